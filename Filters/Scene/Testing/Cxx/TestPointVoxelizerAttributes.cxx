// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Normals and colours of cells: sums, nearest points, planes.
#include "heliosVoxelTesting.h"

#include <catch2/catch.hpp>

#include <vtkFloatArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>

#include <cmath>
#include <random>

namespace names = vtkHeliosArrayNames;
using helios::MakeCloud;
using helios::Triples;
using helios::Vec3;
using helios::Voxelizing;

namespace
{

Vec3 GetTriple(vtkPolyData* scene, const char* name, vtkIdType triangle)
{
  vtkDataArray* array = scene->GetCellData()->GetArray(name);
  REQUIRE(array);
  REQUIRE(array->GetNumberOfTuples() == scene->GetNumberOfPolys());
  REQUIRE(array->GetNumberOfComponents() == 3);
  return Vec3(array->GetTuple3(triangle));
}

/// The angle between two unit vectors [rad].
double GetAngle(const Vec3& a, const Vec3& b)
{
  return std::atan2(a.Cross(b).Norm(), a.Dot(b));
}

/// Points of a plane through a cell of 1 m, noise in mm along its normal, in world coordinates.
Triples MakePlane(const Vec3& normal, double noise, const Vec3& centre)
{
  const Vec3 helper = std::abs(normal[0]) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  Vec3 u = normal.Cross(helper);
  u.Normalize();
  const Vec3 v = normal.Cross(u);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-0.28, 0.28);
  std::normal_distribution<double> gauss(0.0, 1.0);
  Triples points = { { centre[0] - 0.5, centre[1] - 0.5, centre[2] - 0.5 } }; // origin of the grid
  for (int i = 0; i < 2000; ++i)
  {
    const Vec3 p =
      centre + u * uniform(random) + v * uniform(random) + normal * (noise * gauss(random));
    points.push_back({ p[0], p[1], p[2] });
  }
  return points;
}

} // namespace

TEST_CASE(
  "PointVoxelizer: the normal of a voxel is the mean of its points", "[PointVoxelizerAttributes]")
{
  const Triples points = { { 0, 0, 0 }, { 0.5, 0, 0 }, { 0.7, 0, 0 }, { 2, 0, 0 } };
  const Triples normals = { { 3, 0, 0 }, { 0, 0.1, 0 }, { 0, 0, 0 }, { 0, 0, -1 } };
  Voxelizing cells(MakeCloud(points, normals), 1.0);
  REQUIRE(cells.Run());
  const double half = std::sqrt(0.5);
  CHECK((GetTriple(cells.Scene(), names::Normals, 0) - Vec3(half, half, 0)).Norm() < 1e-7);
  CHECK((GetTriple(cells.Scene(), names::Normals, 11) - Vec3(half, half, 0)).Norm() < 1e-7);
  CHECK(GetTriple(cells.Scene(), names::Normals, 12) == Vec3(0, 0, -1));
  CHECK(cells.Scene()->GetCellData()->GetNormals()); // so that transforms turn them
}

TEST_CASE(
  "PointVoxelizer: the normal of the point nearest to the centre", "[PointVoxelizerAttributes]")
{
  const Triples points = { { 0, 0, 0 }, { 0.5, 0.5, 0.4 }, { 0.5, 0.5, 0.8 }, { 0.5, 0.5, 0.5 } };
  const Triples normals = { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 1 }, { 0, 0, 0 } };
  Voxelizing cells(MakeCloud(points, normals), 1.0);
  cells.Filter->SnapNeighborNormalOn();
  REQUIRE(cells.Run());
  // mean of the points with a normal
  CHECK(GetTriple(cells.Scene(), names::Normals, 0) == Vec3(0, 1, 0));

  // For coincident points neither the first nor the last, but the same for any order.
  const Triples place = { { 0, 0, 0 }, { 0.5, 0.5, 0.5 }, { 0.5, 0.5, 0.5 } };
  for (const Triples& twins : { Triples{ { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 } },
         Triples{ { 0, 0, 1 }, { 0, 1, 0 }, { 1, 0, 0 } } })
  {
    cells.Filter->SetInputData(MakeCloud(place, twins));
    REQUIRE(cells.Run());
    CHECK(GetTriple(cells.Scene(), names::Normals, 0) == Vec3(0, 1, 0));
  }
}

