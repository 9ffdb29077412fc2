// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Instances are drawn and picked as copies are.
#include "heliosFlatScene.h"
#include "heliosSceneView.h"
#include "heliosTestRasters.h"
#include "heliosViewerTest.h"
#include "vtkHeliosScene.h"

#include <catch2/catch.hpp>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkPNGWriter.h>
#include <vtkStringArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

using namespace helios;
using namespace helios::viewer;
namespace names = vtkHeliosArrayNames;

namespace
{

const Vec3 Far(500000.0, 5400000.0, 300.0);
constexpr int PartsBefore = 2; // triangles of the mesh

void AddIds(vtkDataSetAttributes* data, const char* name, const std::vector<int>& ids)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  for (const int id : ids)
  {
    array->InsertNextValue(id);
  }
  data->AddArray(array);
}

/// A ball of 2 n^2 triangles around a centre, of a material below and one above.
vtkSmartPointer<vtkPolyData> MakeBall(
  const Vec3& centre, double radius, int n, int below, int above)
{
  std::vector<Vec3> corners;
  vtkNew<vtkCellArray> cells;
  std::vector<int> materials;
  for (int i = 0; i <= n; ++i)
  {
    for (int k = 0; k <= n; ++k)
    {
      const double a = M_PI * i / n;
      const double b = 2.0 * M_PI * k / n;
      corners.push_back(centre +
        radius * Vec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), -1.6 * std::cos(a)));
    }
  }
  for (int i = 0; i < n * n; ++i)
  {
    const vtkIdType a = i / n * (n + 1) + i % n;
    cells->InsertNextCell({ a, a + 1, a + n + 2 });
    cells->InsertNextCell({ a, a + n + 2, a + n + 1 });
    materials.insert(materials.end(), 2, 2 * i < n * n ? below : above);
  }
  auto ball = MakeEchoes(corners);
  ball->SetPolys(cells);
  AddIds(ball->GetCellData(), names::MaterialIds, materials);
  return ball;
}

/// Two squares as the mesh of a scene.
void AddSquares(vtkPolyData* scene, const Vec3& origin)
{
  std::vector<Vec3> corners;
  vtkNew<vtkCellArray> cells;
  for (const double x : { -5.0, 5.0 })
  {
    const auto first = static_cast<vtkIdType>(corners.size());
    for (const Vec3& c : { Vec3(-4, -9, -3), Vec3(4, -9, -3), Vec3(4, 9, -3), Vec3(-4, 9, -3) })
    {
      corners.push_back(origin + c + Vec3(x, 0.0, 0.0));
    }
    cells->InsertNextCell({ first, first + 1, first + 2 });
    cells->InsertNextCell({ first, first + 2, first + 3 });
  }
  scene->SetPoints(MakeEchoes(corners)->GetPoints());
  scene->SetPolys(cells);
  AddIds(scene->GetCellData(), names::MaterialIds, { 0, 0, 1, 1 });
  AddIds(scene->GetCellData(), names::PartIds, { 0, 0, 1, 1 });
}

/// Balls at several places: turned, scaled, one of another material.
vtkSmartPointer<vtkPolyData> MakePlaces(const Vec3& origin, int side, double distance)
{
  std::vector<Vec3> places;
  std::vector<double> scales;
  std::vector<int> prototypes, materials, parts;
  vtkNew<vtkDoubleArray> orientations;
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  for (int i = 0; i < side * side; ++i)
  {
    places.push_back(origin +
      Vec3((i % side - 0.5 * (side - 1)) * distance, (i / side - 0.5 * (side - 1)) * distance,
        0.1 * (i % 5)));
    scales.push_back(0.7 + 0.1 * (i % 6));
    prototypes.push_back(i % 2);
    materials.push_back(i == 4 ? 3 : -1);
    parts.push_back(PartsBefore + i);
    const Quaternion q = AxisAngle({ 0.3, 1.0, 0.2 }, 37.0 * i);
    orientations->InsertNextTuple4(2.0 * q.GetW(), 2.0 * q.GetX(), 2.0 * q.GetY(), 2.0 * q.GetZ());
  }
  auto instances = MakeEchoes(places);
  AddColumn(instances, names::Scale, scales);
  AddIds(instances->GetPointData(), names::PrototypeIds, prototypes);
  AddIds(instances->GetPointData(), names::MaterialIds, materials);
  AddIds(instances->GetPointData(), names::PartIds, parts);
  instances->GetPointData()->AddArray(orientations);
  return instances;
}

