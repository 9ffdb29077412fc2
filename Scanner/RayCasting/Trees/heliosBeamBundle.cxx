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

} // namespace

void BeamBundle::Trace(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count)
{
  if (!this->GatherRays(rays, count))
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
  for (int i = 0; i < this->Count && this->Tree.IsOfHeights(); ++i)
  {
    hits[i].CellId = hits[i].CellId >= 0 ? this->Tree.GetCell(hits[i].CellId) : -1;
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

/// Sets the frustum and the filter; false if the frustum misses the tree.
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
  if (this->Quads % 2 == 1) // the last group is padded with a ray that hits nothing
  {
    const Floats nowhere = Floats() + std::numeric_limits<float>::quiet_NaN();
    Store(&this->Slopes[0][QuadWidth * this->Quads], nowhere);
    Store(&this->Slopes[1][QuadWidth * this->Quads], nowhere);
  }
  this->SetBlocks();
  return true;
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

/// The distance along Z beyond which no ray can have a better hit.
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

} // namespace helios
