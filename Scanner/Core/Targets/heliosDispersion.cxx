// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDispersion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace helios
{
namespace
{

/// n^2 = 1 + sum of B l^2 / (l^2 - C), l in micrometres.
struct Term
{
  double B;
  double C; // [um2]
};
using Sellmeier = std::array<Term, 4>;

constexpr Sellmeier Water = { { { 5.684027565e-1, 5.101829712e-3 },
  { 1.726177391e-1, 1.821153936e-2 }, { 2.086189578e-2, 2.620722293e-2 },
  { 1.130748688e-1, 1.069792721e1 } } };
constexpr Sellmeier Bk7 = { { { 1.03961212, 0.00600069867 }, { 0.231792344, 0.0200179144 },
  { 1.01046945, 103.560653 }, { 0.0, 0.0 } } };
constexpr Sellmeier Silica = { { { 0.6961663, 0.0684043 * 0.0684043 },
  { 0.4079426, 0.1162414 * 0.1162414 }, { 0.8974794, 9.896161 * 9.896161 }, { 0.0, 0.0 } } };

Indices GetIndices(const Sellmeier& terms, double l)
{
  double square = 1.0;
  double slope = 0.0; // slope of n^2
  for (const Term& term : terms)
  {
    const double away = l * l - term.C;
    square += term.B * l * l / away;
    slope -= 2.0 * term.B * term.C * l / (away * away);
  }
  const double n = std::sqrt(square);
  return { n, n - l * slope / (2.0 * n) };
}

/// Returns n = 1.5130 - 0.003169 l^2 + 0.003962 / l^2.
Indices GetSodaLime(double l)
{
  const double falling = 0.003169 * l * l;
  const double rising = 0.003962 / (l * l);
  return { 1.5130 - falling + rising, 1.5130 + falling + 3.0 * rising };
}

} // namespace

Indices GetIndices(DispersionKind medium, double wavelength)
{
  const bool isWater = medium == DispersionKind::Water;
  const double l =
    1e-3 * std::clamp(wavelength, isWater ? 400.0 : 300.0, isWater ? 1100.0 : 2300.0);
  switch (medium)
  {
    case DispersionKind::Water:
      return GetIndices(Water, l);
    case DispersionKind::SodaLime:
      return GetSodaLime(l);
    case DispersionKind::Bk7:
      return GetIndices(Bk7, l);
    case DispersionKind::Silica:
      return GetIndices(Silica, l);
    default:
      return { 1.0, 1.0 };
  }
}

} // namespace helios
