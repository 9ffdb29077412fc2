// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the platform is at a time.

#ifndef heliosTrajectory_h
#define heliosTrajectory_h

#include "heliosPose.h"

#include <vtkType.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * The samples of a trajectory. Between two samples the position is linear in time, the orientation
 * turns at a constant rate; of two samples at one time the later holds. A single sample holds at
 * all times, and before the first and after the last sample their poses hold.
 */
class Trajectory
{
public:
  /// Reads a trajectory; says in words what is wrong with it, or returns an empty text.
  std::string Set(vtkPolyData* trajectory);

  bool IsStatic() const { return this->Times.size() == 1; }
  double GetStartTime() const { return this->Times.front(); }
  double GetEndTime() const { return this->Times.back(); }

  /// Remembers where the last pose was found; one a thread.
  struct Cursor
  {
    std::size_t Sample = 0;
    bool Valid = false;
    Rotation Attitude; // of the sample
  };

  /// The position at a time, and the attitude in cursor.Attitude or, where it turns, as a new one.
  Vec3 GetPosition(double time, Cursor& cursor, Rotation& attitude) const;

private:
  std::size_t FindSample(double time, std::size_t hint) const;

  std::vector<double> Times;
  std::vector<Vec3> Positions;
  std::vector<Quaternion> Orientations;
};

} // namespace helios

#endif
