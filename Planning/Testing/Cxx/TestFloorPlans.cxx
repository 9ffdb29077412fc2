// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The planner on eight scenes whose optima, linear bounds and greedy results are known.

#include "heliosFloorPlans.h"
#include "heliosVisibility.h"
#include "vtkHeliosScanPositionPlanner.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

namespace names = vtkHeliosArrayNames;

namespace
{

using Planner = vtkHeliosScanPositionPlanner;

const std::vector<helios::FloorPlan>& GetScenes()
{
  static const std::vector<helios::FloorPlan> scenes = helios::MakeFloorPlans();
  return scenes;
}

vtkNew<Planner> MakePlanner(const helios::FloorPlan& scene, int method)
{
  vtkNew<Planner> planner;
  planner->SetInputData(0, scene.GetCandidates());
  planner->SetInputData(1, scene.GetTestPoints());
  planner->SetMethod(method);
  return planner;
}

vtkIdType Count(const helios::FloorPlan& scene, int method, int order = Planner::ASCENDING)
{
  const auto planner = MakePlanner(scene, method);
  planner->SetRemovalOrder(order);
  planner->Update();
  CHECK(planner->GetCoverableCoverage() == 100.0);
  CHECK(planner->GetCoverage() == Approx(scene.Truth.Coverage).margin(0.005));
  return planner->GetNumberOfSelected();
}

/// Test points covered by the first 1, 2 ... of the selected.
std::vector<int> GetCurve(Planner* planner)
{
  vtkDataArray* added = planner->GetOutput(2)->GetPointData()->GetArray(names::NewlyCovered);
  std::vector<int> curve;
  for (vtkIdType k = 0; k < added->GetNumberOfTuples(); ++k)
  {
    curve.push_back(
      static_cast<int>(added->GetComponent(k, 0)) + (curve.empty() ? 0 : curve.back()));
  }
  return curve;
}

} // namespace

TEST_CASE("FloorPlans: scenes equal those of the benchmark", "[FloorPlans]")
{
  for (const helios::FloorPlan& scene : GetScenes())
  {
    INFO(scene.Name);
    CHECK(scene.GetCandidates()->GetNumberOfPoints() == scene.Truth.Candidates);
    CHECK(scene.GetTestPoints()->GetNumberOfPoints() == scene.Truth.TestPoints);
    helios::Visibility matrix;
    REQUIRE(matrix.Set(scene.GetCandidates(), scene.Truth.TestPoints).IsOk());
    std::vector<char> isSeen(scene.Truth.TestPoints);
    for (const helios::PlanPoint& place : scene.Witness)
    {
      REQUIRE(scene.Find(place) >= 0);
      matrix.ForEach(scene.Find(place), [&isSeen](vtkIdType v) { isSeen[v] = 1; });
    }
    if (!scene.Witness.empty())
    {
      CHECK(static_cast<int>(scene.Witness.size()) == scene.Truth.Optimum);
      CHECK(std::accumulate(isSeen.begin(), isSeen.end(), 0) == scene.Truth.TestPoints);
    }
  }
}

TEST_CASE(
  "FloorPlans: the paper's orders and greedy reproduce the table", "[vtkHeliosScanPositionPlanner]")
{
  for (const helios::FloorPlan& scene : GetScenes())
  {
    INFO(scene.Name);
    const helios::PlanTruth& truth = scene.Truth;
    CHECK(Count(scene, Planner::VIEWSHED_SIZE) == truth.Viewshed);
    CHECK(Count(scene, Planner::MEAN_INCIDENCE_ANGLE) == truth.IncidenceAscending);
    CHECK(Count(scene, Planner::MEAN_INCIDENCE_ANGLE, Planner::DESCENDING) ==
      truth.IncidenceDescending);
    CHECK(Count(scene, Planner::GREEDY) == truth.Greedy);
  }
}

TEST_CASE("FloorPlans: every method reports the linear bound", "[vtkHeliosScanPositionPlanner]")
{
  for (const helios::FloorPlan& scene : GetScenes())
  {
    INFO(scene.Name);
    const auto planner = MakePlanner(scene, Planner::GREEDY);
    planner->Update();
    const double bound = planner->GetLowerBound();
    if (Planner::HasOptimal())
    {
      CHECK(std::round(100.0 * bound) / 100.0 == Approx(scene.Truth.Linear));
    }
    CHECK(bound <= scene.Truth.Linear + 0.005);
    CHECK(bound >= 0.9 * scene.Truth.Linear);
    CHECK(planner->GetBestBound() == std::ceil(bound - 1e-6));
  }
}

TEST_CASE("FloorPlans: Best is within 4 % of the optima in total", "[vtkHeliosScanPositionPlanner]")
{
  vtkIdType total = 0;
  int optimum = 0;
  for (const helios::FloorPlan& scene : GetScenes())
  {
    INFO(scene.Name);
    const vtkIdType count = Count(scene, Planner::BEST);
    CHECK(count >= scene.Truth.Optimum);
    total += count;
    optimum += scene.Truth.Optimum;
  }
  CHECK(optimum == 30);
  CHECK(total <= 31);
}

