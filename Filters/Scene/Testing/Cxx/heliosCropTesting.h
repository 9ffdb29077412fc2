// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Crop fields for tests, and their ground truth arrays.

#ifndef heliosCropTesting_h
#define heliosCropTesting_h

#include "heliosCropFieldNames.h"
#include "heliosSceneTesting.h"
#include "vtkHeliosCropFieldSource.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace helios
{

/// A field as triangles, checked for the guarantees of every scene.
inline TriangleMesh Make(vtkHeliosCropFieldSource* field)
{
  field->Update();
  TriangleMesh mesh;
  REQUIRE(mesh.Set(field->GetOutput()).IsOk());
  CHECK(mesh.GetMemorySize() == 0); // double points, 32-bit cells
  CHECK(GetSmallestArea(mesh) > 0.0);
  for (const char* name : { vtkHeliosArrayNames::MaterialIds, vtkHeliosArrayNames::PartIds })
  {
    vtkIntArray* ids = GetIds(field->GetOutput(), name);
    REQUIRE(ids != nullptr);
    REQUIRE(ids->GetNumberOfValues() == mesh.GetNumberOfTriangles());
  }
  return mesh;
}

inline vtkDoubleArray* GetTruth(vtkHeliosCropFieldSource* field, const char* name)
{
  auto* array =
    vtkDoubleArray::SafeDownCast(field->GetOutput()->GetFieldData()->GetAbstractArray(name));
  REQUIRE(array != nullptr);
  return array;
}

inline std::vector<bool> FindMaterial(vtkHeliosCropFieldSource* field, const std::string& name)
{
  const MaterialTable table = GetMaterials(field->GetOutput());
  vtkIntArray* ids = GetIds(field->GetOutput(), vtkHeliosArrayNames::MaterialIds);
  std::vector<bool> is;
  for (vtkIdType i = 0; i < ids->GetNumberOfValues(); ++i)
  {
    is.push_back(table[static_cast<std::size_t>(ids->GetValue(i))].Name == name);
  }
  return is;
}

/// Disables all random variation.
inline void MakeExact(vtkHeliosCropFieldSource* field)
{
  field->SetEmergence(1.0);
  field->SetPositionJitter(0.0);
  field->SetPlantHeightDeviation(0.0);
  field->SetLeafVariation(0.0);
  field->SetGroundRoughness(0.0);
}

} // namespace helios

#endif
