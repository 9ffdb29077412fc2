// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The meshes of a glTF document at their places.

#ifndef heliosGltfModel_h
#define heliosGltfModel_h

#include "heliosCutouts.h"
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
#include <utility>
#include <vector>

namespace helios
{

/// Adds the triangles of a document to an empty mesh, in the document's coordinates.
class GltfModel
{
public:
  GltfModel(SceneMesh& mesh, TextReport& report)
    : Mesh(mesh)
    , Report(report)
  {
  }

  /// Runs with the fraction of the placements; false stops reading.
  std::function<bool(double)> OnBlock;

  /// Returns false after an error, which is in the report.
  bool Read(const std::string& path);

  /// Replaces the triangles of materials that are cut or blended. False after an error.
  bool ApplyCutouts();

private:
  /// A mesh, and the weights of its morph targets.
  using MeshKey = std::pair<std::int64_t, std::vector<double>>;

  static MeshKey GetKey(const GltfPlacement& placement)
  {
    return { placement.Mesh, placement.Weights };
  }
  Status ReadFile(const std::string& path);
  Status ReadMaterials();
  Status ReadMeshes();
  Status CheckSize() const;
  Status AddMeshes();
  Status AddMesh(const GltfPlacement& placement);
  void AddTextures(const GltfMesh& mesh, bool isMirrored);
  int FindRow(int material);
  void WarnOfMotion();

  SceneMesh& Mesh;
  TextReport& Report;
  GltfDocument Document;
  std::vector<GltfPlacement> Placements;
  std::map<MeshKey, GltfMesh> Meshes; // meshes that are placed
  std::vector<Cutout> Cutouts;
  std::vector<int> TextureSets; // sets of texture coordinates of materials; -1: none
  int DefaultRow = -1;          // row of triangles without material; -1: none yet
};

} // namespace helios

#endif
