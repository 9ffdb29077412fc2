// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The materials of city models: a row per kind of surface, with its class.

#ifndef heliosCitySurfaces_h
#define heliosCitySurfaces_h

#include "heliosMaterialTable.h"

#include <map>
#include <string>
#include <utility>

namespace helios
{

/// The class of a kind of surface in LAS, and whether tripods may be placed on it.
struct CityClass
{
  int Classification = 0;
  bool IsGround = false;
};

/// Returns the class of a semantic surface ("RoofSurface"; empty: none) of a city object
/// ("BuildingPart").
CityClass FindCityClass(const std::string& object, const std::string& surface);

/// Returns whether a semantic surface only closes a volume, and nothing is there.
bool IsVirtual(const std::string& surface);

/// Adds a material for each kind of surface, by name and class, in the order of their first use.
class CityMaterials
{
public:
  explicit CityMaterials(MaterialTable& materials)
    : Materials(materials)
  {
  }

  /// Finds the row of a semantic surface of a city object.
  int FindRow(const std::string& object, const std::string& surface);

private:
  MaterialTable& Materials;
  std::map<std::pair<std::string, std::string>, int> Rows; // by object and surface
  std::map<std::pair<std::string, int>, int> RowsByName;   // and class
};

} // namespace helios

#endif
