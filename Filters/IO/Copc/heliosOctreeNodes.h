// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Divides points that come along a Morton curve among the nodes of an octree.

#ifndef heliosOctreeNodes_h
#define heliosOctreeNodes_h

#include "heliosPointSort.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace helios
{

/// Bits of a Morton code per axis.
inline constexpr int MortonBits = 21;

/// Bits per axis of the grid of a node: 128 x 128 x 128 cells.
inline constexpr int OctreeGridBits = 7;

/// Inserts two zeros between the bits of a number below 2^21.
VTKHELIOSFILTERSIO_EXPORT std::uint64_t SpreadMorton(std::uint64_t value);

/// Returns the number whose bits, with two others between them, are those of a code.
VTKHELIOSFILTERSIO_EXPORT std::uint64_t GatherMorton(std::uint64_t code);

/// A node with its points, in the order in which they came.
struct OctreeNode
{
  int Level = 0;          ///< 0: the root
  std::uint64_t Code = 0; ///< 3 bits a level
  std::vector<std::uint64_t> Indices;
  std::vector<char> Records;
};

/**
 * A node has one point of each cell of its grid that has any, and its children the others; a node
 * that has no more than Few points, and one of the deepest level, has all. Only nodes about the
 * last point are in memory: at most 8 Few points a level, and those of the open nodes.
 */
class VTKHELIOSFILTERSIO_EXPORT OctreeNodes
{
public:
  using UseNode = std::function<Status(OctreeNode&&)>;

  static constexpr std::uint64_t Few = 20000;

  /// Passes each node on when it is complete; records have a length [bytes].
  OctreeNodes(std::size_t length, UseNode use);

  /// Adds the next point along the curve.
  Status Add(const SortedPoint& point);

  /// Passes the last nodes on.
  Status Finish() { return this->CloseFrom(0); }

private:
  static constexpr int Deepest = MortonBits - OctreeGridBits;

  struct Open
  {
    bool IsOpen = false;
    bool IsDivided = false; ///< a descendant was passed on
    std::uint64_t Cell = 0; ///< cell of the last point
    OctreeNode Node;
    std::vector<OctreeNode> Children; ///< complete ones that were not passed on
  };

  Status CloseFrom(int level);
  Status Close(int level);

  std::size_t Length;
  UseNode Use;
  std::array<Open, Deepest + 1> Levels;
};

} // namespace helios

#endif
