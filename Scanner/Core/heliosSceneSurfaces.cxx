// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneSurfaces.h"

#include "heliosMaterialTable.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkPolyData.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// A cell array of the scene as one of the wanted type; its first value, or null where there is none.
template <typename ArrayT>
auto* Take(vtkPolyData* scene, const char* name, int components, vtkSmartPointer<ArrayT>& array,
  std::string& fault)
{
  vtkDataArray* given = scene->GetCellData()->GetArray(name);
  const bool fits = given && given->GetNumberOfComponents() == components &&
    given->GetNumberOfTuples() == scene->GetNumberOfCells();
  if (given && !fits)
  {
    fault = std::string("cell array ") + name + " of the scene has " +
      std::to_string(given->GetNumberOfTuples()) + " tuples of " +
      std::to_string(given->GetNumberOfComponents()) + " for " +
      std::to_string(scene->GetNumberOfCells()) + " triangles; it needs one of " +
      std::to_string(components) + " each";
  }
  array = ArrayT::FastDownCast(given);
  if (fits && !array)
  {
    array = vtkSmartPointer<ArrayT>::New();
    array->DeepCopy(given);
  }
  return array ? array->GetPointer(0) : nullptr;
}

} // namespace

//------------------------------------------------------------------------------
std::string SceneSurfaces::Set(vtkPolyData* scene)
{
  std::string fault;
  this->Materials = Take(scene, names::MaterialIds, 1, this->MaterialArray, fault);
  this->Parts = Take(scene, names::PartIds, 1, this->PartArray, fault);
  this->Normals = Take(scene, names::Normals, 3, this->NormalArray, fault);
  const std::string material = this->SetMaterials(scene);
  fault = fault.empty() ? material : fault;
  return fault.empty() ? this->CheckMaterialIds() : fault;
}

//------------------------------------------------------------------------------
std::string SceneSurfaces::SetMaterials(vtkPolyData* scene)
{
  this->Reflections.clear();
  this->Classifications.clear();
  const auto isShare = [](double x) { return x >= 0.0 && x <= 1.0; };
  for (const Material& m : GetMaterials(scene))
  {
    const double rho = std::isnan(m.Reflectance) ? DefaultReflectance : m.Reflectance;
    const double exponent = m.SpecularExponent;
    if (!isShare(rho) || !isShare(m.Specularity) || !(exponent >= 0.0 && exponent <= 1e6))
    {
      return "material " + std::to_string(this->Reflections.size()) + " of the scene, " + m.Name +
        ", has reflectance " + std::to_string(rho) + ", specularity " +
        std::to_string(m.Specularity) + " and specular exponent " + std::to_string(exponent) +
        "; give the first two within [0, 1] and the last within [0, 1e6]";
    }
    this->Reflections.push_back({ rho, m.Specularity, exponent });
    this->Classifications.push_back(m.Classification);
  }
  return {};
}

//------------------------------------------------------------------------------
std::string SceneSurfaces::CheckMaterialIds() const
{
  int range[2] = { 0, 0 };
  if (this->Materials)
  {
    this->MaterialArray->GetValueRange(range);
  }
  if (range[0] >= 0 && range[1] < static_cast<int>(this->Reflections.size()))
  {
    return {};
  }
  return std::string("cell array ") + names::MaterialIds + " of the scene goes from " +
    std::to_string(range[0]) + " to " + std::to_string(range[1]) + ", but its field data has " +
    std::to_string(this->Reflections.size()) + " materials";
}

} // namespace helios
