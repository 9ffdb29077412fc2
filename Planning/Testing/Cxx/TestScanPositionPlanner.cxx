// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosScanPositionPlanner.h"

#include "heliosCoverOverlap.h"
#include "heliosErrorObserver.h"
#include "heliosSmallCovers.h"
#include "vtkHeliosArrayNames.h"

#include <catch2/catch.hpp>
#include <vtkCallbackCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkTypeUInt64Array.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::Choice;
using Planner = vtkHeliosScanPositionPlanner;

namespace
{

/// Candidates in a row 2 m above a row of test points on the ground, x = 0, 1 ...
struct Site
{
  vtkNew<Planner> Filter;
  vtkNew<vtkPolyData> Candidates;
  vtkNew<vtkPolyData> TestPoints;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  vtkSmartPointer<helios::ErrorObserver> Quiet =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  explicit Site(const helios::BitRows& rows)
  {
    this->AddPoints(this->Candidates, rows.Rows, 2.0);
    this->AddPoints(this->TestPoints, rows.Columns, 0.0);
    vtkNew<vtkTypeUInt64Array> words;
    words->SetName(names::Visibility);
    words->SetNumberOfComponents(rows.Length);
    words->SetNumberOfTuples(rows.Rows);
    std::copy_n(rows.Data, rows.Rows * rows.Length, words->GetPointer(0));
    this->Candidates->GetPointData()->AddArray(words);
    this->Filter->SetInputData(0, this->Candidates);
    this->Filter->SetInputData(1, this->TestPoints);
    this->Log->Watch(this->Filter);
    this->Quiet->Watch(this->Filter->GetExecutive());
  }

  void AddPoints(vtkPolyData* data, int count, double height)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (int i = 0; i < count; ++i)
    {
      points->InsertNextPoint(i, 0.0, height);
    }
    data->SetPoints(points);
  }

  void AddNormals()
  {
    vtkNew<vtkDoubleArray> normals;
    normals->SetName(names::Normal);
    normals->SetNumberOfComponents(3);
    for (vtkIdType v = 0; v < this->TestPoints->GetNumberOfPoints(); ++v)
    {
      normals->InsertNextTuple3(0.0, 0.0, -2.0); // either side, any length
    }
    this->TestPoints->GetPointData()->AddArray(normals);
  }

  void AddAreas(const std::vector<double>& values)
  {
    vtkNew<vtkDoubleArray> areas;
    areas->SetName(names::Area);
    for (const double area : values)
    {
      areas->InsertNextValue(area);
    }
    this->TestPoints->GetPointData()->AddArray(areas);
  }

  Choice GetSelected()
  {
    Choice selected;
    this->Filter->Update();
    vtkDataArray* flags = this->GetArray(0, names::Selected);
    for (vtkIdType a = 0; flags && a < flags->GetNumberOfTuples(); ++a)
    {
      if (flags->GetComponent(a, 0) != 0.0)
      {
        selected.push_back(static_cast<int>(a));
      }
    }
    return selected;
  }

  vtkDataArray* GetArray(int port, const char* name)
  {
    return this->Filter->GetOutput(port)->GetPointData()->GetArray(name);
  }

  bool Fails(const std::string& text)
  {
    this->Log->Clear();
    this->Filter->Modified();
    this->Filter->Update();
    INFO(this->Log->Errors);
    CHECK(this->Log->HasError(text));
    return this->Log->HasError(text) && this->Log->HasError("Scan positions cannot be planned: ") &&
      this->Filter->GetOutput(0)->GetNumberOfPoints() == 0;
  }
};

helios::BitMatrix MakeRows(int points, const std::vector<std::vector<int>>& sets)
{
  helios::BitMatrix rows(static_cast<int>(sets.size()), points);
  for (std::size_t a = 0; a < sets.size(); ++a)
  {
    for (const int v : sets[a])
    {
      rows.Set(static_cast<int>(a), v);
    }
  }
  return rows;
}

/// 0 to 5 are seen, 6 is not; pairs such as {0, 2} or {1, 2} see all.
helios::BitMatrix MakeExample()
{
  return MakeRows(7, { { 0, 1, 2 }, { 0, 1, 2 }, { 2, 3, 4, 5 }, {}, { 5 } });
}

} // namespace

