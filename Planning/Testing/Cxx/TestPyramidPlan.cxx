// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The pyramid experiment of Bechtold and Hoefle 2016, figure 5: from a scene to scan positions.

#include "vtkHeliosScanPositionPlanner.h"

#include "heliosPose.h"
#include "heliosPyramidScene.h"
#include "heliosRandom.h"
#include "heliosVisibility.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScanPositionCandidates.h"
#include "vtkHeliosViewsheds.h"
#include "vtkHeliosVisibilityTestPoints.h"

#include <catch2/catch.hpp>
#include <vtkAppendPolyData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::Vec3;

namespace
{

struct Experiment
{
  vtkSmartPointer<vtkPolyData> Scene;
  vtkNew<vtkHeliosScanPositionCandidates> Candidates;
  vtkNew<vtkHeliosVisibilityTestPoints> Above;
  vtkNew<vtkHeliosVisibilityTestPoints> Beside;
  vtkNew<vtkAppendPolyData> TestPoints;
  vtkNew<vtkHeliosViewsheds> Viewsheds;
  vtkNew<vtkHeliosScanPositionPlanner> Planner;

  explicit Experiment(double step = 1.0, bool withBeside = false,
    const helios::Pyramid& pyramid = helios::Pyramid(), double scannerHeight = 1.5)
    : Scene(helios::MakePyramidScene(pyramid))
  {
    // The grid is on whole metres and, with 0.5 m, half metres: the mesh's edges are off the grid.
    const double half = std::floor(pyramid.Ground) + 0.5 * step;
    this->Candidates->SetInputData(this->Scene);
    this->Candidates->SetRegion(-half, half, -half, half);
    this->Candidates->SetStep(step);
    this->Candidates->SetMaximumSlope(30.0);
    this->Candidates->SetScannerHeight(scannerHeight);
    this->Above->SetInputData(this->Scene);
    this->Above->SetRegion(-half, half, -half, half, NAN, NAN);
    this->Above->SetStep(step);
    this->Above->HorizontalOff();
    this->TestPoints->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    this->TestPoints->AddInputConnection(this->Above->GetOutputPort());
    if (withBeside)
    {
      this->Beside->SetInputData(this->Scene);
      this->Beside->SetStep(0.5);
      this->Beside->SetRegion(-10.25, 10.25, -10.25, 10.25, 0.25, 2.25);
      this->Beside->VerticalOff();
      this->TestPoints->AddInputConnection(this->Beside->GetOutputPort());
    }
    this->Viewsheds->SetInputData(0, this->Scene);
    this->Viewsheds->SetInputConnection(1, this->Candidates->GetOutputPort());
    this->Viewsheds->SetInputConnection(2, this->TestPoints->GetOutputPort());
    this->Planner->SetInputConnection(0, this->Viewsheds->GetOutputPort());
    this->Planner->SetInputConnection(1, this->TestPoints->GetOutputPort());
  }

  /// The positions selected by a method, in rows of x from the smallest y on.
  std::vector<Vec3> Plan(int method)
  {
    this->Planner->SetMethod(method);
    this->Planner->Update();
    std::vector<Vec3> positions;
    vtkPolyData* selected = this->Planner->GetOutput(2);
    for (vtkIdType i = 0; i < selected->GetNumberOfPoints(); ++i)
    {
      positions.push_back(Vec3(selected->GetPoint(i)));
    }
    std::sort(positions.begin(), positions.end(),
      [](const Vec3& a, const Vec3& b) { return a[1] != b[1] ? a[1] < b[1] : a[0] < b[0]; });
    return positions;
  }

  /// The number of positions on the structure.
  static std::ptrdiff_t CountOnTop(const std::vector<Vec3>& positions)
  {
    return std::count_if(
      positions.begin(), positions.end(), [](const Vec3& p) { return p[2] > 1.6; });
  }
};

/// Whether two positions are opposite corners of a square about the origin, within a few metres.
bool AreOppositeCorners(const std::vector<Vec3>& p, double half)
{
  return p.size() == 2 && std::abs(std::abs(p[0][0]) - half) <= 1.0 &&
    std::abs(std::abs(p[0][1]) - half) <= 1.0 && std::abs(p[0][0] + p[1][0]) <= 1.0 &&
    std::abs(p[0][1] + p[1][1]) <= 1.0;
}

bool IsAt(const Vec3& p, double x, double y, double z)
{
  return (p - Vec3(x, y, z)).Norm() < 1e-9;
}

using Planner = vtkHeliosScanPositionPlanner;

} // namespace

