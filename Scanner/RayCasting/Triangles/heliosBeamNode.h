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

/// Three numbers of ten bits in a word, for x, y, z from the lowest bit.
struct PackedWord
{
  static constexpr int Bits = 10;
  static constexpr int Largest = (1 << Bits) - 1;
  static constexpr int Masks[3] = { Largest, Largest << Bits, Largest << 2 * Bits };
  static constexpr float Units[3] = { 1.0f, 0x1p-10f, 0x1p-20f }; ///< 1 / (a number of one)
};

/**
 * A stored node: child i covers the numbers Low[i] to High[i]. A number q of an axis is at Origin + q
 * step, the step being a power of two; boxes are larger than needed by Margin steps, which covers
 * the rounding of (Origin - o) r + q (step r) for an origin o of rays, a factor r.
 */
struct alignas(64) PackedNode
{
  static constexpr double Margin = 0x1p-9;

  float Origin[4];  ///< and zero, for vectors
  float Factors[4]; ///< steps, of numbers that are not moved to the lowest bit; number of children
  vtkTypeInt32 Low[BeamNode::Width];
  vtkTypeInt32 High[BeamNode::Width];
  vtkTypeUInt32 Children[BeamNode::Width];

  int GetCount() const { return static_cast<int>(this->Factors[3]); }
};

/// The frame of the words of a leaf: a number q of an axis is at Origin + q step, a power of two.
struct PackedFrame
{
  float Origin[3];
  unsigned char Exponents[3]; ///< exponents of the steps, as floats store them
  unsigned char Count;        ///< triangles

  float GetStep(int axis) const
  {
    const vtkTypeUInt32 bits = static_cast<vtkTypeUInt32>(this->Exponents[axis]) << 23;
    float step;
    std::memcpy(&step, &bits, sizeof(step));
    return step;
  }
};

/// Up to four triangles, and their corners in the frame of the tree: rounded to floats, or packed.
struct BeamLeaf
{
  static constexpr int Size = 4;

  int Count = 0;
  const vtkTypeInt32* Triangles = nullptr;
  const PackedFrame* Frame = nullptr; ///< frame of packed corners; null: floats

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