TEST_CASE("PointVoxelizer: voxels without a normal use the default, or that of their faces",
  "[PointVoxelizerAttributes]")
{
  const Triples normals = { { 1, 0, 0 }, { -1, 0, 0 }, { std::nan(""), 0, 0 } };
  for (const bool snap : { false, true })
  {
    Voxelizing cells(MakeCloud({ { 0, 0, 0 }, { 0.5, 0, 0 }, { 3, 0, 0 } }, normals), 1.0);
    cells.Filter->SetSnapNeighborNormal(snap);
    REQUIRE(cells.Run());
    REQUIRE(cells.FaceCount() == 12); // none is dropped
    const Vec3 faces[] = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, -1, 0 }, { 0, 1, 0 }, { 0, 0, -1 },
      { 0, 0, 1 } };
    helios::TriangleMesh mesh;
    REQUIRE(mesh.Set(cells.Scene()).IsOk());
    for (int i = 0; i < 12; ++i)
    {
      CHECK(GetTriple(cells.Scene(), names::Normals, 12 + i) == faces[i / 2]);
      CHECK(mesh.GetNormal(12 + i) == faces[i / 2]);
    }
    cells.Filter->SetDefaultNormal(0, 0, 5);
    REQUIRE(cells.Run());
    CHECK(GetTriple(cells.Scene(), names::Normals, 13) == Vec3(0, 0, 1));
    CHECK((GetTriple(cells.Scene(), names::Normals, 0) == Vec3(0, 0, 1)) == !snap); // 1 - 1 = 0
  }
  Voxelizing bare(MakeCloud({ { 0, 0, 0 } }), 1.0);
  REQUIRE(bare.Run());
  CHECK(bare.Scene()->GetCellData()->GetArray(names::Normals) == nullptr);
  bare.Filter->SetDefaultNormal(0, -2, 0);
  REQUIRE(bare.Run());
  CHECK(GetTriple(bare.Scene(), names::Normals, 7) == Vec3(0, -1, 0));
}

TEST_CASE("PointVoxelizer: fitted planes", "[PointVoxelizerAttributes]")
{
  for (const Vec3& centre : { Vec3(0.5, 0.5, 0.5), Vec3(476000.5, 5473000.5, 110.5) })
  {
    for (Vec3 normal : { Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(1, 2, 3), Vec3(-1, 1, 0.001) })
    {
      normal.Normalize();
      Triples points = MakePlane(normal, 0.0, centre);
      points[0] = { centre[0] - 10.5, centre[1] - 10.5, centre[2] - 10.5 }; // in a cell of its own
      Voxelizing cells(MakeCloud(points), 1.0);
      cells.Filter->EstimateNormalsOn();
      REQUIRE(cells.Run());
      const Vec3 exact = GetTriple(cells.Scene(), names::Normals, 12);
      CHECK(GetAngle(exact, normal) < 3e-7); // float

      // Noise of 10 mm over 2000 points: sigma / (spread sqrt(n)) = 0.01 / (0.16 * 44.7).
      points = MakePlane(normal, 0.01, centre);
      points[0] = { centre[0] - 10.5, centre[1] - 10.5, centre[2] - 10.5 };
      cells.Filter->SetInputData(MakeCloud(points));
      REQUIRE(cells.Run());
      const double turn = GetAngle(GetTriple(cells.Scene(), names::Normals, 12), normal);
      const double angle = std::min(turn, std::acos(-1.0) - turn); // horizontal: either is up
      CHECK(angle < 4.0 * 0.01 / (0.16 * std::sqrt(2000.0)));
      CHECK(angle > 0.0);
    }
  }
}