TEST_CASE(
  "PyramidPlan: smallest viewsheds first leaves three positions, one on top", "[PyramidPlan]")
{
  Experiment experiment;
  experiment.Viewsheds->SetBothSides(GENERATE(false, true));
  const auto p = experiment.Plan(Planner::VIEWSHED_SIZE);
  REQUIRE(p.size() == 3);
  CHECK(IsAt(p[0], 10, -2, 1.5));
  CHECK(IsAt(p[1], 0, 0, 3.9375));
  CHECK(IsAt(p[2], -2, 10, 1.5));
  CHECK(experiment.Planner->GetNumberCovered() == 441);
  CHECK(experiment.Planner->GetNumberCoverable() == 441);
  CHECK(experiment.Planner->GetWorstIncidenceAngle() == Approx(89.70).margin(0.005));
  CHECK(experiment.Planner->GetMeanBestIncidenceAngle() == Approx(62.66).margin(0.5));
  // Without the one on top the two others see 438.
  experiment.Planner->SetMinimumCoverage(99.0);
  CHECK(experiment.Plan(Planner::VIEWSHED_SIZE).size() == 2);
  CHECK(experiment.Planner->GetNumberCovered() == 438);
  experiment.Planner->SetMinimumCoverage(75.0);
  CHECK(experiment.Plan(Planner::VIEWSHED_SIZE).size() == 1);
  CHECK(experiment.Planner->GetNumberCovered() == 347);
}

TEST_CASE("PyramidPlan: smallest incidence first leaves two opposite corners", "[PyramidPlan]")
{
  Experiment experiment;
  experiment.Viewsheds->SetBothSides(GENERATE(false, true));
  const auto p = experiment.Plan(Planner::MEAN_INCIDENCE_ANGLE);
  REQUIRE(p.size() == 2);
  CHECK(IsAt(p[0], -10, -10, 1.5));
  CHECK(IsAt(p[1], 10, 10, 1.5));
  CHECK(experiment.Planner->GetNumberCovered() == 441);
  CHECK(experiment.Planner->GetWorstIncidenceAngle() == Approx(85.71).margin(0.005));
  CHECK(experiment.Planner->GetMeanBestIncidenceAngle() == Approx(78.23).margin(0.5));
}

TEST_CASE("PyramidPlan: greedy needs three positions, the optimum two", "[PyramidPlan]")
{
  Experiment experiment;
  experiment.Planner->SetMinimumCoverage(100.0);
  CHECK(experiment.Plan(Planner::GREEDY).size() == 3);
  vtkDataArray* added =
    experiment.Planner->GetOutput(2)->GetPointData()->GetArray(names::NewlyCovered);
  CHECK(added->GetTuple1(0) == 401); // the one on top
  CHECK(added->GetTuple1(0) + added->GetTuple1(1) + added->GetTuple1(2) == 441);
  CHECK(experiment.Plan(Planner::BEST).size() == 2);
  CHECK(experiment.Planner->GetLowerBound() > 1.0); // two are needed
  CHECK(experiment.Planner->GetLowerBound() <= 2.0 + 1e-9);
}

TEST_CASE("PyramidPlan: the optimum is proved for every order of criteria", "[PyramidPlan]")
{
  if (!Planner::HasOptimal())
  {
    return;
  }
  Experiment experiment;
  const auto p = experiment.Plan(Planner::OPTIMAL);
  REQUIRE(p.size() == 2);
  CHECK(experiment.Planner->GetIsProvedOptimal());
  CHECK(experiment.Planner->GetIsWorstProvedOptimal());
  CHECK(experiment.Planner->GetIsMeanProvedOptimal());
  CHECK(experiment.Planner->GetLowerBound() == Approx(2.0).margin(1e-6));
  CHECK(experiment.Planner->GetWorstIncidenceAngle() == Approx(85.11).margin(0.5));
  CHECK(experiment.Planner->GetMeanBestIncidenceAngle() == Approx(73.60).margin(0.5));
}

TEST_CASE("PyramidPlan: points from the side, and a finer grid", "[PyramidPlan]")
{
  SECTION("horizontal lines")
  {
    Experiment experiment(1.0, true);
    const auto bySize = experiment.Plan(Planner::VIEWSHED_SIZE);
    CHECK(experiment.TestPoints->GetOutput()->GetNumberOfPoints() == 569);
    REQUIRE(bySize.size() == 3);
    CHECK(IsAt(bySize[0], 10, -2, 1.5));
    CHECK(IsAt(bySize[1], 0, 0, 3.9375));
    CHECK(IsAt(bySize[2], -2, 10, 1.5));
    const auto byAngle = experiment.Plan(Planner::MEAN_INCIDENCE_ANGLE);
    REQUIRE(byAngle.size() == 2);
    CHECK(AreOppositeCorners(byAngle, 10.0)); // normals on edges decide which pair
  }
  SECTION("half metres")
  {
    Experiment experiment(0.5);
    const auto bySize = experiment.Plan(Planner::VIEWSHED_SIZE);
    // 32 steep ones; those at 2.5 m, on the edge to the ground, count as ground: its cells come
    // first.
    CHECK(experiment.Candidates->GetOutput()->GetNumberOfPoints() == 1681 - 32);
    CHECK(experiment.TestPoints->GetOutput()->GetNumberOfPoints() == 1681);
    CHECK(bySize.size() == 4);
    CHECK(Experiment::CountOnTop(bySize) == 4);
    const auto byAngle = experiment.Plan(Planner::MEAN_INCIDENCE_ANGLE);
    CHECK(AreOppositeCorners(byAngle, 10.0));
    CHECK(Experiment::CountOnTop(byAngle) == 0);
    CHECK(experiment.Plan(Planner::GREEDY).size() == 3);
    CHECK(experiment.Plan(Planner::BEST).size() == 2);
  }
}

