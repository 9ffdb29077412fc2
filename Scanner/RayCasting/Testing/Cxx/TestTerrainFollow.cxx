// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosTerrainFollow.h"

#include "heliosErrorObserver.h"
#include "heliosMaterialTable.h"
#include "heliosRayCastingScenes.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

namespace
{

namespace names = vtkHeliosArrayNames;
using helios::Vec3;

/// A rectangle over [x0, x1] x [-100, 100] with the given heights at both ends.
void AddSlab(helios::Soup& soup, double x0, double z0, double x1, double z1)
{
  soup.AddTriangle({ x0, -100, z0 }, { x1, -100, z1 }, { x1, 100, z1 });
  soup.AddTriangle({ x0, -100, z0 }, { x1, 100, z1 }, { x0, 100, z0 });
}

struct Follow
{
  vtkNew<vtkHeliosTerrainFollow> Filter;
  vtkNew<vtkPolyData> Waypoints;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkSmartPointer<helios::ErrorObserver> Quiet =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  Follow(const helios::Soup& scene, std::initializer_list<Vec3> waypoints)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkDoubleArray> speeds;
    speeds->SetName(names::Speed);
    for (const Vec3& p : waypoints)
    {
      speeds->InsertNextValue(10.0 + static_cast<double>(points->InsertNextPoint(p.GetData())));
    }
    this->Waypoints->SetPoints(points);
    this->Waypoints->GetPointData()->AddArray(speeds);
    this->Filter->SetInputData(0, this->Waypoints);
    this->Filter->SetInputData(1, scene.GetPolyData());
    this->Log->Watch(this->Filter);
    this->Quiet->Watch(this->Filter->GetExecutive());
  }

  vtkPolyData* Run()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }

  bool FailsWith(const std::string& message)
  {
    return this->Run()->GetNumberOfPoints() == 0 && this->Log->HasError(message);
  }
};

} // namespace

TEST_CASE("TerrainFollow: waypoints at a height above a slope", "[TerrainFollow]")
{
  helios::Soup scene;
  AddSlab(scene, 0, 0, 1000, 100);
  scene.Move({ 5e5, 5.5e6, 300 });
  Follow follow(scene, { { 500010, 5500000, 0 }, { 500910, 5500000, -7 } });
  vtkNew<vtkStringArray> crs;
  crs->SetName(names::CRS);
  follow.Waypoints->GetFieldData()->AddArray(crs);
  follow.Filter->SetHeight(80);
  vtkPolyData* way = follow.Run();
  REQUIRE(way->GetNumberOfPoints() == 2);
  CHECK(way->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(way->GetPoint(0)[2] == Approx(381).epsilon(1e-12));
  CHECK(way->GetPoint(1)[2] == Approx(471).epsilon(1e-12));
  CHECK(way->GetFieldData()->GetAbstractArray(names::CRS) == crs.Get());
  CHECK(way->GetPointData()->GetArray(names::LegIds)->GetTuple1(1) == 1.0);
}

TEST_CASE("TerrainFollow: additional waypoints have the settings of their leg", "[TerrainFollow]")
{
  helios::Soup scene = helios::MakeTerrain(100, 5);
  Follow follow(scene, { { 10, 20, 0 }, { 410, 320, 0 }, { 410, 320, 0 }, { 410, 331, 0 } });
  follow.Filter->SetSpacing(7);
  vtkPolyData* way = follow.Run();
  // 500 m are 72 pieces, 0 m one, 11 m two.
  REQUIRE(way->GetNumberOfPoints() == 72 + 1 + 2 + 1);
  vtkDataArray* legs = way->GetPointData()->GetArray(names::LegIds);
  vtkDataArray* speeds = way->GetPointData()->GetArray(names::Speed);
  const vtkNew<vtkHeliosTerrainFollow> single;
  for (vtkIdType i = 0; i < way->GetNumberOfPoints(); ++i)
  {
    const int leg = i < 72 ? 0 : (i < 73 ? 1 : (i < 75 ? 2 : 3));
    CHECK(legs->GetTuple1(i) == leg);
    CHECK(speeds->GetTuple1(i) == 10 + leg);
    if (leg == 0)
    {
      const double s = static_cast<double>(i) / 72;
      CHECK(way->GetPoint(i)[0] == Approx(10 + 400 * s).epsilon(1e-14));
      CHECK(way->GetPoint(i)[1] == Approx(20 + 300 * s).epsilon(1e-14));
    }
    // The reference: a ray.
    helios::TriangleMesh mesh;
    REQUIRE(mesh.Set(vtkPolyData::SafeDownCast(follow.Filter->GetInputDataObject(1, 0))).IsOk());
    const Vec3 p(way->GetPoint(i));
    const vtkHeliosRay ray = helios::MakeRay({ p[0], p[1], 50 }, { 0, 0, -1 });
    const double ground = 50 - helios::IntersectBruteForce(mesh, ray).Range;
    CHECK(p[2] == Approx(ground + 50).epsilon(1e-12));
  }
}

TEST_CASE("TerrainFollow: existing LegIds are kept", "[TerrainFollow]")
{
  helios::Soup scene;
  AddSlab(scene, 0, 0, 1000, 100);
  Follow follow(scene, { { 0, 0, 0 }, { 10, 0, 0 }, { 20, 0, 0 } });
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::LegIds);
  for (const int id : { 7, 9, 11 })
  {
    ids->InsertNextValue(id);
  }
  follow.Waypoints->GetPointData()->AddArray(ids);
  follow.Filter->SetSpacing(5);
  vtkDataArray* legs = follow.Run()->GetPointData()->GetArray(names::LegIds);
  REQUIRE(legs->GetNumberOfTuples() == 5);
  const double expected[5] = { 7, 7, 9, 9, 11 };
  for (vtkIdType i = 0; i < 5; ++i)
  {
    CHECK(legs->GetTuple1(i) == expected[i]);
  }
  CHECK(follow.Waypoints->GetPointData()->GetNumberOfArrays() == 2); // the input is unchanged
}

