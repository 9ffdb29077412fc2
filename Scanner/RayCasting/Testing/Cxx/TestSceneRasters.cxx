// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rasters of heights in a scene against meshes of the same triangles.
#include "heliosConeProbe.h"
#include "heliosConeView.h"
#include "heliosErrorObserver.h"
#include "heliosFlatScene.h"
#include "heliosMaterialTable.h"
#include "heliosRasterScenes.h"
#include "heliosRayCasterChecks.h"
#include "heliosSceneGeometry.h"
#include "heliosScenePlaces.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosClearance.h"
#include "vtkHeliosGroundSnap.h"
#include "vtkHeliosScene.h"

#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <string>

using helios::Dice;
using helios::Quaternion;
using helios::Vec3;

namespace names = vtkHeliosArrayNames;

namespace
{

/// Where a raster is.
struct Tilt
{
  Vec3 At;
  Quaternion Turn;
  double Scale;
};

const std::vector<Tilt> Tilts = { { { 0, 0, 0 }, Quaternion(1, 0, 0, 0), 1.0 },
  { { 12.3, -4.5, 30.1 }, Quaternion(1, 0, 0, 0), 1.0 },
  { { 1, 2, 3 }, helios::AxisAngle({ 0, 0, 1 }, 33.0), 1.7 },
  { { 3, 2, 1 }, helios::AxisAngle({ 0.2, 0.1, 1 }, 20.0), 0.4 } };

vtkSmartPointer<vtkImageData> MakeRaster(const helios::GeoTransform& transform)
{
  helios::HeightRaster raster(60, 45, transform);
  raster.AddHills(5.0, 1.0);
  raster.AddHoles();
  return raster.MakeImage<vtkFloatArray>();
}

/// A raster at a place, and a few meshes near it.
vtkSmartPointer<vtkHeliosScene> MakeScene(vtkImageData* raster, const Tilt& tilt)
{
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  scene->AddPrototype(raster);
  scene->AddPrototype(helios::MakeIcosphere(2).GetPolyData());
  helios::ScenePlaces places;
  places.Add(0, tilt.At, tilt.Turn, tilt.Scale);
  helios::HeightField field;
  REQUIRE(field.Set(raster).IsOk());
  for (int i = 0; i < 20; ++i)
  {
    double corners[3][3];
    field.GetCorners(field.GetNumberOfTriangles() * i / 20, corners);
    const double turn[4] = { tilt.Turn.GetW(), tilt.Turn.GetX(), tilt.Turn.GetY(),
      tilt.Turn.GetZ() };
    helios::Similarity(turn, tilt.Scale, tilt.At.GetData()).Apply(corners[0], corners[1]);
    places.Add(1, Vec3(corners[1]), Quaternion(1, 0, 0, 0), 0.7);
  }
  scene->SetInstances(places.Get());
  return scene;
}

vtkSmartPointer<vtkPolyData> Flatten(vtkHeliosScene* scene)
{
  auto flat = vtkSmartPointer<vtkPolyData>::New();
  REQUIRE(helios::FlattenScene(scene, flat).IsOk());
  return flat;
}

/// Beams of 7 rays to and along the scene.
std::vector<vtkHeliosRay> MakeBeams(vtkPolyData* flat, int count)
{
  Dice dice(5);
  double b[6];
  flat->GetBounds(b);
  const auto pick = [&] { return Vec3(dice(b[0], b[1]), dice(b[2], b[3]), dice(b[4], b[5] + 5)); };
  std::vector<vtkHeliosRay> rays;
  for (int i = 0; i < count; ++i)
  {
    const Vec3 from = pick() + Vec3(0, 0, i % 3 == 0 ? 40.0 : 0.0);
    const Vec3 along = (pick() - from).Normalized();
    for (int k = 0; k < 7; ++k)
    {
      rays.push_back(helios::MakeRay(from, along + dice.Direction() * (k == 0 ? 0.0 : 2e-3)));
    }
  }
  return rays;
}

bool AreEqual(const std::vector<vtkHeliosHit>& a, const std::vector<vtkHeliosHit>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const vtkHeliosHit& p, const vtkHeliosHit& q)
    { return p.CellId == q.CellId && (p.CellId < 0 || p.Range == q.Range); });
}

