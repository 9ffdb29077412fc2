// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBeamTree.h"

#include "heliosHeightTree.h"
#include "heliosMeshFrames.h"
#include "heliosRayVectors.h"
#include "heliosTriangleArea.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace helios
{

namespace
{

constexpr int Width = BeamTree::Width;
constexpr float Endless = std::numeric_limits<float>::max();
constexpr float Smallest = 1e-30f;       // slope treated as nonzero
constexpr float Outwards = 1 + 0x1p-20f; // exceeds the rounding of an entry or exit

/// The ray tolerance, relative to the largest distance: BoxSlack and the rounding of the frustum.
constexpr double FrustumSlack = 4 * BoxSlack;

typedef EightFloats Wide;
typedef EightMasks WideMasks;
static_assert(Width == 8, "a node's children are lanes");

/// Returns eight bits per lane, one of them set.
HELIOS_INLINE vtkTypeUInt64 GetBits(const WideMasks& masks)
{
  return GetBytes(masks) & 0x0101010101010101u;
}

} // namespace

float Frustum::GetLimit(double distance) const
{
  const double s = (distance - this->Start + this->Slack) * this->Scale;
  return s < 1e30 ? static_cast<float>(s * Outwards + 0x1p-60) : Endless;
}

//------------------------------------------------------------------------------
std::size_t BeamTree::GetMemorySize() const
{
  return this->Storage.GetMemorySize() + this->Outliers.GetMemorySize();
}

//------------------------------------------------------------------------------
bool BeamTree::SetFrustum(Frustum& frustum, const double low[3], const double high[3],
  const double slopeLow[2], const double slopeHigh[2], double error) const
{
  if (this->Frame.Scale == 0.0)
  {
    return false;
  }
  const int axes[3] = { frustum.Axes.X, frustum.Axes.Y, frustum.Axes.Z };
  double from[3], to[3];
  double reach = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    from[i] = low[i] - this->Frame.Centre[axes[i]];
    to[i] = high[i] - this->Frame.Centre[axes[i]];
    reach = Max(reach, Max(Max(from[i], -from[i]), Max(to[i], -to[i])) + this->Frame.Half[axes[i]]);
  }
  const double half = this->Frame.Half[axes[2]];
  frustum.Slack = FrustumSlack * reach + error;
  frustum.Scale = this->Frame.Scale;
  frustum.Start = Max((frustum.IsForward ? -half - to[2] : from[2] - half) - frustum.Slack, 0.0);
  const double advance = frustum.IsForward ? frustum.Start : -frustum.Start;
  for (int i = 0; i < 3; ++i)
  {
    from[i] += i < 2 ? frustum.Start * slopeLow[i] : advance;
    to[i] += i < 2 ? frustum.Start * slopeHigh[i] : advance;
    frustum.Low[i] = RoundDown((from[i] - frustum.Slack) * this->Frame.Scale);
    frustum.High[i] = RoundUp((to[i] + frustum.Slack) * this->Frame.Scale);
  }
  for (int i = 0; i < 2; ++i)
  {
    frustum.SlopeLow[i] = RoundDown(slopeLow[i] - 0x1p-48);
    frustum.SlopeHigh[i] = RoundUp(slopeHigh[i] + 0x1p-48);
  }
  return true;
}

//------------------------------------------------------------------------------
BeamWalk::BeamWalk(const BeamTree& tree, const Frustum& frustum)
  : Tree(tree)
  , Heights(tree.Heights.get())
  , Axes(frustum.Axes)
  , IsForward(frustum.IsForward)
{
  const int axes[2] = { this->Axes.X, this->Axes.Y };
  for (int i = 0; i < 2; ++i)
  {
    // Low + s SlopeLow <= the child's high, and High + s SlopeHigh >= its low.
    float slope = frustum.SlopeLow[i];
    slope = slope > -Smallest && slope < Smallest ? -Smallest : slope;
    this->Highs.Origin[axes[i]] = frustum.Low[i];
    this->Highs.Factor[axes[i]] = 1.0f / slope;
    this->Kinds[i].IsEntry[0] = slope < 0.0f;
    slope = frustum.SlopeHigh[i];
    slope = slope > -Smallest && slope < Smallest ? Smallest : slope;
    this->Lows.Origin[axes[i]] = frustum.High[i];
    this->Lows.Factor[axes[i]] = 1.0f / slope;
    this->Kinds[i].IsEntry[1] = slope > 0.0f;
  }
  const int z = this->Axes.Z;
  this->Highs.Origin[z] = frustum.Low[2];
  this->Lows.Origin[z] = frustum.High[2];
  this->Highs.Factor[z] = this->Lows.Factor[z] = this->IsForward ? 1.0f : -1.0f;
  this->Highs.Origin[3] = this->Highs.Factor[3] = 0.0f;
  this->Lows.Origin[3] = this->Lows.Factor[3] = 0.0f;
  this->Stack[this->Size++] = { 0.0f, tree.Storage.Root };
}

