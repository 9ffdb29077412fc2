// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a mesh of a glTF document.

#ifndef heliosGltfMesh_h
#define heliosGltfMesh_h

#include "heliosGltfSkin.h"
#include "heliosStatus.h"

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

namespace Json
{
class Value;
}

namespace helios
{

class GltfDocument;

/// Triangles in the coordinates of the mesh.
struct GltfMesh
{
  std::vector<double> Points;        // x y z of each vertex
  std::vector<vtkTypeInt32> Corners; // three vertices of each triangle
  // material of each triangle, by index of the document; -1: none
  std::vector<int> Materials;
  // u v of the corners of each triangle, v downward; NaN: none. Empty: not read.
  std::vector<float> Textures;
  GltfWeights Weights; // joints of the vertices, if a skin moves them
};

/// Reads the primitives of a mesh that are triangles, strips or fans; points and lines are skipped.
/// Texture coordinates of a
/// set are read for materials that have one; by index, -1: none. Vertices are moved by the morph targets that have a weight; without weights, by none. With a skin the joints of
/// vertices are read, too.
Status ReadGltfMesh(GltfDocument& document, std::int64_t index, const std::vector<double>& weights,
  bool hasSkin, const std::vector<int>& textureSets, GltfMesh& mesh);

} // namespace helios

#endif