std::vector<vtkHeliosHit> Cast(
  const vtkHeliosRayCaster* caster, const std::vector<vtkHeliosRay>& rays, int raysPerBeam)
{
  std::vector<vtkHeliosHit> hits(rays.size(), { -7.0, -7 });
  caster->IntersectBeams(
    rays.data(), hits.data(), raysPerBeam, static_cast<vtkIdType>(rays.size()) / raysPerBeam);
  return hits;
}

} // namespace

TEST_CASE("scene rasters: hits, normals and bounds are those of a mesh", "[sceneRasters]")
{
  for (const helios::GeoTransform& transform : helios::TestTransforms)
  {
    for (const Tilt& tilt : Tilts)
    {
      const auto scene = MakeScene(MakeRaster(transform), tilt);
      const auto flat = Flatten(scene);
      REQUIRE(flat->GetNumberOfPolys() == scene->GetNumberOfTriangles());
      vtkNew<vtkHeliosBeamRayCaster> caster;
      vtkNew<vtkHeliosBvhRayCaster> truth;
      REQUIRE(caster->Build(scene));
      REQUIRE(truth->Build(flat));
      const auto rays = MakeBeams(flat, 400);
      const auto expected = Cast(truth, rays, 1);
      CHECK(std::count_if(expected.begin(), expected.end(),
              [](const vtkHeliosHit& hit) { return hit.CellId >= 0; }) > 400);
      CHECK(AreEqual(Cast(caster, rays, 1), expected));
      CHECK(AreEqual(Cast(caster, rays, 7), expected));
      std::vector<unsigned char> isHidden(rays.size()), isTruth(rays.size());
      caster->Occluded(rays.data(), isHidden.data(), static_cast<vtkIdType>(rays.size()));
      truth->Occluded(rays.data(), isTruth.data(), static_cast<vtkIdType>(rays.size()));
      CHECK((isHidden == isTruth));
      for (const vtkHeliosHit& hit : expected)
      {
        if (hit.CellId >= 0)
        {
          REQUIRE(caster->GetGeometry().GetNormal(hit.CellId) ==
            truth->GetGeometry().GetNormal(hit.CellId));
        }
      }
      double bounds[6], own[6];
      caster->GetGeometry().GetBounds(bounds);
      flat->GetBounds(own);
      for (int i = 0; i < 6; i += 2)
      {
        CHECK(bounds[i] <= own[i]);
        CHECK(bounds[i + 1] >= own[i + 1]);
      }
    }
  }
}

TEST_CASE("scene rasters: cones see what they see of a mesh", "[sceneRasters]")
{
  for (const bool isAlone : { true, false })
  {
    const auto scene = MakeScene(MakeRaster(helios::TestTransforms[3]), Tilts[0]);
    if (isAlone)
    {
      helios::ScenePlaces places;
      places.Add(0, { 0, 0, 0 }, Quaternion(1, 0, 0, 0), 1.0);
      scene->SetInstances(places.Get());
    }
    const auto flat = Flatten(scene);
    vtkNew<vtkHeliosBeamRayCaster> caster, truth;
    REQUIRE(caster->Build(scene));
    REQUIRE(truth->Build(flat));
    int kinds[3] = {};
    for (const vtkHeliosRay& ray : MakeBeams(flat, 300))
    {
      const double tangent = 1e-3;
      const Vec3 axis = Vec3(ray.Direction).Normalized();
      const helios::PlaneLimits limits(0.001);
      const auto probe = [&](vtkHeliosRayCaster* own)
      { return own->GetConeProbe()->Probe(ray.Origin, axis.GetData(), tangent, limits); };
      const vtkHeliosConeHit hit = probe(caster);
      const vtkHeliosConeHit expected = probe(truth);
      ++kinds[hit.Kind];
      REQUIRE(hit.Kind == expected.Kind);
      REQUIRE(hit.CellId == expected.CellId);
      helios::ConeView own, all;
      REQUIRE(
        caster->GetConeProbe()->Collect(ray.Origin, axis.GetData(), tangent, 0.0, 10000, own));
      REQUIRE(truth->GetConeProbe()->Collect(ray.Origin, axis.GetData(), tangent, 0.0, 10000, all));
      REQUIRE(own.Farthest == all.Farthest);
    }
    CHECK(kinds[vtkHeliosConeHit::PlanarFootprint] > 10);
    CHECK(kinds[vtkHeliosConeHit::Unresolved] > 10);
  }
}