/// Prefetches a node or leaf.
HELIOS_INLINE void BeamTree::Prefetch(vtkTypeUInt32 child) const
{
  const char* from = child & LeafBit
    ? reinterpret_cast<const char*>(&this->Storage.Leaves[child & ~LeafBit])
    : reinterpret_cast<const char*>(&this->Storage.Nodes[child]);
  __builtin_prefetch(from);
  __builtin_prefetch(from + 64);
}

/// Pushes entered children on the stack, the nearest on top; bits has 8 for each child.
template <bool IsOfHeights>
HELIOS_INLINE void BeamWalk::Push(
  const vtkTypeUInt32* children, vtkTypeUInt64 bits, const float* nears)
{
  const int bottom = this->Size;
  for (; bits != 0; bits &= bits - 1)
  {
    const int child = __builtin_ctzll(bits) / 8;
    const float near = nears[child];
    int at = this->Size++;
    for (; at > bottom && this->Stack[at - 1].Near < near; --at)
    {
      this->Stack[at] = this->Stack[at - 1];
    }
    this->Stack[at] = { near, children[child] };
    if (!IsOfHeights)
    {
      this->Tree.Prefetch(children[child]);
    }
  }
}

template <bool IsOfHeights>
HELIOS_INLINE const auto& BeamWalk::GetNode(vtkTypeUInt32 number)
{
  if constexpr (IsOfHeights)
  {
    this->Heights->MakeNode(number, this->NodeOfHeights);
    return this->NodeOfHeights;
  }
  else
  {
    return this->Tree.Storage.Nodes[number];
  }
}

template <bool IsOfHeights>
HELIOS_INLINE BeamLeaf BeamWalk::GetLeaf(vtkTypeUInt32 number)
{
  if (!IsOfHeights)
  {
    return this->Tree.Storage.GetLeaf(number);
  }
  this->Heights->MakeLeaf(number, this->LeafOfHeights);
  return { this->LeafOfHeights.Count, this->LeafOfHeights.Words };
}

namespace
{

/// The limits of the children of a node by their high or their low sides.
template <typename NodeT>
struct Limits;

template <>
struct Limits<BeamNode>
{
  const float (*Places)[Width];
  const float* Origin;
  const float* Factor;

  HELIOS_INLINE Limits(const BeamNode& node, bool areHigh, const float* origin, const float* factor)
    : Places(areHigh ? node.High : node.Low)
    , Origin(origin)
    , Factor(factor)
  {
  }
  HELIOS_INLINE Wide Get(int axis) const
  {
    return (Load<Wide>(this->Places[axis]) - this->Origin[axis]) * this->Factor[axis];
  }
};

template <>
struct Limits<PackedNode>
{
  WideMasks Words;
  float Start[4];
  float Steps[4];

  HELIOS_INLINE Limits(
    const PackedNode& node, bool areHigh, const float* origin, const float* factor)
    : Words(Load<WideMasks>(areHigh ? node.High : node.Low))
  {
    const Floats factors = Load<Floats>(factor);
    Store(this->Start, (Load<Floats>(node.Origin) - Load<Floats>(origin)) * factors);
    Store(this->Steps, Load<Floats>(node.Factors) * factors);
  }
  HELIOS_INLINE Wide Get(int axis) const
  {
    const WideMasks numbers = this->Words & PackedWord::Masks[axis];
    return __builtin_convertvector(numbers, Wide) * this->Steps[axis] + this->Start[axis];
  }
};

/// Returns the bits, as of GetBits(), of the children that exist.
HELIOS_INLINE vtkTypeUInt64 GetChildBits(const BeamNode&)
{
  return ~vtkTypeUInt64(0); // others have empty boxes
}
HELIOS_INLINE vtkTypeUInt64 GetChildBits(const PackedNode& node)
{
  return ~vtkTypeUInt64(0) >> (64 - 8 * node.GetCount());
}

} // namespace

