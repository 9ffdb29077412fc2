// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How fast a vehicle drives along its way: full force, cap, full brake.

#ifndef heliosSpeedProfile_h
#define heliosSpeedProfile_h

#include "heliosDrag.h"
#include "vtkHeliosScannerPlatformsModule.h" // For export macro

#include <vector>

namespace helios
{

/// A part of the way with one slope and one speed that is not to be exceeded.
struct Stretch
{
  double Length; // [m]
  double Cap;    // [m/s]
  double Thrust; // [m/s^2] with full force, gravity along the way counted
  double Brake;  // [m/s^2] with full brake, negative
  bool StopsAtEnd = false;
};

/// A time with a constant force.
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
 * The fastest drive from rest over all stretches that keeps below every cap: what each end allows is
 * found from the last stretch to the first, then the vehicle drives. All in closed form for drag
 * that grows linearly with speed, rate [1/s]. Every stretch has Thrust > 0 > Brake.
 */
VTKHELIOSSCANNERPLATFORMS_EXPORT std::vector<SpeedPhase> DriveStretches(
  const std::vector<Stretch>& stretches, double rate);

} // namespace helios

#endif
