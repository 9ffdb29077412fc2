// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The nodes and leaves that a BeamTree stores.

#ifndef heliosBeamStorage_h
#define heliosBeamStorage_h

#include "heliosBeamNode.h"
#include "heliosTreeArray.h"

#include <vtkType.h>

#include <cstddef>

namespace helios
{

/// The frame of a tree: coordinates are (x - Centre) Scale.
struct TreeFrame
{
  double Centre[3] = { 0, 0, 0 };
  double Half[3] = { 0, 0, 0 }; ///< half sides of the box
  double Scale = 0.0;           ///< a power of two, into [-1, 1]; zero for an empty tree

  void Set(const double low[3], const double high[3]);
  double GetLocal(double x, int axis) const { return (x - this->Centre[axis]) * this->Scale; }
};

/// The nodes of a tree, its leaves (a PackedFrame, triangles, words of their corners), and the root.
struct BeamStorage
{
  TreeArray<PackedNode> Nodes;
  TreeArray<vtkTypeUInt32> Leaves;
  vtkTypeUInt32 Root = 0;

  std::size_t GetMemorySize() const
  {
    return this->Nodes.GetMemorySize() + this->Leaves.GetMemorySize();
  }

  /// Returns the leaf of a number without LeafBit.
  BeamLeaf GetLeaf(vtkTypeUInt32 number) const
  {
    constexpr std::size_t head = sizeof(PackedFrame) / sizeof(vtkTypeUInt32);
    const vtkTypeUInt32* words = &this->Leaves[number];
    const auto* frame = reinterpret_cast<const PackedFrame*>(words);
    return { frame->Count, reinterpret_cast<const vtkTypeInt32*>(words + head), frame };
  }
};

} // namespace helios

#endif
