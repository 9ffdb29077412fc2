// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Visible parts by cells, against closed forms.
#include "heliosFootprintScene.h"

#include <catch2/catch.hpp>

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

using namespace helios::testing;

namespace
{

constexpr double Rim = 0.15; // radius of the beam at 100 m, nearly

double GetEnergy(const Cells& cells, vtkIdType first, vtkIdType last)
{
  double sum = 0.0;
  for (vtkIdType id = first; id < last; ++id)
  {
    const auto found = cells.find(id);
    sum += found == cells.end() ? 0.0 : found->second.Energy;
  }
  return sum;
}

/// A strip at a distance y, of a half width, across the beam at an angle: two triangles.
void AddStrip(FootprintScene& scene, double y, double offset, double half, double turn)
{
  constexpr double far = 10.0;
  const double along[2] = { std::cos(turn), std::sin(turn) };
  const auto at = [&](double a, double b, double* corner)
  {
    corner[0] = a * along[0] - (offset + b) * along[1];
    corner[1] = y;
    corner[2] = a * along[1] + (offset + b) * along[0];
  };
  double triangles[2][3][3];
  at(-far, -half, triangles[0][0]);
  at(far, -half, triangles[0][1]);
  at(far, half, triangles[0][2]);
  at(-far, -half, triangles[1][0]);
  at(far, half, triangles[1][1]);
  at(-far, half, triangles[1][2]);
  scene.AddTriangle(triangles[0]);
  scene.AddTriangle(triangles[1]);
}

/// Returns the energy in a strip between lines at so many radii from the axis, in a beam cut at 1.5
/// w: the integral over the chords of exp(-4.5 r^2).
double GetStripEnergy(double low, double high)
{
  constexpr int steps = 20000;
  const double root = std::sqrt(4.5);
  const auto sum = [&](double from, double to)
  {
    double total = 0.0;
    for (int i = 0; i < steps; ++i)
    {
      const double x = from + (to - from) * (i + 0.5) / steps;
      const double chord = std::sqrt(std::max(0.0, 1.0 - x * x));
      total += (to - from) / steps * std::exp(-4.5 * x * x) * std::erf(root * chord);
    }
    return total;
  };
  return sum(std::max(-1.0, low), std::min(1.0, high)) / sum(-1.0, 1.0);
}

} // namespace

TEST_CASE("Cells: needles, slats and edges have the energies of closed forms", "[Raster]")
{
  const double half = GENERATE(0.0004, 0.002, 0.02, 0.2);
  const double turn = GENERATE(0.0, 0.3, 1.1, 2.5);
  const double offset = GENERATE(0.0, 0.031);
  FootprintScene scene;
  AddStrip(scene, 100.0, offset, half, turn);
  scene.AddWall(103.0, -25.0, -25.0);
  scene.Build();
  const double expected = GetStripEnergy((offset - half) / Rim, (offset + half) / Rim);
  for (const int across : { 48, 128, 560 })
  {
    CAPTURE(half, turn, offset, across);
    const Cells cells = scene.Sample(across);
    const double energy = GetEnergy(cells, 0, 2);
    CHECK(std::abs(energy - expected) < 0.5 / across);
    CHECK(energy + GetEnergy(cells, 2, 4) == Approx(1.0).epsilon(1e-5));
  }
}

TEST_CASE("Cells: the energies of a disc and of what it leaves of a wall", "[Raster]")
{
  const double radius = GENERATE(0.01, 0.05, 0.1);
  FootprintScene scene;
  constexpr int corners = 64;
  for (int i = 0; i < corners; ++i)
  {
    const double from = 2.0 * vtkMath::Pi() * i / corners;
    const double to = 2.0 * vtkMath::Pi() * (i + 1) / corners;
    scene.AddTriangle({ { 0, 100, 0 }, { radius * std::cos(from), 100, radius * std::sin(from) },
      { radius * std::cos(to), 100, radius * std::sin(to) } });
  }
  scene.AddWall(100.4, -25.0, -25.0);
  scene.Build();
  const double r = radius / Rim;
  const double expected = std::expm1(-4.5 * r * r) / std::expm1(-4.5);
  for (const int across : { 48, 128, 560 })
  {
    CAPTURE(radius, across);
    const Cells cells = scene.Sample(across);
    const double energy = GetEnergy(cells, 0, corners);
    CHECK(energy == Approx(expected).epsilon(0.004).margin(3.0 / std::pow(across, 1.5)));
    CHECK(energy + GetEnergy(cells, corners, corners + 2) == Approx(1.0).epsilon(1e-5));
  }
}

TEST_CASE("Cells: of leaves that intersect, each is seen where it is nearer", "[Raster]")
{
  // Walls that cross at x = 0: the first is nearer to the left. What is nearer last in one is drawn
  // after the other, which it uncovers.
  const double lean = GENERATE(0.1, 0.6);
  FootprintScene scene;
  for (const double side : { 1.0, -1.0 })
  {
    scene.AddTriangle({ { -2, 100 - 2 * lean * side, -2 }, { 2, 100 + 2 * lean * side, -2 },
      { 2, 100 + 2 * lean * side, 2 } });
    scene.AddTriangle({ { -2, 100 - 2 * lean * side, -2 }, { 2, 100 + 2 * lean * side, 2 },
      { -2, 100 - 2 * lean * side, 2 } });
  }
  scene.Build();
  const Cells exact = scene.GetFootprint();
  for (const int across : { 48, 560 })
  {
    const Cells cells = scene.Sample(across);
    CAPTURE(lean, across);
    CHECK(GetEnergy(cells, 0, 2) == Approx(0.5).margin(0.5 / across));
    CHECK(GetEnergy(cells, 2, 4) == Approx(0.5).margin(0.5 / across));
    for (const auto& [id, cell] : cells)
    {
      CHECK(cell.Energy == Approx(exact.at(id).Energy).margin(1.0 / across));
      CHECK(cell.Mean == Approx(exact.at(id).Mean).epsilon(0).margin(0.05 * lean / across));
    }
  }
}

TEST_CASE("Cells: a wall behind the slope that hides it is not seen", "[Raster]")
{
  // The slope begins before the wall and ends behind it; the strip before it is drawn after it.
  FootprintScene scene;
  scene.AddTriangle({ { -5, 90, -5 }, { 5, 90, -5 }, { 5, 110, 5 } });
  scene.AddTriangle({ { -5, 90, -5 }, { 5, 110, 5 }, { -5, 110, 5 } });
  AddStrip(scene, 99.0, 0.0, 0.03, 0.0);
  scene.AddWall(120.0, -25.0, -25.0);
  scene.Build();
  const Cells cells = scene.Sample(128);
  const double expected = GetStripEnergy(-0.03 / Rim, 0.03 / Rim);
  CHECK(GetEnergy(cells, 2, 4) == Approx(expected).margin(0.5 / 128));
  CHECK(GetEnergy(cells, 0, 2) == Approx(1.0 - expected).margin(0.5 / 128));
  CHECK(cells.count(4) + cells.count(5) == 0);
}

TEST_CASE("Cells: of coincident leaves the first one is visible", "[Raster]")
{
  FootprintScene scene;
  for (int i = 0; i < 3; ++i)
  {
    scene.AddTriangle({ { -1, 100, -1 }, { 1, 100, -1 }, { 0, 100, 1 } });
  }
  scene.Build();
  const Cells cells = scene.Sample(64);
  CHECK(cells.size() == 1);
  CHECK(GetEnergy(cells, 0, 1) == Approx(1.0));
}