TEST_CASE("FloorPlans: Optimal proves every optimum", "[vtkHeliosScanPositionPlanner]")
{
  for (const helios::FloorPlan& scene : GetScenes())
  {
    if (!Planner::HasOptimal())
    {
      break;
    }
    INFO(scene.Name);
    const auto planner = MakePlanner(scene, Planner::OPTIMAL);
    planner->SetTimeLimit(scene.Truth.Optimum <= 4 ? 200.0 : 5.0);
    planner->Update();
    CHECK(planner->GetNumberOfSelected() == scene.Truth.Optimum);
    CHECK(planner->GetIsProvedOptimal());
    CHECK(planner->GetGap() == 0.0);
    CHECK(planner->GetCoverableCoverage() == 100.0);
    if (scene.Truth.Optimum <= 4)
    {
      CHECK(planner->GetIsWorstProvedOptimal());
      CHECK(planner->GetIsMeanProvedOptimal());
    }
  }
}

TEST_CASE(
  "FloorPlans: a single scan agrees with exhaustive search", "[vtkHeliosScanPositionPlanner]")
{
  const helios::FloorPlan& scene = GetScenes()[1];
  double worst = 90.0;
  double mean = 90.0;
  for (vtkIdType c = 0; c < scene.GetCandidates()->GetNumberOfPoints(); ++c)
  {
    double p[3];
    scene.GetCandidates()->GetPoint(c, p);
    helios::Visibility matrix;
    REQUIRE(matrix.Set(scene.GetCandidates(), scene.Truth.TestPoints).IsOk());
    double largest = 0.0;
    double sum = 0.0;
    matrix.ForEach(c,
      [&](vtkIdType v)
      {
        double q[3];
        double n[3];
        scene.GetTestPoints()->GetPoint(v, q);
        scene.GetTestPoints()->GetPointData()->GetArray(names::Normal)->GetTuple(v, n);
        const double dot =
          std::abs((q[0] - p[0]) * n[0] + (q[1] - p[1]) * n[1] + (q[2] - p[2]) * n[2]);
        const double length = std::sqrt((q[0] - p[0]) * (q[0] - p[0]) +
          (q[1] - p[1]) * (q[1] - p[1]) + (q[2] - p[2]) * (q[2] - p[2]));
        const double angle = std::acos(dot / length) * 180.0 / 3.14159265358979323846;
        largest = std::max(largest, angle);
        sum += angle;
      });
    if (matrix.GetSize(c) == scene.Truth.TestPoints && largest < worst)
    {
      worst = largest;
      mean = sum / scene.Truth.TestPoints;
    }
  }
  const auto planner = MakePlanner(scene, Planner::BEST);
  planner->Update();
  CHECK(planner->GetWorstIncidenceAngle() == Approx(worst).margin(1e-8));
  CHECK(planner->GetMeanBestIncidenceAngle() == Approx(mean).margin(1e-8));
  CHECK(planner->GetIsWorstProvedOptimal());
  CHECK(planner->GetIsMeanProvedOptimal());
}

TEST_CASE("FloorPlans: coverage-limited reduction reproduces the known curves",
  "[vtkHeliosScanPositionPlanner]")
{
  // Test points covered by this many scans, the fewest scans first.
  const std::vector<std::pair<int, std::vector<int>>> curves = {
    { 4, { 500, 607, 630, 636, 640, 642 } },
    { 5, { 799, 1110, 1195, 1229, 1239 } },
    { 7, { 0, 1490, 1802, 1987, 2042, 2087 } },
  };
  for (const auto& [k, curve] : curves)
  {
    const helios::FloorPlan& scene = GetScenes()[k];
    for (std::size_t n = 0; n < curve.size(); ++n)
    {
      if (curve[n] == 0)
      {
        continue;
      }
      INFO(scene.Name << ", " << n + 1);
      const auto planner = MakePlanner(scene, Planner::VIEWSHED_SIZE);
      planner->SetMinimumCoverage(100.0 * curve[n] / scene.Truth.TestPoints);
      planner->Update();
      CHECK(planner->GetNumberOfSelected() == static_cast<vtkIdType>(n + 1));
      CHECK(planner->GetNumberCovered() == curve[n]);
      if (curve[n] == scene.Truth.TestPoints)
      {
        continue;
      }
      planner->SetMinimumCoverage(100.0 * (curve[n] + 0.5) / scene.Truth.TestPoints);
      planner->Update();
      CHECK(planner->GetNumberOfSelected() > static_cast<vtkIdType>(n + 1));
    }
  }
}

TEST_CASE("FloorPlans: selected positions are in greedy order", "[vtkHeliosScanPositionPlanner]")
{
  const std::vector<std::pair<int, std::vector<int>>> curves = {
    { 4, { 501, 614, 641, 642 } },
    { 5, { 810, 1109, 1219, 1248, 1252 } },
    { 7, { 1089, 1640, 1850, 1984, 2047, 2084, 2100, 2109, 2111 } },
  };
  for (const auto& [k, curve] : curves)
  {
    const auto planner = MakePlanner(GetScenes()[k], Planner::GREEDY);
    planner->Update();
    CHECK(GetCurve(planner) == curve);
  }
}

TEST_CASE("FloorPlans: 95 % of the blocks take 5 scans by reduction or greedy, and no more by Best",
  "[vtkHeliosScanPositionPlanner]")
{
  for (const int method : { Planner::VIEWSHED_SIZE, Planner::GREEDY, Planner::BEST })
  {
    const auto planner = MakePlanner(GetScenes()[7], method);
    planner->SetMinimumCoverage(95.0);
    planner->Update();
    INFO(method);
    CHECK(planner->GetCoverage() >= 95.0);
    CHECK(planner->GetNumberOfSelected() <= 5);
    CHECK(planner->GetBestBound() <= planner->GetNumberOfSelected());
    CHECK((method == Planner::BEST || planner->GetNumberOfSelected() == 5));
  }
}
