// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Edited scenes: the saved files have the same mesh.
#include "heliosSceneEdit.h"

#include "heliosEditDocument.h"
#include "heliosMessages.h"
#include "heliosSurveyEdit.h"
#include "heliosSurveyFiles.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosSurveySource.h"

#include <vtkBoundingBox.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using Catch::Contains;
using namespace helios;
using namespace helios::test;

namespace
{

const char* const Box = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nv 0 0 3\nv 2 0 3\nv 2 1 3\nv 0 1 3\n"
                        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// A floor, a box that is rotated, scaled and moved, and two files as parts without names.
struct Scene
{
  Files Folder;
  vtkNew<vtkHeliosSurvey> Owner;
  vtkSmartPointer<ErrorObserver> Heard = Observe(Owner);
  Messages Log{ Owner };
  SceneEdit Edit;

  Scene()
  {
    this->Folder.Write("parts/box.obj", Box);
    this->Folder.Write("parts/many/a.obj", Box);
    this->Folder.Write("parts/many/b.obj", Box);
    this->Folder.Write("parts/scene.xml", R"(<document><scene id="s"><part id="floor">
<filter type="objloader"><param type="string" key="filepath" value="../plane.obj"/></filter></part>
<part id="box"><filter type="translate"><param type="vec3" key="offset" value="4;5;0.5"/></filter>
<filter type="objloader"><param type="string" key="filepath" value="box.obj"/></filter>
<filter type="scale"><param type="double" key="scale" value="1.5"/></filter>
<filter type="rotate"><param type="rotation" key="rotation"><rot axis="x" angle_deg="20"/></param>
</filter></part><part><filter type="objloader">
<param type="string" key="efilepath" value="many/.*[.]obj"/></filter></part></scene></document>)");
    REQUIRE(this->Edit.Load(this->Folder / "parts/scene.xml#s", {}, this->Log));
  }

  /// The mesh of a saved scene, read by a survey.
  vtkSmartPointer<vtkPolyData> Read()
  {
    CHECK(this->Edit.Save(this->Folder / "new.xml").IsOk());
    this->Folder.Write("survey.xml",
      std::string("<document><survey name=\"n\" scene=\"new.xml#s\" ") + Tripod + ">" + OneLeg +
        "</survey></document>");
    const Reading reading(this->Folder);
    REQUIRE(reading.Good);
    CHECK(reading.Log->Warnings.empty());
    vtkNew<vtkHeliosSurveySource> source;
    source->SetSurvey(reading.Reader->GetSurvey());
    REQUIRE(source->Load());
    return source->GetScene();
  }
};

/// The bounds of a part.
std::array<double, 6> GetBounds(vtkPolyData* scene, int part)
{
  vtkDataArray* parts = scene->GetCellData()->GetArray(vtkHeliosArrayNames::PartIds);
  vtkBoundingBox box;
  for (vtkIdType cell = 0; cell < scene->GetNumberOfCells(); ++cell)
  {
    double b[6];
    scene->GetCellBounds(cell, b);
    static_cast<int>(parts->GetComponent(cell, 0)) == part ? box.AddBounds(b) : void();
  }
  std::array<double, 6> bounds;
  box.GetBounds(bounds.data());
  return bounds;
}

void CheckBounds(const std::array<double, 6>& a, const std::array<double, 6>& b)
{
  for (std::size_t i = 0; i < 6; ++i)
  {
    CHECK(a[i] == Approx(b[i]).margin(1e-9));
  }
}

} // namespace

TEST_CASE("SceneEdit: an unchanged scene is identical in another folder", "[SceneEdit]")
{
  Scene scene;
  CHECK(scene.Edit.GetNumberOfParts() == 4); // two of them were one part of two files
  CHECK(scene.Edit.GetPartName(1) == "box");
  CHECK(scene.Edit.GetPartName(3) == "3");
  CHECK(scene.Edit.FindPart("none") == -1);
  const auto mesh = scene.Read();
  CHECK(mesh->GetNumberOfCells() == 2 + 3 * 12);
  CheckBounds(GetBounds(mesh, 2), { 0.0, 2.0, 0.0, 1.0, 0.0, 3.0 });
  // scaled, rotated about x, moved: computed independently
  const double c = 1.5 * std::cos(vtkMath::RadiansFromDegrees(20.0));
  const double s = 1.5 * std::sin(vtkMath::RadiansFromDegrees(20.0));
  CheckBounds(GetBounds(mesh, 1), { 4.0, 7.0, 5.0 - 3.0 * s, 5.0 + c, 0.5, 0.5 + s + 3.0 * c });
}