TEST_CASE(
  "ScanPositionPlanner: a plan has columns and statistics", "[vtkHeliosScanPositionPlanner]")
{
  const helios::BitMatrix rows = MakeExample();
  Site site(rows.View());
  site.AddNormals();
  site.Filter->SetMethodToViewshedSize();
  CHECK(site.GetSelected() == Choice{ 1, 2 }); // the lower index of equal ones leaves first
  CHECK(site.Log->Errors.empty());
  CHECK(site.GetArray(0, names::ViewshedSize)->GetComponent(2, 0) == 4.0);
  CHECK(site.GetArray(0, names::Exclusivity)->GetComponent(0, 0) == 0.0);
  CHECK(site.GetArray(0, names::Exclusivity)->GetComponent(1, 0) == 2.0);
  CHECK(site.GetArray(0, names::Exclusivity)->GetComponent(2, 0) == 3.0);
  CHECK(std::isnan(site.GetArray(0, names::MeanIncidenceAngle)->GetComponent(3, 0)));
  const double degrees = 180.0 / 3.14159265358979323846;
  CHECK(site.GetArray(0, names::MeanIncidenceAngle)->GetComponent(0, 0) ==
    Approx((0.0 + std::atan(0.5) + std::atan(1.0)) / 3.0 * degrees));
  CHECK(site.GetArray(1, names::Coverable)->GetComponent(5, 0) == 1.0);
  CHECK(site.GetArray(1, names::Coverable)->GetComponent(6, 0) == 0.0);
  CHECK(site.GetArray(1, names::NumberOfScans)->GetComponent(2, 0) == 2.0);
  CHECK(site.GetArray(1, names::NumberOfScans)->GetComponent(6, 0) == 0.0);
  CHECK(site.GetArray(1, names::BestIncidenceAngle)->GetComponent(2, 0) == 0.0);
  CHECK(site.GetArray(1, names::BestIncidenceAngle)->GetComponent(5, 0) ==
    Approx(std::atan(1.5) * degrees));
  CHECK(std::isnan(site.GetArray(1, names::BestIncidenceAngle)->GetComponent(6, 0)));
  vtkPolyData* selected = site.Filter->GetOutput(2);
  REQUIRE(selected->GetNumberOfPoints() == 2);
  CHECK(selected->GetNumberOfVerts() == 2);
  CHECK(selected->GetPoint(0)[0] == 2.0); // adds most
  CHECK(site.GetArray(2, names::NewlyCovered)->GetComponent(0, 0) == 4.0);
  CHECK(site.GetArray(2, names::NewlyCovered)->GetComponent(1, 0) == 2.0);
  CHECK(site.GetArray(2, names::Exclusivity)->GetComponent(0, 0) == 3.0);
  CHECK(site.GetArray(2, names::Visibility) == nullptr);
  CHECK(site.Filter->GetNumberOfSelected() == 2);
  CHECK(site.Filter->GetNumberCovered() == 6);
  CHECK(site.Filter->GetNumberCoverable() == 6);
  CHECK(site.Filter->GetCoverage() == Approx(100.0 * 6 / 7));
  CHECK(site.Filter->GetCoverableCoverage() == 100.0);
  CHECK(site.Filter->GetLowerBound() == Approx(2.0).margin(1e-3));
  CHECK(site.Filter->GetBestBound() == 2);
  CHECK(site.Filter->GetGap() == 0.0);
  CHECK(site.Filter->GetIsProvedOptimal());
  CHECK(site.Filter->GetWorstIncidenceAngle() == Approx(std::atan(1.5) * degrees));
  vtkFieldData* numbers = site.Filter->GetOutput(0)->GetFieldData();
  CHECK(numbers->GetArray(names::PlanNumberOfSelected)->GetTuple1(0) == 2.0);
  CHECK(numbers->GetArray(names::PlanCoverage)->GetTuple1(0) == site.Filter->GetCoverage());
  CHECK(numbers->GetArray(names::PlanMeanBestIncidenceAngle)->GetTuple1(0) ==
    site.Filter->GetMeanBestIncidenceAngle());
}

TEST_CASE("ScanPositionPlanner: given angles are used, and orders can be reversed",
  "[vtkHeliosScanPositionPlanner]")
{
  const helios::BitMatrix rows = MakeExample();
  Site site(rows.View());
  vtkNew<vtkDoubleArray> angles;
  angles->SetName(names::MeanIncidenceAngle);
  for (const double angle : { 30.0, 20.0, 10.0, 0.0, 5.0 })
  {
    angles->InsertNextValue(angle);
  }
  site.Candidates->GetPointData()->AddArray(angles);
  site.Filter->SetMethodToMeanIncidenceAngle();
  CHECK(site.GetSelected() == Choice{ 0, 2 });
  site.Filter->SetRemovalOrderToDescending();
  CHECK(site.GetSelected() == Choice{ 1, 2 });
  CHECK(site.GetArray(0, names::MeanIncidenceAngle)->GetComponent(0, 0) == 30.0);
  CHECK(std::isnan(site.Filter->GetWorstIncidenceAngle()));
}

