// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneGeometry.h"
#include "vtkHeliosObbTreeRayCaster.h"

#include "../../../Testing/Cxx/heliosRayCasterChecks.h"

using Caster = vtkHeliosObbTreeRayCaster;
using helios::Vec3;

TEST_CASE("ObbTreeRayCaster: rays in general position agree with brute force", "[ObbTreeRayCaster]")
{
  for (const Vec3& offset : helios::Offsets)
  {
    helios::Soup soup = helios::MakeTerrain(30, 1.0);
    helios::AddLeaves(soup, 300, 0.3, { 0, 0, 5 }, { 30, 30, 15 });
    soup.Move(offset, 1.0);
    const auto scene = soup.GetPolyData();
    vtkNew<Caster> caster;
    REQUIRE(caster->Build(scene));
    const auto rays = helios::MakeRays(soup, 1000);
    std::vector<vtkHeliosHit> truth;
    for (const vtkHeliosRay& ray : rays)
    {
      truth.push_back(helios::IntersectBruteForce(caster->GetGeometry().GetMesh(), ray));
    }
    std::vector<unsigned char> occluded(rays.size(), 2);
    caster->Occluded(rays.data(), occluded.data(), static_cast<vtkIdType>(rays.size()));
    const std::vector<vtkHeliosHit> hits = helios::Cast(caster, rays);
    int lost = 0, invented = 0, wrong = 0;
    for (std::size_t i = 0; i < rays.size(); ++i)
    {
      const bool isHit = truth[i].CellId >= 0;
      lost += isHit && hits[i].CellId < 0;
      invented += !isHit && hits[i].CellId >= 0;
      wrong +=
        hits[i].CellId >= 0 && hits[i].CellId == truth[i].CellId && hits[i].Range != truth[i].Range;
      REQUIRE(occluded[i] == (hits[i].CellId >= 0 ? 1 : 0));
    }
    INFO("offset " << offset[0]);
    CHECK(wrong == 0); // the common test computes the range of a triangle
    CHECK(lost <= 5);
    CHECK(invented <= 40); // a quarter of the rays passes along edges, within the tolerance
  }
}

TEST_CASE("ObbTreeRayCaster: degenerate triangles and invalid rays", "[ObbTreeRayCaster]")
{
  helios::CheckDegenerate<Caster>();
}

TEST_CASE("ObbTreeRayCaster: threads and batches", "[ObbTreeRayCaster]")
{
  helios::Soup soup = helios::MakeTerrain(30, 1.0);
  vtkNew<Caster> caster;
  const auto scene = soup.GetPolyData();
  REQUIRE(caster->Build(scene));
  const auto rays = helios::MakeRays(soup, 2000);
  const auto truth = helios::Cast(caster, rays);
  std::vector<vtkHeliosHit> hits(rays.size());
  const auto count = static_cast<vtkIdType>(rays.size());
  std::thread other([&] { caster->Intersect(rays.data(), hits.data(), count / 2); });
  caster->Intersect(&rays[rays.size() / 2], &hits[rays.size() / 2], count - count / 2);
  other.join();
  CHECK(helios::CountDifferences(hits, truth) == 0);
}
