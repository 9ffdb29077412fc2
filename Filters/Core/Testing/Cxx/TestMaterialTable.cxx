// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMaterialTable.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>

TEST_CASE("MaterialTable: values are stored and returned", "[MaterialTable]")
{
  helios::MaterialTable materials(2);
  materials[0].Name = "grass";
  materials[0].Reflectance = 0.1;
  materials[0].IsGround = true;
  materials[0].Classification = 2;
  materials[1].Name = "leaf";
  materials[1].Spectrum = "deciduous";
  materials[1].Specularity = 0.25;
  materials[1].SpecularExponent = 96.0;

  vtkNew<vtkPolyData> scene;
  helios::SetMaterials(scene, materials);
  CHECK(helios::GetMaterials(scene) == materials);
}

TEST_CASE("MaterialTable: a scene without materials has the default one", "[MaterialTable]")
{
  vtkNew<vtkPolyData> scene;
  const auto materials = helios::GetMaterials(scene);
  REQUIRE(materials.size() == 1);
  CHECK(std::isnan(materials[0].Reflectance));
  CHECK_FALSE(materials[0].IsGround);
}
