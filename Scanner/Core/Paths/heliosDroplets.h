// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Single drops of rain in a beam.

#ifndef heliosDroplets_h
#define heliosDroplets_h

#include "heliosAirColumn.h"
#include "heliosReceiver.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <vtkType.h>

#include <cstdint>
#include <vector>

namespace helios
{

/// A beam: its radius at 1/e2 is w at range R, w^2 = Angle^2 (R^2 + Apex^2).
struct BeamWidth
{
  double Angle = 0.0;      ///< half of the divergence [rad]; 0: no drops
  double Apex = 0.0;       ///< from the cone's apex to the instrument, of a beam with a waist [m]
  double Truncation = 1.0; ///< K: energy ends at K w
};

/**
 * Air whose extinction alpha is caused by drops of one diameter d: n 2 pi d^2 / 4 for n drops in a
 * volume (the extinction efficiency of large drops is 2). Their places are a Poisson process in the
 * beam, of the seed and the pulse. Each returns what it receives of the beam there. Drops that
 * would return less than a least power are no returns of their own: the rest of an AirColumn stands
 * for them, and the mean over many pulses equals the whole column.
 */
class VTKHELIOSSCANNERCORE_EXPORT Droplets
{
public:
  Droplets() = default;
  /// Sets a diameter [m] and a smallest power [W].
  Droplets(const AirSettings& air, double end, const BeamWidth& beam, double diameter,
    double minimumPower = 0.0);

  bool IsEmpty() const { return !(this->Density > 0.0); }
  double GetDensity() const { return this->Density; } ///< [1/m3]

  /// Returns the share of the energy that comes from drops below the least power, at a range.
  double GetHomogeneousShare(double range) const;

  /// Returns the volume of a beam up to a range [m3].
  double GetVolume(double range) const;

  /// Appends the returns of the drops in the beam of a pulse before hits, which are sorted by range.
  void Append(std::uint64_t seed, vtkIdType pulse, const std::vector<Hidden>& hits,
    std::vector<SubReturn>& returns) const;

private:
  /// A part of the beam: drops that reach the least power lie within a share of its section.
  struct Shell
  {
    double Volume;    ///< volume of the beam before the shell [m3]
    double Effective; ///< volume of these shares before the shell [m3]
    double Share;     ///< at its near end, where it is largest
  };

  void MakeShells();
  double GetReach(double range) const;
  double FindRange(double volume) const;
  double FindEnd(double end) const;
  double GetReceived(double range, double away2) const;
  double GetWhole(double range) const;
  double GetPower(double range, double away2) const;

  AirSettings Air;
  BeamWidth Beam;
  double MinimumPower = 0.0; // [W]
  double End = 0.0;          // end of the drops that reach the smallest power [m]
  double Section = 0.0;      // section of a drop [m2]
  double Density = 0.0;
  std::vector<Shell> Shells; // the last one ends the beam
};

} // namespace helios

#endif
