// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The nodes and leaves of a wide bounding volume hierarchy.

#ifndef heliosBeamNode_h
#define heliosBeamNode_h

#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace helios
{

/// Returns a float not above a number, or not below it.
inline float RoundDown(double x)
{
  return static_cast<float>(std::max(x - std::abs(x) * 0x1p-23, -1e30));
}
inline float RoundUp(double x)
{
  return static_cast<float>(std::min(x + std::abs(x) * 0x1p-23, 1e30));
}

/// A node whose child i covers Low[axis][i] to High[axis][i]: a node or, with the highest bit set,
/// a leaf.
struct alignas(64) BeamNode
{
  static constexpr int Width = 8;
  static constexpr vtkTypeUInt32 LeafBit = 0x80000000u;

  float Low[3][Width];
  float High[3][Width];
  vtkTypeUInt32 Children[Width];
};

/**
 * Numbers of ten bits along three axes, in a word: x, y, z from the lowest bit. A number is at
 * Origin + number Step in the frame of the tree, in floats; a step is a power of two, given by its
 * exponent as floats store it.
 */
struct PackedFrame
{
  static constexpr int Bits = 10;
  static constexpr vtkTypeUInt32 Largest = (1u << Bits) - 1;

  float Origin[3];
  unsigned char Exponents[3];
  unsigned char Count; ///< children or triangles

  float GetStep(int axis) const
  {
    const vtkTypeUInt32 bits = static_cast<vtkTypeUInt32>(this->Exponents[axis]) << 23;
    float step;
    std::memcpy(&step, &bits, sizeof(step));
    return step;
  }
};

/// A stored node: child i covers the numbers Low[i] to High[i], rounded outwards.
struct PackedNode
{
  PackedFrame Frame;
  vtkTypeUInt32 Low[BeamNode::Width];
  vtkTypeUInt32 High[BeamNode::Width];
  vtkTypeUInt32 Children[BeamNode::Width];
};

/// Up to four triangles, and their corners in the frame of the tree: rounded to floats, or packed.
struct BeamLeaf
{
  static constexpr int Size = 4;

  int Count = 0;
  const vtkTypeInt32* Triangles = nullptr;
  const PackedFrame* Frame = nullptr; ///< of packed corners; null: floats

  /// Returns where floats start: a coordinate of the triangles, and padding to ignore.
  const vtkTypeInt32* GetCorners(int corner, int axis) const
  {
    return this->Triangles + (1 + 3 * corner + axis) * this->Count;
  }

  /// Returns where the words of packed corners start, and padding to ignore.
  const vtkTypeInt32* GetWords(int corner) const
  {
    return this->Triangles + (1 + corner) * this->Count;
  }
};

/// A leaf that is not stored; vectors read past its end.
struct BeamLeafData
{
  int Count;
  vtkTypeInt32 Words[11 * BeamLeaf::Size];
};

} // namespace helios

#endif
