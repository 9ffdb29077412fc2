// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The lidar equation.

#ifndef heliosRadiometry_h
#define heliosRadiometry_h

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
 * What a Lambertian surface that holds the whole beam returns, as a fraction of the power sent:
 * rho cos(theta) D^2 / (4 R^2) eta exp(-2 alpha R) (Wagner et al. 2006).
 */
struct LidarEquation
{
  double ReceiverDiameter;  // D [m]
  double OpticalEfficiency; // eta
  double Extinction;        // alpha [1/m]

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

  double operator()(double range)
  {
    const double x = -2.0 * this->Equation.Extinction * (range - this->Range);
    if (!(std::abs(x) < 1e-3))
    {
      this->Range = range;
      this->Transmission = this->Equation.GetTransmission(range);
      return this->Transmission;
    }
    return this->Transmission * (1.0 + x * (1.0 + x * (1 / 2.0 + x * (1 / 6.0 + x * (1 / 24.0)))));
  }

private:
  const LidarEquation& Equation;
  double Range = std::numeric_limits<double>::quiet_NaN();
  double Transmission = 1.0;
};

} // namespace helios

#endif
