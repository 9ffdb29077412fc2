// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosWaypointTesting.h"
#include "vtkHeliosGroundVehiclePlatform.h"

#include <catch2/catch.hpp>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <random>

namespace names = vtkHeliosArrayNames;

namespace
{

const double Pi = std::acos(-1.0);

vtkSmartPointer<vtkPolyData> Run(vtkHeliosGroundVehiclePlatform* car,
  const std::vector<helios::Point>& positions, const std::vector<double>& speeds)
{
  car->SetInputData(helios::MakeWaypoints(positions, speeds));
  car->Update();
  return car->GetOutput();
}

double GetDuration(vtkPolyData* path)
{
  return helios::Value(path, names::GpsTime, path->GetNumberOfPoints() - 1) -
    helios::Value(path, names::GpsTime, 0);
}

double GetSpeed(vtkPolyData* path, vtkIdType sample)
{
  return std::hypot(helios::Value(path, names::Velocity, sample, 0),
    helios::Value(path, names::Velocity, sample, 1),
    helios::Value(path, names::Velocity, sample, 2));
}

/// Along the body's forward axis, negative in reverse.
double GetForwardSpeed(vtkPolyData* path, vtkIdType sample)
{
  const helios::Point forward = helios::ForwardAt(path, sample);
  double v[3];
  path->GetPointData()->GetArray(names::Velocity)->GetTuple(sample, v);
  return vtkMath::Dot(v, forward.data());
}

double GetCourse(vtkPolyData* path, vtkIdType sample)
{
  const helios::Point forward = helios::ForwardAt(path, sample);
  return std::atan2(forward[1], forward[0]);
}

} // namespace

TEST_CASE("GroundVehiclePlatform: full force against linear drag", "[GroundVehiclePlatform]")
{
  // m = 1500 kg, F = 3000 N, k = 150 kg/s; terminal speed 20 m/s.
  vtkNew<vtkHeliosGroundVehiclePlatform> car;
  car->SetEngineForce(3000.0);
  car->SetDrag(150.0);
  auto path = Run(car, { { 0.0, 0.0, 0.0 }, { 0.0, 1500.0, 0.0 } }, { 30.0, 0.0 });
  CHECK(helios::PositionAt(path, 10.0)[1] == Approx(73.575888234288).epsilon(2e-9));
  CHECK(helios::PositionAt(path, 60.0)[1] == Approx(1000.495750435333).epsilon(1e-9));
  const vtkIdType last = path->GetNumberOfPoints() - 1;
  CHECK(helios::GetMiss(path, last, { 0.0, 1500.0, 0.0 }) < 1e-9);
  CHECK(GetSpeed(path, last) ==
    Approx(20.0 * (1.0 - std::exp(-0.1 * GetDuration(path)))).epsilon(1e-12));
  CHECK(last < 400);
}

TEST_CASE("GroundVehiclePlatform: Speed is reached and kept", "[GroundVehiclePlatform]")
{
  vtkNew<vtkHeliosGroundVehiclePlatform> car;
  car->SetStartTime(50.0);
  auto path = Run(car, { { 0.0, 0.0, 3.0 }, { 1000.0, 0.0, 3.0 } }, { 10.0, 0.0 });
  CHECK(helios::Value(path, names::GpsTime, 0) == 50.0);
  CHECK(GetSpeed(path, 0) == 0.0);
  CHECK(GetSpeed(path, path->GetNumberOfPoints() - 1) == Approx(10.0).epsilon(1e-13));
  // 4 m/s^2 against little drag: 2.6 s and 13 m for 10 m/s, then 10 m/s.
  CHECK(GetDuration(path) == Approx(100.0 + 0.5 * 2.6).margin(0.05));
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    CHECK(helios::ForwardAt(path, i)[0] == Approx(1.0).epsilon(1e-14));
    CHECK(GetSpeed(path, i) <= 10.0 * (1.0 + 1e-12));
  }
}

