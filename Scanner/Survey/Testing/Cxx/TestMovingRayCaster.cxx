// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Compares the ray caster for moving scenes with the caster of the whole scene.
#include "heliosMovingRayCaster.h"

#include "heliosConeProbe.h"
#include "heliosSceneGeometry.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCasterFactory.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <random>
#include <string>
#include <vector>

using helios::MovingRayCaster;

namespace
{

/// Random triangles of three parts in a box, each with a duplicate in the next part at the same
/// place; and a separate one of part 1. Part 1 is raised by lift.
vtkSmartPointer<vtkPolyData> MakeScene(double lift, bool onlyMoving)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  std::uniform_real_distribution<double> size(-2.0, 2.0);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkIntArray> ids;
  ids->SetName(vtkHeliosArrayNames::PartIds);
  for (int i = 0; i < 200; ++i)
  {
    const double p[3] = { place(random), place(random), place(random) };
    double corners[3][3];
    for (auto& corner : corners)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        corner[axis] = p[axis] + size(random);
      }
    }
    for (const int part : { i % 3, (i + 1) % 3 })
    {
      vtkIdType cell[3];
      for (int k = 0; k < 3; ++k)
      {
        const double up = part == 1 ? lift : 0.0;
        cell[k] = points->InsertNextPoint(corners[k][0], corners[k][1], corners[k][2] + up);
      }
      polys->InsertNextCell(3, cell);
      ids->InsertNextValue(onlyMoving ? 1 : part);
    }
  }
  const vtkIdType lone[3] = { points->InsertNextPoint(30, 0, lift),
    points->InsertNextPoint(40, 0, lift), points->InsertNextPoint(30, 10, lift) };
  polys->InsertNextCell(3, lone);
  ids->InsertNextValue(1);
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  scene->SetPoints(points);
  scene->SetPolys(polys);
  scene->GetCellData()->AddArray(ids);
  return scene;
}

/// Makes instances of the triangles at three places; cell ids of two of them are between the ids of
/// the mesh.
vtkSmartPointer<vtkPolyData> MakeInstances(double lift, bool onlyMoving)
{
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  scene->ShallowCopy(MakeScene(lift, onlyMoving));
  scene->AddPrototype(MakeScene(0.0, false));
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  places->InsertNextPoint(0.0, 0.0, 0.0); // triangles at the place of the mesh
  places->InsertNextPoint(3.0, 1.0, -5.0);
  places->InsertNextPoint(-8.0, 2.0, 9.0);
  vtkNew<vtkIdTypeArray> first;
  first->SetName(vtkHeliosArrayNames::FirstCellIds);
  const vtkIdType count = scene->GetNumberOfPolys();
  first->InsertNextValue(20);
  first->InsertNextValue(100 + count);
  first->InsertNextValue(3 * count);
  vtkNew<vtkIntArray> prototypes;
  prototypes->SetName(vtkHeliosArrayNames::PrototypeIds);
  prototypes->SetNumberOfValues(3);
  prototypes->Fill(0);
  vtkNew<vtkPolyData> instances;
  instances->SetPoints(places);
  instances->GetPointData()->AddArray(first);
  instances->GetPointData()->AddArray(prototypes);
  scene->SetInstances(instances);
  return scene;
}

/// Rays from below, four per beam.
std::vector<vtkHeliosRay> MakeRays()
{
  std::mt19937 random(6);
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  std::uniform_real_distribution<double> slope(-0.01, 0.01);
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < 2000; ++i)
  {
    const double x = place(random);
    const double y = place(random);
    for (int k = 0; k < 4; ++k)
    {
      rays.push_back({ { x, y, -30.0 }, { slope(random), slope(random), 1.0 } });
    }
  }
  rays.push_back({ { 33.0, 3.0, -50.0 }, { 0.0, 0.0, 1.0 } }); // to the separate triangle
  rays.insert(rays.end(), 3, rays.back());
  return rays;
}

} // namespace