TEST_CASE(
  "ScanPositionPlanner: Best minimises worst, then mean incidence for the same number of scans",
  "[vtkHeliosScanPositionPlanner]")
{
  for (unsigned int seed = 0; seed < 40; ++seed)
  {
    const helios::SmallCover cover(10, 30, 0.35, seed);
    Site site(cover.Rows.View());
    site.AddNormals();
    const auto judge = [](const Choice& choice, const helios::SmallCover& c)
    {
      double worst = 0.0;
      double sum = 0.0;
      for (int v = 0; v < 30; ++v)
      {
        double best = 90.0;
        for (const int a : choice)
        {
          best = c.Rows.View().Has(a, v) ? std::min(best, std::abs(a - v) / 2.0) : best;
        }
        const double angle = best < 90.0 ? std::atan(best) * 180.0 / 3.14159265358979323846 : 0.0;
        worst = std::max(worst, angle);
        sum += angle;
      }
      return std::make_pair(std::round(worst * 1e6), std::round(sum * 1e6));
    };
    auto least = std::make_pair(1e300, 1e300);
    for (const Choice& choice : cover.GetOptima())
    {
      least = std::min(least, judge(choice, cover));
    }
    for (const int method : { Planner::BEST, Planner::OPTIMAL })
    {
      if (method == Planner::BEST || Planner::HasOptimal())
      {
        INFO(seed << ", " << method);
        site.Filter->SetMethod(method);
        const Choice selected = site.GetSelected();
        CHECK(cover.IsEnough(selected));
        CHECK(judge(selected, cover) == least);
        CHECK(site.Filter->GetIsProvedOptimal());
        CHECK(site.Filter->GetIsWorstProvedOptimal());
        CHECK(site.Filter->GetIsMeanProvedOptimal());
      }
    }
  }
}

TEST_CASE("ScanPositionPlanner: coverage may be limited, of all or of coverable points",
  "[vtkHeliosScanPositionPlanner]")
{
  const helios::BitMatrix rows = MakeExample();
  Site site(rows.View());
  for (int method = Planner::VIEWSHED_SIZE; method <= Planner::BEST; ++method)
  {
    if (method != Planner::MEAN_INCIDENCE_ANGLE)
    {
      INFO(method);
      site.Filter->SetMethod(method);
      site.Filter->SetCoverageOfToCoverable();
      site.Filter->SetMinimumCoverage(400.0 / 6.0);
      CHECK(site.GetSelected() == Choice{ 2 });
      CHECK(site.Filter->GetCoverableCoverage() == Approx(400.0 / 6.0));
      site.Filter->SetMinimumCoverage(67.0);
      CHECK(site.GetSelected().size() == 2);
      site.Filter->SetCoverageOfToAll();
      site.Filter->SetMinimumCoverage(57.0); // 4 of 7
      CHECK(site.GetSelected() == Choice{ 2 });
    }
  }
  site.Filter->SetMinimumCoverage(100.0);
  CHECK(site.Fails("the minimum coverage of 100 % of all test points cannot be reached: all "
                   "candidates together see 85.7143 %; lower it, add candidates, or require a "
                   "share of the coverable ones only"));
}

TEST_CASE("ScanPositionPlanner: UseAreas weights test points", "[vtkHeliosScanPositionPlanner]")
{
  const helios::BitMatrix rows = MakeRows(4, { { 0, 1, 2 }, { 3 } });
  Site site(rows.View());
  site.Filter->SetMinimumCoverage(60.0);
  CHECK(site.GetSelected() == Choice{ 0 });
  site.AddAreas({ 1.0, 1.0, 1.0, 9.0 });
  site.Filter->UseAreasOn();
  CHECK(site.GetSelected() == Choice{ 1 });
  CHECK(site.Filter->GetCoverage() == 75.0);
  CHECK(site.Filter->GetNumberCovered() == 1);
  site.AddAreas({ 1.0, -1.0, 1.0, 9.0 });
  CHECK(site.Fails("Area of test point 1 is -1; areas are finite and not negative"));
  site.AddAreas({ 0.0, 0.0, 0.0, 0.0 });
  CHECK(site.Fails("no candidate sees a test point with an area"));
  site.TestPoints->GetPointData()->RemoveArray(names::Area);
  CHECK(site.Fails("UseAreas is on, but the test points have no point array Area"));
}

