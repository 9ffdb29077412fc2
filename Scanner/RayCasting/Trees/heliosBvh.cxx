// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBvh.h"

#include "heliosThreadLoop.h"
#include "heliosTriangleArea.h"
#include "heliosTriangleMesh.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <limits>

namespace helios
{

namespace
{

constexpr double Huge = std::numeric_limits<double>::max();
constexpr int NumberOfBins = 16;
constexpr vtkTypeInt32 LeafSize = 4;
constexpr int BinnedDepth = 56; // median splits below: at most 56 + 31 levels
constexpr int StackSize = 96;

// A large tree is built of parts, on all threads.
constexpr vtkTypeInt32 PartsOfTree = 64;
constexpr vtkTypeInt32 SmallestPart = 512; // triangles

struct Box
{
  double Low[3] = { Huge, Huge, Huge };
  double High[3] = { -Huge, -Huge, -Huge };

  void Add(const Box& other)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], other.Low[axis]);
      this->High[axis] = std::max(this->High[axis], other.High[axis]);
    }
  }

  double GetHalfArea() const
  {
    const double x = this->High[0] - this->Low[0];
    const double y = this->High[1] - this->Low[1];
    const double z = this->High[2] - this->Low[2];
    return x * y + y * z + z * x;
  }

  /// Returns twice the centre.
  double GetCentre(int axis) const { return this->Low[axis] + this->High[axis]; }
};

Box GetBox(const TriangleMesh& mesh, vtkTypeInt32 triangle)
{
  Box box;
  for (int corner = 0; corner < 3; ++corner)
  {
    const double* p = mesh.GetCorner(triangle, corner);
    for (int axis = 0; axis < 3; ++axis)
    {
      box.Low[axis] = std::min(box.Low[axis], p[axis]);
      box.High[axis] = std::max(box.High[axis], p[axis]);
    }
  }
  return box;
}

struct Bin
{
  Box Bounds;
  vtkTypeInt32 Count = 0;
};

struct Split
{
  int Axis = -1;
  int Bin = 0;
  double Cost = Huge;
};

/// A triangle during the build.
struct Primitive
{
  Box Bounds;
  vtkTypeInt32 Triangle;
};

/// The bin of a centre; the same for counting and partitioning.
struct Binning
{
  double Start;
  double Scale;

  Binning(const Box& centres, int axis)
    : Start(centres.Low[axis])
    , Scale(NumberOfBins / (centres.High[axis] - centres.Low[axis]))
  {
  }
  int operator()(double centre) const
  {
    const double bin = (centre - this->Start) * this->Scale;
    return bin >= NumberOfBins ? NumberOfBins - 1 : (bin > 0.0 ? static_cast<int>(bin) : 0);
  }
};

} // namespace

/// A range of primitives whose node, a child of another one, is made later.
struct Bvh::Part
{
  vtkTypeInt32 Parent;
  int Child;
  vtkTypeInt32 First;
  vtkTypeInt32 Last;
  int Depth;
  std::vector<Node> Nodes; // nodes to visit, the first on top
};

/// Splits ranges of primitives by the surface area heuristic over bins of their centres.
class Bvh::Builder
{
public:
  Builder(std::vector<Primitive>& primitives, std::vector<Node>& nodes, StopCheck& check)
    : Primitives(primitives)
    , Nodes(nodes)
    , Check(check)
  {
  }

  /// Makes the nodes of ranges with more primitives only, and parts of the others.
  void MakeParts(vtkTypeInt32 size, std::vector<Part>& parts)
  {
    this->PartSize = size;
    this->Parts = &parts;
  }

  /// Creates the node of at least two primitives; returns its index.
  vtkTypeInt32 MakeNode(vtkTypeInt32 first, vtkTypeInt32 last, int depth)
  {
    this->Check.Count(1 + static_cast<std::size_t>(last - first) / 32);
    const vtkTypeInt32 middle = this->Divide(first, last, depth);
    const vtkTypeInt32 index = static_cast<vtkTypeInt32>(this->Nodes.size());
    this->Nodes.emplace_back();
    this->SetChild(index, 0, first, middle, depth);
    this->SetChild(index, 1, middle, last, depth);
    return index;
  }

