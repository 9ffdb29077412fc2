// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Crowds of leaves, which are drawn as triangles, against the faces of facets.
#include "heliosFootprintScene.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace helios::testing;

namespace
{

/// A leaf of two triangles in one plane, in the beam at y.
void AddLeaf(FootprintScene& scene, std::mt19937& random, double y)
{
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  const double middle[3] = { 0.1 * number(random), y + number(random), 0.1 * number(random) };
  double a[3], b[3], corners[4][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = 0.04 * number(random);
    b[axis] = 0.04 * number(random);
    corners[0][axis] = middle[axis] - a[axis];
    corners[1][axis] = middle[axis] - b[axis];
    corners[2][axis] = middle[axis] + a[axis];
    corners[3][axis] = middle[axis] + b[axis];
  }
  double triangles[2][3][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      triangles[0][corner][axis] = corners[corner][axis];
      triangles[1][corner][axis] = corners[(corner + 2) % 4][axis];
    }
  }
  scene.AddTriangle(triangles[0]);
  scene.AddTriangle(triangles[1]);
}

constexpr std::size_t Leaves = 40;

void AddLeaves(FootprintScene& scene)
{
  std::mt19937 random(3); // NOLINT(cert-msc32-c, cert-msc51-cpp): the same scenes every time
  for (std::size_t i = 0; i < Leaves; ++i)
  {
    AddLeaf(scene, random, 100.0);
  }
  scene.AddWall(102.5, -25.0, -25.0);
  // Reaches behind the origin.
  scene.AddTriangle({ { 0.05, -10.0, -0.3 }, { 0.05, 200.0, -0.3 }, { 0.05, 200.0, -0.02 } });
}

bool Accept(std::size_t, double)
{
  return true;
}

void CheckEqual(const Cells& cells, const Cells& expected)
{
  double total = 0.0;
  for (const auto& [id, cell] : expected)
  {
    const auto found = cells.find(id);
    CAPTURE(id, cell.Energy);
    const Cell other = found == cells.end() ? Cell() : found->second;
    CHECK(other.Energy == Approx(cell.Energy).margin(2e-5)); // a cell on an edge
    if (cell.Energy > 1e-3)
    {
      CHECK(other.Mean == Approx(cell.Mean).epsilon(0).margin(1e-4));
    }
    total += other.Energy;
  }
  CHECK(total == Approx(1.0).epsilon(1e-6));
}

} // namespace

TEST_CASE("Crowd: triangles have the cells of the faces of facets", "[Raster]")
{
  const double ratio = GENERATE(1.0, 0.4);
  FootprintScene scene;
  scene.Settings.Ratio = ratio;
  scene.Minor[0] = 0.6;
  scene.Minor[2] = 0.8;
  AddLeaves(scene);
  scene.Build();
  CHECK(scene.CountCrowd() == 0);
  const Cells faces = scene.Sample(256);
  REQUIRE(faces.size() > 30);
  scene.Settings.IsCrowd = Accept;
  REQUIRE(scene.CountCrowd() > 20);
  CheckEqual(scene.Sample(256), faces);
}

TEST_CASE("Crowd: the triangles of one plane count once, large ones not", "[Raster]")
{
  FootprintScene scene;
  AddLeaves(scene);
  scene.Build();
  std::size_t surfaces = 0;
  double layers = 0.0;
  scene.Settings.IsCrowd = [&](std::size_t count, double covered)
  {
    surfaces = count;
    layers = covered;
    return false;
  };
  CHECK(scene.CountCrowd() == 0);
  CHECK(surfaces > Leaves / 2);
  CHECK(surfaces <= Leaves);
  CHECK(layers > 0.3);
  CHECK(layers < 3.0);
}

TEST_CASE("Crowd: none near a limit of the range gate, in a waist, or of few leaves", "[Raster]")
{
  FootprintScene scene;
  SECTION("gate")
  {
    scene.Settings.Gate[0] = 100.0;
    AddLeaves(scene);
  }
  SECTION("waist")
  {
    scene.Settings.ApexOffset = 50.0;
    AddLeaves(scene);
  }
  SECTION("few")
  {
    std::mt19937 random(5); // NOLINT(cert-msc32-c, cert-msc51-cpp)
    for (int i = 0; i < 5; ++i)
    {
      AddLeaf(scene, random, 100.0);
    }
    scene.AddWall(102.5, -25.0, -25.0);
  }
  scene.Build();
  scene.Settings.IsCrowd = Accept;
  CHECK(scene.CountCrowd() == 0);
}
