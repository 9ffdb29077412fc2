// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Motion along a line against drag, in closed form.

#ifndef heliosDrag_h
#define heliosDrag_h

#include "heliosRoot.h"

#include <cmath>
#include <limits>

namespace helios
{

/// Distance and speed.
struct Travel
{
  double Distance; // [m]
  double Speed;    // [m/s]
};

/// Returns (exp(z) - 1) / z.
inline double ExpM1Over(double z)
{
  return z != 0.0 ? std::expm1(z) / z : 1.0;
}

/// Returns (exp(z) - 1 - z) / z^2.
inline double ExpM2Over(double z)
{
  if (std::abs(z) > 1.0)
  {
    return (std::expm1(z) - z) / (z * z);
  }
  double sum = 0.0;
  double term = 0.5;
  for (int n = 3; n < 22; ++n)
  {
    sum += term;
    term *= z / n;
  }
  return sum;
}

/// dv/dt = Acceleration - Rate v: a constant force against drag k v, Rate = k / m >= 0.
struct LinearDrag
{
  double Acceleration; // [m/s^2]
  double Rate;         // [1/s]

  /// Returns the travel after a time t, which may be negative.
  Travel At(double speed, double t) const
  {
    const double z = -this->Rate * t;
    const double gain = (this->Acceleration - this->Rate * speed) * t;
    return { t * (speed + gain * ExpM2Over(z)), speed + gain * ExpM1Over(z) };
  }

  /// Returns the time at which a speed is reached; infinity if never.
  double FindTime(double from, double to) const
  {
    const double start = this->Acceleration - this->Rate * from;
    const double t = (to - from) / start;
    const double z = this->Rate * t;
    if (to == from)
    {
      return 0.0;
    }
    if (!(t >= 0.0) || z >= 1.0)
    {
      return std::numeric_limits<double>::infinity();
    }
    return z != 0.0 ? t * (-std::log1p(-z) / z) : t;
  }

  /// Returns the time for a distance, from a speed >= 0 that stays so.
  double FindTimeTo(double speed, double distance) const
  {
    if (distance <= 0.0)
    {
      return 0.0;
    }
    double late = 1.0;
    while (this->At(speed, late).Distance < distance && late < 1e30)
    {
      late *= 2.0;
    }
    return FindRoot([&](double t) { return this->At(speed, t).Distance - distance; }, 0.0, late);
  }
};

/// dv/dt = Drive - Drag v^2: a constant force against quadratic drag, Drag = c / m >= 0, v >= 0.
struct QuadraticDrag
{
  double Drive; // [m/s^2]
  double Drag;  // [1/m]

  Travel At(double speed, double t) const
  {
    if (this->Drag == 0.0)
    {
      return { t * (speed + 0.5 * this->Drive * t), speed + this->Drive * t };
    }
    // v = vT tanh(w t + ..) or vT tan(.. - w t); the distance is the logarithm of the denominator.
    const double w = std::sqrt(this->Drag * std::abs(this->Drive));
    const bool pulls = this->Drive >= 0.0;
    if (pulls && w * t > 20.0) // tanh is 1, cosh half the exponential
    {
      const double final = std::sqrt(this->Drive / this->Drag);
      return { (w * t - std::log(2.0) + std::log1p(speed / final)) / this->Drag, final };
    }
    const double sine = w == 0.0 ? t : (pulls ? std::sinh(w * t) : std::sin(w * t)) / w;
    const double half = w == 0.0 ? 0.0 : (pulls ? std::sinh(0.5 * w * t) : std::sin(0.5 * w * t));
    const double versine = (pulls ? 2.0 : -2.0) * half * half; // cosh - 1 or cos - 1
    const double grown = versine + this->Drag * speed * sine;
    return { std::log1p(grown) / this->Drag,
      (speed * (1.0 + versine) + this->Drive * sine) / (1.0 + grown) };
  }
};

} // namespace helios

#endif
