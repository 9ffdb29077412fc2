// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBeamTree.h"

#include "heliosCoreBounds.h"
#include "heliosRayVectors.h"
#include "heliosTriangleArea.h"
#include "heliosTriangleMesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

constexpr int Width = BeamTree::Width;
constexpr float Endless = std::numeric_limits<float>::max();
constexpr float Smallest = 1e-30f;       // slope that is not zero
constexpr double FloatError = 0x1p-23;   // more than the rounding of a float, relative
constexpr float Outwards = 1 + 0x1p-20f; // more than what the arithmetic of an entry or exit rounds

/// Of the largest distance, how far a ray may be off: BoxSlack and the rounding of the frustum.
constexpr double FrustumSlack = 4 * BoxSlack;

typedef float Wide __attribute__((vector_size(4 * Width)));
typedef int WideMasks __attribute__((vector_size(4 * Width)));

float RoundDown(double x)
{
  return static_cast<float>(std::max(x - std::abs(x) * FloatError, -1e30));
}

float RoundUp(double x)
{
  return static_cast<float>(std::min(x + std::abs(x) * FloatError, 1e30));
}

} // namespace

float Frustum::GetLimit(double distance) const
{
  const double s = (distance - this->Start + this->Slack) * this->Scale;
  return s < 1e30 ? static_cast<float>(s * Outwards + 0x1p-60) : Endless;
}

//------------------------------------------------------------------------------
void BeamTree::Build(const TriangleMesh& mesh)
{
  *this = BeamTree();
  this->Mesh = &mesh;
  if (mesh.GetNumberOfTriangles() == 0)
  {
    return;
  }
  double core[6];
  GetCoreBounds(mesh, core);
  double low[3] = { core[1], core[3], core[5] };
  double high[3] = { core[0], core[2], core[4] };
  std::vector<vtkTypeInt32> inside, outside;
  inside.reserve(static_cast<std::size_t>(mesh.GetNumberOfTriangles()));
  for (vtkTypeInt32 i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const double* p[3] = { mesh.GetCorner(i, 0), mesh.GetCorner(i, 1), mesh.GetCorner(i, 2) };
    if (!SpansArea(p[0], p[1], p[2]))
    {
      continue;
    }
    double least[3], most[3];
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      least[axis] = Min(Min(p[0][axis], p[1][axis]), p[2][axis]);
      most[axis] = Max(Max(p[0][axis], p[1][axis]), p[2][axis]);
      isInside = isInside && least[axis] >= core[2 * axis] && most[axis] <= core[2 * axis + 1];
    }
    for (int axis = 0; axis < 3 && isInside; ++axis)
    {
      low[axis] = Min(low[axis], least[axis]);
      high[axis] = Max(high[axis], most[axis]);
    }
    (isInside ? inside : outside).push_back(i);
  }
  this->HasOutliers = !outside.empty();
  this->Outliers.Build(mesh, std::move(outside));
  if (inside.empty())
  {
    return;
  }
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Centre[axis] = 0.5 * low[axis] + 0.5 * high[axis];
    this->Half[axis] =
      Max(high[axis] - this->Centre[axis], this->Centre[axis] - low[axis]) * (1 + FloatError);
    largest = Max(largest, this->Half[axis]);
  }
  this->Scale = std::ldexp(1.0, -std::ilogb(largest) - 1);
  Bvh binary;
  binary.Build(mesh, std::move(inside));
  this->MakeNode(binary, 0);
  this->Nodes.shrink_to_fit();
  this->Order = std::move(binary.Order);
}

