// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclTesting.h"
#include "vtkHeliosReturnSelection.h"

#include <vtkFloatArray.h>

#include <catch2/catch.hpp>

namespace names = vtkHeliosArrayNames;

namespace
{

/// Pulses of 1, 2 and 3 returns; classes 2, 5, 6 in turn.
vtkSmartPointer<vtkPolyData> MakeEchoes()
{
  const auto cloud = helios::MakeCloud(helios::Triples(6, helios::Utm));
  const int numbers[] = { 1, 1, 2, 1, 2, 3 };
  const int totals[] = { 1, 2, 2, 3, 3, 3 };
  helios::AddColumn<vtkUnsignedCharArray>(
    cloud->GetPointData(), names::ReturnNumber, 6, [&numbers](vtkIdType i) { return numbers[i]; });
  helios::AddColumn<vtkUnsignedCharArray>(
    cloud->GetPointData(), names::NumberOfReturns, 6, [&totals](vtkIdType i) { return totals[i]; });
  const int classes[] = { 2, 5, 6, 2, 5, 6 };
  helios::AddColumn<vtkIntArray>(cloud->GetPointData(), names::ClassificationIds, 6,
    [&classes](vtkIdType i) { return classes[i]; });
  return cloud;
}

using Selecting = helios::Filtering<vtkHeliosReturnSelection>;
using Ids = std::vector<vtkIdType>;

Ids Select(Selecting& run)
{
  REQUIRE(run.Run());
  CHECK(run.CountMoved() == 0);
  Ids ids;
  for (vtkIdType i = 0; i < run.Count(); ++i)
  {
    ids.push_back(run.GetId(i));
  }
  return ids;
}

} // namespace

TEST_CASE("ReturnSelection: by type of return", "[ReturnSelection]")
{
  Selecting run(MakeEchoes());
  CHECK(Select(run) == Ids{ 0, 1, 2, 3, 4, 5 });
  run.Filter->SetReturnsToFirst();
  CHECK(Select(run) == Ids{ 0, 1, 3 });
  run.Filter->SetReturnsToLast();
  CHECK(Select(run) == Ids{ 0, 2, 5 });
  run.Filter->SetReturnsToOnly();
  CHECK(Select(run) == Ids{ 0 });
  run.Filter->SetReturnsToIntermediate();
  CHECK(Select(run) == Ids{ 4 });
  run.Filter->SetReturns(vtkHeliosReturnSelection::FirstOfMany);
  CHECK(Select(run) == Ids{ 1, 3 });
  run.Filter->SetReturns(vtkHeliosReturnSelection::LastOfMany);
  CHECK(Select(run) == Ids{ 2, 5 });
  run.Filter->SetReturnsToAll();
  run.Filter->SetReturnRange(2, 3);
  CHECK(Select(run) == Ids{ 2, 4, 5 });
}

TEST_CASE("ReturnSelection: by class, and by both", "[ReturnSelection]")
{
  Selecting run(MakeEchoes());
  run.Filter->AddClass(5);
  run.Filter->AddClass(6);
  run.Filter->AddClass(6);
  CHECK(run.Filter->GetNumberOfClasses() == 2);
  CHECK(run.Filter->GetClass(1) == 6);
  CHECK(run.Filter->GetClass(2) == -1);
  CHECK(Select(run) == Ids{ 1, 2, 4, 5 });
  run.Filter->SetReturnsToLast();
  CHECK(Select(run) == Ids{ 2, 5 });
  run.Filter->RemoveAllClasses();
  CHECK(Select(run) == Ids{ 0, 2, 5 });
}

TEST_CASE("ReturnSelection: requires only the arrays it uses", "[ReturnSelection]")
{
  const auto cloud = MakeEchoes();
  cloud->GetPointData()->RemoveArray(names::NumberOfReturns);
  Selecting run(cloud);
  run.Filter->SetReturnsToFirst();
  CHECK(Select(run) == Ids{ 0, 1, 3 });
  run.Filter->SetReturnsToLast();
  CHECK(run.FailsWith(
    "Input: the point array NumberOfReturns does not exist; add it, or do not select by it"));
  helios::AddColumn<vtkFloatArray>(
    cloud->GetPointData(), names::NumberOfReturns, 6, [](vtkIdType) { return 1; });
  CHECK(run.FailsWith("NumberOfReturns is not one integer per point"));
  run.Filter->SetReturnRange(3, 2);
  CHECK(run.FailsWith("ReturnRange is 3 to 2; set the smaller number first"));
  Selecting none{ helios::Triples() };
  none.Filter->SetReturnsToLast();
  REQUIRE(none.Run());
  CHECK(none.Count() == 0);
}