template <bool IsOfHeights>
HELIOS_INLINE bool BeamWalk::FindNext(float limit, BeamTree::Leaf& leaf)
{
  vtkTypeUInt32 child = 0; // the next one, from the node or the stack
  bool isOnStack = true;
  while (!isOnStack || this->Size > 0)
  {
    if (isOnStack)
    {
      const Entry& current = this->Stack[--this->Size];
      if (!(current.Near <= limit))
      {
        continue;
      }
      child = current.Child;
    }
    if (child & BeamTree::LeafBit)
    {
      leaf = this->GetLeaf<IsOfHeights>(child & ~BeamTree::LeafBit);
      return true;
    }
    const auto& node = this->GetNode<IsOfHeights>(child);
    using NodeLimits = Limits<std::decay_t<decltype(node)>>;
    const NodeLimits highs(node, true, this->Highs.Origin, this->Highs.Factor);
    const NodeLimits lows(node, false, this->Lows.Origin, this->Lows.Factor);
    Wide entry = this->IsForward ? lows.Get(this->Axes.Z) : highs.Get(this->Axes.Z);
    Wide exit = this->IsForward ? highs.Get(this->Axes.Z) : lows.Get(this->Axes.Z);
    entry = Max(entry, Wide());
    for (int i = 0; i < 2; ++i)
    {
      const int axis = i == 0 ? this->Axes.X : this->Axes.Y;
      const bool* isEntry = this->Kinds[i].IsEntry;
      const Wide s0 = highs.Get(axis);
      const Wide s1 = lows.Get(axis);
      entry = isEntry[0] ? Max(entry, s0) : entry;
      exit = isEntry[0] ? exit : Min(exit, s0);
      entry = isEntry[1] ? Max(entry, s1) : entry;
      exit = isEntry[1] ? exit : Min(exit, s1);
    }
    entry = entry * (2.0f - Outwards);
    const WideMasks isEntered = (entry <= exit * Outwards) & (exit >= 0.0f) & (entry <= limit);
    const vtkTypeUInt64 bits = GetBits(isEntered) & GetChildBits(node);
    isOnStack = (bits & (bits - 1)) != 0 || bits == 0;
    if (!isOnStack)
    {
      child = node.Children[__builtin_ctzll(bits) / 8];
      continue;
    }
    float nears[Width];
    Store(nears, entry);
    this->Push<IsOfHeights>(node.Children, bits, nears);
  }
  return false;
}

HELIOS_CLONES
bool BeamWalk::GetNext(float limit, BeamTree::Leaf& leaf)
{
  return this->Heights ? this->FindNext<true>(limit, leaf) : this->FindNext<false>(limit, leaf);
}

//------------------------------------------------------------------------------
double BeamTree::GetReach() const
{
  double reach = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    reach = Max(reach, std::abs(this->Frame.Centre[axis]) + this->Frame.Half[axis]);
  }
  return reach;
}

//------------------------------------------------------------------------------
bool BeamTree::SetFrustum(Frustum& frustum, const TestRay& ray, double error) const
{
  const RayAxes& a = ray.Axes;
  frustum.Axes = a;
  frustum.IsForward = ray.Largest > 0.0;
  const double sign = frustum.IsForward ? 1.0 : -1.0;
  const double origin[3] = { ray.Origin[a.X], ray.Origin[a.Y], ray.Origin[a.Z] };
  const double slopes[2] = { sign * ray.Shear[0], sign * ray.Shear[1] };
  return this->SetFrustum(frustum, origin, origin, slopes, slopes, error);
}

//------------------------------------------------------------------------------
void BeamTree::ComputePoints(vtkTypeInt32 triangle, double points[3][3]) const
{
  if (this->IsOfHeights())
  {
    this->Heights->GetField().GetSlotCorners(triangle, points);
    return;
  }
  const vtkTypeInt32* corners = this->Mesh->GetCorners() + 3 * static_cast<vtkIdType>(triangle);
  for (int corner = 0; corner < 3; ++corner)
  {
    this->Shape->GetPoint(corners[corner], points[corner]);
  }
  if (!SpansArea(points[0], points[1], points[2]))
  {
    std::copy_n(points[0], 3, points[1]); // one point, which is never hit
    std::copy_n(points[0], 3, points[2]);
  }
}

void BeamTree::GetCellPoints(vtkIdType cell, double points[3][3]) const
{
  if (this->IsOfHeights())
  {
    this->Heights->GetField().GetCorners(cell, points);
    return;
  }
  for (int corner = 0; corner < 3; ++corner)
  {
    std::copy_n(this->Mesh->GetCorner(cell, corner), 3, points[corner]);
  }
}

vtkIdType BeamTree::ComputeCell(vtkIdType triangle) const
{
  return this->Heights->GetField().GetTriangle(triangle);
}

} // namespace helios