TEST_CASE("SceneEdit: parts are moved, rotated and scaled about a point", "[SceneEdit]")
{
  Scene scene;
  const auto start = GetBounds(scene.Read(), 1);
  const Vec3 about(0.5 * (start[0] + start[1]), 0.5 * (start[2] + start[3]), start[4]);

  REQUIRE(scene.Edit.MovePart(1, { 1.0 / 3.0, -2.0, 0.25 }));
  auto b = GetBounds(scene.Read(), 1);
  CheckBounds(b,
    { start[0] + 1.0 / 3.0, start[1] + 1.0 / 3.0, start[2] - 2.0, start[3] - 2.0, start[4] + 0.25,
      start[5] + 0.25 });
  REQUIRE(scene.Edit.MovePart(1, { -1.0 / 3.0, 2.0, -0.25 }));

  REQUIRE(scene.Edit.ScalePart(1, 2.0, about));
  b = GetBounds(scene.Read(), 1);
  CheckBounds(b,
    { about[0] - (start[1] - start[0]), about[0] + (start[1] - start[0]),
      about[1] - (start[3] - start[2]), about[1] + (start[3] - start[2]), about[2],
      about[2] + 2.0 * (start[5] - start[4]) });
  REQUIRE(scene.Edit.ScalePart(1, 0.5, about));

  // Two rotations by 45 degrees exchange x and y.
  REQUIRE(scene.Edit.TurnPart(1, 45.0, about));
  REQUIRE(scene.Edit.TurnPart(1, 45.0, about));
  b = GetBounds(scene.Read(), 1);
  const double halfX = 0.5 * (start[1] - start[0]);
  const double halfY = 0.5 * (start[3] - start[2]);
  CheckBounds(b,
    { about[0] - halfY, about[0] + halfY, about[1] - halfX, about[1] + halfX, start[4], start[5] });
  CheckBounds(GetBounds(scene.Read(), 2), { 0.0, 2.0, 0.0, 1.0, 0.0, 3.0 }); // others are unchanged
}

TEST_CASE("SceneEdit: moves by parts of a metre do not grow digits", "[SceneEdit]")
{
  Scene scene;
  for (int i = 0; i < 3; ++i)
  {
    REQUIRE(scene.Edit.MovePart(1, { 0.1, -0.1, 0.7 }));
  }
  CHECK(scene.Edit.Save(scene.Folder / "new.xml").IsOk());
  CHECK_THAT(ReadText(scene.Folder / "new.xml"), Contains("value=\"4.3;4.7;2.6\""));
}

TEST_CASE("SceneEdit: parts are added and removed, and a text restores them", "[SceneEdit]")
{
  Scene scene;
  const std::string before = scene.Edit.GetText();
  REQUIRE(scene.Edit.AddPart(scene.Folder / "parts/box.obj", { 10.0, 20.0, 1.0 }, scene.Log) == 4);
  CHECK(scene.Edit.GetPartName(4) == "box_2");
  auto mesh = scene.Read();
  CheckBounds(GetBounds(mesh, 4), { 9.0, 11.0, 19.5, 20.5, 1.0, 4.0 });
  REQUIRE(scene.Edit.RemovePart(1));
  mesh = scene.Read();
  CHECK(mesh->GetNumberOfCells() == 2 + 3 * 12);
  CheckBounds(GetBounds(mesh, 3), { 9.0, 11.0, 19.5, 20.5, 1.0, 4.0 });
  scene.Edit.SetText(before);
  CHECK(scene.Edit.GetText() == before);
  CHECK(scene.Edit.GetNumberOfParts() == 4);
  while (scene.Edit.GetNumberOfParts() > 1)
  {
    REQUIRE(scene.Edit.RemovePart(0));
  }
  CHECK_FALSE(scene.Edit.RemovePart(0)); // the last one is kept
}

