// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The light that fog, rain or smoke scatters back before a beam meets surfaces.

#ifndef heliosAirColumn_h
#define heliosAirColumn_h

#include "heliosReceiver.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

#include <functional>
#include <vector>

namespace helios
{

/// Homogeneous air before a scanner.
struct AirSettings
{
  double Backscatter = 0.0; ///< beta [1/(m sr)]; 0: none
  double Gain = 0.0;        ///< power of a white surface at 1 m without extinction [W]
  double Extinction = 0.0;  ///< alpha [1/m]
  double Start = 0.0;       ///< the range gate [m]
  double Stop = 0.0;
  double Step = 0.0;         ///< step of slabs [m]: the standard deviation of the pulse
  double MinimumPower = 0.0; ///< amplitudes below do not matter [W]
};

/// A hit, which hides the air behind it, and its share of the beam.
struct Hidden
{
  double Range;
  double Weight;
};

/**
 * The returns of air: a length dR at range R is a surface of the response pi beta dR, with the power
 * Gain pi beta exp(-2 alpha R) / R^2 dR. Empty without backscatter; it ends where amplitudes do not
 * matter any more.
 */
class VTKHELIOSSCANNERCORE_EXPORT AirColumn
{
public:
  AirColumn() = default;
  /// Sets the share of the backscatter that counts, by range; null: all.
  explicit AirColumn(
    const AirSettings& settings, const std::function<double(double)>& share = nullptr);

  bool IsEmpty() const { return !(this->Backscatter > 0.0); }
  double GetBackscatter() const { return this->Backscatter; }
  double GetEnd() const { return this->End; } ///< [m]

  /// Appends the returns of a beam before hits, which are sorted by range.
  void Append(std::vector<Hidden>& hits, std::vector<SubReturn>& returns) const;

private:
  struct Slab
  {
    double Begin; // [m]
    double Near;  // range of the first return
    double Far;
    double Power; // power of each slab [W]
  };

  double Backscatter = 0.0;
  double Step = 0.0;
  double End = 0.0;
  std::vector<Slab> Slabs;
};

} // namespace helios

#endif
