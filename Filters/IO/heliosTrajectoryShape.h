// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Attitudes of the rows of a trajectory, and which rows matter.

#ifndef heliosTrajectoryShape_h
#define heliosTrajectoryShape_h

#include "heliosTrajectoryParser.h"

#include <vector>

namespace helios
{

/// A = Rz(-yaw) Ry(roll) Rx(pitch): yaw clockwise from north, nose up, right side down [rad].
Quaternion FromArinc705(const Vec3& rollPitchYaw);

/// A = Rx(roll) Ry(pitch) Rz(yaw) [rad], as vtkHeliosTrajectoryTextWriter writes it.
Quaternion FromCanonical(const Vec3& rollPitchYaw);

/**
 * Level attitudes along the flight: at a row the direction in x, y is that of a parabola through it
 * and its neighbours, at the ends and beside jumps that of the one piece. Below a speed [m/s]
 * the heading is that before (at the start: the first that there is; north where there is none).
 */
std::vector<Quaternion> HeadingsOfFlight(
  const std::vector<TrajectoryRow>& rows, double minimumSpeed);

/**
 * The rows to keep: the first, the last, those of jumps, and those after which velocity [m/s] or
 * turning rate [deg/s] differ by more than the threshold in any component from those after the row
 * kept before.
 */
std::vector<std::size_t> FilterSlopes(const std::vector<TrajectoryRow>& rows,
  const std::vector<Quaternion>& orientations, double threshold);

} // namespace helios

#endif
