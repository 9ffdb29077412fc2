// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Lines over rectangles have lengths in closed form; the heading is the fastest of a finer search.
#include "vtkHeliosFlightLines.h"

#include "heliosPlanningTest.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosFlightArrayNames.h"

#include <vtkDataArray.h>
#include <vtkMath.h>
#include <vtkPointData.h>

#include <cmath>
#include <limits>

namespace
{

vtkSmartPointer<vtkPolyData> MakePolygon(const std::vector<std::array<double, 3>>& corners)
{
  auto area = helios::MakePoints(corners);
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell(static_cast<int>(corners.size()));
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    polys->InsertCellPoint(static_cast<vtkIdType>(i));
  }
  area->SetPolys(polys);
  return area;
}

vtkSmartPointer<vtkPolyData> MakeRectangle(double x, double y)
{
  return MakePolygon({ { 0, 0, 5 }, { x, 0, 5 }, { x, y, 5 }, { 0, y, 5 } });
}

struct Flight
{
  vtkNew<vtkHeliosFlightLines> Filter;
  vtkNew<helios::ErrorObserver> Log;

  explicit Flight(vtkPolyData* area)
  {
    this->Filter->SetInputData(area);
    this->Log->Watch(this->Filter);
  }

  vtkPolyData* Update()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
};

} // namespace

TEST_CASE("FlightLines: a rectangle, lines along x", "[FlightLines]")
{
  Flight flight(MakeRectangle(1000, 300));
  flight.Filter->OptimizeHeadingOff();
  flight.Filter->SetHeading(90.0);
  flight.Filter->SetSwathWidth(100.0);
  flight.Filter->SetLineSpacing(80.0);
  flight.Filter->SetAltitude(500.0);
  flight.Filter->SetRunIn(20.0);
  flight.Filter->SetSpeed(50.0);
  flight.Filter->SetTurnTime(60.0);
  vtkPolyData* lines = flight.Update();
  // 300 - 100 = 200 m between the outer lines: 3 gaps of at most 80 m.
  REQUIRE(flight.Filter->GetNumberOfLines() == 4);
  CHECK(lines->GetNumberOfLines() == 4);
  CHECK(flight.Filter->GetLineLength() == Approx(4 * 1040.0));
  CHECK(flight.Filter->GetFlightTime() == Approx(4 * 1040.0 / 50.0 + 3 * 60.0));
  vtkPointData* data = lines->GetPointData();
  for (int i = 0; i < 4; ++i)
  {
    double begin[3], end[3];
    lines->GetPoint(2 * i, begin);
    lines->GetPoint(2 * i + 1, end);
    const double y = 250.0 - i * 200.0 / 3.0; // to the right of the first heading
    const double x[2] = { -20.0, 1020.0 };
    CHECK(begin[0] == Approx(x[i % 2]));
    CHECK(end[0] == Approx(x[1 - i % 2]));
    CHECK(begin[1] == Approx(y));
    CHECK(end[1] == Approx(y));
    CHECK(begin[2] == 500.0);
    CHECK(data->GetArray(vtkHeliosFlightArrayNames::Active)->GetTuple1(2 * i) == 1.0);
    CHECK(data->GetArray(vtkHeliosFlightArrayNames::Active)->GetTuple1(2 * i + 1) == 0.0);
    CHECK(data->GetArray(vtkHeliosArrayNames::Speed)->GetTuple1(2 * i) == 50.0);
    CHECK(data->GetArray(vtkHeliosArrayNames::LegIds)->GetTuple1(2 * i + 1) == i);
  }
}

TEST_CASE("FlightLines: an area narrower than the swath is one line", "[FlightLines]")
{
  Flight flight(MakeRectangle(90, 700));
  vtkPolyData* lines = flight.Update();
  REQUIRE(lines->GetNumberOfLines() == 1);
  CHECK(flight.Filter->GetLineLength() == Approx(700.0).epsilon(1e-4));
  CHECK(lines->GetPoint(0)[0] == Approx(45.0).epsilon(1e-3));
}

