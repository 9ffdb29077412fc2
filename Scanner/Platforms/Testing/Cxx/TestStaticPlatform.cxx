// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosWaypointTesting.h"
#include "vtkHeliosStaticPlatform.h"

#include <catch2/catch.hpp>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;

TEST_CASE("StaticPlatform: one sample, level, at rest", "[StaticPlatform]")
{
  vtkNew<vtkHeliosStaticPlatform> platform;
  platform->SetStartTime(12.5);
  platform->SetInputData(helios::MakeWaypoints({ { 1.0, 2.0, 3.0 } }));
  platform->Update();
  vtkPolyData* path = platform->GetOutput();
  REQUIRE(path->GetNumberOfPoints() == 1);
  CHECK(path->GetNumberOfVerts() == 1);
  CHECK(path->GetPoint(0)[2] == 3.0);
  CHECK(helios::Value(path, names::GpsTime, 0) == 12.5);
  CHECK(helios::Value(path, names::Orientation, 0, 0) == 1.0);
  CHECK(helios::Value(path, names::Velocity, 0, 0) == 0.0);
  CHECK(helios::Value(path, names::LegIds, 0) == 0.0);
}

TEST_CASE("StaticPlatform: the heading counts clockwise from north", "[StaticPlatform]")
{
  vtkNew<vtkHeliosStaticPlatform> platform;
  platform->SetInputData(helios::MakeWaypoints({ { 0.0, 0.0, 0.0 } }));
  for (const double heading : { 0.0, 30.0, 90.0, 180.0, -90.0, 360.0 })
  {
    platform->SetHeading(heading);
    platform->Update();
    const auto forward = helios::BodyToWorld(platform->GetOutput(), 0, { 0.0, 1.0, 0.0 });
    const double angle = heading * std::acos(-1.0) / 180.0;
    INFO("heading " << heading);
    CHECK(forward[0] == Approx(std::sin(angle)).margin(1e-15));
    CHECK(forward[1] == Approx(std::cos(angle)).margin(1e-15));
    CHECK(forward[2] == 0.0);
  }
}

TEST_CASE("StaticPlatform: more than one waypoint is an error", "[StaticPlatform]")
{
  vtkNew<vtkHeliosStaticPlatform> platform;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(platform);
  platform->SetInputData(helios::MakeWaypoints({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }));
  platform->Update();
  CHECK(
    log->HasError("A static platform needs exactly one waypoint, the input has 2; run it once"));
}