/// Makes a wide node of a binary one: opens the child with the largest surface until there are eight.
vtkTypeUInt32 BeamTree::MakeNode(const Bvh& binary, vtkTypeInt32 index)
{
  struct Child
  {
    vtkTypeInt32 Node;
    int Side;
    double Surface; // negative for a leaf
  };
  Child children[Width];
  int count = 0;
  const auto add = [&binary, &children, &count](int at, vtkTypeInt32 node, int side)
  {
    const Bvh::Node& n = binary.Nodes[node];
    const double x = n.High[0][side] - n.Low[0][side];
    const double y = n.High[1][side] - n.Low[1][side];
    const double z = n.High[2][side] - n.Low[2][side];
    children[at] = { node, side, n.Count[side] > 0 ? -1.0 : x * y + y * z + z * x };
    ++count;
  };
  add(0, index, 0);
  add(1, index, 1);
  while (count < Width)
  {
    Child* largest = std::max_element(children, children + count,
      [](const Child& a, const Child& b) { return a.Surface < b.Surface; });
    if (largest->Surface < 0.0)
    {
      break;
    }
    const vtkTypeInt32 inner = binary.Nodes[largest->Node].First[largest->Side];
    add(count, inner, 1);
    --count;
    add(static_cast<int>(largest - children), inner, 0);
  }
  const auto node = static_cast<vtkTypeUInt32>(this->Nodes.size());
  this->Nodes.emplace_back();
  for (int child = 0; child < Width; ++child)
  {
    Node& n = this->Nodes[node];
    for (int axis = 0; axis < 3; ++axis)
    {
      n.Low[axis][child] = Endless; // an empty one
      n.High[axis][child] = -Endless;
    }
    n.First[child] = 0;
    n.Count[child] = 0;
  }
  for (int child = 0; child < count; ++child)
  {
    this->SetChild(node, child, binary, children[child].Node, children[child].Side);
  }
  return node;
}

void BeamTree::SetChild(
  vtkTypeUInt32 node, int child, const Bvh& binary, vtkTypeInt32 parent, int side)
{
  const Bvh::Node& b = binary.Nodes[parent];
  const bool isLeaf = b.Count[side] > 0;
  const vtkTypeUInt32 first =
    isLeaf ? static_cast<vtkTypeUInt32>(b.First[side]) : this->MakeNode(binary, b.First[side]);
  Node& n = this->Nodes[node]; // only now: making nodes moves them
  for (int axis = 0; axis < 3; ++axis)
  {
    n.Low[axis][child] = RoundDown((b.Low[axis][side] - this->Centre[axis]) * this->Scale);
    n.High[axis][child] = RoundUp((b.High[axis][side] - this->Centre[axis]) * this->Scale);
  }
  n.First[child] = first;
  n.Count[child] = static_cast<unsigned char>(b.Count[side]);
}

std::size_t BeamTree::GetMemorySize() const
{
  return this->Nodes.capacity() * sizeof(Node) + this->Order.capacity() * sizeof(vtkTypeInt32) +
    this->Outliers.GetMemorySize();
}

