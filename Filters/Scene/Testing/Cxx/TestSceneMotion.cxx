// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSceneMotion.h"

#include "heliosErrorObserver.h"
#include "heliosPartMotion.h"
#include "heliosSceneTesting.h"
#include "vtkHeliosSceneComposer.h"

#include <vtkFloatArray.h>
#include <vtkInformation.h>

#include <catch2/catch.hpp>

#include <limits>
#include <sstream>

namespace
{

/// Triangles at x = 0, 10, 20: parts 0, 1, 2.
vtkSmartPointer<vtkPolyData> MakeScene()
{
  vtkNew<vtkHeliosSceneComposer> composer;
  for (const double x : { 0.0, 10.0, 20.0 })
  {
    composer->AddInputData(helios::MakeTriangle(x, { helios::Material() }));
  }
  composer->Update();
  auto scene = vtkSmartPointer<vtkPolyData>::New();
  scene->ShallowCopy(composer->GetOutput());
  return scene;
}

void CheckPoint(vtkPolyData* scene, vtkIdType point, double x, double y, double z)
{
  const helios::Vec3 p(scene->GetPoint(point));
  INFO(p[0] << " " << p[1] << " " << p[2]);
  CHECK((p - helios::Vec3(x, y, z)).Norm() < 1e-14);
}

/// A filter on a scene; part 1 rises.
struct Rising
{
  vtkSmartPointer<vtkPolyData> Scene = MakeScene();
  vtkNew<vtkHeliosSceneMotion> Filter;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  Rising()
  {
    const double up[3] = { 0, 0, 0.5 };
    this->Log->Watch(this->Filter);
    this->Filter->SetInputData(this->Scene);
    this->Filter->AddTranslation(1, up);
  }

  void CheckFails(const std::string& message)
  {
    this->Filter->Update();
    INFO(this->Log->Errors);
    CHECK(this->Log->HasError(message));
    CHECK(this->Filter->GetOutput()->GetNumberOfPoints() == 0);
  }
};

} // namespace

TEST_CASE("SceneMotion: parts move, others are unchanged", "[SceneMotion]")
{
  Rising rising;
  rising.Filter->Update();
  vtkPolyData* moved = rising.Filter->GetOutput();
  CHECK(moved->GetPoints() == rising.Scene->GetPoints()); // at step 0

  rising.Filter->SetStep(1, 3);
  CHECK(rising.Filter->GetStep(1) == 3);
  rising.Filter->Update();
  CheckPoint(moved, 0, 0, 0, 0);
  CheckPoint(moved, 3, 10, 0, 1.5);
  CheckPoint(moved, 5, 10, 1, 1.5);
  CheckPoint(moved, 8, 20, 1, 0);
  CheckPoint(rising.Scene, 3, 10, 0, 0); // the input
  CHECK(moved->GetPolys() == rising.Scene->GetPolys());
  CHECK(
    moved->GetCellData()->GetArray("PartIds") == rising.Scene->GetCellData()->GetArray("PartIds"));
  CHECK(helios::GetMaterials(moved).size() == 1);

  vtkPoints* before = moved->GetPoints();
  rising.Filter->SetStep(1, 3);
  rising.Filter->Update();
  CHECK(moved->GetPoints() == before); // nothing to do
  rising.Filter->RemoveAllMotions();
  rising.Filter->Update();
  CHECK(moved->GetPoints() == rising.Scene->GetPoints());
}

TEST_CASE("SceneMotion: the requested time", "[SceneMotion]")
{
  Rising rising;
  rising.Filter->SetTimeStep(0.1);
  for (const auto& [time, height] : { std::pair<double, double>{ 0.0, 0.0 }, { 0.09, 0.0 },
         { 0.1, 0.5 }, { 0.3, 1.5 }, { 0.7, 3.5 }, { 0.75, 3.5 } })
  {
    rising.Filter->UpdateTimeStep(time);
    INFO(time);
    CheckPoint(rising.Filter->GetOutput(), 3, 10, 0, height);
    CHECK(
      rising.Filter->GetOutput()->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()) == time);
  }
}

