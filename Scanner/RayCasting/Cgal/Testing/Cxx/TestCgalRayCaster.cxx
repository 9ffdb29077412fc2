// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosCgalRayCaster.h"

#include "../../../Testing/Cxx/heliosRayCasterChecks.h"

using Caster = vtkHeliosCgalRayCaster;

TEST_CASE("CgalRayCaster: equal to brute force bit for bit", "[CgalRayCaster]")
{
  helios::CheckAgainstBruteForce<Caster>(3000);
}

TEST_CASE("CgalRayCaster: no leak at edges and corners", "[CgalRayCaster]")
{
  helios::CheckLeaks<Caster>(4);
}

TEST_CASE("CgalRayCaster: the lowest cell id at equal ranges", "[CgalRayCaster]")
{
  helios::CheckTies<Caster>();
}

TEST_CASE("CgalRayCaster: degenerate triangles and invalid rays", "[CgalRayCaster]")
{
  helios::CheckDegenerate<Caster>();
}

TEST_CASE("CgalRayCaster: threads and batches", "[CgalRayCaster]")
{
  helios::CheckThreads<Caster>();
}

TEST_CASE("CgalRayCaster: at most 80 bytes per triangle, excluding the scene", "[CgalRayCaster]")
{
  const auto scene = helios::MakeTerrain(100, 1.0).GetPolyData();
  vtkNew<Caster> caster;
  REQUIRE(caster->Build(scene));
  CHECK(caster->GetAcceleratorSize() > 0);
  CHECK(caster->GetAcceleratorSize() <= 80 * static_cast<std::size_t>(scene->GetNumberOfCells()));
}

TEST_CASE("CgalRayCaster: one triangle, and none with area", "[CgalRayCaster]")
{
  helios::Soup soup;
  soup.AddTriangle({ 1, -1, -1 }, { 1, 1, -1 }, { 1, 0, 2 });
  vtkNew<Caster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  CHECK(helios::Cast(caster, { helios::MakeRay({ 0, 0, 0 }, { 1, 0, 0 }) })[0].Range == 1.0);
  helios::Soup flat;
  flat.AddTriangle({ 1, 0, 0 }, { 1, 1, 0 }, { 1, 2, 0 });
  REQUIRE(caster->Build(flat.GetPolyData()));
  CHECK(helios::Cast(caster, { helios::MakeRay({ 0, 1, 0 }, { 1, 0, 0 }) })[0].CellId == -1);
}
