// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The nodes of a glTF scene: where its meshes are.

#ifndef heliosGltfNodes_h
#define heliosGltfNodes_h

#include "heliosGltfDocument.h"
#include "heliosGltfTransform.h"
#include "heliosStatus.h"

#include <cstdint>
#include <map>
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
  std::int64_t Skin = -1;        ///< the skin that moves it in place of the node; -1: none
};

class GltfAnimation;

/// Finds the placements of the default scene; without scenes, of all nodes. Nodes that are not
/// visible are left out, with their children. With an animation they are where it poses them, and skins
/// move meshes.
class GltfNodes
{
public:
  explicit GltfNodes(GltfDocument& document, const GltfAnimation* animation = nullptr)
    : Document(document)
    , Animation(animation)
  {
  }

  Status Find(std::vector<GltfPlacement>& placements);

  /// Returns the place of a node that was found; null: it is not in the scene.
  const GltfTransform* FindPlace(std::int64_t node) const
  {
    const auto found = this->Places.find(node);
    return found == this->Places.end() ? nullptr : &found->second;
  }

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
  Status ReadPlace(const Json::Value& node, std::int64_t index, GltfTransform& place) const;
  Status AddInstances(
    const Json::Value& attributes, const std::string& where, const GltfPlacement& node);
  Status ReadAttribute(const Json::Value& attributes, const char* name, const char* type,
    const std::string& where, std::vector<double>& values, std::int64_t& count);

  GltfDocument& Document;
  std::vector<GltfPlacement>* Placements = nullptr;
  const GltfAnimation* Animation;               // null: none
  std::vector<bool> IsVisited;                  // by node
  std::map<std::int64_t, GltfTransform> Places; // places of nodes, if they are animated
};

} // namespace helios

#endif
