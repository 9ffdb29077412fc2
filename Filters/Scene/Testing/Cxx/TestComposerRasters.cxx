// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rasters of heights on input 0 of vtkHeliosSceneComposer.
#include "heliosErrorObserver.h"
#include "heliosInstanceTesting.h"
#include "heliosRasterScenes.h"
#include "heliosSceneCrs.h"
#include "vtkHeliosScene.h"
#include "vtkHeliosSceneComposer.h"
#include "vtkHeliosSceneFlatten.h"
#include "vtkHeliosSceneTransform.h"

using namespace helios::test;

namespace names = vtkHeliosArrayNames;

namespace
{

helios::HeightRaster MakeRaster()
{
  helios::HeightRaster raster(9, 7, helios::TestTransforms[3]);
  raster.AddHills(3.0, 1.0);
  raster.At(3, 3) = std::nan("");
  return raster;
}

/// A raster and its mesh, with a material.
struct Terrain
{
  vtkSmartPointer<vtkImageData> Image = MakeRaster().MakeImage<vtkFloatArray>();
  vtkSmartPointer<vtkPolyData> Mesh = helios::MakeMesh(MakeRaster());

  explicit Terrain(const char* material)
  {
    helios::MaterialTable table(1);
    table[0].Name = material;
    helios::SetMaterials(this->Image, table);
    helios::SetMaterials(this->Mesh, table);
  }
};

vtkSmartPointer<vtkPolyData> Flatten(vtkHeliosSceneComposer* composer)
{
  vtkNew<vtkHeliosSceneFlatten> flatten;
  flatten->SetInputConnection(composer->GetOutputPort());
  flatten->Update();
  return flatten->GetOutput();
}

} // namespace

TEST_CASE("SceneComposer: rasters are parts as meshes are", "[ComposerRasters]")
{
  const Terrain soil("soil"), rock("rock");
  for (const bool hasMeshes : { false, true })
  {
    vtkNew<vtkHeliosSceneComposer> composer, copies;
    const auto add = [&](vtkDataObject* data, vtkPolyData* mesh, const char* name)
    {
      const int part = composer->GetNumberOfInputConnections(0);
      composer->AddInputDataObject(0, data);
      copies->AddInputDataObject(0, mesh);
      composer->SetPartName(part, name);
      copies->SetPartName(part, name);
    };
    add(soil.Image, soil.Mesh, "field");
    if (hasMeshes)
    {
      const auto oak = MakeMesh(3, "oak");
      add(oak, oak, "tree");
      add(rock.Image, rock.Mesh, "cliff");
      add(oak, oak, nullptr);
    }
    composer->Update();
    copies->Update();
    auto* scene = vtkHeliosScene::SafeDownCast(composer->GetOutput());
    REQUIRE(scene);
    CHECK(scene->GetNumberOfInstances() == (hasMeshes ? 2 : 1));
    CHECK(scene->GetNumberOfPolys() == (hasMeshes ? 6 : 0));
    CHECK(scene->GetNumberOfTriangles() == copies->GetOutput()->GetNumberOfPolys());
    CheckSame(Flatten(composer), copies->GetOutput());
    double bounds[6], expected[6];
    scene->GetBounds(bounds);
    copies->GetOutput()->GetBounds(expected);
    CHECK(std::equal(bounds, bounds + 6, expected));
  }
}

TEST_CASE("SceneComposer: instances of rasters and meshes", "[ComposerRasters]")
{
  const Terrain soil("soil"), rock("rock");
  const auto oak = MakeMesh(4, "oak");
  const std::vector<Place> places = { { 2, { 5, 0, 0 }, { 0.8, 0, 0.6, 0 }, 1.2, 0 },
    { 0, { 0, 7, 2 }, { 0.9, 0.1, 0.3, 0.2 }, 2.5, 2 },
    { 0, { 1, 1, 1 }, { 0, 0, 0, 1 }, 0.5, 3 } };
  vtkNew<vtkHeliosSceneComposer> composer, copies;
  composer->AddInputDataObject(0, soil.Image); // two instances
  composer->AddInputDataObject(0, rock.Image); // at its place, between the instances
  composer->AddInputDataObject(0, oak);
  composer->SetPartId(1, 1);
  composer->SetPartName(1, "cliff");
  const auto instances = MakeInstances(places);
  vtkNew<vtkIntArray> materials;
  materials->SetName(names::MaterialIds);
  for (const int id : { -1, -1, 1 })
  {
    materials->InsertNextValue(id);
  }
  instances->GetPointData()->AddArray(materials);
  composer->SetInputDataObject(1, instances);
  composer->Update();

  const auto add = [&](vtkPolyData* mesh, const Place& place, const char* name)
  {
    vtkNew<vtkHeliosSceneTransform> move;
    move->SetInputDataObject(mesh);
    move->SetRotation(place.Rotation);
    move->SetScale(place.Scale);
    move->SetTranslation(place.Position);
    copies->SetPartName(copies->GetNumberOfInputConnections(0), name);
    copies->AddInputConnection(move->GetOutputPort());
  };
  add(oak, places[0], "tree 0");
  add(rock.Mesh, { 0, { 0, 0, 0 }, { 1, 0, 0, 0 }, 1.0, 0 }, "cliff");
  add(soil.Mesh, places[1], "tree 2");
  const Terrain asRock("rock"); // the second material of the scene
  add(asRock.Mesh, places[2], "tree 3");
  copies->Update();
  auto* scene = vtkHeliosScene::SafeDownCast(composer->GetOutput());
  REQUIRE(scene);
  CHECK(scene->GetNumberOfInstances() == 4);
  CHECK(scene->GetNumberOfPrototypes() == 3);
  CheckSame(Flatten(composer), copies->GetOutput());
}

TEST_CASE("SceneComposer: a raster and a mesh in turn", "[ComposerRasters]")
{
  const Terrain soil("soil");
  vtkNew<vtkHeliosSceneComposer> composer;
  composer->AddInputDataObject(0, soil.Image);
  composer->Update();
  CHECK(vtkHeliosScene::SafeDownCast(composer->GetOutput()));
  composer->SetInputDataObject(0, soil.Mesh);
  composer->Update();
  CHECK_FALSE(vtkHeliosScene::SafeDownCast(composer->GetOutput()));
  CHECK(composer->GetOutput()->GetNumberOfPolys() == soil.Mesh->GetNumberOfPolys());
}

TEST_CASE("SceneComposer: rasters that are not valid have messages", "[ComposerRasters]")
{
  const Terrain soil("soil");
  vtkNew<vtkHeliosSceneComposer> composer;
  vtkNew<helios::ErrorObserver> log;
  log->Watch(composer);
  composer->AddInputDataObject(0, MakeMesh(3, "oak"));
  composer->AddInputDataObject(0, soil.Image);
  composer->SetPartName(1, "field");
  soil.Image->GetFieldData()->RemoveArray(names::GeoTransform);
  composer->Update();
  CHECK(log->HasError("Part 1 (field): the raster has no field data GeoTransform of 6 doubles"));
  CHECK(composer->GetOutput()->GetNumberOfPolys() == 0);

  const Terrain dutch("soil"), british("soil");
  log->Clear();
  composer->RemoveAllInputs();
  helios::SetCRS(dutch.Image, "EPSG:28992");
  helios::SetCRS(british.Image, "EPSG:27700");
  composer->AddInputDataObject(0, dutch.Image);
  composer->AddInputDataObject(0, british.Image);
  composer->Update();
  CHECK(log->HasError("Part 1 (field) has the CRS"));
}
