// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The faces of an OBJ file as triangles.

#ifndef heliosObjFaces_h
#define heliosObjFaces_h

#include "heliosScenePolygons.h"

#include <vtkType.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace helios
{

/// Adds faces to a mesh in their order; those that refer to a vertex further down, and all after
/// them, at the end.
class ObjFaces
{
public:
  explicit ObjFaces(SceneMesh& mesh)
    : Mesh(mesh)
    , Polygons(mesh)
  {
  }

  /// Vertices from 0; texture coordinates from 1, 0: none, or an empty list.
  struct Face
  {
    std::vector<vtkTypeInt32> Vertices;
    std::vector<int> Textures;
    int Material = 0;
    std::int64_t Line = 0;
  };

  /// Returns the triangles of all faces, at most: corners minus two each.
  std::int64_t GetLargestCount() const { return this->LargestCount; }

  /// Adds a face of a file.
  void Add(const Face& face, const std::string& path);

  /// Adds the faces that waited for vertices.
  void Finish();

  /// Warns of faces whose sides cross.
  void Warn(TextReport& report) const { this->Polygons.Warn(report); }

  /// Returns the texture coordinates of the corners of every triangle that was added with some.
  const std::vector<std::array<int, 3>>& GetTextures() const { return this->Textures; }

private:
  void AddTriangles(const Face& face, const std::string& path);
  void AddFan(const Face& face);
  void AddTextures(const Face& face, const std::array<int, 3>& corners);

  SceneMesh& Mesh;
  ScenePolygons Polygons;
  PolygonRings Rings{ {} };
  std::string Path;
  std::vector<Face> Waiting;
  std::vector<std::array<int, 3>> Textures;
  std::int64_t LargestCount = 0;
};

} // namespace helios

#endif
