// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Instances of a scene against copies of their triangles.
#include "heliosConeProbe.h"
#include "heliosConeView.h"
#include "heliosFlatScene.h"
#include "heliosRayCasterChecks.h"
#include "heliosSceneGeometry.h"
#include "heliosScenePlaces.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosGroundSnap.h"
#include "vtkHeliosScene.h"

#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using helios::Dice;
using helios::Vec3;

namespace names = vtkHeliosArrayNames;

namespace
{

/// A terrain with trees and stones at any place, rotation and scale.
vtkSmartPointer<vtkHeliosScene> MakeStand(const Vec3& offset, int count = 200)
{
  helios::Soup terrain = helios::MakeTerrain(50, 2.0);
  terrain.Move(offset);
  helios::Soup tree;
  helios::AddLeaves(tree, 500, 0.2, { -2, -2, 2 }, { 2, 2, 10 });
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  scene->ShallowCopy(terrain.GetPolyData());
  scene->AddPrototype(tree.GetPolyData());
  scene->AddPrototype(helios::MakeIcosphere(3).GetPolyData());
  helios::ScenePlaces places;
  Dice dice(11);
  for (int i = 0; i < count; ++i)
  {
    const Vec3 at = offset + Vec3(dice(0, 100), dice(0, 100), dice(-1, 3));
    const helios::Quaternion q = i % 3 == 0 ? helios::Quaternion(1, 0, 0, 0)
      : i % 3 == 1                          ? helios::AxisAngle({ 0, 0, 1 }, dice(0, 360))
                                            : helios::AxisAngle(dice.Direction(), dice(0, 360));
    places.Add(i % 2, at, q, i % 5 == 0 ? 1.0 : dice(0.3, 2.0));
  }
  scene->SetInstances(places.Get());
  return scene;
}

vtkSmartPointer<vtkPolyData> Flatten(vtkHeliosScene* scene)
{
  auto flat = vtkSmartPointer<vtkPolyData>::New();
  REQUIRE(helios::FlattenScene(scene, flat).IsOk());
  REQUIRE(flat->GetNumberOfCells() == scene->GetNumberOfTriangles());
  return flat;
}

/// Beams from a point to points in the stand; skew: origins differ.
std::vector<vtkHeliosRay> MakeBeams(
  const Vec3& offset, const Vec3& from, double spread, int raysPerBeam, double skew = 0.0)
{
  Dice dice(6);
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < 300; ++i)
  {
    const Vec3 target = offset + Vec3(dice(0, 100), dice(0, 100), dice(-2, 12));
    const Vec3 direction = (target - from).Normalized();
    for (int k = 0; k < raysPerBeam; ++k)
    {
      rays.push_back(helios::MakeRay(from + dice.Direction() * (skew * dice()),
        direction + dice.Direction() * (k == 0 ? 0.0 : spread)));
    }
  }
  return rays;
}

/// Returns whether all hits equal the copy's, to the last bit.
bool AreEqual(const std::vector<vtkHeliosHit>& a, const std::vector<vtkHeliosHit>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const vtkHeliosHit& p, const vtkHeliosHit& q)
    { return p.CellId == q.CellId && (p.CellId < 0 || p.Range == q.Range); });
}

std::ptrdiff_t CountHits(const std::vector<vtkHeliosHit>& hits)
{
  return std::count_if(
    hits.begin(), hits.end(), [](const vtkHeliosHit& hit) { return hit.CellId >= 0; });
}

std::vector<vtkHeliosHit> CastBeams(
  vtkHeliosRayCaster* caster, const std::vector<vtkHeliosRay>& rays, int raysPerBeam)
{
  std::vector<vtkHeliosHit> hits(rays.size(), { -7.0, -7 });
  caster->IntersectBeams(
    rays.data(), hits.data(), raysPerBeam, static_cast<vtkIdType>(rays.size()) / raysPerBeam);
  return hits;
}

/// Whether a triangle in the frame of a cone touches it, found by samples of its points.
bool Touches(const helios::ConeTriangle& t, double tangent)
{
  constexpr int n = 20;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; i + j <= n; ++j)
    {
      double p[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        p[axis] =
          (i * t.Corners[0][axis] + j * t.Corners[1][axis] + (n - i - j) * t.Corners[2][axis]) / n;
      }
      if (p[2] > 0 && std::hypot(p[0], p[1]) <= tangent * p[2])
      {
        return true;
      }
    }
  }
  return false;
}