TEST_CASE("ScanPositionPlanner: required overlap connects the scans with few additions",
  "[vtkHeliosScanPositionPlanner]")
{
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    INFO(seed);
    const helios::SmallCover cover(10, 40, 0.25, seed);
    Site site(cover.Rows.View());
    const double share = 0.3 + 0.05 * (seed % 4);
    site.Filter->SetMinimumOverlap(share);
    const helios::OverlapNetwork network(cover.Problem, share);
    const auto optima = cover.TryAll(
      [&](const Choice& choice) { return cover.IsEnough(choice) && network.IsConnected(choice); });
    if (optima.empty())
    {
      CHECK(site.Fails("no set of candidates connected by the minimum overlap of "));
      continue;
    }
    for (int method = Planner::VIEWSHED_SIZE; method <= Planner::OPTIMAL; ++method)
    {
      const bool isThere = method != Planner::OPTIMAL || Planner::HasOptimal();
      if (method != Planner::MEAN_INCIDENCE_ANGLE && isThere)
      {
        INFO(method);
        site.Filter->SetMethod(method);
        const Choice selected = site.GetSelected();
        CHECK(cover.IsEnough(selected));
        CHECK(network.IsConnected(selected));
        CHECK(selected.size() >= optima[0].size());
        CHECK(site.Filter->GetBestBound() <= static_cast<vtkIdType>(optima[0].size()));
        CHECK((method != Planner::OPTIMAL || selected.size() == optima[0].size()));
        CHECK((method != Planner::OPTIMAL || site.Filter->GetIsProvedOptimal()));
      }
    }
  }
}

TEST_CASE("ScanPositionPlanner: overlap is the share of the smaller viewshed",
  "[vtkHeliosScanPositionPlanner]")
{
  const helios::BitMatrix rows =
    MakeRows(12, { { 0, 1, 2, 3 }, { 3, 4, 5, 6, 7, 8 }, { 8, 9 }, { 2, 3, 4, 5 } });
  const helios::CoverProblem problem(rows.View());
  CHECK(helios::OverlapNetwork(problem, 0.25).AreNeighbours(0, 1));
  CHECK_FALSE(helios::OverlapNetwork(problem, 0.26).AreNeighbours(0, 1));
  CHECK(helios::OverlapNetwork(problem, 0.5).AreNeighbours(2, 1));
  Site site(rows.View());
  CHECK(site.GetSelected() == Choice{ 0, 1, 2 });
  site.Filter->SetMinimumOverlap(0.5);
  CHECK(site.GetSelected() == Choice{ 0, 1, 2, 3 });
  site.Filter->SetMinimumOverlap(0.51);
  CHECK(
    site.Fails("no set of candidates connected by the minimum overlap of 51 % sees enough; lower "
               "the overlap or the coverage, or add candidates in between"));
}

