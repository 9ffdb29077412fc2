// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosSceneTesting.h"
#include "vtkHeliosSyntheticScene.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <set>
#include <sstream>

namespace
{
namespace names = vtkHeliosArrayNames;

/// A scene as triangles, checked for the guarantees of every scene.
helios::TriangleMesh Make(vtkHeliosSyntheticScene* source)
{
  source->Update();
  vtkPolyData* scene = source->GetOutput();
  helios::TriangleMesh mesh;
  REQUIRE(mesh.Set(scene).IsOk());
  CHECK(mesh.GetMemorySize() == 0); // double points, 32-bit cells
  CHECK(helios::GetSmallestArea(mesh) > 0.0);
  vtkIntArray* ids = helios::GetIds(scene, names::MaterialIds);
  REQUIRE(ids != nullptr);
  REQUIRE(ids->GetNumberOfValues() == mesh.GetNumberOfTriangles());
  CHECK(ids->GetValueRange()[0] >= 0);
  CHECK(ids->GetValueRange()[1] < static_cast<int>(helios::GetMaterials(scene).size()));
  return mesh;
}

std::set<int> GetClasses(vtkHeliosSyntheticScene* source)
{
  std::set<int> classes;
  for (const helios::Material& material : helios::GetMaterials(source->GetOutput()))
  {
    CHECK(material.Reflectance > 0.0);
    CHECK(material.Reflectance < 1.0);
    CHECK(material.IsGround == (material.Classification == 2));
    classes.insert(material.Classification);
  }
  return classes;
}

double GetBound(const helios::TriangleMesh& mesh, int index)
{
  double bounds[6];
  mesh.GetBounds(bounds);
  return bounds[index];
}

/// The material names of a scene.
std::set<std::string> GetMaterialNames(vtkPolyData* scene)
{
  std::set<std::string> used;
  const helios::MaterialTable table = helios::GetMaterials(scene);
  vtkIntArray* ids = helios::GetIds(scene, names::MaterialIds);
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
  {
    used.insert(table[static_cast<std::size_t>(ids->GetValue(i))].Name);
  }
  return used;
}

} // namespace

TEST_CASE("SyntheticScene: a plane", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetSize(8.0);
  source->SetResolution(4);
  source->SetOrigin(500000.5, 5500000.25, 100.125);
  const helios::TriangleMesh mesh = Make(source);
  CHECK(mesh.GetNumberOfTriangles() == 32);
  CHECK(mesh.GetNumberOfPoints() == 25);
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    CHECK(mesh.GetNormal(i)[2] == 1.0);
    CHECK(helios::GetArea(mesh, i) == 2.0);
    CHECK(mesh.GetCorner(i, 0)[2] == 100.125);
  }
  CHECK(GetBound(mesh, 0) == 500000.5 - 4.0);
  CHECK(GetBound(mesh, 3) == 5500000.25 + 4.0);
  CHECK(GetClasses(source) == std::set<int>{ 2 });
}

TEST_CASE("SyntheticScene: a step has its riser at x = 0", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToStep();
  source->SetSize(20.0);
  source->SetHeight(3.0);
  source->SetResolution(2);
  const helios::TriangleMesh mesh = Make(source);
  CHECK(mesh.GetNumberOfTriangles() == 3 * 2 * 2 * 2);
  double area[3] = { 0, 0, 0 };
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const helios::Vec3 normal = mesh.GetNormal(i);
    const double* c = mesh.GetCorner(i, 0);
    if (normal[0] == -1.0)
    {
      CHECK(c[0] == 0.0);
      area[2] += helios::GetArea(mesh, i);
    }
    else
    {
      REQUIRE(normal[2] == 1.0);
      CHECK((c[2] == 0.0 || c[2] == 3.0));
      area[c[2] == 3.0] += helios::GetArea(mesh, i);
    }
  }
  CHECK(area[0] == Approx(200.0));
  CHECK(area[1] == Approx(200.0));
  CHECK(area[2] == Approx(60.0));
}

TEST_CASE("SyntheticScene: all points of the sphere lie on it", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToSphere();
  source->SetSize(6.0);
  for (const int parts : { 1, 2, 17 })
  {
    source->SetResolution(parts);
    const helios::TriangleMesh mesh = Make(source);
    CHECK(mesh.GetNumberOfTriangles() == 20 * parts * parts);
    CHECK(mesh.GetNumberOfPoints() == 10 * parts * parts + 2); // Euler
    CHECK(helios::CountOpenEdges(mesh) == 0);
    double worst = 0.0;
    for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i)
    {
      worst = std::max(worst, std::abs(helios::Vec3(mesh.GetPoints() + 3 * i).Norm() - 3.0));
    }
    CHECK(worst < 2e-15);
    // An inscribed mesh has slightly less volume than the ball.
    const double ball = vtkMath::Pi() * 36.0;
    CHECK(helios::GetVolume(mesh) < ball);
    CHECK(helios::GetVolume(mesh) > ball * (1.0 - 0.6 / (parts * parts)));
  }
}

