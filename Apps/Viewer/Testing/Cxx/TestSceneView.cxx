// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMaterialColors.h"
#include "heliosSceneView.h"
#include "heliosViewerTest.h"

#include <catch2/catch.hpp>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkStringArray.h>

#include <cmath>
#include <cstdlib>

using namespace helios;
using namespace helios::viewer;
namespace names = vtkHeliosArrayNames;

namespace
{

const Vec3 Far(500000.0, 5400000.0, 300.0);

/// Two squares of 4 m: material 0, part 0 around x = -4; material 1, part 1 around x = 4, 2 m up.
vtkSmartPointer<vtkPolyData> MakeScene(const Vec3& origin)
{
  std::vector<Vec3> corners;
  for (const double x : { -4.0, 4.0 })
  {
    for (const Vec3& c : { Vec3(-2, -2, 0), Vec3(2, -2, 0), Vec3(2, 2, 0), Vec3(-2, 2, 0) })
    {
      corners.push_back(origin + c + Vec3(x, 0.0, x > 0.0 ? 2.0 : 0.0));
    }
  }
  auto scene = MakeEchoes(corners);
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> materials, parts;
  materials->SetName(names::MaterialIds);
  parts->SetName(names::PartIds);
  for (int square = 0; square < 2; ++square)
  {
    for (int half = 0; half < 2; ++half)
    {
      cells->InsertNextCell({ 4 * square, 4 * square + 1 + half, 4 * square + 2 + half });
      materials->InsertNextValue(square);
      parts->InsertNextValue(square);
    }
  }
  scene->SetPolys(cells);
  scene->GetCellData()->AddArray(materials);
  scene->GetCellData()->AddArray(parts);
  MaterialTable table(2);
  table[0].Name = "old_asphalt";
  table[1].Name = "x";
  table[1].Classification = 6;
  SetMaterials(scene, table);
  vtkNew<vtkStringArray> partNames;
  partNames->SetName(names::PartName);
  partNames->InsertNextValue("street");
  partNames->InsertNextValue("house 7");
  scene->GetFieldData()->AddArray(partNames);
  return scene;
}

/// Makes squares of very many triangles.
vtkSmartPointer<vtkPolyData> MakeFine(const Vec3& origin, int side)
{
  std::vector<Vec3> corners;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIntArray> materials;
  materials->SetName(names::MaterialIds);
  for (int square = 0; square < 2; ++square)
  {
    const auto first = static_cast<vtkIdType>(corners.size());
    for (int i = 0; i < (side + 1) * (side + 1); ++i)
    {
      const Vec3 place(
        -2.0 + 4.0 * (i % (side + 1)) / side, -2.0 + 4.0 * (i / (side + 1)) / side, 2.0 * square);
      corners.push_back(origin + place + Vec3(square == 0 ? -4.0 : 4.0, 0.0, 0.0));
    }
    for (int i = 0; i < 2 * side * side; ++i)
    {
      const vtkIdType a = first + i / 2 / side * (side + 1) + i / 2 % side;
      const vtkIdType c = a + side + 2;
      i % 2 == 0 ? cells->InsertNextCell({ a, a + 1, c }) : cells->InsertNextCell({ a, c, c - 1 });
      materials->InsertNextValue(square);
    }
  }
  auto scene = MakeEchoes(corners);
  scene->SetPolys(cells);
  scene->GetCellData()->AddArray(materials);
  MaterialTable table(2);
  table[1].Classification = 6;
  SetMaterials(scene, table);
  return scene;
}

bool IsNear(const Rgb& a, const Rgb& b)
{
  return std::abs(a[0] - b[0]) <= 2 && std::abs(a[1] - b[1]) <= 2 && std::abs(a[2] - b[2]) <= 2;
}

} // namespace