TEST_CASE("TerrainFollow: climbs before a step and descends after it", "[TerrainFollow]")
{
  // 0 up to x = 100, 60 up to x = 200, 0 again.
  helios::Soup scene;
  AddSlab(scene, 0, 0, 100, 0);
  AddSlab(scene, 100, 60, 200, 60);
  AddSlab(scene, 200, 0, 300, 0);
  Follow follow(scene, { { 0, 0, 0 }, { 300, 0, 0 } });
  follow.Filter->SetSpacing(10);
  follow.Filter->SetHeight(20);
  vtkPolyData* way = follow.Run();
  REQUIRE(way->GetNumberOfPoints() == 31);
  for (vtkIdType i = 0; i < 31; ++i)
  {
    CHECK(way->GetPoint(i)[2] == Approx(i < 10 || i > 20 ? 20 : 80)); // edges are high
  }
  follow.Filter->SetMaximumSlope(45);
  way = follow.Run();
  for (vtkIdType i = 0; i < 31; ++i)
  {
    const double x = 10.0 * static_cast<double>(i);
    const double off = std::max({ 0.0, 100 - x, x - 200 });
    CHECK(way->GetPoint(i)[2] == Approx(20 + std::max(0.0, 60 - off)));
  }
  follow.Filter->SetMaximumSlope(0); // level, at the greatest height
  CHECK(follow.Run()->GetPoint(0)[2] == Approx(80));
}

TEST_CASE("TerrainFollow: above the ground, or above all surfaces", "[TerrainFollow]")
{
  helios::Soup soup;
  AddSlab(soup, 0, 0, 100, 0);
  AddSlab(soup, 40, 12, 60, 12);
  Follow follow(soup, { { 50, 0, 0 } });
  const auto scene = soup.GetPolyData();
  helios::MaterialTable materials(2);
  materials[0].IsGround = true;
  helios::SetMaterials(scene, materials);
  vtkNew<vtkIntArray> ids;
  ids->SetName(names::MaterialIds);
  for (const int id : { 0, 0, 1, 1 })
  {
    ids->InsertNextValue(id);
  }
  scene->GetCellData()->AddArray(ids);
  follow.Filter->SetInputData(1, scene);
  CHECK(follow.Run()->GetPoint(0)[2] == Approx(50));
  follow.Filter->SetSurfaceToTop();
  CHECK(follow.Run()->GetPoint(0)[2] == Approx(62));
}

TEST_CASE("TerrainFollow: bad input is an error", "[TerrainFollow]")
{
  helios::Soup scene;
  AddSlab(scene, 0, 0, 100, 0);
  AddSlab(scene, 110, 0, 200, 0);
  Follow follow(scene, { { 50, 0, 0 }, { 150, 0, 0 } });
  SECTION("no ground below the path")
  {
    CHECK(follow.Run()->GetNumberOfPoints() == 2);
    follow.Filter->SetSpacing(5);
    CHECK(follow.FailsWith("The scene has no ground above or below point 11 at x 105, y 0, "
                           "between two waypoints; keep the path over the scene."));
  }
  SECTION("too many")
  {
    follow.Filter->SetSpacing(1e-6);
    CHECK(follow.FailsWith(
      "Spacing 1e-06 m results in 1e+08 waypoints; give one that results in fewer than 1e+07."));
  }
  SECTION("not finite")
  {
    follow.Waypoints->GetPoints()->SetPoint(1, std::nan(""), 0, 0);
    CHECK(follow.FailsWith("No ground for point 1 at x nan, y 0; its coordinates must be finite."));
    follow.Waypoints->GetPoints()->SetPoint(1, std::numeric_limits<double>::infinity(), 0, 0);
    follow.Waypoints->Modified();
    follow.Filter->SetSpacing(10);
    CHECK(follow.FailsWith("Spacing 10 m results in inf waypoints;"));
  }
  SECTION("an empty scene")
  {
    follow.Filter->SetInputData(1, vtkNew<vtkPolyData>());
    CHECK(follow.FailsWith("The scene on port 1 is empty: it has no ground"));
  }
  SECTION("a trajectory")
  {
    vtkNew<vtkDoubleArray> times;
    times->SetName(names::GpsTime);
    times->SetNumberOfTuples(2);
    follow.Waypoints->GetPointData()->AddArray(times);
    CHECK(
      follow.FailsWith("The input on port 0 is a trajectory, it has GpsTime; connect waypoints"));
  }
  SECTION("no waypoints: no output")
  {
    follow.Waypoints->Initialize();
    CHECK(follow.Run()->GetNumberOfPoints() == 0);
    CHECK(follow.Log->Errors.empty());
  }
}