/// Prototypes are off their origin; side * side instances on two squares.
vtkSmartPointer<vtkHeliosScene> MakeScene(
  const Vec3& origin, int side = 3, double distance = 6.0, int detail = 24, bool hasMesh = true)
{
  auto scene = vtkSmartPointer<vtkHeliosScene>::New();
  if (hasMesh)
  {
    AddSquares(scene, origin);
  }
  MaterialTable table(4);
  table[0].Name = "old_asphalt";
  table[1].Classification = 6;
  table[2].Classification = 5;
  table[3].Name = "x";
  SetMaterials(scene, table);
  scene->AddPrototype(MakeBall({ 0.3, -0.2, 0.5 }, 1.3, detail, 2, 1));
  scene->AddPrototype(MakeBall({ 0.0, 0.0, 0.0 }, 1.0, detail, 0, 2));
  scene->SetInstances(MakePlaces(origin, side, distance));
  vtkNew<vtkStringArray> partNames;
  partNames->SetName(names::PartName);
  for (int i = 0; i < PartsBefore + side * side; ++i)
  {
    partNames->InsertNextValue("part " + std::to_string(10 * i));
  }
  scene->GetFieldData()->AddArray(partNames);
  return scene;
}

vtkSmartPointer<vtkPolyData> MakeCopies(vtkHeliosScene* scene)
{
  auto flat = vtkSmartPointer<vtkPolyData>::New();
  REQUIRE(FlattenScene(scene, flat).IsOk());
  return flat;
}

/// Saves a test's picture for a look: HELIOS_PICTURES is a folder for them.
void SavePicture(Stage& stage, const std::string& name)
{
  if (const char* folder = std::getenv("HELIOS_PICTURES"))
  {
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(stage.Window);
    grab->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grab->GetOutputPort());
    writer->SetFileName((std::string(folder) + "/" + name + ".png").c_str());
    writer->Write();
  }
}

/// A view of a scene from above, or at a slant in perspective.
struct Shown
{
  Stage On;
  SceneView View{ On.Renderer };

  explicit Shown(vtkPolyData* scene, bool isSlanted = false)
  {
    this->View.SetOrigin(Far);
    REQUIRE(this->View.SetScene(scene).IsOk());
    vtkCamera* camera = this->On.Renderer->GetActiveCamera();
    if (isSlanted)
    {
      camera->ParallelProjectionOff();
      camera->SetPosition(12.0, -25.0, 18.0);
      camera->SetViewUp(0.0, 0.0, 1.0);
      camera->SetClippingRange(1.0, 100.0);
    }
  }
};

/// The pixels of which a colour differs by more than 3 of 255.
int CountDifferent(const Stage& a, const Stage& b)
{
  int count = 0;
  for (int i = 0; i < 200 * 200; ++i)
  {
    const Rgb p = a.GetPixel(i % 200, i / 200);
    const Rgb q = b.GetPixel(i % 200, i / 200);
    int most = 0;
    for (int k = 0; k < 3; ++k)
    {
      most = std::max(most, std::abs(p[k] - q[k]));
    }
    count += most > 3;
  }
  return count;
}

} // namespace

