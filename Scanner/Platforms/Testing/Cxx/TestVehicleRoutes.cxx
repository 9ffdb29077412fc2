// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Any waypoints: the trajectory passes them, in bounded time.
#include "heliosErrorObserver.h"
#include "heliosWaypointTesting.h"
#include "vtkHeliosGroundVehiclePlatform.h"
#include "vtkHeliosMulticopterPlatform.h"

#include <catch2/catch.hpp>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <random>

namespace names = vtkHeliosArrayNames;
using helios::Mode;
using helios::Smooth;
using helios::Through;

namespace
{

vtkSmartPointer<vtkPolyData> Run(vtkHeliosMulticopterPlatform* copter,
  const std::vector<helios::Point>& positions, const std::vector<double>& speeds, Mode mode)
{
  copter->SetInputData(helios::MakeFlight(positions, speeds, mode));
  copter->Update();
  return copter->GetOutput();
}

} // namespace

TEST_CASE("VehicleRoutes: many waypoints", "[VehicleRoutes]")
{
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> pick(-30.0, 30.0);
  std::vector<helios::Point> way;
  for (int i = 0; i < 120; ++i)
  {
    way.push_back({ 10.0 * i + pick(random), pick(random), 0.5 * pick(random) });
  }
  for (const auto& [mode, drag] :
    { std::pair<Mode, double>{ Smooth, 0.01 }, { Through, 0.01 }, { Through, 3.0 } })
  {
    vtkNew<vtkHeliosMulticopterPlatform> copter;
    copter->SetDragCoefficient(drag);
    // At maximum speed with high drag.
    auto path = Run(copter, way, std::vector<double>(way.size(), drag > 1.0 ? 100.0 : 15.0), mode);
    CHECK(helios::FindFlaw(path, 0.05) == "");
    CHECK(helios::GetMiss(path, path->GetNumberOfPoints() - 1, way.back()) < 1e-9);
  }
}

TEST_CASE("VehicleRoutes: random waypoints are reached", "[VehicleRoutes]")
{
  std::mt19937_64 random(11);
  const auto pick = [&](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  vtkIdType samples = 0;
  double time = 0.0;
  for (int run = 0; run < 120; ++run)
  {
    vtkNew<vtkHeliosMulticopterPlatform> copter;
    copter->SetDragCoefficient(run % 5 == 0 ? 0.0 : std::pow(10.0, pick(-3.0, 0.5)));
    copter->SetMaximumPitch(pick(5.0, 60.0));
    copter->SetMaximumRoll(pick(5.0, 60.0));
    copter->SetYawRate(pick(5.0, 200.0));
    copter->SetSlowdownDistance(run % 4 == 0 ? pick(0.0, 50.0) : 0.0);
    const double scale = std::pow(10.0, pick(-1.0, 2.5));
    const bool lattice = run % 3 == 0;
    const auto step = [&]() { return lattice ? std::round(pick(-2.0, 2.0)) : pick(-1.0, 1.0); };
    std::vector<helios::Point> way;
    std::vector<double> speeds;
    const int count = 2 + static_cast<int>(pick(0.0, 8.0));
    for (int i = 0; i < count; ++i)
    {
      way.push_back({ 5e5 + scale * step(), 5e6 + scale * step(), scale * step() });
      speeds.push_back(std::pow(10.0, pick(-0.5, 1.5)));
    }
    auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
    log->Watch(copter);
    const Mode mode = static_cast<Mode>(run / 3 % 3);
    auto path = Run(copter, way, speeds, mode);
    INFO("run " << run << ", mode " << mode << ": " << log->Errors);
    CHECK(log->Errors.empty());
    REQUIRE(path->GetNumberOfPoints() > 0);
    CHECK(helios::FindFlaw(path, 0.05) == "");
    for (int leg = 0; leg + 1 < count; ++leg)
    {
      const auto ends = helios::FindLeg(path, leg);
      REQUIRE(ends[0] >= 0);
      // A smooth turn misses its waypoint by less than a leg length.
      const double allowed = mode == Smooth && leg + 2 < count
        ? std::sqrt(vtkMath::Distance2BetweenPoints(way[leg].data(), way[leg + 1].data()))
        : 0.0;
      CHECK(helios::GetMiss(path, ends[1], way[leg + 1]) <= allowed + 1e-7);
    }
    samples += path->GetNumberOfPoints();
    time += (helios::Value(path, names::GpsTime, path->GetNumberOfPoints() - 1) -
      helios::Value(path, names::GpsTime, 0));
  }
  INFO(samples << " samples for " << time << " s");
  CHECK(static_cast<double>(samples) < 100.0 * time);
}

TEST_CASE("VehicleRoutes: properties at the limits of their ranges", "[VehicleRoutes]")
{
  std::mt19937_64 random(19);
  const auto coin = [&]() { return random() % 3; };
  const auto choose = [&](double low, double usual, double high)
  {
    const auto side = coin();
    return side == 0 ? low : (side == 1 ? usual : high);
  };
  const std::vector<helios::Point> way = { { 0.0, 0.0, 0.0 }, { 0.0, 30.0, 0.5 },
    { 3.0, 30.0, 0.5 }, { 60.0, 0.0, 1.0 } };
  int done = 0;
  for (int run = 0; run < 40; ++run)
  {
    vtkNew<vtkHeliosMulticopterPlatform> copter;
    copter->SetMass(choose(0.01, 10.0, 1e5));
    copter->SetDragCoefficient(choose(0.0, 1e-3, 0.1) * copter->GetMass());
    copter->SetMaximumPitch(choose(0.1, 35.0, 80.0));
    copter->SetMaximumRoll(choose(0.1, 25.0, 80.0));
    copter->SetPitchRate(choose(1.0, 85.0, 1000.0));
    copter->SetRollRate(choose(1.0, 28.0, 1000.0));
    copter->SetYawRate(choose(0.1, 85.0, 1000.0));
    copter->SetSlowdownDistance(choose(0.0, 5.0, 1e6));
    vtkNew<vtkHeliosGroundVehiclePlatform> car;
    car->SetMass(choose(1.0, 1500.0, 1e6));
    car->SetEngineForce(choose(100.0, 6000.0, 1e7));
    car->SetBrakeForce(choose(100.0, 6000.0, 1e7));
    car->SetDrag(choose(0.0, 50.0, 1e6));
    car->SetWheelbase(choose(0.1, 2.5, 100.0));
    car->SetMaximumSteeringAngle(choose(1.0, 30.0, 80.0));
    car->SetSteeringRate(choose(1.0, 30.0, 1e4));
    car->SetLateralAcceleration(choose(0.01, 2.0, 100.0));
    car->SetTurnDeviation(choose(0.0, 1.0, 1e4));
    const std::vector<double> speeds(way.size(), choose(0.1, 5.0, 200.0));
    auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
    for (vtkHeliosPlatform* platform :
      { static_cast<vtkHeliosPlatform*>(copter), static_cast<vtkHeliosPlatform*>(car) })
    {
      log->Clear();
      log->Watch(platform);
      platform->SetInputData(helios::MakeFlight(way, speeds, static_cast<Mode>(coin())));
      platform->Update();
      vtkPolyData* path = platform->GetOutput();
      INFO("run " << run << ": " << log->Errors);
      const vtkIdType count = path->GetNumberOfPoints();
      CHECK((count > 0) != log->HasError("Waypoint "));
      if (count > 0)
      {
        CHECK(helios::GetMiss(path, count - 1, way.back()) < 1e-7);
        ++done;
      }
    }
  }
  CHECK(done > 20);
}
