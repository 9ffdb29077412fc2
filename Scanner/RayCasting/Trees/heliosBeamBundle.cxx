// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBeamBundle.h"

#include "heliosRayVectors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace helios
{

namespace
{

HELIOS_INLINE double GetMinimum(const Doubles& v)
{
  return Min(Min(v[0], v[1]), Min(v[2], v[3]));
}

HELIOS_INLINE double GetMaximum(const Doubles& v)
{
  return Max(Max(v[0], v[1]), Max(v[2], v[3]));
}

/// Returns the columns of the rows a, b, c, d.
HELIOS_INLINE void Transpose(const Doubles& a, const Doubles& b, const Doubles& c, const Doubles& d,
  Doubles& first, Doubles& second, Doubles& third, Doubles& fourth)
{
  const Doubles evenAB = __builtin_shufflevector(a, b, 0, 4, 2, 6);
  const Doubles oddAB = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Doubles evenCD = __builtin_shufflevector(c, d, 0, 4, 2, 6);
  const Doubles oddCD = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  first = __builtin_shufflevector(evenAB, evenCD, 0, 1, 4, 5);
  second = __builtin_shufflevector(oddAB, oddCD, 0, 1, 4, 5);
  third = __builtin_shufflevector(evenAB, evenCD, 2, 3, 6, 7);
  fourth = __builtin_shufflevector(oddAB, oddCD, 2, 3, 6, 7);
}

/// Loads the origin and the first direction component; the rest and the range.
HELIOS_INLINE Doubles LoadOrigin(const vtkHeliosRay& ray)
{
  return Load<Doubles>(reinterpret_cast<const char*>(&ray));
}
HELIOS_INLINE Doubles LoadDirection(const vtkHeliosRay& ray)
{
  static_assert(sizeof(vtkHeliosRay) == 7 * sizeof(double), "a ray is read as two vectors");
  return Load<Doubles>(reinterpret_cast<const char*>(&ray) + offsetof(vtkHeliosRay, Direction));
}

/// Loads four rays into lanes.
HELIOS_INLINE void SetRays(const vtkHeliosRay& a, const vtkHeliosRay& b, const vtkHeliosRay& c,
  const vtkHeliosRay& d, RayLanes& lanes)
{
  Doubles* direction = lanes.Direction;
  Transpose(LoadOrigin(a), LoadOrigin(b), LoadOrigin(c), LoadOrigin(d), lanes.Origin[0],
    lanes.Origin[1], lanes.Origin[2], direction[0]);
  Transpose(LoadDirection(a), LoadDirection(b), LoadDirection(c), LoadDirection(d), direction[0],
    direction[1], direction[2], lanes.Range);
}

HELIOS_INLINE bool AreAll(const Masks& m)
{
  return m[0] && m[1] && m[2] && m[3];
}

/// Returns the rays whose direction is largest along an axis, forward or not.
HELIOS_INLINE Masks IsAlong(const RayTerms<Doubles>& rays, const Masks& isX, const Masks& isY,
  const RayAxes& axes, bool isForward)
{
  const Masks isSame = axes.Z == 0 ? isX : (axes.Z == 1 ? ~isX & isY : ~isX & ~isY);
  const Masks areForward = rays.Largest > 0.0;
  return isSame & (isForward ? areForward : ~areForward);
}

} // namespace

void BeamBundle::Trace(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count)
{
  if (!this->GatherRays(rays, count))
  {
    this->TraceParts(rays, hits, count);
    return;
  }
  this->TraceTree(this->Scene.GetMesh());
  if (this->Scene.HasInstances())
  {
    this->Scene.VisitBoxes(
      [this](const BoxTree& boxes)
      {
        this->TraceInstances(boxes);
        return true;
      });
  }
  this->GetHits(hits);
}

/// Keeps better hits with the triangles of a tree.
void BeamBundle::TraceTree(const PlacedTree& placed)
{
  this->Placed = placed;
  if (placed.IsMoved() && !this->MoveRays())
  {
    this->TraceEach();
    return;
  }
  if (!this->SetFrame())
  {
    return;
  }
  BeamWalk walk(placed.GetTree(), this->Hull);
  float limit = this->Hull.GetLimit(this->GetFarthest());
  BeamTree::Leaf leaf;
  bool hasFilter = false;
  while (walk.GetNext(limit, leaf))
  {
    if (!hasFilter)
    {
      this->SetFilter();
      hasFilter = true;
    }
    if (this->Test(leaf, limit))
    {
      limit = this->Hull.GetLimit(this->GetFarthest());
    }
  }
}

/// Traces ray by ray, with the same hits as in bundles.
void BeamBundle::TraceEach()
{
  for (int i = 0; i < this->Count; ++i)
  {
    RayLanes& lanes = this->Lanes[i / QuadWidth];
    const int lane = i % QuadWidth;
    vtkHeliosRay ray;
    for (int axis = 0; axis < 3; ++axis)
    {
      ray.Origin[axis] = lanes.Origin[axis][lane];
      ray.Direction[axis] = lanes.Direction[axis][lane];
    }
    ray.MaximumRange = lanes.Range[lane];
    const vtkHeliosHit before = lanes.GetHit(lane);
    vtkHeliosHit hit = before;
    SceneTree::Intersect(this->Placed, ray, hit);
    if (hit.CellId != before.CellId)
    {
      lanes.Range[lane] = hit.Range;
      lanes.Triangle[lane] = hit.CellId;
    }
  }
}

/// Keeps better hits with the instances whose boxes the rays enter.
void BeamBundle::TraceInstances(const BoxTree& boxes)
{
  this->Placed = PlacedTree(boxes.Tree, nullptr);
  if (!this->SetFrame())
  {
    return;
  }
  this->SetReach();
  const Frustum hull = this->Hull; // the hulls of the instances replace it
  BeamWalk walk(boxes.Tree, hull);
  BeamTree::Leaf leaf;
  float limit = hull.GetLimit(this->GetFarthest());
  while (walk.GetNext(limit, leaf))
  {
    for (int i = 0; i < leaf.Count; ++i)
    {
      this->TraceTree(this->Scene.GetInstance(boxes.GetInstance(leaf.Triangles[i])));
    }
    this->Placed = PlacedTree(boxes.Tree, nullptr);
    limit = hull.GetLimit(this->GetFarthest());
  }
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

/// Traces the rays with the same main axis together.
void BeamBundle::TraceParts(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count)
{
  int keys[MaximumRays]; // the main axis of a ray; negative for none
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
/// Fills the lanes; false unless all rays are usable and have the same main axis.
HELIOS_CLONES
bool BeamBundle::GatherRays(const vtkHeliosRay* rays, int count)
{
  this->Count = count;
  this->Quads = (count + QuadWidth - 1) / QuadWidth;
  Masks isX, isY, isFine;
  Masks areFine = Masks() - 1;
  Masks areOne = areFine;
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
    }
    areFine = areFine & isFine & (lanes.Range > 0.0) &
      IsAlong(lanes, isX, isY, this->Axes, this->Lanes[0].Largest[0] > 0.0);
    areOne = areOne & (lanes.Origin[0] == this->Lanes[0].Origin[0][0]) &
      (lanes.Origin[1] == this->Lanes[0].Origin[1][0]) &
      (lanes.Origin[2] == this->Lanes[0].Origin[2][0]);
  }
  this->HaveSameOrigin = AreAll(areOne);
  return AreAll(areFine);
}

/// Sets the largest coordinate of the origins, without the sign.
void BeamBundle::SetReach()
{
  this->Reach = 0.0;
  for (int quad = 0; quad < this->Quads; ++quad)
  {
    const Doubles* o = this->Lanes[quad].Origin;
    const Doubles maximum =
      Max(Max(Max<Doubles>(o[0], -o[0]), Max<Doubles>(o[1], -o[1])), Max<Doubles>(o[2], -o[2]));
    this->Reach = Max(this->Reach, GetMaximum(maximum));
  }
}

/// Moves the rays into the frame of an instance; false unless they have the same main axis there.
HELIOS_CLONES
bool BeamBundle::MoveRays()
{
  const Similarity& place = this->Placed.GetPlace();
  const double inverse = 1.0 / place.Scale;
  const auto& m = place.Turn.M;
  const Vec3 shift = place.Translation + place.Scale * place.Pivot;
  Masks isX, isY, isFine;
  Masks areFine = Masks() - 1;
  for (int quad = 0; quad < this->Quads; ++quad)
  {
    const RayLanes& from = this->Lanes[quad];
    RayTerms<Doubles>& to = this->Moved[quad];
    const Doubles o[3] = { from.Origin[0] - shift[0], from.Origin[1] - shift[1],
      from.Origin[2] - shift[2] };
    const Doubles* d = from.Direction;
    for (int axis = 0; axis < 3; ++axis)
    {
      to.Origin[axis] =
        (m[0][axis] * o[0] + m[1][axis] * o[1] + m[2][axis] * o[2]) * inverse + place.Pivot[axis];
      to.Direction[axis] = (m[0][axis] * d[0] + m[1][axis] * d[1] + m[2][axis] * d[2]) * inverse;
    }
    SetTerms<Doubles, Masks>(to, isFine, isX, isY);
    if (quad == 0)
    {
      this->HullAxes = RayAxes(isX[0] ? 0 : (isY[0] ? 1 : 2));
    }
    areFine =
      areFine & isFine & IsAlong(to, isX, isY, this->HullAxes, this->Moved[0].Largest[0] > 0.0);
  }
  return AreAll(areFine);
}

/// Sets the frustum for the current tree; false if it is empty.
HELIOS_CLONES
bool BeamBundle::SetFrame()
{
  double* const low = this->Low;
  double* const high = this->High;
  double* const slopeLow = this->SlopeLow;
  double* const slopeHigh = this->SlopeHigh;
  this->SetIntervals(low, high, slopeLow, slopeHigh);
  const BeamTree& tree = this->Placed.GetTree();
  const double error = this->Placed.IsMoved() ? this->Placed.GetError(this->Reach) : 0.0;
  this->Hull.Axes = this->HullAxes;
  this->Hull.IsForward = this->IsForward;
  if (!tree.SetFrustum(this->Hull, low, high, slopeLow, slopeHigh, error))
  {
    return false;
  }
  return true;
}

/// Sets the filter for the current tree.
HELIOS_CLONES
void BeamBundle::SetFilter()
{
  const double* const low = this->Low;
  const double* const high = this->High;
  this->HaveSamePlace = low[0] == high[0] && low[1] == high[1] && low[2] == high[2];
  this->Filter.SetAxis(
    this->Placed.GetTree(), this->Hull, low, high, this->SlopeLow, this->SlopeHigh);
  this->SetSlopes(low, high);
  this->SetBlocks();
}

/// Returns the intervals of origins and slopes in the frame of the current tree; sets its axes.
HELIOS_INLINE void BeamBundle::SetIntervals(
  double low[3], double high[3], double slopeLow[2], double slopeHigh[2])
{
  this->HullAxes = this->Placed.IsMoved() ? this->HullAxes : this->Axes;
  this->IsForward = this->GetRays(0).Largest[0] > 0.0;
  const int axes[3] = { this->HullAxes.X, this->HullAxes.Y, this->HullAxes.Z };
  const double sign = this->IsForward ? 1.0 : -1.0;
  for (int i = 0; i < 3; ++i)
  {
    Doubles minimum = this->GetRays(0).Origin[axes[i]];
    Doubles maximum = minimum;
    for (int quad = 1; quad < this->Quads; ++quad)
    {
      minimum = Min(minimum, this->GetRays(quad).Origin[axes[i]]);
      maximum = Max(maximum, this->GetRays(quad).Origin[axes[i]]);
    }
    low[i] = GetMinimum(minimum);
    high[i] = GetMaximum(maximum);
  }
  for (int i = 0; i < 2; ++i)
  {
    Doubles minimum = this->GetRays(0).Shear[i] * sign;
    Doubles maximum = minimum;
    for (int quad = 1; quad < this->Quads; ++quad)
    {
      minimum = Min<Doubles>(minimum, this->GetRays(quad).Shear[i] * sign);
      maximum = Max<Doubles>(maximum, this->GetRays(quad).Shear[i] * sign);
    }
    slopeLow[i] = GetMinimum(minimum);
    slopeHigh[i] = GetMaximum(maximum);
  }
}

/// Sets the slopes of the rays relative to the filter's axis.
HELIOS_INLINE void BeamBundle::SetSlopes(const double low[3], const double high[3])
{
  const int axes[3] = { this->HullAxes.X, this->HullAxes.Y, this->HullAxes.Z };
  const double sign = this->IsForward ? 1.0 : -1.0;
  const double middle[2] = { 0.5 * low[0] + 0.5 * high[0], 0.5 * low[1] + 0.5 * high[1] };
  double rest = 0.0;
  for (int i = 0; i < 2; ++i)
  {
    const double slope = this->Filter.GetSlope(i);
    Doubles maximum = Doubles();
    for (int quad = 0; quad < this->Quads; ++quad)
    {
      const RayTerms<Doubles>& rays = this->GetRays(quad);
      const Doubles own = rays.Shear[i] * sign;
      const Floats shortSlope = __builtin_convertvector(own - slope, Floats);
      Store(&this->Slopes[i][QuadWidth * quad], shortSlope);
      if (!this->HaveSamePlace)
      {
        const Doubles ahead = this->Hull.Start + (low[2] - rays.Origin[axes[2]]) * sign;
        const Doubles x = rays.Origin[axes[i]] - middle[i] + own * ahead - slope * this->Hull.Start;
        const Doubles off = x * this->Hull.Scale - (own - slope) * this->Filter.GetDepth();
        maximum = Max(maximum, Max<Doubles>(off, -off));
      }
    }
    rest = Max(rest, GetMaximum(maximum));
  }
  if (!this->Filter.SetError(rest))
  {
    std::fill_n(this->Slopes[0], MaximumRays, 0.0f);
    std::fill_n(this->Slopes[1], MaximumRays, 0.0f);
  }
  if (this->Quads % 2 == 1) // the last group is padded with a ray that hits nothing
  {
    const Floats nowhere = Floats() + std::numeric_limits<float>::quiet_NaN();
    Store(&this->Slopes[0][QuadWidth * this->Quads], nowhere);
    Store(&this->Slopes[1][QuadWidth * this->Quads], nowhere);
  }
}

/// Sets the bounds of blocks of adjacent rays.
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
      Floats minimum = Load<Floats>(&this->Slopes[i][QuadWidth * first]);
      Floats maximum = minimum;
      for (int quad = first + 1; quad < last; ++quad)
      {
        const Floats slopes = Load<Floats>(&this->Slopes[i][QuadWidth * quad]);
        minimum = Min(minimum, slopes);
        maximum = Max(maximum, slopes);
      }
      const float low = Min(Min(minimum[0], minimum[1]), Min(minimum[2], minimum[3]));
      const float high = Max(Max(maximum[0], maximum[1]), Max(maximum[2], maximum[3]));
      const float middle = 0.5f * (low + high);
      this->Middle[i][block] = middle;
      this->Half[i][block] = Max(high - middle, middle - low) * (1 + 0x1p-20f);
    }
  }
}

/// Returns the distance along Z of the current tree beyond which no ray can have a better hit.
HELIOS_CLONES
double BeamBundle::GetFarthest() const
{
  Doubles farthest = Doubles();
  for (int quad = 0; quad < this->Quads; ++quad)
  {
    const Doubles& speed = this->GetRays(quad).Largest;
    farthest = Max<Doubles>(farthest, this->Lanes[quad].Range * Max<Doubles>(speed, -speed));
  }
  return GetMaximum(farthest);
}

} // namespace helios
