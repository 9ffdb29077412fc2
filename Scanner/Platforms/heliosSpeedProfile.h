// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The speed of a vehicle along its path: full force, cap, full brake.

#ifndef heliosSpeedProfile_h
#define heliosSpeedProfile_h

#include "heliosDrag.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

#include <vector>

namespace helios
{

/// A part of the path with one slope and one maximum speed.
struct Stretch
{
  double Length; // [m]
  double Cap;    // [m/s]
  double Thrust; // [m/s^2] with full force, gravity along the path included
  double Brake;  // [m/s^2] with full brake, negative
  bool StopsAtEnd = false;
};

/// A period with a constant force.
struct SpeedPhase
{
  std::size_t Stretch;
  double Start;    // [m] along the stretch
  double Speed;    // [m/s] at the start
  double Duration; // [s]
  LinearDrag Force;

  Travel At(double t) const
  {
    const Travel travel = this->Force.At(this->Speed, t);
    return { this->Start + travel.Distance, travel.Speed };
  }
};

/**
 * Returns the fastest drive from rest over all stretches below every cap: the maximum end speeds
 * are computed from the last stretch to the first, then the vehicle drives. All in closed form for
 * linear drag, rate [1/s]. Every stretch has Thrust > 0 > Brake.
 */
VTKHELIOSSCANNERPLATFORMS_EXPORT std::vector<SpeedPhase> DriveStretches(
  const std::vector<Stretch>& stretches, double rate);

} // namespace helios

#endif