TEST_CASE("GroundVehiclePlatform: the tightest turn is the circle of the bicycle model",
  "[GroundVehiclePlatform]")
{
  // A waypoint beside the car: with instant steering it follows the circle of radius Wheelbase
  // / tan(angle): 4.330127018922 m for 2.5 m, 30 degrees.
  vtkNew<vtkHeliosGroundVehiclePlatform> car;
  car->SetSteeringRate(1e4);
  const double radius = 4.330127018922;
  auto path = Run(car, { { 0.0, -10.0, 0.0 }, { 0.0, 0.0, 0.0 }, { 2.0 * radius, -5.0, 0.0 } },
    { 5.0, 5.0, 0.0 });
  const auto leg = helios::FindLeg(path, 1);
  int onCircle = 0;
  for (vtkIdType i = leg[0]; i <= leg[1]; ++i)
  {
    double p[3];
    path->GetPoint(i, p);
    onCircle += std::abs(std::hypot(p[0] - radius, p[1]) - radius) < 0.02 && p[1] > 0.0 ? 1 : 0;
  }
  CHECK(onCircle > 20);
  CHECK(helios::GetMiss(path, leg[1], { 2.0 * radius, -5.0, 0.0 }) < 1e-9);
  // Half way round it is opposite, and the turn's speed follows from the lateral acceleration.
  double top = 0.0;
  for (vtkIdType i = leg[0]; i <= leg[1]; ++i)
  {
    top = std::max(top, path->GetPoint(i)[1]);
  }
  CHECK(top == Approx(radius).margin(0.02));
  CHECK(GetSpeed(path, leg[0]) == Approx(std::sqrt(2.0 * radius)).epsilon(1e-9));
}

TEST_CASE(
  "GroundVehiclePlatform: the wheels turn no faster than SteeringRate", "[GroundVehiclePlatform]")
{
  vtkNew<vtkHeliosGroundVehiclePlatform> car;
  car->SetSteeringRate(20.0);
  auto path =
    Run(car, { { 0.0, 0.0, 0.0 }, { 0.0, 60.0, 0.0 }, { 40.0, 60.0, 0.0 }, { 40.0, 64.0, 0.0 } },
      { 8.0, 8.0, 8.0, 0.0 });
  REQUIRE(helios::FindFlaw(path, 1e-3).empty());
  double before = 0.0;
  double timeBefore = -1.0;
  double steepest = 0.0;
  double largest = 0.0;
  for (vtkIdType i = 1; i + 1 < path->GetNumberOfPoints(); ++i)
  {
    const double t0 = helios::Value(path, names::GpsTime, i);
    const double dt = helios::Value(path, names::GpsTime, i + 1) - t0;
    const double v = 0.5 * (GetForwardSpeed(path, i) + GetForwardSpeed(path, i + 1));
    if (dt < 1e-4 || std::abs(v) < 0.05)
    {
      continue;
    }
    const double turn = std::remainder(GetCourse(path, i + 1) - GetCourse(path, i), 2.0 * Pi);
    const double angle = std::atan(car->GetWheelbase() * turn / (dt * v)) * 180.0 / Pi;
    const double time = t0 + 0.5 * dt;
    if (time - timeBefore < 0.1)
    {
      steepest = std::max(steepest, std::abs(angle - before) / (time - timeBefore));
    }
    largest = std::max(largest, std::abs(angle));
    before = angle;
    timeBefore = time;
  }
  CHECK(largest == Approx(30.0).epsilon(0.01));
  CHECK(steepest < 20.0 * 1.1);
  CHECK(steepest > 15.0);
}

TEST_CASE("GroundVehiclePlatform: no lateral slip", "[GroundVehiclePlatform]")
{
  vtkNew<vtkHeliosGroundVehiclePlatform> car;
  auto path =
    Run(car, { { 0.0, 0.0, 0.0 }, { 0.0, 20.0, 0.0 }, { 1.0, 20.0, 0.0 }, { -30.0, 5.0, 0.0 } },
      { 8.0, 8.0, 8.0, 0.0 });
  bool backs = false;
  for (vtkIdType i = 0; i < path->GetNumberOfPoints(); ++i)
  {
    const double along = GetForwardSpeed(path, i);
    CHECK(std::abs(along) == Approx(GetSpeed(path, i)).margin(1e-9));
    backs = backs || along < -0.1;
  }
  CHECK(backs); // 1 m to the side needs a three-point turn
  CHECK(helios::FindFlaw(path, 1e-3).empty());
  CHECK(helios::GetMiss(path, helios::FindLeg(path, 1)[1], { 1.0, 20.0, 0.0 }) < 1e-9);
}

