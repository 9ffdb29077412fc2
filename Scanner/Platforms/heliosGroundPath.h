// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The path of a car through its waypoints.

#ifndef heliosGroundPath_h
#define heliosGroundPath_h

#include "heliosPose.h"
#include "heliosTurn.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

#include <cstddef>
#include <vector>

namespace helios
{

/// The limits of a car.
struct Steering
{
  double Wheelbase;           // [m]
  double MaximumAngle;        // largest angle of the front wheels [rad]
  double Rate;                // rate of that angle [rad/s]
  double LateralAcceleration; // [m/s^2]
  double Deviation;           // [m] off the straight line for a faster turn

  /// Returns the curvature of the path of the rear axle for a steering angle (bicycle model).
  double GetCurvature(double angle) const { return std::tan(angle) / this->Wheelbase; }
};

/// A part of the path of the rear axle in x, y: straight, or a turn.
struct GroundElement
{
  std::size_t Waypoint; ///< start of its leg
  Vec3 Start;
  double Course = 0.0; ///< the path runs along (cos Course, sin Course) [rad]
  double Length = 0.0; ///< in x, y [m]
  bool IsTurn = false;
  bool Right = false;
  Turn Bend;
  bool Backward = false; ///< the body faces backwards
  bool Stops = false;    ///< at its end
  double Grade = 0.0;    ///< rise per metre in x, y
  double Cap = 0.0;      ///< [m/s]

  struct Place
  {
    Vec3 Position;
    double Course;
    double Curvature;
  };
  /// Returns the place after a length in x, y.
  VTKHELIOSSCANNERPLATFORMS_EXPORT Place At(double s) const;
};

struct GroundWaypoint
{
  Vec3 Position;
  double Speed; // [m/s] to the next
};

/**
 * Returns the path through all waypoints, from the first, with the car heading to the second. At a
 * waypoint the car turns towards the next until that is straight ahead, then drives straight. If no
 * turn leads there, it reverses on the opposite lock, and straight, by the minimum that allows a
 * turn.
 */
VTKHELIOSSCANNERPLATFORMS_EXPORT std::vector<GroundElement> PlanGroundPath(
  const std::vector<GroundWaypoint>& waypoints, const Steering& steering);

} // namespace helios

#endif
