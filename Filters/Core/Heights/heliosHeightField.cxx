// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosHeightField.h"

#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>

namespace helios
{

namespace
{

constexpr std::int64_t MaximumCells = std::int64_t(1) << 30; // slots are 31-bit
constexpr double MaximumRelief = 1e4; // heights in units of the raster's width: boxes are floats

/// The slots of a cell, a bit each.
constexpr std::uint64_t UpperBit = 1;
constexpr std::uint64_t LowerBit = 2;

int CountBits(std::uint64_t bits)
{
  return __builtin_popcountll(bits);
}

std::string ToText(const double* numbers, int count)
{
  std::ostringstream text;
  text.precision(17);
  for (int i = 0; i < count; ++i)
  {
    text << (i > 0 ? ", " : "") << numbers[i];
  }
  return text.str();
}

} // namespace

/// A row of pixels: whether they have a height, and whether a triangle uses them.
struct HeightField::PixelRow
{
  std::vector<unsigned char> HasHeight;
  std::vector<unsigned char> IsUsed;

  /// Copies a row of heights; false if a height is infinite.
  bool Set(const HeightGrid& grid, std::int64_t row)
  {
    const auto count = static_cast<std::size_t>(grid.Columns);
    this->HasHeight.resize(count);
    this->IsUsed.assign(count, 0);
    bool areFinite = true;
    for (std::size_t c = 0; c < count; ++c)
    {
      const double height = grid.GetHeight(row, static_cast<std::int64_t>(c));
      this->HasHeight[c] = height == height;
      areFinite = areFinite && !std::isinf(height);
    }
    return areFinite;
  }
};

Status HeightField::SetTriangles(vtkImageData* raster)
{
  Status status = this->SetGrid(raster);
  status = status.IsOk() ? this->CheckTransform() : status;
  status = status.IsOk() ? this->FindTriangles() : status;
  return status.IsOk() ? this->CheckHeights() : status;
}

Status HeightField::Set(vtkImageData* raster)
{
  *this = HeightField();
  Status status = this->SetTriangles(raster);
  if (!status.IsOk())
  {
    *this = HeightField();
    return status;
  }
  this->Raster = raster;
  this->Pyramid.Build(this->Grid, 0.5 * this->Bounds[4] + 0.5 * this->Bounds[5]);
  return {};
}

//------------------------------------------------------------------------------
Status HeightField::SetGrid(vtkImageData* raster)
{
  int size[3] = { 0, 0, 0 };
  if (raster)
  {
    raster->GetDimensions(size);
  }
  if (size[0] < 2 || size[1] < 2 || size[2] != 1)
  {
    return Status::Error("the raster has " + std::to_string(size[0]) + " x " +
      std::to_string(size[1]) + " x " + std::to_string(size[2]) +
      " pixels and no triangles; give 2 x 2 x 1 or more");
  }
  this->Grid.Columns = size[0];
  this->Grid.Rows = size[1];
  const std::int64_t cells = (this->Grid.Columns - 1) * (this->Grid.Rows - 1);
  if (cells > MaximumCells)
  {
    return Status::Error("the raster has " + std::to_string(cells) +
      " cells, more than 2^30; cut it into parts with gdal_retile.py");
  }
  auto* transform = vtkDoubleArray::SafeDownCast(
    raster->GetFieldData()->GetArray(vtkHeliosArrayNames::GeoTransform));
  if (!transform || transform->GetNumberOfValues() != 6)
  {
    return Status::Error(std::string("the raster has no field data ") +
      vtkHeliosArrayNames::GeoTransform + " of 6 doubles; add its geotransform, in GDAL's order");
  }
  std::copy_n(transform->GetPointer(0), 6, this->Grid.Transform);
  return this->SetHeights(raster->GetPointData()->GetArray(vtkHeliosArrayNames::Heights),
    this->Grid.Columns * this->Grid.Rows);
}

Status HeightField::SetHeights(vtkDataArray* heights, std::int64_t count)
{
  auto* floats = vtkFloatArray::FastDownCast(heights);
  auto* doubles = vtkDoubleArray::FastDownCast(heights);
  if ((!floats && !doubles) || heights->GetNumberOfValues() != count)
  {
    return Status::Error(std::string("the raster has no point data ") +
      vtkHeliosArrayNames::Heights + " of " + std::to_string(count) +
      " floats or doubles; add its heights, row by row");
  }
  this->Grid.Floats = floats ? floats->GetPointer(0) : nullptr;
  this->Grid.Doubles = doubles ? doubles->GetPointer(0) : nullptr;
  return {};
}

/**
 * Checks that rounding turns no triangle over. A coordinate of a pixel has an error of up to 3 u
 * reach, u = 2^-53 and reach the sum of the sizes of its terms; the doubled area of a triangle,
 * seen from above, differs from the exact one by less than 16 u reach times the length of two
 * sides: no triangle is without area or turned over if its area is larger.
 */
Status HeightField::CheckTransform() const
{
  const double* t = this->Grid.Transform;
  const auto columns = static_cast<double>(this->Grid.Columns);
  const auto rows = static_cast<double>(this->Grid.Rows);
  const double reach = std::max(std::abs(t[0]) + std::abs(t[1]) * columns + std::abs(t[2]) * rows,
    std::abs(t[3]) + std::abs(t[4]) * columns + std::abs(t[5]) * rows);
  const double sides = std::abs(t[1]) + std::abs(t[4]) + std::abs(t[2]) + std::abs(t[5]);
  const double area = std::abs(t[1] * t[5] - t[2] * t[4]);
  if (std::isfinite(reach) && area > 0x1p-48 * reach * sides)
  {
    return {};
  }
  return Status::Error("the raster has the geotransform " + ToText(t, 6) +
    ", whose pixels are not apart in double precision; correct it, or subtract an offset from it");
}

//------------------------------------------------------------------------------
/// Counts the triangles, finds those that are missing, and the bounds.
Status HeightField::FindTriangles()
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Bounds[2 * axis] = infinity;
    this->Bounds[2 * axis + 1] = -infinity;
  }
  this->BlocksPerRow = (this->Grid.Columns - 1 + BlockSize - 1) / BlockSize;
  const auto blocks = static_cast<std::size_t>(this->BlocksPerRow * (this->Grid.Rows - 1));
  this->Masks.assign(blocks, 0);
  this->Numbers.resize(blocks);
  PixelRow rows[2];
  for (std::int64_t row = 0; row < this->Grid.Rows; ++row)
  {
    PixelRow& above = rows[(row + 1) % 2];
    PixelRow& below = rows[row % 2];
    if (!below.Set(this->Grid, row))
    {
      return Status::Error("the raster has an infinite height in row " + std::to_string(row) +
        " (from 0); make it NaN, which is no height");
    }
    if (row > 0)
    {
      this->AddRow(row - 1, above, below);
      this->AddBounds(row - 1, above);
    }
  }
  this->AddBounds(this->Grid.Rows - 1, rows[(this->Grid.Rows - 1) % 2]);
  if (this->NumberOfTriangles == 0)
  {
    return Status::Error("the raster has no triangles; three pixels of a cell must have a height");
  }
  if (this->NumberOfTriangles == 2 * (this->Grid.Columns - 1) * (this->Grid.Rows - 1))
  {
    this->Masks = std::vector<std::uint64_t>();
    this->Numbers = std::vector<std::uint32_t>();
  }
  return {};
}

