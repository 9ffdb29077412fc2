// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosWaypointTesting.h"
#include "vtkHeliosMulticopterPlatform.h"

#include <catch2/catch.hpp>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <limits>

namespace names = vtkHeliosArrayNames;
using helios::Mode;
using helios::Smooth;
using helios::Stop;
using helios::Through;

namespace
{

const double Pi = std::acos(-1.0);
constexpr double Gravity = 9.80665;

vtkSmartPointer<vtkPolyData> Run(vtkHeliosMulticopterPlatform* copter,
  const std::vector<helios::Point>& positions, const std::vector<double>& speeds, helios::Mode mode,
  const std::vector<double>& yaws = {})
{
  auto waypoints = helios::MakeFlight(positions, speeds, mode);
  if (!yaws.empty())
  {
    helios::AddValues(waypoints, names::YawAtDeparture, yaws);
  }
  copter->SetInputData(waypoints);
  copter->Update();
  auto path = vtkSmartPointer<vtkPolyData>::New();
  path->ShallowCopy(copter->GetOutput());
  return path;
}

double GetTime(vtkPolyData* path, vtkIdType sample)
{
  return helios::Value(path, names::GpsTime, sample);
}

double GetDuration(vtkPolyData* path)
{
  return GetTime(path, path->GetNumberOfPoints() - 1) - GetTime(path, 0);
}

double GetSpeed(vtkPolyData* path, vtkIdType sample)
{
  return std::hypot(helios::Value(path, names::Velocity, sample, 0),
    helios::Value(path, names::Velocity, sample, 1),
    helios::Value(path, names::Velocity, sample, 2));
}

/// The angle of the body's z axis from the vertical [deg].
double GetTilt(vtkPolyData* path, vtkIdType sample)
{
  const helios::Point up = helios::BodyToWorld(path, sample, { 0.0, 0.0, 1.0 });
  return std::atan2(std::hypot(up[0], up[1]), up[2]) * 180.0 / Pi;
}

/// The heading of the nose, clockwise from north [deg].
double GetHeading(vtkPolyData* path, vtkIdType sample)
{
  const helios::Point forward = helios::ForwardAt(path, sample);
  return std::atan2(forward[0], forward[1]) * 180.0 / Pi;
}

} // namespace

TEST_CASE(
  "MulticopterPlatform: tilt, drag and terminal speed of a helicopter", "[MulticopterPlatform]")
{
  // c = 1.225 kg/m, m = 1000 kg; terminal speed and the distance of the first 10 s.
  const double cases[3][3] = { { 2.0, 16.719920030476, 17.004391465585 },
    { 5.0, 26.464773693847, 42.167496731752 }, { 10.0, 37.570906953084, 83.568543218366 } };
  for (const auto& [tilt, terminal, way] : cases)
  {
    vtkNew<vtkHeliosMulticopterPlatform> copter;
    copter->SetMass(1000.0);
    copter->SetDragCoefficient(1.225);
    copter->SetMaximumPitch(tilt);
    copter->SetPitchRate(1000.0);
    auto path = Run(copter, { { 0.0, 0.0, 50.0 }, { 0.0, 5000.0, 50.0 } }, { 100.0, 0.0 }, Through);
    INFO("tilt " << tilt);
    REQUIRE(path->GetNumberOfPoints() > 2);
    // Tilting takes time: equivalent to a start in the middle of it.
    const double late = 0.5 * std::tan(tilt * Pi / 180.0) / (1000.0 * Pi / 180.0);
    CHECK(helios::PositionAt(path, 10.0 + late)[1] == Approx(way).epsilon(1e-6));
    const vtkIdType last = path->GetNumberOfPoints() - 1;
    CHECK(GetSpeed(path, last) == Approx(0.99 * terminal).epsilon(1e-9));
    CHECK(GetTilt(path, last) ==
      Approx(std::atan(0.9801 * std::tan(tilt * Pi / 180.0)) * 180.0 / Pi).epsilon(1e-9));
    double steepest = 0.0;
    for (vtkIdType i = 0; i <= last; ++i)
    {
      steepest = std::max(steepest, GetTilt(path, i));
      CHECK(std::abs(path->GetPoint(i)[0]) < 1e-9);
      CHECK(path->GetPoint(i)[2] == Approx(50.0).epsilon(1e-13));
    }
    CHECK(steepest == Approx(tilt).epsilon(1e-9));
    CHECK(helios::ForwardAt(path, last)[2] < 0.0); // nose down
  }
}

