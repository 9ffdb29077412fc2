// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How fast a multicopter flies along a line: its thrust tilts, and drag holds against it.

#ifndef heliosFlightSpeed_h
#define heliosFlightSpeed_h

#include "heliosDrag.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

#include <vector>

namespace helios
{

/// What the thrust can do along a line: a drive q [m/s^2], dv/dt = q - Drag v |v|.
struct DriveLimits
{
  double Most;  // > 0
  double Least; // < 0
  double Rate;  // of the drive [m/s^3]
  double Drag;  // [1/m]
  double Step;  // of the integration while the drive changes [s]

  /// What keeps a speed.
  double Keep(double speed) const { return this->Drag * speed * speed; }
};

/// A time in which the drive stays, or changes at a constant rate.
class VTKHELIOSSCANNERPLATFORMS_EXPORT DrivePhase
{
public:
  struct State
  {
    double Distance; // [m]
    double Speed;    // [m/s]
    double Drive;    // [m/s^2]
  };

  /// From a drive to another at the rate of the limits: RK4 steps of equal length.
  static DrivePhase Ramp(const DriveLimits& limits, double speed, double from, double to);

  /// The same drive, not less than 0 speed: in closed form.
  static DrivePhase Hold(const DriveLimits& limits, double speed, double drive, double duration);

  /// A constant speed.
  static DrivePhase Cruise(const DriveLimits& limits, double speed, double duration);

  double GetDuration() const { return this->Duration; }

  /// After a time in [0, GetDuration()]; the distance counts from the phase's start.
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

/// Two ramps and what is between: from a speed kept to another speed kept.
struct SpeedChange
{
  std::vector<DrivePhase> Phases;
  double Distance = 0.0;
};

/// The fastest change within the limits. The speed kept needs less than the limits give.
VTKHELIOSSCANNERPLATFORMS_EXPORT SpeedChange ChangeSpeed(
  const DriveLimits& limits, double from, double to);

/// A straight line to fly.
struct LineFlight
{
  double Length;        // [m]
  double Entry;         // [m/s]
  double Exit;          // [m/s]
  double Cruise;        // [m/s], not to be exceeded
  double BrakeDistance; // slows down over at least this, or half the line [m]
};

/// Up to the cruise speed, or what the line is long enough for, and down again.
VTKHELIOSSCANNERPLATFORMS_EXPORT std::vector<DrivePhase> FlyLine(
  const DriveLimits& limits, const LineFlight& line);

} // namespace helios

#endif
