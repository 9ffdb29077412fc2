// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The rays of a beam, traversing a scene as one, within a frustum drawn in heliosBeamTree.h. For
// sources only, as heliosLeafFilter.h.

#ifndef heliosBeamBundle_h
#define heliosBeamBundle_h

#include "heliosBeamTree.h"
#include "heliosLeafFilter.h"
#include "heliosRayLanes.h"

#include <cstdint>

namespace helios
{

/**
 * Only the triangles of a leaf that a ray may hit by LeafFilter are tested in double, in quads of
 * four rays. The filter tests groups of eight rays; large bundles in blocks of adjacent groups
 * first.
 */
class VTKHELIOSSCANNERRAYCASTING_EXPORT BeamBundle
{
public:
  static constexpr int MaximumRays = 256;

  explicit BeamBundle(const BeamTree& tree)
    : Tree(tree)
  {
  }

  /// The first hits of rays in the tree, without its outliers.
  void Trace(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count);

private:
  static constexpr int GroupWidth = 8; ///< rays per filter pass

  void TraceParts(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count);
  bool GatherRays(const vtkHeliosRay* rays, int count);
  bool SetFrame();
  void SetBlocks();
  double GetFarthest() const;
  void GetHits(vtkHeliosHit* hits) const;
  vtkTypeUInt64 FindBlocks(const LeafFilter::Edges& edges, int triangle) const;
  std::uint32_t FindGroups(
    const LeafFilter::Edges& edges, int triangle, int first, int last, std::uint32_t* bytes) const;
  std::uint32_t FindGroups(
    const LeafFilter::Edges& edges, int triangle, std::uint32_t* bytes) const;
  bool Test(const BeamTree::Leaf& leaf, float limit);
  bool TestTriangle(vtkTypeInt32 triangle, std::uint32_t groups, const std::uint32_t* bytes);
  template <typename SeenT>
  void TestQuad(RayLanes& lanes, std::uint32_t bytes, vtkTypeInt32 triangle,
    const TrianglePlane& plane, const SeenT& seen, Masks& better) const;

  const BeamTree& Tree;
  int Count = 0;
  int Quads = 0;
  RayAxes Axes;
  bool IsForward = true;
  bool HaveSameOrigin = false;
  RayLanes Lanes[MaximumRays / QuadWidth]; ///< padded with the last ray
  Frustum Hull;

  LeafFilter Filter;
  alignas(64) float Slopes[2][MaximumRays]; ///< of the rays relative to the filter's axis

  static constexpr int MaximumBlocks = 8;
  static constexpr int GroupsPerBlock = MaximumRays / GroupWidth / MaximumBlocks;
  int Blocks = 1;
  float Middle[2][MaximumBlocks]; ///< of the slopes of a block, if any
  float Half[2][MaximumBlocks];   ///< from there to its sides
};

} // namespace helios

#endif