TEST_CASE(
  "MulticopterPlatform: thrust equals gravity, drag and acceleration", "[MulticopterPlatform]")
{
  vtkNew<vtkHeliosMulticopterPlatform> copter;
  copter->SetDragCoefficient(0.3);
  for (const Mode mode : { Stop, Smooth, Through })
  {
    auto path = Run(copter,
      { { 0.0, 0.0, 0.0 }, { 60.0, 0.0, 0.0 }, { 60.0, 80.0, 20.0 }, { 0.0, 160.0, 20.0 } },
      { 8.0, 8.0, 8.0, 8.0 }, mode);
    REQUIRE(helios::FindFlaw(path, 1e-3) == "");
    double worst = 0.0;
    for (vtkIdType i = 1; i + 1 < path->GetNumberOfPoints(); ++i)
    {
      const double dt = GetTime(path, i + 1) - GetTime(path, i - 1);
      if (dt < 1e-4 || dt > 0.05)
      {
        continue;
      }
      helios::Point thrust{ 0.0, 0.0, Gravity };
      for (int k = 0; k < 3; ++k)
      {
        const double v = helios::Value(path, names::Velocity, i, k);
        const double v0 = helios::Value(path, names::Velocity, i - 1, k);
        const double v1 = helios::Value(path, names::Velocity, i + 1, k);
        const double d0 = GetTime(path, i) - GetTime(path, i - 1);
        const double d1 = GetTime(path, i + 1) - GetTime(path, i);
        // The derivative at the middle sample of three.
        thrust[k] += ((v - v0) / d0 * d1 + (v1 - v) / d1 * d0) / dt + 0.03 * GetSpeed(path, i) * v;
      }
      const helios::Point up = helios::BodyToWorld(path, i, { 0.0, 0.0, 1.0 });
      double cross[3];
      vtkMath::Cross(thrust.data(), up.data(), cross);
      worst = std::max(worst, vtkMath::Norm(cross) / vtkMath::Norm(thrust.data()));
    }
    INFO("mode " << mode);
    CHECK(worst < 0.02); // inaccurate where the tilt begins to change
  }
}

TEST_CASE(
  "MulticopterPlatform: tilt rate and tilt are within their limits", "[MulticopterPlatform]")
{
  for (const double climb : { 0.0, 60.0, -60.0, 300.0, -300.0 })
  {
    vtkNew<vtkHeliosMulticopterPlatform> copter;
    copter->SetPitchRate(40.0);
    copter->SetMaximumPitch(30.0);
    auto path = Run(copter, { { 0.0, 0.0, 0.0 }, { 0.0, 100.0, climb } }, { 50.0, 0.0 }, Stop);
    double fastest = 0.0;
    double farthest = 0.0;
    for (vtkIdType i = 1; i < path->GetNumberOfPoints(); ++i)
    {
      const double dt = GetTime(path, i) - GetTime(path, i - 1);
      const double turn = std::abs(GetTilt(path, i) - GetTilt(path, i - 1));
      fastest = dt > 1e-6 ? std::max(fastest, turn / dt) : fastest;
      farthest = std::max(farthest, GetTilt(path, i));
    }
    INFO("climb " << climb);
    CHECK(fastest < 40.0 * (1.0 + 1e-4));
    CHECK(fastest > 5.0);
    CHECK(farthest < 30.0 * (1.0 + 1e-9));
    if (climb == 0.0)
    {
      CHECK(fastest > 39.0);
      CHECK(farthest > 29.9);
    }
  }
}