TEST_CASE("SceneEdit: changes of missing parts are errors", "[SceneEdit]")
{
  Scene scene;
  CHECK_FALSE(scene.Edit.MovePart(9, { 1.0, 0.0, 0.0 }));
  CHECK_FALSE(scene.Edit.TurnPart(-1, 1.0, { 1.0, 0.0, 0.0 }));
  CHECK_FALSE(scene.Edit.ScalePart(0, 0.0, { 1.0, 0.0, 0.0 }));
  CHECK(scene.Edit.AddPart(scene.Folder / "no.obj", { 0.0, 0.0, 0.0 }, scene.Log) == -1);
  CHECK_THAT(scene.Log.GetLastError(), Contains("no.obj"));
  SceneEdit other;
  CHECK_FALSE(other.Load(scene.Folder / "parts/scene.xml#none", {}, scene.Log));
  CHECK_THAT(scene.Log.GetLastError(), Contains("has no <scene> with the id \"none\""));
  CHECK_FALSE(other.IsLoaded());
}

TEST_CASE("SceneEdit: a mesh becomes a scene of a survey", "[SceneEdit]")
{
  Scene scene;
  SceneEdit edit;
  REQUIRE(edit.Load(scene.Folder / "plane.obj", {}, scene.Log));
  CHECK(edit.GetId() == "scene");
  REQUIRE(edit.AddPart(scene.Folder / "parts/box.obj", { 0.0, 0.0, 0.0 }, scene.Log) == 1);
  SurveyEdit survey;
  survey.SceneText = edit.GetText();
  survey.Platform = "assets.xml#tripod";
  survey.Scanner = "assets.xml#tls";
  survey.Settings.Scan.HeadRotateStop = 10.0;
  survey.Settings.Scan.HeadRotateSpeed = 10.0;
  survey.Settings.ScanFrequency = 50.0;
  AddLeg(survey, { 5.0, 5.0, 0.0 }, true);
  vtkNew<vtkHeliosSurvey> read;
  REQUIRE(ReadEdit(survey, scene.Folder / "x.xml", {}, read));
  const SurveyData& data = read->GetData();
  REQUIRE(data.Scene.Parts.size() == 2);
  CHECK(data.Scene.Parts[1].Translation == Vec3(-1.0, -0.5, 0.0));
}

TEST_CASE("SceneEdit: tables of parts are kept, with their files", "[SceneEdit]")
{
  Scene scene;
  scene.Folder.Write("parts/stand.csv", "model,x,y,id\nbox.obj,3,4,b1\nsmall,7,8,b2\n");
  scene.Folder.Replace("parts/scene.xml", "</scene>",
    R"(<partTable file="stand.csv"><model id="small"><filter type="objloader">
<param type="string" key="filepath" value="box.obj"/></filter><filter type="scale">
<param type="double" key="scale" value="0.5"/></filter></model></partTable><partTable>
<row model="box.obj" x="-9" y="0" z="5"/></partTable></scene>)");
  REQUIRE(scene.Edit.Load(scene.Folder / "parts/scene.xml#s", {}, scene.Log));
  CHECK(scene.Edit.GetNumberOfParts() == 4); // without the tables' parts
  CHECK_THAT(scene.Edit.GetText(), Contains(std::string(scene.Folder / "parts/stand.csv") + "\""));
  CHECK(scene.Edit.MovePart(1, { 1.0, 0.0, 0.0 }));
  const auto mesh = scene.Read();
  CHECK(GetBounds(mesh, 4) == std::array<double, 6>{ 3.0, 5.0, 4.0, 5.0, 0.0, 3.0 });
  CHECK(GetBounds(mesh, 5) == std::array<double, 6>{ 7.0, 8.0, 8.0, 8.5, 0.0, 1.5 });
  CHECK(GetBounds(mesh, 6) == std::array<double, 6>{ -9.0, -7.0, 0.0, 1.0, 5.0, 8.0 });
  const auto built = scene.Edit.Build(scene.Log); // with instances
  REQUIRE(vtkHeliosScene::SafeDownCast(built));
  CHECK(vtkHeliosScene::SafeDownCast(built)->GetNumberOfTriangles() == mesh->GetNumberOfPolys());
}
