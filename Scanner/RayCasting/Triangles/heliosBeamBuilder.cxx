// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBeamBuilder.h"

#include "heliosBeamPart.h"
#include "heliosThreadLoop.h"
#include "heliosTriangleMesh.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

constexpr double Steps = 65535.0; // steps of coarse boxes

// A tree has at least this many parts, unless they are small.
constexpr vtkTypeInt32 PartsOfTree = 64;
constexpr vtkTypeInt32 SmallestPart = 4096; // triangles
constexpr vtkTypeInt32 LargestPart = 1 << 18;
constexpr vtkTypeInt32 Chunk = 1 << 17; // coarse boxes that a thread adds to bins

using Coarse = CoarseBox;

/// A range of coarse boxes whose node, a side of another one, is made later.
struct CoarseRange
{
  vtkTypeInt32 First;
  vtkTypeInt32 Last;
  vtkTypeInt32 Parent;
  int Side;
  int Depth;
  Extent Centres;
};

HELIOS_CLONES
void AddBoxes(const Coarse* boxes, vtkTypeInt32 first, vtkTypeInt32 last, BoxBins& bins)
{
  for (vtkTypeInt32 i = first; i < last; ++i)
  {
    bins.Add(boxes[i]);
  }
}

/// Adds the boxes of a range to bins, on all threads.
void AddAll(const Coarse* boxes, const CoarseRange& range, BoxBins& bins)
{
  const vtkTypeInt32 chunks = (range.Last - range.First + Chunk - 1) / Chunk;
  std::vector<BoxBins> all(static_cast<std::size_t>(chunks), bins);
  LoopOnThreads(0, chunks,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto first = range.First + static_cast<vtkTypeInt32>(i) * Chunk;
        AddBoxes(
          boxes, first, std::min(range.Last, first + Chunk), all[static_cast<std::size_t>(i)]);
      }
    });
  for (const BoxBins& each : all)
  {
    bins.Add(each);
  }
}

HELIOS_CLONES
vtkTypeInt32 DivideRange(Coarse* boxes, const CoarseRange& range, BoxBins& bins, Extent centres[2])
{
  return range.Depth < BoxBins::MaximumDepth && bins.FindSplit()
    ? Partition(boxes, range.First, range.Last, bins, centres)
    : Halve(boxes, range.First, range.Last, range.Centres, centres);
}

} // namespace

//------------------------------------------------------------------------------
void TreeFrame::Set(const double low[3], const double high[3])
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Centre[axis] = 0.5 * low[axis] + 0.5 * high[axis];
    this->Half[axis] =
      Max(high[axis] - this->Centre[axis], this->Centre[axis] - low[axis]) * (1 + 0x1p-23);
    largest = Max(largest, this->Half[axis]);
  }
  this->Scale = std::ldexp(1.0, -std::ilogb(largest) - 1);
}

//------------------------------------------------------------------------------
BeamBuilder::BeamBuilder(
  const TriangleMesh& mesh, const TreeFrame& frame, vtkIdType count, int leafSize)
  : Mesh(mesh)
  , Frame(frame)
  , LeafSize(leafSize)
{
  this->Boxes.Resize(static_cast<std::size_t>(count));
}

BeamBuilder::~BeamBuilder() = default;

//------------------------------------------------------------------------------
void BeamBuilder::SetTriangle(vtkIdType i, vtkTypeInt32 triangle)
{
  CoarseBox& box = this->Boxes[static_cast<std::size_t>(i)];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double a = this->Mesh.GetCorner(triangle, 0)[axis];
    const double b = this->Mesh.GetCorner(triangle, 1)[axis];
    const double c = this->Mesh.GetCorner(triangle, 2)[axis];
    const double half = this->Frame.Half[axis];
    const double scale = half > 0.0 ? 0.5 * Steps / half : 0.0;
    const double start = this->Frame.Centre[axis] - half;
    const double low = (std::min({ a, b, c }) - start) * scale;
    const double high = (std::max({ a, b, c }) - start) * scale;
    box.Values[axis] = static_cast<vtkTypeUInt16>(std::min(std::max(low, 0.0), Steps));
    box.Values[3 + axis] = static_cast<vtkTypeUInt16>(std::min(std::max(high, 0.0), Steps));
  }
  std::memcpy(box.Values + 6, &triangle, sizeof(triangle));
}

