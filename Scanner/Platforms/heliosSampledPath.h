// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A recorded trajectory, evaluated at any time.

#ifndef heliosSampledPath_h
#define heliosSampledPath_h

#include "heliosPose.h"
#include "heliosStatus.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>

class vtkDataArray;
class vtkPolyData;

namespace helios
{

/**
 * Between samples the position is linear in time, or cubic: Hermite's with the velocities of the
 * samples. The attitude rotates at a constant rate along the shorter arc. Two samples at one time
 * are a jump.
 */
class SampledPath
{
public:
  struct State
  {
    double Time;
    Vec3 Position;
    Quaternion Orientation;
    Vec3 Velocity; // velocity, for cubic paths
  };

  /// Reads a trajectory.
  Status Set(vtkPolyData* trajectory, bool isCubic);

  double GetStartTime() const { return this->GetTime(0); }
  double GetEndTime() const { return this->GetTime(this->Count - 1); }

  vtkIdType GetNumberOfSamples() const { return this->Count; }
  double GetTime(vtkIdType sample) const;
  State GetSample(vtkIdType sample) const;

  /// Returns the number of samples before a time, or not after it.
  vtkIdType CountBefore(double time) const;
  vtkIdType CountUntil(double time) const;

  /// @{
  /// Returns the state at a path time; at a jump the state before or after it.
  State GetArrival(double time) const;
  State GetDeparture(double time) const;
  ///@}

private:
  Status CheckArrays(vtkPolyData* trajectory);
  Status CheckSamples() const;
  Vec3 GetVelocity(vtkIdType sample) const;
  State Interpolate(vtkIdType sample, double time) const;

  vtkSmartPointer<vtkPolyData> Path;
  vtkDataArray* Times = nullptr;
  vtkDataArray* Orientations = nullptr;
  vtkDataArray* Velocities = nullptr;
  vtkIdType Count = 0;
  bool IsCubic = false;
};

} // namespace helios

#endif