TEST_CASE("SceneView: instances look as copies")
{
  const bool isSlanted = GENERATE(false, true);
  const bool isSmooth = GENERATE(false, true);
  const auto scene = MakeScene(Far);
  Shown instances(scene, isSlanted);
  Shown copies(MakeCopies(scene), isSlanted);
  const auto compare = [&](const std::string& what)
  {
    INFO(what << ", slanted " << isSlanted << ", smooth " << isSmooth);
    instances.On.Render();
    copies.On.Render();
    SavePicture(instances.On, what + (isSlanted ? "_slanted" : "") + (isSmooth ? "_smooth" : ""));
    CHECK(copies.On.CountPixels(Black) < 30000);
    CHECK(CountDifferent(instances.On, copies.On) < 100); // outlines
  };
  for (Shown* shown : { &instances, &copies })
  {
    shown->View.SetSmooth(isSmooth);
  }
  compare("materials");
  for (Shown* shown : { &instances, &copies })
  {
    shown->View.SetColoring(SceneView::Coloring::ByPart);
    shown->View.SetHighlightedPart(PartsBefore + 2);
  }
  compare("parts");
  for (Shown* shown : { &instances, &copies })
  {
    shown->View.SetOpacity(0.5);
    shown->View.SetHighlightedPart(-1);
  }
  instances.On.Render();
  CHECK(CountDifferent(instances.On, copies.On) > 1000);
  CHECK(instances.View.GetInstanceTrianglesDrawn() == 9 * 2 * 24 * 24);
}

TEST_CASE("SceneView: instances are picked as copies")
{
  const auto scene = MakeScene(Far);
  vtkNew<vtkIdTypeArray> first; // half of the mesh follows the instances
  first->SetName(names::FirstCellIds);
  for (vtkIdType i = 0; i < 9; ++i)
  {
    first->InsertNextValue(2 + i * 2 * 24 * 24);
  }
  scene->GetInstances()->GetPointData()->AddArray(first);
  Shown instances(scene, true);
  Shown copies(MakeCopies(scene), true);
  instances.On.Render();
  copies.On.Render();
  CHECK(CountDifferent(instances.On, copies.On) < 100);
  int found = 0;
  for (int x = 5; x < 200; x += 10)
  {
    for (int y = 5; y < 200; y += 10)
    {
      const auto pick = instances.View.Pick(x, y);
      const auto truth = copies.View.Pick(x, y);
      REQUIRE(pick.has_value() == truth.has_value());
      if (pick)
      {
        CHECK(pick->Cell == truth->Cell);
        CHECK(pick->Part == truth->Part);
        CHECK(pick->PartName == truth->PartName);
        CHECK(pick->Material == truth->Material);
        CHECK(pick->MaterialName == truth->MaterialName);
        CHECK((pick->Position - truth->Position).Norm() == 0.0);
        CHECK((pick->Normal - truth->Normal).Norm() == 0.0);
        found += pick->Part >= PartsBefore;
      }
    }
  }
  CHECK(found > 20);
}

TEST_CASE("SceneView: a scene of instances alone, parts and bounds")
{
  const auto scene = MakeScene(Far, 3, 6.0, 24, false);
  const auto flat = MakeCopies(scene);
  Shown instances(scene);
  Shown copies(flat);
  instances.On.Render();
  copies.On.Render();
  CHECK(CountDifferent(instances.On, copies.On) < 100);
  double own[6], truth[6];
  REQUIRE(instances.View.GetBounds(own));
  REQUIRE(copies.View.GetBounds(truth));
  CHECK(std::equal(own, own + 6, truth));
  int part = -1;
  CHECK(instances.View.FindPart("part 50", part, own));
  CHECK(part == 5);
  CHECK(copies.View.FindPart("part 50", part, truth));
  CHECK(std::equal(own, own + 6, truth));
  CHECK_FALSE(instances.View.FindPart("part 51", part, own));
  CHECK(part == -1);
  CHECK(instances.View.GetPart(0) == PartsBefore);
  CHECK(instances.View.GetPart(9 * 2 * 24 * 24) == -1);
  CHECK(instances.View.SetScene(nullptr).IsOk());
  instances.On.Render();
  CHECK(instances.On.CountPixels(Black) == 200 * 200);
  CHECK(instances.View.GetPart(0) == -1);
}

