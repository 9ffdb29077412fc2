// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A wide bounding volume hierarchy that a ray bundle, or a cone, traverses once.

#ifndef heliosBeamTree_h
#define heliosBeamTree_h

#include "heliosBeamStorage.h"
#include "heliosBvh.h"
#include "heliosTriangleMesh.h"

#include <vtkType.h>

#include <array>
#include <memory>
#include <vector>

namespace helios
{

class BoxRefit;
class HeightField;
class HeightTree;
struct MeshShape;
struct RefitOrder;

/**
 * The bounds of a bundle's rays: they lie in a frustum about one of the axes, Z. At a distance s
 * along Z the frustum reaches from Low + s SlopeLow to High + s SlopeHigh along X and Y. Numbers
 * are floats in the frame of the tree, rounded outwards; s starts where the frustum reaches the box
 * of the tree. LeafFilter gives each ray by its slope relative to the axis, the line through the
 * middle of the rays.
 *
 *   X ^                                              __..--''  High + s SlopeHigh
 *     |                      +---------------__..--''---+
 *     |                 High |       __..--''           |
 *     |                   __.+.--''             ____....|----''  a ray: slope of the axis
 *     |           __..--''   |  ____....----''''        |          and its own
 *     | origins  o ----------+--------------------------|------  axis
 *     |           ''--..__   |                          |
 *     |                   ''-+-..__                     |
 *     |                  Low |     ''--..__             |  box of the tree
 *     |                      +-------------''--..__-----+
 *     |                                            ''--..__  Low + s SlopeLow
 *     +----------+-----------+--------------------------------> Z
 *                |<- Start ->| s = 0
 *
 * No hit of TestTriangle is lost: origins are widened by Slack, which covers the tolerance of the
 * test (BoxSlack) and the rounding of these numbers.
 */
struct Frustum
{
  RayAxes Axes;
  bool IsForward; ///< along Z
  float Low[3];   ///< at s = 0, along X, Y, Z
  float High[3];
  float SlopeLow[2]; ///< along X and Y, for a unit along Z
  float SlopeHigh[2];
  double Start; ///< s = 0, in units of the scene from the origins
  double Slack; ///< in units of the scene
  double Scale;

  /// Returns the limit of s for a distance along Z from the origins.
  float GetLimit(double distance) const;
};

/**
 * Boxes of eight children and corners have ten bits an axis within their node or leaf, in a frame
 * local to the scene; boxes are rounded outwards, and triangles are tested in double. Triangles that
 * reach far out of the scene are kept in a tree of doubles.
 * Over a height field, nodes, leaves and corners are computed on demand; triangles are its slots.
 * Over a mesh that deforms, nodes are fitted to where its points are over a part of the way between two
 * frames, and corners are interpolated on demand.
 */
class VTKHELIOSSCANNERRAYCASTING_EXPORT BeamTree
{
public:
  /// The maximum number of triangles: leaves are indexed by 32-bit words.
  static constexpr vtkIdType MaximumTriangles = 200000000;

  /// Builds over the triangles of a mesh that have an area; the mesh must outlive it. Empty if
  /// there are too many. Throws Stopped on an abort request, and is then unusable.
  void Build(const TriangleMesh& mesh, StopCheck& check);

  /// Builds without outliers: all triangles are in the tree of floats, up to leafSize in a leaf.
  void BuildWhole(const TriangleMesh& mesh, StopCheck& check, int leafSize = BeamLeaf::Size);

  /// Builds over a height field, which must outlive it.
  void Build(const HeightField& field);

  /// Builds over boxes x0 x1 y0 y1 z0 z1, as triangles without corners, one in a leaf: ten times as
  /// fast as over a mesh, less tight.
  void Build(const std::vector<std::array<double, 6>>& boxes);

  /// Builds over triangles of a mesh that deforms within a box, with or without area. All in a leaf that is
  /// entered are visited. The mesh must outlive it.
  void BuildShape(const TriangleMesh& mesh, const std::vector<vtkTypeInt32>& triangles,
    const double bounds[6], StopCheck& check);

  /// Copies a tree of BuildShape(), which a shape is given that must outlive it.
  void CopyShape(const BeamTree& other, const MeshShape& shape);

  /// Fits the nodes of a tree of CopyShape() to its shape at the fractions from low to high.
  void Fit(const RefitOrder& order, double low, double high, BoxRefit& refit);

  const BeamStorage& GetStorage() const { return this->Storage; }

  bool HasOutliers() const { return this->OutliersExist; }

  /// Returns the first hit of the outliers.
  vtkHeliosHit IntersectOutliers(const TestRay& ray) const { return this->Outliers.Intersect(ray); }
  bool IsOccludedByOutliers(const TestRay& ray) const
  {
    return this->OutliersExist && this->Outliers.IsOccluded(ray);
  }

  std::size_t GetMemorySize() const;

  bool IsOfHeights() const { return this->Heights != nullptr; }

  /// Returns the corners of a triangle, in the buffer if they are not stored.
  void GetPoints(vtkTypeInt32 triangle, double buffer[3][3], const double* points[3]) const
  {
    if (!this->IsComputed)
    {
      points[0] = this->Mesh->GetCorner(triangle, 0);
      points[1] = this->Mesh->GetCorner(triangle, 1);
      points[2] = this->Mesh->GetCorner(triangle, 2);
      return;
    }
    this->ComputePoints(triangle, buffer);
    points[0] = buffer[0];
    points[1] = buffer[1];
    points[2] = buffer[2];
  }

