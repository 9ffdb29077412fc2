// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMaterialTable.h"
#include "vtkHeliosSceneClassify.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

using namespace helios;

namespace
{

MaterialTable Classify(vtkPolyData* mesh, int classification)
{
  vtkNew<vtkHeliosSceneClassify> filter;
  filter->SetInputData(mesh);
  filter->SetClassification(classification);
  filter->Update();
  CHECK(filter->GetOutput()->GetPoints() == mesh->GetPoints());
  return GetMaterials(filter->GetOutput());
}

} // namespace

TEST_CASE("SceneClassify: all materials have the class, and are else unchanged", "[SceneClassify]")
{
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(vtkNew<vtkPoints>());
  MaterialTable materials(2);
  materials[0].Reflectance = 0.3;
  materials[1].Name = "leaf";
  materials[1].Classification = 2;
  materials[1].IsGround = true;
  SetMaterials(mesh, materials);
  const MaterialTable made = Classify(mesh, 5);
  materials[0].Classification = materials[1].Classification = 5;
  CHECK(made == materials);
  CHECK(GetMaterials(mesh)[1].Classification == 2); // the input is unchanged
}

TEST_CASE("SceneClassify: a mesh without materials has the default one", "[SceneClassify]")
{
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(vtkNew<vtkPoints>());
  const MaterialTable made = Classify(mesh, 6);
  REQUIRE(made.size() == 1);
  CHECK(made[0].Name == Material().Name);
  CHECK(made[0].Classification == 6);
}
