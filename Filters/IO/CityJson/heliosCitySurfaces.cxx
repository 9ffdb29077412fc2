// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCitySurfaces.h"

#include <algorithm>
#include <iterator>

namespace helios
{

namespace
{

/// Classes of LAS 1.4 by the beginning of the name of an object or surface; the first match counts.
constexpr struct
{
  const char* Name;
  int Classification;
  bool IsGround;
} Classes[] = {
  { "Building", 6, false },
  { "Bridge", 17, false },
  { "Road", 11, true },
  { "TransportSquare", 11, true },
  { "Railway", 10, true },
  { "Water", 9, false }, // also Waterway
  { "TINRelief", 2, true },
  { "LandUse", 2, true },
  { "SolitaryVegetationObject", 5, false },
  { "PlantCover", 4, false },
};

} // namespace

//------------------------------------------------------------------------------
/// Surfaces have the class of their object: the roof of a bridge is no building.
CityClass FindCityClass(const std::string& object, const std::string& surface)
{
  const auto* found = std::find_if(std::begin(Classes), std::end(Classes),
    [&object](const auto& each) { return object.rfind(each.Name, 0) == 0; });
  if (found == std::end(Classes))
  {
    return {};
  }
  const bool isHole = surface == "TransportationHole";
  return { found->Classification, found->IsGround && !isHole };
}

//------------------------------------------------------------------------------
bool IsVirtual(const std::string& surface)
{
  return surface == "ClosureSurface" || surface == "WaterClosureSurface";
}

//------------------------------------------------------------------------------
int CityMaterials::FindRow(const std::string& object, const std::string& surface)
{
  const auto next = static_cast<int>(this->Materials.size());
  const auto [place, isNew] = this->Rows.emplace(std::make_pair(object, surface), next);
  if (!isNew)
  {
    return place->second;
  }
  Material material;
  material.Name = surface.empty() ? object : surface;
  const CityClass kind = FindCityClass(object, surface);
  material.Classification = kind.Classification;
  material.IsGround = kind.IsGround;
  const auto [row, isFirst] =
    this->RowsByName.emplace(std::make_pair(material.Name, material.Classification), next);
  if (isFirst)
  {
    this->Materials.push_back(material);
  }
  place->second = row->second;
  return place->second;
}

} // namespace helios
