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

/// The speed of light [m/ns].
constexpr double SpeedOfLight = 0.299792458;

/// Full width at half maximum of a Gaussian, in standard deviations.
constexpr double FwhmPerSigma = 2.3548200450309493;

/**
 * The extinction of clear air [1/m] for a visibility [km] and a wavelength [nm]: Kruse,
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
 * What a surface that holds the whole beam returns, as a fraction of the power sent:
 * f D^2 / (4 R^2) eta exp(-2 alpha R), f = rho cos(theta) for Lambert (Wagner et al. 2006).
 */
struct LidarEquation
{
  double ReceiverDiameter;  // D [m]
  double OpticalEfficiency; // eta
  double Extinction;        // alpha [1/m]

  /// Of a Lambertian surface.
  double operator()(double range, double reflectance, double cosIncidence) const
  {
    return this->GetGain(range, this->GetTransmission(range)) * reflectance * cosIncidence;
  }

  /// exp(-2 alpha R): the way there and back.
  double GetTransmission(double range) const
  {
    return this->Extinction > 0.0 ? std::exp(-2.0 * this->Extinction * range) : 1.0;
  }

  /// All but the surface, with the transmission known.
  double GetGain(double range, double transmission) const
  {
    const double aperture = this->ReceiverDiameter / range;
    return 0.25 * aperture * aperture * this->OpticalEfficiency * transmission;
  }
};

/// How a surface sends light back.
struct SurfaceReflection
{
  double Reflectance;      // rho, [0..1]
  double Specularity;      // s, [0..1]: the share of it in the lobe
  double SpecularExponent; // n
};

/**
 * pi times the bidirectional reflectance times cos(theta), back along the way the light came: what
 * takes the place of rho cos(theta) in the lidar equation. The lobe of Phong is about the mirrored
 * direction, 2 theta away, and normalised by (n + 2) / (2 pi) so that it returns no more than it gets
 * (Lewis 1994, Computer Graphics Forum 13, 109-120); where 2 theta > 90 degrees there is none.
 */
inline double GetBackscatter(const SurfaceReflection& surface, double cosTheta)
{
  if (surface.Specularity == 0.0)
  {
    return surface.Reflectance * cosTheta;
  }
  const double n = surface.SpecularExponent;
  const double cosMirrored = std::max(0.0, 2.0 * cosTheta * cosTheta - 1.0);
  const double lobe = 0.5 * (n + 2.0) * std::pow(cosMirrored, n);
  const double s = surface.Specularity;
  return surface.Reflectance * ((1.0 - s) + s * lobe) * cosTheta;
}

/**
 * The transmission for the sub-rays of one pulse, whose ranges differ little: one exponential at
 * the first range, and its series from there.
 */
class NearbyTransmission
{
public:
  explicit NearbyTransmission(const LidarEquation& equation)
    : Equation(equation)
  {
  }

  /// At a range; from now on the series starts there if it was not good enough.
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

  ///@{
  /// The same in steps, for ranges near the one where the series starts.
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
