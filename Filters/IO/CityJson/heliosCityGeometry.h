// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The surfaces of a geometry of a city object as triangles.

#ifndef heliosCityGeometry_h
#define heliosCityGeometry_h

#include "heliosCitySurfaces.h"
#include "heliosSceneMesh.h"
#include "heliosScenePolygons.h"
#include "heliosStatus.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Json
{
class Value;
}

namespace helios
{

class JsonFile;

/// Returns the nesting of the lists of a geometry type: 0 surfaces, 1 shells, 2 solids; -1: no
/// surfaces.
int GetCityDepth(const Json::Value& geometry);

/// Adds the surfaces of geometries to a mesh. Errors have file:line and the object.
class CityGeometry
{
public:
  CityGeometry(const JsonFile& file, SceneMesh& mesh);

  /// Sets the text that later geometries and errors refer to; returns the previous one.
  const JsonFile& SetFile(const JsonFile& file);

  /// Sets the object that later geometries belong to.
  void SetObject(const std::string& name, const std::string& type);

  /// Adds a geometry; ids gives the point of each of its vertices.
  Status Add(const Json::Value& geometry, const std::vector<vtkTypeInt32>& ids);

  /// Warns of surfaces whose rings cross.
  void Warn(TextReport& report) const { this->Polygons.Warn(report); }

  /// Returns an error at a value of the current object.
  Status Fail(const Json::Value& value, const std::string& message) const;

private:
  Status AddLevel(const Json::Value& boundaries, const Json::Value& values, int depth);
  Status AddSurface(const Json::Value& surface, const Json::Value& value);
  Status ReadRing(const Json::Value& ring);
  Status FindRow(const Json::Value& value, int& row);

  const JsonFile* File;
  SceneMesh& Mesh;
  CityMaterials Materials;
  std::string ObjectName;
  std::string ObjectType;
  const Json::Value* Surfaces = nullptr;          // semantics of the current geometry
  const std::vector<vtkTypeInt32>* Ids = nullptr; // likewise
  PolygonRings Rings;                             // rings of the current surface
  ScenePolygons Polygons;
};

} // namespace helios

#endif
