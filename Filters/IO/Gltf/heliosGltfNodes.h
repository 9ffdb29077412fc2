// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The nodes of a glTF scene: where its meshes are.

#ifndef heliosGltfNodes_h
#define heliosGltfNodes_h

#include "heliosGltfDocument.h"
#include "heliosGltfTransform.h"
#include "heliosStatus.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace helios
{

/// A mesh at a place.
struct GltfPlacement
{
  std::int64_t Mesh = 0;
  std::int64_t Node = 0;
  GltfTransform Place;
  std::vector<double> Weights{}; ///< weights of the mesh's morph targets; empty: all 0
};

/// Finds the placements of the default scene; without scenes, of all nodes. Nodes that are not
/// visible are left out, with their children.
class GltfNodes
{
public:
  explicit GltfNodes(GltfDocument& document)
    : Document(document)
  {
  }

  Status Find(std::vector<GltfPlacement>& placements);

private:
  /// A node to visit, with the transform of its parent.
  using Visit = std::pair<std::int64_t, GltfTransform>;

  Status FindRoots(std::vector<Visit>& visits) const;
  void AddParentless(std::vector<Visit>& visits) const;
  Status AddNodes(const Json::Value& list, const std::string& where, const GltfTransform& parent,
    std::vector<Visit>& visits) const;
  Status AddNode(const Visit& visit, std::vector<Visit>& visits);
  Status ReadVisibility(const Json::Value& node, const std::string& where, bool& isVisible) const;
  Status ReadWeights(const Json::Value& node, GltfPlacement& placement) const;
  Status ReadPlace(const Json::Value& node, const std::string& where, GltfTransform& place) const;
  Status AddInstances(
    const Json::Value& attributes, const std::string& where, const GltfPlacement& node);
  Status ReadAttribute(const Json::Value& attributes, const char* name, const char* type,
    const std::string& where, std::vector<double>& values, std::int64_t& count);

  GltfDocument& Document;
  std::vector<GltfPlacement>* Placements = nullptr;
  std::vector<bool> IsVisited; // by node
};

} // namespace helios

#endif
