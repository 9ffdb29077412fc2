// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A binary bounding volume hierarchy over triangles, in double precision.

#ifndef heliosBvh_h
#define heliosBvh_h

#include "heliosPose.h"
#include "heliosStopCheck.h"
#include "heliosTriangleTest.h"

#include <vtkType.h>

#include <vector>

namespace helios
{

class TriangleMesh;

/**
 * No hit of TestTriangle is lost: boxes are widened, node by node, by the tolerance of the test
 * (BoxSlack), and by monotone rounding a node is never entered later than the box of a triangle in
 * it, to which the test clamps ranges.
 */
class VTKHELIOSSCANNERRAYCASTING_EXPORT Bvh
{
public:
  /// Builds over the triangles of a mesh that have an area; the mesh must outlive it. Both throw
  /// Stopped on an abort request; the tree is then unusable until rebuilt.
  void Build(const TriangleMesh& mesh, StopCheck& check);
  void Build(const TriangleMesh& mesh)
  {
    StopCheck never(nullptr);
    this->Build(mesh, never);
  }

  /// Builds over some triangles of a mesh, all of which have an area.
  void Build(const TriangleMesh& mesh, std::vector<vtkTypeInt32> triangles, StopCheck& check);

  /// Returns the hit with the smallest range and, of equals, the smallest triangle; triangle -1 for
  /// a miss.
  vtkHeliosHit Intersect(const TestRay& ray) const;

  bool IsOccluded(const TestRay& ray) const;

  /// Returns the distance from a segment to the nearest triangle; infinite if none is within reach.
  double GetDistance(const Vec3& a, const Vec3& b, double reach) const;

  std::size_t GetMemorySize() const;

  const std::vector<vtkTypeInt32>& GetTriangles() const { return this->Order; }

private:
  typedef double Pair __attribute__((vector_size(16)));

  /// Child i covers Low[axis][i] to High[axis][i]: Count triangles of the order from First, or
  /// with a Count of zero the node First.
  struct Node
  {
    Pair Low[3];
    Pair High[3];
    vtkTypeInt32 First[2];
    vtkTypeInt32 Count[2];
  };
  class Builder;
  struct Part;
  class NearestSearch;

  void Append(const Part& part);
  template <typename PrimitivesT>
  void BuildParts(std::vector<Part>& parts, PrimitivesT& primitives, StopCheck& check);

  template <typename VisitT>
  void Traverse(const TestRay& ray, const double& range, VisitT visit) const;

  const TriangleMesh* Mesh = nullptr;
  std::vector<vtkTypeInt32> Order;
  std::vector<Node> Nodes;
};

} // namespace helios

#endif
