// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBvhRayCaster.h"

#include "heliosRayCasterChecks.h"

TEST_CASE("BvhRayCaster: equal to brute force bit for bit", "[BvhRayCaster]")
{
  helios::CheckAgainstBruteForce<vtkHeliosBvhRayCaster>(1000);
}

TEST_CASE("BvhRayCaster: a tree made of parts is equal to brute force", "[BvhRayCaster]")
{
  const helios::Soup soup = helios::MakeTerrain(200, 1.0); // 80,000 triangles
  const auto rays = helios::MakeRays(soup, 300);
  vtkNew<vtkHeliosBvhRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  std::vector<vtkHeliosHit> truth;
  for (const vtkHeliosRay& ray : rays)
  {
    truth.push_back(helios::IntersectBruteForce(caster->GetGeometry().GetMesh(), ray));
  }
  CHECK(helios::CountDifferences(helios::Cast(caster, rays), truth) == 0);
  const auto isHit = [](const vtkHeliosHit& hit) { return hit.CellId >= 0; };
  CHECK(std::count_if(truth.begin(), truth.end(), isHit) > 50);
}

TEST_CASE("BvhRayCaster: no leak at corners and edges", "[BvhRayCaster]")
{
  helios::CheckLeaks<vtkHeliosBvhRayCaster>(5);
}

TEST_CASE("BvhRayCaster: the lowest cell id at equal ranges", "[BvhRayCaster]")
{
  helios::CheckTies<vtkHeliosBvhRayCaster>();
}

TEST_CASE("BvhRayCaster: degenerate triangles are not hit", "[BvhRayCaster]")
{
  helios::CheckDegenerate<vtkHeliosBvhRayCaster>();
}

TEST_CASE("BvhRayCaster: byte-identical for any number of threads", "[BvhRayCaster]")
{
  helios::CheckThreads<vtkHeliosBvhRayCaster>();
}

TEST_CASE("BvhRayCaster: a distant point changes no other hit", "[BvhRayCaster]")
{
  helios::Soup soup = helios::MakeMixture();
  const auto rays = helios::MakeRays(soup, 3000);
  vtkNew<vtkHeliosBvhRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  const auto before = helios::Cast(caster, rays);
  soup.AddTriangle({ 1e30, 1e30, 1e30 }, { 1e30, 2e30, 1e30 }, { 1e30, 1e30, 2e30 });
  REQUIRE(caster->Build(soup.GetPolyData()));
  CHECK(helios::CountDifferences(helios::Cast(caster, rays), before) == 0);
}

TEST_CASE("BvhRayCaster: memory is small compared with the scene", "[BvhRayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  const helios::Soup soup = helios::MakeTerrain(200, 1.0);
  REQUIRE(caster->Build(soup.GetPolyData()));
  const double perTriangle =
    static_cast<double>(caster->GetAcceleratorSize()) / static_cast<double>(soup.Triangles.size());
  CHECK(perTriangle > 10);
  CHECK(perTriangle < 80);
}
