// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The shapes that objects of a city model share: geometry-templates.

#ifndef heliosCityTemplates_h
#define heliosCityTemplates_h

#include "heliosCityGeometry.h"
#include "heliosSceneMesh.h"
#include "heliosStatus.h"

#include <cstdint>
#include <map>
#include <vector>

namespace helios
{

/// Adds instances of templates to a mesh: only the vertices that a template has.
class CityTemplates
{
public:
  CityTemplates(const JsonFile& file, SceneMesh& mesh, CityGeometry& geometry)
    : File(file)
    , Mesh(mesh)
    , Geometry(geometry)
  {
  }

  /// Returns the template of a GeometryInstance; null if it has none.
  const Json::Value& Find(const Json::Value& instance) const;

  /// Adds a GeometryInstance; ids gives the point of each vertex of the file.
  Status Add(const Json::Value& instance, const std::vector<vtkTypeInt32>& ids);

private:
  /// The vertices of a template.
  struct Shape
  {
    std::vector<std::size_t> Vertices; // rows of vertices-templates
    std::vector<double> Points;        // x y z of each
  };

  std::int64_t FindIndex(const Json::Value& instance) const;
  Status CheckSize(const Json::Value& instance);
  Status ReadShape(const Json::Value& instance, const Shape*& shape);
  Status AddVertices(
    const Json::Value& instance, const Shape& shape, const double* matrix, const double* place);

  const JsonFile& File;
  SceneMesh& Mesh;
  CityGeometry& Geometry;
  std::map<std::int64_t, Shape> Shapes; // by the index of the template
  std::int64_t NumberOfInstances = 0;
  std::vector<vtkTypeInt32> Ids; // points of the template's vertices in the current instance
};

} // namespace helios

#endif