  /// Prefetches the numbers of the corners of a triangle; then the corners.
  void PrefetchNumbers(vtkTypeInt32 triangle) const
  {
    if (!this->IsOfHeights())
    {
      __builtin_prefetch(this->Mesh->GetCorners() + 3 * static_cast<vtkIdType>(triangle));
    }
  }
  void PrefetchPoints(vtkTypeInt32 triangle) const
  {
    for (int corner = 0; corner < 3 && !this->IsOfHeights(); ++corner)
    {
      __builtin_prefetch(this->Mesh->GetCorner(triangle, corner));
    }
  }

  /// Returns the cell of a triangle in the scene.
  vtkIdType GetCell(vtkIdType triangle) const
  {
    return this->IsOfHeights() ? this->ComputeCell(triangle) : triangle;
  }

  /// Returns the corners of a cell.
  void GetCellPoints(vtkIdType cell, double points[3][3]) const;

  /// Returns the outlier triangles.
  const std::vector<vtkTypeInt32>& GetOutliers() const { return this->Outliers.GetTriangles(); }

  /// Returns whether no triangle is in the tree, except the outliers.
  bool IsEmpty() const { return this->Frame.Scale == 0.0; }

  /**
   * Sets all but the axes and direction of a frustum from intervals along X, Y, Z: of
   * origins, and of slopes per unit along Z. False if the tree is empty. Error: by which rays and
   * triangles may be off, in addition to the tolerance of the test.
   */
  bool SetFrustum(Frustum& frustum, const double low[3], const double high[3],
    const double slopeLow[2], const double slopeHigh[2], double error = 0.0) const;

  /// Sets the frustum of one ray.
  bool SetFrustum(Frustum& frustum, const TestRay& ray, double error) const;

  /// Returns the largest coordinate of its corners, without the sign.
  double GetReach() const;

  /// Returns a coordinate along an axis in the frame of the tree.
  double GetLocal(double x, int axis) const { return this->Frame.GetLocal(x, axis); }

  static constexpr int Width = BeamNode::Width;
  static constexpr int LeafSize = BeamLeaf::Size;
  using Leaf = BeamLeaf;

private:
  friend class BeamWalk;
  struct Block;

  static constexpr vtkTypeUInt32 LeafBit = BeamNode::LeafBit;

  void BuildNodes(const double box[6], StopCheck& check, int leafSize);
  void OpenLeaves();
  void Prefetch(vtkTypeUInt32 child) const;
  void ComputePoints(vtkTypeInt32 triangle, double points[3][3]) const;
  vtkIdType ComputeCell(vtkIdType triangle) const;

  const TriangleMesh* Mesh = nullptr;
  TreeFrame Frame;
  BeamStorage Storage;
  bool OutliersExist = false;
  Bvh Outliers;
  bool IsComputed = false;                   ///< whether corners are computed, not stored
  std::shared_ptr<const HeightTree> Heights; ///< null: over a mesh
  const MeshShape* Shape = nullptr;          ///< null: over a mesh that does not deform
};

/// Traverses a tree along a frustum, from front to back.
class VTKHELIOSSCANNERRAYCASTING_EXPORT BeamWalk
{
public:
  BeamWalk(const BeamTree& tree, const Frustum& frustum);

  /// Finds the next leaf that the frustum enters at or before a limit; false after the last.
  bool GetNext(float limit, BeamTree::Leaf& leaf);

private:
  struct Entry
  {
    float Near;
    vtkTypeUInt32 Child;
  };
  /**
   * Limits along an axis at (a side of a child - Origin) Factor: by its high sides s0, at which the
   * frustum's lower side passes it, by its low sides s1; an entry or an exit. Along Z the near and the
   * far end.
   */
  struct Sides
  {
    float Origin[4]; ///< along x, y, z; the fourth is to be ignored
    float Factor[4];
  };
  struct Kind
  {
    bool IsEntry[2]; ///< whether the limit by the high sides is an entry; by the low ones
  };
  template <bool IsOfHeights>
  const auto& GetNode(vtkTypeUInt32 number);
  template <bool IsOfHeights>
  BeamLeaf GetLeaf(vtkTypeUInt32 number);
  template <bool IsOfHeights>
  void Push(const vtkTypeUInt32* children, vtkTypeUInt64 bits, const float* nears);
  template <bool IsOfHeights>
  bool FindNext(float limit, BeamTree::Leaf& leaf);

  static constexpr int StackSize = 8 + 90 * (BeamTree::Width - 1);

  const BeamTree& Tree;
  const HeightTree* Heights; ///< null: over a mesh
  RayAxes Axes;
  bool IsForward;
  Sides Highs;   ///< high sides of children
  Sides Lows;    ///< low sides of children
  Kind Kinds[2]; ///< along X and Y
  int Size = 0;
  Entry Stack[StackSize];
  BeamNode NodeOfHeights; ///< computed last
  BeamLeafData LeafOfHeights;
};

} // namespace helios

#endif
