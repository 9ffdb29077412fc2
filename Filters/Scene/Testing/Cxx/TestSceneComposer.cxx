// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosSceneTesting.h"
#include "vtkHeliosSceneComposer.h"
#include "vtkHeliosSyntheticScene.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkStringArray.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <utility>

namespace
{
namespace names = vtkHeliosArrayNames;

const helios::Material Grass = helios::MakeMaterial("grass", 0.4);
const helios::Material Wall = helios::MakeMaterial("wall", 0.7);

vtkSmartPointer<helios::ErrorObserver> Watch(vtkObject* object)
{
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(object);
  return log;
}

std::string GetText(vtkPolyData* scene, const char* name, vtkIdType row)
{
  auto* column = vtkStringArray::SafeDownCast(scene->GetFieldData()->GetAbstractArray(name));
  return column ? std::string(column->GetValue(row)) : "no array";
}

void SetCRS(vtkPolyData* part, const char* crs)
{
  vtkNew<vtkStringArray> column;
  column->SetName(names::CRS);
  column->InsertNextValue(crs);
  part->GetFieldData()->AddArray(column);
}

} // namespace

TEST_CASE("SceneComposer: joins parts and merges equal materials", "[SceneComposer]")
{
  vtkNew<vtkHeliosSceneComposer> composer;
  composer->AddInputData(helios::MakeTriangle(0.0, { Grass, Wall }));
  composer->AddInputData(helios::MakeTriangle(500000.123456, { Wall, Grass }, false));
  composer->AddInputData(helios::MakeTriangle(7.0, { helios::MakeMaterial("wall", 0.71) }));
  composer->SetPartName(1, "house 7");
  composer->Update();
  vtkPolyData* scene = composer->GetOutput();

  helios::TriangleMesh mesh;
  REQUIRE(mesh.Set(scene).IsOk());
  CHECK(mesh.GetMemorySize() == 0); // double points, 32-bit cells
  REQUIRE(mesh.GetNumberOfTriangles() == 3);
  CHECK(mesh.GetCorner(1, 0)[0] == 500000.123456);
  CHECK(mesh.GetCorner(2, 1)[0] == 8.0);

  const helios::MaterialTable table = helios::GetMaterials(scene);
  REQUIRE(table.size() == 3); // the two walls differ
  const int expected[3] = { 0, 1, 2 };
  for (int i = 0; i < 3; ++i)
  {
    CHECK(helios::GetIds(scene, names::MaterialIds)->GetValue(i) == expected[i]);
    CHECK(helios::GetIds(scene, names::PartIds)->GetValue(i) == i);
  }
  CHECK(table[0] == Grass);
  CHECK(table[1] == Wall);
  CHECK(table[2].Reflectance == 0.71);
  CHECK(GetText(scene, names::PartName, 0) == "0");
  CHECK(GetText(scene, names::PartName, 1) == "house 7");
  CHECK(GetText(scene, names::PartName, 2) == "2");
}

