// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays through grids of turbid cells, against closed forms.
#include "heliosRandom.h"
#include "heliosTurbidGrid.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

namespace names = vtkHeliosArrayNames;

namespace
{

using helios::TurbidGrid;
using helios::Vec3;

/// A grid of cells of one size from a corner, with the density of each.
vtkSmartPointer<vtkImageData> MakeImage(const int count[3], double size, const Vec3& corner,
  const std::function<double(vtkIdType)>& density)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(count[0] + 1, count[1] + 1, count[2] + 1);
  image->SetSpacing(size, size, size);
  image->SetOrigin(corner[0], corner[1], corner[2]);
  vtkNew<vtkDoubleArray> pad;
  pad->SetName(names::PAD);
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    pad->InsertNextValue(density(i));
  }
  image->GetCellData()->AddArray(pad);
  return image;
}

TurbidGrid MakeGrid(const int count[3], double size, const Vec3& corner = { 0, 0, 0 })
{
  TurbidGrid grid;
  REQUIRE(grid.Set(MakeImage(count, size, corner, [](vtkIdType) { return 1.0; })).IsOk());
  return grid;
}

struct Step
{
  vtkIdType Cell;
  double From;
  double To;
};

std::vector<Step> Walk(
  const TurbidGrid& grid, const Vec3& origin, const Vec3& direction, double end = 1e9)
{
  std::vector<Step> steps;
  grid.Traverse(origin, direction, end,
    [&steps](vtkIdType cell, double from, double to)
    {
      steps.push_back({ cell, from, to });
      return true;
    });
  return steps;
}

std::vector<vtkIdType> Cells(const std::vector<Step>& steps)
{
  std::vector<vtkIdType> cells;
  for (const Step& step : steps)
  {
    cells.push_back(step.Cell);
  }
  return cells;
}

/// Random numbers in [low, high).
Vec3 Draw(vtkIdType item, std::uint32_t draw, double low, double high)
{
  const auto u =
    helios::Uniform4(5, helios::RandomStream::Scene, static_cast<std::uint64_t>(item), draw);
  return Vec3(low, low, low) + (high - low) * Vec3(u[0], u[1], u[2]);
}

/// The chord of a ray in the box [0, size]: the intersected ranges of the slabs in long double.
long double Chord(const Vec3& o, const Vec3& d, const Vec3& size)
{
  long double first = 0.0L;
  long double last = 1e9L;
  for (int axis = 0; axis < 3; ++axis)
  {
    const long double a = -static_cast<long double>(o[axis]) / d[axis];
    const long double b = (static_cast<long double>(size[axis]) - o[axis]) / d[axis];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return std::max(0.0L, last - first);
}

} // namespace

TEST_CASE("TurbidGrid: the diagonal of a cube is one chord without gaps", "[TurbidGrid]")
{
  const int ten[3] = { 10, 10, 10 };
  const TurbidGrid grid = MakeGrid(ten, 0.1);
  const double s = 1.0 / std::sqrt(3.0);
  const auto steps = Walk(grid, { -1, -1, -1 }, { s, s, s });
  REQUIRE(steps.size() >= 10);
  CHECK(steps.front().From == Approx(std::sqrt(3.0)).epsilon(1e-15));
  CHECK(steps.back().To - steps.front().From == Approx(1.732050807568877).epsilon(1e-15));
  double sum = 0.0;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    CHECK((i == 0 || steps[i].From == steps[i - 1].To));
    sum += steps[i].To - steps[i].From;
  }
  CHECK(sum == Approx(1.732050807568877).epsilon(1e-14));
}

TEST_CASE("TurbidGrid: chords of random rays add up to that of the box", "[TurbidGrid]")
{
  const int count[3] = { 7, 5, 11 };
  const Vec3 size(0.7, 0.5, 1.1);
  const TurbidGrid grid = MakeGrid(count, 0.1);
  int met = 0;
  for (vtkIdType i = 0; i < 20000; ++i)
  {
    const Vec3 origin = Draw(i, 0, -2.0, 3.0);
    Vec3 direction = Draw(i, 1, 0.0, 1.1) - origin;
    direction.Normalize();
    const auto steps = Walk(grid, origin, direction);
    double sum = 0.0;
    for (std::size_t k = 0; k < steps.size(); ++k)
    {
      REQUIRE((k == 0 || steps[k].From == steps[k - 1].To));
      REQUIRE(steps[k].To > steps[k].From);
      REQUIRE((steps[k].Cell >= 0 && steps[k].Cell < grid.GetNumberOfCells()));
      const Vec3 middle = origin + 0.5 * (steps[k].From + steps[k].To) * direction;
      const vtkIdType cell = static_cast<vtkIdType>(middle[0] / 0.1) +
        7 * static_cast<vtkIdType>(middle[1] / 0.1) + 35 * static_cast<vtkIdType>(middle[2] / 0.1);
      REQUIRE((steps[k].To - steps[k].From < 1e-12 || cell == steps[k].Cell));
      sum += steps[k].To - steps[k].From;
    }
    const auto chord = static_cast<double>(Chord(origin, direction, size));
    REQUIRE(sum == Approx(chord).epsilon(1e-12).margin(1e-14));
    met += steps.empty() ? 0 : 1;
  }
  CHECK(met > 5000);
}

