// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFlightView.h"
#include "heliosPlanView.h"
#include "heliosViewerTest.h"
#include "vtkHeliosFlightArrayNames.h"

#include <catch2/catch.hpp>

#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace helios;
using namespace helios::viewer;
namespace fs = std::filesystem;
namespace names = vtkHeliosArrayNames;
namespace flight = vtkHeliosFlightArrayNames;

namespace
{

/// Five test points, visible from no to three positions, 4 m apart along x.
Plan MakePlan()
{
  Plan plan;
  plan.TestPoints =
    MakeEchoes({ { -8, 4, 0 }, { -4, 4, 0 }, { 0, 4, 0 }, { 4, 4, 0 }, { 8, 4, 0 } });
  AddColumn(plan.TestPoints, names::Coverable, { 0, 1, 1, 1, 1 });
  AddColumn(plan.TestPoints, names::NumberOfScans, { 0, 0, 1, 2, 5 });
  plan.Candidates = MakeEchoes({ { 0, -8, 0 } });
  plan.Positions = MakeEchoes({ { -4, -4, 1.5 }, { 4, -4, 1.5 } });
  return plan;
}

void Write(vtkPolyData* data, const fs::path& path)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(data);
  writer->SetFileName(path.c_str());
  writer->Write();
}

} // namespace

TEST_CASE("PlanView: test points are coloured by the number of scans that see them")
{
  Stage stage;
  const Vec3 origin(500000.0, 5400000.0, 0.0);
  Plan plan = MakePlan();
  for (vtkPolyData* data : { plan.TestPoints.Get(), plan.Candidates.Get(), plan.Positions.Get() })
  {
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      data->GetPoints()->SetPoint(i, (Vec3(data->GetPoint(i)) + origin).GetData());
    }
  }
  PlanView view(stage.Renderer, plan, origin);
  stage.Render();
  CHECK(stage.GetColorAt(-8, 4) == Rgb{ 110, 112, 118 });
  CHECK(stage.GetColorAt(-4, 4) == Rgb{ 235, 60, 55 });
  CHECK(stage.GetColorAt(0, 4) == Rgb{ 250, 205, 70 });
  CHECK(stage.GetColorAt(4, 4) == Rgb{ 110, 205, 90 });
  CHECK(stage.GetColorAt(8, 4) == Rgb{ 70, 150, 245 });
  CHECK(stage.GetColorAt(-4, -4) != Black); // a tripod, or its number
  CHECK(stage.GetColorAt(4, -4) != Black);
  CHECK(view.GetNumberOfPositions() == 2);
  CHECK(view.GetNumberOfTestPoints() == 5);
  CHECK(view.GetNumberCoverable() == 4);
  CHECK(view.GetNumberCovered() == 3);
  CHECK(view.Describe().find("2 scan positions see 3 of 5 test points: 60.0 %, or 75.0 %") == 0);
  const Legend legend = view.MakeLegend();
  CHECK(legend.IsCategory);
  REQUIRE(legend.Marks.size() == 7);
  CHECK(legend.Marks[1].Text == "2");
  CHECK(legend.Colors[1] == PlanView::GetColor(true, 2));
  CHECK(legend.Marks[4].Text == "not visible from anywhere");
  CHECK(legend.Colors[4] == PlanView::GetColor(false, 0));
  CHECK(legend.Marks[6].Text == "candidate");
  view.SetVisible(false);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
}