/// Adds the triangles between two rows.
void HeightField::AddRow(std::int64_t row, PixelRow& above, PixelRow& below)
{
  const auto cells = static_cast<std::size_t>(this->Grid.Columns - 1);
  const auto first = static_cast<std::size_t>(row * this->BlocksPerRow);
  for (std::size_t c = 0; c < cells; ++c)
  {
    const std::size_t block = first + c / BlockSize;
    if (c % BlockSize == 0)
    {
      this->Numbers[block] = static_cast<std::uint32_t>(this->NumberOfTriangles);
    }
    const int diagonal = above.HasHeight[c + 1] & below.HasHeight[c];
    const int upper = diagonal & above.HasHeight[c];
    const int lower = diagonal & below.HasHeight[c + 1];
    above.IsUsed[c] |= upper;
    above.IsUsed[c + 1] |= upper | lower;
    below.IsUsed[c] |= upper | lower;
    below.IsUsed[c + 1] |= lower;
    this->Masks[block] |= (upper * UpperBit | lower * LowerBit) << 2 * (c % BlockSize);
    this->NumberOfTriangles += upper + lower;
  }
}

/// Adds the used pixels of a row. Coordinates are monotonic along it.
void HeightField::AddBounds(std::int64_t row, const PixelRow& pixels)
{
  const auto& used = pixels.IsUsed;
  const auto first = std::find(used.begin(), used.end(), 1) - used.begin();
  const auto last = used.rend() - std::find(used.rbegin(), used.rend(), 1) - 1;
  const auto add = [this](int axis, double x)
  {
    this->Bounds[2 * axis] = std::min(this->Bounds[2 * axis], x);
    this->Bounds[2 * axis + 1] = std::max(this->Bounds[2 * axis + 1], x);
  };
  for (const std::int64_t column : { first, last })
  {
    double point[3];
    if (first <= last)
    {
      this->Grid.GetPoint(row, column, point);
      add(0, point[0]);
      add(1, point[1]);
    }
  }
  for (std::int64_t column = first; column <= last; ++column)
  {
    if (used[static_cast<std::size_t>(column)])
    {
      add(2, this->Grid.GetHeight(row, column));
    }
  }
}

