// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosHeightPyramid.h"

#include "heliosVectorLoops.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace helios
{

namespace
{

constexpr int Width = HeightPyramid::Width;
constexpr int BlockSize = HeightPyramid::BlockSize;
constexpr int Strips = BlockSize / HeightPyramid::StripSize; // strips in a row of a block

std::int64_t Divide(std::int64_t a, std::int64_t b)
{
  return (a + b - 1) / b;
}

constexpr int Pixels = BlockSize + 1; // pixels at a side of a block

void SetNone(HeightPyramid::Extents& extents, int child)
{
  extents.Low[child] = HeightPyramid::None;
  extents.High[child] = -HeightPyramid::None;
}

/// Sets the extents of the strips of a whole block. A NaN changes nothing.
template <typename T>
HELIOS_INLINE void SetExtents(
  const T* pixels, std::int64_t step, double base, HeightPyramid::Extents& extents)
{
  T low[Pixels * Strips]; // one of three pixels in a row
  T high[Pixels * Strips];
  for (int i = 0; i < Pixels * Strips; ++i)
  {
    const T* from = pixels + i / Strips * step + HeightPyramid::StripSize * (i % Strips);
    low[i] = std::numeric_limits<T>::max();
    high[i] = -std::numeric_limits<T>::max();
    for (int k = 0; k <= HeightPyramid::StripSize; ++k)
    {
      low[i] = from[k] < low[i] ? from[k] : low[i];
      high[i] = from[k] > high[i] ? from[k] : high[i];
    }
  }
  for (int i = 0; i < Width; ++i)
  {
    const T minimum = std::min(low[i], low[i + Strips]);
    const T maximum = std::max(high[i], high[i + Strips]);
    const double below = static_cast<double>(minimum) - base;
    const double above = static_cast<double>(maximum) - base;
    const bool isNone = minimum > maximum;
    extents.Low[i] =
      isNone ? HeightPyramid::None : static_cast<float>(below - std::abs(below) * 0x1p-23);
    extents.High[i] =
      isNone ? -HeightPyramid::None : static_cast<float>(above + std::abs(above) * 0x1p-23);
  }
}

HELIOS_CLONES
void SetExtentsOf(
  const float* pixels, std::int64_t step, double base, HeightPyramid::Extents& extents)
{
  SetExtents(pixels, step, base, extents);
}

HELIOS_CLONES
void SetExtentsOf(
  const double* pixels, std::int64_t step, double base, HeightPyramid::Extents& extents)
{
  SetExtents(pixels, step, base, extents);
}

} // namespace

template <typename T>
void HeightPyramid::ComputeExtents(
  const T* heights, std::int64_t row, std::int64_t column, Extents& extents) const
{
  const T* pixels = heights + BlockSize * (row * this->Grid.Columns + column);
  const std::int64_t rows = this->Grid.Rows - BlockSize * row;
  const std::int64_t columns = this->Grid.Columns - BlockSize * column;
  if (rows >= Pixels && columns >= Pixels)
  {
    SetExtentsOf(pixels, this->Grid.Columns, this->Base, extents);
    return;
  }
  T copy[Pixels * Pixels];
  std::fill_n(copy, Pixels * Pixels, std::numeric_limits<T>::quiet_NaN());
  for (std::int64_t r = 0; r < std::min<std::int64_t>(rows, Pixels); ++r)
  {
    std::copy_n(
      pixels + r * this->Grid.Columns, std::min<std::int64_t>(columns, Pixels), copy + r * Pixels);
  }
  SetExtentsOf(copy, Pixels, this->Base, extents);
  for (int child = 0; child < Width; ++child)
  {
    if (child / Strips + 1 >= rows || child % Strips * StripSize + 1 >= columns)
    {
      SetNone(extents, child);
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
  for (int child = 0; child < Width; ++child)
  {
    SetNone(none, child);
  }
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
