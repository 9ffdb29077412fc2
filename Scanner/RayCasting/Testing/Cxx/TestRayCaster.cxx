// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRayCaster.h"

#include "heliosErrorObserver.h"
#include "heliosRayCastingScenes.h"
#include "vtkHeliosBvhRayCaster.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <sstream>

namespace
{

vtkSmartPointer<vtkPolyData> MakeWall(double x)
{
  helios::Soup soup;
  soup.AddTriangle({ x, -1, -1 }, { x, 1, -1 }, { x, 0, 2 });
  return soup.GetPolyData();
}

/// Counts the actual builds.
class CountingCaster : public vtkHeliosBvhRayCaster
{
public:
  static CountingCaster* New() { VTK_STANDARD_NEW_BODY(CountingCaster); }
  int Builds = 0;

protected:
  bool BuildAccelerator(const helios::TriangleMesh& mesh) override
  {
    this->Builds += mesh.GetNumberOfTriangles() > 0;
    return this->vtkHeliosBvhRayCaster::BuildAccelerator(mesh);
  }
};

vtkNew<vtkDoubleArray> MakeArray(int components, std::initializer_list<double> values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetNumberOfComponents(components);
  for (double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

} // namespace

TEST_CASE("RayCaster: builds again only after the scene was modified", "[RayCaster]")
{
  vtkNew<CountingCaster> caster;
  const auto scene = MakeWall(2);
  const std::vector<vtkHeliosRay> rays = { helios::MakeRay({ 0, 0, 0 }, { 1, 0, 0 }) };
  REQUIRE(caster->Build(scene));
  REQUIRE(caster->Build(scene));
  CHECK(caster->Builds == 1);
  CHECK(helios::Cast(caster, rays)[0].Range == 2);
  scene->GetPoints()->SetPoint(0, 5, -1, -1);
  scene->GetPoints()->SetPoint(1, 5, 1, -1);
  scene->GetPoints()->SetPoint(2, 5, 0, 2);
  scene->GetPoints()->Modified();
  REQUIRE(caster->Build(scene));
  CHECK(caster->Builds == 2);
  CHECK(helios::Cast(caster, rays)[0].Range == 5);
  REQUIRE(caster->Build(MakeWall(3)));
  CHECK(caster->Builds == 3);
  CHECK(helios::Cast(caster, rays)[0].Range == 3);
}

TEST_CASE("RayCaster: keeps its tree for another scene with the same triangles", "[RayCaster]")
{
  vtkNew<CountingCaster> caster;
  const auto scene = MakeWall(2);
  vtkNew<vtkPolyData> other;
  other->ShallowCopy(scene);
  vtkNew<vtkDoubleArray> colour;
  colour->SetName("Colour");
  other->GetFieldData()->AddArray(colour);
  REQUIRE(caster->Build(scene));
  REQUIRE(caster->Build(other));
  REQUIRE(caster->Build(scene));
  CHECK(caster->Builds == 1);
  scene->GetPoints()->SetPoint(0, 2, -1, -5);
  scene->GetPoints()->Modified();
  REQUIRE(caster->Build(other)); // has these points, too
  CHECK(caster->Builds == 2);
  vtkNew<vtkPoints> points;
  points->DeepCopy(scene->GetPoints());
  other->SetPoints(points);
  REQUIRE(caster->Build(scene)); // still has the points of the tree
  CHECK(caster->Builds == 2);
  REQUIRE(caster->Build(other));
  CHECK(caster->Builds == 3);
}

TEST_CASE("RayCaster: a failed build is an error, and nothing is hit", "[RayCaster]")
{
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkNew<vtkHeliosBvhRayCaster> caster;
  log->Watch(caster);
  const std::vector<vtkHeliosRay> rays = { helios::MakeRay({ 0, 0, 0 }, { 1, 0, 0 }) };
  CHECK(helios::Cast(caster, rays)[0].CellId == -1);
  REQUIRE(caster->Build(MakeWall(2)));

  CHECK_FALSE(caster->Build(nullptr));
  CHECK(log->HasError("the scene is empty"));
  CHECK(helios::Cast(caster, rays)[0].CellId == -1);

  log->Clear();
  CHECK_FALSE(caster->Build(vtkSmartPointer<vtkPolyData>::New()));
  CHECK(log->HasError("the scene is empty"));

  log->Clear();
  CHECK_FALSE(caster->Build(MakeWall(std::nan(""))));
  CHECK(log->HasError("cell 0 of the scene has a corner that is not finite"));

  log->Clear();
  const auto quads = MakeWall(2);
  quads->GetPolys()->InsertNextCell({ 0, 1, 2, 1 });
  CHECK_FALSE(caster->Build(quads));
  CHECK(log->HasError("vtkTriangleFilter"));

  log->Clear();
  CHECK(caster->Build(MakeWall(2)));
  CHECK(log->Errors.empty());
  CHECK(helios::Cast(caster, rays)[0].CellId == 0);
}

TEST_CASE("RayCaster: arrays of rays and hits", "[RayCaster]")
{
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkNew<vtkHeliosBvhRayCaster> caster;
  log->Watch(caster);
  const auto origins = MakeArray(3, { 0, 0, 0, 0, 0, 1 });
  const auto directions = MakeArray(3, { 2, 0, 0, -1, 0, 0 });
  vtkNew<vtkDoubleArray> ranges;
  vtkNew<vtkIdTypeArray> cells;
  CHECK_FALSE(caster->Intersect(origins, directions, ranges, cells));
  CHECK(log->HasError("call Build first"));

  REQUIRE(caster->Build(MakeWall(3)));
  const auto scene = MakeWall(3);
  REQUIRE(caster->Build(scene));
  REQUIRE(caster->Intersect(origins, directions, ranges, cells));
  REQUIRE(ranges->GetNumberOfValues() == 2);
  REQUIRE(cells->GetNumberOfValues() == 2);
  CHECK(ranges->GetValue(0) == 1.5);
  CHECK(cells->GetValue(0) == 0);
  CHECK(ranges->GetValue(1) == helios::NoHit);
  CHECK(cells->GetValue(1) == -1);

  log->Clear();
  CHECK_FALSE(caster->Intersect(origins, MakeArray(3, { 1, 0, 0 }), ranges, cells));
  CHECK(log->HasError("origins (2 x 3) and directions (1 x 3)"));
  log->Clear();
  CHECK_FALSE(caster->Intersect(MakeArray(2, { 1, 0 }), MakeArray(3, { 1, 0, 0 }), ranges, cells));
  CHECK(log->HasError("origins (1 x 2)"));
  log->Clear();
  CHECK_FALSE(caster->Intersect(origins, nullptr, ranges, cells));
  CHECK(log->HasError("must all be arrays"));
}

TEST_CASE("RayCaster: prints its properties", "[RayCaster]")
{
  vtkNew<vtkHeliosBvhRayCaster> caster;
  REQUIRE(caster->Build(MakeWall(3)));
  std::ostringstream text;
  caster->Print(text);
  CHECK(text.str().find("Name: bvh") != std::string::npos);
  CHECK(text.str().find("NumberOfTriangles: 1") != std::string::npos);
}