TEST_CASE("FlightView: lines are numbered, cells are coloured by their density")
{
  Stage stage;
  const Vec3 origin(0.0, 0.0, 0.0);
  Plan plan;
  plan.Cells = MakeEchoes({ { -8, 4, 0 }, { -4, 4, 0 }, { 0, 4, 0 }, { 4, 4, 0 } });
  AddColumn(plan.Cells, flight::PulseDensity, { 0, 4, 8, 8 });
  // Two lines, a turn between them that does not fire.
  plan.Lines =
    MakeEchoes({ { -8, -4, 9 }, { 0, -4, 9 }, { 8, -4, 9 }, { 8, -8, 9 }, { -8, -8, 9 } });
  AddColumn(plan.Lines, flight::Active, { 1, 1, 0, 1, 0 });
  AddColumn(plan.Lines, names::LegIds, { 0, 0, 0, 1, 1 });
  FlightView view(stage.Renderer, plan, origin);
  stage.Render();
  CHECK(stage.GetColorAt(-8, 4) == Rgb{ 235, 60, 55 }); // no pulse
  CHECK(stage.GetColorAt(-4, 4) == FlightView::GetColor(4.0, 8.0));
  CHECK(stage.GetColorAt(4, 4) == FlightView::GetColor(8.0, 8.0));
  CHECK(FlightView::GetColor(8.0, 8.0) == MakeRamp(RampPart())[255]);
  CHECK(FlightView::GetColor(9.0, 8.0) == FlightView::GetColor(8.0, 8.0));
  CHECK(stage.GetColorAt(4, -4) == Rgb{ 255, 158, 38 });
  CHECK(stage.GetColorAt(8, -6) == Black); // the turn
  CHECK(stage.GetColorAt(0, -8) == Rgb{ 255, 158, 38 });
  CHECK(view.GetNumberOfLines() == 2);
  CHECK(view.GetNumberOfCells() == 4);
  CHECK(view.GetNumberOfGaps() == 1);
  CHECK(view.GetMeanDensity() == 5.0);
  CHECK(view.Describe().find(
          "2 flight lines give 5 pulses/m\xC2\xB2 on average; 25.0 % of the area has none") == 0);
  const Legend legend = view.MakeLegend();
  CHECK(legend.Title == "Pulses [1/m\xC2\xB2]");
  CHECK_FALSE(legend.IsCategory);
  CHECK(legend.Colors.back() == FlightView::GetColor(8.0, 8.0));
  REQUIRE(legend.Marks.size() > 2);
  CHECK(legend.Marks.back().Text == "8");
  CHECK(legend.Marks.back().Position == 1.0);
  REQUIRE(legend.Others.size() == 2);
  CHECK(legend.Others[1].first == Rgb{ 235, 60, 55 });
  CHECK(legend.Others[1].second == "no pulse");
  view.SetVisible(false);
  stage.Render();
  CHECK(stage.CountPixels(Black) == 200 * 200);
}

TEST_CASE("PlanView: a plan is recognised by its files")
{
  std::string name = (fs::temp_directory_path() / "vtkHeliosPlanXXXXXX").string();
  const fs::path folder = ::mkdtemp(name.data());
  CHECK_FALSE(IsPlan(folder.string()));
  Plan plan;
  CHECK(ReadPlan(folder.string(), plan).Message() ==
    folder.string() + ": has no positions and no flight lines; plan again, or give another folder");
  const Plan made = MakePlan();
  Write(made.Positions, folder / "positions.vtp");
  CHECK(IsPlan(folder.string()));
  CHECK(IsPlan((folder / "positions.vtp").string()));
  CHECK_FALSE(IsPlan((folder / "test_points.vtp").string()));
  REQUIRE(ReadPlan((folder / "positions.vtp").string(), plan).IsOk());
  CHECK(plan.Positions->GetNumberOfPoints() == 2);
  CHECK(plan.TestPoints == nullptr);
  Write(made.TestPoints, folder / "test_points.vtp");
  std::ofstream(folder / "survey.xml") << "<document/>";
  REQUIRE(ReadPlan(folder.string(), plan).IsOk());
  CHECK(plan.TestPoints->GetNumberOfPoints() == 5);
  CHECK(plan.Survey == (folder / "survey.xml").string());
  Write(made.Positions, folder / "lines.vtp");
  CHECK(IsPlan((folder / "lines.vtp").string()));
  std::ofstream(folder / "candidates.vtp") << "no XML";
  CHECK(ReadPlan(folder.string(), plan).Message() ==
    (folder / "candidates.vtp").string() + ": cannot be read; plan again");
  fs::remove_all(folder);
}