TEST_CASE("TurbidGrid: rays along the axes, in faces and from inside", "[TurbidGrid]")
{
  const int count[3] = { 4, 3, 2 };
  const TurbidGrid grid = MakeGrid(count, 0.5);
  using Ids = std::vector<vtkIdType>;
  CHECK(Cells(Walk(grid, { -1, 0.25, 0.25 }, { 1, 0, 0 })) == Ids{ 0, 1, 2, 3 });
  CHECK(Cells(Walk(grid, { 9, 0.25, 0.25 }, { -1, -0.0, 0 })) == Ids{ 3, 2, 1, 0 });
  CHECK(Cells(Walk(grid, { 0.25, 0.25, 5 }, { 0, 0, -1 })) == Ids{ 12, 0 });
  // A face belongs to the cell above it, the uppermost to none.
  CHECK(Cells(Walk(grid, { -1, 0.5, 0.25 }, { 1, 0, 0 })) == Ids{ 4, 5, 6, 7 });
  CHECK(Cells(Walk(grid, { -1, 0.0, 0.0 }, { 1, 0, 0 })) == Ids{ 0, 1, 2, 3 });
  CHECK(Walk(grid, { -1, 1.5, 0.25 }, { 1, 0, 0 }).empty());
  CHECK(Walk(grid, { -1, 0.25, 1.0 }, { 1, 0, 0 }).empty());
  // From inside, from a face between cells either way, and away from the grid.
  CHECK(Cells(Walk(grid, { 1.25, 0.25, 0.25 }, { 1, 0, 0 })) == Ids{ 2, 3 });
  CHECK(Cells(Walk(grid, { 1.0, 0.25, 0.25 }, { 1, 0, 0 })) == Ids{ 2, 3 });
  CHECK(Cells(Walk(grid, { 1.0, 0.25, 0.25 }, { -1, 0, 0 })) == Ids{ 1, 0 });
  CHECK(Walk(grid, { 2.5, 0.25, 0.25 }, { 1, 0, 0 }).empty());
  CHECK(Walk(grid, { 2.0, 0.25, 0.25 }, { 1, 0, 0 }).empty());
  // Up to an end.
  const auto steps = Walk(grid, { -1, 0.25, 0.25 }, { 1, 0, 0 }, 1.75);
  REQUIRE(Cells(steps) == Ids{ 0, 1 });
  CHECK(steps.back().To == 1.75);
  CHECK(Walk(grid, { -1, 0.25, 0.25 }, { 1, 0, 0 }, 1.0).empty());
}

TEST_CASE("TurbidGrid: a rotated grid is equivalent", "[TurbidGrid]")
{
  const int count[3] = { 8, 6, 4 };
  const helios::Quaternion turn = helios::AxisAngle({ 1, 2, 3 }, 37.0);
  const auto density = [](vtkIdType cell) { return static_cast<double>(cell % 5); };
  const auto image = MakeImage(count, 0.25, { 0, 0, 0 }, density);
  TurbidGrid straight;
  REQUIRE(straight.Set(image).IsOk());
  const Vec3 offset(478233.5, 5471966.75, 110.25);
  const helios::Rotation rotation(turn);
  image->SetDirectionMatrix(&rotation.M[0][0]);
  image->SetOrigin(offset[0], offset[1], offset[2]);
  TurbidGrid turned;
  REQUIRE(turned.Set(image).IsOk());
  for (vtkIdType i = 0; i < 1000; ++i)
  {
    const Vec3 origin = Draw(i, 0, -3.0, 4.0);
    Vec3 direction = Draw(i, 1, 0.0, 1.5) - origin;
    direction.Normalize();
    const auto a = straight.FindDepth(origin, direction, 1e9, 0.3);
    const auto b = turned.FindDepth(offset + rotation * origin, rotation * direction, 1e9, 0.3);
    REQUIRE(a.Cell == b.Cell);
    REQUIRE((a.Cell < 0 || b.Range == Approx(a.Range).margin(1e-8)));
  }
}

TEST_CASE("TurbidGrid: an optical depth is where densities add up to it", "[TurbidGrid]")
{
  const int count[3] = { 4, 1, 1 };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double pads[] = { 2.0, 0.0, nan, 1.0 };
  const auto image = MakeImage(count, 1.0, { 0, 0, 0 }, [&](vtkIdType i) { return pads[i]; });
  TurbidGrid grid;
  REQUIRE(grid.Set(image).IsOk());
  const auto find = [&grid](double depth, double end = 1e9) {
    return grid.FindDepth({ -1, 0.5, 0.5 }, { 1, 0, 0 }, end, depth);
  };
  CHECK(find(0.25).Range == 1.25);
  CHECK(find(0.25).Cell == 0);
  CHECK(find(1.25).Range == 4.5); // 1 in the first cell, 0 in two, 0.25 of the last
  CHECK(find(1.25).Cell == 3);
  CHECK(find(1.5).Cell == -1);
  CHECK(find(0.25, 1.2).Cell == -1);
}