TEST_CASE("GroundVehiclePlatform: it climbs, pitched to the slope", "[GroundVehiclePlatform]")
{
  vtkNew<vtkHeliosGroundVehiclePlatform> car;
  auto path =
    Run(car, { { 0.0, 0.0, 0.0 }, { 0.0, 100.0, 10.0 }, { 0.0, 200.0, 0.0 } }, { 10.0, 10.0, 0.0 });
  const double slope = std::atan(0.1);
  for (const int leg : { 0, 1 })
  {
    const auto ends = helios::FindLeg(path, leg);
    for (vtkIdType i = ends[0]; i <= ends[1]; ++i)
    {
      const double* p = path->GetPoint(i);
      CHECK(p[2] == Approx(leg == 0 ? 0.1 * p[1] : 10.0 - 0.1 * (p[1] - 100.0)).margin(1e-9));
      const double pitch = std::asin(helios::ForwardAt(path, i)[2]);
      const double left = 100.0 - p[1];
      if (left >= 2.5 || left < 0.0)
      {
        CHECK(pitch == Approx(left > 0.0 ? slope : -slope).epsilon(1e-12));
      }
      else // over one wheelbase
      {
        CHECK(pitch == Approx(std::atan(0.1 * (2.0 * left / 2.5 - 1.0))).margin(1e-12));
      }
    }
    CHECK(GetSpeed(path, ends[1]) == Approx(10.0).epsilon(1e-12));
  }
}

TEST_CASE("GroundVehiclePlatform: independent of the pulse frequency", "[GroundVehiclePlatform]")
{
  vtkNew<vtkHeliosGroundVehiclePlatform> car;
  auto path = Run(car,
    { { 0.0, 0.0, 0.0 }, { 30.0, 40.0, 2.0 }, { 100.0, 40.0, 5.0 }, { 90.0, 40.0, 5.0 },
      { 60.0, 80.0, 5.0 } },
    { 12.0, 9.0, 3.0, 8.0, 0.0 });
  CHECK(path->GetNumberOfPoints() < 20000);
  for (int i = 0; i < 200000; i += 100) // 10 kHz and 1 MHz
  {
    const auto a = helios::PositionAt(path, i / 1e4);
    const auto b = helios::PositionAt(path, 100.0 * i / 1e6);
    REQUIRE((a - b).Norm() < 1e-12);
  }
}

TEST_CASE("GroundVehiclePlatform: legs without length take no time", "[GroundVehiclePlatform]")
{
  vtkNew<vtkHeliosGroundVehiclePlatform> car;
  auto path =
    Run(car, { { 1.0, 2.0, 0.0 }, { 1.0, 2.0, 0.0 }, { 9.0, 2.0, 0.0 }, { 9.0, 2.0, 0.0 } },
      { 5.0, 5.0, 5.0, 5.0 });
  CHECK(helios::FindFlaw(path, 1e-3).empty());
  CHECK(helios::FindLeg(path, 0) == std::array<vtkIdType, 2>{ 0, 1 });
  CHECK(helios::Value(path, names::GpsTime, 1) == 0.0);
  CHECK(helios::ForwardAt(path, 0)[0] == Approx(1.0));
  const auto last = helios::FindLeg(path, 2);
  CHECK(last[1] == last[0] + 1);
  CHECK(helios::GetMiss(path, last[1], { 9.0, 2.0, 0.0 }) < 1e-9);
}

