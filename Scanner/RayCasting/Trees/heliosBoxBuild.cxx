// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Builds a tree over boxes that are needed for a short time only.
#include "heliosBeamPacking.h"
#include "heliosBeamTree.h"

#include <algorithm>
#include <limits>

namespace helios
{

namespace
{

constexpr float Endless = std::numeric_limits<float>::max();

/// A box in the frame of the tree, and its number.
struct NumberedBox
{
  PlainBox Box;
  vtkTypeUInt32 Number;

  float GetCentre(int axis) const { return this->Box.Low[axis] + this->Box.High[axis]; }
};

void Add(PlainBox& all, const PlainBox& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    all.Low[axis] = std::min(all.Low[axis], box.Low[axis]);
    all.High[axis] = std::max(all.High[axis], box.High[axis]);
  }
}

/// Divides boxes in halves, along the longest side of their centres, three times for each node.
class BoxBuilder
{
public:
  BoxBuilder(std::vector<NumberedBox>& boxes, BeamStorage& tree)
    : Boxes(boxes)
    , Tree(tree)
  {
  }

  /// Adds the node of some boxes, and those below; returns its number.
  vtkTypeUInt32 AddNode(std::size_t first, std::size_t last, PlainBox& bounds)
  {
    const std::size_t number = this->Tree.Nodes.GetSize();
    this->Tree.Nodes.Resize(number + 1);
    std::size_t ends[BeamNode::Width + 1] = { first, last };
    int count = 1;
    for (int level = 0; level < 3; ++level)
    {
      for (int i = count; i-- > 0;)
      {
        ends[2 * i + 2] = ends[i + 1];
        ends[2 * i + 1] = this->Halve(ends[i], ends[i + 1]);
        ends[2 * i] = ends[i];
      }
      count *= 2;
    }
    PlainBox boxes[BeamNode::Width];
    vtkTypeUInt32 children[BeamNode::Width] = {};
    int size = 0;
    bounds = { { Endless, Endless, Endless }, { -Endless, -Endless, -Endless } };
    for (int i = 0; i < count; ++i)
    {
      if (ends[i] < ends[i + 1])
      {
        children[size] = ends[i] + 1 == ends[i + 1]
          ? this->AddLeaf(ends[i], boxes[size])
          : this->AddNode(ends[i], ends[i + 1], boxes[size]);
        Add(bounds, boxes[size++]);
      }
    }
    PackedNode& node = this->Tree.Nodes[number];
    PackBoxes(boxes, size, node);
    std::copy_n(children, BeamNode::Width, node.Children);
    return static_cast<vtkTypeUInt32>(number);
  }

private:
  /// Returns the middle of some boxes, and moves the lower half before it.
  std::size_t Halve(std::size_t first, std::size_t last)
  {
    const std::size_t middle = first + (last - first + 1) / 2;
    if (last - first < 2)
    {
      return middle;
    }
    float low[3] = { Endless, Endless, Endless };
    float high[3] = { -Endless, -Endless, -Endless };
    for (std::size_t i = first; i < last; ++i)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], this->Boxes[i].GetCentre(axis));
        high[axis] = std::max(high[axis], this->Boxes[i].GetCentre(axis));
      }
    }
    const float sides[3] = { high[0] - low[0], high[1] - low[1], high[2] - low[2] };
    const auto axis = static_cast<int>(std::max_element(sides, sides + 3) - sides);
    const auto at = [this](std::size_t i)
    { return this->Boxes.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last),
      [axis](const NumberedBox& a, const NumberedBox& b)
      { return a.GetCentre(axis) < b.GetCentre(axis); });
    return middle;
  }

  vtkTypeUInt32 AddLeaf(std::size_t i, PlainBox& box)
  {
    constexpr std::size_t head = sizeof(PackedFrame) / sizeof(vtkTypeUInt32);
    const std::size_t place = this->Tree.Leaves.GetSize();
    this->Tree.Leaves.Resize(place + head + 1);
    PackedFrame frame = {};
    frame.Count = 1;
    std::copy_n(reinterpret_cast<const vtkTypeUInt32*>(&frame), head, &this->Tree.Leaves[place]);
    this->Tree.Leaves[place + head] = this->Boxes[i].Number;
    box = this->Boxes[i].Box;
    return static_cast<vtkTypeUInt32>(place) | BeamNode::LeafBit;
  }

  std::vector<NumberedBox>& Boxes;
  BeamStorage& Tree;
};

} // namespace

void BeamTree::Build(const std::vector<std::array<double, 6>>& boxes)
{
  *this = BeamTree();
  if (boxes.empty())
  {
    return;
  }
  double low[3], high[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = boxes.front()[2 * axis];
    high[axis] = boxes.front()[2 * axis + 1];
    for (const auto& box : boxes)
    {
      low[axis] = std::min(low[axis], box[2 * axis]);
      high[axis] = std::max(high[axis], box[2 * axis + 1]);
    }
  }
  this->Frame.Set(low, high);
  std::vector<NumberedBox> local(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    local[i].Number = static_cast<vtkTypeUInt32>(i);
    for (int axis = 0; axis < 3; ++axis)
    {
      local[i].Box.Low[axis] = RoundDown(this->Frame.GetLocal(boxes[i][2 * axis], axis));
      local[i].Box.High[axis] = RoundUp(this->Frame.GetLocal(boxes[i][2 * axis + 1], axis));
    }
  }
  PlainBox bounds;
  this->Storage.Root = BoxBuilder(local, this->Storage).AddNode(0, local.size(), bounds);
}

} // namespace helios
