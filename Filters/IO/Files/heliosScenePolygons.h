// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The polygons of a scene file as triangles of its mesh.

#ifndef heliosScenePolygons_h
#define heliosScenePolygons_h

#include "heliosPolygonTriangulator.h"
#include "heliosSceneMesh.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <cstdint>
#include <string>
#include <vector>

namespace helios
{

/// Adds polygons, which may be concave and have holes, and counts those that cross themselves.
class VTKHELIOSFILTERSIO_EXPORT ScenePolygons
{
public:
  explicit ScenePolygons(SceneMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Adds a polygon; getPlace() gives "path:line: ", and is called if its sides cross.
  template <typename Function>
  void Add(const PolygonRings& rings, int material, Function getPlace)
  {
    if (!this->AddTriangles(rings, material) && this->NumberOfCrossed++ == 0)
    {
      this->FirstPlace = getPlace();
    }
  }

  /// Returns the places of the corners of the triangles added last, counted through all rings.
  const std::vector<int>& GetPlaces() const { return this->Triangulator.GetPlaces(); }

  /// Warns of the polygons that cross themselves, if there are any.
  void Warn(TextReport& report) const;

private:
  bool AddTriangles(const PolygonRings& rings, int material);

  SceneMesh& Mesh;
  PolygonTriangulator Triangulator;
  std::int64_t NumberOfCrossed = 0;
  std::string FirstPlace;
};

} // namespace helios

#endif
