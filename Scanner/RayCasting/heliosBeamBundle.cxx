// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBeamBundle.h"

#include "heliosTriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace helios
{

namespace
{

typedef EightFloats Group;
typedef EightMasks GroupMasks;

HELIOS_INLINE double GetLeast(const Doubles& v)
{
  return Min(Min(v[0], v[1]), Min(v[2], v[3]));
}

HELIOS_INLINE double GetMost(const Doubles& v)
{
  return Max(Max(v[0], v[1]), Max(v[2], v[3]));
}

/// The columns of the rows a, b, c, d.
HELIOS_INLINE void Transpose(const Doubles& a, const Doubles& b, const Doubles& c, const Doubles& d,
  Doubles& first, Doubles& second, Doubles& third, Doubles& fourth)
{
  constexpr Masks even = { 0, 4, 2, 6 }, odd = { 1, 5, 3, 7 };
  constexpr Masks low = { 0, 1, 4, 5 }, high = { 2, 3, 6, 7 };
  const Doubles evenAB = __builtin_shuffle(a, b, even), oddAB = __builtin_shuffle(a, b, odd);
  const Doubles evenCD = __builtin_shuffle(c, d, even), oddCD = __builtin_shuffle(c, d, odd);
  first = __builtin_shuffle(evenAB, evenCD, low);
  second = __builtin_shuffle(oddAB, oddCD, low);
  third = __builtin_shuffle(evenAB, evenCD, high);
  fourth = __builtin_shuffle(oddAB, oddCD, high);
}

/// Origin and the first of the direction; the direction and the range.
HELIOS_INLINE Doubles LoadOrigin(const vtkHeliosRay& ray)
{
  return Load<Doubles>(reinterpret_cast<const char*>(&ray));
}
HELIOS_INLINE Doubles LoadDirection(const vtkHeliosRay& ray)
{
  static_assert(sizeof(vtkHeliosRay) == 7 * sizeof(double), "a ray is read as two vectors");
  return Load<Doubles>(reinterpret_cast<const char*>(&ray) + offsetof(vtkHeliosRay, Direction));
}

/// Four rays into lanes.
HELIOS_INLINE void SetRays(const vtkHeliosRay& a, const vtkHeliosRay& b, const vtkHeliosRay& c,
  const vtkHeliosRay& d, RayLanes& lanes)
{
  Doubles* direction = lanes.Direction;
  Transpose(LoadOrigin(a), LoadOrigin(b), LoadOrigin(c), LoadOrigin(d), lanes.Origin[0],
    lanes.Origin[1], lanes.Origin[2], direction[0]);
  Transpose(LoadDirection(a), LoadDirection(b), LoadDirection(c), LoadDirection(d), direction[0],
    direction[1], direction[2], lanes.Range);
}

/// Of lanes by the signs of all edge functions, as far as the error tells: 0 outside, -1 perhaps, -2 inside.
HELIOS_INLINE GroupMasks Compare(const Group e[3], const Group& error)
{
  const Group least = Min(Min(e[0], e[1]), e[2]);
  const Group most = Max(Max(e[0], e[1]), e[2]);
  const GroupMasks possible = (least >= -error) | (most <= error);
  const GroupMasks certain = (least > error) | (most < -error);
  return possible + certain;
}
constexpr std::uint32_t Perhaps =
  0x01010101; // what the bytes of four lanes have that are perhaps inside

} // namespace

void BeamBundle::Trace(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count)
{
  if (!this->Take(rays, count))
  {
    this->TraceParts(rays, hits, count);
    return;
  }
  if (this->SetFrame())
  {
    BeamWalk walk(this->Tree, this->Hull);
    float limit = this->Hull.GetLimit(this->GetFarthest());
    BeamTree::Leaf leaf;
    while (walk.GetNext(limit, leaf))
    {
      if (this->Test(leaf, limit))
      {
        limit = this->Hull.GetLimit(this->GetFarthest());
      }
    }
  }
  this->GetHits(hits);
}

HELIOS_CLONES
void BeamBundle::GetHits(vtkHeliosHit* hits) const
{
  const int full = this->Count / QuadWidth;
  for (int quad = 0; quad < full; ++quad)
  {
    this->Lanes[quad].GetHits(hits + QuadWidth * quad, QuadWidth);
  }
  if (full < this->Quads)
  {
    this->Lanes[full].GetHits(hits + QuadWidth * full, this->Count % QuadWidth);
  }
}

/// Traces those rays together that run along the same axis.
void BeamBundle::TraceParts(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count)
{
  int keys[MaximumRays]; // the axis a ray runs along; negative for none
  for (int i = 0; i < count; ++i)
  {
    TestRay ray;
    const bool isUsable = ray.Set(rays[i]);
    keys[i] = isUsable ? 2 * ray.Axes.Z + (ray.Largest > 0.0 ? 1 : 0) : -1;
    hits[i] = { NoHit, -1 };
  }
  for (int key = 0; key < 6; ++key)
  {
    vtkHeliosRay part[MaximumRays];
    vtkHeliosHit partHits[MaximumRays];
    int size = 0;
    for (int i = 0; i < count; ++i)
    {
      if (keys[i] == key)
      {
        part[size++] = rays[i];
      }
    }
    if (size > 0)
    {
      this->Trace(part, partHits, size);
    }
    for (int i = count - 1; i >= 0; --i)
    {
      if (keys[i] == key)
      {
        hits[i] = partHits[--size];
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Fills the lanes; false where not all rays are usable and run along the same axis.
HELIOS_CLONES
bool BeamBundle::Take(const vtkHeliosRay* rays, int count)
{
  this->Count = count;
  this->Quads = (count + QuadWidth - 1) / QuadWidth;
  Masks isX, isY, isFine;
  Masks areFine = Masks() - 1;
  for (int quad = 0; quad < this->Quads; ++quad)
  {
    RayLanes& lanes = this->Lanes[quad];
    const int first = QuadWidth * quad;
    const int last = count - 1;
    SetRays(rays[first], rays[std::min(first + 1, last)], rays[std::min(first + 2, last)],
      rays[std::min(first + 3, last)], lanes);
    lanes.Triangle = Masks() + RayLanes::NoTriangle;
    SetTerms<Doubles, Masks>(lanes, isFine, isX, isY);
    if (quad == 0)
    {
      this->Axes = RayAxes(isX[0] ? 0 : (isY[0] ? 1 : 2));
      this->IsForward = lanes.Largest[0] > 0.0;
    }
    const Masks isSame = this->Axes.Z == 0 ? isX : (this->Axes.Z == 1 ? ~isX & isY : ~isX & ~isY);
    const Masks isForward = lanes.Largest > 0.0;
    areFine =
      areFine & isFine & isSame & (this->IsForward ? isForward : ~isForward) & (lanes.Range > 0.0);
  }
  return areFine[0] && areFine[1] && areFine[2] && areFine[3];
}

/// Sets the frustum and the filter; false where the frustum misses the tree.
HELIOS_CLONES
bool BeamBundle::SetFrame()
{
  const int axes[3] = { this->Axes.X, this->Axes.Y, this->Axes.Z };
  const double sign = this->IsForward ? 1.0 : -1.0;
  double low[3], high[3], slopeLow[2], slopeHigh[2];
  for (int i = 0; i < 3; ++i)
  {
    Doubles least = this->Lanes[0].Origin[axes[i]];
    Doubles most = least;
    for (int quad = 1; quad < this->Quads; ++quad)
    {
      least = Min(least, this->Lanes[quad].Origin[axes[i]]);
      most = Max(most, this->Lanes[quad].Origin[axes[i]]);
    }
    low[i] = GetLeast(least);
    high[i] = GetMost(most);
  }
  for (int i = 0; i < 2; ++i)
  {
    Doubles least = this->Lanes[0].Shear[i] * sign;
    Doubles most = least;
    for (int quad = 1; quad < this->Quads; ++quad)
    {
      least = Min<Doubles>(least, this->Lanes[quad].Shear[i] * sign);
      most = Max<Doubles>(most, this->Lanes[quad].Shear[i] * sign);
    }
    slopeLow[i] = GetLeast(least);
    slopeHigh[i] = GetMost(most);
  }
  this->Hull.Axes = this->Axes;
  this->Hull.IsForward = this->IsForward;
  if (!this->Tree.SetFrustum(this->Hull, low, high, slopeLow, slopeHigh))
  {
    return false;
  }
  this->HaveSameOrigin = low[0] == high[0] && low[1] == high[1] && low[2] == high[2];
  const double middle[2] = { 0.5 * low[0] + 0.5 * high[0], 0.5 * low[1] + 0.5 * high[1] };
  this->Filter.SetAxis(this->Tree, this->Hull, low, high, slopeLow, slopeHigh);
  double rest = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const double slope = this->Filter.GetSlope(i);
    Doubles most = Doubles();
    for (int quad = 0; quad < this->Quads; ++quad)
    {
      const RayLanes& lanes = this->Lanes[quad];
      const Doubles own = lanes.Shear[i] * sign;
      const Floats shortSlope = __builtin_convertvector(own - slope, Floats);
      Store(&this->Slopes[i][QuadWidth * quad], shortSlope);
      if (!this->HaveSameOrigin)
      {
        const Doubles ahead = this->Hull.Start + (low[2] - lanes.Origin[axes[2]]) * sign;
        const Doubles x =
          lanes.Origin[axes[i]] - middle[i] + own * ahead - slope * this->Hull.Start;
        const Doubles off = x * this->Hull.Scale - (own - slope) * this->Filter.GetDepth();
        most = Max(most, Max<Doubles>(off, -off));
      }
    }
    rest = Max(rest, GetMost(most));
  }
  if (!this->Filter.SetError(rest))
  {
    std::fill_n(this->Slopes[0], MaximumRays, 0.0f);
    std::fill_n(this->Slopes[1], MaximumRays, 0.0f);
  }
  if (this->Quads % 2 == 1) // a ray that hits nothing fills the last group
  {
    const Floats nowhere = Floats() + std::numeric_limits<float>::quiet_NaN();
    Store(&this->Slopes[0][QuadWidth * this->Quads], nowhere);
    Store(&this->Slopes[1][QuadWidth * this->Quads], nowhere);
  }
  this->SetBlocks();
  return true;
}

/// Sets the sides of blocks of neighbours.
HELIOS_INLINE void BeamBundle::SetBlocks()
{
  constexpr int quadsPerBlock = 2 * GroupsPerBlock;
  this->Blocks = (this->Quads + quadsPerBlock - 1) / quadsPerBlock;
  for (int block = 0; this->Blocks > 1 && block < MaximumBlocks; ++block)
  {
    const int first = std::min(quadsPerBlock * block, this->Quads - 1);
    const int last = std::min(quadsPerBlock * (block + 1), this->Quads);
    for (int i = 0; i < 2; ++i)
    {
      Floats least = Load<Floats>(&this->Slopes[i][QuadWidth * first]);
      Floats most = least;
      for (int quad = first + 1; quad < last; ++quad)
      {
        const Floats slopes = Load<Floats>(&this->Slopes[i][QuadWidth * quad]);
        least = Min(least, slopes);
        most = Max(most, slopes);
      }
      const float low = Min(Min(least[0], least[1]), Min(least[2], least[3]));
      const float high = Max(Max(most[0], most[1]), Max(most[2], most[3]));
      const float middle = 0.5f * (low + high);
      this->Middle[i][block] = middle;
      this->Half[i][block] = Max(high - middle, middle - low) * (1 + 0x1p-20f);
    }
  }
}

/// The distance along Z beyond which no ray can meet anything better.
HELIOS_CLONES
double BeamBundle::GetFarthest() const
{
  Doubles farthest = Doubles();
  for (int quad = 0; quad < this->Quads; ++quad)
  {
    const RayLanes& lanes = this->Lanes[quad];
    farthest = Max<Doubles>(farthest, lanes.Range * Max<Doubles>(lanes.Largest, -lanes.Largest));
  }
  return GetMost(farthest);
}

//------------------------------------------------------------------------------
/// What of a triangle depends on where rays come from: on the lanes, or one place for all.
template <typename PlaceT>
struct Seen
{
  PlaceT Corners[3][3];
  RangeTerms<PlaceT> Terms;

  HELIOS_INLINE void SetCorners(const PlaceT origin[3], const double* const points[3])
  {
    Relate<PlaceT>(origin, points, this->Corners);
  }
};

/// Keeps better hits with a triangle of lanes that may be inside, a byte for each.
template <typename SeenT>
HELIOS_INLINE void BeamBundle::TestQuad(RayLanes& lanes, std::uint32_t bytes, vtkTypeInt32 triangle,
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
  KeepBetter(lanes, inside, triangle, plane, seen.Terms, isBetter);
  better |= isBetter;
}

/// Tests those of some groups in double that have bytes; whether any ray has a better hit.
HELIOS_INLINE bool BeamBundle::TestTriangle(
  vtkTypeInt32 triangle, std::uint32_t groups, const std::uint32_t* bytes)
{
  const TriangleMesh& mesh = this->Tree.GetMesh();
  const double* points[3] = { mesh.GetCorner(triangle, 0), mesh.GetCorner(triangle, 1),
    mesh.GetCorner(triangle, 2) };
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
        this->TestQuad(lanes, bytes[quad], triangle, plane, fromOne, better);
        continue;
      }
      Seen<Doubles> seen;
      seen.SetCorners(lanes.Origin, points);
      seen.Terms.Set(plane, seen.Corners);
      this->TestQuad(lanes, bytes[quad], triangle, plane, seen, better);
    }
  }
  return Any(better);
}

/// The edge functions of a triangle at slopes.
HELIOS_INLINE void GetEdges(
  const LeafFilter::Edges& edges, int triangle, const Group& dx, const Group& dy, Group e[3])
{
  for (int k = 0; k < 3; ++k)
  {
    const auto& terms = edges.Terms[k];
    e[k] = dx * terms[0][triangle] + dy * terms[1][triangle] + terms[2][triangle];
  }
}

/// The blocks some of whose rays may hit a triangle, a byte for each.
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

/// Compares the rays of groups with a triangle: a byte for each. The groups where any may hit it, a bit
/// for each.
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

/// The same of all groups, or those of blocks that may have some.
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

/// Tests the triangles of a leaf; whether any ray has a better hit.
HELIOS_CLONES
bool BeamBundle::Test(const BeamTree::Leaf& leaf, float limit)
{
  const TriangleMesh& mesh = this->Tree.GetMesh();
  for (int i = 0; i < leaf.Count; ++i)
  {
    __builtin_prefetch(mesh.GetCorners() + 3 * static_cast<vtkIdType>(leaf.Triangles[i]));
  }
  LeafFilter::Edges edges;
  this->Filter.SetEdges(leaf, limit, edges);
  for (int i = 0; i < leaf.Count; ++i)
  {
    for (int corner = 0; corner < 3 && edges.IsAlive[i]; ++corner)
    {
      __builtin_prefetch(mesh.GetCorner(leaf.Triangles[i], corner));
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