TEST_CASE("SceneView: triangles are at their pixels in the colours of their materials")
{
  Stage stage;
  SceneView view(stage.Renderer);
  view.SetOrigin(Far);
  REQUIRE(view.SetScene(MakeScene(Far)).IsOk());
  stage.Render();
  const Rgb asphalt = { 104, 106, 112 };
  CHECK(IsNear(stage.GetColorAt(-4, 0), asphalt));
  CHECK(IsNear(stage.GetColorAt(4, 0), GetClassColor(6)));
  CHECK(stage.CountPixels(Black) == 200 * 200 - 2 * 40 * 40);
  CHECK(stage.GetColorAt(-1.9, 0) == Black);
  CHECK(stage.GetColorAt(0, 0) == Black);
  view.SetColoring(SceneView::Coloring::ByPart);
  stage.Render();
  CHECK(IsNear(stage.GetColorAt(-4, 0), GetDistinctColor(0)));
  CHECK(IsNear(stage.GetColorAt(4, 0), GetDistinctColor(1)));
  view.SetHighlightedPart(1);
  stage.Render();
  CHECK(IsNear(stage.GetColorAt(-4, 0), GetDistinctColor(0)));
  CHECK(IsNear(stage.GetColorAt(4, 0), Rgb{ 255, 205, 60 }));
  view.SetSmooth(true);
  stage.Render();
  CHECK(IsNear(stage.GetColorAt(4, 0), Rgb{ 255, 205, 60 }));
  view.SetHighlightedPart(-1);
  view.SetWireframe(true);
  stage.Render();
  CHECK(stage.GetColorAt(4, 1) == Black);
  CHECK(stage.CountPixels(Black) < 200 * 200 - 300);
  view.SetWireframe(false);
  view.SetOpacity(0.5);
  stage.Render();
  CHECK(std::abs(stage.GetColorAt(4, 1)[0] - GetDistinctColor(1)[0] / 2) <= 3);
  view.SetVisible(false);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
}

TEST_CASE("SceneView: a pick returns position, normal, part and material in double precision")
{
  Stage stage;
  SceneView view(stage.Renderer);
  view.SetOrigin(Far);
  REQUIRE(view.SetScene(MakeScene(Far)).IsOk());
  stage.Render();
  const auto pick = view.Pick(Stage::ToPixel(4.5), Stage::ToPixel(-1.0));
  REQUIRE(pick);
  const Vec3 place = pick->Position - Far;
  CHECK(std::abs(place[0] - 4.5) < 0.051); // a pixel is 0.1 m
  CHECK(std::abs(place[1] + 1.0) < 0.051);
  CHECK(std::abs(place[2] - 2.0) < 1e-6);
  CHECK(pick->Normal[2] == 1.0);
  CHECK(pick->Cell == 2);
  CHECK(pick->Part == 1);
  CHECK(pick->PartName == "house 7");
  CHECK(pick->Material == 1);
  CHECK(pick->MaterialName == "x");
  CHECK_FALSE(view.Pick(Stage::ToPixel(0.0), Stage::ToPixel(0.0)));
  double bounds[6];
  REQUIRE(view.GetBounds(bounds));
  CHECK(bounds[0] == Far[0] - 6.0);
  CHECK(view.GetPartName(5) == "5");
  view.SetVisible(false);
  CHECK_FALSE(view.Pick(Stage::ToPixel(4.5), Stage::ToPixel(-1.0)));
}

TEST_CASE("SceneView: moving parts are drawn and picked at their current position")
{
  Stage stage;
  SceneView view(stage.Renderer);
  view.SetOrigin(Far);
  REQUIRE(view.SetScene(MakeScene(Far)).IsOk());
  CHECK_FALSE(view.GetMovingMesh());
  view.SetMovingParts({ 1, 7 });
  REQUIRE(view.GetMovingMesh());
  CHECK(view.GetMovingMesh()->GetNumberOfPoints() == 4);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200 - 2 * 40 * 40); // unchanged
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(view.GetMovingMesh());
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const Vec3 p = Vec3(moved->GetPoint(i)) + Vec3(0.0, 6.0, 0.0);
    moved->GetPoints()->SetPoint(i, p.GetData());
  }
  view.Move(moved);
  stage.Render();
  CHECK(stage.GetColorAt(4, 0) == Black);
  CHECK(IsNear(stage.GetColorAt(4, 6), GetClassColor(6)));
  CHECK(IsNear(stage.GetColorAt(-4, 0), Rgb{ 104, 106, 112 })); // static part
  CHECK(stage.CountPixels(Black) == 200 * 200 - 2 * 40 * 40);
  CHECK_FALSE(view.Pick(Stage::ToPixel(4), Stage::ToPixel(0)));
  const auto pick = view.Pick(Stage::ToPixel(4.5), Stage::ToPixel(5.0));
  REQUIRE(pick);
  CHECK(pick->Part == 1);
  CHECK(pick->Cell == 2); // index in the whole scene
  CHECK(std::abs(pick->Position[2] - Far[2] - 2.0) < 1e-6);
  CHECK(view.Pick(Stage::ToPixel(-4), Stage::ToPixel(0))->Part == 0);
  view.SetHighlightedPart(1);
  view.SetSmooth(true);
  stage.Render();
  CHECK(IsNear(stage.GetColorAt(4, 6), Rgb{ 255, 205, 60 }));
  view.SetVisible(false);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
  REQUIRE(view.SetScene(MakeScene(Far)).IsOk());
  CHECK_FALSE(view.GetMovingMesh());
  view.Move(moved); // belongs to an earlier scene
  stage.Render();
  CHECK(IsNear(stage.GetColorAt(4, 0), Rgb{ 255, 205, 60 }));
  view.SetMovingParts({ 0, 1 }); // all are drawn
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200 - 2 * 40 * 40);
}

