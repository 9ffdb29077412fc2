// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Cones in groups against the same cones, and rays in them, one by one.
#include "heliosConeGroup.h"
#include "heliosConeProbe.h"
#include "heliosRayCastingScenes.h"
#include "heliosScenePlaces.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosScene.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bitset>
#include <cmath>

using helios::ConeAxis;
using helios::ConeGroup;
using helios::Dice;
using helios::Vec3;

namespace
{

/// A wide floor with stones of 80 triangles on it, as instances.
vtkSmartPointer<vtkHeliosScene> MakeYard(const Vec3& offset)
{
  helios::Soup floor;
  floor.AddTriangle({ -60, -60, 0 }, { 60, -60, 0 }, { 60, 60, 0 });
  floor.AddTriangle({ -60, -60, 0 }, { 60, 60, 0 }, { -60, 60, 0 });
  floor.Move(offset);
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  scene->ShallowCopy(floor.GetPolyData());
  scene->AddPrototype(helios::MakeIcosphere(1).GetPolyData());
  helios::ScenePlaces places;
  Dice dice(3);
  for (int i = 0; i < 40; ++i)
  {
    places.Add(0, offset + Vec3(dice(-50, 50), dice(-50, 50), 2.0),
      helios::AxisAngle(dice.Direction(), dice(0, 360)), dice(1, 4));
  }
  scene->SetInstances(places.Get());
  return scene;
}

/// Consecutive cones of a scanner that moves and turns: about its azimuth and elevation [rad].
std::vector<ConeAxis> MakeLine(const Vec3& from, double azimuth, double elevation, double step)
{
  std::vector<ConeAxis> cones;
  for (int i = 0; i < 32; ++i)
  {
    const double angle = elevation + step * i;
    const Vec3 origin = from + Vec3(0.01 * i, 0.02 * i, 0.0);
    const Vec3 axis(
      std::cos(azimuth) * std::cos(angle), std::sin(azimuth) * std::cos(angle), std::sin(angle));
    ConeAxis cone;
    std::copy_n(origin.GetData(), 3, cone.Origin);
    std::copy_n(axis.Normalized().GetData(), 3, cone.Axis);
    cones.push_back(cone);
  }
  return cones;
}

/// Rays within a cone, from its apex.
std::vector<vtkHeliosRay> MakeRays(const ConeAxis& cone, double tangent, Dice& dice)
{
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < 19; ++i)
  {
    rays.push_back(helios::MakeRay(
      Vec3(cone.Origin), Vec3(cone.Axis) + dice.Direction() * (0.999 * tangent * dice())));
  }
  return rays;
}

bool IsEqual(const vtkHeliosHit& a, const vtkHeliosHit& b)
{
  return a.CellId == b.CellId && (a.CellId < 0 || a.Range == b.Range);
}

/// Counts of what was found.
struct Tally
{
  int Grouped = 0, TooMany = 0, Empty = 0, Single = 0, Planar = 0;
  int WrongProbes = 0, WrongHits = 0;
};

/// Compares a cone of a group with the cone alone.
void Compare(vtkHeliosBeamRayCaster* caster, const ConeGroup& group, const ConeAxis& cone,
  double tangent, Dice& dice, Tally& tally)
{
  helios::PlaneLimits limits(0.001);
  limits.OfLayer = { 0.1, 1.0 };
  helios::ConeLayer layer, own;
  const helios::ConeProbe* cones = caster->GetConeProbe();
  const vtkHeliosConeHit hit =
    cones->ProbeGroup(cone.Origin, cone.Axis, tangent, limits, &layer, group);
  const vtkHeliosConeHit truth = cones->Probe(cone.Origin, cone.Axis, tangent, limits, &own);
  tally.WrongProbes += hit.Kind == truth.Kind && hit.CellId == truth.CellId &&
      (hit.Kind == vtkHeliosConeHit::Unresolved || hit.Range == truth.Range) &&
      layer.Size == own.Size
    ? 0
    : 1;
  tally.Planar += hit.Kind == vtkHeliosConeHit::PlanarFootprint ? 1 : 0;

  const auto rays = MakeRays(cone, tangent, dice);
  std::vector<vtkHeliosHit> hits(rays.size(), { -7.0, -7 }), all(rays.size());
  caster->IntersectBeams(rays.data(), all.data(), static_cast<int>(rays.size()), 1);
  const helios::ConeTriangles found = group.Select(cone.Origin, cone.Axis, tangent);
  if (found.AreNone())
  {
    ++tally.Empty;
    std::fill(hits.begin(), hits.end(), vtkHeliosHit{ 0.0, -1 });
  }
  else if (found.IsOne())
  {
    ++tally.Single;
    group.Meet(found.Covering, rays.data(), rays.size(), hits.data());
  }
  else
  {
    return;
  }
  CHECK((found.AreNone() ? truth.Kind == vtkHeliosConeHit::Empty
                         : truth.Kind == vtkHeliosConeHit::PlanarFootprint));
  tally.WrongHits += std::equal(hits.begin(), hits.end(), all.begin(), IsEqual) ? 0 : 1;
}

} // namespace

