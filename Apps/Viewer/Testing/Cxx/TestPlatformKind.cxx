// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Kinds of platforms by their names and how they move, and their models.
#include "heliosPlatformKind.h"

#include "heliosGroundHeight.h"
#include "heliosPlatformModel.h"
#include "heliosSimulation.h"
#include "heliosSurveyData.h"

#include <catch2/catch.hpp>

#include <vtkPolyData.h>

#include <cmath>

using namespace helios;
using namespace helios::viewer;

namespace
{

PlatformKind FindKind(PlatformType type, const std::string& id, const std::string& name = "")
{
  PlatformData platform;
  platform.Type = type;
  platform.Id = id;
  platform.Name = name;
  return FindPlatformKind(platform);
}

} // namespace

TEST_CASE("PlatformKind: names tell the kind, else the type does")
{
  const PlatformType plays = PlatformType::Interpolated, lines = PlatformType::LinearPath;
  CHECK(FindKind(plays, "car_linearpath") == PlatformKind::Car);
  CHECK(FindKind(lines, "", "Multicopter, straight lines") == PlatformKind::Multicopter);
  CHECK(FindKind(lines, "airplane_linearpath") == PlatformKind::Aircraft);
  CHECK(FindKind(lines, "sr22") == PlatformKind::Aircraft);
  CHECK(FindKind(PlatformType::GroundVehicle, "tractor") == PlatformKind::Tractor);
  CHECK(FindKind(plays, "", "A person with a backpack") == PlatformKind::Person);
  CHECK(FindKind(PlatformType::Static, "car") == PlatformKind::Tripod);
  CHECK(FindKind(PlatformType::GroundVehicle, "x1") == PlatformKind::Car);
  CHECK(FindKind(PlatformType::Multicopter, "x1") == PlatformKind::Multicopter);
  CHECK(FindKind(plays, "scarab") == PlatformKind::Unknown); // no car
  CHECK(FindKind(lines, "x1", "interpolated") == PlatformKind::Unknown);
}

TEST_CASE("PlatformKind: height and speed tell what the names do not")
{
  CHECK(GuessPlatformKind(1.8, 1.2) == PlatformKind::Person);
  CHECK(GuessPlatformKind(2.2, 12.0) == PlatformKind::Car);
  CHECK(GuessPlatformKind(60.0, 6.0) == PlatformKind::Multicopter);
  CHECK(GuessPlatformKind(700.0, 60.0) == PlatformKind::Aircraft);
  CHECK(GuessPlatformKind(std::nan(""), 60.0) == PlatformKind::Aircraft);
}

TEST_CASE("PlatformKind: the wheels of a car are below the trajectory of its scanner")
{
  const std::vector<Vec3> ground = { { 0, 0, 100 }, { 10, 0, 100 }, { 20, 0, 100.2 },
    { 10, 5, 108 } };
  CHECK(FindGround(ground, { 10, 1, 102 }) == 100.0);
  CHECK(std::isnan(FindGround({}, { 10, 1, 102 })));
  SimulatedLeg leg;
  leg.IsMoving = true;
  leg.EndTime = 2.0;
  leg.Positions = { { 0, 0, 102.2 }, { 10, 0, 102.2 }, { 20, 0, 102.2 } };
  std::vector<SimulatedLeg> legs(3, leg);
  legs[1].Kind = PlatformKind::Aircraft;
  for (Vec3& position : legs[2].Positions)
  {
    position[2] = 100.1; // its wheels are on the road
  }
  FindPlatforms(legs, ground);
  CHECK(legs[0].Kind == PlatformKind::Car);
  CHECK(legs[0].Height == Approx(2.2));
  CHECK(legs[1].Kind == PlatformKind::Aircraft);
  CHECK(legs[1].Height == 0.0);
  CHECK(legs[2].Kind == PlatformKind::Car);
  CHECK(legs[2].Height == 0.0);
}

TEST_CASE("PlatformKind: each kind has a model of its size, on the ground from z = 0")
{
  const std::pair<PlatformKind, double> sizes[] = { { PlatformKind::Tripod, 1.45 },
    { PlatformKind::Person, 2.0 }, { PlatformKind::Car, 4.4 }, { PlatformKind::Tractor, 4.0 },
    { PlatformKind::Multicopter, 1.5 }, { PlatformKind::Aircraft, 11.0 },
    { PlatformKind::Unknown, 1.0 } };
  for (const auto& size : sizes)
  {
    CAPTURE(static_cast<int>(size.first));
    double b[6];
    MakePlatformModel(size.first)->GetBounds(b);
    const double longest = std::max({ b[1] - b[0], b[3] - b[2], b[5] - b[4] });
    CHECK(longest == Approx(size.second).epsilon(0.15));
    CHECK((!IsOnGround(size.first) || std::abs(b[4]) < 0.06));
  }
}
