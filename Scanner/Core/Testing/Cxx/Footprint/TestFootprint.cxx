// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFootprintScene.h"
#include "heliosPose.h"

#include <catch2/catch.hpp>

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using helios::Footprint;
using helios::FootprintPart;
using helios::Vec3;
using namespace helios::testing;

namespace
{

double GetEnergy(const Cells& cells, vtkIdType id)
{
  const auto found = cells.find(id);
  return found == cells.end() ? 0.0 : found->second.Energy;
}

/// Both have the same energies.
void CheckEnergies(const Cells& cells, const Cells& traced, vtkIdType count)
{
  for (vtkIdType id = 0; id < count; ++id)
  {
    const double energy = GetEnergy(traced, id);
    const double difference = std::abs(GetEnergy(cells, id) - energy);
    if (!(difference < 1e-3)) // a check for each of many would be slow
    {
      CAPTURE(id, energy);
      CHECK(difference < 1e-3);
    }
  }
}

/// Both have the same energies, and mean ranges and their spreads where the energy is not small.
void CheckSame(const Cells& cells, const Cells& traced, vtkIdType count, double negligible)
{
  CheckEnergies(cells, traced, count);
  for (vtkIdType id = 0; id < count; ++id)
  {
    const double energy = GetEnergy(traced, id);
    if (energy > 0.02)
    {
      const double deviation = std::sqrt(traced.at(id).Square / energy);
      CHECK(std::abs(cells.at(id).Mean - traced.at(id).Mean) < 3e-5 + 0.05 * deviation);
      CHECK(std::sqrt(cells.at(id).Square / cells.at(id).Energy) ==
        Approx(deviation).epsilon(0.08).margin(negligible));
    }
  }
}

/// Triangles in a cone of 0.15 m radius at 100 m.
void Scatter(
  FootprintScene& scene, std::mt19937& random, int count, double size, double depth, double thin)
{
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < count; ++i)
  {
    const double middle[3] = { 0.15 * number(random), 100.0 + depth * number(random),
      0.15 * number(random) };
    double corners[3][3];
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        corners[corner][axis] = middle[axis] + (corner == 2 ? thin : 1.0) * size * number(random);
      }
    }
    if (thin < 1.0)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        corners[2][axis] += corners[0][axis] - middle[axis];
      }
    }
    scene.AddTriangle(corners);
  }
}

/// Leaves of 4 triangles each in a cone of 0.15 m radius at 100 m: hexagons.
void ScatterLeaves(
  FootprintScene& scene, std::mt19937& random, int count, double radius, double depth)
{
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (int i = 0; i < count; ++i)
  {
    const Vec3 middle(0.15 * number(random), 100.0 + depth * number(random), 0.15 * number(random));
    const Vec3 normal = Vec3(number(random), number(random), number(random)).Normalized();
    const Vec3 u = radius * normal.Cross(Vec3(0.3, 0.5, 0.8)).Normalized();
    const Vec3 v = normal.Cross(u);
    Vec3 corners[6];
    for (int k = 0; k < 6; ++k)
    {
      const double turn = vtkMath::Pi() / 3.0 * k;
      corners[k] = middle + std::cos(turn) * u + std::sin(turn) * v;
    }
    for (int k = 1; k < 5; ++k)
    {
      const Vec3* ends[3] = { &corners[0], &corners[k], &corners[k + 1] };
      double triangle[3][3];
      for (int corner = 0; corner < 3; ++corner)
      {
        std::copy_n(ends[corner]->GetData(), 3, triangle[corner]);
      }
      scene.AddTriangle(triangle);
    }
  }
}

/// A surface of n x n cells of two triangles each, 0.5 m wide at 100 m, but for one cell.
template <typename HeightT>
void AddField(FootprintScene& scene, int n, int hole, HeightT height)
{
  const auto at = [&](int i, int k, double* corner)
  {
    corner[0] = 0.5 * i / n - 0.251;
    corner[2] = 0.5 * k / n - 0.252;
    corner[1] = 100.0 + height(corner[0], corner[2]);
  };
  for (int cell = 0; cell < n * n; ++cell)
  {
    if (cell == hole)
    {
      continue;
    }
    const int i = cell / n;
    const int k = cell % n;
    for (const int half : { 0, 1 })
    {
      double triangle[3][3];
      at(i, k, triangle[0]);
      at(i + 1, k + 1, triangle[1]);
      at(i + half, k + 1 - half, triangle[2]);
      scene.AddTriangle(triangle);
    }
  }
}