  void SetChild(vtkTypeInt32 node, int child, vtkTypeInt32 first, vtkTypeInt32 last, int depth)
  {
    Box bounds;
    for (vtkTypeInt32 i = first; i < last; ++i)
    {
      bounds.Add(this->Primitives[i].Bounds);
    }
    const bool isLeaf = last - first <= LeafSize;
    const bool isPart = !isLeaf && last - first <= this->PartSize;
    vtkTypeInt32 inner = first;
    if (isPart)
    {
      this->Parts->push_back({ node, child, first, last, depth + 1, {} });
    }
    else if (!isLeaf)
    {
      inner = this->MakeNode(first, last, depth + 1);
    }
    Node& n = this->Nodes[node]; // here, since creating nodes moves them
    for (int axis = 0; axis < 3; ++axis)
    {
      n.Low[axis][child] = bounds.Low[axis];
      n.High[axis][child] = bounds.High[axis];
    }
    n.First[child] = inner;
    n.Count[child] = isLeaf ? last - first : 0;
  }

private:
  /// Partitions a range; returns the start of its second half.
  vtkTypeInt32 Divide(vtkTypeInt32 first, vtkTypeInt32 last, int depth)
  {
    Box centres;
    for (vtkTypeInt32 i = first; i < last; ++i)
    {
      const Box& box = this->Primitives[i].Bounds;
      const double c[3] = { box.GetCentre(0), box.GetCentre(1), box.GetCentre(2) };
      centres.Add({ { c[0], c[1], c[2] }, { c[0], c[1], c[2] } });
    }
    Split best;
    for (int axis = 0; axis < 3 && depth < BinnedDepth; ++axis)
    {
      if (centres.High[axis] > centres.Low[axis])
      {
        this->TrySplits(first, last, centres, axis, best);
      }
    }
    const auto begin = this->Primitives.begin() + first;
    const auto end = this->Primitives.begin() + last;
    if (best.Axis < 0)
    {
      return this->Halve(first, last, centres);
    }
    const Binning bin(centres, best.Axis);
    const auto middle = std::partition(begin, end,
      [&bin, &best](const Primitive& p) { return bin(p.Bounds.GetCentre(best.Axis)) < best.Bin; });
    return static_cast<vtkTypeInt32>(middle - this->Primitives.begin());
  }

  /// Halves a range along the longest side of the box of its centres.
  vtkTypeInt32 Halve(vtkTypeInt32 first, vtkTypeInt32 last, const Box& centres)
  {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
    {
      axis = centres.High[i] - centres.Low[i] > centres.High[axis] - centres.Low[axis] ? i : axis;
    }
    const vtkTypeInt32 middle = first + (last - first) / 2;
    const auto begin = this->Primitives.begin();
    std::nth_element(begin + first, begin + middle, begin + last,
      [axis](const Primitive& a, const Primitive& b)
      { return a.Bounds.GetCentre(axis) < b.Bounds.GetCentre(axis); });
    return middle;
  }

  void TrySplits(
    vtkTypeInt32 first, vtkTypeInt32 last, const Box& centres, int axis, Split& best) const
  {
    const Binning binOf(centres, axis);
    Bin bins[NumberOfBins];
    for (vtkTypeInt32 i = first; i < last; ++i)
    {
      const Box& box = this->Primitives[i].Bounds;
      Bin& bin = bins[binOf(box.GetCentre(axis))];
      bin.Bounds.Add(box);
      ++bin.Count;
    }
    double costBelow[NumberOfBins] = {};
    Bin below;
    for (int i = 1; i < NumberOfBins; ++i)
    {
      below.Bounds.Add(bins[i - 1].Bounds);
      below.Count += bins[i - 1].Count;
      costBelow[i] = below.Count == 0 ? Huge : below.Count * below.Bounds.GetHalfArea();
    }
    Bin above;
    for (int i = NumberOfBins - 1; i > 0; --i)
    {
      above.Bounds.Add(bins[i].Bounds);
      above.Count += bins[i].Count;
      const double cost =
        costBelow[i] + (above.Count == 0 ? Huge : above.Count * above.Bounds.GetHalfArea());
      if (cost < best.Cost)
      {
        best = { axis, i, cost };
      }
    }
  }

  std::vector<Primitive>& Primitives;
  std::vector<Node>& Nodes;
  StopCheck& Check;
  vtkTypeInt32 PartSize = 0;
  std::vector<Part>* Parts = nullptr;
};

/// Appends the nodes of a part.
void Bvh::Append(const Part& part)
{
  const auto offset = static_cast<vtkTypeInt32>(this->Nodes.size());
  this->Nodes[part.Parent].First[part.Child] = offset;
  for (Node node : part.Nodes)
  {
    for (int child = 0; child < 2; ++child)
    {
      node.First[child] += node.Count[child] == 0 ? offset : 0;
    }
    this->Nodes.push_back(node);
  }
}

/// Makes the nodes of parts, on all threads, in rounds between checks for a stop.
template <typename PrimitivesT>
void Bvh::BuildParts(std::vector<Part>& parts, PrimitivesT& primitives, StopCheck& check)
{
  const auto build = [&](vtkIdType begin, vtkIdType end)
  {
    StopCheck never(nullptr);
    for (vtkIdType i = begin; i < end; ++i)
    {
      Part& part = parts[static_cast<std::size_t>(i)];
      Builder(primitives, part.Nodes, never).MakeNode(part.First, part.Last, part.Depth);
    }
  };
  const auto count = static_cast<vtkIdType>(parts.size());
  const vtkIdType round = 4 * vtkSMPTools::GetEstimatedNumberOfThreads();
  for (vtkIdType first = 0; first < count; first += round)
  {
    check.Poll();
    LoopOnThreads(first, std::min(count, first + round), build);
  }
  std::size_t size = this->Nodes.size();
  for (const Part& part : parts)
  {
    size += part.Nodes.size();
  }
  this->Nodes.reserve(size);
  for (Part& part : parts)
  {
    this->Append(part);
    part.Nodes = std::vector<Node>();
  }
}

