// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBeamPart.h"

#include "heliosTriangleMesh.h"

#include <cstring>

namespace helios
{

/// The box of a triangle, rounded outwards.
struct BeamPart::FineBox
{
  float Low[4]; ///< the triangle in the fourth lane
  float High[4];

  FineBox() = default;
  FineBox(const TriangleMesh& mesh, const TreeFrame& frame, vtkTypeInt32 triangle)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double a = mesh.GetCorner(triangle, 0)[axis];
      const double b = mesh.GetCorner(triangle, 1)[axis];
      const double c = mesh.GetCorner(triangle, 2)[axis];
      this->Low[axis] = RoundDown(frame.GetLocal(std::min({ a, b, c }), axis));
      this->High[axis] = RoundUp(frame.GetLocal(std::max({ a, b, c }), axis));
    }
    std::memcpy(this->Low + 3, &triangle, sizeof(triangle));
    this->High[3] = 0.0f;
  }

  vtkTypeInt32 GetTriangle() const
  {
    vtkTypeInt32 triangle;
    std::memcpy(&triangle, this->Low + 3, sizeof(triangle));
    return triangle;
  }

  HELIOS_INLINE Floats GetLow() const
  {
    const ShortMasks isAxis = { -1, -1, -1, 0 };
    return reinterpret_cast<Floats>(Load<ShortMasks>(this->Low) & isAxis);
  }
  HELIOS_INLINE Floats GetHigh() const { return Load<Floats>(this->High); }
};

namespace
{

/// A range of boxes whose node, a side of another one, is made later.
struct Range
{
  vtkTypeInt32 First;
  vtkTypeInt32 Last;
  vtkTypeInt32 Parent;
  int Side;
  int Depth;
  Extent Centres;
};

} // namespace

//------------------------------------------------------------------------------
/// Makes the binary nodes of at least two boxes, which it sorts.
HELIOS_CLONES
void BeamPart::Split(
  FineBox* boxes, vtkTypeInt32 count, int depth, std::vector<SplitNode>& nodes) const
{
  Range range{ 0, count, -1, 0, depth, {} };
  for (vtkTypeInt32 i = 0; i < count; ++i)
  {
    const Floats centre = boxes[i].GetLow() + boxes[i].GetHigh();
    range.Centres.Add(centre, centre);
  }
  std::vector<Range> waiting{ range };
  while (!waiting.empty())
  {
    range = waiting.back();
    waiting.pop_back();
    BoxBins bins(range.Centres, Floats() + 1.0f);
    for (vtkTypeInt32 i = range.First; i < range.Last; ++i)
    {
      bins.Add(boxes[i]);
    }
    Extent halves[2], centres[2];
    vtkTypeInt32 middle;
    if (range.Depth < BoxBins::MaximumDepth && bins.FindSplit())
    {
      middle = Partition(boxes, range.First, range.Last, bins, centres);
      bins.GetHalves(halves);
    }
    else
    {
      middle = Halve(boxes, range.First, range.Last, range.Centres, centres);
      for (vtkTypeInt32 i = range.First; i < range.Last; ++i)
      {
        halves[i < middle ? 0 : 1].Add(boxes[i].GetLow(), boxes[i].GetHigh());
      }
    }
    const auto index = static_cast<vtkTypeInt32>(nodes.size());
    nodes.emplace_back();
    if (range.Parent >= 0)
    {
      nodes[static_cast<std::size_t>(range.Parent)].First[range.Side] = index;
    }
    const vtkTypeInt32 ends[3] = { range.First, middle, range.Last };
    for (int side = 1; side >= 0; --side)
    {
      const vtkTypeInt32 size = ends[side + 1] - ends[side];
      SplitNode& node = nodes.back();
      for (int axis = 0; axis < 3; ++axis)
      {
        node.Low[side][axis] = halves[side].Low[axis];
        node.High[side][axis] = halves[side].High[axis];
      }
      node.First[side] = ends[side];
      node.Count[side] = size <= this->LeafSize ? size : 0;
      if (size > this->LeafSize)
      {
        waiting.push_back(
          { ends[side], ends[side + 1], index, side, range.Depth + 1, centres[side] });
      }
    }
  }
}

//------------------------------------------------------------------------------
void BeamPart::Build(const TriangleMesh& mesh, const TreeFrame& frame, const CoarseBox* boxes,
  vtkTypeInt32 count, int depth)
{
  std::vector<FineBox> fine;
  fine.reserve(static_cast<std::size_t>(count));
  for (vtkTypeInt32 i = 0; i < count; ++i)
  {
    fine.emplace_back(mesh, frame, boxes[i].GetTriangle());
  }
  std::vector<SplitNode> binary;
  if (count > this->LeafSize)
  {
    binary.reserve(static_cast<std::size_t>(count) / 2);
    this->Split(fine.data(), count, depth, binary);
  }
  this->MakeNodes(mesh, frame, fine, binary);
}

//------------------------------------------------------------------------------
void BeamPart::MakeNodes(const TriangleMesh& mesh, const TreeFrame& frame,
  const std::vector<FineBox>& boxes, const std::vector<SplitNode>& binary)
{
  const auto addLeaf = [&](vtkTypeInt32 first, vtkTypeInt32 count)
  { return this->AddLeaf(mesh, frame, &boxes[static_cast<std::size_t>(first)], count); };
  Extent bounds;
  for (const FineBox& box : boxes)
  {
    bounds.Add(box.GetLow(), box.GetHigh());
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Bounds.Low[axis] = bounds.Low[axis];
    this->Bounds.High[axis] = bounds.High[axis];
  }
  if (!binary.empty())
  {
    WideNodes(binary, addLeaf).Make(0, this->Nodes);
    return;
  }
  PackedNode node = {};
  node.Children[0] = addLeaf(0, static_cast<vtkTypeInt32>(boxes.size()));
  PackBoxes(&this->Bounds, 1, node);
  this->Nodes.push_back(node);
}

//------------------------------------------------------------------------------
vtkTypeUInt32 BeamPart::AddLeaf(
  const TriangleMesh& mesh, const TreeFrame& frame, const FineBox* boxes, int count)
{
  constexpr std::size_t head = sizeof(PackedFrame) / sizeof(vtkTypeUInt32);
  const auto triangles = static_cast<std::size_t>(count);
  const std::size_t made = this->Leaves.size();
  this->Leaves.resize(made + head + 4 * triangles);
  vtkTypeUInt32* words = &this->Leaves[made];
  double corners[BeamLeaf::Size][3][3];
  for (int i = 0; i < count; ++i)
  {
    const vtkTypeInt32 triangle = boxes[i].GetTriangle();
    words[head + static_cast<std::size_t>(i)] = static_cast<vtkTypeUInt32>(triangle);
    for (int k = 0; k < 9; ++k)
    {
      corners[i][k / 3][k % 3] = frame.GetLocal(mesh.GetCorner(triangle, k / 3)[k % 3], k % 3);
    }
  }
  PackedFrame packed;
  PackCorners(corners, count, packed, words + head + triangles);
  std::memcpy(words, &packed, sizeof(packed));
  return static_cast<vtkTypeUInt32>(made) | BeamNode::LeafBit;
}

} // namespace helios