TEST_CASE("SceneMotion: normals rotate with their part", "[SceneMotion]")
{
  Rising rising;
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 3; ++i)
  {
    normals->InsertNextTuple3(0, 0, 1);
  }
  rising.Scene->GetCellData()->SetNormals(normals);
  const double axis[3] = { 2, 0, 0 };
  const double center[3] = { 1.0 / 3.0, 0, 0 };
  rising.Filter->AddRotation(2, axis, 30, center, true);
  rising.Filter->SetStep(2, 3);
  rising.Filter->Update();
  vtkPolyData* moved = rising.Filter->GetOutput();
  // about its centroid (20 + 1/3, 1/3, 0), by 90 degrees
  CheckPoint(moved, 6, 20, 1.0 / 3.0, -1.0 / 3.0);
  CheckPoint(moved, 8, 20, 1.0 / 3.0, 2.0 / 3.0);
  const helios::Vec3 turned(moved->GetCellData()->GetNormals()->GetTuple3(2));
  CHECK((turned - helios::Vec3(0, -1, 0)).Norm() < 1e-7);
  CHECK(moved->GetCellData()->GetNormals()->GetTuple3(1)[2] == 1.0);
  CHECK(normals->GetTuple3(2)[2] == 1.0);
}

TEST_CASE("SceneMotion: the centroid is weighted by area", "[SceneMotion]")
{
  Rising rising;
  // a distant second triangle of part 2 with zero area changes nothing
  vtkNew<vtkPolyData> scene;
  scene->DeepCopy(rising.Scene);
  scene->GetPoints()->InsertNextPoint(90, 0, 0);
  scene->GetPolys()->InsertNextCell({ 9, 9, 9 });
  auto* ids = helios::GetIds(scene, "PartIds");
  ids->InsertNextValue(2);
  helios::GetIds(scene, "MaterialIds")->InsertNextValue(0);
  const double axis[3] = { 0, 0, 1 };
  const double center[3] = { 0, 0, 0 };
  rising.Filter->SetInputData(scene);
  rising.Filter->AddRotation(2, axis, 180, center, true);
  rising.Filter->SetStep(2, 1);
  rising.Filter->Update();
  CheckPoint(rising.Filter->GetOutput(), 6, 20 + 2.0 / 3.0, 2.0 / 3.0, 0);
}

TEST_CASE("SceneMotion: bad input is an error", "[SceneMotion]")
{
  const double axis[3] = { 0, 0, 0 };
  const double finite[3] = { 1, 0, 0 };
  Rising rising;
  SECTION("no such part")
  {
    rising.Filter->AddTranslation(3, finite);
    rising.CheckFails(
      "part 3 moves, but the scene has no triangle of it; parts are numbered from 0");
  }
  SECTION("no axis")
  {
    rising.Filter->AddRotation(1, axis, 5, finite);
    rising.CheckFails("a motion of part 1 has an axis or normal of length 0; give one");
  }
  SECTION("not finite")
  {
    rising.Filter->AddRotation(1, finite, std::numeric_limits<double>::quiet_NaN(), finite);
    rising.CheckFails("a motion of part 1 has numbers that are not finite; give finite ones");
  }
  SECTION("no parts")
  {
    rising.Scene->GetCellData()->RemoveArray("PartIds");
    rising.CheckFails("the scene has no cell array PartIds");
  }
  SECTION("shared points")
  {
    helios::GetIds(rising.Scene, "PartIds")->SetValue(1, 0);
    rising.Scene->GetPolys()->ReplaceCellAtId(2, { 6, 7, 4 });
    helios::GetIds(rising.Scene, "PartIds")->SetValue(2, 1);
    rising.Scene->Modified();
    rising.CheckFails("point 4 belongs to a part that moves, part 1, and to another one; compose");
  }
  SECTION("backwards")
  {
    rising.Filter->SetStep(1, -1);
    CHECK(rising.Log->HasError("step -1 of part 1 is negative"));
    CHECK(rising.Filter->GetStep(1) == 0);
  }
}

TEST_CASE("SceneMotion: prints its properties", "[SceneMotion]")
{
  Rising rising;
  rising.Filter->SetStep(1, 7);
  rising.Filter->SetTimeStep(0.25);
  std::ostringstream text;
  rising.Filter->Print(text);
  CHECK(text.str().find("TimeStep: 0.25") != std::string::npos);
  CHECK(text.str().find("Part 1: 1 sequences, step 7") != std::string::npos);
}
