// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclTesting.h"
#include "vtkHeliosPCLClusters.h"

#include <catch2/catch.hpp>

namespace names = vtkHeliosPCLArrayNames;

namespace
{

/// Rows of points 0.3 m apart: 20, 40, 5 and 40 of them, 2 m from row to row.
helios::Triples MakeRows()
{
  helios::Triples points;
  const int counts[] = { 20, 40, 5, 40 };
  for (int row = 0; row < 4; ++row)
  {
    for (int i = 0; i < counts[row]; ++i)
    {
      points.push_back(helios::Utm + helios::Triple{ 0.3 * i, 2.0 * row, 0.0 });
    }
  }
  return points;
}

std::vector<int> GetIds(helios::Filtering<vtkHeliosPCLClusters>& run)
{
  std::vector<int> ids;
  for (const vtkIdType first : { 0, 20, 60, 65 })
  {
    ids.push_back(static_cast<int>(run.Get(names::ClusterIds)->GetTuple1(first)));
  }
  return ids;
}

} // namespace

TEST_CASE("PCLClusters: rows of points are clusters, the largest first", "[PCLClusters]")
{
  helios::Filtering<vtkHeliosPCLClusters> run(MakeRows());
  REQUIRE(run.Run());
  CHECK(run.Count() == 105);
  CHECK(run.CountMoved() == 0);
  CHECK(run.Filter->GetNumberOfClusters() == 3);
  CHECK(GetIds(run) == std::vector<int>{ 2, 0, -1, 1 });
  for (vtkIdType i = 20; i < 60; ++i)
  {
    CHECK(run.Get(names::ClusterIds)->GetTuple1(i) == 0);
  }
}

TEST_CASE("PCLClusters: minimum and maximum sizes, and distances at the tolerance", "[PCLClusters]")
{
  helios::Filtering<vtkHeliosPCLClusters> run(MakeRows());
  run.Filter->SetMinimumClusterSize(5);
  run.Filter->SetMaximumClusterSize(20);
  REQUIRE(run.Run());
  CHECK(GetIds(run) == std::vector<int>{ 0, -1, 1, -1 });
  run.Filter->SetMaximumClusterSize(1000);
  run.Filter->SetTolerance(2.1);
  REQUIRE(run.Run());
  CHECK(run.Filter->GetNumberOfClusters() == 1);
  run.Filter->SetTolerance(0.29);
  run.Filter->SetMinimumClusterSize(1);
  REQUIRE(run.Run());
  CHECK(run.Filter->GetNumberOfClusters() == 105);
  run.Filter->SetMaximumClusterSize(4);
  run.Filter->SetMinimumClusterSize(5);
  CHECK(run.FailsWith("MinimumClusterSize is 5, above MaximumClusterSize, 4; set a smaller one"));
  CHECK(run.Filter->GetNumberOfClusters() == 0);
}
