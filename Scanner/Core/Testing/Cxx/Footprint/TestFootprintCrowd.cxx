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

/// A leaf of two triangles, in the beam at y; in one plane, unless a corner is beside it by a bend.
void AddLeaf(
  FootprintScene& scene, std::mt19937& random, double y, double bend = 0.0, bool isTurned = false)
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
  corners[3][1] += bend;
  double triangles[2][3][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      triangles[0][corner][axis] = corners[corner][axis];
      triangles[1][isTurned ? 2 - corner : corner][axis] = corners[(corner + 2) % 4][axis];
    }
  }
  scene.AddTriangle(triangles[0]);
  scene.AddTriangle(triangles[1]);
}

constexpr std::size_t Leaves = 40;

void AddLeaves(FootprintScene& scene, double bend = 0.0, bool isTurned = false)
{
  std::mt19937 random(3); // NOLINT(cert-msc32-c, cert-msc51-cpp): the same scenes every time
  for (std::size_t i = 0; i < Leaves; ++i)
  {
    AddLeaf(scene, random, 100.0, bend, isTurned);
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

/// Returns the cells of leaves, instead of their triangles.
Cells MergeLeaves(const Cells& cells)
{
  Cells leaves;
  for (const auto& [id, cell] : cells)
  {
    Cell& leaf = leaves[id / 2];
    const double energy = leaf.Energy + cell.Energy;
    leaf.Mean = (leaf.Energy * leaf.Mean + cell.Energy * cell.Mean) / energy;
    leaf.Energy = energy;
  }
  return leaves;
}

/// A wall of small triangles, off by random distances, at y.
void AddRoughWall(FootprintScene& scene, double y, double roughness, std::mt19937& random)
{
  constexpr int count = 6;
  std::uniform_real_distribution<double> number(-roughness, roughness);
  double corners[count + 1][count + 1][3];
  for (int i = 0; i <= count; ++i)
  {
    for (int k = 0; k <= count; ++k)
    {
      corners[i][k][0] = 0.12 * (i - 0.5 * count) + 0.033;
      corners[i][k][1] = y + number(random);
      corners[i][k][2] = 0.12 * (k - 0.5 * count) + 0.047;
    }
  }
  const auto add = [&scene](const double* a, const double* b, const double* c) {
    scene.AddTriangle({ { a[0], a[1], a[2] }, { b[0], b[1], b[2] }, { c[0], c[1], c[2] } });
  };
  for (int i = 0; i < count; ++i)
  {
    for (int k = 0; k < count; ++k)
    {
      add(corners[i][k], corners[i + 1][k], corners[i + 1][k + 1]);
      add(corners[i][k], corners[i + 1][k + 1], corners[i][k + 1]);
    }
  }
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

TEST_CASE("Crowd: two triangles of a leaf are one face, whichever way they are turned", "[Raster]")
{
  const bool isTurned = GENERATE(false, true);
  FootprintScene scene;
  AddLeaves(scene, 0.0, isTurned);
  scene.Build();
  scene.AreAlike = [](vtkIdType, vtkIdType) { return true; };
  scene.Settings.IsCrowd = Accept;
  const Cells triangles = scene.Sample(256);
  scene.Settings.PairTilt = 1e-3;
  const Cells pairs = scene.Sample(256);
  CHECK(pairs.size() < 0.7 * static_cast<double>(triangles.size()));
  CheckEqual(MergeLeaves(pairs), MergeLeaves(triangles));
}

TEST_CASE("Crowd: triangles that are bent, or differ, are two faces", "[Raster]")
{
  FootprintScene scene;
  const double bend = GENERATE(0.0, 0.02);
  AddLeaves(scene, bend);
  scene.Build();
  scene.AreAlike = [bend](vtkIdType, vtkIdType) { return bend > 0.0; };
  scene.Settings.IsCrowd = Accept;
  const Cells triangles = scene.Sample(256);
  scene.Settings.PairTilt = 1e-3;
  const Cells pairs = scene.Sample(256);
  CHECK(pairs.size() == triangles.size());
}

TEST_CASE("Crowd: none is mixed where a cone test finds one plane or one layer", "[Raster]")
{
  const double distance = GENERATE(1e-4, 2e-3, 0.05);
  int mixed = 0;
  int resolved = 0;
  for (unsigned seed = 0; seed < 60; ++seed)
  {
    FootprintScene scene;
    scene.Settings.IsCrowd = Accept;
    std::mt19937 random(seed); // NOLINT(cert-msc32-c, cert-msc51-cpp)
    const double roughness = std::pow(10.0, -static_cast<double>(seed / 2 % 6));
    AddRoughWall(scene, 100.0, roughness, random);
    for (unsigned i = 0; seed % 2 == 1 && i < Leaves / 2; ++i)
    {
      AddLeaf(scene, random, 90.0 + 0.4 * i);
    }
    scene.Build();
    const bool isMixed = scene.IsMixed(distance);
    const bool isResolved = scene.IsResolved(distance);
    CAPTURE(distance, roughness, seed);
    CHECK_FALSE((isMixed && isResolved));
    mixed += isMixed ? 1 : 0;
    resolved += isResolved ? 1 : 0;
  }
  CHECK(mixed >= 15);
  CHECK(resolved >= 5);
}