TEST_CASE("FlightLines: turns", "[FlightLines]")
{
  Flight flight(MakeRectangle(1000, 180));
  flight.Filter->OptimizeHeadingOff();
  flight.Filter->SetHeading(90.0);
  double wanted = 80.0;
  SECTION("without a radius: straight") {}
  SECTION("wide: a half circle and a straight part")
  {
    flight.Filter->SetTurnRadius(10.0);
    wanted = 10.0 * vtkMath::Pi() + 60.0;
  }
  SECTION("as wide as the circle")
  {
    flight.Filter->SetTurnRadius(40.0);
    wanted = 40.0 * vtkMath::Pi();
  }
  SECTION("tight: three arcs, found by their centres")
  {
    // Circles of radius R: the outer ones touch both lines from outside, the middle one touches both.
    const double radius = 100.0;
    flight.Filter->SetTurnRadius(radius);
    const double half = 0.5 * 80.0 + radius; // half the distance of the outer centres
    const double lean = std::acos(half / (2.0 * radius));
    wanted = radius * (2.0 * lean + vtkMath::Pi() + 2.0 * lean);
  }
  flight.Update();
  REQUIRE(flight.Filter->GetNumberOfLines() == 2);
  CHECK(flight.Filter->GetTurnLength() == Approx(wanted));
}

TEST_CASE("FlightLines: the heading is the fastest", "[FlightLines]")
{
  const std::vector<std::vector<std::array<double, 3>>> areas = {
    { { 0, 0, 0 }, { 1000, 150, 0 }, { 900, 700, 0 }, { 100, 500, 0 } },
    { { 0, 0, 0 }, { 800, 0, 0 }, { 300, 900, 0 } },
    { { 0, 0, 0 }, { 500, -300, 0 }, { 1200, 100, 0 }, { 1100, 600, 0 }, { 400, 800, 0 } },
  };
  const auto& area = areas[GENERATE(0, 1, 2)];
  const double radius = GENERATE(0.0, 150.0);
  Flight best(MakePolygon(area));
  best.Filter->SetTurnRadius(radius);
  best.Update();
  Flight other(MakePolygon(area));
  other.Filter->SetTurnRadius(radius);
  other.Filter->OptimizeHeadingOff();
  double least = std::numeric_limits<double>::max();
  for (double heading = 0.0; heading < 180.0; heading += 0.02)
  {
    other.Filter->SetHeading(heading);
    other.Update();
    least = std::min(least, other.Filter->GetFlightTime());
  }
  CHECK(best.Filter->GetFlightTime() <= least * 1.001);
}

TEST_CASE("FlightLines: the radius of a level turn", "[FlightLines]")
{
  CHECK(vtkHeliosFlightLines::ComputeTurnRadius(60.0, 45.0) == Approx(3600.0 / 9.80665));
  CHECK(vtkHeliosFlightLines::ComputeTurnRadius(30.0, 20.0) == Approx(252.148).margin(1e-3));
}

TEST_CASE("FlightLines: errors", "[FlightLines]")
{
  Flight flight(MakeRectangle(100, 100));
  std::string wanted;
  SECTION("a spacing above the swath")
  {
    flight.Filter->SetLineSpacing(120.0);
    wanted = "the line spacing is 120 m, above the swath width 100 m";
  }
  SECTION("too many lines")
  {
    flight.Filter->SetLineSpacing(1e-3);
    wanted = "lines; give one that results in fewer than";
  }
  SECTION("no surface")
  {
    flight.Filter->SetInputData(MakePolygon({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } }));
    wanted = "the area has no polygon with a surface";
  }
  SECTION("not finite")
  {
    flight.Filter->SetInputData(MakePolygon({ { 0, 0, 0 }, { std::nan(""), 1, 0 }, { 2, 0, 0 } }));
    wanted = "Vertex 1 of the area is (nan, 1)";
  }
  flight.Update();
  CHECK_THAT(flight.Log->Errors, Catch::Contains(wanted));
}