TEST_CASE("SyntheticScene: a pyramid has a third of the volume of its prism", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToPyramid();
  source->SetSize(6.0);
  source->SetHeight(4.0);
  for (const int parts : { 1, 3 })
  {
    source->SetResolution(parts);
    const helios::TriangleMesh mesh = Make(source);
    CHECK(mesh.GetNumberOfTriangles() == 6 * parts * parts);
    CHECK(helios::CountOpenEdges(mesh) == 0);
    CHECK(helios::GetVolume(mesh) == Approx(48.0).epsilon(1e-14));
    CHECK(GetBound(mesh, 5) == 4.0);
    CHECK(GetBound(mesh, 4) == 0.0);
  }
}

TEST_CASE("SyntheticScene: terrain equals its closed form", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToTerrain();
  source->SetSize(256.0);
  source->SetHeight(15.0);
  source->SetResolution(64);
  source->SetSeed(3);
  source->SetOrigin(4e5, 5e6, 300.0);
  const helios::TriangleMesh mesh = Make(source);
  CHECK(mesh.GetNumberOfTriangles() == 2 * 64 * 64);
  double worst = 0.0;
  for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    const double* p = mesh.GetPoints() + 3 * i;
    worst = std::max(worst, std::abs(p[2] - source->GetTerrainHeight(p[0], p[1])));
  }
  CHECK(worst < 1e-9);
  CHECK(GetBound(mesh, 4) > 300.0 - 7.5);
  CHECK(GetBound(mesh, 5) < 300.0 + 7.5);
  CHECK(GetBound(mesh, 5) - GetBound(mesh, 4) > 3.0); // hills exist
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    REQUIRE(mesh.GetNormal(i)[2] > 0.5);
  }
  const double here = source->GetTerrainHeight(4e5, 5e6);
  source->SetSeed(4);
  CHECK(source->GetTerrainHeight(4e5, 5e6) != here);
}

TEST_CASE("SyntheticScene: blocks are on the ground, the centre is free", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToBlocks();
  source->SetResolution(5);
  source->SetHeight(10.0);
  const helios::TriangleMesh mesh = Make(source);
  CHECK(mesh.GetNumberOfTriangles() == 2 * 25 + 12 * 24);
  CHECK(GetClasses(source) == std::set<int>({ 2, 6 }));
  CHECK(GetBound(mesh, 5) <= 10.0);
  CHECK(GetBound(mesh, 4) == Approx(-0.5));
  CHECK(GetBound(mesh, 1) == 50.0); // no block extends beyond the ground
  for (vtkIdType i = 50; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const double* p = mesh.GetCorner(i, 0);
    REQUIRE(std::max(std::abs(p[0]), std::abs(p[1])) > 10.0);
  }
  source->SetResolution(4); // the centre is a corner of four squares
  CHECK(Make(source).GetNumberOfTriangles() == 2 * 16 + 12 * 12);
}

TEST_CASE("SyntheticScene: a house is a closed surface", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToHouse();
  for (const double length : { 3.0, 8.0, 12.0, 30.0 })
  {
    source->SetSize(length);
    const helios::TriangleMesh mesh = Make(source);
    CHECK(helios::CountOpenEdges(mesh) == 0);
    CHECK(helios::GetVolume(mesh) > 0.0);
    CHECK(GetBound(mesh, 4) == 0.0);
    CHECK(GetBound(mesh, 5) == 8.7); // the chimney
    CHECK(GetBound(mesh, 3) == Approx(0.5 * length + 0.5));
    CHECK(GetClasses(source) == std::set<int>{ 6 });
  }
}

TEST_CASE(
  "SyntheticScene: a house has a door and windows deeper than its walls", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToHouse();
  source->SetSize(12.0);
  const helios::TriangleMesh mesh = Make(source);
  vtkPolyData* scene = source->GetOutput();
  CHECK(GetMaterialNames(scene) ==
    std::set<std::string>({ "brick", "plaster", "roof", "window", "wood" }));
  const helios::MaterialTable table = helios::GetMaterials(scene);
  vtkIntArray* ids = helios::GetIds(scene, names::MaterialIds);
  double doorArea = 0.0;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    if (table[static_cast<std::size_t>(ids->GetValue(i))].Name == "wood")
    {
      CHECK(mesh.GetNormal(i)[0] == Approx(1.0));
      CHECK(mesh.GetCorner(i, 0)[0] == Approx(0.5 * 0.65 * 12.0 - 0.15));
      doorArea += helios::GetArea(mesh, i);
    }
  }
  CHECK(doorArea == Approx(1.1 * 2.1));
}

TEST_CASE("SyntheticScene: a low house has no door and no windows", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToHouse();
  source->SetHeight(2.0);
  CHECK(helios::CountOpenEdges(Make(source)) == 0);
  CHECK(
    GetMaterialNames(source->GetOutput()) == std::set<std::string>({ "brick", "plaster", "roof" }));
}

