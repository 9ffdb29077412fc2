// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosHeightField.h"

#include "heliosHeightCache.h"

#include "heliosTestRasters.h"

#include <vtkIntArray.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using helios::HeightField;
using helios::HeightRaster;

namespace
{

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

std::string GetError(vtkImageData* image)
{
  HeightField field;
  const std::string message = field.Set(image).Message();
  CHECK(field.GetNumberOfTriangles() == 0);
  return message;
}

std::string GetError(const HeightRaster& raster)
{
  return GetError(raster.MakeImage<vtkDoubleArray>());
}

/// The smallest and largest height of the pixels of cells that are in the raster.
struct Block
{
  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();

  Block(const HeightRaster& raster, std::int64_t column, std::int64_t row, std::int64_t columns,
    std::int64_t rows)
  {
    HeightRaster copy = raster;
    const bool isOutside = column + 1 >= raster.Columns || row + 1 >= raster.Rows;
    for (auto r = row; r <= std::min<std::int64_t>(row + rows, raster.Rows - 1) && !isOutside; ++r)
    {
      for (auto c = column; c <= std::min<std::int64_t>(column + columns, raster.Columns - 1); ++c)
      {
        const double height = copy.At(static_cast<int>(c), static_cast<int>(r));
        this->Low = height < this->Low ? height : this->Low;
        this->High = height > this->High ? height : this->High;
      }
    }
  }
};

/// Whether a child has the extents of a block, rounded outwards by no more than two floats.
bool HasExtents(const helios::HeightPyramid::Extents& extents, int child, double base, Block block)
{
  if (block.Low > block.High)
  {
    return extents.Low[child] == helios::HeightPyramid::None &&
      extents.High[child] == -helios::HeightPyramid::None;
  }
  const double low = block.Low - base - extents.Low[child];
  const double high = extents.High[child] - (block.High - base);
  const double most =
    0x1p-21 * (1 + std::max(std::abs(block.Low - base), std::abs(block.High - base)));
  return low >= 0.0 && low <= most && high >= 0.0 && high <= most;
}

/// The number of wrong extents of all levels.
int CountFaults(const HeightRaster& raster, const helios::HeightPyramid& pyramid)
{
  int faults = 0;
  for (const auto& level : pyramid.GetLevels())
  {
    const auto columns = level.CellColumns / level.ChildColumns;
    const auto rows = level.CellRows * level.ChildColumns / helios::HeightPyramid::Width;
    for (std::int64_t i = 0; i < level.Rows * level.Columns; ++i)
    {
      helios::HeightPyramid::Extents extents;
      pyramid.ComputeExtents(i / level.Columns, i % level.Columns, extents);
      extents = level.Nodes.empty() ? extents : level.Nodes[static_cast<std::size_t>(i)];
      for (int child = 0; child < helios::HeightPyramid::Width; ++child)
      {
        const auto column =
          i % level.Columns * level.CellColumns + child % level.ChildColumns * columns;
        const auto row = i / level.Columns * level.CellRows + child / level.ChildColumns * rows;
        faults +=
          !HasExtents(extents, child, pyramid.GetBase(), Block(raster, column, row, columns, rows));
      }
    }
  }
  return faults;
}

} // namespace

TEST_CASE("HeightField: two triangles a cell on a plane", "[HeightField]")
{
  HeightRaster raster(4, 3);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      raster.At(column, row) = column - 2.0 * row;
    }
  }
  HeightField field;
  REQUIRE(field.Set(raster.MakeImage<vtkFloatArray>()).IsOk());
  CHECK(field.GetNumberOfTriangles() == 12);
  double p[3][3];
  field.GetCorners(2 * (3 + 1), p); // row 1, column 1: UL, LL, UR
  CHECK(std::vector<double>(p[0], p[0] + 3) == std::vector<double>{ 100.75, 199.25, -1 });
  CHECK(std::vector<double>(p[1], p[1] + 3) == std::vector<double>{ 100.75, 198.75, -3 });
  CHECK(std::vector<double>(p[2], p[2] + 3) == std::vector<double>{ 101.25, 199.25, 0 });
  field.GetCorners(2 * (3 + 1) + 1, p); // LL, LR, UR
  CHECK(std::vector<double>(p[1], p[1] + 3) == std::vector<double>{ 101.25, 198.75, -2 });
  double bounds[6];
  field.GetBounds(bounds);
  CHECK(std::vector<double>(bounds, bounds + 6) ==
    std::vector<double>{ 100.25, 101.75, 198.75, 199.75, -4, 3 });
  const helios::Vec3 expected = helios::Vec3(-2, -4, 1).Normalized(); // z = 2 x + 4 y + ...
  for (vtkIdType i = 0; i < 12; ++i)
  {
    CHECK((field.GetNormal(i) - expected).Norm() < 1e-15);
  }
}