TEST_CASE("SceneComposer: accepts points and ids of other types", "[SceneComposer]")
{
  const auto part = helios::MakeTriangle(3.0, { Grass, Wall }, false, VTK_FLOAT);
  part->GetCellData()->RemoveArray(names::MaterialIds);
  vtkNew<vtkShortArray> ids;
  ids->SetName(names::MaterialIds);
  ids->InsertNextValue(1);
  part->GetCellData()->AddArray(ids);
  const auto bare = helios::MakeTriangle(4.0, { Grass });
  bare->GetCellData()->RemoveArray(names::MaterialIds);

  vtkNew<vtkHeliosSceneComposer> composer;
  composer->AddInputData(part);
  composer->AddInputData(bare);
  composer->Update();
  vtkPolyData* scene = composer->GetOutput();
  CHECK(scene->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(scene->GetPoint(4)[0] == 5.0);
  CHECK(helios::GetIds(scene, names::MaterialIds)->GetValue(0) == 1);
  CHECK(helios::GetIds(scene, names::MaterialIds)->GetValue(1) == 0);
}

TEST_CASE("SceneComposer: passes a single part by reference", "[SceneComposer]")
{
  const auto part = helios::MakeTriangle(0.0, { Grass, Wall });
  vtkNew<vtkHeliosSceneComposer> composer;
  composer->AddInputData(part);
  composer->Update();
  vtkPolyData* scene = composer->GetOutput();
  CHECK(scene->GetPoints() == part->GetPoints());
  CHECK(scene->GetPolys()->GetConnectivityArray() == part->GetPolys()->GetConnectivityArray());
  CHECK(helios::GetIds(scene, names::MaterialIds) == helios::GetIds(part, names::MaterialIds));
  CHECK(helios::GetMaterials(scene).size() == 2);
  CHECK(part->GetCellData()->GetArray(names::PartIds) == nullptr);
}

TEST_CASE("SceneComposer: equal materials of one part are merged", "[SceneComposer]")
{
  const auto part = helios::MakeTriangle(0.0, { Grass, Grass });
  helios::GetIds(part, names::MaterialIds)->SetValue(0, 1);
  vtkNew<vtkHeliosSceneComposer> composer;
  composer->AddInputData(part);
  composer->Update();
  CHECK(helios::GetMaterials(composer->GetOutput()).size() == 1);
  CHECK(helios::GetIds(composer->GetOutput(), names::MaterialIds)->GetValue(0) == 0);
}

TEST_CASE("SceneComposer: drops empty parts, ids are kept", "[SceneComposer]")
{
  vtkNew<vtkHeliosSceneComposer> composer;
  const auto log = Watch(composer);
  vtkNew<vtkPolyData> empty;
  composer->AddInputData(empty);
  composer->AddInputData(helios::MakeTriangle(0.0, { Grass }));
  composer->SetPartName(0, "pond");
  composer->Update();
  CHECK(log->HasWarning("Part 0 (pond) has no triangles"));
  CHECK(log->Errors.empty());
  CHECK(helios::GetIds(composer->GetOutput(), names::PartIds)->GetValue(0) == 1);
  CHECK(GetText(composer->GetOutput(), names::PartName, 0) == "pond");
}

TEST_CASE("SceneComposer: keeps the CRS", "[SceneComposer]")
{
  const auto part = helios::MakeTriangle(0.0, { Grass });
  SetCRS(part, "EPSG:25832");
  vtkNew<vtkHeliosSceneComposer> composer;
  composer->AddInputData(part);
  composer->AddInputData(helios::MakeTriangle(1.0, { Grass }));
  composer->Update();
  CHECK(GetText(composer->GetOutput(), names::CRS, 0) == "EPSG:25832");

  const auto other = helios::MakeTriangle(2.0, { Grass });
  SetCRS(other, "EPSG:32632");
  composer->AddInputData(other);
  const auto log = Watch(composer);
  composer->Update();
  CHECK(log->HasError("Part 2 has the CRS EPSG:32632 (WGS 84 / UTM zone 32N), but earlier parts "
                      "have EPSG:25832 (ETRS89 / UTM zone 32N); reproject one of them: "
                      "vtkHeliosReproject, or <filter type=\"crs\"> with target EPSG:25832"));
  CHECK(composer->GetOutput()->GetNumberOfCells() == 0);
}

TEST_CASE("SceneComposer: one CRS in several notations", "[SceneComposer]")
{
  vtkNew<vtkHeliosSceneComposer> composer;
  const auto log = Watch(composer);
  composer->AddInputData(helios::MakeTriangle(0.0, { Grass }));
  for (const char* crs : { "EPSG:32632", "+proj=utm +zone=32 +datum=WGS84", "epsg:32632" })
  {
    const auto part = helios::MakeTriangle(1.0, { Grass });
    SetCRS(part, crs);
    composer->AddInputData(part);
  }
  composer->Update();
  CHECK(log->Errors.empty());
  CHECK(GetText(composer->GetOutput(), names::CRS, 0) == "EPSG:32632");

  const auto part = helios::MakeTriangle(2.0, { Grass });
  SetCRS(part, "nonsense");
  composer->AddInputData(part);
  composer->Update();
  CHECK(log->HasError("Part 4 has the CRS nonsense, but earlier parts have EPSG:32632: "
                      "\"nonsense\" is not a coordinate system known to PROJ"));
}

TEST_CASE("SceneComposer: bad input is an error", "[SceneComposer]")
{
  vtkNew<vtkHeliosSceneComposer> composer;
  const auto log = Watch(composer);
  composer->Update();
  CHECK(log->HasError("The scene is empty: none of its 0 parts has triangles"));

  log->Clear();
  vtkNew<vtkPolyData> empty;
  composer->AddInputData(empty);
  composer->Update();
  CHECK(log->HasError("The scene is empty: none of its 1 parts"));

  log->Clear();
  const auto quads = helios::MakeTriangle(0.0, { Grass });
  quads->GetPolys()->InsertNextCell({ 0, 1, 2, 1 });
  composer->AddInputData(quads);
  composer->Update();
  CHECK(
    log->HasError("Part 1 has cells that are not triangles; pass it through vtkTriangleFilter"));

  log->Clear();
  composer->RemoveAllInputs();
  for (const int id : { -1, 1 })
  {
    const auto part = helios::MakeTriangle(0.0, { Grass });
    helios::GetIds(part, names::MaterialIds)->SetValue(0, id);
    composer->SetInputData(part);
    composer->Update();
    CHECK(log->HasError("Part 0: triangle 0 has a material id that is not one of its 1 materials"));
    log->Clear();
  }

  composer->SetPartName(-1, "x");
  CHECK(log->HasError("Part -1 cannot have a name"));
}

TEST_CASE("SceneComposer: normals of parts that have them", "[SceneComposer]")
{
  const auto plain = helios::MakeTriangle(0.0, { Grass });
  const auto voxel = helios::MakeTriangle(1.0, { Grass });
  vtkNew<vtkDoubleArray> normals;
  normals->SetName(names::Normals);
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(0.6, 0.0, 0.8);
  voxel->GetCellData()->SetNormals(normals);
  vtkNew<vtkHeliosSceneComposer> composer;
  composer->AddInputData(plain);
  composer->Update();
  CHECK(composer->GetOutput()->GetCellData()->GetNormals() == nullptr);
  composer->AddInputData(voxel);
  composer->Update();
  vtkDataArray* joined = composer->GetOutput()->GetCellData()->GetArray(names::Normals);
  REQUIRE(joined);
  REQUIRE(joined->GetNumberOfTuples() == 2);
  CHECK(joined->GetComponent(0, 2) == 0.0);
  CHECK(joined->GetComponent(1, 0) == 0.6f);
  CHECK(joined->GetComponent(1, 2) == 0.8f);
}

TEST_CASE("SceneComposer: colours are passed if asked, NaN for parts without", "[SceneComposer]")
{
  const auto painted = helios::MakeTriangle(0.0, { Grass });
  for (const auto& [name, components] :
    { std::pair(names::TextureCoordinates, 6), std::pair(names::RGB, 3) })
  {
    vtkNew<vtkFloatArray> values;
    values->SetName(name);
    values->SetNumberOfComponents(components);
    values->SetNumberOfTuples(painted->GetNumberOfCells());
    values->Fill(0.5);
    painted->GetCellData()->AddArray(values);
  }
  vtkNew<vtkHeliosSceneComposer> composer;
  composer->AddInputData(helios::MakeTriangle(5.0, { Wall }));
  composer->AddInputData(painted);
  composer->Update();
  CHECK_FALSE(composer->GetOutput()->GetCellData()->HasArray(names::TextureCoordinates));
  CHECK_FALSE(composer->GetOutput()->GetCellData()->HasArray(names::RGB));

  composer->PassColorsOn();
  composer->Update();
  for (const char* name : { names::TextureCoordinates, names::RGB })
  {
    vtkDataArray* joined = composer->GetOutput()->GetCellData()->GetArray(name);
    REQUIRE(joined != nullptr);
    REQUIRE(joined->GetNumberOfTuples() == 2);
    CHECK(std::isnan(joined->GetComponent(0, 0)));
    CHECK(joined->GetComponent(1, 2) == 0.5);
  }
}

TEST_CASE("SceneComposer: a changed name is a modification", "[SceneComposer]")
{
  vtkNew<vtkHeliosSceneComposer> composer;
  const vtkMTimeType before = composer->GetMTime();
  composer->SetPartName(3, "barn");
  const vtkMTimeType after = composer->GetMTime();
  CHECK(after > before);
  composer->SetPartName(3, "barn");
  CHECK(composer->GetMTime() == after);
  CHECK(composer->GetPartName(3) == "barn");
  CHECK(composer->GetPartName(0) == "0");
  CHECK(composer->GetPartName(99) == "99");
  std::ostringstream text;
  composer->Print(text);
  CHECK_THAT(text.str(), Catch::Contains("PartNames: 4 given"));
}

TEST_CASE("SceneComposer: large parts keep every point and triangle", "[SceneComposer]")
{
  vtkNew<vtkHeliosSyntheticScene> ground;
  ground->SetKindToTerrain();
  ground->SetResolution(300);
  vtkNew<vtkHeliosSyntheticScene> tree;
  tree->SetKindToTree();
  vtkNew<vtkHeliosSceneComposer> composer;
  composer->AddInputConnection(ground->GetOutputPort());
  composer->AddInputConnection(tree->GetOutputPort());
  composer->Update();
  vtkPolyData* scene = composer->GetOutput();

  helios::TriangleMesh mesh;
  REQUIRE(mesh.Set(scene).IsOk());
  helios::TriangleMesh treeMesh;
  REQUIRE(treeMesh.Set(tree->GetOutput()).IsOk());
  REQUIRE(mesh.GetNumberOfTriangles() == 180000 + treeMesh.GetNumberOfTriangles());
  int different = 0;
  for (vtkIdType i = 0; i < treeMesh.GetNumberOfTriangles(); ++i)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const double* a = mesh.GetCorner(180000 + i, corner);
      const double* b = treeMesh.GetCorner(i, corner);
      different += a[0] != b[0] || a[1] != b[1] || a[2] != b[2];
    }
  }
  CHECK(different == 0);
}

