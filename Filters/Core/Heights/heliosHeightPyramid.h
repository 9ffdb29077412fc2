// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Smallest and largest heights of blocks of a raster, level by level.

#ifndef heliosHeightPyramid_h
#define heliosHeightPyramid_h

#include "heliosHeightGrid.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace helios
{

/**
 * A tree of eight children a node without pointers. A cell is the square of 2 x 2 pixels, named by
 * column and row of its first. The nodes of level 0 are blocks of 4 x 4 cells; their children,
 * strips of two cells of a row, are computed on demand. The other levels are stored: half a byte a
 * cell.
 *
 * level  children of a node   cells of a node 0      2 x 4 strips         4 x 4 1      4 x 2 nodes
 * 16 x 8 2      2 x 4 nodes          32 x 32 ...
 */
class VTKHELIOSFILTERSCORE_EXPORT HeightPyramid
{
public:
  static constexpr int Width = 8;
  static constexpr int BlockSize = 4; ///< cells of a block, along rows and columns
  static constexpr int StripSize = 2; ///< cells of a strip

  /// Heights of eight children relative to the base, rounded outwards; low > high: no heights.
  struct alignas(64) Extents
  {
    float Low[Width];
    float High[Width];
  };
  static constexpr float None = std::numeric_limits<float>::max(); ///< low, and -high

  struct Level
  {
    std::int64_t Columns; ///< in nodes
    std::int64_t Rows;
    int ChildColumns; ///< children of a node in a row: 2 or 4
    std::int64_t CellColumns;
    std::int64_t CellRows;
    std::vector<Extents> Nodes; ///< row by row; none at level 0
  };

  /// Builds the tree of a grid, whose heights must outlive it.
  void Build(const HeightGrid& grid, double base);

  /// Returns the levels; the last one has one node.
  const std::vector<Level>& GetLevels() const { return this->Levels; }

  double GetBase() const { return this->Base; }

  /// Computes the extents of the strips of a block.
  void ComputeExtents(std::int64_t row, std::int64_t column, Extents& extents) const;

  std::size_t GetMemorySize() const;

private:
  template <typename T>
  void ComputeExtents(
    const T* heights, std::int64_t row, std::int64_t column, Extents& extents) const;
  Level MakeLevel(const Level& below) const;

  HeightGrid Grid;
  double Base = 0.0;
  std::vector<Level> Levels;
};

} // namespace helios

#endif
