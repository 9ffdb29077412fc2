// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamLattice.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

struct Polar
{
  double Radius; // of the unit disc
  double Azimuth;
};

/// The concentric map of [-1, 1]^2 to the unit disc.
Polar MapToDisc(double x, double y)
{
  const double quarter = 0.25 * vtkMath::Pi();
  if (x == 0.0 && y == 0.0)
  {
    return { 0.0, 0.0 };
  }
  if (std::abs(x) >= std::abs(y))
  {
    return { std::abs(x), quarter * (y / x) + (x < 0.0 ? vtkMath::Pi() : 0.0) };
  }
  return { std::abs(y), 2.0 * quarter - quarter * (x / y) + (y < 0.0 ? vtkMath::Pi() : 0.0) };
}

} // namespace

BeamLattice::BeamLattice(double divergence, double truncation, int cells)
  : Cells(cells)
{
  const double w = 0.5 * divergence;
  const double minusEnergy = std::expm1(-2.0 * truncation * truncation); // -E
  this->Directions.reserve(static_cast<std::size_t>(this->GetSide() * this->GetSide()));
  for (int j = 0; j < this->GetSide(); ++j)
  {
    for (int i = 0; i < this->GetSide(); ++i)
    {
      const Polar at =
        MapToDisc(static_cast<double>(i - cells) / cells, static_cast<double>(j - cells) / cells);
      const double p = std::min(1.0, at.Radius * at.Radius);
      const double angle = w * std::sqrt(-0.5 * std::log1p(p * minusEnergy));
      this->Directions.emplace_back(std::sin(angle) * std::sin(at.Azimuth), std::cos(angle),
        std::sin(angle) * std::cos(at.Azimuth));
    }
  }
}

} // namespace helios
