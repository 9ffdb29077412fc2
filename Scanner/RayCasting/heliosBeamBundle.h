// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The rays of a beam on their way through a scene, as one.

#ifndef heliosBeamBundle_h
#define heliosBeamBundle_h

#include "heliosBeamTree.h"
#include "heliosRayLanes.h"

#include <cstdint>

namespace helios
{

/**
 * Of the triangles of a leaf, only those are tested in double that a ray may hit by the following
 * filter, in floats. A line through the middle of the bundle is the axis of a plane (x, y) across
 * Z; relative to it, ray i is at slope_i z, z being the distance along Z from where the rays come
 * from. With corners q = (x, y, z) the edge function of ray i at the edge q r is
 * (slope_i, 1) . (q x r), linear in the slope: its sign decides where it is beyond a bound of its
 * error, in which is all that floats round and the test in double allows.
 */
class BeamBundle
{
public:
  static constexpr int MaximumRays = 256;

  explicit BeamBundle(const BeamTree& tree)
    : Tree(tree)
  {
  }

  /// The first hits of rays.
  void Trace(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count);

private:
  struct Edges; // of the triangles of a leaf, for the filter

  void TraceParts(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count);
  bool Take(const vtkHeliosRay* rays, int count);
  bool SetFrame();
  double GetFarthest() const;
  void SetEdges(const BeamTree::Leaf& leaf, float limit, Edges& edges) const;
  bool Test(const BeamTree::Leaf& leaf, float limit);
  bool TestTriangle(
    vtkTypeInt32 triangle, const std::uint32_t* possible, const std::uint32_t* certain);
  template <typename SeenT>
  void TestQuad(RayLanes& lanes, std::uint32_t possible, std::uint32_t certain,
    vtkTypeInt32 triangle, const TrianglePlane& plane, const SeenT& seen,
    std::uint32_t& better) const;

  const BeamTree& Tree;
  int Count = 0;
  int Quads = 0;
  RayAxes Axes;
  bool IsForward = true;
  bool HaveSameOrigin = false;
  RayLanes Lanes[MaximumRays / QuadWidth];
  std::uint32_t Valid[MaximumRays / QuadWidth]; ///< a byte for each lane
  Frustum Hull;

  alignas(64) float Slopes[2][MaximumRays]; ///< of the rays relative to the axis
  float Place[3];                           ///< of the axis at s = 0, along X, Y, Z
  float Slope[2];                           ///< of the axis, for a unit along Z
  float Depth;                              ///< z at s = 0
  float Spread[2];                          ///< the largest of the slopes
  float Error;                              ///< of the place of a ray
};

} // namespace helios

#endif
