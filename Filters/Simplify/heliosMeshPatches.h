// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene taken apart into pieces that can be simplified one by one and still fit together.

#ifndef heliosMeshPatches_h
#define heliosMeshPatches_h

#include "heliosMeshDecimation.h"

#include <vector>

namespace helios
{

/// A scene: no triangles without area or at the same place, no points at equal coordinates.
struct PatchSource
{
  const double* Points;
  vtkIdType NumberOfPoints;
  std::vector<vtkTypeInt32> Corners; ///< three a triangle
  std::vector<int> Parts;            ///< one a triangle
  std::vector<int> Materials;        ///< one a triangle
};

/**
 * Two triangles of one part and material hold together where an edge has these two and no other,
 * wound alike. All other edges are seams: borders of the surface, of parts and of materials,
 * non-manifold edges. A patch is what holds together. Points on seams are locked, and points where
 * two fans of triangles meet; each fan has its own copy, so that OpenMesh finds a manifold.
 * Triangles at edges of more than two triangles are locked altogether, and counted.
 */
class MeshPatches
{
public:
  /// Throws Stopped, as MakePatch() does, where it is told to stop.
  MeshPatches(const PatchSource& source, StopCheck& check);

  /// Number of triangles at edges of more than two triangles.
  vtkIdType GetNumberOfNonManifoldTriangles() const { return this->NonManifold; }

  /// Triangles that no decimation can change: of patches whose points are all locked, ascending.
  const std::vector<vtkIdType>& GetFixedTriangles() const { return this->Fixed; }

  ///@{
  /// The patches that have a point to take out, the largest first.
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
  std::vector<vtkTypeInt32> Fans;       ///< of corners: the lowest corner of the same fan
  std::vector<vtkTypeInt32> Components; ///< of triangles: the lowest triangle of the same patch
  std::vector<bool> IsLocked;           ///< points of the scene
  std::vector<vtkIdType> Fixed;
  std::vector<vtkIdType> Sorted; ///< triangles, patch by patch
  std::vector<std::size_t> Begins;
};

} // namespace helios

#endif
