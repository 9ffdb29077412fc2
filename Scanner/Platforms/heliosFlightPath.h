// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The path of a multicopter through its waypoints.

#ifndef heliosFlightPath_h
#define heliosFlightPath_h

#include "heliosFlightSpeed.h"
#include "heliosPose.h"
#include "heliosTurn.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

#include <limits>
#include <vector>

namespace helios
{

/// The limits of a multicopter.
struct Copter
{
  double Pitch; // [rad], along the path
  double Roll;  // [rad], bank in a turn
  double PitchRate;
  double RollRate;
  double YawRate; // [rad/s]
  double Thrust;  // [m/s^2], per unit of mass
  double Drag;    // [1/m]
  double Step;    // [s]

  /// Returns the limits along a unit direction: from tilt, thrust, gravity and maximum thrust.
  VTKHELIOSSCANNERPLATFORMS_EXPORT DriveLimits GetLimits(const Vec3& direction) const;

  /// Returns the maximum speed along a unit direction, 1 % below the terminal speed.
  double GetTopSpeed(const Vec3& direction) const
  {
    return this->Drag > 0.0 ? 0.99 * std::sqrt(this->GetLimits(direction).Maximum / this->Drag)
                            : std::numeric_limits<double>::infinity();
  }
};

enum class Passing
{
  Stop,    ///< rests there, yaws, and starts again
  Smooth,  ///< cuts the corner with a banked turn
  Through, ///< passes it, and turns to the next after that
};

struct FlightWaypoint
{
  Vec3 Position;
  double Speed; // [m/s] to the next
  Passing Mode;
};

/// The motion at a waypoint.
struct FlightCorner
{
  Passing Mode;
  double Speed = 0.0; // [m/s]
  Turn Bend;
  Vec3 Start; // start of the bend
  Vec3 Along; // the initial direction
  Vec3 Side;  // the direction of the turn
};

/// The straight part of a leg.
struct FlightLine
{
  Vec3 Start;
  Vec3 Direction; // unit, or 0 for a leg without length
  double Length;
  double Cruise;
};

struct FlightPath
{
  std::vector<FlightCorner> Corners; // per waypoint
  std::vector<FlightLine> Lines;     // per leg
  std::vector<std::size_t> Slowed;   // waypoints passed more slowly than requested
};

/// Returns the path through all waypoints, at the requested speed if the turns fit between the
/// waypoints, otherwise slower.
VTKHELIOSSCANNERPLATFORMS_EXPORT FlightPath PlanFlight(
  const std::vector<FlightWaypoint>& waypoints, const Copter& copter);

} // namespace helios

#endif
