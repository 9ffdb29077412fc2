// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The rays of a bundle against the triangles of a leaf.
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBeamBundle.h"

#include "heliosRayVectors.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

typedef EightFloats Group;
typedef EightMasks GroupMasks;

/// Classifies lanes by the signs of all edge functions, within the error: 0 outside, -1 unresolved,
/// -2 inside.
HELIOS_INLINE GroupMasks Compare(const Group e[3], const Group& error)
{
  const Group minimum = Min(Min(e[0], e[1]), e[2]);
  const Group maximum = Max(Max(e[0], e[1]), e[2]);
  const GroupMasks possible = (minimum >= -error) | (maximum <= error);
  const GroupMasks certain = (minimum > error) | (maximum < -error);
  return possible + certain;
}

/// The lowest bits of the bytes of four lanes: set for unresolved ones.
constexpr std::uint32_t Perhaps = 0x01010101;

/// The triangle data that depend on the ray origins: per lane, or one for all.
template <typename PlaceT>
struct Seen
{
  PlaceT Corners[3][3];
  RangeTerms<PlaceT> Terms;

  HELIOS_INLINE void SetCorners(const PlaceT origin[3], const double* const points[3])
  {
    ComputeOffsets<PlaceT>(origin, points, this->Corners);
  }
};

} // namespace

/// Keeps better hits with a triangle in lanes that may be inside, one byte per lane.
template <typename SeenT>
HELIOS_INLINE void BeamBundle::TestQuad(RayLanes& lanes, std::uint32_t bytes, vtkIdType cell,
  const TrianglePlane& plane, const SeenT& seen, Masks& better) const
{
  Masks inside, isBetter;
  SetMasks(bytes, inside);
  if (bytes & Perhaps)
  {
    Doubles sheared[3][2], edges[3];
    GetEdgeFunctions(lanes, this->Axes, seen.Corners, sheared, edges);
    const Masks isPossible = inside;
    helios::GetInside(isPossible, sheared, edges, inside);
  }
  SelectBetter(lanes, inside, cell, plane, seen.Terms, isBetter);
  better |= isBetter;
}

/// Tests the groups with nonzero bytes in double; returns whether any ray has a better hit.
HELIOS_INLINE bool BeamBundle::TestTriangle(
  vtkTypeInt32 triangle, std::uint32_t groups, const std::uint32_t* bytes)
{
  double buffer[3][3];
  const double* points[3];
  this->Placed.GetPoints(triangle, buffer, points);
  const vtkIdType cell = this->Placed.GetCell(triangle);
  const TrianglePlane plane = GetPlane(points);
  Masks better = {};
  Seen<double> fromOne;
  if (this->HaveSameOrigin)
  {
    const double origin[3] = { this->Lanes[0].Origin[0][0], this->Lanes[0].Origin[1][0],
      this->Lanes[0].Origin[2][0] };
    fromOne.SetCorners(origin, points);
    fromOne.Terms.Set(plane, fromOne.Corners);
  }
  for (; groups != 0; groups &= groups - 1)
  {
    const int first = 2 * __builtin_ctz(groups);
    for (int quad = first; quad < first + 2; ++quad)
    {
      RayLanes& lanes = this->Lanes[quad];
      if (bytes[quad] == 0)
      {
        continue;
      }
      if (this->HaveSameOrigin)
      {
        this->TestQuad(lanes, bytes[quad], cell, plane, fromOne, better);
        continue;
      }
      Seen<Doubles> seen;
      seen.SetCorners(lanes.Origin, points);
      seen.Terms.Set(plane, seen.Corners);
      this->TestQuad(lanes, bytes[quad], cell, plane, seen, better);
    }
  }
  return Any(better);
}

/// Returns the edge functions of a triangle at slopes.
HELIOS_INLINE void GetEdges(
  const LeafFilter::Edges& edges, int triangle, const Group& dx, const Group& dy, Group e[3])
{
  for (int k = 0; k < 3; ++k)
  {
    const auto& terms = edges.Terms[k];
    e[k] = dx * terms[0][triangle] + dy * terms[1][triangle] + terms[2][triangle];
  }
}

