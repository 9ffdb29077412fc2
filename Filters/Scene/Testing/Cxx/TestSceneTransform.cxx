// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosSceneTesting.h"
#include "vtkHeliosSceneTransform.h"

#include <vtkDoubleArray.h>
#include <vtkPointData.h>

#include <catch2/catch.hpp>

#include <limits>
#include <sstream>
#include <string>

namespace
{

const double NaN = std::numeric_limits<double>::quiet_NaN();

/// A part of one triangle with its first corner at x, y, z.
vtkSmartPointer<vtkPolyData> MakePart(double x, double y, double z)
{
  auto part = helios::MakeTriangle(0.0, { helios::Material() });
  part->GetPoints()->SetPoint(0, x, y, z);
  return part;
}

std::string GetError(vtkHeliosSceneTransform* transform)
{
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(transform);
  transform->SetInputData(MakePart(1, 2, 3));
  transform->Update();
  CHECK(transform->GetOutput()->GetNumberOfPoints() == 0);
  return log->Errors;
}

} // namespace

TEST_CASE("SceneTransform: rotates, scales, then translates", "[SceneTransform]")
{
  vtkNew<vtkHeliosSceneTransform> transform;
  transform->SetInputData(MakePart(1, 0, 5));
  const double root = std::sqrt(0.5);
  transform->SetRotation(root, 0, 0, root); // 90 degrees about z
  transform->SetScale(2.0);
  transform->SetTranslation(10, 20, 30);
  transform->Update();
  const helios::Vec3 p(transform->GetOutput()->GetPoint(0));
  CHECK(p[0] == Approx(10.0).margin(1e-14));
  CHECK(p[1] == Approx(22.0).epsilon(1e-15));
  CHECK(p[2] == Approx(40.0).epsilon(1e-15));
}

TEST_CASE("SceneTransform: the length of the quaternion has no effect", "[SceneTransform]")
{
  vtkNew<vtkHeliosSceneTransform> transform;
  transform->SetInputData(MakePart(3, 0, 0));
  transform->SetRotation(7, 0, 0, 7);
  transform->Update();
  CHECK(transform->GetOutput()->GetPoint(0)[1] == Approx(3.0).epsilon(1e-15));
}

TEST_CASE("SceneTransform: exact to the last bit at UTM coordinates", "[SceneTransform]")
{
  const double x = 500000.123456;
  const double y = 5500000.987654321;
  vtkNew<vtkHeliosSceneTransform> transform;
  transform->SetInputData(MakePart(x, y, 0.1));
  transform->SetTranslation(0.5, -0.25, 0.0);
  transform->Update();
  CHECK(transform->GetOutput()->GetPoint(0)[0] == x + 0.5);
  CHECK(transform->GetOutput()->GetPoint(0)[1] == y - 0.25);
  CHECK(transform->GetOutput()->GetPoint(0)[2] == 0.1);
}

TEST_CASE("SceneTransform: passes unchanged arrays by reference", "[SceneTransform]")
{
  const auto part = MakePart(1, 2, 3);
  vtkNew<vtkHeliosSceneTransform> transform;
  transform->SetInputData(part);
  transform->Update();
  CHECK(transform->GetOutput()->GetPoints() == part->GetPoints());

  transform->SetScale(3.0);
  transform->Update();
  vtkPolyData* output = transform->GetOutput();
  CHECK(output->GetPoints() != part->GetPoints());
  CHECK(part->GetPoint(0)[0] == 1.0);
  CHECK(output->GetPolys()->GetConnectivityArray() == part->GetPolys()->GetConnectivityArray());
  CHECK(helios::GetIds(output, "MaterialIds") == helios::GetIds(part, "MaterialIds"));
  CHECK(helios::GetMaterials(output) == helios::GetMaterials(part));
}

TEST_CASE("SceneTransform: converts points to double", "[SceneTransform]")
{
  vtkNew<vtkHeliosSceneTransform> transform;
  transform->SetInputData(helios::MakeTriangle(0.0, { helios::Material() }, true, VTK_FLOAT));
  transform->Update();
  CHECK(transform->GetOutput()->GetPoints()->GetDataType() == VTK_DOUBLE);
  transform->SetTranslation(500000.125, 0, 0);
  transform->Update();
  CHECK(transform->GetOutput()->GetPoint(1)[0] == 500001.125);
}

TEST_CASE("SceneTransform: rotates normals", "[SceneTransform]")
{
  const auto part = MakePart(1, 2, 3);
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  normals->InsertNextTuple3(1, 0, 0);
  part->GetCellData()->SetNormals(normals);
  vtkNew<vtkHeliosSceneTransform> transform;
  transform->SetInputData(part);
  transform->SetRotation(1, 0, 0, 1);
  transform->SetScale(5);
  transform->Update();
  const double* normal = transform->GetOutput()->GetCellData()->GetNormals()->GetTuple3(0);
  CHECK(normal[0] == Approx(0.0).margin(1e-15));
  CHECK(normal[1] == Approx(1.0));
  CHECK(normals->GetComponent(0, 0) == 1.0);
}

TEST_CASE("SceneTransform: an empty part stays empty", "[SceneTransform]")
{
  vtkNew<vtkPolyData> empty;
  vtkNew<vtkHeliosSceneTransform> transform;
  transform->SetInputData(empty);
  transform->SetScale(2.0);
  transform->Update();
  CHECK(transform->GetOutput()->GetNumberOfCells() == 0);
}

TEST_CASE("SceneTransform: errors name the property", "[SceneTransform]")
{
  vtkNew<vtkHeliosSceneTransform> transform;
  transform->SetRotation(0, 0, 0, 0);
  CHECK_THAT(GetError(transform), Catch::Contains("Rotation is (0, 0, 0, 0)"));
  transform->SetRotation(1, 0, NaN, 0);
  CHECK_THAT(GetError(transform), Catch::Contains("Rotation is (1, 0, nan, 0)"));
  transform->SetRotation(1, 0, 0, 0);
  for (const double scale : { 0.0, -1.0, NaN })
  {
    std::ostringstream text;
    text << "Scale is " << scale << "; set a number greater than 0";
    transform->SetScale(scale);
    CHECK_THAT(GetError(transform), Catch::Contains(text.str()));
  }
  transform->SetScale(1.0);
  transform->SetTranslation(0, std::numeric_limits<double>::infinity(), 0);
  CHECK_THAT(GetError(transform), Catch::Contains("Translation is (0, inf, 0)"));
}

TEST_CASE("SceneTransform: prints its properties", "[SceneTransform]")
{
  vtkNew<vtkHeliosSceneTransform> transform;
  std::ostringstream text;
  transform->Print(text);
  CHECK_THAT(text.str(), Catch::Contains("Scale: 1"));
}
