// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The rays of a beam, traversing a scene as one, within a frustum drawn in heliosBeamTree.h. For
// sources only, as heliosLeafFilter.h.

#ifndef heliosBeamBundle_h
#define heliosBeamBundle_h

#include "heliosBeamTree.h"
#include "heliosLeafFilter.h"
#include "heliosPlacedTree.h"
#include "heliosRayLanes.h"
#include "heliosSceneTree.h"

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

  explicit BeamBundle(const SceneTree& scene)
    : Scene(scene)
  {
  }

  /// Finds the first hits of rays in the scene, without the outliers of its mesh.
  void Trace(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count);

private:
  static constexpr int GroupWidth = 8; ///< rays per filter pass

  void TraceParts(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count);
  bool GatherRays(const vtkHeliosRay* rays, int count);
  void TraceTree(const PlacedTree& placed);
  void TraceEach();
  void TraceInstances(const BoxTree& boxes);
  void SetReach();
  bool MoveRays();
  bool SetFrame();
  void SetFilter();
  void SetIntervals(double low[3], double high[3], double slopeLow[2], double slopeHigh[2]);
  void SetSlopes(const double low[3], const double high[3]);
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
  void TestQuad(RayLanes& lanes, std::uint32_t bytes, vtkIdType cell, const TrianglePlane& plane,
    const SeenT& seen, Masks& better) const;

  /// Rays in the frame of the current tree.
  const RayTerms<Doubles>& GetRays(int quad) const
  {
    return this->Placed.IsMoved() ? this->Moved[quad] : this->Lanes[quad];
  }

  const SceneTree& Scene;
  int Count = 0;
  int Quads = 0;
  RayAxes Axes;
  bool HaveSameOrigin = false;
  RayLanes Lanes[MaximumRays / QuadWidth]; ///< padded with the last ray

  double Reach = 0.0; ///< largest distance of the origins, if there are instances

  PlacedTree Placed;                                ///< the current tree; and in its frame:
  RayTerms<Doubles> Moved[MaximumRays / QuadWidth]; ///< the rays, if it is an instance's
  RayAxes HullAxes;
  bool IsForward = true;
  bool HaveSamePlace = false; ///< the origins
  Frustum Hull;
  double Low[3], High[3]; ///< intervals of the rays: origins; slopes
  double SlopeLow[2], SlopeHigh[2];

  LeafFilter Filter;
  alignas(64) float Slopes[2][MaximumRays]; ///< slopes of the rays relative to the filter's axis

  static constexpr int MaximumBlocks = 8;
  static constexpr int GroupsPerBlock = MaximumRays / GroupWidth / MaximumBlocks;
  int Blocks = 1;
  float Middle[2][MaximumBlocks]; ///< middle of the slopes of a block, if any
  float Half[2][MaximumBlocks];   ///< from there to its sides
};

} // namespace helios

#endif
