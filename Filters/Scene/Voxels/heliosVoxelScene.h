// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Data arrays of the triangles of solid voxels.

#ifndef heliosVoxelScene_h
#define heliosVoxelScene_h

#include "heliosVoxelMesh.h"

class vtkPolyData;

namespace helios
{

struct VoxelSceneOptions
{
  int NumberOfMaterials = 1;
  bool HasVoxelIds = false;
  bool HasNormals = false;
  bool HasColors = false;
  Vec3 DefaultNormal{ 0.0, 0.0, 0.0 }; ///< unit vector; 0 0 0: normal of the faces
};

/// Writes triangles, their arrays and the materials.
void WriteVoxelScene(const VoxelGrid& grid, const std::vector<VoxelMap::Entry>& cells,
  const VoxelMesh& mesh, const VoxelSceneOptions& options, vtkPolyData* scene);

} // namespace helios

#endif