TEST_CASE("MulticopterPlatform: stop and turn", "[MulticopterPlatform]")
{
  vtkNew<vtkHeliosMulticopterPlatform> copter;
  copter->SetStartTime(100.0);
  copter->SetYawRate(30.0);
  const std::vector<helios::Point> way = { { 0.0, 0.0, 35.0 }, { 100.0, 0.0, 35.0 },
    { 100.0, 50.0, 45.0 } };
  auto path = Run(copter, way, { 5.0, 5.0, 0.0 }, Stop);
  CHECK(helios::FindFlaw(path, 1e-3) == "");
  CHECK(GetTime(path, 0) == 100.0);
  const auto first = helios::FindLeg(path, 0);
  const auto second = helios::FindLeg(path, 1);
  CHECK(GetSpeed(path, first[0]) == 0.0);
  CHECK(GetHeading(path, first[0]) == Approx(90.0));
  CHECK(GetSpeed(path, first[1]) < 1e-12);
  CHECK(helios::GetMiss(path, first[1], way[1]) < 1e-9);
  CHECK(helios::GetMiss(path, second[1], way[2]) < 1e-9);
  CHECK(GetSpeed(path, second[1]) < 1e-12);
  CHECK(GetTilt(path, second[1]) < 1e-9);
  // 90 degrees at 30 degrees/s: 3 s at the waypoint, level.
  double hover = 0.0;
  for (vtkIdType i = second[0]; GetHeading(path, i) > 1e-6; ++i)
  {
    CHECK(helios::GetMiss(path, i + 1, way[1]) < 1e-9);
    CHECK(GetTilt(path, i) < 1e-9);
    hover = GetTime(path, i + 1) - GetTime(path, second[0]);
  }
  CHECK(hover == Approx(3.0).epsilon(1e-12));
}

TEST_CASE(
  "MulticopterPlatform: the yaw at departure is kept along the leg", "[MulticopterPlatform]")
{
  vtkNew<vtkHeliosMulticopterPlatform> copter;
  const double none = std::numeric_limits<double>::quiet_NaN();
  auto path =
    Run(copter, { { 0.0, 0.0, 5.0 }, { 40.0, 0.0, 5.0 }, { 40.0, 40.0, 5.0 }, { 0.0, 40.0, 5.0 } },
      { 5.0, 5.0, 5.0, 5.0 }, Stop, { 30.0, -135.0, none, none });
  for (const auto& [leg, heading] :
    { std::pair<int, double>{ 0, 30.0 }, { 1, -135.0 }, { 2, -90.0 } })
  {
    const auto ends = helios::FindLeg(path, leg);
    CHECK(GetHeading(path, ends[1]) == Approx(heading));
    CHECK(GetHeading(path, (ends[0] + 3 * ends[1]) / 4) == Approx(heading));
  }
}