/// Returns the blocks with rays that may hit a triangle, one byte per block.
HELIOS_INLINE vtkTypeUInt64 BeamBundle::FindBlocks(
  const LeafFilter::Edges& edges, int triangle) const
{
  static_assert(MaximumBlocks == GroupWidth, "blocks are asked for as a group");
  Group e[3];
  GetEdges(edges, triangle, Load<Group>(this->Middle[0]), Load<Group>(this->Middle[1]), e);
  const Group halfX = Load<Group>(this->Half[0]);
  const Group halfY = Load<Group>(this->Half[1]);
  GroupMasks positive = GroupMasks() - 1;
  GroupMasks negative = positive;
  for (int k = 0; k < 3; ++k)
  {
    const auto& terms = edges.Terms[k];
    // Twice the error: of the rays, and of the middle.
    const Group reach = halfX * std::abs(terms[0][triangle]) +
      halfY * std::abs(terms[1][triangle]) + 2.0f * edges.Error[triangle];
    positive = positive & (e[k] >= -reach);
    negative = negative & (e[k] <= reach);
  }
  return GetBytes(positive | negative);
}

/// Compares the rays of groups with a triangle: one byte per ray. Returns the groups with possible
/// hits, one bit per group.
HELIOS_INLINE std::uint32_t BeamBundle::FindGroups(
  const LeafFilter::Edges& edges, int triangle, int first, int last, std::uint32_t* bytes) const
{
  std::uint32_t groups = 0;
  for (int group = first; group < last; ++group)
  {
    Group e[3];
    GetEdges(edges, triangle, Load<Group>(this->Slopes[0] + GroupWidth * group),
      Load<Group>(this->Slopes[1] + GroupWidth * group), e);
    const vtkTypeUInt64 both = GetBytes(Compare(e, Group() + edges.Error[triangle]));
    groups |= (both != 0 ? 1u : 0u) << group;
    Store(bytes + 2 * group, both);
  }
  return groups;
}

/// Returns the groups with rays that may hit a triangle, among all groups or the groups of
/// candidate blocks.
HELIOS_INLINE std::uint32_t BeamBundle::FindGroups(
  const LeafFilter::Edges& edges, int triangle, std::uint32_t* bytes) const
{
  const int count = (this->Quads + 1) / 2;
  if (this->Blocks == 1)
  {
    return this->FindGroups(edges, triangle, 0, count, bytes);
  }
  std::uint32_t groups = 0;
  for (vtkTypeUInt64 blocks = this->FindBlocks(edges, triangle); blocks != 0;)
  {
    const int block = __builtin_ctzll(blocks) / 8;
    blocks &= ~(vtkTypeUInt64(0xff) << 8 * block);
    const int first = block * GroupsPerBlock;
    groups |=
      this->FindGroups(edges, triangle, first, std::min(first + GroupsPerBlock, count), bytes);
  }
  return groups;
}

/// Tests the triangles of a leaf; returns whether any ray has a better hit.
HELIOS_CLONES
bool BeamBundle::Test(const BeamTree::Leaf& leaf, float limit)
{
  const BeamTree& tree = this->Placed.GetTree();
  for (int i = 0; i < leaf.Count; ++i)
  {
    tree.PrefetchNumbers(leaf.Triangles[i]);
  }
  LeafFilter::Edges edges;
  this->Filter.SetEdges(leaf, limit, edges);
  for (int i = 0; i < leaf.Count; ++i)
  {
    if (edges.IsAlive[i])
    {
      tree.PrefetchPoints(leaf.Triangles[i]);
    }
  }
  bool isBetter = false;
  for (int i = 0; i < leaf.Count; ++i)
  {
    std::uint32_t bytes[MaximumRays / QuadWidth];
    const std::uint32_t groups = edges.IsAlive[i] ? this->FindGroups(edges, i, bytes) : 0;
    if (groups != 0)
    {
      isBetter = this->TestTriangle(leaf.Triangles[i], groups, bytes) || isBetter;
    }
  }
  return isBetter;
}

} // namespace helios
