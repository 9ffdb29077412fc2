// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneCrs.h"

#include "vtkHeliosArrayNames.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

TEST_CASE("SceneCrs: set, get, remove", "[SceneCrs]")
{
  vtkNew<vtkPolyData> scene;
  CHECK(helios::GetCRS(scene).empty());
  helios::SetCRS(scene, "EPSG:25832");
  CHECK(helios::GetCRS(scene) == "EPSG:25832");
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(scene);
  helios::SetCRS(copy, "EPSG:32633");
  CHECK(helios::GetCRS(copy) == "EPSG:32633");
  CHECK(helios::GetCRS(scene) == "EPSG:25832");
  helios::SetCRS(scene, "");
  CHECK(helios::GetCRS(scene).empty());
  CHECK_FALSE(scene->GetFieldData()->HasArray(vtkHeliosArrayNames::CRS));
}