TEST_CASE("MulticopterPlatform: smooth turns are banked circles", "[MulticopterPlatform]")
{
  // v = 30 m/s, bank 20 degrees: R = 252.148254246777 m.
  vtkNew<vtkHeliosMulticopterPlatform> copter;
  copter->SetDragCoefficient(0.0);
  copter->SetMaximumRoll(20.0);
  const helios::Point corner{ 0.0, 2000.0, 300.0 };
  auto path = Run(copter, { { 0.0, 0.0, 300.0 }, corner, { 2000.0, 2000.0, 300.0 } },
    { 30.0, 30.0, 30.0 }, Smooth);
  CHECK(helios::FindFlaw(path, 1e-3) == "");
  const auto first = helios::FindLeg(path, 0);
  const vtkIdType middle = first[1];
  CHECK(GetTime(path, middle) == GetTime(path, middle + 1));
  CHECK(GetTilt(path, middle) == Approx(20.0).epsilon(1e-9));
  CHECK(GetHeading(path, middle) == Approx(45.0).epsilon(1e-9));
  CHECK(GetSpeed(path, middle) == Approx(30.0).epsilon(1e-12));
  // Its velocity turns by v / R.
  const vtkIdType i = middle - 20;
  const double turn =
    std::remainder(GetHeading(path, middle) - GetHeading(path, i), 360.0) * Pi / 180.0;
  const double radius = 30.0 * (GetTime(path, middle) - GetTime(path, i)) / turn;
  CHECK(GetTilt(path, i) == Approx(20.0).epsilon(1e-9));
  CHECK(radius == Approx(252.148254246777).epsilon(1e-9));
  // It cuts the corner by less than a circle plus the roll-in.
  const double miss = helios::GetMiss(path, middle, corner);
  CHECK(miss > radius * (std::sqrt(2.0) - 1.0));
  CHECK(miss < radius * (std::sqrt(2.0) - 1.0) + 30.0 * 20.0 / 28.65);
  // The right of the turn is down.
  CHECK(helios::BodyToWorld(path, middle, { 1.0, 0.0, 0.0 })[2] ==
    Approx(-std::sin(20.0 * Pi / 180.0)));
}

TEST_CASE("MulticopterPlatform: without SmoothTurn it passes the waypoint and overshoots",
  "[MulticopterPlatform]")
{
  vtkNew<vtkHeliosMulticopterPlatform> copter;
  const std::vector<helios::Point> way = { { 0.0, 0.0, 30.0 }, { 0.0, 200.0, 30.0 },
    { 200.0, 200.0, 60.0 }, { 400.0, 300.0, 30.0 } };
  auto path = Run(copter, way, { 10.0, 10.0, 10.0, 10.0 }, Through);
  CHECK(helios::FindFlaw(path, 1e-3) == "");
  for (int leg = 0; leg < 3; ++leg)
  {
    const auto ends = helios::FindLeg(path, leg);
    CHECK(helios::GetMiss(path, ends[0], way[leg]) < 1e-9);
    CHECK(helios::GetMiss(path, ends[1], way[leg + 1]) < 1e-9);
    CHECK(GetSpeed(path, ends[1]) == Approx(10.0).epsilon(1e-12));
  }
  double farthest = 0.0;
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    farthest = std::max(farthest, path->GetPoint(i)[1] - 200.0);
    CHECK(GetTilt(path, i) < 36.0);
  }
  CHECK(farthest > 10.0);
}

TEST_CASE("MulticopterPlatform: slows down for turns that are too tight", "[MulticopterPlatform]")
{
  vtkNew<vtkHeliosMulticopterPlatform> copter;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(copter);
  const std::vector<helios::Point> way = { { 0.0, 0.0, 30.0 }, { 0.0, 40.0, 30.0 },
    { 40.0, 40.0, 30.0 }, { 40.0, 0.0, 30.0 } };
  for (const Mode mode : { Smooth, Through })
  {
    log->Clear();
    copter->SlowdownEnabledOn();
    auto path = Run(copter, way, { 30.0, 30.0, 30.0, 30.0 }, mode);
    CHECK(helios::FindFlaw(path, 1e-3) == "");
    CHECK(GetSpeed(path, helios::FindLeg(path, 1)[0]) < 12.0);
    CHECK(GetSpeed(path, helios::FindLeg(path, 1)[0]) > 3.0);
    CHECK(log->Warnings.empty());
    copter->SlowdownEnabledOff();
    Run(copter, way, { 30.0, 30.0, 30.0, 30.0 }, mode);
    CHECK(
      log->HasWarning("SlowdownEnabled is off, but waypoint 1 and others are passed more slowly "
                      "than Speed, or stopped at, since the turn does not fit; lower Speed or"));
    log->Clear();
    Run(copter, way, { 2.0, 2.0, 2.0, 2.0 }, mode);
    CHECK(log->Warnings.empty());
  }
}