/// The triangles of a view that touch the cone before a depth and are not in the other one, with the
/// same corners.
int CountMissing(
  const helios::ConeView& view, const helios::ConeView& other, double tangent, double farthest)
{
  return static_cast<int>(std::count_if(view.Triangles.begin(), view.Triangles.end(),
    [&](const helios::ConeTriangle& t)
    {
      const auto* corners = &t.Corners[0][0];
      const bool isThere = std::any_of(other.Triangles.begin(), other.Triangles.end(),
        [&](const auto& o)
        { return o.Cell == t.Cell && std::equal(corners, corners + 9, &o.Corners[0][0]); });
      return !isThere && Touches(t, tangent) &&
        std::min({ t.Corners[0][2], t.Corners[1][2], t.Corners[2][2] }) < farthest;
    }));
}

} // namespace

TEST_CASE("instances: hits are those of a copy, to the last bit", "[instances]")
{
  for (const Vec3& offset : helios::Offsets)
  {
    const auto scene = MakeStand(offset);
    vtkNew<vtkHeliosBeamRayCaster> beam;
    vtkNew<vtkHeliosBvhRayCaster> flat, other;
    REQUIRE(beam->Build(scene));
    REQUIRE(flat->Build(Flatten(scene)));
    REQUIRE(other->Build(scene)); // copies the instances itself
    for (const double height : { 3.0, 100.0, 20000.0 })
    {
      const Vec3 from = offset + Vec3(40, 55, height);
      for (const double width : { 0.1, 10.0 }) // range of a beam where it ends
      {
        const double spread = width / std::max(height, 30.0);
        for (const double skew : { 0.0, 0.5 })
        {
          const auto rays = MakeBeams(offset, from, spread, 19, skew);
          const auto truth = helios::Cast(flat, rays);
          CHECK(AreEqual(CastBeams(beam, rays, 19), truth));
          CHECK(AreEqual(helios::Cast(beam, rays), truth));
          CHECK(AreEqual(helios::Cast(other, rays), truth));
        }
      }
      const auto rays = MakeBeams(offset, from, 0.0, 1);
      CHECK(CountHits(helios::Cast(beam, rays)) > 200);
      const auto many = MakeBeams(offset, from, 3.0 / std::max(height, 30.0), 100);
      CHECK(AreEqual(CastBeams(beam, many, 100), helios::Cast(flat, many)));
    }
  }
}

TEST_CASE("instances: occlusion is that of a copy", "[instances]")
{
  const auto scene = MakeStand({ 5e5, 5.5e6, 300 });
  vtkNew<vtkHeliosBeamRayCaster> beam, flat;
  REQUIRE(beam->Build(scene));
  REQUIRE(flat->Build(Flatten(scene)));
  const Vec3 offset(5e5, 5.5e6, 300);
  auto rays = MakeBeams(offset, offset + Vec3(10, 10, 4), 0.1, 19);
  Dice dice(8);
  for (vtkHeliosRay& ray : rays)
  {
    ray.MaximumRange = dice(0.0, 60.0);
  }
  std::vector<unsigned char> own(rays.size()), truth(rays.size());
  beam->Occluded(rays.data(), own.data(), static_cast<vtkIdType>(rays.size()));
  flat->Occluded(rays.data(), truth.data(), static_cast<vtkIdType>(rays.size()));
  CHECK(own == truth);
  const auto count = std::count(own.begin(), own.end(), 1);
  CHECK(count > 1000);
  CHECK(count < static_cast<std::ptrdiff_t>(own.size()) - 1000);
}

