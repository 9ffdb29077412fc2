// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTriangleMesh.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <limits>

namespace
{

vtkSmartPointer<vtkPolyData> MakeTriangle(int precision, bool narrow, double x = 0.0)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(precision);
  points->InsertNextPoint(x, 0, 0);
  points->InsertNextPoint(2, 0, 0);
  points->InsertNextPoint(0, 3, 0);
  vtkNew<vtkCellArray> polys;
  if (narrow)
  {
    polys->Use32BitStorage();
  }
  polys->InsertNextCell({ 0, 1, 2 });
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  scene->SetPoints(points);
  scene->SetPolys(polys);
  return scene;
}

} // namespace

TEST_CASE("TriangleMesh: shares double points and 32-bit cells", "[TriangleMesh]")
{
  helios::TriangleMesh mesh;
  const auto scene = MakeTriangle(VTK_DOUBLE, true);
  REQUIRE(mesh.Set(scene).IsOk());
  CHECK(mesh.GetMemorySize() == 0);
  CHECK(mesh.GetPoints() == scene->GetPoints()->GetVoidPointer(0));
  CHECK(mesh.GetNumberOfTriangles() == 1);
}

TEST_CASE("TriangleMesh: copies other storage types", "[TriangleMesh]")
{
  helios::TriangleMesh mesh;
  REQUIRE(mesh.Set(MakeTriangle(VTK_FLOAT, false)).IsOk());
  CHECK(mesh.GetMemorySize() > 0);
  CHECK(mesh.GetCorner(0, 1)[0] == 2.0);
  const helios::Vec3 normal = mesh.GetNormal(0);
  CHECK(normal[2] == 1.0);
  double bounds[6];
  mesh.GetBounds(bounds);
  CHECK(bounds[3] == 3.0);
}

TEST_CASE("TriangleMesh: bad input is an error", "[TriangleMesh]")
{
  helios::TriangleMesh mesh;
  CHECK(mesh.Set(nullptr).Message().find("empty") != std::string::npos);

  vtkNew<vtkPolyData> empty;
  CHECK(mesh.Set(empty).Message().find("empty") != std::string::npos);

  const double inf = std::numeric_limits<double>::infinity();
  CHECK(
    mesh.Set(MakeTriangle(VTK_DOUBLE, true, inf)).Message().find("cell 0") != std::string::npos);

  const auto dangling = MakeTriangle(VTK_DOUBLE, true);
  dangling->GetPolys()->InsertNextCell({ 0, 1, 7 });
  CHECK(mesh.Set(dangling).Message().find("refers to point 7, but it has 3") != std::string::npos);

  const auto quads = MakeTriangle(VTK_DOUBLE, true);
  quads->GetPolys()->InsertNextCell({ 0, 1, 2, 1 });
  CHECK(mesh.Set(quads).Message().find("vtkTriangleFilter") != std::string::npos);
}

TEST_CASE("TriangleMesh: of many bad corners the first is named", "[TriangleMesh]")
{
  const auto scene = MakeTriangle(VTK_DOUBLE, true);
  for (int i = 1; i < 400000; ++i)
  {
    const bool isBad = i == 399000 || i == 250000 || i == 250001;
    scene->GetPolys()->InsertNextCell({ 0, 1, isBad ? 3 + i % 10 : 2 });
  }
  helios::TriangleMesh mesh;
  CHECK(mesh.Set(scene).Message().find("cell 250000 of the scene refers to point 3,") == 0);
}
