// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Floor plans with walls 3 m high: visibility by rays in space equals that by lines in the plan.

#include "vtkHeliosViewsheds.h"

#include "heliosFloorPlans.h"
#include "heliosPlanningTest.h"
#include "heliosVisibility.h"
#include "vtkHeliosScanPositionPlanner.h"

#include <catch2/catch.hpp>

namespace
{

/// The walls of a floor plan, two triangles each.
vtkSmartPointer<vtkPolyData> MakeWalls(const helios::FloorPlan& plan)
{
  std::vector<std::array<double, 3>> corners;
  std::vector<std::array<int, 3>> triangles;
  std::vector<helios::PlanPolygon> outlines = plan.Solids;
  outlines.push_back(plan.Room);
  for (const helios::PlanPolygon& outline : outlines)
  {
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      const auto& a = outline[i];
      const auto& b = outline[(i + 1) % outline.size()];
      const int first = static_cast<int>(corners.size());
      for (const double z : { 0.0, 3.0 })
      {
        corners.push_back({ a[0], a[1], z });
        corners.push_back({ b[0], b[1], z });
      }
      triangles.push_back({ first, first + 1, first + 3 });
      triangles.push_back({ first, first + 3, first + 2 });
    }
  }
  return helios::MakeTriangles(corners, triangles);
}

} // namespace

TEST_CASE("FloorPlanViews: rays between walls agree with lines in the plan", "[FloorPlanViews]")
{
  int sum = 0;
  for (const helios::FloorPlan& plan : helios::MakeFloorPlans())
  {
    vtkNew<vtkHeliosViewsheds> viewsheds;
    vtkNew<vtkPolyData> places; // without the plan's own matrix
    places->SetPoints(plan.GetCandidates()->GetPoints());
    const auto walls = MakeWalls(plan);
    viewsheds->SetInputData(0, walls);
    viewsheds->SetInputData(1, places);
    viewsheds->SetInputData(2, plan.GetTestPoints());
    viewsheds->Update();
    const vtkIdType testPoints = plan.GetTestPoints()->GetNumberOfPoints();
    helios::Visibility rays, lines;
    REQUIRE(rays.Set(viewsheds->GetOutput(), testPoints).IsOk());
    REQUIRE(lines.Set(plan.GetCandidates(), testPoints).IsOk());
    int different = 0;
    for (vtkIdType c = 0; c < places->GetNumberOfPoints(); ++c)
    {
      for (vtkIdType v = 0; v < testPoints; ++v)
      {
        different += rays.IsVisible(c, v) != lines.IsVisible(c, v);
      }
    }
    INFO(plan.Name);
    CHECK(different == 0);

    vtkNew<vtkHeliosScanPositionPlanner> planner;
    planner->SetInputConnection(0, viewsheds->GetOutputPort());
    planner->SetInputData(1, plan.GetTestPoints());
    planner->SetMethodToViewshedSize();
    planner->Update();
    CHECK(planner->GetNumberOfSelected() == plan.Truth.Viewshed);
    planner->SetMethodToBest();
    planner->Update();
    sum += static_cast<int>(planner->GetNumberOfSelected());
  }
  CHECK(sum <= 31); // within 4 % of 30
}