TEST_CASE("instances: cones collect the triangles of a copy", "[instances]")
{
  const Vec3 offset(5e5, 5.5e6, 300);
  const auto scene = MakeStand(offset);
  vtkNew<vtkHeliosBeamRayCaster> beam, flat;
  REQUIRE(beam->Build(scene));
  REQUIRE(flat->Build(Flatten(scene)));
  const Vec3 from = offset + Vec3(40, 55, 500);
  int kinds[3] = {};
  int different = 0;
  std::size_t triangles = 0;
  for (const vtkHeliosRay& ray : MakeBeams(offset, from, 0.0, 1))
  {
    const Vec3 axis = Vec3(ray.Direction).Normalized();
    for (const double tangent : { 1e-4, 1e-3 })
    {
      const helios::PlaneLimits limits(0.001);
      const auto probe = [&](vtkHeliosRayCaster* caster)
      { return caster->GetConeProbe()->Probe(from.GetData(), axis.GetData(), tangent, limits); };
      const vtkHeliosConeHit hit = probe(beam);
      const vtkHeliosConeHit truth = probe(flat);
      // The members of a cone come in another order: there may be too many of them.
      const bool isEqual = hit.Kind == truth.Kind && hit.CellId == truth.CellId;
      different += isEqual ? 0 : 1;
      CHECK((isEqual || hit.Kind == vtkHeliosConeHit::Unresolved));
      ++kinds[hit.Kind];

      helios::ConeView own, all;
      REQUIRE(
        beam->GetConeProbe()->Collect(from.GetData(), axis.GetData(), tangent, 0.0, 100000, own));
      REQUIRE(
        flat->GetConeProbe()->Collect(from.GetData(), axis.GetData(), tangent, 0.0, 100000, all));
      triangles += own.Triangles.size();
      const double farthest = std::min(own.Farthest, all.Farthest);
      CHECK(own.Farthest == all.Farthest);
      CHECK(CountMissing(all, own, tangent, farthest) == 0);
      CHECK(CountMissing(own, all, tangent, farthest) == 0);
    }
  }
  CHECK(different < 8); // at least 10 of 600
  CHECK(kinds[vtkHeliosConeHit::PlanarFootprint] > 10);
  CHECK(kinds[vtkHeliosConeHit::Unresolved] > 10);
  CHECK(triangles > 1000);
}

TEST_CASE("instances: no ray is lost between neighbours", "[instances]")
{
  // A wall of square tiles, each an instance turned by a multiple of 90 degrees.
  helios::Soup tile;
  tile.AddTriangle({ -0.5, -0.5, 0 }, { 0.5, -0.5, 0 }, { 0.5, 0.5, 0 });
  tile.AddTriangle({ -0.5, -0.5, 0 }, { 0.5, 0.5, 0 }, { -0.5, 0.5, 0 });
  vtkNew<vtkHeliosScene> scene;
  scene->AddPrototype(tile.GetPolyData());
  helios::ScenePlaces places;
  for (int i = 0; i < 400; ++i)
  {
    const helios::Quaternion turn =
      i % 4 == 0 ? helios::Quaternion(1, 0, 0, 0) : helios::Quaternion(i % 4 - 2, 0, 0, 1);
    places.Add(0, { i % 20 + 0.5, i / 20 + 0.5, 0 }, turn, 1.0);
  }
  scene->SetInstances(places.Get());
  vtkNew<vtkHeliosBeamRayCaster> beam;
  REQUIRE(beam->Build(scene));
  Dice dice(4);
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < 20000; ++i)
  {
    const Vec3 from = dice.Point(5, 15);
    const double along = dice(2, 18);
    const Vec3 to = i % 2 == 0 ? Vec3(std::floor(along), dice(2, 18), 0) // on an edge
                               : Vec3(dice(2, 18), std::floor(along), 0);
    rays.push_back(helios::MakeRay(from, to - from));
  }
  CHECK(CountHits(helios::Cast(beam, rays)) == 20000);
}