TEST_CASE("SceneView: a scene without arrays is shown in one colour")
{
  Stage stage;
  auto scene = MakeScene({ 0, 0, 0 });
  scene->GetCellData()->Initialize();
  scene->SetFieldData(vtkNew<vtkFieldData>());
  SceneView view(stage.Renderer);
  REQUIRE(view.SetScene(scene).IsOk());
  stage.Render();
  CHECK(IsNear(stage.GetColorAt(-4, 0), GetDistinctColor(0)));
  CHECK(stage.GetColorAt(-4, 0) == stage.GetColorAt(4, 0));
  CHECK(view.Pick(Stage::ToPixel(4), Stage::ToPixel(0))->Part == -1);
}

TEST_CASE("SceneView: errors are reported, and nothing is shown")
{
  Stage stage;
  SceneView view(stage.Renderer);
  REQUIRE(view.SetScene(MakeScene({ 0, 0, 0 })).IsOk());
  CHECK(view.SetScene(vtkNew<vtkPolyData>()).Message() ==
    "the scene has no triangles: it cannot be shown");
  CHECK_FALSE(view.IsVisible());
  auto quad = MakeEchoes({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } });
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2, 3 });
  quad->SetPolys(cells);
  CHECK(view.SetScene(quad).Message().find("the scene cannot be shown: ") == 0);
  CHECK(view.SetScene(nullptr).IsOk());
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
  double bounds[6];
  CHECK_FALSE(view.GetBounds(bounds));
}

TEST_CASE("SceneView: material colours by class, name, ground, or index")
{
  Material material;
  CHECK(GetMaterialColor(material, 3) == GetDistinctColor(3));
  material.IsGround = true;
  CHECK(GetMaterialColor(material, 3) == GetClassColor(2));
  material.Name = "Oak_LEAF";
  CHECK(GetMaterialColor(material, 3) == Rgb{ 84, 150, 76 });
  material.Classification = 9;
  CHECK(GetMaterialColor(material, 3) == GetClassColor(9));
}

TEST_CASE("SceneView: large meshes are simplified while the camera moves")
{
  Stage stage;
  SceneView view(stage.Renderer);
  view.SetOrigin(Far);
  REQUIRE(view.SetScene(MakeFine(Far, 240)).IsOk()); // 230,400 triangles
  const auto check = [&](bool isCoarse)
  {
    stage.Render();
    CHECK(view.IsCoarse() == isCoarse);
    CHECK(IsNear(stage.GetColorAt(4, 0), GetClassColor(6)));
    CHECK(stage.GetColorAt(-4, 0) != Black);
    CHECK_FALSE(IsNear(stage.GetColorAt(-4, 0), GetClassColor(6)));
    // The outline may move by half a cube, 12 m / 160.
    CHECK(std::abs(stage.CountPixels(Black) - (200 * 200 - 2 * 40 * 40)) <= (isCoarse ? 330 : 0));
  };
  check(false);
  view.SetInteracting(true);
  check(true);
  CHECK(view.Pick(140.5, 100.5)->Material == 1); // bounds of the original triangles
  view.SetVisible(false);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
  view.SetVisible(true);
  check(true);
  view.SetInteracting(false);
  check(false);
  view.SetInteracting(true);
  REQUIRE(view.SetScene(MakeScene(Far)).IsOk());
  stage.Render();
  CHECK_FALSE(view.IsCoarse()); // few are drawn unchanged
}
