// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The way a car drives from waypoint to waypoint.

#ifndef heliosGroundPath_h
#define heliosGroundPath_h

#include "heliosPose.h"
#include "heliosTurn.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

#include <cstddef>
#include <vector>

namespace helios
{

/// What a car can do.
struct Steering
{
  double Wheelbase;           // [m]
  double MaximumAngle;        // of the front wheels [rad]
  double Rate;                // of that angle [rad/s]
  double LateralAcceleration; // [m/s^2]
  double Deviation;           // [m] off the straight way to take a bend faster

  /// The curvature of the rear axle's way on a bicycle of that steering angle.
  double GetCurvature(double angle) const { return std::tan(angle) / this->Wheelbase; }
};

/// A part of the way of the rear axle in x, y: straight, or a turn.
struct GroundElement
{
  std::size_t Waypoint; ///< where its leg starts
  Vec3 Start;
  double Course = 0.0; ///< the way goes along (cos, sin) of it [rad]
  double Length = 0.0; ///< in x, y [m]
  bool IsTurn = false;
  bool Right = false;
  Turn Bend;
  bool Backward = false; ///< the body looks against the way
  bool Stops = false;    ///< at its end
  double Grade = 0.0;    ///< rise a metre in x, y
  double Cap = 0.0;      ///< [m/s]

  struct Place
  {
    Vec3 Position;
    double Course;
    double Curvature;
  };
  /// After a length in x, y.
  VTKHELIOSSCANNERPLATFORMS_EXPORT Place At(double s) const;
};

struct GroundWaypoint
{
  Vec3 Position;
  double Speed; // [m/s] to the next
};

/**
 * The way through all waypoints, from the first where the car looks to the second. At a waypoint the
 * car turns towards the next until it lies straight ahead, then drives straight. Where no turn leads
 * there, it backs up on the other lock, and straight, as little as makes a turn lead there.
 */
VTKHELIOSSCANNERPLATFORMS_EXPORT std::vector<GroundElement> PlanGroundPath(
  const std::vector<GroundWaypoint>& waypoints, const Steering& steering);

} // namespace helios

#endif
