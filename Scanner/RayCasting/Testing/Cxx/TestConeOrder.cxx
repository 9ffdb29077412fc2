// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Cone probes of surfaces that the tree returns in an unfavourable order.
#include "heliosConeProbe.h"
#include "heliosRayCastingScenes.h"
#include "vtkHeliosBeamRayCaster.h"

#include <catch2/catch.hpp>

using helios::Soup;

namespace
{

/// A triangle around the z axis, on the plane z = depth + slope x.
void AddPlane(Soup& soup, double depth, double slope, double size)
{
  const auto getPoint = [=](double x, double y) { return helios::Vec3(x, y, depth + slope * x); };
  soup.AddTriangle(getPoint(-size, -size), getPoint(size, -size), getPoint(0, 2 * size));
}

/// The kind for a cone along z of a tangent of 0.1.
int Probe(const Soup& soup, double distance)
{
  vtkNew<vtkHeliosBeamRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  const double from[3] = { 0, 0, 0 };
  const double axis[3] = { 0, 0, 1 };
  return caster->GetConeProbe()->Probe(from, axis, 0.1, distance).Kind;
}

/// Many small triangles beside the cone: a triangle far larger than them is an outlier of the tree.
Soup MakeDebris()
{
  Soup soup;
  helios::AddLeaves(soup, 1000, 0.1, { 15, -5, 8 }, { 20, 5, 12 });
  return soup;
}

} // namespace

TEST_CASE("ConeOrder: a nearer hit may reach farther than the one found before", "[ConeOrder]")
{
  // The outlier at 10 m is tested first: it seems to hide what is beyond 11 m. The tilted plane, at
  // 9.95 m, reaches from 9.6 to 10.4 m, so that what is at 11.2 m is within 1 m of it, in part.
  Soup soup = MakeDebris();
  AddPlane(soup, 10.0, 0.0, 1e5);
  AddPlane(soup, 9.95, 0.4, 3.0);
  CHECK(Probe(soup, 1.0) == vtkHeliosConeHit::PlanarFootprint);
  AddPlane(soup, 11.2, 0.0, 3.0);
  CHECK(Probe(soup, 1.0) == vtkHeliosConeHit::Unresolved);
}

TEST_CASE("ConeOrder: surfaces hidden in the whole cone do not count", "[ConeOrder]")
{
  // The second triangle has a corner before the first, outside the cone; inside it is behind.
  Soup soup = MakeDebris();
  AddPlane(soup, 10.0, 0.0, 3.0);
  soup.AddTriangle({ 0, 8, 5 }, { -3, -3, 19 }, { 3, -3, 19 });
  CHECK(Probe(soup, 0.01) == vtkHeliosConeHit::PlanarFootprint);
}

TEST_CASE("ConeOrder: a plane before more triangles than a probe holds", "[ConeOrder]")
{
  Soup soup = MakeDebris();
  AddPlane(soup, 10.0, 0.0, 1e5); // an outlier
  helios::AddLeaves(soup, 200, 0.05, { -1, -1, 12 }, { 1, 1, 14 });
  CHECK(Probe(soup, 0.01) == vtkHeliosConeHit::PlanarFootprint);
  Soup inTree = MakeDebris();
  for (int i = 0; i < 30; ++i) // corners before the plane, hidden in the cone
  {
    inTree.AddTriangle({ 0.1 * i, 8, 5 }, { -3, -3, 19.0 + i }, { 3, -3, 19.0 + i });
  }
  AddPlane(inTree, 10.0, 0.0, 3.0);
  CHECK(Probe(inTree, 0.01) == vtkHeliosConeHit::PlanarFootprint);
}

TEST_CASE("ConeOrder: a tree of one leaf has its triangles once", "[ConeOrder]")
{
  Soup soup;
  AddPlane(soup, 10.0, 0.0, 3.0);
  vtkNew<vtkHeliosBeamRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  const double from[3] = { 0.1, 0.2, 0 };
  const double axis[3] = { 0, 0, 1 };
  helios::ConeLayer layer;
  for (auto& piece : layer.Pieces)
  {
    piece.Cell = -7;
  }
  caster->GetConeProbe()->Probe(from, axis, 0.01, 0.1, &layer);
  CHECK(layer.Size == 1);
  for (int i = 0; i < layer.Size; ++i)
  {
    CHECK(layer.Pieces[i].Cell >= 0);
  }
}