void Bvh::Build(const TriangleMesh& mesh, StopCheck& check)
{
  std::vector<vtkTypeInt32> triangles;
  triangles.reserve(static_cast<std::size_t>(mesh.GetNumberOfTriangles()));
  for (vtkTypeInt32 i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    if (SpansArea(mesh.GetCorner(i, 0), mesh.GetCorner(i, 1), mesh.GetCorner(i, 2)))
    {
      triangles.push_back(i);
    }
  }
  this->Build(mesh, std::move(triangles), check);
}

void Bvh::Build(const TriangleMesh& mesh, std::vector<vtkTypeInt32> triangles, StopCheck& check)
{
  this->Mesh = &mesh;
  this->Order = std::move(triangles);
  this->Nodes = std::vector<Node>();
  const vtkTypeInt32 count = static_cast<vtkTypeInt32>(this->Order.size());
  std::vector<Primitive> primitives(this->Order.size());
  for (vtkTypeInt32 i = 0; i < count; ++i)
  {
    primitives[i] = { GetBox(mesh, this->Order[i]), this->Order[i] };
  }
  Builder builder(primitives, this->Nodes, check);
  if (count > 1)
  {
    std::vector<Part> parts;
    const vtkTypeInt32 size = count / PartsOfTree;
    builder.MakeParts(size < SmallestPart ? 0 : size, parts);
    builder.MakeNode(0, count, 0);
    this->BuildParts(parts, primitives, check);
  }
  else if (count == 1) // a duplicate leaf is harmless
  {
    this->Nodes.emplace_back();
    builder.SetChild(0, 0, 0, 1, 0);
    builder.SetChild(0, 1, 0, 1, 0);
  }
  this->Nodes.shrink_to_fit();
  for (vtkTypeInt32 i = 0; i < count; ++i)
  {
    this->Order[i] = primitives[i].Triangle;
  }
}

/// Calls visit for triangles in boxes that the ray enters at or before range, which visit may
/// reduce.
template <typename VisitT>
void Bvh::Traverse(const TestRay& ray, const double& range, VisitT visit) const
{
  struct Entry
  {
    double Range;
    vtkTypeInt32 First;
    vtkTypeInt32 Count;
  };
  Entry stack[StackSize];
  int size = 0;
  Entry current{ 0.0, 0, 0 };
  while (!this->Nodes.empty())
  {
    if (current.Range <= range && current.Count > 0)
    {
      for (vtkTypeInt32 i = 0; i < current.Count; ++i)
      {
        visit(this->Order[current.First + i]);
      }
    }
    else if (current.Range <= range)
    {
      const Node& node = this->Nodes[current.First];
      Pair low[3], high[3], entry, exit;
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = node.Low[axis] - ray.Origin[axis];
        high[axis] = node.High[axis] - ray.Origin[axis];
      }
      GetBoxRange(low, high, ray.Inverse, entry, exit);
      const auto isEntered = (entry <= exit) & (exit > 0.0) & (entry <= range);
      const int nearer = isEntered[0] && (!isEntered[1] || entry[0] <= entry[1]) ? 0 : 1;
      const int farther = 1 - nearer;
      if (isEntered[farther])
      {
        stack[size++] = { entry[farther], node.First[farther], node.Count[farther] };
      }
      if (isEntered[nearer])
      {
        current = { entry[nearer], node.First[nearer], node.Count[nearer] };
        continue;
      }
    }
    if (size == 0)
    {
      return;
    }
    current = stack[--size];
  }
}

vtkHeliosHit Bvh::Intersect(const TestRay& ray) const
{
  TestRay rest = ray; // its MaximumRange shrinks to the best hit so far
  vtkHeliosHit hit{ NoHit, -1 };
  this->Traverse(rest, rest.MaximumRange,
    [this, &rest, &hit](vtkTypeInt32 triangle)
    {
      const double* points[3] = { this->Mesh->GetCorner(triangle, 0),
        this->Mesh->GetCorner(triangle, 1), this->Mesh->GetCorner(triangle, 2) };
      const double range = TestTriangle(rest, points);
      if (range < hit.Range || (range == hit.Range && triangle < hit.CellId))
      {
        hit = { range, triangle };
        rest.MaximumRange = range;
      }
    });
  return hit;
}

bool Bvh::IsOccluded(const TestRay& ray) const
{
  double range = ray.MaximumRange; // drops below every entry after the first hit
  this->Traverse(ray, range,
    [this, &ray, &range](vtkTypeInt32 triangle)
    {
      const double* points[3] = { this->Mesh->GetCorner(triangle, 0),
        this->Mesh->GetCorner(triangle, 1), this->Mesh->GetCorner(triangle, 2) };
      range = TestTriangle(ray, points) < NoHit ? -NoHit : range;
    });
  return range < 0.0;
}

std::size_t Bvh::GetMemorySize() const
{
  return this->Nodes.capacity() * sizeof(Node) + this->Order.capacity() * sizeof(vtkTypeInt32);
}

} // namespace helios
