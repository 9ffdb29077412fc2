// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "vtkHeliosTriangulate.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangle.h>

#include <catch2/catch.hpp>

#include <array>
#include <vector>

namespace
{

using Ids = std::vector<vtkIdType>;

/// Makes a mesh whose points are a grid of 5 x 5, and whose cells are numbered.
vtkSmartPointer<vtkPolyData> MakeMesh(int type, const std::vector<Ids>& polygons,
  const std::vector<Ids>& strips = {}, bool withLine = false)
{
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  for (int i = 0; i < 25; ++i)
  {
    points->InsertNextPoint(i % 5, i / 5, 0.0); // NOLINT(bugprone-integer-division)
  }
  mesh->SetPoints(points);
  vtkNew<vtkCellArray> polys;
  vtkNew<vtkCellArray> bands;
  vtkNew<vtkCellArray> lines;
  for (const Ids& each : polygons)
  {
    polys->InsertNextCell(static_cast<vtkIdType>(each.size()), each.data());
  }
  for (const Ids& each : strips)
  {
    bands->InsertNextCell(static_cast<vtkIdType>(each.size()), each.data());
  }
  if (withLine)
  {
    lines->InsertNextCell({ 0, 1 });
  }
  mesh->SetPolys(polys);
  mesh->SetStrips(bands);
  mesh->SetLines(lines);
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (int i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    numbers->InsertNextValue(i);
  }
  mesh->GetCellData()->AddArray(numbers);
  vtkNew<vtkIntArray> field;
  field->SetName("Field");
  mesh->GetFieldData()->AddArray(field);
  return mesh;
}

/// The area of the triangles of each cell, negative where they face down.
std::vector<double> ComputeAreas(vtkPolyData* mesh, std::size_t cells)
{
  std::vector<double> areas(cells);
  vtkNew<vtkIdList> ids;
  auto* numbers = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray("Number"));
  REQUIRE(numbers);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPolys(); ++i)
  {
    mesh->GetCellPoints(i, ids);
    REQUIRE(ids->GetNumberOfIds() == 3);
    std::array<std::array<double, 3>, 3> p{};
    double normal[3];
    for (std::size_t k = 0; k < 3; ++k)
    {
      mesh->GetPoint(ids->GetId(static_cast<vtkIdType>(k)), p[k].data());
    }
    vtkTriangle::ComputeNormal(p[0].data(), p[1].data(), p[2].data(), normal);
    areas.at(static_cast<std::size_t>(numbers->GetValue(i))) +=
      normal[2] * vtkTriangle::TriangleArea(p[0].data(), p[1].data(), p[2].data());
  }
  return areas;
}

} // namespace

TEST_CASE("Triangulate: polygons of every kind keep area, side and data", "[Triangulate]")
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_INT })
  {
    const auto mesh = MakeMesh(type,
      { { 0, 1, 6 }, { 0, 4, 9, 6, 21, 20 }, { 20, 21, 6, 9, 4, 0 },
        { 0, 4, 24, 20, 0, 6, 16, 18, 8, 6 }, { 0, 1, 6, 12, 13, 18, 12, 11, 6, 5 }, { 0, 1, 2 },
        { 0, 1, 2, 3 }, { 0, 0, 1, 6, 6, 5 } },
      { { 0, 5, 1, 6, 2 } }, true);
    vtkNew<vtkHeliosTriangulate> filter;
    filter->SetInputData(mesh);
    filter->Update();
    vtkPolyData* made = filter->GetOutput();
    CHECK(made->GetPoints() == mesh->GetPoints());
    CHECK(made->GetFieldData()->HasArray("Field"));
    CHECK(made->GetNumberOfCells() == made->GetNumberOfPolys());
    const std::vector<double> expected = { 0.0, 0.5, 7.0, -7.0, 12.0, 2.0, 0.0, 0.0, 1.0, -1.5 };
    const std::vector<double> areas = ComputeAreas(made, expected.size());
    for (std::size_t i = 0; i < areas.size(); ++i)
    {
      INFO("cell " << i);
      CHECK(areas[i] == Approx(expected[i]).margin(1e-12));
    }
    CHECK(filter->GetNumberOfCrossedPolygons() == 0);
  }
}

TEST_CASE("Triangulate: a mesh of triangles passes by reference", "[Triangulate]")
{
  const auto mesh = MakeMesh(VTK_DOUBLE, { { 0, 1, 6 }, { 0, 6, 5 } });
  vtkNew<vtkHeliosTriangulate> filter;
  filter->SetInputData(mesh);
  filter->Update();
  CHECK(filter->GetOutput()->GetPolys() == mesh->GetPolys());
  vtkNew<vtkPolyData> empty;
  filter->SetInputData(empty);
  filter->Update();
  CHECK(filter->GetOutput()->GetNumberOfCells() == 0);
}

TEST_CASE("Triangulate: polygons that cross are counted", "[Triangulate]")
{
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkNew<vtkHeliosTriangulate> filter;
  log->Watch(filter);
  filter->SetInputData(
    MakeMesh(VTK_DOUBLE, { { 0, 4, 24, 20 }, { 0, 6, 1, 5 }, { 0, 18, 3, 15 } }));
  filter->Update();
  CHECK(log->HasWarning("The sides of polygon 1 cross, so its triangles may be wrong (2 such "
                        "polygons in this mesh); correct it"));
  CHECK(filter->GetNumberOfCrossedPolygons() == 2);
}