TEST_CASE("PyramidPlan: the result does not depend on details", "[PyramidPlan]")
{
  const double tolerance = GENERATE(0.02, 0.05, 0.1);
  const double step = GENERATE(0.5, 1.0);
  const bool withBeside = GENERATE(false, true);
  Experiment experiment(step, withBeside);
  experiment.Viewsheds->SetHitTolerance(tolerance);
  CAPTURE(tolerance, step, withBeside);
  const auto bySize = experiment.Plan(Planner::VIEWSHED_SIZE);
  // On the finer grid, with points at the shoulder's edge, two on top are enough (confirmed by a
  // loop over all lines and triangles).
  CHECK(bySize.size() >= (step == 0.5 && withBeside ? 2 : 3));
  CHECK(Experiment::CountOnTop(bySize) >= 1);
  const auto byAngle = experiment.Plan(Planner::MEAN_INCIDENCE_ANGLE);
  CHECK(AreOppositeCorners(byAngle, 10.0));
  CHECK(Experiment::CountOnTop(byAngle) == 0);
}

TEST_CASE(
  "PyramidPlan: the result does not depend on the order of equal candidates", "[PyramidPlan]")
{
  Experiment experiment;
  experiment.Viewsheds->Update();
  vtkPolyData* views = experiment.Viewsheds->GetOutput();
  const vtkIdType count = views->GetNumberOfPoints();
  const std::uint64_t shuffle = GENERATE(1, 2, 3);
  std::vector<vtkIdType> order;
  for (vtkIdType i = 0; i < count; ++i)
  {
    order.push_back(i);
  }
  std::sort(order.begin(), order.end(),
    [shuffle](vtkIdType a, vtkIdType b)
    {
      const auto key = [shuffle](vtkIdType i)
      {
        return helios::Uniform4(
          shuffle, helios::RandomStream::Scene, static_cast<std::uint64_t>(i), 0)[0];
      };
      return key(a) < key(b);
    });
  vtkNew<vtkPolyData> shuffled;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  shuffled->GetPointData()->CopyAllOn();
  shuffled->GetPointData()->CopyAllocate(views->GetPointData(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(views->GetPoint(order[i]));
    shuffled->GetPointData()->CopyData(views->GetPointData(), order[i], i);
  }
  shuffled->SetPoints(points);
  experiment.Planner->SetInputData(0, shuffled);
  const auto bySize = experiment.Plan(Planner::VIEWSHED_SIZE);
  CHECK(bySize.size() >= 3);
  CHECK(Experiment::CountOnTop(bySize) >= 1);
  const auto byAngle = experiment.Plan(Planner::MEAN_INCIDENCE_ANGLE);
  CHECK(AreOppositeCorners(byAngle, 10.0));
}

TEST_CASE("PyramidPlan: pyramids of other sizes", "[PyramidPlan]")
{
  SECTION("3 m wide, 3 and 3.75 m high, scanner at 1 m")
  {
    helios::Pyramid pyramid{ 10.0, 3.0, 2.0, 3.0, 3.75 };
    Experiment experiment(1.0, false, pyramid, 1.0);
    CHECK(experiment.Plan(Planner::VIEWSHED_SIZE).size() == 3);
    CHECK(experiment.Plan(Planner::MEAN_INCIDENCE_ANGLE).size() == 2);
    CHECK(experiment.Plan(Planner::BEST).size() == 2);
  }
  SECTION("3 m wide, 2 and 3 m high, scanner at 0.5 m")
  {
    helios::Pyramid pyramid{ 12.0, 3.0, 2.0, 2.0, 3.0 };
    Experiment experiment(1.0, false, pyramid, 0.5);
    CHECK(experiment.Plan(Planner::VIEWSHED_SIZE).size() == 3);
    CHECK(experiment.Plan(Planner::MEAN_INCIDENCE_ANGLE).size() == 2);
  }
}