TEST_CASE("PointVoxelizer: no plane for two points or a line", "[PointVoxelizerAttributes]")
{
  const double x = 476000.0;
  const Triples lone = { { x, 0, 0 } };
  const Triples two = { { x, 0, 0 }, { x + 0.3, 0.2, 0.1 } };
  const Triples same = { { x + 0.3, 0, 0 }, { x + 0.3, 0, 0 }, { x + 0.3, 0, 0 } };
  const Triples line = { { x, 0, 0 }, { x + 0.1, 0.2, 0.1 }, { x + 0.2, 0.4, 0.2 },
    { x + 0.4, 0.8, 0.4 } };
  for (const Triples& points : { lone, two, same, line })
  {
    Voxelizing cells(MakeCloud(points), 1.0);
    cells.Filter->EstimateNormalsOn();
    cells.Filter->SetDefaultNormal(0, 1, 0);
    REQUIRE(cells.Run());
    CHECK(GetTriple(cells.Scene(), names::Normals, 0) == Vec3(0, 1, 0));
  }
  // The points' own normals are then ignored.
  Voxelizing cells(MakeCloud(two, { { 1, 0, 0 }, { 1, 0, 0 } }), 1.0);
  cells.Filter->EstimateNormalsOn();
  cells.Filter->SetDefaultNormal(0, 1, 0);
  REQUIRE(cells.Run());
  CHECK(GetTriple(cells.Scene(), names::Normals, 0) == Vec3(0, 1, 0));
}

TEST_CASE(
  "PointVoxelizer: the colour of a voxel is the root mean square", "[PointVoxelizerAttributes]")
{
  const Triples points = { { 0, 0, 0 }, { 0.5, 0, 0 }, { 3, 0, 0 } };
  const Triples colors = { { 1.0, 0.0, 0.6 }, { 0.0, 0.0, 0.8 }, { 0.2, 0.4, 1.0 } };
  const Vec3 mean(std::sqrt(0.5), 0.0, std::sqrt(0.5));
  Voxelizing cells(MakeCloud(points, {}, colors), 1.0);
  REQUIRE(cells.Run());
  CHECK((GetTriple(cells.Scene(), names::RGB, 0) - mean).Norm() < 2e-5);
  CHECK((GetTriple(cells.Scene(), names::RGB, 12) - Vec3(0.2, 0.4, 1.0)).Norm() < 1e-7);

  vtkNew<vtkUnsignedCharArray> bytes;
  vtkNew<vtkUnsignedShortArray> shorts;
  for (const auto& [array, full] :
    { std::pair<vtkDataArray*, double>(bytes, 255.0), { shorts, 65535.0 } })
  {
    array->SetName(names::RGB);
    array->SetNumberOfComponents(3);
    for (const auto& color : colors)
    {
      array->InsertNextTuple3(
        std::round(full * color[0]), std::round(full * color[1]), std::round(full * color[2]));
    }
    auto cloud = MakeCloud(points);
    cloud->GetPointData()->AddArray(array);
    cells.Filter->SetInputData(cloud);
    REQUIRE(cells.Run());
    CHECK((GetTriple(cells.Scene(), names::RGB, 0) - mean).Norm() < 2e-5);
    CHECK((GetTriple(cells.Scene(), names::RGB, 12) - Vec3(0.2, 0.4, 1.0)).Norm() < 1e-7);
  }
}

TEST_CASE("PointVoxelizer: float coordinates are in the voxel of their decimals",
  "[PointVoxelizerAttributes]")
{
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  for (int i = 0; i < 1000; ++i)
  {
    coordinates->InsertNextTuple3(100.0f + static_cast<float>(i) / 10.0f, 0.0, 0.0);
  }
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  Voxelizing cells(cloud, 0.1);
  REQUIRE(cells.Run());
  CHECK(cells.Filter->GetNumberOfVoxels() == 1000); // one point per cell, no cell missing
  CHECK(cells.Scene()->GetPoints()->GetDataType() == VTK_DOUBLE);
}