TEST_CASE("scene rasters: other ray casters copy the triangles", "[sceneRasters]")
{
  const auto scene = MakeScene(MakeRaster(helios::TestTransforms[3]), Tilts[2]);
  const auto flat = Flatten(scene);
  vtkNew<vtkHeliosBeamRayCaster> caster;
  vtkNew<vtkHeliosBvhRayCaster> copies;
  REQUIRE(caster->Build(scene));
  REQUIRE(copies->Build(scene));
  CHECK(caster->GetMemorySize() * 2 < copies->GetMemorySize());
  const auto rays = MakeBeams(flat, 100);
  CHECK(AreEqual(Cast(caster, rays, 1), Cast(copies, rays, 1)));
}

TEST_CASE("scene rasters: the ground below points is that of a mesh", "[sceneRasters]")
{
  for (const helios::GeoTransform& transform : helios::TestTransforms)
  {
    for (const Tilt& tilt : Tilts)
    {
      const auto scene = MakeScene(MakeRaster(transform), tilt);
      const auto flat = Flatten(scene);
      // At vertices, along edges and elsewhere.
      vtkNew<vtkPoints> places;
      places->SetDataTypeToDouble();
      Dice dice(3);
      for (vtkIdType i = 0; i < 200; ++i)
      {
        double corners[3][3];
        const auto cell = static_cast<vtkIdType>(dice() * 3000.0);
        vtkIdType size;
        const vtkIdType* ids;
        flat->GetPolys()->GetCellAtId(cell, size, ids);
        for (int k = 0; k < 3; ++k)
        {
          flat->GetPoint(ids[k], corners[k]);
        }
        const double u = i % 3 == 0 ? 1e-6 : dice(0.0, 0.5);
        const double v = i % 3 == 2 ? dice(0.0, 0.5) : 1e-6;
        const Vec3 a(corners[0]);
        const Vec3 p = a + (Vec3(corners[1]) - a) * u + (Vec3(corners[2]) - a) * v;
        places->InsertNextPoint(p[0], p[1], 0.0);
      }
      vtkNew<vtkPolyData> points;
      points->SetPoints(places);
      vtkNew<vtkHeliosGroundSnap> snap, truth;
      vtkNew<helios::ErrorObserver> log, truthLog;
      log->Watch(snap);
      truthLog->Watch(truth);
      snap->SetInputDataObject(0, points);
      snap->SetInputDataObject(1, scene);
      snap->Update();
      truth->SetInputDataObject(0, points);
      truth->SetInputDataObject(1, flat);
      truth->Update();
      REQUIRE(log->Errors == "");
      REQUIRE(truthLog->Errors == "");
      REQUIRE(snap->GetOutput()->GetNumberOfPoints() == truth->GetOutput()->GetNumberOfPoints());
      vtkIdType differences = 0;
      for (vtkIdType i = 0; i < snap->GetOutput()->GetNumberOfPoints(); ++i)
      {
        differences += snap->GetOutput()->GetPoint(i)[2] < truth->GetOutput()->GetPoint(i)[2] ||
          snap->GetOutput()->GetPoint(i)[2] > truth->GetOutput()->GetPoint(i)[2];
      }
      CHECK(differences == 0);
    }
  }
}

