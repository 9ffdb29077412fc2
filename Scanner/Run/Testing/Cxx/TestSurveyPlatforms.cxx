// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs of surveys with ground vehicles, multicopters, trajectory files and platform noise.
#include "heliosMakePlatform.h"
#include "heliosSurveyPlaying.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPlatformNoise.h"
#include "vtkHeliosPointXMLReader.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

using namespace helios::test;

namespace
{

/// A line of a trajectory file.
struct Sample
{
  double X, Y, Z, Time, Roll, Pitch, Yaw;
};

std::vector<Sample> ReadSamples(const std::string& path)
{
  std::vector<Sample> samples;
  std::ifstream file(path);
  Sample s;
  while (file >> s.X >> s.Y >> s.Z >> s.Time >> s.Roll >> s.Pitch >> s.Yaw)
  {
    samples.push_back(s);
  }
  return samples;
}

/// A leg of a conic scanner facing down, with a sample every 0.1 s.
std::string Leg(const std::string& place)
{
  return "<leg><platformSettings " + place +
    "/>\n<scannerSettings pulseFreq_hz=\"20000\" scanFreq_hz=\"50\" scanAngle_deg=\"5\" "
    "trajectoryTimeInterval_s=\"0.1\"/></leg>\n";
}

/// Runs a survey of the folder's platform with the id plane.
void Run(const Files& files, const std::string& attributes, const std::string& legs)
{
  const Reading reading(files, attributes, legs);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  playing.Player->SetOverwrite(true);
  const bool good = playing.Player->Run();
  INFO(playing.Log->Errors);
  REQUIRE(good);
}

} // namespace

TEST_CASE("SurveyPlatforms: a car turns on circles and climbs", "[SurveyPlatforms]")
{
  const Files files;
  files.Replace("assets.xml", "type=\"linearpath\"", "type=\"groundvehicle\" drag=\"0.005\"");
  Run(files, Flight,
    Leg("z=\"20\" movePerSec_m=\"5\"") + Leg("y=\"30\" z=\"21\" movePerSec_m=\"5\"") +
      Leg("x=\"20\" y=\"30\" z=\"21\""));
  const auto first = ReadSamples(files / "out/test/leg000_trajectory.txt");
  const auto second = ReadSamples(files / "out/test/leg001_trajectory.txt");
  REQUIRE(first.size() > 20);
  CHECK(first.front().Y == 0.0);
  CHECK(first.back().Y == 30.0); // to 0.1 mm as printed
  CHECK(first.back().Z == 21.0); // waypoints at other heights are reached
  CHECK(second.front().Time == first.back().Time);
  CHECK(second.back().X == 20.0);
  CHECK(second.back().Yaw > 225.0); // it leaves a circle beside the line towards the point
  CHECK(second.back().Yaw < 270.0);
  double fastest = 0.0;
  for (std::size_t i = 1; i < first.size(); ++i)
  {
    const Sample& a = first[i - 1];
    const Sample& b = first[i];
    fastest = std::max(fastest, std::hypot(b.X - a.X, b.Y - a.Y, b.Z - a.Z) / (b.Time - a.Time));
  }
  CHECK(fastest == Approx(5.0).epsilon(0.01)); // movePerSec_m
}

TEST_CASE("SurveyPlatforms: a multicopter tilts with its scanner", "[SurveyPlatforms]")
{
  const Files files;
  files.Replace("assets.xml", "type=\"linearpath\"", "type=\"multicopter\" base_pitch_deg=\"-5\"");
  Run(files, Flight,
    Leg("z=\"50\" movePerSec_m=\"8\"") + Leg("y=\"40\" z=\"50\" movePerSec_m=\"8\"") +
      Leg("x=\"40\" y=\"40\" z=\"50\""));
  const auto first = ReadSamples(files / "out/test/leg000_trajectory.txt");
  REQUIRE(first.size() > 40);
  CHECK(first.front().Roll == Approx(0.0).margin(0.1)); // it hovers
  double lowest = 0.0;
  double cruise = 0.0;
  for (const Sample& s : first)
  {
    lowest = std::min(lowest, s.Roll); // in the file: about the right axis, nose up
    cruise = std::abs(s.Y - 20.0) < 0.6 ? s.Roll : cruise;
  }
  CHECK(cruise == Approx(-5.0).margin(0.1)); // base_pitch_deg at movePerSec_m
  CHECK(lowest < -20.0);                     // while accelerating
  CHECK(first.back().Y == 40.0);
  CHECK(first.back().Roll == Approx(0.0).margin(0.1)); // stopAndTurn is the default
}

TEST_CASE("SurveyPlatforms: a very slow multicopter", "[SurveyPlatforms]")
{
  const Files files;
  files.Replace("assets.xml", "type=\"linearpath\"", "type=\"multicopter\"");
  Run(files, Flight, Leg("z=\"5\" movePerSec_m=\"0.1\"") + Leg("y=\"0.2\" z=\"5\""));
  const auto samples = ReadSamples(files / "out/test/leg000_trajectory.txt");
  CHECK(samples.back().Y == 0.2);
  CHECK(samples.back().Time == Approx(2.0).epsilon(0.3));
}

