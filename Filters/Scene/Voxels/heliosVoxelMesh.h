// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The surface of solid voxels as triangles.

#ifndef heliosVoxelMesh_h
#define heliosVoxelMesh_h

#include "heliosVoxelGrid.h"

#include <vtkType.h>

#include <cstdint>
#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * Two triangles for every face between a solid cell and an empty one, wound outward; cells share
 * corner points, so that the surface is closed. Cells are sorted by key, triangles by cell.
 */
class VoxelMesh
{
public:
  explicit VoxelMesh(const std::vector<VoxelMap::Entry>& cells);

  vtkIdType GetNumberOfTriangles() const { return this->NumberOfTriangles; }

  /// Writes points and polys, in 32-bit storage.
  void Write(const double origin[3], double size, vtkPolyData* scene) const;

  /// Calls visit(cell, side) for every triangle; cells count from 0, side is 2 axis + (1: upper).
  template <typename Visitor>
  void ForEachTriangle(Visitor&& visit) const
  {
    for (std::size_t cell = 0; cell < this->Faces.size(); ++cell)
    {
      for (int side = 0; side < 6; ++side)
      {
        if (this->Faces[cell] & (1u << side))
        {
          visit(cell, side);
          visit(cell, side);
        }
      }
    }
  }

private:
  void OpenFaces(int side);

  const std::vector<VoxelMap::Entry>& Cells;
  std::vector<std::uint8_t> Faces; // by cell: bit 2 axis + (1: the upper side)
  vtkIdType NumberOfTriangles = 0;
};

} // namespace helios

#endif
