// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamLattice.h"

#include <catch2/catch.hpp>

#include <cmath>

using helios::BeamCell;
using helios::BeamLattice;
using helios::Vec3;

namespace
{

constexpr double Divergence = 1e-3;
constexpr double W = 0.5 * Divergence;

/// E[r^2] / w^2 by the cells of a level: from their centres, or from their points.
double GetSecondMoment(const BeamLattice& lattice, int level, bool fromPoints)
{
  double sum = 0;
  const int n = lattice.GetBaseCells() << level;
  for (int i = 0; i < n * n; ++i)
  {
    const BeamCell& cell = lattice.GetCell(level, i % n, i / n);
    for (const Vec3& d : cell.Points)
    {
      const Vec3& at = fromPoints ? d : cell.Centre;
      const double r = std::atan2(std::hypot(at[0], at[2]), at[1]) / W;
      sum += 0.25 * cell.Energy * r * r;
    }
  }
  return sum;
}

} // namespace

TEST_CASE("BeamLattice: the energy is that of the beam on every level", "[BeamLattice]")
{
  const BeamLattice lattice(Divergence, 1.5, 6, 3);
  for (int level = 0; level <= 3; ++level)
  {
    const int n = 6 << level;
    double energy = 0, x = 0, z = 0;
    for (int i = 0; i < n * n; ++i)
    {
      const BeamCell& cell = lattice.GetCell(level, i % n, i / n);
      CHECK(cell.Energy > 0);
      CHECK(cell.Centre.Norm() == Approx(1).epsilon(1e-15));
      energy += cell.Energy;
      x += cell.Energy * cell.Centre[0];
      z += cell.Energy * cell.Centre[2];
    }
    CHECK(energy == Approx(1).epsilon(1e-14));
    CHECK(std::abs(x) < 1e-10 * W);
    CHECK(std::abs(z) < 1e-10 * W);
  }
}

TEST_CASE("BeamLattice: second moments of the cut beam", "[BeamLattice]")
{
  for (const auto& [k, truth] :
    { std::pair{ 1.0, 0.3434823572503343 }, std::pair{ 1.5, 0.4747239664194075 } })
  {
    const BeamLattice lattice(Divergence, k, 6, 3);
    // The points have it on every level; the centres miss the cells' own, less and less.
    for (int level = 0; level <= 3; ++level)
    {
      CHECK(GetSecondMoment(lattice, level, true) == Approx(truth).epsilon(6e-5));
    }
    const double coarse = truth - GetSecondMoment(lattice, 0, false);
    const double fine = truth - GetSecondMoment(lattice, 1, false);
    CHECK(coarse > 0);
    CHECK(coarse < 0.12 * truth);
    CHECK(coarse / fine == Approx(4).epsilon(0.15));
  }
}

TEST_CASE("BeamLattice: energy inside a circle", "[BeamLattice]")
{
  // Rings of cells about the centre are bounded by circles: their energy is that of the Gaussian.
  const double k = 1.5;
  const BeamLattice lattice(Divergence, k, 8, 0);
  const Vec3& corner = lattice.GetCorner(lattice.GetCornerId(4 + 2, 4)); // rho = 1/2
  const double r = std::atan2(std::hypot(corner[0], corner[2]), corner[1]) / W;
  double inside = 0;
  for (int y = 2; y < 6; ++y)
  {
    for (int x = 2; x < 6; ++x)
    {
      inside += lattice.GetCell(0, x, y).Energy;
    }
  }
  const double truth = std::expm1(-2 * r * r) / std::expm1(-2 * k * k);
  CHECK(inside == Approx(truth).epsilon(2e-3));
  const Vec3& rim = lattice.GetCorner(lattice.GetCornerId(8, 3));
  CHECK(std::atan2(std::hypot(rim[0], rim[2]), rim[1]) == Approx(k * W).epsilon(1e-12));
}

TEST_CASE("BeamLattice: a half plane's energy by corners", "[BeamLattice]")
{
  // Corners of cells on the finest level alone, as where an edge is: error below 0.06 / cells (RMS).
  const double k = 1.5;
  const int cells = 48;
  const BeamLattice lattice(Divergence, k, cells, 0);
  // Truncated half planes at offsets of 0.1, 0.25, 0.5, 0.75 w.
  const double offsets[4] = { 0.1, 0.25, 0.5, 0.75 };
  const double truths[4] = { 0.42006787315304, 0.30693343504042, 0.15592773783746,
    0.063638861707145 };
  double square = 0;
  int count = 0;
  for (int turn = 0; turn < 12; ++turn)
  {
    const double angle = 0.137 + 0.51 * turn;
    for (int o = 0; o < 4; ++o)
    {
      double energy = 0;
      for (int i = 0; i < cells * cells; ++i)
      {
        const int x = i % cells, y = i / cells;
        for (const std::size_t id : { lattice.GetCornerId(x, y), lattice.GetCornerId(x + 1, y),
               lattice.GetCornerId(x, y + 1), lattice.GetCornerId(x + 1, y + 1) })
        {
          const Vec3& d = lattice.GetCorner(id);
          const double along = (d[0] * std::cos(angle) + d[2] * std::sin(angle)) / W;
          energy += along > offsets[o] ? 0.25 * lattice.GetCell(0, x, y).Energy : 0.0;
        }
      }
      square += std::pow(energy - truths[o], 2);
      ++count;
    }
  }
  CHECK(std::sqrt(square / count) < 0.06 / cells);
}