/// Adds up a number of consecutive cells.
Cells Group(const Cells& cells, vtkIdType size)
{
  Cells groups;
  for (const auto& [id, cell] : cells)
  {
    groups[id / size].Energy += cell.Energy;
  }
  return groups;
}

} // namespace

TEST_CASE(
  "A surface has the energies that sub-rays find, also with a hole, folds or a layer before it")
{
  constexpr int n = 12;
  const int hole = GENERATE(-1, n * n / 2 + n / 2);
  const double steep = GENERATE(0.0, 0.5, 40.0); // m: the last one hides some of itself
  const bool hasLeaf = GENERATE(false, true);
  CAPTURE(hole, steep, hasLeaf);
  FootprintScene scene;
  AddField(scene, n, hole,
    [steep](double x, double z)
    { return steep * (std::sin(31.0 * x) * std::cos(23.0 * z) + 5.0 * x); });
  if (hasLeaf)
  {
    scene.AddTriangle({ { 0.01, 50, 0.01 }, { 0.02, 50, 0.01 }, { 0.01, 50, 0.03 } });
  }
  scene.AddWall(400.0, -25.0, -25.0);
  scene.Settings.Depth = 1e9;
  scene.Build();
  const Cells cells = scene.GetFootprint();
  const Cells traced = scene.Trace();
  double sum = 0.0;
  for (vtkIdType id = 0; id < scene.Mesh->GetNumberOfCells(); ++id)
  {
    sum += GetEnergy(cells, id);
    CHECK(std::abs(GetEnergy(cells, id) - GetEnergy(traced, id)) < 1e-3);
  }
  CHECK(sum == Approx(1.0).epsilon(1e-5));
}

TEST_CASE("Triangles of one plane are one surface if their responses are alike")
{
  FootprintScene scene;
  std::mt19937 random(3);
  ScatterLeaves(scene, random, 80, 0.03, 3.0);
  scene.AddWall(110.0, -25.0, -25.0);
  scene.Settings.Depth = 1e9;
  scene.Build();
  const Cells separate = scene.GetFootprint();
  const auto isLeaf = [](vtkIdType a, vtkIdType b) { return a / 4 == b / 4; };
  scene.AreAlike = isLeaf;
  const Cells joined = scene.GetFootprint();
  CHECK(joined.size() < separate.size() / 2);
  const Cells leaves = Group(joined, 4);
  const Cells traced = Group(scene.Trace(), 4);
  CHECK(leaves.size() >= 60);
  for (vtkIdType leaf = 0; leaf < 81; ++leaf)
  {
    CHECK(std::abs(GetEnergy(leaves, leaf) - GetEnergy(traced, leaf)) < 1e-3);
    CHECK(GetEnergy(leaves, leaf) == Approx(GetEnergy(Group(separate, 4), leaf)).margin(2e-6));
  }
}

TEST_CASE("The visible parts of triangles have the energies that sub-rays find")
{
  struct Kind
  {
    int Count;
    double Size, Depth, Thin;
  };
  // leaves, a thicket of triangles that intersect, large ones, slivers, grazing ones
  const Kind kind = GENERATE(Kind{ 300, 0.03, 3.0, 1.0 }, Kind{ 60, 0.1, 0.05, 1.0 },
    Kind{ 20, 30.0, 20.0, 1.0 }, Kind{ 200, 0.2, 1.0, 1e-4 }, Kind{ 100, 0.05, 0.02, 1.0 });
  for (unsigned seed = 0; seed < 3; ++seed)
  {
    CAPTURE(kind.Count, kind.Size, seed);
    FootprintScene scene;
    std::mt19937 random(seed);
    Scatter(scene, random, kind.Count, kind.Size, kind.Depth, kind.Thin);
    scene.AddWall(110.0, -25.0, -25.0);
    scene.Settings.Depth = 0.3;
    scene.Build();
    CheckSame(scene.GetFootprint(), scene.Trace(), kind.Count + 2, 0.03 * scene.Settings.Depth);
  }
}