TEST_CASE("TurbidGrid: G of a table is linear in the angle from the vertical", "[TurbidGrid]")
{
  const int one[3] = { 1, 1, 1 };
  const auto image = MakeImage(one, 1.0, { 0, 0, 0 }, [](vtkIdType) { return 1.0; });
  TurbidGrid grid;
  REQUIRE(grid.Set(image).IsOk());
  CHECK(grid.GetProjection({ 1, 2, 3 }) == 0.5);
  vtkNew<vtkDoubleArray> table;
  table->SetName(names::LeafProjection);
  table->SetNumberOfComponents(4);
  table->InsertNextTuple4(1, 0, 0, 0.2);
  table->InsertNextTuple4(0, 0, 2, 0.8);
  table->InsertNextTuple4(0, 3, 0, 0.4);
  image->GetFieldData()->AddArray(table);
  REQUIRE(grid.Set(image).IsOk());
  CHECK(grid.GetProjection({ 0, 0, -5 }) == 0.8);
  CHECK(grid.GetProjection({ 1, 1, 0 }) == Approx(0.3)); // the mean of two
  CHECK(grid.GetProjection({ 1, 0, 1 }) == Approx(0.55));
  CHECK(grid.GetProjection({ 0, std::sqrt(3.0), -1 }) == Approx(0.8 - 0.5 * 2 / 3));
  CHECK(grid.FindDepth({ 0.5, 0.5, 9 }, { 0, 0, -1 }, 99, 0.4).Range == Approx(8.5));
}

TEST_CASE("TurbidGrid: a cone that misses by the test has no hits", "[TurbidGrid]")
{
  const int count[3] = { 3, 4, 5 };
  const TurbidGrid grid = MakeGrid(count, 0.5, { 10, 0, 0 });
  int missed = 0;
  int met = 0;
  for (vtkIdType i = 0; i < 4000; ++i)
  {
    const Vec3 origin = Draw(i, 0, -5.0, 20.0);
    Vec3 axis = Draw(i, 1, -3.0, 14.0) - origin;
    axis.Normalize();
    const double tangent = 0.05;
    const bool mayMeet = grid.MayMeet(origin, axis, tangent, 0.5);
    (mayMeet ? met : missed) += 1;
    for (std::uint32_t k = 2; !mayMeet && k < 10; ++k)
    {
      // Rays that start within 0.5 tangent of the origin and diverge by no more than the tangent.
      const Vec3 aside = Draw(i, k, -1.0, 1.0).Cross(axis);
      const Vec3 unit = (1.0 / aside.Norm()) * aside;
      Vec3 direction = axis + tangent * unit;
      direction.Normalize();
      REQUIRE(Walk(grid, origin + 0.5 * tangent * unit, direction).empty());
      REQUIRE(Walk(grid, origin, direction).empty());
    }
  }
  CHECK(missed > 500);
  CHECK(met > 300);
  CHECK_FALSE(grid.MayMeet({ 0, 1, 1 }, { -1, 0, 0 }, 0.001, 0.0));
  CHECK(grid.MayMeet({ 10.5, 1, 1 }, { -1, 0, 0 }, 0.001, 0.0));
}

TEST_CASE("TurbidGrid: bad images are errors", "[TurbidGrid]")
{
  const int one[3] = { 1, 1, 1 };
  TurbidGrid grid;
  const auto fault = [&grid](vtkImageData* image) { return grid.Set(image).Message(); };
  const auto none = [](vtkIdType) { return 1.0; };
  const auto empty = MakeImage(one, 1.0, { 0, 0, 0 }, none);
  empty->GetCellData()->Initialize();
  CHECK_THAT(fault(empty), Catch::Contains("PAD with one value per cell"));
  vtkNew<vtkImageData> flat;
  flat->SetDimensions(3, 3, 1);
  CHECK_THAT(fault(flat), Catch::Contains("cells along three axes"));
  CHECK_THAT(fault(MakeImage(one, 1.0, { 0, 0, 0 }, [](vtkIdType) { return -2.0; })),
    Catch::Contains("PAD of cell 0 of the voxels is -2"));
  CHECK_THAT(fault(MakeImage(one, 0.0, { 0, 0, 0 }, none)), Catch::Contains("no spacing"));
  const auto image = MakeImage(one, 1.0, { 0, 0, 0 }, none);
  vtkNew<vtkDoubleArray> table;
  table->SetName(names::LeafProjection);
  table->SetNumberOfComponents(4);
  table->InsertNextTuple4(0, 0, 0, 0.5);
  image->GetFieldData()->AddArray(table);
  CHECK_THAT(fault(image), Catch::Contains("LeafProjection of the voxels needs rows x y z G"));
}