TEST_CASE("MulticopterPlatform: brakes within SlowdownDistance", "[MulticopterPlatform]")
{
  vtkNew<vtkHeliosMulticopterPlatform> copter;
  for (const double distance : { 0.0, 40.0 })
  {
    copter->SetSlowdownDistance(distance);
    auto path = Run(copter, { { 0.0, 0.0, 30.0 }, { 0.0, 200.0, 30.0 } }, { 10.0, 10.0 }, Stop);
    double cruiseEnd = 0.0;
    for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
    {
      cruiseEnd = GetSpeed(path, i) > 10.0 * (1.0 - 1e-12) ? path->GetPoint(i)[1] : cruiseEnd;
    }
    CHECK(200.0 - cruiseEnd ==
      Approx(distance > 0.0 ? 40.0 : 10.4).epsilon(distance > 0.0 ? 1e-9 : 0.1));
  }
}

TEST_CASE("MulticopterPlatform: half the time step gives the same result", "[MulticopterPlatform]")
{
  const std::vector<helios::Point> way = { { 0.0, 0.0, 30.0 }, { 0.0, 200.0, 30.0 },
    { 200.0, 200.0, 60.0 }, { 230.0, 220.0, 30.0 } };
  for (const Mode mode : { Stop, Smooth, Through })
  {
    vtkNew<vtkHeliosMulticopterPlatform> copter;
    copter->SetDragCoefficient(0.2);
    auto coarse = Run(copter, way, { 12.0, 10.0, 20.0, 10.0 }, mode);
    copter->SetTimeStep(0.005);
    auto fine = Run(copter, way, { 12.0, 10.0, 20.0, 10.0 }, mode);
    double worst = 0.0;
    // At 10 kHz and at 1 MHz: the same times and positions.
    for (int i = 0; i < 100000; ++i)
    {
      const double t = i * 1e-4;
      worst = std::max(
        worst, (helios::PositionAt(coarse, t) - helios::PositionAt(fine, 100.0 * i / 1e6)).Norm());
    }
    INFO("mode " << mode);
    CHECK(GetDuration(coarse) == Approx(GetDuration(fine)).epsilon(1e-9));
    CHECK(worst < 4e-7); // twice the tolerance of samples, and 1e-9 for the step
  }
}

TEST_CASE("MulticopterPlatform: vertical legs and legs without length", "[MulticopterPlatform]")
{
  vtkNew<vtkHeliosMulticopterPlatform> copter;
  const std::vector<helios::Point> way = { { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 50.0 },
    { 0.0, 0.0, 50.0 }, { 80.0, 0.0, 50.0 }, { 80.0, 0.0, 10.0 }, { 80.0, 0.0, 10.0 } };
  for (const Mode mode : { Stop, Smooth, Through })
  {
    INFO("mode " << mode);
    auto path = Run(copter, way, { 5.0, 5.0, 5.0, 5.0, 5.0, 5.0 }, mode);
    CHECK(helios::FindFlaw(path, 0.01) == "");
    for (int leg = 0; leg < 5; ++leg)
    {
      const auto ends = helios::FindLeg(path, leg);
      REQUIRE(ends[0] >= 0);
      CHECK(helios::GetMiss(path, ends[0], way[leg]) < 1e-9);
      CHECK(helios::GetMiss(path, ends[1], way[leg + 1]) < 1e-9);
      CHECK(GetHeading(path, ends[1]) == Approx(90.0));
    }
    const auto flat = helios::FindLeg(path, 1);
    CHECK(GetTime(path, flat[1]) == GetTime(path, flat[0]));
  }
}

