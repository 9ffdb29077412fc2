// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A planned flight as a motion: the required thrust, and the tilt of the body.

#ifndef heliosFlightMotion_h
#define heliosFlightMotion_h

#include "heliosFlightPath.h"
#include "heliosMotion.h"

#include <vector>

namespace helios
{

/// Returns the attitude whose z axis is along a thrust, and whose y axis points to a course [rad,
/// from x to y] seen from above: yaw, then pitch about x, then roll about y.
VTKHELIOSSCANNERPLATFORMS_EXPORT Quaternion TiltTo(const Vec3& thrust, double course);

/// Returns the pieces of a flight, leg after leg. Courses [rad] at the waypoints are the headings
/// on leaving a stop; NaN is the heading of the leg.
VTKHELIOSSCANNERPLATFORMS_EXPORT std::vector<MotionPiece> FlyPath(const FlightPath& path,
  const Copter& copter, const std::vector<double>& courses, double brakeDistance);

} // namespace helios

#endif