TEST_CASE("A wide beam has the energies that sub-rays find")
{
  FootprintScene scene(0.2);
  std::mt19937 random(7);
  Scatter(scene, random, 100, 20.0, 20.0, 1.0);
  scene.Settings.Depth = 0.5;
  scene.Build();
  CheckEnergies(scene.GetFootprint(), scene.Trace(), 100);
}

TEST_CASE("A part of a wide beam is as far as its sub-rays on average")
{
  constexpr double w = 0.02;
  FootprintScene scene(w);
  scene.AddWall(2.0, -25.0, -25.0);
  scene.Build();
  const std::vector<FootprintPart> parts = scene.FindParts();
  double mean = 0.0;
  for (const FootprintPart& part : parts)
  {
    mean += part.Energy * part.Range;
  }
  // With the variance of the truncated beam, as in heliosPlaneEcho.h.
  CHECK(mean == Approx(2.0 * (1.0 + 0.475 * 0.5 * w * w)).epsilon(3e-6));
}

TEST_CASE("Of coincident triangles the first one is visible")
{
  FootprintScene scene;
  for (int i = 0; i < 4; ++i)
  {
    scene.AddTriangle({ { -1, 100, -1 }, { 1, 100, -1 }, { 0, 100, 2 } });
  }
  scene.Build();
  const Cells cells = scene.GetFootprint();
  CHECK(cells.size() == 1);
  CHECK(GetEnergy(cells, 0) == Approx(1.0).epsilon(1e-6));
}

TEST_CASE("A beam past all triangles has no parts, and before a wall all energy")
{
  FootprintScene scene;
  scene.AddTriangle({ { 1, 100, -1 }, { 2, 100, -1 }, { 1, 100, 2 } });
  scene.AddTriangle({ { -1, -10, -1 }, { 1, -10, -1 }, { 0, -10, 2 } }); // behind the origin
  SECTION("nothing")
  {
    scene.Build();
    CHECK(scene.FindParts().empty());
  }
  SECTION("a wall around the origin and beyond it")
  {
    scene.AddTriangle({ { -1e3, -1e3, -1e3 }, { 0, 1e5, -1e3 }, { 0, 1e3, 1e5 } });
    scene.Settings.Depth = 1e9;
    scene.Build();
    const Cells cells = scene.GetFootprint();
    CHECK(GetEnergy(cells, 2) == Approx(GetEnergy(scene.Trace(), 2)).margin(1e-3));
    CHECK(cells.at(2).Mean == Approx(scene.Trace().at(2).Mean).epsilon(1e-4));
  }
}

TEST_CASE("Parts end at the range gate, and spread over no more than the depth")
{
  FootprintScene scene(1e-2);
  // A plane along the beam: depths of 80 to 130 m.
  scene.AddTriangle({ { -100, 80, -1.2 }, { 100, 80, -1.2 }, { 0, 1e4, 200 } });
  scene.Settings.Depth = 0.5;
  scene.Settings.Gate[0] = 90.123;
  scene.Settings.Gate[1] = 101.456;
  scene.Build();
  double inside = 0.0;
  double largest = 0.0;
  for (const FootprintPart& part : scene.FindParts())
  {
    inside += part.Range > 90.123 && part.Range < 101.456 ? part.Energy : 0.0;
    largest = std::max(largest, part.Energy);
  }
  CHECK(largest < 0.1);
  const double traced = scene.GetEnergyBetween(90.123, 101.456);
  CHECK(inside == Approx(traced).margin(1e-3));
}

TEST_CASE("Where a beam has a waist, its radius is that of a Gaussian beam")
{
  FootprintScene scene(1.5e-4);
  scene.Settings.Truncation = 3.0;
  scene.Settings.ApexOffset = 22.0;
  scene.AddWall(10.0, -25.0, 0.002); // above 2 mm
  scene.AddWall(20.0, -25.0, -25.0);
  scene.Build();
  const Cells cells = scene.GetFootprint();
  const double radius = 1.5e-4 * std::hypot(10.0, 22.0);
  const double above = 0.5 * std::erfc(std::sqrt(2.0) * 0.002 / radius);
  CHECK(GetEnergy(cells, 0) + GetEnergy(cells, 1) == Approx(above).margin(1e-5));
  CHECK(GetEnergy(cells, 2) + GetEnergy(cells, 3) == Approx(1.0 - above).margin(1e-5));
  CHECK(cells.begin()->second.Mean == Approx(10.0).epsilon(1e-6));
}