TEST_CASE("HeightField: slots and triangles without holes are the same", "[HeightField]")
{
  HeightField field;
  REQUIRE(field.Set(HeightRaster(50, 3).MakeImage<vtkDoubleArray>()).IsOk());
  CHECK(field.GetSlot(77) == 77);
  CHECK(field.GetTriangle(77) == 77);
  CHECK(field.HasTriangle(77));
}

TEST_CASE("HeightField: triangles are counted without those at holes", "[HeightField]")
{
  for (const int columns : { 2, 3, 33, 34, 65, 100 })
  {
    HeightRaster raster(columns, 40);
    raster.AddHoles();
    HeightField field;
    REQUIRE(field.Set(raster.MakeImage<vtkDoubleArray>()).IsOk() == (columns > 2));
    vtkIdType count = 0;
    for (std::int64_t slot = 0; slot < 2 * 39 * (columns - 1) && columns > 2; ++slot)
    {
      double p[3][3];
      field.GetSlotCorners(slot, p);
      const bool isWhole = !std::isnan(p[0][2] + p[1][2] + p[2][2]);
      REQUIRE(field.HasTriangle(slot) == isWhole);
      if (isWhole)
      {
        REQUIRE(field.GetTriangle(slot) == count);
        REQUIRE(field.GetSlot(count) == slot);
        ++count;
      }
    }
    CHECK(field.GetNumberOfTriangles() == count);
  }
}