TEST_CASE("SceneComposer: objects of parts that are split come after all parts", "[SceneComposer]")
{
  const auto makeCity = [](const std::vector<int>& ids, const std::vector<std::string>& objects)
  {
    auto city = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> polys;
    polys->Use32BitStorage();
    vtkNew<vtkIntArray> parts;
    parts->SetName(names::PartIds);
    for (const int id : ids)
    {
      const vtkIdType first = points->InsertNextPoint(id, 0, 0);
      points->InsertNextPoint(id + 1, 0, 0);
      points->InsertNextPoint(id, 1, 0);
      polys->InsertNextCell({ first, first + 1, first + 2 });
      parts->InsertNextValue(id);
    }
    vtkNew<vtkStringArray> given;
    given->SetName(names::PartName);
    for (const std::string& object : objects)
    {
      given->InsertNextValue(object);
    }
    city->SetPoints(points);
    city->SetPolys(polys);
    city->GetCellData()->AddArray(parts);
    city->GetFieldData()->AddArray(given);
    return city;
  };
  const auto ids = [](vtkPolyData* scene)
  {
    vtkIntArray* array = helios::GetIds(scene, names::PartIds);
    return std::vector<int>(array->GetPointer(0), array->GetPointer(array->GetNumberOfValues()));
  };
  vtkNew<vtkHeliosSceneComposer> composer;
  const auto log = Watch(composer);
  composer->AddInputData(makeCity({ 2, 0, 2 }, { "a", "bare", "c" }));
  composer->AddInputData(helios::MakeTriangle(7.0, { Wall }));
  composer->AddInputData(makeCity({ 0, 5 }, { "d" }));
  composer->SetPartName(0, "city");
  composer->SetPartIsSplit(0, true);
  composer->SetPartIsSplit(1, true); // has no objects
  composer->SetPartIsSplit(2, true);
  composer->Update();
  vtkPolyData* scene = composer->GetOutput();
  CHECK(ids(scene) == std::vector<int>{ 4, 3, 4, 1, 5, 6 });
  const char* expected[] = { "city", "1", "2", "a", "c", "d", "5" };
  for (int i = 0; i < 7; ++i)
  {
    CHECK(GetText(scene, names::PartName, i) == expected[i]);
  }
  composer->SetPartIsSplit(0, false);
  composer->SetPartIsSplit(2, false);
  composer->Update();
  CHECK(ids(composer->GetOutput()) == std::vector<int>{ 0, 0, 0, 1, 2, 2 });
  CHECK_FALSE(composer->GetPartIsSplit(0));
  CHECK(composer->GetPartIsSplit(1));

  composer->SetPartIsSplit(0, true);
  vtkNew<vtkPolyData> instances; // ids of the wall: parts 2 and 3, before the objects
  vtkNew<vtkPoints> places;
  places->InsertNextPoint(0, 0, 0);
  places->InsertNextPoint(9, 0, 0);
  vtkNew<vtkIntArray> prototypes;
  prototypes->SetName(names::PrototypeIds);
  prototypes->InsertNextValue(1);
  prototypes->InsertNextValue(1);
  instances->SetPoints(places);
  instances->GetPointData()->AddArray(prototypes);
  composer->SetInputData(1, instances);
  composer->Update();
  CHECK(ids(composer->GetOutput()) == std::vector<int>{ 5, 4, 5, 1, 1 });
  CHECK(GetText(composer->GetOutput(), names::PartName, 5) == "c");

  composer->SetPartIsSplit(-1, true);
  CHECK(log->HasError("Part -1 does not exist; parts are counted from 0"));
}