TEST_CASE("ConeGroup: probes and hits are those of each cone alone, to the last bit", "[ConeGroup]")
{
  for (const Vec3& offset : helios::Offsets)
  {
    vtkNew<vtkHeliosBeamRayCaster> caster;
    REQUIRE(caster->Build(MakeYard(offset)));
    Tally tally;
    Dice dice(5);
    for (int line = 0; line < 150; ++line)
    {
      const Vec3 from = offset + Vec3(dice(-30, 30), dice(-30, 30), line % 2 == 0 ? 8.0 : 40.0);
      const double tangent = line % 3 == 0 ? 5e-3 : 2e-4;
      const auto cones =
        MakeLine(from, dice(0, 6.28), dice(-1.6, 0.8), line % 5 == 0 ? 2e-2 : 1e-3);
      ConeGroup group;
      if (!caster->GetConeProbe()->FindGroup(cones.data(), cones.size(), tangent, {}, group))
      {
        ++tally.TooMany;
        continue;
      }
      ++tally.Grouped;
      CHECK(group.GetNumberOfTriangles() <= ConeGroup::Capacity);
      for (const ConeAxis& cone : cones)
      {
        Compare(caster, group, cone, tangent, dice, tally);
      }
    }
    CHECK(tally.WrongProbes == 0);
    CHECK(tally.WrongHits == 0);
    CHECK(tally.Grouped > 50);
    CHECK(tally.TooMany > 5);
    CHECK(tally.Empty > 500);
    CHECK(tally.Single > 500);
    CHECK(tally.Planar > 500);
  }
}

TEST_CASE("ConeGroup: triangles far out of the scene are in it", "[ConeGroup]")
{
  helios::Soup soup;
  helios::AddLeaves(soup, 1000, 0.1, { 15, -5, 8 }, { 20, 5, 12 });
  soup.AddTriangle({ -1e5, -1e5, 10 }, { 1e5, -1e5, 10 }, { 0, 2e5, 10 });
  vtkNew<vtkHeliosBeamRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  const ConeAxis cone{ { 0, 0, 0 }, { 0, 0, 1 } };
  ConeGroup group;
  REQUIRE(caster->GetConeProbe()->FindGroup(&cone, 1, 0.01, {}, group));
  const helios::ConeTriangles found = group.Select(cone.Origin, cone.Axis, 0.01);
  CHECK(found.Touched == 1);
  CHECK(found.Covering == 1);
  const vtkHeliosRay ray = helios::MakeRay({ 0, 0, 0 }, { 0.001, 0, 1 });
  vtkHeliosHit hit{ 0.0, -1 };
  group.Meet(found.Covering, &ray, 1, &hit);
  CHECK(hit.CellId == 2000);
  CHECK(hit.Range == 10.0);
}

TEST_CASE("ConeGroup: triangles behind one that covers a cone are not selected", "[ConeGroup]")
{
  helios::Soup soup;
  soup.AddTriangle({ -9, -9, 5 }, { 9, -9, 5 }, { 0, 9, 5 });
  soup.AddTriangle({ 0, -9, 5.1 }, { 9, -9, 5.1 }, { 0, 9, 5.1 }); // an edge in the cone
  soup.AddTriangle({ -9, -9, 7 }, { 9, -9, 7 }, { 0, 9, 7 });      // covers it, too
  soup.AddTriangle({ -1, -1, 8 }, { 1, -1, 8 }, { 0, 1, 9 });      // farther at its other end
  vtkNew<vtkHeliosBeamRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  const ConeAxis cone{ { 0, 0, 0 }, { 0, 0, 1 } };
  ConeGroup group;
  REQUIRE(caster->GetConeProbe()->FindGroup(&cone, 1, 0.01, {}, group));
  REQUIRE(group.GetNumberOfTriangles() == 4);
  const auto count = [&](double distance)
  {
    const auto found = group.Select(cone.Origin, cone.Axis, 0.01, distance);
    return std::bitset<32>(found.Touched).count() + 10 * std::bitset<32>(found.Covering).count();
  };
  CHECK(count(0.0) == 11);
  CHECK(count(0.09) == 11);
  CHECK(count(0.11) == 12);
  CHECK(count(1e3) == 34);
  CHECK(group.Select(cone.Origin, cone.Axis, 0.01).IsOne());
}

TEST_CASE("ConeGroup: none of cones too wide, or that point to different sides", "[ConeGroup]")
{
  helios::Soup soup;
  soup.AddTriangle({ -1, -1, 5 }, { 1, -1, 5 }, { 0, 2, 5 });
  vtkNew<vtkHeliosBeamRayCaster> caster;
  REQUIRE(caster->Build(soup.GetPolyData()));
  const auto find = [&caster](const std::vector<ConeAxis>& cones, double tangent)
  {
    ConeGroup group;
    return caster->GetConeProbe()->FindGroup(cones.data(), cones.size(), tangent, {}, group);
  };
  const ConeAxis up{ { 0, 0, 0 }, { 0, 0, 1 } };
  CHECK(find({ up, up }, 0.01));
  CHECK_FALSE(find({ up }, 0.1));
  CHECK_FALSE(find({ up }, -0.1));
  CHECK_FALSE(find({ up, { { 0, 0, 0 }, { 0, 0, -1 } } }, 0.01));
  CHECK_FALSE(find({ up, { { 0, 0, 0 }, { 1, 0, 0 } } }, 0.01));
  CHECK_FALSE(find({ { { 0, 0, 0 }, { std::nan(""), 0, 0 } } }, 0.01));
  CHECK_FALSE(find({}, 0.01));
}