TEST_CASE("GroundVehiclePlatform: bad input is an error", "[GroundVehiclePlatform]")
{
  vtkNew<vtkHeliosGroundVehiclePlatform> car;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(car);
  const helios::Point origin{ 0.0, 0.0, 0.0 };
  SECTION("one waypoint")
  {
    Run(car, { origin }, { 1.0 });
    CHECK(log->HasError("A vehicle's path needs two or more waypoints, the input has 1; add"));
  }
  SECTION("a speed of 0")
  {
    Run(car, { origin, { 1.0, 0.0, 0.0 } }, { 0.0, 1.0 });
    CHECK(log->HasError("Speed of waypoint 0 is 0 m/s; it must be positive and finite."));
  }
  SECTION("straight up")
  {
    Run(car, { origin, { 0.0, 5.0, 0.0 }, { 0.0, 5.0, 3.0 } }, { 1.0, 1.0, 1.0 });
    CHECK(log->HasError("Waypoint 2 is 3 m straight above waypoint 1, where no vehicle can drive; "
                        "move it aside, or fly."));
  }
  SECTION("nowhere to go")
  {
    Run(car, { origin, origin }, { 1.0, 1.0 });
    CHECK(log->HasError("All waypoints are at one place; move one, or use a static platform"));
  }
  SECTION("a waypoint too far away")
  {
    Run(car, { origin, { 1e200, 0.0, 0.0 } }, { 1.0, 1.0 });
    CHECK(
      log->HasError("Waypoint 1 is 1e+200 m from waypoint 0, too far to drive; move it closer."));
  }
  SECTION("too steep for the engine")
  {
    Run(car, { origin, { 100.0, 0.0, 0.0 }, { 200.0, 0.0, 100.0 } }, { 10.0, 10.0, 1.0 });
    CHECK(log->HasError("Waypoint 2 cannot be reached: the slope of 45 degrees needs more than "
                        "10401.5 N, EngineForce is 6000 N; raise it, lower Mass or the waypoint."));
  }
  SECTION("too steep for the brakes")
  {
    Run(car, { origin, { 100.0, 0.0, -100.0 } }, { 10.0, 10.0 });
    CHECK(log->HasError("Waypoint 1 cannot be reached safely: the slope of -45 degrees needs more "
                        "than 10401.5 N to brake, BrakeForce is 6000 N; raise it, lower Mass"));
  }
  SECTION("no engine")
  {
    car->SetEngineForce(0.0);
    Run(car, { origin, { 100.0, 0.0, 0.0 } }, { 10.0, 10.0 });
    CHECK(log->HasError("Waypoint 1 cannot be reached: the slope of 0 degrees needs more than 0 N, "
                        "EngineForce is 0 N; raise it"));
  }
  SECTION("a weak engine")
  {
    car->SetEngineForce(1.0);
    car->SetDrag(1e5);
    Run(car, { origin, { 100.0, 0.0, 0.0 } }, { 10.0, 10.0 });
    CHECK(log->HasError("Waypoint 1, 100 m from waypoint 0, is reached only after 1e+07 s; raise "
                        "EngineForce, or lower Drag or Mass."));
  }
  CHECK(car->GetOutput()->GetNumberOfPoints() == 0);
}

TEST_CASE("GroundVehiclePlatform: random waypoints are passed", "[GroundVehiclePlatform]")
{
  std::mt19937_64 random(7);
  const auto pick = [&](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  vtkIdType samples = 0;
  double time = 0.0;
  for (int run = 0; run < 200; ++run)
  {
    vtkNew<vtkHeliosGroundVehiclePlatform> car;
    car->SetWheelbase(pick(0.5, 6.0));
    car->SetMaximumSteeringAngle(pick(10.0, 60.0));
    car->SetSteeringRate(std::pow(10.0, pick(1.0, 3.0)));
    car->SetDrag(run % 5 == 0 ? 0.0 : std::pow(10.0, pick(0.0, 3.0)));
    const double scale = std::pow(10.0, pick(-1.0, 2.5));
    std::vector<helios::Point> way;
    std::vector<double> speeds;
    const int count = 2 + static_cast<int>(pick(0.0, 8.0));
    for (int i = 0; i < count; ++i)
    {
      const double step = run % 3 == 0 ? std::round(pick(-2.0, 2.0)) : pick(-1.0, 1.0);
      way.push_back({ 5e5 + scale * step,
        5e6 + scale * (run % 3 == 0 ? std::round(pick(-2.0, 2.0)) : pick(-1.0, 1.0)),
        0.02 * scale * pick(-0.5, 0.5) });
      speeds.push_back(std::pow(10.0, pick(-1.0, 1.5)));
    }
    auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
    log->Watch(car);
    auto path = Run(car, way, speeds);
    INFO("run " << run << ": " << log->Errors);
    if (path->GetNumberOfPoints() == 0)
    {
      CHECK((log->HasError("Waypoint ") || log->HasError("All waypoints")));
      continue;
    }
    CHECK(helios::FindFlaw(path, 0.01) == "");
    for (int leg = 0; leg + 1 < count; ++leg)
    {
      const auto ends = helios::FindLeg(path, leg);
      REQUIRE(ends[0] >= 0);
      CHECK(helios::GetMiss(path, ends[0], way[leg]) < 1e-7);
      CHECK(helios::GetMiss(path, ends[1], way[leg + 1]) < 1e-7);
    }
    samples += path->GetNumberOfPoints();
    time += GetDuration(path);
  }
  INFO(samples << " samples for " << time << " s");
  CHECK(static_cast<double>(samples) < 30.0 * time);
}