TEST_CASE("Too many triangles in a beam are not collected")
{
  FootprintScene scene;
  std::mt19937 random(1);
  Scatter(scene, random, static_cast<int>(1.5 * Footprint::MaximumTriangles), 0.002, 1.0, 1.0);
  scene.Build();
  CHECK_FALSE(scene.Collect());
}

TEST_CASE("A wide beam is not flat where its ranges at one depth differ")
{
  FootprintScene scene(0.05); // the rim is 0.28 % farther
  scene.AddWall(10.0, -25.0, -25.0);
  scene.Settings.Depth = 0.2;
  scene.Build();
  CHECK_FALSE(scene.IsFlat());
  scene.Settings.Depth = 0.4;
  CHECK(scene.IsFlat());
}

TEST_CASE("Parts of a wide beam spread over the ranges of its sub-rays")
{
  FootprintScene scene(0.05);
  scene.AddWall(10.0, -25.0, -25.0);
  scene.Settings.Depth = 0.02;
  scene.Build();
  const Cells cells = scene.GetFootprint();
  const Cells traced = scene.Trace();
  for (const vtkIdType id : { 0, 1 })
  {
    const double deviation = std::sqrt(traced.at(id).Square / traced.at(id).Energy);
    CHECK(deviation > 5e-3);
    CHECK(std::sqrt(cells.at(id).Square / cells.at(id).Energy) == Approx(deviation).epsilon(0.03));
    CHECK(cells.at(id).Mean == Approx(traced.at(id).Mean).epsilon(1e-5));
  }
}

TEST_CASE("A beam with a waist is not flat where it bends edges")
{
  const double depth = GENERATE(10.0, 10.001);
  FootprintScene scene(1e-3);
  scene.Settings.ApexOffset = 5.0;
  scene.AddTriangle({ { -1, 10, 0 }, { 1, 10, 0 }, { 0.001, depth == 10.0 ? 10.0 : 14.0, 1 } });
  scene.Build();
  CHECK(scene.IsFlat() == (depth == 10.0));
}

TEST_CASE("Cells see the visible areas")
{
  const int count = GENERATE(1, 20, 400);
  FootprintScene scene;
  std::mt19937 random(static_cast<unsigned>(count));
  Scatter(scene, random, count, count > 100 ? 0.03 : 0.1, 1.0, 1.0);
  scene.AddWall(103.0, -25.0, -25.0);
  scene.Build();
  const Cells exact = scene.GetFootprint();
  double last = 1.0;
  for (const int across : { 64, 256, 1024 })
  {
    const Cells cells = scene.Sample(across);
    double sum = 0.0;
    double worst = 0.0;
    for (vtkIdType id = 0; id < count + 2; ++id)
    {
      sum += GetEnergy(cells, id);
      worst = std::max(worst, std::abs(GetEnergy(cells, id) - GetEnergy(exact, id)));
    }
    CAPTURE(count, across);
    CHECK(sum == Approx(1.0).epsilon(1e-9));
    CHECK(worst < 0.6 / across); // half a cell along an edge through the axis has 0.75 / across
    CHECK(worst < last + 1e-5);  // the error of the division
    last = worst;
  }
}

TEST_CASE("Faces without gaps leave no cell, and share none")
{
  FootprintScene scene;
  for (int i = -40; i < 40; ++i) // a fan about the axis, with corners on no cell
  {
    const double turn = 0.0785398 * i;
    const double next = 0.0785398 * (i + 1);
    scene.AddTriangle({ { 0.0001, 100, 0.0002 }, { std::cos(turn), 100, std::sin(turn) },
      { std::cos(next), 100, std::sin(next) } });
  }
  scene.Build();
  for (const int across : { 24, 96, 520 })
  {
    const Cells cells = scene.Sample(across);
    double sum = 0.0;
    for (const auto& [id, cell] : cells)
    {
      sum += cell.Energy;
      CHECK(cell.Mean == Approx(100.0).epsilon(2e-6));
    }
    CHECK(sum == Approx(1.0).epsilon(1e-9));
  }
}
