// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Shares of objects: plans against the enumeration of all choices.
#include "heliosCoverExact.h"
#include "heliosErrorObserver.h"
#include "heliosSmallCovers.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScanPositionPlanner.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeUInt64Array.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::Choice;
using Planner = vtkHeliosScanPositionPlanner;

namespace
{

constexpr int Candidates = 10;
constexpr int Points = 60;
constexpr int Objects = 4;

/// A planner of a random visibility, whose points are of four objects in turn; every 13th of none.
struct Site
{
  helios::SmallCover Cover;
  vtkNew<Planner> Filter;
  vtkNew<helios::ErrorObserver> Log;
  vtkNew<vtkPolyData> TestPoints;

  explicit Site(unsigned seed, double density = 0.2)
    : Cover(Candidates, Points, density, seed)
  {
    const helios::BitRows rows = this->Cover.Rows.View();
    vtkNew<vtkPolyData> positions;
    Site::AddPoints(positions, Candidates);
    Site::AddPoints(this->TestPoints, Points);
    vtkNew<vtkTypeUInt64Array> words;
    words->SetName(names::Visibility);
    words->SetNumberOfComponents(rows.Length);
    words->SetNumberOfTuples(rows.Rows);
    std::copy_n(rows.Data, rows.Rows * rows.Length, words->GetPointer(0));
    positions->GetPointData()->AddArray(words);
    vtkNew<vtkIntArray> parts;
    parts->SetName(names::PartIds);
    vtkNew<vtkDoubleArray> areas;
    areas->SetName(names::Area);
    for (int v = 0; v < Points; ++v)
    {
      parts->InsertNextValue(Site::GetObject(v));
      areas->InsertNextValue(this->Cover.Areas[static_cast<std::size_t>(v)]);
    }
    this->TestPoints->GetPointData()->AddArray(parts);
    this->TestPoints->GetPointData()->AddArray(areas);
    this->Filter->SetInputData(0, positions);
    this->Filter->SetInputData(1, this->TestPoints);
    this->Log->Watch(this->Filter);
  }

  static void AddPoints(vtkPolyData* data, int count)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 0; i < count; ++i)
    {
      points->InsertNextPoint(i, 0.0, 0.0);
    }
    data->SetPoints(points);
  }

  static int GetObject(int point) { return point % 13 == 0 ? -1 : point % Objects; }

  /// Whether a choice has the shares, in all and of each object, by definition.
  bool IsEnough(const Choice& choice, double share, double ofAll, bool byArea) const
  {
    std::vector<double> seen(Objects + 1, 0.0);
    std::vector<double> possible(Objects + 1, 0.0);
    for (int v = 0; v < Points; ++v)
    {
      const double weight = byArea ? this->Cover.Areas[static_cast<std::size_t>(v)] : 1.0;
      const auto isSeenBy = [&](int a) { return this->Cover.Rows.View().Has(a, v); };
      bool isCoverable = false;
      for (int a = 0; a < Candidates; ++a)
      {
        isCoverable = isCoverable || isSeenBy(a);
      }
      const bool isSeen = std::any_of(choice.begin(), choice.end(), isSeenBy);
      for (const int object : { Site::GetObject(v), Objects })
      {
        if (object >= 0)
        {
          possible[static_cast<std::size_t>(object)] += isCoverable ? weight : 0.0;
          seen[static_cast<std::size_t>(object)] += isSeen ? weight : 0.0;
        }
      }
    }
    bool isEnough = seen[Objects] >= ofAll * possible[Objects] - 1e-9;
    for (std::size_t k = 0; k < Objects; ++k)
    {
      isEnough = isEnough && seen[k] >= share * possible[k] - 1e-9;
    }
    return isEnough;
  }

  Choice GetSelected()
  {
    this->Filter->Update();
    INFO(this->Log->Errors);
    vtkDataArray* selected = this->Filter->GetOutput()->GetPointData()->GetArray(names::Selected);
    REQUIRE(selected);
    Choice choice;
    for (int a = 0; a < Candidates; ++a)
    {
      if (selected->GetTuple1(a) != 0.0)
      {
        choice.push_back(a);
      }
    }
    return choice;
  }
};

} // namespace

TEST_CASE("ObjectCover: the fewest scans with shares of all objects", "[ObjectCover]")
{
  const auto seed = static_cast<unsigned>(GENERATE(range(1, 9)));
  const double share = GENERATE(60.0, 85.0);
  const double ofAll = GENERATE(0.0, 80.0);
  const bool byArea = seed % 2 == 0;
  Site site(seed);
  site.Filter->SetMinimumObjectCoverage(share);
  site.Filter->SetMinimumCoverage(ofAll);
  site.Filter->SetUseAreas(byArea);
  const auto isGood = [&](const Choice& choice)
  { return site.IsEnough(choice, share / 100.0, ofAll / 100.0, byArea); };
  const auto fewest = static_cast<vtkIdType>(site.Cover.TryAll(isGood).front().size());
  for (const int method :
    { Planner::VIEWSHED_SIZE, Planner::GREEDY, Planner::BEST, Planner::OPTIMAL })
  {
    if (method == Planner::OPTIMAL && !Planner::HasOptimal())
    {
      continue;
    }
    site.Filter->SetMethod(method);
    const Choice choice = site.GetSelected();
    CHECK(isGood(choice));
    CHECK(site.Filter->GetBestBound() <= fewest);
    if (method == Planner::OPTIMAL)
    {
      CHECK(static_cast<vtkIdType>(choice.size()) == fewest);
      CHECK(site.Filter->GetIsProvedOptimal());
    }
    // No member is redundant.
    for (std::size_t k = 0; k < choice.size(); ++k)
    {
      Choice fewer = choice;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      CHECK_FALSE(isGood(fewer));
    }
  }
}

TEST_CASE("ObjectCover: complete objects are a full cover", "[ObjectCover]")
{
  Site site(3);
  const auto full = site.GetSelected().size();
  site.Filter->SetMinimumObjectCoverage(50.0);
  CHECK(site.GetSelected().size() == full); // all coverable points are required as well
  site.Filter->SetMinimumCoverage(0.0);
  CHECK(site.GetSelected().size() <= full);
}

TEST_CASE("ObjectCover: errors", "[ObjectCover]")
{
  Site site(1);
  std::string wanted;
  SECTION("nothing is required")
  {
    site.Filter->SetMinimumCoverage(0.0);
    wanted = "the minimum coverage is 0 %, so nothing is required";
  }
  SECTION("no parts")
  {
    site.Filter->SetMinimumObjectCoverage(50.0);
    site.TestPoints->GetPointData()->RemoveArray(names::PartIds);
    wanted = "coverage of objects needs the point array PartIds of the test points";
  }
  site.Filter->Update();
  CHECK_THAT(site.Log->Errors, Catch::Contains(wanted));
}
