// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Radial velocities and continuous motion, compared with closed forms.
#include "heliosVelocityEchoes.h"

#include <vtkMath.h>

#include <cmath>
#include <sstream>
#include <string>

using namespace helios::test;
using helios::Vec3;

namespace
{

constexpr double Speed = 20.0; // [m/s]

/// Makes the floor move.
void Move(const Files& files, const std::string& motion, const std::string& scene)
{
  files.Replace(
    "scene.xml", "</part>", "\n<dmotion loop=\"0\"><motion " + motion + "/></dmotion></part>");
  files.Replace("scene.xml", "<scene id=\"s\"", "<scene id=\"s\" " + scene);
}

} // namespace

TEST_CASE("SurveyVelocity: a wall that drives away at 20 m/s", "[SurveyVelocity]")
{
  Files files;
  const std::string steps = GENERATE("dynTimeStep=\"0.01\"",
    "dynTimeStep=\"0.01\" "
    "motion=\"continuous\"");
  const int subRays = GENERATE(0, 1, 7);
  Move(files, R"(type="translation" vec="0;0;-0.2")", steps);
  Echoes echoes(files, Tripod, OneLeg, subRays);
  echoes.CheckVelocities([](const Vec3&, double) { return Vec3(0.0, 0.0, -Speed); }, AtRest, 1e-9);
  const bool isContinuous = steps.find("continuous") != std::string::npos;
  for (vtkIdType i = 0; i < echoes.Count(); ++i)
  {
    const double time = echoes.Get(names::GpsTime, i);
    const double height = -Speed * (isContinuous ? time : std::floor(time / 0.01 + 1e-9) * 0.01);
    REQUIRE((subRays != 1 || std::abs(echoes.GetPoint(i)[2] - height) < 1e-6));
    REQUIRE(std::abs(echoes.Get(names::PartPosition, i, 2) - height) < 1e-9);
    REQUIRE(echoes.Get(names::PartOrientation, i, 0) == 1.0);
    REQUIRE(echoes.Get(names::RadialVelocity, i) > 0.0);
  }
}

TEST_CASE("SurveyVelocity: a disc that rotates", "[SurveyVelocity]")
{
  Files files;
  Move(files, R"(type="rotation" axis="0;0;1" angle="5")",
    "dynTimeStep=\"0.01\" motion=\"continuous\"");
  const double omega = vtkMath::RadiansFromDegrees(500.0);
  Echoes echoes(files, Tripod, OneLeg, 0);
  echoes.CheckVelocities([omega](const Vec3& p, double)
    { return Vec3(-omega * p[1], omega * p[0], 0.0); },
    AtRest, 1e-9);
  for (vtkIdType i = 0; i < echoes.Count(); i += 97)
  {
    const double half = 0.5 * omega * echoes.Get(names::GpsTime, i);
    REQUIRE(std::abs(std::abs(echoes.Get(names::PartOrientation, i, 3)) -
              std::abs(std::sin(half))) < 1e-9);
  }
}

TEST_CASE("SurveyVelocity: a scanner on a car on a curve", "[SurveyVelocity]")
{
  Files files;
  constexpr double radius = 20.0;
  constexpr double omega = 0.5;
  std::ostringstream track;
  track.precision(12);
  for (int i = 0; i <= 2000; ++i)
  {
    const double time = 0.001 * i;
    const double angle = omega * time;
    track << time << ",0,0," << -vtkMath::DegreesFromRadians(angle) << ","
          << radius * std::cos(angle) << "," << radius * std::sin(angle) << ",3\n";
  }
  files.Write("track.csv", track.str());
  files.Replace("assets.xml", "<platform id=\"plane\" type=\"linearpath\">",
    "<platform id=\"car\" type=\"static\"><scannerMount x=\"0.5\" y=\"2\" z=\"1\"/></platform>"
    "<platform id=\"plane\" type=\"linearpath\">");
  Echoes echoes(files,
    R"(platform="interpolated" basePlatform="assets.xml#car" scanner="assets.xml#tls")",
    R"(<leg><platformSettings trajectory="track.csv" tStart="0" tEnd="1"/>
<scannerSettings scanFreq_hz="50"/></leg>)",
    0);
  // All that turns with the car has a velocity about the centre; between samples, along a chord.
  echoes.CheckVelocities(
    AtRest, [](const Vec3& o, double) { return Vec3(-omega * o[1], omega * o[0], 0.0); }, 5e-3);
}

TEST_CASE("SurveyVelocity: continuous motion equals steps of 1 us", "[SurveyVelocity]")
{
  struct Row
  {
    const char* Slow;
    const char* Fast;
  };
  const Row row = GENERATE(Row{ R"(type="translation" vec="0.1;0.2;-0.2")",
                             R"(type="translation" vec="1e-5;2e-5;-2e-5")" },
    Row{ R"(type="rotation" axis="0.1;0.2;1" angle="3" center="1;2;0")",
      R"(type="rotation" axis="0.1;0.2;1" angle="3e-4" center="1;2;0")" },
    Row{ R"(type="helical" axis="0;0.1;1" angle="3" glide="-0.1")",
      R"(type="helical" axis="0;0.1;1" angle="3e-4" glide="-1e-5")" });
  Files slow;
  Files fast;
  Move(slow, row.Slow, "dynTimeStep=\"0.01\" motion=\"continuous\"");
  Move(fast, row.Fast, "dynTimeStep=\"0.000001\"");
  Echoes a(slow, Tripod, OneLeg, 1);
  Echoes b(fast, Tripod, OneLeg, 1);
  REQUIRE(a.Count() > 10000);
  REQUIRE(a.Count() == b.Count());
  for (vtkIdType i = 0; i < a.Count(); ++i)
  {
    REQUIRE((a.GetPoint(i) - b.GetPoint(i)).Norm() < 1e-6);
  }
}

TEST_CASE(
  "SurveyVelocity: a part follows a trajectory, another one is mounted on it", "[SurveyVelocity]")
{
  Files files;
  std::ostringstream track;
  track.precision(12); // down at 20 m/s, and a turn of 0.5 rad/s
  for (int i = 0; i <= 20; ++i)
  {
    track << 5.0 + 0.1 * i << ",0,0," << -vtkMath::DegreesFromRadians(0.05 * i) << ",0,0,"
          << -2.0 * i << "\n";
  }
  files.Write("down.csv", track.str());
  const bool isMounted = GENERATE(false, true);
  files.Replace("scene.xml", "</part>",
    isMounted ? "</part><part id=\"lift\"><filter type=\"objloader\"><param type=\"string\" "
                "key=\"filepath\" value=\"far.obj\"/></filter>"
                "<trajectory file=\"down.csv\"/></part>"
              : "<trajectory file=\"down.csv\"/></part>");
  files.Write("far.obj", "v 900 900 0\nv 901 900 0\nv 900 901 0\nf 1 2 3\n");
  files.Replace("scene.xml", "<part id=\"floor\"",
    isMounted ? "<part id=\"floor\" mount=\"lift\"" : "<part id=\"floor\"");
  Echoes echoes(files, Tripod, OneLeg, 1);
  echoes.CheckVelocities(
    [](const Vec3& p, double) { return Vec3(-0.5 * p[1], 0.5 * p[0], -Speed); }, AtRest, 1e-9);
  for (vtkIdType i = 0; i < echoes.Count(); ++i)
  {
    REQUIRE(std::abs(echoes.GetPoint(i)[2] + Speed * echoes.Get(names::GpsTime, i)) < 1e-6);
  }
}