//------------------------------------------------------------------------------
bool BeamTree::SetFrustum(Frustum& frustum, const double low[3], const double high[3],
  const double slopeLow[2], const double slopeHigh[2]) const
{
  if (this->Scale == 0.0)
  {
    return false;
  }
  const int axes[3] = { frustum.Axes.X, frustum.Axes.Y, frustum.Axes.Z };
  double from[3], to[3];
  double reach = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    from[i] = low[i] - this->Centre[axes[i]];
    to[i] = high[i] - this->Centre[axes[i]];
    reach = Max(reach, Max(Max(from[i], -from[i]), Max(to[i], -to[i])) + this->Half[axes[i]]);
  }
  const double half = this->Half[axes[2]];
  frustum.Slack = FrustumSlack * reach;
  frustum.Scale = this->Scale;
  frustum.Start = Max((frustum.IsForward ? -half - to[2] : from[2] - half) - frustum.Slack, 0.0);
  const double advance = frustum.IsForward ? frustum.Start : -frustum.Start;
  for (int i = 0; i < 3; ++i)
  {
    from[i] += i < 2 ? frustum.Start * slopeLow[i] : advance;
    to[i] += i < 2 ? frustum.Start * slopeHigh[i] : advance;
    frustum.Low[i] = RoundDown((from[i] - frustum.Slack) * this->Scale);
    frustum.High[i] = RoundUp((to[i] + frustum.Slack) * this->Scale);
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
  , Axes(frustum.Axes)
  , IsForward(frustum.IsForward)
  , Near(frustum.IsForward ? frustum.High[2] : frustum.Low[2])
  , Far(frustum.IsForward ? frustum.Low[2] : frustum.High[2])
{
  for (int i = 0; i < 2; ++i)
  {
    // Low + s SlopeLow <= the child's high, and High + s SlopeHigh >= its low.
    float slope = frustum.SlopeLow[i];
    slope = slope > -Smallest && slope < Smallest ? -Smallest : slope;
    this->Lower[i] = { frustum.Low[i], 1.0f / slope, slope < 0.0f };
    slope = frustum.SlopeHigh[i];
    slope = slope > -Smallest && slope < Smallest ? Smallest : slope;
    this->Upper[i] = { frustum.High[i], 1.0f / slope, slope > 0.0f };
  }
  this->Stack[this->Size++] = { 0.0f, 0, 0 };
}

HELIOS_CLONES
int BeamWalk::GetNext(float limit, const vtkTypeInt32*& triangles)
{
  while (this->Size > 0)
  {
    const Entry current = this->Stack[--this->Size];
    if (!(current.Near <= limit))
    {
      continue;
    }
    if (current.Count > 0)
    {
      triangles = this->Tree.Order.data() + current.First;
      return static_cast<int>(current.Count);
    }
    const BeamTree::Node& node = this->Tree.Nodes[current.First];
    const Wide lowZ = Load<Wide>(node.Low[this->Axes.Z]);
    const Wide highZ = Load<Wide>(node.High[this->Axes.Z]);
    Wide entry = this->IsForward ? lowZ - this->Near : this->Near - highZ;
    Wide exit = this->IsForward ? highZ - this->Far : this->Far - lowZ;
    entry = Max(entry, Wide());
    for (int i = 0; i < 2; ++i)
    {
      const int axis = i == 0 ? this->Axes.X : this->Axes.Y;
      const Side& lower = this->Lower[i];
      const Side& upper = this->Upper[i];
      const Wide s0 = (Load<Wide>(node.High[axis]) - lower.Origin) * lower.Inverse;
      const Wide s1 = (Load<Wide>(node.Low[axis]) - upper.Origin) * upper.Inverse;
      entry = lower.IsEntry ? Max(entry, s0) : entry;
      exit = lower.IsEntry ? exit : Min(exit, s0);
      entry = upper.IsEntry ? Max(entry, s1) : entry;
      exit = upper.IsEntry ? exit : Min(exit, s1);
    }
    entry = entry * (2.0f - Outwards);
    const WideMasks isEntered = (entry <= exit * Outwards) & (exit >= 0.0f) & (entry <= limit);
    const int bottom = this->Size;
    for (int child = 0; child < Width; ++child)
    {
      if (isEntered[child])
      {
        int at = this->Size++;
        for (; at > bottom && this->Stack[at - 1].Near < entry[child]; --at)
        {
          this->Stack[at] = this->Stack[at - 1];
        }
        this->Stack[at] = { entry[child], node.First[child], node.Count[child] };
      }
    }
  }
  return 0;
}

//------------------------------------------------------------------------------
/// Up to MaximumRays rays that run along the same axis, and their best hits so far.
class BeamTree::Bundle
{
public:
  static constexpr int MaximumRays = 256;

  RayAxes Axes;
  bool IsForward = true;

  void Add(const vtkHeliosRay& ray, int index)
  {
    this->Rays[this->Count] = &ray;
    this->Indices[this->Count++] = index;
  }
  void Clear() { this->Count = 0; }

  void Trace(const BeamTree& tree, vtkHeliosHit* hits);

private:
  bool Prepare(const BeamTree& tree);
  float GetLimit() const;
  bool Test(const TriangleMesh& mesh, vtkTypeInt32 triangle);

  int Count = 0;
  int Quads = 0;
  const vtkHeliosRay* Rays[MaximumRays];
  int Indices[MaximumRays];
  RayLanes Lanes[MaximumRays / QuadWidth];
  Masks Valid[MaximumRays / QuadWidth];
  Frustum Hull;
};

void BeamTree::Bundle::Trace(const BeamTree& tree, vtkHeliosHit* hits)
{
  if (this->Prepare(tree))
  {
    BeamWalk walk(tree, this->Hull);
    float limit = this->GetLimit();
    const vtkTypeInt32* triangles;
    while (const int count = walk.GetNext(limit, triangles))
    {
      bool isBetter = false;
      for (int i = 0; i < count; ++i)
      {
        isBetter = this->Test(*tree.Mesh, triangles[i]) || isBetter;
      }
      limit = isBetter ? this->GetLimit() : limit;
    }
  }
  for (int i = 0; i < this->Count; ++i)
  {
    hits[this->Indices[i]] = this->Lanes[i / QuadWidth].GetHit(i % QuadWidth);
  }
}

/// Fills the lanes and the frustum; false where it misses the tree.
HELIOS_CLONES
bool BeamTree::Bundle::Prepare(const BeamTree& tree)
{
  this->Quads = (this->Count + QuadWidth - 1) / QuadWidth;
  Doubles low[3], high[3], slopeLow[2], slopeHigh[2];
  const int axes[3] = { this->Axes.X, this->Axes.Y, this->Axes.Z };
  for (int quad = 0; quad < this->Quads; ++quad)
  {
    RayLanes& lanes = this->Lanes[quad];
    const vtkHeliosRay* r[QuadWidth];
    for (int lane = 0; lane < QuadWidth; ++lane)
    {
      const int i = QuadWidth * quad + lane;
      r[lane] = this->Rays[i < this->Count ? i : 0];
      this->Valid[quad][lane] = i < this->Count ? -1 : 0;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      lanes.Origin[axis] =
        Doubles{ r[0]->Origin[axis], r[1]->Origin[axis], r[2]->Origin[axis], r[3]->Origin[axis] };
      lanes.Direction[axis] = Doubles{ r[0]->Direction[axis], r[1]->Direction[axis],
        r[2]->Direction[axis], r[3]->Direction[axis] };
    }
    lanes.Range =
      Doubles{ r[0]->MaximumRange, r[1]->MaximumRange, r[2]->MaximumRange, r[3]->MaximumRange };
    lanes.Triangle = Masks() + RayLanes::NoTriangle;
    Masks isUsable, isX, isY;
    SetTerms<Doubles, Masks>(lanes, isUsable, isX, isY);
    for (int i = 0; i < 3; ++i)
    {
      const Doubles& o = lanes.Origin[axes[i]];
      low[i] = quad == 0 ? o : Min(low[i], o);
      high[i] = quad == 0 ? o : Max(high[i], o);
    }
    for (int i = 0; i < 2; ++i)
    {
      const Doubles slope = this->IsForward ? lanes.Shear[i] : -lanes.Shear[i];
      slopeLow[i] = quad == 0 ? slope : Min(slopeLow[i], slope);
      slopeHigh[i] = quad == 0 ? slope : Max(slopeHigh[i], slope);
    }
  }
  double limits[10];
  for (int i = 0; i < 3; ++i)
  {
    limits[i] = Min(Min(low[i][0], low[i][1]), Min(low[i][2], low[i][3]));
    limits[3 + i] = Max(Max(high[i][0], high[i][1]), Max(high[i][2], high[i][3]));
  }
  for (int i = 0; i < 2; ++i)
  {
    limits[6 + i] = Min(Min(slopeLow[i][0], slopeLow[i][1]), Min(slopeLow[i][2], slopeLow[i][3]));
    limits[8 + i] =
      Max(Max(slopeHigh[i][0], slopeHigh[i][1]), Max(slopeHigh[i][2], slopeHigh[i][3]));
  }
  this->Hull.Axes = this->Axes;
  this->Hull.IsForward = this->IsForward;
  return tree.SetFrustum(this->Hull, limits, limits + 3, limits + 6, limits + 8);
}

/// Beyond it no ray of the bundle can meet anything better.
HELIOS_CLONES
float BeamTree::Bundle::GetLimit() const
{
  Doubles farthest = Doubles();
  for (int quad = 0; quad < this->Quads; ++quad)
  {
    const RayLanes& lanes = this->Lanes[quad];
    const Doubles distance = lanes.Range * Max<Doubles>(lanes.Largest, -lanes.Largest);
    farthest = Max(farthest, this->Valid[quad] ? distance : Doubles());
  }
  return this->Hull.GetLimit(Max(Max(farthest[0], farthest[1]), Max(farthest[2], farthest[3])));
}

/// Tests the rays against a triangle; whether any has a better hit.
HELIOS_CLONES
bool BeamTree::Bundle::Test(const TriangleMesh& mesh, vtkTypeInt32 triangle)
{
  const double* points[3] = { mesh.GetCorner(triangle, 0), mesh.GetCorner(triangle, 1),
    mesh.GetCorner(triangle, 2) };
  LazyPlane plane;
  Masks better = Masks();
  for (int quad = 0; quad < this->Quads; ++quad)
  {
    Masks isBetter;
    TestLanes(this->Lanes[quad], this->Axes, this->Valid[quad], triangle, points, plane, isBetter);
    better = better | isBetter;
  }
  return Any(better);
}

//------------------------------------------------------------------------------
void BeamTree::TraceBundle(const vtkHeliosRay* rays, vtkHeliosHit* hits, int count) const
{
  signed char keys[Bundle::MaximumRays]; // the axis a ray runs along; negative for none
  bool isThere[6] = {};
  for (int i = 0; i < count; ++i)
  {
    TestRay ray;
    const bool isUsable = ray.Set(rays[i]);
    const int key = 2 * ray.Axes.Z + (ray.Largest > 0.0 ? 1 : 0);
    keys[i] = static_cast<signed char>(isUsable ? key : -1);
    hits[i] = { NoHit, -1 };
    if (isUsable)
    {
      isThere[key] = true;
    }
  }
  Bundle bundle;
  for (int key = 0; key < 6; ++key)
  {
    if (!isThere[key])
    {
      continue;
    }
    bundle.Clear();
    bundle.Axes = RayAxes(key / 2);
    bundle.IsForward = key % 2 == 1;
    for (int i = 0; i < count; ++i)
    {
      if (keys[i] == key)
      {
        bundle.Add(rays[i], i);
      }
    }
    bundle.Trace(*this, hits);
  }
}

void BeamTree::Intersect(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const
{
  for (vtkIdType beam = 0; beam < beams; ++beam)
  {
    for (int first = 0; first < raysPerBeam; first += Bundle::MaximumRays)
    {
      const int count = std::min(Bundle::MaximumRays, raysPerBeam - first);
      this->TraceBundle(rays + first, hits + first, count);
    }
    for (int i = 0; i < raysPerBeam && this->HasOutliers; ++i)
    {
      hits[i] = this->AddOutliers(rays[i], hits[i]);
    }
    rays += raysPerBeam;
    hits += raysPerBeam;
  }
}

/// The better of a hit and what the outliers have before it.
vtkHeliosHit BeamTree::AddOutliers(const vtkHeliosRay& ray, const vtkHeliosHit& hit) const
{
  TestRay rest;
  if (!rest.Set(ray))
  {
    return hit;
  }
  rest.MaximumRange = Min(rest.MaximumRange, hit.Range);
  const vtkHeliosHit other = this->Outliers.Intersect(rest);
  const bool isBetter =
    other.Range < hit.Range || (other.Range == hit.Range && other.CellId < hit.CellId);
  return other.CellId >= 0 && isBetter ? other : hit;
}

bool BeamTree::IsOccluded(const vtkHeliosRay& ray) const
{
  TestRay test;
  if (!test.Set(ray))
  {
    return false;
  }
  Frustum hull;
  hull.Axes = test.Axes;
  hull.IsForward = test.Largest > 0.0;
  const RayAxes& a = test.Axes;
  const double origin[3] = { test.Origin[a.X], test.Origin[a.Y], test.Origin[a.Z] };
  const double sign = hull.IsForward ? 1.0 : -1.0;
  const double slopes[2] = { sign * test.Shear[0], sign * test.Shear[1] };
  if (this->SetFrustum(hull, origin, origin, slopes, slopes))
  {
    BeamWalk walk(*this, hull);
    const float limit = hull.GetLimit(test.MaximumRange * sign * test.Largest);
    const vtkTypeInt32* triangles;
    while (const int count = walk.GetNext(limit, triangles))
    {
      for (int i = 0; i < count; ++i)
      {
        const double* points[3] = { this->Mesh->GetCorner(triangles[i], 0),
          this->Mesh->GetCorner(triangles[i], 1), this->Mesh->GetCorner(triangles[i], 2) };
        if (TestTriangle(test, points) < NoHit)
        {
          return true;
        }
      }
    }
  }
  return this->HasOutliers && this->Outliers.IsOccluded(test);
}

} // namespace helios