TEST_CASE("SurveyPlatforms: the heading of a multicopter at departure", "[SurveyPlatforms]")
{
  const Files files;
  files.Replace("assets.xml", "type=\"linearpath\"", "type=\"multicopter\"");
  Run(files, Flight,
    Leg("z=\"50\" movePerSec_m=\"8\" yawAtDeparture_deg=\"40\"") + Leg("y=\"40\" z=\"50\""));
  const auto samples = ReadSamples(files / "out/test/leg000_trajectory.txt");
  CHECK(samples.front().Yaw == Approx(40.0).margin(1e-3)); // both are counterclockwise
}

TEST_CASE("SurveyPlatforms: a recorded flight", "[SurveyPlatforms]")
{
  const Files files;
  files.Write("way.txt",
    "#HEADER: \"t\", \"x\", \"y\", \"z\", \"roll\", \"pitch\", \"yaw\"\n"
    "100,0,0,60,0,0,350\n101,0,10,60,0,0,10\n103,10,10,62,0,0,90\n");
  const std::string file = "trajectory=\"way.txt\"";
  Run(files, R"(platform="interpolated" basePlatform="assets.xml#plane" scanner="assets.xml#als")",
    Leg(file + " tEnd=\"101\"") + Leg(file + " tStart=\"101.5\" teleportToStart=\"true\""));
  const auto first = ReadSamples(files / "out/test/leg000_trajectory.txt");
  REQUIRE(first.size() == 11);
  CHECK(first[0].Time == 0.0);
  CHECK(first[5].Y == 5.0);
  CHECK(first[5].Yaw == Approx(0.0).margin(1e-4)); // the shorter way from 350 to 10 degrees
  const auto second =
    ReadSamples(files / "out/test/leg001_trajectory.txt"); // fires pulses: no end point
  REQUIRE(second.size() == 16);
  CHECK(second[0].Time == 1.0);
  CHECK(second[0].X == 2.5);
  CHECK(second[15].X == 10.0);
  CHECK(second[15].Z == 62.0);
  CHECK(second[15].Yaw == 270.0); // ARINC is clockwise, the file counterclockwise

  Run(files, R"(platform="interpolated" scanner="assets.xml#tls")",
    "<leg><platformSettings " + file +
      " syncGPSTime=\"true\" tStart=\"102\"/><scannerSettings scanFreq_hz=\"100\"/></leg>");
  const auto synced = ReadSamples(files / "out/test/leg000_trajectory.txt");
  CHECK(synced.front().Time == 102.0);
  CHECK(synced.back().Time == 103.0);
}

TEST_CASE("SurveyPlatforms: impossible paths name the leg or the file", "[SurveyPlatforms]")
{
  const Files files;
  files.Write("way.txt", "0,0,0,0,0,0,60\n1,0,0,0,x,0,60\n");
  const Reading recorded(
    files, R"(platform="interpolated" scanner="assets.xml#als")", Leg("trajectory=\"way.txt\""));
  REQUIRE(recorded.Good);
  Playing(files, recorded).CheckFails({ "way.txt:2" });

  const Files other;
  other.Replace("assets.xml", "type=\"linearpath\"", "type=\"groundvehicle\"");
  const Reading climbing(other, Flight, Leg("z=\"10\"") + Leg("z=\"20\""));
  REQUIRE(climbing.Good);
  Playing(other, climbing).CheckFails({ "survey.xml:5" });
}

TEST_CASE("SurveyPlatforms: noise moves pulses, not the trajectory file", "[SurveyPlatforms]")
{
  const Files files;
  const std::string legs = Leg("z=\"90\" movePerSec_m=\"20\"") + Leg("x=\"20\" z=\"90\"");
  Run(files, Flight, legs);
  const auto still = ReadPoints(files / "out/test/leg000_points.xyz");
  const std::string way = ReadText(files / "out/test/leg000_trajectory.txt");
  const std::string noise =
    R"(<positionXNoise type="UNIFORM" min="0.5" max="1.5" fixedLifespan="0"/>)";
  Run(files, Flight, legs + noise);
  const auto moved = ReadPoints(files / "out/test/leg000_points.xyz");
  CHECK(ReadText(files / "out/test/leg000_trajectory.txt") == way);
  REQUIRE(moved.size() == still.size());
  const double shift = moved[0].X - still[0].X;
  CHECK(shift > 0.5);
  CHECK(shift < 1.5);
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    REQUIRE(moved[i].X - still[i].X == Approx(shift).margin(2e-4)); // constant
    REQUIRE(std::abs(moved[i].Z) < 1e-3);                           // on the ground at their
                                                                    // positions
  }
}