TEST_CASE("HeightField: bounds are those of the triangles", "[HeightField]")
{
  for (const auto& transform : helios::TestTransforms)
  {
    HeightRaster raster(30, 20, transform);
    raster.AddHills(5.0, 1.0);
    raster.AddHoles();
    raster.At(0, 3) = 30.0; // no triangle uses it
    HeightField field;
    REQUIRE(field.Set(raster.MakeImage<vtkDoubleArray>()).IsOk());
    double bounds[6];
    field.GetBounds(bounds);
    double least[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
    double most[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
    for (vtkIdType i = 0; i < field.GetNumberOfTriangles(); ++i)
    {
      double p[3][3];
      field.GetCorners(i, p);
      for (int k = 0; k < 9; ++k)
      {
        least[k % 3] = std::min(least[k % 3], p[k / 3][k % 3]);
        most[k % 3] = std::max(most[k % 3], p[k / 3][k % 3]);
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      CHECK(bounds[2 * axis] == least[axis]);
      CHECK(bounds[2 * axis + 1] == most[axis]);
    }
  }
}

TEST_CASE("HeightField: the pyramid has the extents of its blocks", "[HeightField]")
{
  for (const auto& [columns, rows] :
    { std::pair(3, 3), { 5, 5 }, { 6, 9 }, { 70, 20 }, { 131, 67 } })
  {
    for (const bool hasHoles : { false, true })
    {
      HeightRaster raster(columns, rows);
      raster.AddHills(20.0, 3.0);
      if (hasHoles)
      {
        raster.AddHoles();
      }
      INFO(columns << " x " << rows);
      HeightField field;
      REQUIRE(field.Set(raster.MakeImage<vtkFloatArray>()).IsOk());
      CHECK(CountFaults(raster, field.GetPyramid()) == 0);
      REQUIRE(field.Set(raster.MakeImage<vtkDoubleArray>()).IsOk());
      CHECK(CountFaults(raster, field.GetPyramid()) == 0);
      const auto& top = field.GetPyramid().GetLevels().back();
      CHECK(top.Columns * top.Rows == 1);
    }
  }
}

TEST_CASE("HeightField: one byte a cell beside the heights, at most", "[HeightField]")
{
  HeightRaster raster(1000, 1000);
  HeightField field;
  REQUIRE(field.Set(raster.MakeImage<vtkFloatArray>()).IsOk());
  CHECK(field.GetMemorySize() < 600000);
  raster.AddHoles();
  REQUIRE(field.Set(raster.MakeImage<vtkFloatArray>()).IsOk());
  CHECK(field.GetMemorySize() < 1000000);
}

TEST_CASE("HeightField: errors name the value and the remedy", "[HeightField]")
{
  using Catch::Contains;
  CHECK_THAT(GetError(nullptr), Contains("0 x 0 x 0 pixels and no triangles; give 2 x 2 x 1"));
  CHECK_THAT(GetError(HeightRaster(5, 1)), Contains("5 x 1 x 1 pixels"));
  vtkNew<vtkImageData> huge;
  huge->SetDimensions(40000, 40000, 1);
  CHECK_THAT(GetError(huge), Contains("1599920001 cells, more than 2^30; cut it into parts"));
  auto image = HeightRaster(3, 2).MakeImage<vtkDoubleArray>();
  image->GetFieldData()->Initialize();
  CHECK_THAT(GetError(image), Contains("no field data GeoTransform of 6 doubles; add its"));
  image = HeightRaster(3, 2).MakeImage<vtkIntArray>();
  CHECK_THAT(GetError(image), Contains("no point data Heights of 6 floats or doubles; add its"));
  image->GetPointData()->Initialize();
  CHECK_THAT(GetError(image), Contains("no point data Heights"));
  HeightRaster raster(3, 2);
  raster.At(1, 1) = -HUGE_VAL;
  CHECK_THAT(GetError(raster), Contains("an infinite height in row 1 (from 0); make it NaN"));
  raster.At(1, 1) = -3e38;
  CHECK_THAT(GetError(raster), Contains("more than 10,000 times its width; make those"));
  raster.Values.assign(6, NaN);
  CHECK_THAT(GetError(raster), Contains("three pixels of a cell must have a height"));
  raster = HeightRaster(3, 2, { 5e6, 1e-10, 0, 0, 0, 1 });
  CHECK_THAT(GetError(raster),
    Contains("geotransform 5000000, 1e-10, 0, 0, 0, 1, whose pixels are not apart"));
  raster.Transform = { 0, 1, 2, 0, 1, 2 };
  CHECK_THAT(GetError(raster), Contains("not apart"));
  raster.Transform = { NaN, 1, 0, 0, 0, 1 };
  CHECK_THAT(GetError(raster), Contains("not apart"));
}

TEST_CASE("GetHeightField: made once, and again for other heights", "[HeightField]")
{
  HeightRaster raster(40, 30);
  raster.AddHills(5.0, 1.0);
  const auto image = raster.MakeImage<vtkFloatArray>();
  std::shared_ptr<const helios::HeightField> first, second;
  REQUIRE(helios::GetHeightField(image, first).IsOk());
  vtkNew<vtkImageData> copy;
  copy->ShallowCopy(image);
  REQUIRE(helios::GetHeightField(copy, second).IsOk());
  CHECK(first == second);

  auto* heights = image->GetPointData()->GetArray(vtkHeliosArrayNames::Heights);
  heights->SetComponent(7, 0, 99.0);
  heights->Modified();
  REQUIRE(helios::GetHeightField(image, second).IsOk());
  CHECK(first != second);
  double bounds[6];
  second->GetBounds(bounds);
  CHECK(bounds[5] == 99.0);

  vtkNew<vtkImageData> moved;
  moved->ShallowCopy(image);
  vtkNew<vtkDoubleArray> transform;
  transform->DeepCopy(image->GetFieldData()->GetArray(vtkHeliosArrayNames::GeoTransform));
  transform->SetValue(0, 1234.0);
  vtkNew<vtkFieldData> fields;
  fields->AddArray(transform);
  moved->SetFieldData(fields);
  REQUIRE(helios::GetHeightField(moved, first).IsOk());
  CHECK(first != second);
  first->GetBounds(bounds);
  CHECK(bounds[0] > 1200.0);

  std::shared_ptr<const helios::HeightField> none;
  CHECK_FALSE(helios::GetHeightField(nullptr, none).IsOk());
}
