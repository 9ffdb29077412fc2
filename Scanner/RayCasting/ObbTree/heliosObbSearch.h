// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// VTK's tree of oriented boxes over the triangles of a scene.

#ifndef heliosObbSearch_h
#define heliosObbSearch_h

#include "heliosTriangleTest.h"

#include <vtkNew.h>
#include <vtkOBBTree.h>
#include <vtkPolyData.h>

#include <cstddef>
#include <vector>

namespace helios
{

class TriangleMesh;

class ObbSearch
{
public:
  /// Builds over the triangles of a mesh that have an area; the mesh must outlive it.
  void Build(const TriangleMesh& mesh);

  /// Returns a hit found by the tree, with the range of the common test; triangle -1 for a miss.
  vtkHeliosHit Intersect(const vtkHeliosRay& ray) const;

  bool IsOccluded(const vtkHeliosRay& ray) const { return this->Intersect(ray).CellId >= 0; }

  std::size_t GetMemorySize() const;

private:
  bool Clip(const TestRay& ray, double from[3], double to[3]) const;

  const TriangleMesh* Mesh = nullptr;
  double Bounds[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  double Middle[3] = { 0.0, 0.0, 0.0 };
  double Tolerance = 0.0; // [m]
  std::vector<vtkTypeInt32> Triangles;
  vtkNew<vtkPolyData> Local; // about Middle
  vtkNew<vtkOBBTree> Tree;
};

} // namespace helios

#endif