TEST_CASE("instances: rays through the middle of a prototype hit as a copy", "[instances]")
{
  // A flat grid: where local coordinates are 0, boxes of floats are not wider than their triangles.
  helios::Soup grid;
  for (int j = -4; j <= 4; ++j)
  {
    for (int i = -4; i <= 4; ++i)
    {
      const vtkIdType a = grid.AddPoint(Vec3(i, j, 0));
      if (i < 4 && j < 4)
      {
        grid.Triangles.push_back({ a, a + 1, a + 10 });
        grid.Triangles.push_back({ a, a + 10, a + 9 });
      }
    }
  }
  const Vec3 offset = helios::Offsets[1];
  vtkNew<vtkHeliosScene> scene;
  scene->AddPrototype(grid.GetPolyData());
  helios::ScenePlaces places;
  Dice dice(5);
  for (int i = 0; i < 100; ++i)
  {
    places.Add(0, offset + Vec3(20.0 * (i % 10) + dice(), 20.0 * (i / 10) + dice(), dice()),
      helios::AxisAngle({ 0, 0, 1 }, dice(0, 360)), dice(0.3, 1.5));
  }
  scene->SetInstances(places.Get());
  helios::SceneGeometry geometry;
  REQUIRE(geometry.Set(scene).IsOk());
  std::vector<vtkHeliosRay> rays;
  for (const helios::SceneInstance& instance : geometry.GetInstances())
  {
    for (int k = 0; k < 40; ++k)
    {
      const double along = k < 9 ? k - 4.0 : dice(-4, 4); // corners and edges
      const double p[3] = { k % 2 == 0 ? 0.0 : along, k % 2 == 0 ? along : 0.0, 0.0 };
      double q[3];
      instance.Place.Apply(p, q);
      rays.push_back({ { q[0], q[1], q[2] + 500.0 }, { 0, 0, -1 } });
    }
  }
  vtkNew<vtkHeliosBeamRayCaster> beam;
  vtkNew<vtkHeliosBvhRayCaster> flat;
  REQUIRE(beam->Build(scene));
  REQUIRE(flat->Build(Flatten(scene)));
  const auto truth = helios::Cast(flat, rays);
  CHECK(CountHits(truth) > 3800);
  CHECK(AreEqual(helios::Cast(beam, rays), truth));
  CHECK(AreEqual(CastBeams(beam, rays, 40), truth));
}

TEST_CASE("instances: cell ids may lie between those of the mesh", "[instances]")
{
  const auto scene = MakeStand({ 0, 0, 0 }, 10);
  vtkNew<vtkIdTypeArray> first;
  first->SetName(names::FirstCellIds);
  helios::SceneGeometry geometry;
  REQUIRE(geometry.Set(scene).IsOk());
  vtkIdType shift = 0;
  for (const helios::SceneInstance& instance : geometry.GetInstances())
  {
    // 100 triangles of the mesh before each
    shift += 100;
    first->InsertNextValue(instance.FirstCell - 5000 + shift);
  }
  scene->GetInstances()->GetPointData()->AddArray(first);
  REQUIRE(geometry.Set(scene).IsOk());
  for (vtkIdType i = 0; i < 5000; ++i)
  {
    const auto cell = geometry.Find(geometry.GetCell(i));
    REQUIRE(cell.Instance == nullptr);
    REQUIRE(cell.Triangle == i);
  }
  CHECK(geometry.Find(100).Instance == &geometry.GetInstances()[0]);
  CHECK(geometry.Find(99).Instance == nullptr);

  vtkNew<vtkHeliosBeamRayCaster> beam;
  vtkNew<vtkHeliosBvhRayCaster> flat;
  REQUIRE(beam->Build(scene));
  REQUIRE(flat->Build(Flatten(scene)));
  const auto rays = MakeBeams({ 0, 0, 0 }, { 40, 55, 50 }, 0.1, 19);
  CHECK(AreEqual(CastBeams(beam, rays, 19), helios::Cast(flat, rays)));
}

TEST_CASE(
  "instances: a moved one is built again, another scene with the same is not", "[instances]")
{
  const auto scene = MakeStand({ 0, 0, 0 }, 10);
  vtkNew<vtkHeliosBeamRayCaster> beam;
  REQUIRE(beam->Build(scene));
  const vtkIdType count = beam->GetGeometry().GetNumberOfTriangles();
  const helios::Vec3 before = beam->GetGeometry().GetNormal(count - 1);
  vtkNew<vtkHeliosScene> same;
  same->ShallowCopy(scene);
  REQUIRE(beam->Build(same));
  CHECK(beam->GetGeometry().GetScene() == scene); // not built again
  // another scene of the same mesh with other instances
  vtkNew<vtkHeliosScene> other;
  other->ShallowCopy(scene);
  other->SetInstances(MakeStand({ 0, 0, 0 }, 12)->GetInstances());
  REQUIRE(beam->Build(other));
  CHECK(beam->GetGeometry().GetScene() == other);
  vtkNew<vtkHeliosScene> changed; // other prototypes
  changed->ShallowCopy(scene);
  changed->Initialize();
  changed->SetPoints(scene->GetPoints());
  changed->SetPolys(scene->GetPolys());
  changed->SetInstances(other->GetInstances());
  changed->AddPrototype(scene->GetPrototype(1));
  changed->AddPrototype(scene->GetPrototype(0));
  REQUIRE(beam->Build(changed));
  CHECK(beam->GetGeometry().GetScene() == changed);
  REQUIRE(beam->Build(scene));
  scene->GetInstances()->GetPoints()->SetPoint(9, 50.0, 50.0, 1000.0);
  scene->GetInstances()->Modified();
  REQUIRE(beam->Build(scene));
  vtkHeliosRay ray = helios::MakeRay({ 50, 50, 1100 }, { 0, 0, -1 });
  vtkHeliosHit hit;
  beam->Intersect(&ray, &hit, 1);
  CHECK(hit.Range < 105);
  CHECK((beam->GetGeometry().GetNormal(count - 1) - before).Norm() < 1e-9); // only moved
}

