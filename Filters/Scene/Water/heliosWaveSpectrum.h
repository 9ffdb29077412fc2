// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The waves that a wind raises on deep water.

#ifndef heliosWaveSpectrum_h
#define heliosWaveSpectrum_h

#include "vtkHeliosFiltersSceneModule.h" // For export macro

#include <cstdint>
#include <vector>

namespace helios
{

/// A wind over water.
struct Wind
{
  double Speed = 0.0;     ///< at 10 m [m/s]
  double Direction = 0.0; ///< to where it blows, anticlockwise from x [deg]
  double Fetch = 1000.0;  ///< the length of water that it has blown over [m]
};

/**
 * Returns the energy of waves by angular frequency w (JONSWAP, Hasselmann et al. 1973):
 *
 * S(w) = a g^2 / w^5 exp(-1.25 (w0 / w)^4) 3.3^exp(-(w - w0)^2 / (2 s^2 w0^2))   [m2 s]
 *
 * with a = 0.076 (U^2 / (F g))^0.22, w0 = 22 (g^2 / (U F))^(1/3), s = 0.07 below w0 and 0.09 above.
 */
VTKHELIOSFILTERSSCENE_EXPORT double GetWaveEnergy(const Wind& wind, double frequency);

/// Returns the frequency w0 of the highest waves [rad/s].
VTKHELIOSFILTERSSCENE_EXPORT double GetPeakFrequency(const Wind& wind);

/// A sum of plane waves; their directions spread by cos^2 about the wind.
class VTKHELIOSFILTERSSCENE_EXPORT WaveField
{
public:
  /// The waves longer than a length [m], with phases of a seed.
  WaveField(const Wind& wind, double shortest, std::uint64_t seed);

  /// Returns the height at a place and time [m, s].
  double GetHeight(double x, double y, double time) const;

  double GetVariance() const;        ///< variance of the height [m2]
  double GetMeanSquareSlope() const; ///< in all directions

private:
  struct Wave
  {
    double X; // [rad/m]
    double Y;
    double Frequency; // [rad/s]
    double Phase;
    double Amplitude; // [m]
  };
  std::vector<Wave> Waves;
};

} // namespace helios

#endif