namespace
{

/// A terrain of 0.1 m pixels as the only prototype, over two squares.
vtkSmartPointer<vtkHeliosScene> MakeTerrain(int side)
{
  const double size = 16.0 / side;
  HeightRaster raster(side, side, { -8.0, size, 0.0, 8.0, 0.0, -size });
  raster.AddHills(1.0, 0.0);
  auto scene = MakeScene(Far, 1);
  vtkPolyData* instances = scene->GetInstances();
  instances->GetPointData()->GetArray(names::PrototypeIds)->SetComponent(0, 0, 2);
  instances->GetPointData()->GetArray(names::MaterialIds)->SetComponent(0, 0, 3);
  scene->AddPrototype(raster.MakeImage<vtkFloatArray>());
  return scene;
}

} // namespace

TEST_CASE("SceneView: a raster of heights looks and is picked as its mesh")
{
  const bool isSmooth = GENERATE(false, true);
  const auto scene = MakeTerrain(120);
  Shown rasters(scene, true);
  Shown copies(MakeCopies(scene), true);
  for (Shown* shown : { &rasters, &copies })
  {
    shown->View.SetSmooth(isSmooth);
    shown->On.Render();
  }
  SavePicture(rasters.On, isSmooth ? "raster_smooth" : "raster");
  CHECK(CountDifferent(rasters.On, copies.On) < 100);
  const auto pick = rasters.View.Pick(100, 100);
  const auto truth = copies.View.Pick(100, 100);
  REQUIRE(pick);
  REQUIRE(truth);
  CHECK(pick->Cell == truth->Cell);
  CHECK(pick->Part == truth->Part);
  CHECK(pick->Material == truth->Material);
  CHECK((pick->Position - truth->Position).Norm() == 0.0);
}

TEST_CASE("SceneView: a large raster of heights is drawn with less detail")
{
  Shown shown(MakeTerrain(800), true); // 1.3 million triangles
  shown.On.Render();
  const Rgb before = shown.On.GetPixel(100, 100);
  CHECK(shown.View.GetInstanceTrianglesDrawn() == 2 * 799 * 799);
  const int seen = 200 * 200 - shown.On.CountPixels(Black);
  shown.View.SetInteracting(true);
  shown.On.Render();
  SavePicture(shown.On, "raster_moving");
  CHECK(shown.View.GetInstanceTrianglesDrawn() < 100000);
  CHECK(shown.View.GetInstanceTrianglesDrawn() > 1000);
  CHECK(std::abs(200 * 200 - shown.On.CountPixels(Black) - seen) < 0.03 * seen);
  CHECK(std::abs(shown.On.GetPixel(100, 100)[0] - before[0]) < 30);
}

TEST_CASE("SceneView: very many triangles of instances are drawn with less detail")
{
  const auto scene = MakeScene(Far, 30, 0.64, 160); // 46 million triangles
  Shown shown(scene);
  shown.On.Render();
  SavePicture(shown.On, "many");
  CHECK(shown.View.GetInstanceTrianglesDrawn() < 10000000);
  CHECK(shown.View.GetInstanceTrianglesDrawn() > 30000);
  const int seen = 200 * 200 - shown.On.CountPixels(Black);
  shown.View.SetInteracting(true);
  shown.On.Render();
  SavePicture(shown.On, "many_moving");
  CHECK(shown.View.GetInstanceTrianglesDrawn() <= 200000);
  CHECK(std::abs(200 * 200 - shown.On.CountPixels(Black) - seen) < 0.03 * seen);
  shown.View.SetInteracting(false);
  vtkCamera* camera = shown.On.Renderer->GetActiveCamera();
  camera->SetPosition(500.0, 0.0, 100.0); // beside the scene: nothing is in sight
  camera->SetFocalPoint(500.0, 0.0, 0.0);
  shown.On.Render();
  CHECK(shown.View.GetInstanceTrianglesDrawn() == 0);
  camera->SetPosition(0.0, 0.0, 100.0); // near a few: all their triangles
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetParallelScale(0.3);
  shown.On.Render();
  SavePicture(shown.On, "near");
  CHECK(shown.View.GetInstanceTrianglesDrawn() > 2 * 160 * 160);
}
