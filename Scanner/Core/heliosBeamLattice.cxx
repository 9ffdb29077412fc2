// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamLattice.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace helios
{
namespace
{

/// A direction in the tangent plane of the axis: angles to the right and up.
struct Angles
{
  double X;
  double Z;
};

Vec3 ToDirection(const Angles& a)
{
  const double g = std::hypot(a.X, a.Z);
  const double scale = g > 0.0 ? std::sin(g) / g : 1.0;
  return { scale * a.X, std::cos(g), scale * a.Z };
}

/// Sums of the energy over a cell, with its first and second moments.
struct Moments
{
  double Energy = 0.0;
  double X = 0.0, Z = 0.0;
  double XX = 0.0, XZ = 0.0, ZZ = 0.0;

  void Add(double energy, const Angles& a)
  {
    this->Energy += energy;
    this->X += energy * a.X;
    this->Z += energy * a.Z;
    this->XX += energy * a.X * a.X;
    this->XZ += energy * a.X * a.Z;
    this->ZZ += energy * a.Z * a.Z;
  }

  void Add(const Moments& m)
  {
    for (double Moments::*sum :
      { &Moments::Energy, &Moments::X, &Moments::Z, &Moments::XX, &Moments::XZ, &Moments::ZZ })
    {
      this->*sum += m.*sum;
    }
  }
};

/// The points are the mean and the columns of the covariance's Cholesky factor to both sides.
BeamCell ToCell(const Moments& m, double total)
{
  const Angles mean{ m.X / m.Energy, m.Z / m.Energy };
  const double xx = std::max(0.0, m.XX / m.Energy - mean.X * mean.X);
  const double xz = m.XZ / m.Energy - mean.X * mean.Z;
  const double zz = std::max(0.0, m.ZZ / m.Energy - mean.Z * mean.Z);
  const double l11 = std::sqrt(xx);
  const double l21 = l11 > 0.0 ? xz / l11 : 0.0;
  const double l22 = std::sqrt(std::max(0.0, zz - l21 * l21));
  BeamCell cell{ m.Energy / total, ToDirection(mean), {} };
  for (int i = 0; i < 4; ++i)
  {
    const double a = (i & 1) ? 1.0 : -1.0;
    const double b = (i & 2) ? 1.0 : -1.0;
    cell.Points[i] = ToDirection({ mean.X + a * l11, mean.Z + a * l21 + b * l22 });
  }
  return cell;
}

// Gauss-Legendre with three points: a cell's moments.
constexpr double Nodes[3] = { -0.7745966692414834, 0.0, 0.7745966692414834 };
constexpr double NodeWeights[3] = { 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };

} // namespace

/// From [-1, 1]^2 to the beam.
struct BeamLattice::Map
{
  double W;
  double F;

  /// The energy of a unit square's unit area there.
  double GetDensity(double x, double y) const
  {
    const double rho = std::max(std::abs(x), std::abs(y));
    return (1.0 - rho * rho * this->F) / (1.0 - 0.5 * this->F);
  }

  Angles operator()(double x, double y) const
  {
    if (x == 0.0 && y == 0.0)
    {
      return { 0.0, 0.0 };
    }
    const bool isWide = std::abs(x) >= std::abs(y);
    const double rho = isWide ? x : y; // negative: the opposite sector
    const double quarter = 0.25 * vtkMath::Pi();
    const double azimuth = isWide ? quarter * (y / x) : quarter * (2.0 - x / y);
    const double g = std::copysign(this->W * std::sqrt(-std::log1p(-rho * rho * this->F)), rho);
    return { g * std::cos(azimuth), g * std::sin(azimuth) };
  }
};

//------------------------------------------------------------------------------
BeamLattice::BeamLattice(double divergence, double truncation, int baseCells, int levels)
  : Divergence(divergence)
  , Truncation(truncation)
  , BaseCells(baseCells)
  , Levels(levels)
{
  const Map map{ 0.5 * divergence, -std::expm1(-truncation * truncation) };
  const int side = baseCells << levels;
  const double step = 2.0 / side;
  for (int y = 0; y <= side; ++y)
  {
    for (int x = 0; x <= side; ++x)
    {
      this->Corners.push_back(ToDirection(map(step * x - 1.0, step * y - 1.0)));
    }
  }

  std::vector<Moments> moments(static_cast<std::size_t>(side * side));
  double total = 0.0;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      Moments& m = moments[static_cast<std::size_t>(y * side + x)];
      for (int i = 0; i < 9; ++i)
      {
        const double u = step * (x + 0.5 + 0.5 * Nodes[i % 3]) - 1.0;
        const double v = step * (y + 0.5 + 0.5 * Nodes[i / 3]) - 1.0;
        m.Add(NodeWeights[i % 3] * NodeWeights[i / 3] * map.GetDensity(u, v), map(u, v));
      }
      total += m.Energy;
    }
  }

  this->Cells.resize(static_cast<std::size_t>(levels + 1));
  for (int level = levels; level >= 0; --level)
  {
    auto& cells = this->Cells[static_cast<std::size_t>(level)];
    std::transform(moments.begin(), moments.end(), std::back_inserter(cells),
      [total](const Moments& m) { return ToCell(m, total); });
    const int n = baseCells << level;
    std::vector<Moments> coarser(static_cast<std::size_t>(n / 2 * (n / 2)));
    for (int i = 0; level > 0 && i < n * n; ++i)
    {
      coarser[static_cast<std::size_t>(i / n / 2 * (n / 2) + i % n / 2)].Add(
        moments[static_cast<std::size_t>(i)]);
    }
    moments.swap(coarser);
  }
}

} // namespace helios