TEST_CASE("SurveyPlatforms: a lever arm error displaces points off surfaces", "[SurveyPlatforms]")
{
  const Files files;
  const std::string legs = Leg("z=\"90\" movePerSec_m=\"20\"") + Leg("x=\"20\" z=\"90\"");
  Run(files, Flight, legs);
  const auto still = ReadPoints(files / "out/test/leg000_points.xyz");
  const std::string way = ReadText(files / "out/test/leg000_trajectory.txt");
  Run(files, Flight, legs + R"(<navigationError leverArmZ_m="0.5"/>)");
  const auto moved = ReadPoints(files / "out/test/leg000_points.xyz");
  CHECK(ReadText(files / "out/test/leg000_trajectory.txt") == way);
  REQUIRE(moved.size() > 1000);
  for (const auto& point : moved)
  {
    REQUIRE(point.Z == Approx(-0.5).margin(1e-3)); // the scanner is higher than it reports
  }
  // Without errors nothing changes.
  Run(files, Flight, legs + R"(<navigationError leverArmZ_m="0" positionTime_s="5"/>)");
  const auto quiet = ReadPoints(files / "out/test/leg000_points.xyz");
  REQUIRE(quiet.size() == still.size());
  for (std::size_t i = 0; i < quiet.size(); ++i)
  {
    REQUIRE((quiet[i].X == still[i].X && quiet[i].Z == still[i].Z));
  }
}

TEST_CASE("SurveyPlatforms: a grade gives the errors that are not given", "[SurveyPlatforms]")
{
  using Noise = vtkHeliosPlatformNoise;
  helios::PlatformData platform;
  std::istringstream grades(Noise::GetGradeNames());
  for (std::string grade; grades >> grade;)
  {
    CAPTURE(grade);
    const Files files;
    const Reading reading(files, Flight,
      Leg("z=\"90\" movePerSec_m=\"20\"") + Leg("x=\"20\" z=\"90\"") + "<navigationError grade=\"" +
        grade + "\"/>");
    CHECK(reading.Good); // the words of the dialect are the names
    platform.Errors = helios::NavigationErrorData();
    platform.Errors.Grade = grade;
    platform.Errors.PositionRMS[2] = 0.0;
    platform.Errors.AttitudeRMS[0] = 0.7;
    platform.Errors.AttitudeTime = 30.0;
    const auto noise = helios::MakePlatformNoise(platform, 1);
    REQUIRE(noise);
    vtkNew<Noise> expected;
    REQUIRE(expected->SetGrade(grade));
    CHECK(noise->GetSlowErrorRMS(0) == expected->GetSlowErrorRMS(0));
    CHECK(noise->GetSlowErrorRMS(0) > 0.0);
    CHECK(noise->GetSlowErrorRMS(2) == 0.0);
    CHECK(noise->GetSlowErrorRMS(3) == 0.7);
    CHECK(noise->GetSlowErrorRMS(5) == expected->GetSlowErrorRMS(5));
    CHECK(noise->GetSlowErrorTime(5) == 30.0);
  }
  platform.Errors = helios::NavigationErrorData();
  CHECK_FALSE(helios::MakePlatformNoise(platform, 1));
}

TEST_CASE("SurveyPlatforms: true points are written beside the reported ones", "[SurveyPlatforms]")
{
  const Files files;
  const std::string legs = Leg("z=\"90\" movePerSec_m=\"20\"") + Leg("x=\"20\" z=\"90\"") +
    R"(<navigationError leverArmZ_m="0.5" positionXRms_m="0.2" positionTime_s="1"/>)";
  const Reading reading(files, Flight, legs);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  playing.Player->WriteTruthOn();
  playing.CheckFails({ "WriteTruth is on, but files of the Format \"xyz\" cannot have points and "
                       "normals without noise; give vtp." });
  playing.Player->SetFormat("vtp");
  REQUIRE(playing.Player->Run());
  vtkNew<vtkHeliosPointXMLReader> reader;
  reader->SetFileName((files / "out/test/leg000_points.pvtp").c_str());
  reader->Update();
  vtkPolyData* echoes = reader->GetOutput();
  vtkDataArray* truth = echoes->GetPointData()->GetArray(vtkHeliosArrayNames::TruePoint);
  REQUIRE(truth);
  REQUIRE(echoes->GetNumberOfPoints() > 1000);
  double largest = 0.0;
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    REQUIRE(truth->GetComponent(i, 2) == Approx(0.0).margin(1e-3));
    REQUIRE(echoes->GetPoint(i)[2] == Approx(-0.5).margin(1e-3));
    largest = std::max(largest, std::abs(echoes->GetPoint(i)[0] - truth->GetComponent(i, 0)));
  }
  CHECK(largest > 0.02);
  CHECK(largest < 1.0); // five times the RMS
  CHECK(
    ReadText(files / "out/test/run_summary.json").find("\"truth\" : true") != std::string::npos);
}
