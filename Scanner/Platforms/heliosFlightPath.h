// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The way a multicopter flies from waypoint to waypoint.

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

/// What a multicopter can do.
struct Copter
{
  double Pitch; // [rad], tilt along the way
  double Roll;  // [rad], bank in a turn
  double PitchRate;
  double RollRate;
  double YawRate; // [rad/s]
  double Thrust;  // [m/s^2], a unit of mass
  double Drag;    // [1/m]
  double Step;    // [s]

  static constexpr double Gravity = 9.80665; // [m/s^2]

  /// Along a unit direction: tilt from thrust and gravity, and thrust up to its largest.
  VTKHELIOSSCANNERPLATFORMS_EXPORT DriveLimits GetLimits(const Vec3& direction) const;

  /// The highest speed along a unit direction, a hundredth below the terminal one.
  double GetTopSpeed(const Vec3& direction) const
  {
    return this->Drag > 0.0 ? 0.99 * std::sqrt(this->GetLimits(direction).Most / this->Drag)
                            : std::numeric_limits<double>::infinity();
  }
};

enum class Passing
{
  Stop,    ///< rests there, yaws, and starts again
  Smooth,  ///< cuts the corner by a banked turn
  Through, ///< passes it, and turns to the next after that
};

struct FlightWaypoint
{
  Vec3 Position;
  double Speed; // [m/s] to the next
  Passing Mode;
};

/// What happens at a waypoint.
struct FlightCorner
{
  Passing Mode;
  double Speed = 0.0; // [m/s]
  Turn Bend;
  Vec3 Start; // of the bend
  Vec3 Along; // the direction it starts with
  Vec3 Side;  // the way it turns
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
  std::vector<FlightCorner> Corners; // one a waypoint
  std::vector<FlightLine> Lines;     // one a leg
  std::vector<std::size_t> Slowed;   // waypoints passed more slowly than asked for
};

/// The way through all waypoints, as fast as asked for where the turns fit between the waypoints,
/// slower where they do not.
VTKHELIOSSCANNERPLATFORMS_EXPORT FlightPath PlanFlight(
  const std::vector<FlightWaypoint>& waypoints, const Copter& copter);

} // namespace helios

#endif
