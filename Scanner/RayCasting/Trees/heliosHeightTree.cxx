// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosHeightTree.h"

#include "heliosRayVectors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace helios
{

namespace
{

constexpr int Width = BeamNode::Width;
constexpr int LeafSize = BeamLeaf::Size;
/// Rounding of a box to floats, relative to its coordinates, of up to 1 for the pixels of
/// triangles; and of the coordinates of pixels in double.
constexpr double BoxRounding = 0x1p-22;
constexpr double PixelRounding = 0x1p-50;

typedef EightFloats Wide;
typedef unsigned int WideNumbers __attribute__((vector_size(32)));
static_assert(LeafSize == QuadWidth, "the triangles of a leaf are lanes");

/// Three pixels of a row, and one to ignore, in the frame of the tree.
struct PixelRow
{
  Floats Coordinates[3];
};

/// Returns the heights of the pixels; NaN after the last column.
template <typename T>
HELIOS_INLINE Doubles GetHeights(const T* heights, std::int64_t count)
{
  const T last = count > 2 ? heights[2] : std::numeric_limits<T>::quiet_NaN();
  return Doubles{ static_cast<double>(heights[0]), static_cast<double>(heights[1]),
    static_cast<double>(last), static_cast<double>(last) };
}

/// Sets the corners of a row by the same operations as HeightGrid::GetPoint() and
/// BeamTree::GetLocal().
HELIOS_INLINE void SetRow(const HeightGrid& grid, std::int64_t row, std::int64_t column,
  const double centre[3], double scale, PixelRow& pixels)
{
  const double* t = grid.Transform;
  const auto first = static_cast<double>(column);
  const Doubles x = Doubles{ 0.5, 1.5, 2.5, 2.5 } + first;
  const double y = static_cast<double>(row) + 0.5;
  const std::int64_t i = row * grid.Columns + column;
  const std::int64_t count = grid.Columns - column;
  const Doubles place[3] = { t[0] + (t[1] * x + t[2] * y), t[3] + (t[4] * x + t[5] * y),
    grid.Floats ? GetHeights(grid.Floats + i, count) : GetHeights(grid.Doubles + i, count) };
  for (int axis = 0; axis < 3; ++axis)
  {
    const Doubles local = (place[axis] - centre[axis]) * scale;
    pixels.Coordinates[axis] = __builtin_convertvector(local, Floats);
  }
}

/// Sets a leaf to the triangles, of slots from the first, that are whole.
HELIOS_INLINE void SetLeaf(
  vtkTypeInt32 slot, const Floats corners[3][3], const ShortMasks& isWhole, BeamLeafData& leaf)
{
  int count = 0;
  int lanes[LeafSize];
  for (int lane = 0; lane < LeafSize; ++lane)
  {
    lanes[count] = lane; // overwritten by the next if this one is missing
    leaf.Words[count] = slot + lane;
    count += isWhole[lane] ? 1 : 0;
  }
  leaf.Count = count;
  for (int k = 0; k < 9; ++k)
  {
    const Floats& all = corners[k / 3][k % 3];
    vtkTypeInt32* to = leaf.Words + (1 + k) * count;
    if (count == LeafSize)
    {
      Store(to, all);
      continue;
    }
    for (int i = 0; i < count; ++i)
    {
      const float x = all[lanes[i]];
      std::memcpy(to + i, &x, sizeof(x));
    }
  }
}

} // namespace

void HeightTree::RowFinder::Set(std::int64_t columns)
{
  // Exact for numbers below 2^31, and products within 64 bits.
  this->Columns = static_cast<vtkTypeUInt32>(columns);
  this->Shift = 31;
  while ((std::int64_t(1) << (this->Shift - 31)) < columns)
  {
    ++this->Shift;
  }
  const auto divisor = static_cast<std::uint64_t>(columns);
  this->Factor = ((std::uint64_t(1) << this->Shift) + divisor - 1) / divisor;
}

HeightTree::HeightTree(const HeightField& field, const double centre[3], double scale)
  : Field(field)
  , Scale(scale)
{
  std::copy_n(centre, 3, this->Centre);
  const auto& levels = field.GetPyramid().GetLevels();
  this->Levels.resize(levels.size());
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    this->SetLevel(levels[levels.size() - 1 - i], this->Levels[i]);
  }
  const std::int64_t cells = field.GetGrid().Columns - 1;
  this->LeafRows.Set((cells + HeightPyramid::StripSize - 1) / HeightPyramid::StripSize);
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    this->SetChildren(i);
  }
}

void HeightTree::SetLevel(const HeightPyramid::Level& from, Level& level) const
{
  level.Extents = from.Nodes.empty() ? nullptr : from.Nodes.data();
  level.Rows.Set(from.Columns);
  level.ChildColumns = static_cast<vtkTypeUInt32>(from.ChildColumns);
  level.ChildRows = Width / level.ChildColumns;
  this->SetBoxes(from, level);
}

