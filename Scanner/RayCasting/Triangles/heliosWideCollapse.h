// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Which nodes of a binary tree become children of wide ones. For sources only, as heliosBoxSplit.h.

#ifndef heliosWideCollapse_h
#define heliosWideCollapse_h

#include "heliosBeamNode.h"
#include "heliosBoxSplit.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace helios
{

/**
 * The optimal conversion of a binary tree to a wide one: Cost[k] is the minimum sum of the surfaces
 * of the nodes of its subtree as k children of a wide node; Left[k] is the number of them in the
 * left child, 0 if one less is as good. With k = 1 it becomes a separate node, of Width children.
 * (Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide
 * BVHs", HPG 2017.)
 */
class WideCollapse
{
public:
  static constexpr int Width = BeamNode::Width;

  /// The nodes must outlive this; children follow their parents.
  explicit WideCollapse(const std::vector<SplitNode>& nodes)
    : Nodes(nodes)
    , Shares(nodes.size())
  {
    for (std::size_t i = this->Shares.size(); i-- > 0;)
    {
      this->SetShare(this->Shares[i], nodes[i]);
    }
  }

  /// A child of a wide node: the side of a binary one.
  struct Child
  {
    vtkTypeInt32 Node;
    int Side;
  };

  /// Collects the children of the wide node for a binary one; returns their number.
  int GetChildren(vtkTypeInt32 node, Child children[Width]) const
  {
    int count = 0;
    this->Part(node, this->Shares[static_cast<std::size_t>(node)].Left[1], Width, children, count);
    return count;
  }

private:
  struct Share
  {
    float Cost[Width + 1];
    unsigned char Left[Width + 1];
  };

  float GetCost(const SplitNode& node, int side, int k) const
  {
    return node.Count[side] > 0 ? 0.0f
                                : this->Shares[static_cast<std::size_t>(node.First[side])].Cost[k];
  }

  static float GetHalfArea(const SplitNode& node)
  {
    float d[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      d[axis] = std::max(node.High[0][axis], node.High[1][axis]) -
        std::min(node.Low[0][axis], node.Low[1][axis]);
    }
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }

  void SetShare(Share& share, const SplitNode& node) const
  {
    for (int k = 2; k <= Width; ++k)
    {
      share.Cost[k] = std::numeric_limits<float>::max();
      for (int left = 1; left < k; ++left)
      {
        const float cost = this->GetCost(node, 0, left) + this->GetCost(node, 1, k - left);
        if (cost < share.Cost[k])
        {
          share.Cost[k] = cost;
          share.Left[k] = static_cast<unsigned char>(left);
        }
      }
    }
    share.Left[1] = share.Left[Width];
    share.Cost[1] = share.Cost[Width] + GetHalfArea(node);
    for (int k = 2; k <= Width; ++k)
    {
      if (share.Cost[k - 1] <= share.Cost[k])
      {
        share.Cost[k] = share.Cost[k - 1];
        share.Left[k] = 0;
      }
    }
  }

  /// Distributes k children over the two sides of a node.
  void Part(vtkTypeInt32 node, int left, int k, Child children[Width], int& count) const
  {
    this->Add(node, 0, left, children, count);
    this->Add(node, 1, k - left, children, count);
  }

  void Add(vtkTypeInt32 node, int side, int k, Child children[Width], int& count) const
  {
    const SplitNode& n = this->Nodes[static_cast<std::size_t>(node)];
    const vtkTypeInt32 inner = n.First[side];
    const bool isLeaf = n.Count[side] > 0;
    while (!isLeaf && k > 1 && this->Shares[static_cast<std::size_t>(inner)].Left[k] == 0)
    {
      --k;
    }
    if (isLeaf || k == 1)
    {
      children[count++] = { node, side };
      return;
    }
    this->Part(inner, this->Shares[static_cast<std::size_t>(inner)].Left[k], k, children, count);
  }

  const std::vector<SplitNode>& Nodes;
  std::vector<Share> Shares;
};

} // namespace helios

#endif
