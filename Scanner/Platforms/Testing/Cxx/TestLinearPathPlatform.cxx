// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosWaypointTesting.h"
#include "vtkHeliosLinearPathPlatform.h"

#include <catch2/catch.hpp>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <limits>
#include <string>

namespace names = vtkHeliosArrayNames;

namespace
{

vtkSmartPointer<vtkPolyData> Run(const std::vector<helios::Point>& positions,
  const std::vector<double>& speeds, double start = 0.0)
{
  vtkNew<vtkHeliosLinearPathPlatform> platform;
  platform->SetStartTime(start);
  platform->SetInputData(helios::MakeWaypoints(positions, speeds));
  platform->Update();
  return platform->GetOutput();
}

void CheckForward(vtkPolyData* path, vtkIdType sample, double x, double y)
{
  const helios::Point forward = helios::BodyToWorld(path, sample, { 0.0, 1.0, 0.0 });
  const helios::Point up = helios::BodyToWorld(path, sample, { 0.0, 0.0, 1.0 });
  INFO("sample " << sample);
  CHECK(forward[0] == Approx(x).margin(1e-15));
  CHECK(forward[1] == Approx(y).margin(1e-15));
  CHECK(up[2] == 1.0); // level
}

} // namespace

TEST_CASE("LinearPathPlatform: 1000 m at 25 m/s take exactly 40 s", "[LinearPathPlatform]")
{
  for (const helios::Point& end : { helios::Point{ 1000.0, 0.0, 0.0 },
         helios::Point{ 600.0, -800.0, 0.0 }, helios::Point{ 0.0, 0.0, 1000.0 } })
  {
    auto path = Run({ { 0.0, 0.0, 0.0 }, end }, { 25.0, 0.0 });
    REQUIRE(path->GetNumberOfPoints() == 2);
    CHECK(helios::Value(path, names::GpsTime, 0) == 0.0);
    CHECK(helios::Value(path, names::GpsTime, 1) == 40.0);
    for (int k = 0; k < 3; ++k)
    {
      CHECK(path->GetPoint(1)[k] == end[k]);
      CHECK(helios::Value(path, names::Velocity, 0, k) == Approx(0.025 * end[k]).epsilon(1e-15));
    }
  }
}

TEST_CASE("LinearPathPlatform: two samples per leg, turning at once", "[LinearPathPlatform]")
{
  auto path =
    Run({ { 0.0, 0.0, 10.0 }, { 100.0, 0.0, 10.0 }, { 100.0, 50.0, 60.0 }, { 0.0, 150.0, 60.0 } },
      { 10.0, 5.0, 20.0, 0.0 }, 100.0);
  REQUIRE(path->GetNumberOfPoints() == 6);
  const double climb = std::hypot(50.0, 50.0) / 5.0;
  const double last = std::hypot(100.0, 100.0) / 20.0;
  const double times[6] = { 100.0, 110.0, 110.0, 110.0 + climb, 110.0 + climb,
    110.0 + climb + last };
  for (vtkIdType i = 0; i < 6; ++i)
  {
    CHECK(helios::Value(path, names::GpsTime, i) == Approx(times[i]).epsilon(1e-15));
    CHECK(helios::Value(path, names::LegIds, i) == static_cast<double>(i / 2));
  }
  CHECK(helios::Value(path, names::GpsTime, 3) == helios::Value(path, names::GpsTime, 4));
  const double s = std::sqrt(0.5);
  CheckForward(path, 0, 1.0, 0.0);
  CheckForward(path, 1, 1.0, 0.0);
  CheckForward(path, 2, 0.0, 1.0); // level on the climb
  CheckForward(path, 3, 0.0, 1.0);
  CheckForward(path, 5, -s, s);
  CHECK(helios::Value(path, names::Velocity, 2, 1) == Approx(5.0 * s));
  CHECK(helios::Value(path, names::Velocity, 2, 2) == Approx(5.0 * s));
}

TEST_CASE(
  "LinearPathPlatform: y points to the next waypoint in all directions", "[LinearPathPlatform]")
{
  for (int degrees = -180; degrees < 180; degrees += 15)
  {
    const double a = degrees * std::acos(-1.0) / 180.0;
    auto path =
      Run({ { 5.0, 6.0, 7.0 }, { 5.0 + std::sin(a), 6.0 + std::cos(a), 3.0 } }, { 1.0, 1.0 });
    const helios::Point forward = helios::BodyToWorld(path, 0, { 0.0, 1.0, 0.0 });
    INFO("azimuth " << degrees);
    CHECK(forward[0] == Approx(std::sin(a)).margin(2e-15));
    CHECK(forward[1] == Approx(std::cos(a)).margin(2e-15));
    CHECK(forward[2] == 0.0);
  }
}

