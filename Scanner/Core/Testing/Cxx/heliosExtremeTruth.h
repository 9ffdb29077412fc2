// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// True returns of a pulse: closed forms, and sums over a beam in long double.

#ifndef heliosExtremeTruth_h
#define heliosExtremeTruth_h

#include "heliosPose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace helios
{
namespace testing
{

using Real = long double;

constexpr double SigmaRange = 0.5 * 0.299792458 * 4.0 / 2.3548200450309493; ///< sigma of 4 ns [m]

/// Returns the power of a surface across the beam that fills it: 1 W, D = 0.15 m, reflectance 0.5
/// [W].
inline double GetFull(double range)
{
  return 0.5 * 0.25 * 0.15 * 0.15 / (range * range);
}

/// The fraction of a beam truncated at k between the lines at a and b, all in units of w.
inline double GetStripEnergy(Real a, Real b, Real k = 1.5L)
{
  a = std::clamp(a, -k, k);
  b = std::clamp(b, -k, k);
  const int steps = 4000;
  const Real h = (b - a) / steps;
  const auto f = [k](Real y)
  {
    const Real reach = std::sqrt(std::max(Real(0), k * k - y * y));
    return std::exp(-2 * y * y) * std::erf(std::sqrt(Real(2)) * reach);
  };
  Real sum = f(a) + f(b);
  for (int i = 1; i < steps; ++i)
  {
    sum += (i % 2 == 1 ? 4 : 2) * f(a + i * h);
  }
  const Real pi = std::acos(Real(-1));
  return static_cast<double>(std::sqrt(2 / pi) * sum * h / 3 / -std::expm1(-2 * k * k));
}

/// Returns the energy within a radius.
inline double GetDiscEnergy(Real radius, Real k = 1.5L)
{
  return static_cast<double>(std::expm1(-2 * radius * radius) / std::expm1(-2 * k * k));
}

/// The range of the plane of a triangle along a direction, by the stored numbers.
inline Real GetPlaneRange(
  const std::array<Vec3, 3>& triangle, const Vec3& origin, const Vec3& direction)
{
  Real a[3], b[3], c[3];
  for (int i = 0; i < 3; ++i)
  {
    a[i] = Real(triangle[1][i]) - triangle[0][i];
    b[i] = Real(triangle[2][i]) - triangle[0][i];
    c[i] = Real(triangle[0][i]) - origin[i];
  }
  const Real n[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
  const Real along = n[0] * direction[0] + n[1] * direction[1] + n[2] * direction[2];
  return (n[0] * c[0] + n[1] * c[1] + n[2] * c[2]) / along;
}

/// Something that a beam meets.
struct TrueReturn
{
  double Range, Power;
};

/// The nearest maximum of the sum of the pulses of returns: in bins of sigma / 25, by the parabola.
inline TrueReturn FindFirstMaximum(const std::vector<TrueReturn>& returns)
{
  constexpr double h = SigmaRange / 25;
  constexpr int reach = 175; // 7 sigma
  double low = 1e300;
  double high = 0.0;
  for (const TrueReturn& r : returns)
  {
    low = std::min(low, r.Range);
    high = std::max(high, r.Range);
  }
  std::vector<double> powers(static_cast<std::size_t>((high - low) / h) + 2 * reach + 3, 0.0);
  for (const TrueReturn& r : returns)
  {
    const double x = (r.Range - low) / h + reach;
    const auto bin = static_cast<std::size_t>(x);
    powers[bin] += r.Power * (1 - (x - static_cast<double>(bin)));
    powers[bin + 1] += r.Power * (x - static_cast<double>(bin));
  }
  std::vector<double> wave(powers.size(), 0.0);
  for (std::size_t bin = reach; bin + reach < powers.size(); ++bin)
  {
    for (int k = -reach; powers[bin] > 0.0 && k <= reach; ++k)
    {
      wave[bin + static_cast<std::size_t>(k + reach) - reach] +=
        powers[bin] * std::exp(-0.5 * (k / 25.0) * (k / 25.0));
    }
  }
  std::size_t peak = 1;
  while (peak + 2 < wave.size() && !(wave[peak] > wave[peak - 1] && wave[peak] >= wave[peak + 1]))
  {
    ++peak;
  }
  const double a = std::log(wave[peak - 1]);
  const double b = std::log(wave[peak]);
  const double c = std::log(wave[peak + 1]);
  const double shift = 0.5 * (a - c) / (a - 2 * b + c);
  return { low + (static_cast<double>(peak) - reach + shift) * h,
    std::exp(b - 0.25 * (a - c) * shift) };
}

/**
 * The first echo of a beam along y with half angle w, cut at 1.5 w, from a surface of which the range
 * and the cosine of incidence are known in a direction. Its power varies most along z.
 */
template <typename MeetT>
TrueReturn GetFirstEcho(double w, MeetT meet)
{
  constexpr double k = 1.5;
  constexpr int across = 24;
  constexpr int along = 3001;
  std::vector<TrueReturn> returns;
  double sum = 0.0;
  for (int j = 0; j < along; ++j)
  {
    const double z = k * (2 * (j + 0.5) / along - 1);
    const double chord = std::sqrt(k * k - z * z);
    for (int i = 0; i < across; ++i)
    {
      const double x = chord * (2 * (i + 0.5) / across - 1);
      const double energy = std::exp(-2 * (x * x + z * z)) * chord;
      sum += energy;
      const double angle = w * std::hypot(x, z);
      const double sine = std::sin(angle) / angle * w;
      const TrueReturn hit = meet(Vec3(sine * x, std::cos(angle), sine * z));
      if (hit.Power > 0.0)
      {
        returns.push_back({ hit.Range, energy * hit.Power * GetFull(hit.Range) });
      }
    }
  }
  for (TrueReturn& r : returns)
  {
    r.Power /= sum;
  }
  return FindFirstMaximum(returns);
}

} // namespace testing
} // namespace helios

#endif
