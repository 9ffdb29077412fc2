// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// All PCL filters: points that are not finite, no points, distant points, and an abort.
#include "heliosPclTesting.h"
#include "vtkHeliosPCLClusters.h"
#include "vtkHeliosPCLGroundFilter.h"
#include "vtkHeliosPCLNormals.h"
#include "vtkHeliosPCLOutlierRemoval.h"
#include "vtkHeliosPCLPlanes.h"
#include "vtkHeliosPCLVoxelGrid.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>

#include <catch2/catch.hpp>

#include <limits>

namespace names = vtkHeliosArrayNames;

namespace
{

helios::Triples MakePoints(int count)
{
  helios::Uniform uniform(5);
  helios::Triples points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back(helios::Utm + helios::Triple{ uniform(0, 5), uniform(0, 5), uniform(0, 1) });
  }
  return points;
}

} // namespace

TEMPLATE_TEST_CASE("PCLFilter: common behaviour of all filters", "[PCLFilter]",
  vtkHeliosPCLClusters, vtkHeliosPCLGroundFilter, vtkHeliosPCLNormals, vtkHeliosPCLOutlierRemoval,
  vtkHeliosPCLPlanes, vtkHeliosPCLVoxelGrid)
{
  using Filtering = helios::Filtering<TestType>;
  SECTION("points of the input bit by bit, with its arrays")
  {
    Filtering run(MakePoints(300));
    REQUIRE(run.Run());
    CHECK(run.Count() > 200);
    CHECK(run.CountMoved() == 0);
    CHECK(run.Output()->GetPoints()->GetDataType() == VTK_DOUBLE);
    CHECK(run.GetField(names::GpsEpoch)->GetTuple1(0) == 1e9);
    CHECK(run.Output()->GetNumberOfCells() == 0);
    CHECK(run.Log->Warnings.empty());
  }
  SECTION("points that are not finite are dropped and counted")
  {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    helios::Triples points = MakePoints(300);
    points[7][2] = nan;
    points[8][0] = -infinity;
    Filtering run(points);
    REQUIRE(run.Run());
    CHECK(run.Log->HasWarning("Input: 2 of 300 points are not finite: dropped"));
    CHECK(run.Filter->GetNumberOfDroppedPoints() == 2);
    CHECK(run.Count() <= 298);
    CHECK(run.CountMoved() == 0);
  }
  SECTION("no points: no output")
  {
    Filtering run{ helios::Triples() };
    REQUIRE(run.Run());
    CHECK(run.Count() == 0);
    vtkNew<vtkPolyData> nothing;
    Filtering bare(nothing);
    REQUIRE(bare.Run());
    CHECK(bare.Count() == 0);
  }
  SECTION("one point, and equal points")
  {
    for (const std::size_t count : { 1, 2, 50 })
    {
      Filtering run(helios::Triples(count, helios::Utm));
      REQUIRE(run.Run());
      CHECK(run.Count() >= 1);
      CHECK(run.CountMoved() == 0);
    }
  }
  SECTION("vertices if the input has them")
  {
    const auto cloud = helios::MakeCloud(MakePoints(100));
    vtkNew<vtkCellArray> vertices;
    const vtkIdType id = 0;
    vertices->InsertNextCell(1, &id);
    cloud->SetVerts(vertices);
    Filtering run(cloud);
    REQUIRE(run.Run());
    CHECK(run.Output()->GetNumberOfVerts() == run.Count());
  }
  SECTION("an array of another length is an error")
  {
    const auto cloud = helios::MakeCloud(MakePoints(100));
    helios::AddColumn<vtkFloatArray>(cloud->GetPointData(), "Own", 99, [](vtkIdType) { return 0; });
    Filtering run(cloud);
    CHECK(run.FailsWith("Input: the point array Own has 99 tuples for 100 points; give it one per "
                        "point, or remove it"));
  }
  SECTION("an abort is an error")
  {
    Filtering run(MakePoints(100));
    vtkNew<vtkCallbackCommand> abort;
    abort->SetCallback([](vtkObject* caller, unsigned long, void*, void*)
      { vtkAlgorithm::SafeDownCast(caller)->SetAbortExecute(1); });
    run.Filter->AddObserver(vtkCommand::ProgressEvent, abort);
    CHECK(run.FailsWith("The work was aborted at 10 %; update again to complete it"));
  }
  SECTION("prints its properties")
  {
    vtkNew<TestType> filter;
    std::ostringstream text;
    filter->Print(text);
    CHECK(text.str().find("NumberOfDroppedPoints: 0") != std::string::npos);
  }
}

TEST_CASE("PCLFilter: warns about points far from the centre", "[PCLFilter]")
{
  helios::Triples points = MakePoints(20);
  points.push_back(helios::Utm + helios::Triple{ 20000.0, 0.0, 0.0 });
  helios::Filtering<vtkHeliosPCLOutlierRemoval> run(points);
  REQUIRE(run.Run());
  CHECK(run.Log->HasWarning("0.5 mm or more; process them in tiles"));
}
