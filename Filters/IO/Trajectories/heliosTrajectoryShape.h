// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Attitudes of trajectory rows, and the row filter.

#ifndef heliosTrajectoryShape_h
#define heliosTrajectoryShape_h

#include "heliosTrajectoryRow.h"

#include <vector>

namespace helios
{

/// Returns a = Rz(-yaw) Ry(roll) Rx(pitch): yaw clockwise from north, nose up, right side down
/// [rad].
Quaternion FromArinc705(const Vec3& rollPitchYaw);

/// Returns a = Rz(-yaw) Rx(pitch) Ry(roll): the same angles in the order of navigation software
/// (Euler angles z, y', x'' of forward, right, down).
Quaternion FromNavigation(const Vec3& rollPitchYaw);

/// Returns a = Rx(roll) Ry(pitch) Rz(yaw) [rad], as written by vtkHeliosTrajectoryTextWriter.
Quaternion FromCanonical(const Vec3& rollPitchYaw);

/**
 * Returns level attitudes along the direction of motion in x, y: at a row along the parabola
 * through it and its neighbours, at ends and jumps along the adjacent segment. Below a speed [m/s]
 * the previous heading is kept (at the start: the first available one; otherwise north).
 */
std::vector<Quaternion> HeadingsOfFlight(
  const std::vector<TrajectoryRow>& rows, double minimumSpeed);

/// Axes of the body in a file.
enum class BodyAxes : int
{
  RightForwardUp = 0,
  ForwardLeftUp = 1,
  ForwardRightDown = 2
};

/// Returns the rotation from body axes right, forward, up to others, on the right of an attitude.
Quaternion ToBodyAxes(BodyAxes axes);

/**
 * Returns the rows to keep: the first, the last, rows at jumps, and rows after which velocity [m/s]
 * or turning rate [deg/s] differ by more than the threshold in any component from the values after
 * the last kept row.
 */
std::vector<std::size_t> FilterSlopes(const std::vector<TrajectoryRow>& rows,
  const std::vector<Quaternion>& orientations, double threshold);

} // namespace helios

#endif
