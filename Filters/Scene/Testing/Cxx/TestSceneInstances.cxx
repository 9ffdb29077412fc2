// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Instances on input 1 of vtkHeliosSceneComposer.
#include "heliosErrorObserver.h"
#include "heliosInstanceTesting.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosSceneComposer.h"
#include "vtkHeliosSceneFlatten.h"
#include "vtkHeliosSceneTransform.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTrivialProducer.h>

#include <string>
#include <vector>

using namespace helios::test;

namespace names = vtkHeliosArrayNames;

namespace
{

const std::vector<Place> Places = { { 1, { 5, 0, 0 }, { 1, 0, 0, 0 }, 1.0, 1 },
  { 1, { 0, 7, 2 }, { 0.9, 0.1, 0.3, 0.2 }, 2.5, 3 }, { 2, { 1, 1, 1 }, { 0, 0, 0, 1 }, 0.5, 4 } };

/// Two parts, two prototypes, and their instances: parts 0 and 2, instances 1, 3, 4.
struct Composing
{
  vtkSmartPointer<vtkPolyData> Meshes[4] = { MakeMesh(3, "ground"), MakeMesh(4, "oak"),
    MakeMesh(5, "pine"), MakeMesh(2, "wall") };
  vtkNew<vtkHeliosSceneComposer> Composer;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  Composing()
  {
    for (const auto& mesh : this->Meshes)
    {
      this->Composer->AddInputDataObject(0, mesh);
    }
    this->Composer->SetPartName(0, "the ground");
    this->Composer->SetPartId(3, 2);
    this->Composer->SetInputDataObject(1, MakeInstances(Places));
    this->Log->Watch(this->Composer);
  }
};

} // namespace

TEST_CASE("SceneComposer: instances are what copies are, flattened", "[SceneInstances]")
{
  Composing composing;
  composing.Composer->Update();
  auto* scene = vtkHeliosScene::SafeDownCast(composing.Composer->GetOutput());
  REQUIRE(scene);
  CHECK(composing.Log->Errors.empty());
  CHECK(scene->GetNumberOfPolys() == 5);
  CHECK(scene->GetNumberOfPrototypes() == 2);
  CHECK(scene->GetNumberOfTriangles() == 5 + 4 + 4 + 5);
  vtkNew<vtkHeliosSceneFlatten> flatten;
  flatten->SetInputConnection(composing.Composer->GetOutputPort());
  flatten->Update();
  vtkPolyData* flat = flatten->GetOutput();

  // Makes copies of the parts.
  vtkNew<vtkHeliosSceneComposer> copies;
  int part = 0;
  const auto add = [&](vtkPolyData* mesh, const Place& place)
  {
    vtkNew<vtkHeliosSceneTransform> move;
    move->SetInputDataObject(mesh);
    move->SetRotation(place.Rotation);
    move->SetScale(place.Scale);
    move->SetTranslation(place.Position);
    copies->AddInputConnection(move->GetOutputPort());
    const std::string name = "tree " + std::to_string(part++);
    copies->SetPartName(part - 1, name.c_str());
  };
  const Place none{ 0, { 0, 0, 0 }, { 1, 0, 0, 0 }, 1.0, 0 };
  add(composing.Meshes[0], none);
  add(composing.Meshes[1], Places[0]);
  add(composing.Meshes[3], none);
  add(composing.Meshes[1], Places[1]);
  add(composing.Meshes[2], Places[2]);
  copies->SetPartName(0, "the ground");
  copies->SetPartName(2, nullptr);
  copies->Update();
  vtkPolyData* truth = copies->GetOutput();
  CHECK_FALSE(vtkHeliosScene::SafeDownCast(truth));

  CheckSame(flat, truth);
}

TEST_CASE("SceneFlatten: a mesh stays as it is, errors have messages", "[SceneInstances]")
{
  vtkNew<vtkHeliosSceneFlatten> flatten;
  const auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(flatten);
  const auto mesh = MakeMesh(3, "oak");
  flatten->SetInputDataObject(0, mesh);
  flatten->Update();
  CHECK(flatten->GetOutput()->GetPoints() == mesh->GetPoints());
  vtkNew<vtkHeliosScene> scene;
  scene->SetInstances(MakeInstances(Places));
  flatten->SetInputDataObject(0, scene);
  flatten->Update();
  CHECK(log->HasError("instance 0 of the scene has PrototypeIds 1, but there are 0"));
  CHECK(flatten->GetOutput()->GetNumberOfCells() == 0);
  log->Errors.clear();
  double bounds[6];
  CHECK_FALSE(flatten->ComputeBounds(scene, bounds));
  CHECK(log->HasError("instance 0 of the scene has PrototypeIds 1, but there are 0"));
}

