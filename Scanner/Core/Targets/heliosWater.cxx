// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWater.h"

#include "heliosDispersion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace helios
{
namespace
{

struct Absorption
{
  double Wavelength; // [nm]
  double Value;      // [1/m]
};
constexpr std::array<Absorption, 14> PureWater = { { { 400.0, 0.00663 }, { 440.0, 0.00635 },
  { 490.0, 0.0150 }, { 532.0, 0.0447 }, { 550.0, 0.0565 }, { 600.0, 0.2224 }, { 650.0, 0.340 },
  { 700.0, 0.624 }, { 750.0, 2.5 }, { 800.0, 2.0 }, { 900.0, 6.8 }, { 970.0, 45.0 },
  { 1064.0, 14.0 }, { 1550.0, 1000.0 } } };

constexpr double GivenAt = 532.0; // attenuations of water [nm]

} // namespace

double GetPureWaterAbsorption(double wavelength)
{
  const auto after = std::find_if(PureWater.begin() + 1, PureWater.end() - 1,
    [wavelength](const Absorption& a) { return a.Wavelength > wavelength; });
  const Absorption& above = *after;
  const Absorption& below = *std::prev(after);
  const double share =
    std::clamp((wavelength - below.Wavelength) / (above.Wavelength - below.Wavelength), 0.0, 1.0);
  return std::exp((1.0 - share) * std::log(below.Value) + share * std::log(above.Value));
}

MaterialOptics GetOpticsAt(const MaterialOptics& optics, double wavelength)
{
  MaterialOptics result = optics;
  if (optics.Dispersion != DispersionKind::None)
  {
    const Indices indices = GetIndices(optics.Dispersion, wavelength);
    result.RefractiveIndex = indices.Phase;
    result.GroupIndex = indices.Group;
  }
  result.GroupIndex = result.GroupIndex > 0.0 ? result.GroupIndex : result.RefractiveIndex;
  if (optics.Kind == OpticsKind::Water)
  {
    result.Kind = OpticsKind::Volume;
    const double more = GetPureWaterAbsorption(wavelength) - GetPureWaterAbsorption(GivenAt);
    result.Attenuation = std::max(0.0, optics.Attenuation + more);
  }
  return result;
}

} // namespace helios
