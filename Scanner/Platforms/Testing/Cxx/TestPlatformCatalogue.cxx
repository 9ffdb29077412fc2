// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The mounts of Data/Assets/platforms.xml, against the expected beam directions.
#include "heliosWaypointTesting.h"
#include "vtkHeliosLinearPathPlatform.h"

#include <catch2/catch.hpp>
#include <vtkNew.h>
#include <vtkQuaternion.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace
{

const double Pi = std::acos(-1.0);

/// The text of a <platform> in the catalogue; comments precede the elements.
std::string ReadPlatform(const std::string& id)
{
  const auto root = std::filesystem::path(__FILE__).parent_path() / "../../../..";
  std::ifstream file(root / "Data/Assets/platforms.xml");
  const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::size_t begin = text.find("<platform id=\"" + id + "\"");
  const std::size_t end = text.find("</platform>", begin);
  return begin < end ? text.substr(begin, end - begin) : std::string();
}

/// The rotation of its scannerMount: the <rot> elements in order about fixed axes.
vtkQuaterniond ReadMount(const std::string& platform)
{
  vtkQuaterniond mount;
  const std::string rot = "<rot axis=\"";
  const std::string angle = "angle_deg=\"";
  std::size_t at = platform.find(rot);
  for (; at != std::string::npos; at = platform.find(rot, at + 1))
  {
    const char axis = platform[at + rot.size()];
    const double degrees = std::stod(platform.substr(platform.find(angle, at) + angle.size()));
    double q[4] = { std::cos(degrees * Pi / 360.0), 0.0, 0.0, 0.0 };
    q[1 + axis - 'x'] = std::sin(degrees * Pi / 360.0);
    mount = vtkQuaterniond(q) * mount;
  }
  return mount;
}

/// A direction of the scanner in the world, on a platform of the catalogue moving along (x, y).
helios::Point ToWorld(const std::string& id, double x, double y, const helios::Point& beam)
{
  const std::string text = ReadPlatform(id);
  REQUIRE(text.find("type=\"linearpath\"") != std::string::npos);
  REQUIRE(text.find("rotations=\"local\"") == std::string::npos);
  vtkNew<vtkHeliosLinearPathPlatform> platform;
  platform->SetInputData(helios::MakeWaypoints({ { 0.0, 0.0, 0.0 }, { x, y, 0.0 } }, { 1.0, 1.0 }));
  platform->Update();
  double m[3][3];
  ReadMount(text).ToMatrix3x3(m);
  helios::Point body;
  vtkMath::Multiply3x3(m, beam.data(), body.data());
  return helios::BodyToWorld(platform->GetOutput(), 0, body);
}

/// The beam of a rotating mirror [deg].
helios::Point Beam(double beta)
{
  return { 0.0, std::cos(beta * Pi / 180.0), std::sin(beta * Pi / 180.0) };
}

void CheckPoint(const helios::Point& p, double x, double y, double z)
{
  CHECK(p[0] == Approx(x).margin(1e-15));
  CHECK(p[1] == Approx(y).margin(1e-15));
  CHECK(p[2] == Approx(z).margin(1e-15));
}

} // namespace

TEST_CASE("Catalogue: on airborne platforms beta = 0 is nadir", "[PlatformCatalogue]")
{
  for (const char* id : { "airplane_linearpath", "copter_linearpath" })
  {
    CheckPoint(ToWorld(id, 3.0, 4.0, Beam(0.0)), 0.0, 0.0, -1.0);
  }
}

TEST_CASE("Catalogue: airborne scan lines run across the flight, positive angles to the right",
  "[PlatformCatalogue]")
{
  for (const char* id : { "airplane_linearpath", "copter_linearpath" })
  {
    for (const double beta : { -30.0, 5.0, 60.0 })
    {
      const double s = std::sin(beta * Pi / 180.0);
      const double c = std::cos(beta * Pi / 180.0);
      INFO(id << " at " << beta);
      CheckPoint(ToWorld(id, 0.0, 100.0, Beam(beta)), s, 0.0, -c);          // north: right is east
      CheckPoint(ToWorld(id, 100.0, 0.0, Beam(beta)), 0.0, -s, -c);         // east: right is south
      CheckPoint(ToWorld(id, 3.0, 4.0, Beam(beta)), 0.8 * s, -0.6 * s, -c); // obliquely
    }
  }
}

TEST_CASE("Catalogue: the cone of an airborne scanner is centred on nadir", "[PlatformCatalogue]")
{
  for (int azimuth = 0; azimuth < 360; azimuth += 30)
  {
    const double phi = azimuth * Pi / 180.0;
    const double a = 20.0 * Pi / 180.0;
    const helios::Point beam = { std::sin(a) * std::sin(phi), std::cos(a),
      std::sin(a) * std::cos(phi) };
    CHECK(
      ToWorld("airplane_linearpath", 7.0, -2.0, beam)[2] == Approx(-std::cos(a)).epsilon(1e-15));
  }
}

TEST_CASE(
  "Catalogue: the scan plane of the car is inclined backwards by 45 degrees", "[PlatformCatalogue]")
{
  const double s = std::sqrt(0.5);
  const char* id = "car_linearpath";
  CheckPoint(ToWorld(id, 0.0, 1.0, Beam(0.0)), 0.0, -s, -s);    // the road behind
  CheckPoint(ToWorld(id, 0.0, 1.0, Beam(90.0)), 1.0, 0.0, 0.0); // the right-hand side
  CheckPoint(ToWorld(id, 0.0, 1.0, Beam(-90.0)), -1.0, 0.0, 0.0);
  CheckPoint(ToWorld(id, 0.0, 1.0, Beam(180.0)), 0.0, s, s); // the sky ahead
}

TEST_CASE("Catalogue: platforms with physics mount the scanner as the linear ones do",
  "[PlatformCatalogue]")
{
  struct Pair
  {
    const char* Straight;
    const char* Physical;
    const char* Type;
  };
  for (const Pair& pair : { Pair{ "copter_linearpath", "copter", "multicopter" },
         Pair{ "car_linearpath", "car", "groundvehicle" } })
  {
    INFO(pair.Physical);
    const std::string text = ReadPlatform(pair.Physical);
    const std::string straight = ReadPlatform(pair.Straight);
    CHECK(text.find(std::string("type=\"") + pair.Type + "\"") != std::string::npos);
    CHECK(
      text.substr(text.find("<scannerMount")) == straight.substr(straight.find("<scannerMount")));
  }
}

TEST_CASE("Catalogue: the tripod is vertical, 1.5 m high", "[PlatformCatalogue]")
{
  const std::string tripod = ReadPlatform("tripod");
  CHECK(tripod.find("type=\"static\"") != std::string::npos);
  CHECK(tripod.find("z=\"1.5\"") != std::string::npos);
  CHECK(tripod.find("<rot") == std::string::npos);
}