Status HeightField::CheckHeights() const
{
  const double* b = this->Bounds;
  if (b[5] - b[4] <= MaximumRelief * std::max(b[1] - b[0], b[3] - b[2]))
  {
    return {};
  }
  return Status::Error("the raster has heights from " + std::to_string(b[4]) + " to " +
    std::to_string(b[5]) +
    " m, more than 10,000 times its width; make those that are none NaN, or read it as a mesh");
}

//------------------------------------------------------------------------------
bool HeightField::HasTriangle(std::int64_t slot) const
{
  if (this->Masks.empty())
  {
    return true;
  }
  const std::int64_t cell = slot / 2;
  const std::int64_t row = cell / (this->Grid.Columns - 1);
  const std::int64_t column = cell % (this->Grid.Columns - 1);
  const std::int64_t block = row * this->BlocksPerRow + column / BlockSize;
  const auto bit = static_cast<int>(2 * (column % BlockSize) + slot % 2);
  return this->Masks[static_cast<std::size_t>(block)] >> bit & 1;
}

vtkIdType HeightField::GetTriangle(std::int64_t slot) const
{
  if (this->Masks.empty())
  {
    return slot;
  }
  const std::int64_t cell = slot / 2;
  const std::int64_t row = cell / (this->Grid.Columns - 1);
  const std::int64_t column = cell % (this->Grid.Columns - 1);
  const auto block = static_cast<std::size_t>(row * this->BlocksPerRow + column / BlockSize);
  const auto bit = static_cast<int>(2 * (column % BlockSize) + slot % 2);
  const std::uint64_t before = this->Masks[block] & ((std::uint64_t(1) << bit) - 1);
  return static_cast<vtkIdType>(this->Numbers[block]) + CountBits(before);
}

std::int64_t HeightField::GetSlot(vtkIdType triangle) const
{
  if (this->Masks.empty())
  {
    return triangle;
  }
  const auto after = std::upper_bound(
    this->Numbers.begin(), this->Numbers.end(), static_cast<std::uint32_t>(triangle));
  const std::int64_t block = after - this->Numbers.begin() - 1;
  std::uint64_t mask = this->Masks[static_cast<std::size_t>(block)];
  for (auto i = triangle - static_cast<vtkIdType>(*(after - 1)); i > 0; --i)
  {
    mask &= mask - 1;
  }
  const std::int64_t row = block / this->BlocksPerRow;
  const std::int64_t column = block % this->BlocksPerRow * BlockSize;
  return 2 * (row * (this->Grid.Columns - 1) + column) + __builtin_ctzll(mask);
}

void HeightField::GetSlotCorners(std::int64_t slot, double corners[3][3]) const
{
  const auto cell = static_cast<std::uint32_t>(slot / 2);
  const auto cellColumns = static_cast<std::uint32_t>(this->Grid.Columns - 1);
  const std::int64_t row = cell / cellColumns;
  const std::int64_t column = cell % cellColumns;
  const int second = this->Grid.IsMirrored() ? 2 : 1;
  const bool isUpper = slot % 2 == 0;
  this->Grid.GetPoint(isUpper ? row : row + 1, column, corners[0]);
  this->Grid.GetPoint(row + 1, isUpper ? column : column + 1, corners[second]);
  this->Grid.GetPoint(row, column + 1, corners[3 - second]);
}

Vec3 HeightField::GetNormal(vtkIdType triangle) const
{
  double p[3][3];
  this->GetCorners(triangle, p);
  const Vec3 a(p[0]);
  const Vec3 b(p[1]);
  const Vec3 c(p[2]);
  Vec3 normal = (b - a).Cross(c - a);
  normal.Normalize();
  return normal;
}

void HeightField::GetBounds(double bounds[6]) const
{
  std::copy_n(this->Bounds, 6, bounds);
}

std::size_t HeightField::GetMemorySize() const
{
  return this->Pyramid.GetMemorySize() + this->Masks.capacity() * sizeof(this->Masks[0]) +
    this->Numbers.capacity() * sizeof(this->Numbers[0]);
}

} // namespace helios