/// Sets the numbers of the children.
void HeightTree::SetChildren(std::size_t i)
{
  Level& level = this->Levels[i];
  const bool areLeaves = i + 1 == this->Levels.size();
  level.ChildrenPerRow = (areLeaves ? this->LeafRows : this->Levels[i + 1].Rows).Columns;
  level.Base = areLeaves ? BeamNode::LeafBit : static_cast<vtkTypeUInt32>(i + 1) << LevelShift;
  for (vtkTypeUInt32 child = 0; child < Width; ++child)
  {
    level.Offsets[child] =
      child / level.ChildColumns * level.ChildrenPerRow + child % level.ChildColumns;
  }
}

void HeightTree::SetBoxes(const HeightPyramid::Level& from, Level& level) const
{
  const HeightGrid& grid = this->Field.GetGrid();
  for (int axis = 0; axis < 2; ++axis)
  {
    const double* t = grid.Transform + 3 * axis;
    const double column = t[1] * this->Scale;
    const double row = t[2] * this->Scale;
    level.Origin[axis] = (t[0] + (t[1] * 0.5 + t[2] * 0.5) - this->Centre[axis]) * this->Scale;
    level.ColumnStep[axis] = static_cast<double>(from.CellColumns) * column;
    level.RowStep[axis] = static_cast<double>(from.CellRows) * row;
    const double sides = std::abs(column) * static_cast<double>(grid.Columns) +
      std::abs(row) * static_cast<double>(grid.Rows);
    const double slack = BoxRounding * std::max(1.0, std::abs(level.Origin[axis]) + sides) +
      PixelRounding * (std::abs(t[0]) * this->Scale + sides);
    const double width = level.ColumnStep[axis] / level.ChildColumns;
    const double height = level.RowStep[axis] / level.ChildRows;
    for (int child = 0; child < Width; ++child)
    {
      const double x = child % from.ChildColumns * width;
      const double y = child / from.ChildColumns * height;
      level.Low[axis][child] = RoundDown(std::min(x, x + width) + std::min(y, y + height) - slack);
      level.High[axis][child] = RoundUp(std::max(x, x + width) + std::max(y, y + height) + slack);
    }
  }
}

//------------------------------------------------------------------------------
HELIOS_CLONES
void HeightTree::MakeNode(vtkTypeUInt32 number, BeamNode& node) const
{
  const Level& level = this->Levels[number >> LevelShift];
  const vtkTypeUInt32 inLevel = number & InLevel;
  const vtkTypeUInt32 row = level.Rows.GetRow(inLevel);
  const vtkTypeUInt32 column = inLevel - row * level.Rows.Columns;
  for (int axis = 0; axis < 2; ++axis)
  {
    const auto place = static_cast<float>(
      level.Origin[axis] + column * level.ColumnStep[axis] + row * level.RowStep[axis]);
    Store(node.Low[axis], Load<Wide>(level.Low[axis]) + place);
    Store(node.High[axis], Load<Wide>(level.High[axis]) + place);
  }
  HeightPyramid::Extents computed;
  const HeightPyramid::Extents* extents = &computed;
  if (level.Extents)
  {
    extents = level.Extents + inLevel;
  }
  else
  {
    this->Field.GetPyramid().ComputeExtents(row, column, computed);
  }
  const Wide low = Load<Wide>(extents->Low);
  const Wide high = Load<Wide>(extents->High);
  const auto scale = static_cast<float>(this->Scale); // a power of two
  const Wide none = Wide() + HeightPyramid::None;
  Store(node.Low[2], low <= high ? low * scale : none);
  Store(node.High[2], low <= high ? high * scale : -none);
  const vtkTypeUInt32 first =
    level.Base + row * level.ChildRows * level.ChildrenPerRow + column * level.ChildColumns;
  Store(node.Children, Load<WideNumbers>(level.Offsets) + first);
}

HELIOS_CLONES
void HeightTree::MakeLeaf(vtkTypeUInt32 number, BeamLeafData& leaf) const
{
  const HeightGrid& grid = this->Field.GetGrid();
  const std::int64_t row = this->LeafRows.GetRow(number);
  const std::int64_t column = HeightPyramid::StripSize * (number - row * this->LeafRows.Columns);
  PixelRow above, below;
  SetRow(grid, row, column, this->Centre, this->Scale, above);
  SetRow(grid, row + 1, column, this->Centre, this->Scale, below);
  const int second = grid.IsMirrored() ? 2 : 1;
  Floats corners[3][3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const Floats& u = above.Coordinates[axis];
    const Floats& l = below.Coordinates[axis];
    corners[0][axis] = __builtin_shufflevector(u, l, 0, 4, 1, 5);
    corners[second][axis] = __builtin_shufflevector(u, l, 4, 5, 5, 6);
    corners[3 - second][axis] = __builtin_shufflevector(u, l, 1, 1, 2, 2);
  }
  const Floats z = corners[0][2] + corners[1][2] + corners[2][2];
  const ShortMasks isWhole = z == z;
  const auto slot = static_cast<vtkTypeInt32>(2 * (row * (grid.Columns - 1) + column));
  SetLeaf(slot, corners, isWhole, leaf);
}

void HeightTree::Prefetch(vtkTypeUInt32 number) const
{
  if (number & BeamNode::LeafBit)
  {
    return;
  }
  const Level& level = this->Levels[number >> LevelShift];
  if (level.Extents)
  {
    __builtin_prefetch(level.Extents + (number & InLevel));
  }
}

} // namespace helios
