// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// CGAL's tree of axis-aligned boxes over the triangles of a scene.

#ifndef heliosCgalTree_h
#define heliosCgalTree_h

#include "heliosTriangleTest.h"

#include <cstddef>
#include <memory>

namespace helios
{

class StopCheck;
class TriangleMesh;

class CgalTree
{
public:
  CgalTree();
  ~CgalTree();

  /// Builds over the triangles of a mesh that have an area; the mesh must outlive it. Throws
  /// Stopped on an abort request.
  void Build(const TriangleMesh& mesh, StopCheck& check);

  /// Returns the hit with the smallest range and, of equals, the smallest triangle; triangle -1 for
  /// a miss.
  vtkHeliosHit Intersect(const vtkHeliosRay& ray) const;

  bool IsOccluded(const vtkHeliosRay& ray) const;

  std::size_t GetMemorySize() const;

private:
  struct Internals;
  std::unique_ptr<Internals> State;
};

} // namespace helios

#endif