TEST_CASE("SceneFlatten: bounds are those of the mesh, to the last bit", "[SceneInstances]")
{
  Composing composing;
  composing.Composer->Update();
  vtkNew<vtkHeliosSceneFlatten> flatten;
  flatten->SetInputConnection(composing.Composer->GetOutputPort());
  flatten->Update();
  for (vtkPolyData* scene : { composing.Composer->GetOutput(), flatten->GetOutput() })
  {
    double own[6], truth[6];
    REQUIRE(flatten->ComputeBounds(scene, own));
    flatten->GetOutput()->GetBounds(truth);
    CHECK(std::equal(own, own + 6, truth));
  }
}

TEST_CASE("SceneComposer: without input 1 the output is a mesh again", "[SceneInstances]")
{
  Composing composing;
  composing.Composer->Update();
  composing.Composer->SetInputConnection(1, nullptr);
  composing.Composer->Update();
  CHECK_FALSE(vtkHeliosScene::SafeDownCast(composing.Composer->GetOutput()));
  CHECK(composing.Composer->GetOutput()->GetNumberOfPolys() == 14);
}

TEST_CASE("SceneComposer: instances of nothing but prototypes", "[SceneInstances]")
{
  vtkNew<vtkHeliosSceneComposer> composer;
  composer->AddInputDataObject(0, MakeMesh(3, "oak"));
  vtkNew<vtkPolyData> instances; // one, at the default place
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(1, 2, 3);
  instances->SetPoints(points);
  composer->SetInputDataObject(1, instances);
  composer->Update();
  auto* scene = vtkHeliosScene::SafeDownCast(composer->GetOutput());
  REQUIRE(scene);
  CHECK(scene->GetNumberOfPolys() == 0);
  CHECK(scene->GetNumberOfTriangles() == 3);
  vtkNew<vtkHeliosScene> copy;
  copy->DeepCopy(scene);
  CHECK(copy->GetNumberOfTriangles() == 3);
  CHECK(copy->GetPrototype(0) != scene->GetPrototype(0));
  CHECK(copy->GetPrototype(1) == nullptr);
  CHECK(scene->GetActualMemorySize() > 0);
  copy->Initialize();
  CHECK(copy->GetNumberOfTriangles() == 0);
}

TEST_CASE("SceneComposer: invalid instances have messages", "[SceneInstances]")
{
  const auto fails = [](std::vector<Place> places, const std::string& text)
  {
    Composing composing;
    composing.Composer->SetInputDataObject(1, MakeInstances(places));
    composing.Composer->Update();
    CHECK(composing.Log->HasError(text));
  };
  auto places = Places;
  places[1].Prototype = 4;
  fails(places,
    "PrototypeIds 4 of instance 1 is not valid: expected a connection of input 0 with triangles, 0 "
    "to 3");
  places = Places;
  places[2].Part = 3;
  fails(places, "Part id 3 is given twice");
  places[2].Part = 2;
  fails(places, "Part id 2 is given twice");
  places = Places;
  places[1].Part = 9;
  fails(places, "Part ids must ascend");

  Composing composing;
  composing.Composer->SetPartId(-1, 2);
  CHECK(composing.Log->HasError("Part -1 cannot have the id 2"));
  CHECK(composing.Composer->GetPartId(3) == 2);
  CHECK(composing.Composer->GetPartId(0) == -1);
}

TEST_CASE("vtkHeliosScene: its bounds are those of all triangles", "[SceneInstances]")
{
  Composing composing;
  composing.Composer->Update();
  auto* scene = vtkHeliosScene::SafeDownCast(composing.Composer->GetOutput());
  REQUIRE(scene);
  const auto check = [scene]
  {
    vtkNew<vtkHeliosSceneFlatten> flatten;
    flatten->SetInputDataObject(0, scene);
    flatten->Update();
    double own[6], tight[6];
    scene->GetBounds(own);
    flatten->GetOutput()->GetBounds(tight);
    for (int i = 0; i < 6; i += 2)
    {
      CHECK(own[i] <= tight[i]);
      CHECK(own[i + 1] >= tight[i + 1]);
      CHECK(own[i] > tight[i] - 3.0); // boxes of rotated boxes
      CHECK(own[i + 1] < tight[i + 1] + 3.0);
    }
  };
  check();
  scene->GetInstances()->GetPoints()->SetPoint(0, 500.0, 0.0, 0.0);
  scene->GetInstances()->GetPoints()->Modified();
  scene->GetInstances()->Modified();
  check();
  vtkNew<vtkHeliosScene> empty;
  CHECK(empty->GetBounds()[0] > empty->GetBounds()[1]);
}