TEST_CASE("ScanPositionPlanner: bad input is an error", "[vtkHeliosScanPositionPlanner]")
{
  const helios::BitMatrix rows = MakeExample();
  Site site(rows.View());
  SECTION("no candidates")
  {
    site.Candidates->Initialize();
    CHECK(site.Fails("there are no candidates on port 0; connect vtkHeliosViewsheds"));
  }
  SECTION("no test points")
  {
    site.TestPoints->Initialize();
    CHECK(site.Fails("there are no test points on port 1; connect those"));
  }
  SECTION("a matrix that does not fit")
  {
    site.AddPoints(site.TestPoints, 65, 0.0);
    CHECK(site.Fails("65 test points need 2 of unsigned 64-bit integers"));
    site.Candidates->GetPointData()->RemoveArray(names::Visibility);
    CHECK(site.Fails("the candidates have no point array Visibility"));
  }
  SECTION("no test point is visible")
  {
    site.Candidates->GetPointData()->GetArray(names::Visibility)->Fill(0.0);
    CHECK(site.Fails("no candidate sees any test point; widen the limits"));
  }
  SECTION("no angles")
  {
    site.Filter->SetMethodToMeanIncidenceAngle();
    CHECK(site.Fails("Method MeanIncidenceAngle needs the point array MeanIncidenceAngle"));
  }
  SECTION("normals that do not fit")
  {
    site.AddNormals();
    site.AddPoints(site.TestPoints, 8, 0.0);
    CHECK(site.Fails("Normal of the test points has 7 tuples of 3 components; expected 8 of 3"));
  }
  SECTION("points that are not finite")
  {
    site.TestPoints->GetPoints()->SetPoint(3, std::nan(""), 0.0, 0.0);
    CHECK(site.Fails("test point 3 is not finite; correct it, or leave it out"));
    site.Candidates->GetPoints()->SetPoint(1, 0.0, HUGE_VAL, 0.0);
    CHECK(site.Fails("candidate 1 is not finite; correct it, or leave it out"));
  }
  SECTION("Optimal without CBC")
  {
    site.Filter->SetMethodToOptimal();
    if (!Planner::HasOptimal())
    {
      CHECK(
        site.Fails("the method optimal needs COIN-OR CBC, which this build does not include; build "
                   "with VTKHELIOS_ENABLE_CBC, or use best"));
    }
  }
  SECTION("abort")
  {
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback([](vtkObject* filter, unsigned long, void*, void*)
      { static_cast<vtkAlgorithm*>(filter)->SetAbortExecute(1); });
    site.Filter->AddObserver(vtkCommand::ProgressEvent, abort);
    CHECK(site.Fails("aborted before the plan was made; update again"));
  }
}

TEST_CASE(
  "ScanPositionPlanner: independent of the number of threads", "[vtkHeliosScanPositionPlanner]")
{
  const helios::SmallCover cover(20, 300, 0.25, 3);
  Site site(cover.Rows.View());
  site.AddNormals();
  std::vector<Choice> plans;
  std::vector<double> angles;
  for (const int threads : { 1, 2, 4 })
  {
    vtkSMPTools::Initialize(threads);
    site.Filter->Modified();
    plans.push_back(site.GetSelected());
    angles.push_back(site.GetArray(0, names::MeanIncidenceAngle)->GetComponent(7, 0));
    CHECK(plans.back() == plans.front());
    CHECK(angles.back() == angles.front());
  }
  vtkSMPTools::Initialize(0);
}

TEST_CASE("ScanPositionPlanner: a time limit of zero leaves the best plan found",
  "[vtkHeliosScanPositionPlanner]")
{
  const helios::SmallCover cover(20, 200, 0.2, 5);
  Site site(cover.Rows.View());
  if (Planner::HasOptimal())
  {
    site.Filter->SetMethodToOptimal();
    site.Filter->SetTimeLimit(0.0);
    CHECK(cover.IsEnough(site.GetSelected()));
    CHECK(site.Filter->GetBestBound() >= 1);
    CHECK(site.Filter->GetBestBound() <= site.Filter->GetNumberOfSelected());
  }
}

// Too hard to prove within the limit: 400 points, each seen by about 8 of 200 candidates.
TEST_CASE("ScanPositionPlanner: a hard proof reports progress, is aborted, or ends with a gap",
  "[vtkHeliosScanPositionPlanner]")
{
  const helios::SmallCover cover(200, 400, 0.04, 1);
  Site site(cover.Rows.View());
  if (!Planner::HasOptimal())
  {
    return;
  }
  site.Filter->SetMethodToOptimal();
  site.Filter->SetMinimumCoverage(99.5); // skips the enumeration of BEST
  SECTION("an abort in the middle of branch and cut")
  {
    site.Filter->SetTimeLimit(60.0);
    int reports = 0;
    vtkNew<vtkCallbackCommand> abort;
    abort->SetClientData(&reports);
    abort->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto* filter = static_cast<vtkAlgorithm*>(caller);
        int& count = *static_cast<int*>(data);
        count += filter->GetProgress() >= 0.7 ? 1 : 0;
        filter->SetAbortExecute(count >= 5);
      });
    site.Filter->AddObserver(vtkCommand::ProgressEvent, abort);
    CHECK(site.Fails("aborted before the plan was made; update again"));
    CHECK(reports >= 5);
    CHECK(reports <= 7);
  }
  SECTION("the end of the time")
  {
    site.Filter->SetTimeLimit(1.0);
    CHECK_FALSE(site.GetSelected().empty());
    CHECK(site.Filter->GetBestBound() > 10);
    CHECK(site.Filter->GetGap() > 0.0);
    CHECK_FALSE(site.Filter->GetIsProvedOptimal());
  }
}