TEST_CASE("MovingRayCaster: hits equal those of the whole scene", "[MovingRayCaster]")
{
  const std::string name = GENERATE("beam", "bvh");
  const bool onlyMoving = GENERATE(false, true);
  const auto make = GENERATE(&MakeScene, &MakeInstances);
  const auto kind =
    vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCasterFactory::Create(name.c_str()));
  const auto start = make(0.0, onlyMoving);
  vtkNew<MovingRayCaster> parts;
  parts->SetUp(kind, start, { 1 });
  CHECK(parts->GetName() == name);
  const auto rays = MakeRays();
  const auto count = static_cast<vtkIdType>(rays.size());
  std::vector<vtkHeliosHit> expected(rays.size());
  std::vector<vtkHeliosHit> hits(rays.size());
  for (const double lift : { 0.0, 1.5, -40.0, 0.0 })
  {
    const auto scene = make(lift, onlyMoving);
    INFO(lift);
    REQUIRE(kind->Build(scene));
    REQUIRE(parts->Build(scene));
    CHECK(parts->GetAcceleratorSize() > 0);
    kind->Intersect(rays.data(), expected.data(), count);
    int numberOfHits = 0;
    for (const int raysPerBeam : { 1, 4 })
    {
      parts->IntersectBeams(rays.data(), hits.data(), raysPerBeam, count / raysPerBeam);
      for (std::size_t i = 0; i < hits.size(); ++i)
      {
        REQUIRE(hits[i].CellId == expected[i].CellId);
        REQUIRE(hits[i].Range == expected[i].Range);
        numberOfHits += hits[i].CellId >= 0 ? 1 : 0;
      }
    }
    CHECK(numberOfHits > 4000);
    std::vector<unsigned char> occluded(rays.size());
    parts->Occluded(rays.data(), occluded.data(), count);
    for (std::size_t i = 0; i < hits.size(); ++i)
    {
      REQUIRE((occluded[i] != 0) == (expected[i].CellId >= 0));
    }
  }
}

TEST_CASE("MovingRayCaster: cones resolved by it are resolved equally in the whole scene",
  "[MovingRayCaster]")
{
  const auto kind =
    vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCasterFactory::Create("beam"));
  const auto scene = GENERATE(false, true) ? MakeScene(25.0, false) : MakeInstances(25.0, false);
  vtkNew<MovingRayCaster> parts;
  parts->SetUp(kind, scene, { 1 });
  REQUIRE(kind->Build(scene));
  REQUIRE(parts->Build(scene));
  const helios::ConeProbe* ofKind = kind->GetConeProbe();
  const helios::ConeProbe* ofParts = parts->GetConeProbe();
  REQUIRE((ofKind && ofParts));
  const double up[3] = { 0, 0, 1 };
  int counts[3] = { 0, 0, 0 };
  int planes[2] = { 0, 0 }; // planes of static and moving cells
  for (const vtkHeliosRay& ray : MakeRays())
  {
    const vtkHeliosConeHit whole = ofKind->Probe(ray.Origin, up, 0.001, 0.01);
    const vtkHeliosConeHit hit = ofParts->Probe(ray.Origin, up, 0.001, 0.01);
    ++counts[hit.Kind];
    REQUIRE((hit.Kind == whole.Kind || hit.Kind == vtkHeliosConeHit::Unresolved));
    REQUIRE((hit.Kind != vtkHeliosConeHit::Unresolved || whole.Kind != vtkHeliosConeHit::Empty));
    if (hit.Kind == vtkHeliosConeHit::PlanarFootprint)
    {
      REQUIRE(hit.CellId == whole.CellId);
      REQUIRE(hit.Range == whole.Range);
      vtkDataArray* ids = scene->GetCellData()->GetArray(vtkHeliosArrayNames::PartIds);
      const auto at = parts->GetGeometry().Find(hit.CellId);
      ++planes[!at.Instance && ids->GetComponent(at.Triangle, 0) == 1.0 ? 1 : 0];
    }
  }
  CHECK(counts[vtkHeliosConeHit::Empty] > 100);
  CHECK(counts[vtkHeliosConeHit::Unresolved] > 100);
  CHECK(planes[0] > 0);
  CHECK((planes[1] > 0 || vtkHeliosScene::HasInstances(scene))); // which are before the moving ones
}
