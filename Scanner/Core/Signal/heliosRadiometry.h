// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The lidar equation.

#ifndef heliosRadiometry_h
#define heliosRadiometry_h

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

/**
 * Returns the extinction of clear air [1/m] for a visibility [km] and a wavelength [nm]: Kruse,
 * 3.912 / V (lambda / 0.55 um)^-q per km, with Kruse's exponents q.
 */
inline double AtmosphericExtinction(double visibility, double wavelength)
{
  if (!(visibility < 1e300))
  {
    return 0.0;
  }
  const double q = visibility > 50.0 ? 1.6 : visibility > 6.0 ? 1.3 : 0.585 * std::cbrt(visibility);
  return 3.912 / visibility * std::pow(wavelength / 550.0, -q) * 1e-3;
}

/**
 * The return of a surface that fills the beam, as a fraction of the transmitted power:
 * f D^2 / (4 R^2) eta exp(-2 alpha R), f = rho cos(theta) for Lambert (Wagner et al. 2006).
 */
struct LidarEquation
{
  double ReceiverDiameter;  // D [m]
  double OpticalEfficiency; // eta
  double Extinction;        // alpha [1/m]

  /// For a Lambertian surface.
  double operator()(double range, double reflectance, double cosIncidence) const
  {
    return this->GetGain(range, this->GetTransmission(range)) * reflectance * cosIncidence;
  }

  /// Returns exp(-2 alpha R): the two-way transmission.
  double GetTransmission(double range) const
  {
    return this->Extinction > 0.0 ? std::exp(-2.0 * this->Extinction * range) : 1.0;
  }

  /// Returns all factors but the surface, with the transmission known.
  double GetGain(double range, double transmission) const
  {
    const double aperture = this->ReceiverDiameter / range;
    return 0.25 * aperture * aperture * this->OpticalEfficiency * transmission;
  }
};

/// The reflection of a surface.
struct SurfaceReflection
{
  double Reflectance;      // rho, [0..1]
  double Specularity;      // [0..1]: fraction of rho in the lobe
  double SpecularExponent; // n
};

/**
 * Returns pi times the bidirectional reflectance times cos(theta) of the direction of the scattered
 * light, which has another cosine to the mirrored direction: replaces rho cos(theta) in the lidar
 * equation. The Phong lobe is about the mirrored direction, and normalised by (n + 2) / (2 pi) to
 * conserve energy (Lewis 1994, Computer Graphics Forum 13, 109-120).
 */
inline double GetResponse(const SurfaceReflection& surface, double cosTheta, double cosMirrored)
{
  if (surface.Specularity == 0.0)
  {
    return surface.Reflectance * cosTheta;
  }
  const double n = surface.SpecularExponent;
  const double lobe = 0.5 * (n + 2.0) * std::pow(std::max(0.0, cosMirrored), n);
  const double s = surface.Specularity;
  return surface.Reflectance * ((1.0 - s) + s * lobe) * cosTheta;
}

/// Returns the response in the backscatter direction, 2 theta from the mirrored one; the lobe is 0
/// for 2 theta > 90 degrees.
inline double GetBackscatter(const SurfaceReflection& surface, double cosTheta)
{
  return GetResponse(surface, cosTheta, 2.0 * cosTheta * cosTheta - 1.0);
}

/**
 * The transmission for the sub-rays of one pulse, whose ranges differ little: one exponential at
 * the first range, and a series about it.
 */
class CachedTransmission
{
public:
  explicit CachedTransmission(const LidarEquation& equation)
    : Equation(equation)
  {
  }

  /// Returns the transmission at a range; restarts the series there if it was not accurate enough.
  double operator()(double range)
  {
    const double x = this->GetExponent(range);
    if (!IsNear(x))
    {
      this->Range = range;
      this->Transmission = this->Equation.GetTransmission(range);
      return this->Transmission;
    }
    return this->GetNear(x);
  }

  /// @{
  /// Compute in separate steps, for ranges near the start of the series.
  double GetExponent(double range) const
  {
    return -2.0 * this->Equation.Extinction * (range - this->Range);
  }
  static bool IsNear(double exponent) { return std::abs(exponent) < 1e-2; }
  double GetNear(double x) const
  {
    const double high = 1 / 24.0 + x * (1 / 120.0 + x * (1 / 720.0));
    return this->Transmission * (1.0 + x * (1.0 + x * (1 / 2.0 + x * (1 / 6.0 + x * high))));
  }
  ///@}

private:
  LidarEquation Equation;
  double Range = std::numeric_limits<double>::quiet_NaN();
  double Transmission = 1.0;
};

} // namespace helios

#endif
