// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The nodes and leaves over some triangles, made by one thread. For sources only, as heliosBoxSplit.h.

#ifndef heliosBeamPart_h
#define heliosBeamPart_h

#include "heliosBeamPacking.h"
#include "heliosBeamStorage.h"
#include "heliosCoarseBox.h"
#include "heliosWideCollapse.h"

#include <vector>

namespace helios
{

class TriangleMesh;

/// Makes wide nodes of a binary tree, each before its children; makeLeaf(first, count) returns the
/// number of a leaf.
template <typename MakeLeafT>
class WideNodes
{
public:
  WideNodes(const std::vector<SplitNode>& binary, MakeLeafT makeLeaf)
    : Binary(binary)
    , Collapse(binary)
    , MakeLeaf(makeLeaf)
  {
  }

  /// Appends a node, and all below it, for a binary one; returns its number.
  vtkTypeUInt32 Make(vtkTypeInt32 index, std::vector<PackedNode>& nodes)
  {
    WideCollapse::Child children[BeamNode::Width];
    const int count = this->Collapse.GetChildren(index, children);
    const std::size_t made = nodes.size();
    nodes.emplace_back();
    PackedNode node = {};
    PlainBox boxes[BeamNode::Width];
    for (int i = 0; i < count; ++i)
    {
      const SplitNode& b = this->Binary[static_cast<std::size_t>(children[i].Node)];
      const int side = children[i].Side;
      std::copy_n(b.Low[side], 3, boxes[i].Low);
      std::copy_n(b.High[side], 3, boxes[i].High);
      node.Children[i] = b.Count[side] > 0 ? this->MakeLeaf(b.First[side], b.Count[side])
                                           : this->Make(b.First[side], nodes);
    }
    PackBoxes(boxes, count, node);
    nodes[made] = node; // here, since making nodes moves them
    return static_cast<vtkTypeUInt32>(made);
  }

private:
  const std::vector<SplitNode>& Binary;
  WideCollapse Collapse;
  MakeLeafT MakeLeaf;
};

/// A part of a tree: its root is the first node; numbers count from its own first node and word.
class BeamPart
{
public:
  std::vector<PackedNode> Nodes;
  std::vector<vtkTypeUInt32> Leaves;
  PlainBox Bounds;

  /// Makes leaves of up to a number of triangles.
  explicit BeamPart(int leafSize)
    : LeafSize(leafSize)
  {
  }

  /// Builds over the triangles of coarse boxes; depth: of its root in the binary tree.
  void Build(const TriangleMesh& mesh, const TreeFrame& frame, const CoarseBox* boxes,
    vtkTypeInt32 count, int depth);

private:
  struct FineBox;

  void Split(FineBox* boxes, vtkTypeInt32 count, int depth, std::vector<SplitNode>& nodes) const;
  void MakeNodes(const TriangleMesh& mesh, const TreeFrame& frame,
    const std::vector<FineBox>& boxes, const std::vector<SplitNode>& binary);
  vtkTypeUInt32 AddLeaf(
    const TriangleMesh& mesh, const TreeFrame& frame, const FineBox* boxes, int count);

  int LeafSize;
};

} // namespace helios

#endif