TEST_CASE("scene rasters: ground materials elsewhere count", "[sceneRasters]")
{
  // A raster of ground, and a stone beside it that is not ground.
  helios::HeightRaster raster(10, 10, helios::TestTransforms[1]);
  const auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  scene->AddPrototype(raster.MakeImage<vtkFloatArray>());
  scene->AddPrototype(helios::MakeIcosphere(1).GetPolyData());
  helios::ScenePlaces places;
  places.Add(0, { 0, 0, 0 }, Quaternion(1, 0, 0, 0), 1.0);
  places.Add(1, { 30, 30, 0 }, Quaternion(1, 0, 0, 0), 1.0);
  const auto instances = places.Get();
  vtkNew<vtkIntArray> materials;
  materials->SetName(names::MaterialIds);
  materials->InsertNextValue(1);
  materials->InsertNextValue(0);
  instances->GetPointData()->AddArray(materials);
  scene->SetInstances(instances);
  helios::MaterialTable table(2);
  table[1].IsGround = true;
  helios::SetMaterials(scene, table);
  for (const bool isCopy : { false, true })
  {
    vtkNew<vtkPoints> at;
    at->InsertNextPoint(30, 30, 5);
    vtkNew<vtkPolyData> points;
    points->SetPoints(at);
    vtkNew<vtkHeliosGroundSnap> snap;
    vtkNew<helios::ErrorObserver> log;
    log->Watch(snap);
    snap->SetInputDataObject(0, points);
    snap->SetInputDataObject(1, isCopy ? Flatten(scene) : vtkSmartPointer<vtkPolyData>(scene));
    snap->Update();
    CHECK(log->HasError("no ground above or below point 0"));
    log->Clear();
    at->SetPoint(0, 4, 4, 5);
    at->Modified();
    points->Modified();
    snap->Update();
    CHECK(log->Errors == "");
    CHECK(snap->GetOutput()->GetPoint(0)[2] == 0.0);
  }
}

TEST_CASE("scene rasters: clearances are those of a mesh", "[sceneRasters]")
{
  for (const Tilt& tilt : Tilts)
  {
    const auto scene = MakeScene(MakeRaster(helios::TestTransforms[3]), tilt);
    const auto flat = Flatten(scene);
    double b[6];
    flat->GetBounds(b);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 0; i <= 40; ++i)
    {
      points->InsertNextPoint(
        b[0] + (b[1] - b[0]) * i / 40, b[2] + (b[3] - b[2]) * (i % 7) / 6, b[5] - (i % 3));
    }
    vtkNew<vtkPolyData> path;
    path->SetPoints(points);
    for (const int direction : { vtkHeliosClearance::DOWN, vtkHeliosClearance::ALL_AROUND })
    {
      vtkNew<vtkHeliosClearance> clearance, truth;
      for (vtkHeliosClearance* filter : { clearance.Get(), truth.Get() })
      {
        filter->SetInputDataObject(0, path);
        filter->SetDirection(direction);
      }
      clearance->SetInputDataObject(1, scene);
      truth->SetInputDataObject(1, flat);
      clearance->Update();
      truth->Update();
      CHECK(truth->GetSmallestClearance() < 100.0);
      auto* own = clearance->GetOutput()->GetPointData()->GetArray(names::Clearance);
      auto* expected = truth->GetOutput()->GetPointData()->GetArray(names::Clearance);
      REQUIRE(own);
      vtkIdType differences = 0;
      for (vtkIdType i = 0; i < 41; ++i)
      {
        differences +=
          own->GetTuple1(i) < expected->GetTuple1(i) || own->GetTuple1(i) > expected->GetTuple1(i);
      }
      CHECK(differences == 0);
    }
  }
}

TEST_CASE("scene rasters: invalid ones have messages", "[sceneRasters]")
{
  const auto fails = [](vtkImageData* raster, const std::string& text)
  {
    const auto scene = MakeScene(MakeRaster(helios::TestTransforms[0]), Tilts[0]);
    scene->AddPrototype(raster);
    vtkNew<vtkHeliosBeamRayCaster> caster;
    vtkNew<helios::ErrorObserver> log;
    log->Watch(caster);
    CHECK_FALSE(caster->Build(scene));
    INFO(log->Errors);
    CHECK(log->HasError(text));
    vtkNew<vtkPolyData> flat;
    CHECK(helios::FlattenScene(scene, flat).Message().find(text) != std::string::npos);
  };
  fails(vtkSmartPointer<vtkImageData>::New(), "prototype 2: the raster has 0 x 0 x 0 pixels");
  const auto noHeights = MakeRaster(helios::TestTransforms[0]);
  noHeights->GetPointData()->Initialize();
  fails(noHeights, "prototype 2: the raster has no point data Heights of 2700 floats or doubles");

  const auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  vtkNew<helios::ErrorObserver> log;
  log->Watch(scene);
  scene->AddPrototype(nullptr);
  CHECK(log->HasError("AddPrototype: the prototype is null; give a vtkPolyData of triangles, or a "
                      "vtkImageData of heights."));
}
