// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The speed of a multicopter along a line: tilting thrust against drag.

#ifndef heliosFlightSpeed_h
#define heliosFlightSpeed_h

#include "heliosDrag.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

#include <vector>

namespace helios
{

/// The limits of the thrust along a line: a drive q [m/s^2], dv/dt = q - Drag v |v|.
struct DriveLimits
{
  double Maximum; // > 0
  double Minimum; // < 0
  double Rate;    // rate of the drive [m/s^3]
  double Drag;    // [1/m]
  double Step;    // step of the integration while the drive changes [s]

  /// Returns the drive that keeps a speed constant.
  double GetDrive(double speed) const { return this->Drag * speed * speed; }
};

/// A period in which the drive is constant, or changes at a constant rate.
class VTKHELIOSSCANNERPLATFORMS_EXPORT DrivePhase
{
public:
  struct State
  {
    double Distance; // [m]
    double Speed;    // [m/s]
    double Drive;    // [m/s^2]
  };

  /// Returns the phase from one drive to another at the rate of the limits: RK4 steps of equal
  /// length.
  static DrivePhase Ramp(const DriveLimits& limits, double speed, double from, double to);

  /// Returns the phase of a constant drive, speed >= 0: in closed form.
  static DrivePhase Hold(const DriveLimits& limits, double speed, double drive, double duration);

  /// Returns a constant speed.
  static DrivePhase Cruise(const DriveLimits& limits, double speed, double duration);

  double GetDuration() const { return this->Duration; }

  /// Returns the state after a time in [0, GetDuration()]; the distance is measured from the
  /// phase's start.
  State At(double t) const;
  State GetEnd() const { return this->At(this->Duration); }

private:
  Travel Advance(const Travel& from, double time, double step) const;

  double Duration = 0.0;
  double Speed = 0.0;
  double Drive = 0.0;
  double Rate = 0.0;
  double Drag = 0.0;
  bool Cruises = false;
  std::vector<Travel> Steps; // where the drive changes
};

/// Two ramps and the phase between: from one constant speed to another.
struct SpeedChange
{
  std::vector<DrivePhase> Phases;
  double Distance = 0.0;
};

/// Returns the fastest change within the limits. The constant speeds need less than the limits.
VTKHELIOSSCANNERPLATFORMS_EXPORT SpeedChange ChangeSpeed(
  const DriveLimits& limits, double from, double to);

/// A straight line of the flight.
struct LineFlight
{
  double Length;        // [m]
  double Entry;         // [m/s]
  double Exit;          // [m/s]
  double Cruise;        // [m/s], maximum
  double BrakeDistance; // minimum slowdown distance, or half the line [m]
};

/// Flies up to the cruise speed, or the maximum the line allows, and down again.
VTKHELIOSSCANNERPLATFORMS_EXPORT std::vector<DrivePhase> FlyLine(
  const DriveLimits& limits, const LineFlight& line);

} // namespace helios

#endif