TEST_CASE("MulticopterPlatform: an hour has few samples", "[MulticopterPlatform]")
{
  // 24 lines of 1 km, 50 m apart, at 8 m/s.
  std::vector<helios::Point> way;
  for (int line = 0; line < 24; ++line)
  {
    way.push_back({ line % 2 ? 1000.0 : 0.0, 50.0 * line, 100.0 });
    way.push_back({ line % 2 ? 0.0 : 1000.0, 50.0 * line, 100.0 });
  }
  for (const Mode mode : { Stop, Smooth, Through })
  {
    vtkNew<vtkHeliosMulticopterPlatform> copter;
    auto path = Run(copter, way, std::vector<double>(way.size(), 8.0), mode);
    INFO("mode " << mode << ": " << path->GetNumberOfPoints() << " samples");
    CHECK(GetDuration(path) > 3000.0);
    CHECK(path->GetNumberOfPoints() < 500000);
  }
}

TEST_CASE("MulticopterPlatform: bad input is an error", "[MulticopterPlatform]")
{
  vtkNew<vtkHeliosMulticopterPlatform> copter;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(copter);
  const helios::Point origin{ 0.0, 0.0, 0.0 };
  SECTION("one waypoint")
  {
    Run(copter, { origin }, { 1.0 }, Stop);
    CHECK(log->HasError("A flight needs two or more waypoints, the input has 1; add the end"));
  }
  SECTION("a negative speed")
  {
    Run(copter, { origin, { 1.0, 0.0, 0.0 } }, { -2.0, 1.0 }, Stop);
    CHECK(log->HasError("Speed of waypoint 0 is -2 m/s; it must be positive and finite."));
  }
  SECTION("too heavy")
  {
    copter->SetMaximumThrust(90.0);
    Run(copter, { origin, { 1.0, 0.0, 0.0 } }, { 1.0, 1.0 }, Stop);
    CHECK(log->HasError("Waypoint 1 cannot be reached: MaximumThrust is 90 N, 10 kg need more than "
                        "99.0472 N to fly; raise it or lower Mass."));
  }
  SECTION("too far")
  {
    Run(copter, { origin, { 0.0, 1e300, 0.0 } }, { 1.0, 1.0 }, Stop);
    CHECK(log->HasError("Waypoint 1 is 1e+300 m from waypoint 0, too far to fly; move it closer."));
  }
  SECTION("too slow")
  {
    copter->SetMaximumPitch(0.1);
    copter->SetDragCoefficient(10.0);
    Run(copter, { origin, { 0.0, 1e6, 0.0 } }, { 1000.0, 1.0 }, Stop);
    CHECK(log->HasError("Waypoint 1, 1e+06 m from waypoint 0, is reached only after 7.7"));
    CHECK(log->HasError(" s; raise MaximumThrust or MaximumPitch, or lower DragCoefficient."));
  }
  SECTION("drag only")
  {
    copter->SetDragCoefficient(11.0);
    Run(copter, { origin, { 0.0, 1.0, 0.0 } }, { 1.0, 1.0 }, Stop);
    CHECK(log->HasError("Waypoint 1 cannot be reached: DragCoefficient is 11 kg/m, too high for 10 "
                        "kg to fly; lower it to less than Mass per metre."));
  }
  SECTION("two numbers per waypoint")
  {
    auto waypoints = helios::MakeWaypoints({ origin, { 1.0, 0.0, 0.0 } }, { 1.0, 1.0 });
    vtkNew<vtkDoubleArray> array;
    array->SetName(names::SmoothTurn);
    array->SetNumberOfComponents(2);
    array->SetNumberOfTuples(2);
    array->Fill(0.0);
    waypoints->GetPointData()->AddArray(array);
    copter->SetInputData(waypoints);
    copter->Update();
    CHECK(log->HasError("The point array SmoothTurn of the waypoints must hold one number per"));
  }
  CHECK(copter->GetOutput()->GetNumberOfPoints() == 0);
}
