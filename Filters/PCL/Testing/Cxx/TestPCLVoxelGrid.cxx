// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclTesting.h"
#include "vtkHeliosPCLVoxelGrid.h"

#include <catch2/catch.hpp>

#include <map>

namespace names = vtkHeliosPCLArrayNames;

namespace
{

helios::Triples MakePoints(int count)
{
  helios::Uniform uniform(17);
  helios::Triples points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back(helios::Utm + helios::Triple{ uniform(0, 20), uniform(0, 10), uniform(0, 2) });
  }
  return points;
}

using Cell = std::array<long long, 3>;

Cell GetCell(const helios::Triple& p, double size)
{
  return { std::llround(std::floor(p[0] / size)), std::llround(std::floor(p[1] / size)),
    std::llround(std::floor(p[2] / size)) };
}

} // namespace

TEST_CASE("PCLVoxelGrid: the point nearest to the mean of each voxel", "[PCLVoxelGrid]")
{
  const double size = 0.5; // exact in double: these cells equal the grid's
  const helios::Triples points = MakePoints(20000);
  std::map<Cell, std::pair<helios::Triple, int>> cells; // sum and count
  for (const helios::Triple& p : points)
  {
    auto& cell = cells[GetCell(p, size)];
    cell.first = cell.first + p;
    ++cell.second;
  }
  helios::Filtering<vtkHeliosPCLVoxelGrid> run(points);
  run.Filter->SetVoxelSize(size);
  REQUIRE(run.Run());
  CHECK(run.CountMoved() == 0);
  REQUIRE(run.Count() == static_cast<vtkIdType>(cells.size()));
  vtkIdType total = 0;
  std::vector<Cell> order;
  for (vtkIdType i = 0; i < run.Count(); ++i)
  {
    const helios::Triple& p = points[static_cast<std::size_t>(run.GetId(i))];
    const auto& cell = cells.at(GetCell(p, size));
    const int count = static_cast<int>(run.Get(names::NumberOfPoints)->GetTuple1(i));
    REQUIRE(count == cell.second);
    total += count;
    const auto distance = [&cell](const helios::Triple& q)
    {
      double sum = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        sum += std::pow(q[axis] - cell.first[axis] / cell.second, 2);
      }
      return std::sqrt(sum);
    };
    if (i % 97 == 0)
    {
      for (const helios::Triple& q : points)
      {
        REQUIRE((GetCell(q, size) != GetCell(p, size) || distance(p) <= distance(q) + 1e-5));
      }
    }
    const Cell c = GetCell(p, size);
    order.push_back({ c[2], c[1], c[0] });
  }
  CHECK(total == 20000);
  CHECK(std::is_sorted(order.begin(), order.end()));

  run.Filter->UseMeanPointsOn();
  REQUIRE(run.Run());
  REQUIRE(run.Count() == static_cast<vtkIdType>(cells.size()));
  for (vtkIdType i = 0; i < run.Count(); ++i)
  {
    const helios::Triple& p = points[static_cast<std::size_t>(run.GetId(i))];
    const auto& cell = cells.at(GetCell(p, size));
    for (int axis = 0; axis < 3; ++axis)
    {
      const double mean = cell.first[static_cast<std::size_t>(axis)] / cell.second;
      REQUIRE(std::abs(run.Output()->GetPoint(i)[axis] - mean) < 1e-5);
    }
  }
}

TEST_CASE("PCLVoxelGrid: tiles use one grid", "[PCLVoxelGrid]")
{
  const helios::Triples points = MakePoints(20000);
  const double border = std::floor(helios::Utm[0] / 0.5) * 0.5 + 7.5; // a border of cells
  helios::Triples tiles[2];
  for (const helios::Triple& p : points)
  {
    tiles[p[0] < border ? 0 : 1].push_back(p);
  }
  vtkIdType sum = 0;
  for (const helios::Triples& tile : tiles)
  {
    helios::Filtering<vtkHeliosPCLVoxelGrid> run(tile);
    run.Filter->SetVoxelSize(0.5);
    REQUIRE(run.Run());
    sum += run.Count();
  }
  helios::Filtering<vtkHeliosPCLVoxelGrid> whole(points);
  whole.Filter->SetVoxelSize(0.5);
  REQUIRE(whole.Run());
  CHECK(sum == whole.Count());
}

TEST_CASE("PCLVoxelGrid: more voxels than PCL supports", "[PCLVoxelGrid]")
{
  helios::Filtering<vtkHeliosPCLVoxelGrid> run(
    { helios::Utm, helios::Utm + helios::Triple{ 1000.0, 1000.0, 100.0 } });
  run.Filter->SetVoxelSize(0.01);
  CHECK(run.FailsWith("VoxelSize is 0.01 m, which makes 1.0"));
  CHECK(run.Log->HasError("the maximum is 2147483647: set a larger one"));
  run.Filter->SetVoxelSize(-1.0);
  CHECK(run.Filter->GetVoxelSize() == 1e-4);
}
