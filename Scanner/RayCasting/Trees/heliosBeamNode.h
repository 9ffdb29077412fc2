// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The nodes and leaves of a wide bounding volume hierarchy.

#ifndef heliosBeamNode_h
#define heliosBeamNode_h

#include <vtkType.h>

#include <algorithm>
#include <cmath>

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

/// Up to four triangles, and their corners in the frame of the tree, rounded.
struct BeamLeaf
{
  static constexpr int Size = 4;

  int Count = 0;
  const vtkTypeInt32* Triangles = nullptr;

  /// Returns where floats start: a coordinate of the triangles, and padding to ignore.
  const vtkTypeInt32* GetCorners(int corner, int axis) const
  {
    return this->Triangles + (1 + 3 * corner + axis) * this->Count;
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