//------------------------------------------------------------------------------
void BeamBuilder::Build(BeamStorage& tree, StopCheck& check)
{
  const auto count = static_cast<vtkTypeInt32>(this->Boxes.GetSize());
  const vtkTypeInt32 size = std::max(SmallestPart, std::min(LargestPart, count / PartsOfTree));
  if (count <= size)
  {
    this->Parts.push_back({ 0, count, 0, 0, {} });
  }
  else
  {
    this->Divide(size, check);
  }
  this->BuildParts(tree, check);
  tree.Root = this->Parts.front().Root;
  if (!this->Top.empty())
  {
    this->SetTopBoxes();
    this->MakeTop(tree);
  }
  const std::size_t size0 = tree.Leaves.GetSize();
  tree.Leaves.Resize(size0 + BeamLeaf::Size); // vectors read past the end
  std::fill_n(&tree.Leaves[size0], BeamLeaf::Size, 0u);
  tree.Leaves.Shrink();
  tree.Nodes.Shrink();
}

//------------------------------------------------------------------------------
/// Divides the triangles into parts of a maximum size.
void BeamBuilder::Divide(vtkTypeInt32 size, StopCheck& check)
{
  CoarseBox* boxes = &this->Boxes[0];
  Floats sides = Floats();
  for (int axis = 0; axis < 3; ++axis)
  {
    sides[axis] = static_cast<float>(this->Frame.Half[axis] * this->Frame.Scale);
  }
  CoarseRange range{ 0, static_cast<vtkTypeInt32>(this->Boxes.GetSize()), -1, 0, 0, {} };
  range.Centres.Add(Floats(), Floats() + static_cast<float>(2 * Steps));
  std::vector<CoarseRange> waiting{ range };
  while (!waiting.empty())
  {
    check.Poll();
    range = waiting.back();
    waiting.pop_back();
    BoxBins bins(range.Centres, sides);
    AddAll(boxes, range, bins);
    Extent centres[2];
    const vtkTypeInt32 middle = DivideRange(boxes, range, bins, centres);
    const auto index = static_cast<vtkTypeInt32>(this->Top.size());
    this->Top.emplace_back();
    if (range.Parent >= 0)
    {
      this->Top[static_cast<std::size_t>(range.Parent)].First[range.Side] = index;
    }
    const vtkTypeInt32 ends[3] = { range.First, middle, range.Last };
    for (int side = 0; side < 2; ++side)
    {
      const vtkTypeInt32 first = ends[side];
      const vtkTypeInt32 last = ends[side + 1];
      const bool isPart = last - first <= size;
      this->Top.back().First[side] = static_cast<vtkTypeInt32>(this->Parts.size());
      this->Top.back().Count[side] = isPart ? 1 : 0;
      if (isPart)
      {
        this->Parts.push_back({ first, last, range.Depth + 1, 0, {} });
      }
      else
      {
        waiting.push_back({ first, last, index, side, range.Depth + 1, centres[side] });
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Builds the parts on all threads, in rounds between checks for a stop; frees their coarse boxes.
void BeamBuilder::BuildParts(BeamStorage& tree, StopCheck& check)
{
  std::vector<std::size_t> order(this->Parts.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  std::sort(order.begin(), order.end(),
    [this](std::size_t a, std::size_t b) { return this->Parts[a].First > this->Parts[b].First; });
  const auto round =
    static_cast<std::size_t>(2 * std::max(1, vtkSMPTools::GetEstimatedNumberOfThreads()));
  for (std::size_t first = 0; first < order.size(); first += round)
  {
    check.Poll();
    const std::size_t last = std::min(order.size(), first + round);
    std::vector<BeamPart> built(last - first, BeamPart(this->LeafSize));
    LoopOnThreads(0, static_cast<vtkIdType>(built.size()),
      [&](vtkIdType begin, vtkIdType end)
      {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        {
          const Part& part = this->Parts[order[first + i]];
          built[i].Build(this->Mesh, this->Frame,
            &this->Boxes[static_cast<std::size_t>(part.First)], part.Last - part.First, part.Depth);
        }
      });
    for (std::size_t i = 0; i < built.size(); ++i)
    {
      this->Append(built[i], this->Parts[order[first + i]], tree);
      built[i] = BeamPart(this->LeafSize);
    }
    this->Boxes.Resize(static_cast<std::size_t>(this->Parts[order[last - 1]].First));
    this->Boxes.Shrink();
  }
}

//------------------------------------------------------------------------------
void BeamBuilder::Append(const BeamPart& from, Part& part, BeamStorage& tree) const
{
  const std::size_t nodes = tree.Nodes.GetSize();
  const std::size_t leaves = tree.Leaves.GetSize();
  tree.Nodes.Resize(nodes + from.Nodes.size());
  tree.Leaves.Resize(leaves + from.Leaves.size());
  for (std::size_t i = 0; i < from.Nodes.size(); ++i)
  {
    PackedNode& node = tree.Nodes[nodes + i];
    node = from.Nodes[i];
    for (int child = 0; child < node.GetCount(); ++child)
    {
      const bool isLeaf = node.Children[child] & BeamNode::LeafBit;
      node.Children[child] += static_cast<vtkTypeUInt32>(isLeaf ? leaves : nodes);
    }
  }
  std::copy(from.Leaves.begin(), from.Leaves.end(), &tree.Leaves[leaves]);
  part.Root = static_cast<vtkTypeUInt32>(nodes);
  part.Bounds = from.Bounds;
}

//------------------------------------------------------------------------------
/// Sets the boxes of the nodes above the parts; children follow their parents.
void BeamBuilder::SetTopBoxes()
{
  for (std::size_t i = this->Top.size(); i-- > 0;)
  {
    SplitNode& node = this->Top[i];
    for (int side = 0; side < 2; ++side)
    {
      const auto first = static_cast<std::size_t>(node.First[side]);
      for (int axis = 0; axis < 3; ++axis)
      {
        if (node.Count[side] > 0)
        {
          node.Low[side][axis] = this->Parts[first].Bounds.Low[axis];
          node.High[side][axis] = this->Parts[first].Bounds.High[axis];
          continue;
        }
        const SplitNode& child = this->Top[first];
        node.Low[side][axis] = std::min(child.Low[0][axis], child.Low[1][axis]);
        node.High[side][axis] = std::max(child.High[0][axis], child.High[1][axis]);
      }
    }
  }
}

//------------------------------------------------------------------------------
/// Makes the wide nodes above the parts.
void BeamBuilder::MakeTop(BeamStorage& tree) const
{
  std::vector<PackedNode> nodes;
  const auto offset = static_cast<vtkTypeUInt32>(tree.Nodes.GetSize());
  // Marks the roots of parts, which have their final numbers, as leaves do.
  const auto getRoot = [this](vtkTypeInt32 part, vtkTypeInt32)
  { return this->Parts[static_cast<std::size_t>(part)].Root | BeamNode::LeafBit; };
  WideNodes(this->Top, getRoot).Make(0, nodes);
  tree.Nodes.Resize(offset + nodes.size());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    for (int child = 0; child < nodes[i].GetCount(); ++child)
    {
      vtkTypeUInt32& number = nodes[i].Children[child];
      number = number & BeamNode::LeafBit ? number & ~BeamNode::LeafBit : number + offset;
    }
    tree.Nodes[offset + i] = nodes[i];
  }
  tree.Root = offset;
}

} // namespace helios