TEST_CASE("SyntheticScene: trees fill their crown", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToTree();
  source->SetNumberOfLeaves(3000);
  struct
  {
    int Species;
    double Height;
    double Crown;
    double LeafAreaIndex;
    std::set<int> Classes;
  } const trees[] = { { vtkHeliosSyntheticScene::BROADLEAF, 14, 7, 3, { 5 } },
    { vtkHeliosSyntheticScene::CONIFER, 18, 6, 4, { 5 } },
    { vtkHeliosSyntheticScene::SHRUB, 1.6, 1.4, 3, { 3 } } };
  for (const auto& tree : trees)
  {
    source->SetSpecies(tree.Species);
    source->SetHeight(tree.Height);
    source->SetSize(tree.Crown);
    const helios::TriangleMesh mesh = Make(source);
    CHECK(GetClasses(source) == tree.Classes);
    CHECK(GetBound(mesh, 4) > -0.03 * tree.Height);
    CHECK(GetBound(mesh, 4) <= 0.0);
    CHECK(GetBound(mesh, 5) == Approx(tree.Height).epsilon(0.05));
    CHECK(GetBound(mesh, 1) == Approx(0.5 * tree.Crown).epsilon(0.2));
    double leafArea = 0.0;
    for (vtkIdType i = mesh.GetNumberOfTriangles() - 6000; i < mesh.GetNumberOfTriangles(); ++i)
    {
      leafArea += helios::GetArea(mesh, i);
    }
    const double ground = 0.25 * vtkMath::Pi() * tree.Crown * tree.Crown;
    CHECK(leafArea == Approx(tree.LeafAreaIndex * ground).epsilon(1e-6));
  }
}

TEST_CASE("SyntheticScene: the wood of trees is a closed surface", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToTree();
  source->SetNumberOfLeaves(1);
  for (const int species : { vtkHeliosSyntheticScene::BROADLEAF, vtkHeliosSyntheticScene::CONIFER,
         vtkHeliosSyntheticScene::SHRUB })
  {
    source->SetSpecies(species);
    const helios::TriangleMesh mesh = Make(source);
    CHECK(helios::CountOpenEdges(mesh) == 4); // triangles of the leaf
    CHECK(helios::GetVolume(mesh) > 0.0);
    CHECK(mesh.GetNumberOfTriangles() < 2000);
  }
}

TEST_CASE("SyntheticScene: a canopy of a million triangles", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  source->SetKindToCanopy();
  const helios::TriangleMesh mesh = Make(source);
  CHECK(mesh.GetNumberOfTriangles() == Approx(1e6).epsilon(0.02));
  CHECK(GetClasses(source) == std::set<int>({ 2, 5 }));
  CHECK(GetBound(mesh, 5) > 10.0);
  CHECK(GetBound(mesh, 5) < 15.0 * 1.05 + 3.0);
  const double* p = mesh.GetPoints();
  CHECK(p[2] == source->GetTerrainHeight(p[0], p[1]));
}

TEST_CASE("SyntheticScene: the same seed gives the same scene", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> a;
  vtkNew<vtkHeliosSyntheticScene> b;
  for (vtkHeliosSyntheticScene* source : { a.Get(), b.Get() })
  {
    source->SetKindToCanopy();
    source->SetNumberOfTrees(7);
    source->SetNumberOfLeaves(100);
    source->SetResolution(10);
    source->SetSeed(42);
  }
  const helios::TriangleMesh first = Make(a);
  const helios::TriangleMesh second = Make(b);
  REQUIRE(first.GetNumberOfPoints() == second.GetNumberOfPoints());
  const std::size_t bytes =
    3 * sizeof(double) * static_cast<std::size_t>(first.GetNumberOfPoints());
  CHECK(std::memcmp(first.GetPoints(), second.GetPoints(), bytes) == 0);
  b->SetSeed(43);
  const helios::TriangleMesh other = Make(b);
  const bool isSame = other.GetNumberOfPoints() == first.GetNumberOfPoints() &&
    std::memcmp(first.GetPoints(), other.GetPoints(), bytes) == 0;
  CHECK_FALSE(isSame);
}

TEST_CASE("SyntheticScene: bad properties are errors", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(source);
  source->SetOrigin(0, std::nan(""), 0);
  source->Update();
  CHECK(log->HasError("Size, Height or Origin is nan; set finite numbers"));

  log->Clear();
  source->SetOrigin(0, 0, 0);
  source->SetKindToSphere();
  source->SetResolution(10000);
  source->Update();
  CHECK(log->HasError("Resolution 10000"));
  CHECK(log->HasError("make about 2e+09 triangles, more than 5e+08; lower them"));
  CHECK(source->GetOutput()->GetNumberOfCells() == 0);
}

TEST_CASE("SyntheticScene: prints its kind", "[SyntheticScene]")
{
  vtkNew<vtkHeliosSyntheticScene> source;
  CHECK(std::string(source->GetKindAsString()) == "Plane");
  source->SetKindToTree();
  source->SetSpeciesToConifer();
  CHECK(std::string(source->GetKindAsString()) == "Tree");
  std::ostringstream text;
  source->Print(text);
  CHECK_THAT(text.str(), Catch::Contains("Species: Conifer"));
}
