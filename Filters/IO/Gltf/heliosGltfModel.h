// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The meshes of a glTF document at their places.

#ifndef heliosGltfModel_h
#define heliosGltfModel_h

#include "heliosCutouts.h"
#include "heliosGltfAnimation.h"
#include "heliosGltfDocument.h"
#include "heliosGltfMesh.h"
#include "heliosGltfNodes.h"
#include "heliosSceneMesh.h"
#include "heliosStatus.h"
#include "heliosTextFile.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace helios
{

/// Adds the triangles of a document to an empty mesh, in the document's coordinates.
class GltfModel
{
public:
  /// The document must be read, and outlive it, as must the animation, whose pose meshes have; null:
  /// none, and skins are not applied.
  GltfModel(
    GltfDocument& document, const GltfAnimation* animation, SceneMesh& mesh, TextReport& report)
    : Document(document)
    , Animation(animation)
    , Mesh(mesh)
    , Report(report)
  {
  }

  /// Runs with the fraction of the placements; false stops reading.
  std::function<bool(double)> OnBlock;

  /// Returns false after an error, which is in the report.
  bool Read();

  /// Replaces the triangles of materials that are cut or blended. False after an error.
  bool ApplyCutouts();

private:
  /// A mesh, the weights of its morph targets, and whether a skin moves it.
  using MeshKey = std::tuple<std::int64_t, std::vector<double>, bool>;

  static MeshKey GetKey(const GltfPlacement& placement)
  {
    return { placement.Mesh, placement.Weights, placement.Skin >= 0 };
  }
  Status ReadDocument();
  Status ReadMaterials();
  Status ReadMeshes();
  Status CheckSize() const;
  Status AddMeshes();
  Status AddMesh(const GltfPlacement& placement);
  Status AddPoints(const GltfPlacement& placement, const GltfMesh& mesh);
  void AddTextures(const GltfMesh& mesh, bool isMirrored);
  int FindRow(int material);
  void WarnOfMotion();

  GltfDocument& Document;
  const GltfAnimation* Animation;
  SceneMesh& Mesh;
  TextReport& Report;
  std::vector<GltfPlacement> Placements;
  std::map<std::int64_t, std::vector<GltfTransform>> Joints; // matrices of the joints of skins
  std::map<MeshKey, GltfMesh> Meshes;                        // meshes that are placed
  std::vector<Cutout> Cutouts;
  std::vector<int> TextureSets; // sets of texture coordinates of materials; -1: none
  int DefaultRow = -1;          // row of triangles without material; -1: none yet
};

} // namespace helios

#endif