TEST_CASE("instances: points are placed on them as on a copy", "[instances]")
{
  const auto scene = MakeStand({ 5e5, 5.5e6, 300 });
  vtkNew<vtkPolyData> points;
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  Dice dice(12);
  for (int i = 0; i < 500; ++i)
  {
    places->InsertNextPoint(5e5 + dice(1, 99), 5.5e6 + dice(1, 99), 0);
  }
  points->SetPoints(places);
  vtkNew<vtkHeliosGroundSnap> snap, truth;
  snap->SetInputDataObject(0, points);
  snap->SetInputDataObject(1, scene);
  snap->Update();
  truth->SetInputDataObject(0, points);
  truth->SetInputDataObject(1, Flatten(scene));
  truth->Update();
  int onInstances = 0;
  for (vtkIdType i = 0; i < 500; ++i)
  {
    CHECK(snap->GetOutput()->GetPoint(i)[2] == truth->GetOutput()->GetPoint(i)[2]);
    onInstances += snap->GetOutput()->GetPoint(i)[2] > 300 + 3.5; // above the terrain
  }
  CHECK(onInstances > 50);
}

TEST_CASE("instances: invalid values have messages", "[instances]")
{
  const auto fails = [](const std::function<void(vtkHeliosScene*)>& change, const std::string& text)
  {
    const auto scene = MakeStand({ 0, 0, 0 }, 3);
    change(scene);
    helios::SceneGeometry geometry;
    const helios::Status status = geometry.Set(scene);
    INFO(status.Message());
    CHECK(status.Message().find(text) != std::string::npos);
  };
  const auto array = [](vtkHeliosScene* s, const char* name)
  { return s->GetInstances()->GetPointData()->GetArray(name); };
  fails([&](vtkHeliosScene* s) { array(s, names::PrototypeIds)->SetComponent(1, 0, 2); },
    "instance 1 of the scene has PrototypeIds 2, but there are 2 prototypes, from 0");
  fails([&](vtkHeliosScene* s) { array(s, names::Scale)->SetComponent(2, 0, -1); },
    "instance 2 of the scene has Scale -1; set a number greater than 0");
  fails([&](vtkHeliosScene* s) { array(s, names::Orientation)->SetTuple4(0, 0, 0, 0, 0); },
    "instance 0 of the scene has an Orientation that is no rotation");
  fails([&](vtkHeliosScene* s) { array(s, names::Scale)->SetNumberOfTuples(2); },
    "point array Scale of the instances has 2 tuples of 1 for 3 instances");
  fails([&](vtkHeliosScene* s) { s->GetInstances()->GetPoints()->SetPoint(0, std::nan(""), 0, 0); },
    "instance 0 of the scene has a point that is not finite");
  fails([&](vtkHeliosScene* s) { s->AddPrototype(vtkSmartPointer<vtkPolyData>::New()); },
    "prototype 2: the scene is empty");
  fails(
    [&](vtkHeliosScene* s)
    {
      vtkNew<vtkIdTypeArray> first;
      first->SetName(names::FirstCellIds);
      for (vtkIdType id : { 0, 4000, 3000 })
      {
        first->InsertNextValue(id);
      }
      s->GetInstances()->GetPointData()->AddArray(first);
    },
    "instance 2 of the scene has FirstCellIds 3000, expected");
  helios::TriangleMesh mesh;
  CHECK(mesh.Set(MakeStand({ 0, 0, 0 }, 3)).Message() ==
    "the scene has instances, which are not supported here; pass it through "
    "vtkHeliosSceneFlatten first");
}
