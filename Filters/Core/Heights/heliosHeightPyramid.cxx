// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosHeightPyramid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace helios
{

namespace
{

constexpr int Width = HeightPyramid::Width;
constexpr int BlockSize = HeightPyramid::BlockSize;
constexpr int Strips = BlockSize / HeightPyramid::StripSize; // of a row of a block

std::int64_t Divide(std::int64_t a, std::int64_t b)
{
  return (a + b - 1) / b;
}

/// The smallest and the largest of some heights.
template <typename T>
struct Interval
{
  T Low = std::numeric_limits<T>::max();
  T High = -std::numeric_limits<T>::max();

  /// A NaN changes nothing.
  void Add(T height)
  {
    this->Low = height < this->Low ? height : this->Low;
    this->High = height > this->High ? height : this->High;
  }
};

/// Sets a child from two adjacent intervals.
template <typename T>
void SetChild(HeightPyramid::Extents& extents, int child, const Interval<T>& a,
  const Interval<T>& b, double base)
{
  const T low = std::min(a.Low, b.Low);
  const T high = std::max(a.High, b.High);
  if (low > high)
  {
    return;
  }
  const double least = static_cast<double>(low) - base;
  const double most = static_cast<double>(high) - base;
  extents.Low[child] = static_cast<float>(least - std::abs(least) * 0x1p-23);
  extents.High[child] = static_cast<float>(most + std::abs(most) * 0x1p-23);
}

void Clear(HeightPyramid::Extents& extents)
{
  std::fill_n(extents.Low, Width, HeightPyramid::None);
  std::fill_n(extents.High, Width, -HeightPyramid::None);
}

} // namespace

template <typename T>
void HeightPyramid::ComputeExtents(
  const T* heights, std::int64_t row, std::int64_t column, Extents& extents) const
{
  Clear(extents);
  const std::int64_t firstRow = BlockSize * row;
  const std::int64_t firstColumn = BlockSize * column;
  const std::int64_t rows = std::min<std::int64_t>(BlockSize + 1, this->Grid.Rows - firstRow);
  const std::int64_t columns =
    std::min<std::int64_t>(BlockSize + 1, this->Grid.Columns - firstColumn);
  Interval<T> above[Strips];
  for (std::int64_t r = 0; r < rows; ++r)
  {
    const T* from = heights + (firstRow + r) * this->Grid.Columns + firstColumn;
    Interval<T> below[Strips];
    for (int strip = 0; strip < Strips; ++strip)
    {
      const std::int64_t first = StripSize * strip;
      const std::int64_t last = std::min<std::int64_t>(first + StripSize, columns - 1);
      for (std::int64_t c = first; c <= last && first + 1 < columns; ++c)
      {
        below[strip].Add(from[c]);
      }
      if (r > 0)
      {
        SetChild(extents, static_cast<int>(r - 1) * Strips + strip, above[strip], below[strip],
          this->Base);
      }
      above[strip] = below[strip];
    }
  }
}

void HeightPyramid::ComputeExtents(std::int64_t row, std::int64_t column, Extents& extents) const
{
  if (this->Grid.Floats)
  {
    this->ComputeExtents(this->Grid.Floats, row, column, extents);
    return;
  }
  this->ComputeExtents(this->Grid.Doubles, row, column, extents);
}

HeightPyramid::Level HeightPyramid::MakeLevel(const Level& below) const
{
  Level level;
  level.ChildColumns = below.ChildColumns == 2 ? 4 : 2;
  const int childRows = Width / level.ChildColumns;
  level.CellColumns = level.ChildColumns * below.CellColumns;
  level.CellRows = childRows * below.CellRows;
  level.Columns = Divide(below.Columns, level.ChildColumns);
  level.Rows = Divide(below.Rows, childRows);
  Extents none;
  Clear(none);
  level.Nodes.assign(static_cast<std::size_t>(level.Columns * level.Rows), none);
  for (std::int64_t row = 0; row < below.Rows; ++row)
  {
    Extents* parents = level.Nodes.data() + row / childRows * level.Columns;
    const auto first = static_cast<int>(row % childRows) * level.ChildColumns;
    for (std::int64_t column = 0; column < below.Columns; ++column)
    {
      Extents computed;
      const Extents* extents = &computed;
      if (below.Nodes.empty())
      {
        this->ComputeExtents(row, column, computed);
      }
      else
      {
        extents = &below.Nodes[static_cast<std::size_t>(row * below.Columns + column)];
      }
      Extents& parent = parents[column / level.ChildColumns];
      const auto child = first + static_cast<int>(column % level.ChildColumns);
      parent.Low[child] = *std::min_element(extents->Low, extents->Low + Width);
      parent.High[child] = *std::max_element(extents->High, extents->High + Width);
    }
  }
  return level;
}

void HeightPyramid::Build(const HeightGrid& grid, double base)
{
  this->Grid = grid;
  this->Base = base;
  this->Levels.clear();
  Level blocks;
  blocks.Columns = Divide(grid.Columns - 1, BlockSize);
  blocks.Rows = Divide(grid.Rows - 1, BlockSize);
  blocks.ChildColumns = Strips;
  blocks.CellColumns = BlockSize;
  blocks.CellRows = BlockSize;
  this->Levels.push_back(std::move(blocks));
  while (this->Levels.back().Columns * this->Levels.back().Rows > 1)
  {
    this->Levels.push_back(this->MakeLevel(this->Levels.back()));
  }
}

std::size_t HeightPyramid::GetMemorySize() const
{
  std::size_t size = 0;
  for (const Level& level : this->Levels)
  {
    size += level.Nodes.capacity() * sizeof(Extents);
  }
  return size;
}

} // namespace helios
