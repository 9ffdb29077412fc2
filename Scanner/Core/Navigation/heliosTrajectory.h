// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The platform's pose over time.

#ifndef heliosTrajectory_h
#define heliosTrajectory_h

#include "heliosHermite.h"
#include "heliosPose.h"
#include "heliosStatus.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkType.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * The samples of a trajectory. Between two samples the position is the cubic of both positions and
 * velocities (linear in time without velocities), the orientation rotates at a constant rate; of
 * two samples at one time the later holds. A single sample holds at all times; before the first and
 * after the last sample their poses hold.
 */
class VTKHELIOSSCANNERCORE_EXPORT Trajectory
{
public:
  /// Reads a trajectory.
  Status Set(vtkPolyData* trajectory);

  /// Reads the samples of one leg only.
  Status SetLeg(vtkPolyData* trajectory, int leg);

  /// Sets whether the orientation is interpolated; if not, a sample's holds until the next one.
  /// Default: on.
  void SetInterpolatesOrientation(bool interpolates) { this->Interpolates = interpolates; }

  bool IsStatic() const { return this->Times.size() == 1; }
  double GetStartTime() const { return this->Times.front(); }
  double GetEndTime() const { return this->Times.back(); }

  /// Caches the segment of the last pose; one per thread.
  struct Cursor
  {
    std::size_t Sample = 0;
    bool Valid = false;
    Rotation Attitude; // attitude of the sample
  };

  /// Returns the position at a time, and the attitude in cursor.Attitude or, if it rotates, as a
  /// new one.
  Vec3 GetPosition(double time, Cursor& cursor, Rotation& attitude) const;

  /// Returns position and attitude, for few times.
  Pose GetPose(double time) const;

  /// How a body moves: the velocity of its origin [m/s], and its rotation [rad/s] in the world.
  struct Rates
  {
    Vec3 Velocity{ 0.0, 0.0, 0.0 };
    Vec3 Rotation{ 0.0, 0.0, 0.0 };
  };

  /// Returns how it moves at a time; at a sample, as after it.
  Rates GetRates(double time) const;

  /// Computes bounds of the lengths of the rates within a span.
  void GetBounds(double start, double end, double& speed, double& rotation) const;

private:
  Rates GetRatesAfter(std::size_t sample, double s) const;
  Status Append(vtkPolyData* trajectory, vtkIdType sample);
  void Connect();
  std::size_t FindSample(double time, std::size_t hint) const;
  bool HoldsAt(std::size_t sample, double time) const;
  bool RotatesAfter(std::size_t sample) const;
  double GetFraction(std::size_t sample, double time) const;

  std::vector<double> Times;
  std::vector<Vec3> Positions;
  std::vector<Vec3> Velocities; // until the segments are built
  std::vector<Quaternion> Orientations;
  std::vector<HermiteSegment> Segments; // from each sample to the next
  bool Interpolates = true;             // the orientation
};

} // namespace helios

#endif
