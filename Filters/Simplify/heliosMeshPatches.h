// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Splits a scene into patches that can be simplified separately and still fit together.

#ifndef heliosMeshPatches_h
#define heliosMeshPatches_h

#include "heliosMeshDecimation.h"

#include <vector>

namespace helios
{

/// A scene without triangles of zero area, duplicate triangles or points at equal coordinates.
struct PatchSource
{
  const double* Points;
  vtkIdType NumberOfPoints;
  std::vector<vtkTypeInt32> Corners; ///< three per triangle
  std::vector<int> Parts;            ///< one per triangle
  std::vector<int> Materials;        ///< one per triangle
};

/**
 * Two triangles of one part and material are connected if they alone share an edge, with consistent
 * winding. All other edges are seams: borders of the surface, of parts and of materials,
 * non-manifold edges. A patch is a connected component. Points on seams are locked, and points
 * where two fans of triangles meet; each fan has its own copy, so that OpenMesh gets a manifold.
 * Triangles at edges of more than two triangles are locked entirely, and counted.
 */
class MeshPatches
{
public:
  /// Throws Stopped, as MakePatch() does, if the stop check returns true.
  MeshPatches(const PatchSource& source, StopCheck& check);

  /// Returns the number of triangles at edges of more than two triangles.
  vtkIdType GetNumberOfNonManifoldTriangles() const { return this->NonManifold; }

  /// Triangles that no decimation can change: of patches whose points are all locked, ascending.
  const std::vector<vtkIdType>& GetFixedTriangles() const { return this->Fixed; }

  /// @{
  /// Returns the patches with at least one removable point, the largest first.
  std::size_t GetNumberOfPatches() const { return this->Begins.size() - 1; }
  vtkIdType GetNumberOfTriangles(std::size_t patch) const
  {
    return static_cast<vtkIdType>(this->Begins[patch + 1] - this->Begins[patch]);
  }
  Patch MakePatch(std::size_t patch, StopCheck& check) const;
  ///@}

private:
  void Join(StopCheck& check);
  void Lock();
  void Sort();

  const PatchSource& Source;
  vtkIdType NonManifold = 0;
  std::vector<vtkTypeInt32> Fans;       ///< per corner: the lowest corner of the same fan
  std::vector<vtkTypeInt32> Components; ///< per triangle: the lowest triangle of the same patch
  std::vector<bool> IsLocked;           ///< points of the scene
  std::vector<vtkIdType> Fixed;
  std::vector<vtkIdType> Sorted; ///< triangles, patch by patch
  std::vector<std::size_t> Begins;
};

} // namespace helios

#endif