TEST_CASE("LinearPathPlatform: vertical and empty legs keep a heading", "[LinearPathPlatform]")
{
  SECTION("first: that of the next leg")
  {
    auto path = Run({ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 9.0 }, { 4.0, 0.0, 9.0 } }, { 3.0, 2.0, 1.0 });
    CheckForward(path, 0, 1.0, 0.0);
    CHECK(helios::Value(path, names::Velocity, 0, 2) == 3.0);
    CHECK(helios::Value(path, names::GpsTime, 3) == 5.0);
  }
  SECTION("later: that of the leg before")
  {
    auto path =
      Run({ { 0.0, 0.0, 0.0 }, { 0.0, -2.0, 0.0 }, { 0.0, -2.0, -9.0 }, { 1.0, -2.0, -9.0 } },
        { 1.0, 1.0, 1.0, 1.0 });
    CheckForward(path, 2, 0.0, -1.0);
    CheckForward(path, 3, 0.0, -1.0);
    CheckForward(path, 4, 1.0, 0.0);
  }
  SECTION("no length: no time, no speed")
  {
    auto path =
      Run({ { 0.0, 0.0, 0.0 }, { -2.0, 0.0, 0.0 }, { -2.0, 0.0, 0.0 }, { -3.0, 0.0, 0.0 } },
        { 1.0, 1.0, 1.0, 1.0 });
    REQUIRE(path->GetNumberOfPoints() == 6);
    CheckForward(path, 2, -1.0, 0.0);
    CHECK(helios::Value(path, names::GpsTime, 2) == 2.0);
    CHECK(helios::Value(path, names::GpsTime, 3) == 2.0);
    CHECK(helios::Value(path, names::LegIds, 3) == 1.0);
    CHECK(helios::Value(path, names::Velocity, 2, 0) == 0.0);
    CHECK(helios::Value(path, names::GpsTime, 5) == 3.0);
  }
  SECTION("only vertical legs: north")
  {
    auto path = Run({ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } }, { 1.0, 1.0 });
    CheckForward(path, 0, 0.0, 1.0);
  }
}

TEST_CASE("LinearPathPlatform: the times of many legs do not drift", "[LinearPathPlatform]")
{
  // 100000 legs of 0.1 s back and forth: a plain sum is 1.9e-8 s off.
  const int legs = 100000;
  std::vector<helios::Point> positions;
  for (int i = 0; i <= legs; ++i)
  {
    positions.push_back({ i % 2 ? 1.0 : 0.0, 0.0, 0.0 });
  }
  auto path = Run(positions, std::vector<double>(legs + 1, 10.0));
  double before = 0.0;
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    const double time = helios::Value(path, names::GpsTime, i);
    REQUIRE(time >= before);
    before = time;
  }
  CHECK(before == 10000.0);
}

TEST_CASE("LinearPathPlatform: bad input is an error", "[LinearPathPlatform]")
{
  vtkNew<vtkHeliosLinearPathPlatform> platform;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(platform);
  const std::vector<helios::Point> two = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } };
  SECTION("one waypoint")
  {
    platform->SetInputData(helios::MakeWaypoints({ { 0.0, 0.0, 0.0 } }, { 1.0 }));
    platform->Update();
    CHECK(log->HasError("A linear path needs two or more waypoints, the input has 1; add the end"));
  }
  SECTION("no speed")
  {
    platform->SetInputData(helios::MakeWaypoints(two));
    platform->Update();
    CHECK(
      log->HasError("The waypoints need the point array Speed, one number per waypoint; add it"));
  }
  SECTION("an invalid speed")
  {
    const std::pair<double, std::string> speeds[] = { { 0.0, "0" }, { -3.0, "-3" },
      { std::numeric_limits<double>::quiet_NaN(), "nan" },
      { std::numeric_limits<double>::infinity(), "inf" } };
    for (const auto& [speed, text] : speeds)
    {
      log->Clear();
      platform->SetInputData(helios::MakeWaypoints(two, { speed, 1.0 }));
      platform->Update();
      CHECK(
        log->HasError("Speed of waypoint 0 is " + text + " m/s; it must be positive and finite."));
    }
  }
  SECTION("a leg without end")
  {
    platform->SetInputData(helios::MakeWaypoints(two, { 1e-310, 1.0 }));
    platform->Update();
    CHECK(log->HasError("The leg from waypoint 0 of 1 m at 1e-310 m/s never ends"));
  }
  CHECK(platform->GetOutput()->GetNumberOfPoints() == 0);
}

TEST_CASE(
  "LinearPathPlatform: the speed at the last waypoint has no effect", "[LinearPathPlatform]")
{
  auto path = Run({ { 0.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 } }, { 4.0, -1.0 });
  CHECK(helios::Value(path, names::GpsTime, 1) == 0.5);
}
