// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Skins of glTF documents: vertices that follow joints.

#ifndef heliosGltfSkin_h
#define heliosGltfSkin_h

#include "heliosGltfTransform.h"
#include "heliosStatus.h"

#include <vtkType.h>

#include <array>
#include <cstddef>
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
class GltfNodes;

/// Joints of the vertices of a mesh, and their weights, which are 1 together.
struct GltfWeights
{
  struct Influence
  {
    std::int64_t Joint; ///< index into the joints of the skin
    double Weight;
  };
  std::vector<Influence> Influences; ///< influences on one vertex after the other
  std::vector<std::size_t> Ends;     ///< end of those of each vertex

  /// Returns where a vertex is by the matrices of the joints.
  std::array<double, 3> Apply(
    std::size_t vertex, const double* p, const std::vector<GltfTransform>& joints) const;
};

/// Adds the weights of the vertices of a primitive, JOINTS_n and WEIGHTS_n; an error without.
Status ReadGltfWeights(GltfDocument& document, const Json::Value& primitive,
  const std::string& path, std::int64_t vertices, GltfWeights& weights);

/// Computes the matrix of each joint of a skin: from the mesh at rest to the scene.
Status FindGltfJoints(GltfDocument& document, std::int64_t skin, const GltfNodes& nodes,
  std::vector<GltfTransform>& joints);

} // namespace helios

#endif
