// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Survey settings of channels, platforms, noise, trajectories and legs beyond the basic case.
#include "heliosSurveyChanges.h"
#include "heliosSurveyPlaying.h"

#include <catch2/catch.hpp>

#include <string>

using namespace helios::test;

namespace
{

/// A leg on a tripod with its settings.
std::string Leg(const std::string& attributes, const std::string& place)
{
  return "<leg " + attributes + "><platformSettings " + place +
    "/>\n<scannerSettings scanFreq_hz=\"50\" headRotatePerSec_deg=\"10\" "
    "headRotateStop_deg=\"10\"/></leg>\n";
}

const helios::SurveyData& Read(const Reading& reading)
{
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  return reading.Data();
}

} // namespace

TEST_CASE(
  "SurveyDialect: channels are copies of their scanner with the given changes", "[SurveyDialect]")
{
  const Files files;
  files.Replace("assets.xml", "<FWFSettings beamSampleQuality=\"2\"/>",
    R"(<FWFSettings beamSampleQuality="2"/><channels>
<channel id="low"><beamOrigin x="1"/></channel>
<channel scanAngleMax_deg="60" accuracy_m="0.02" beamDivergence_rad="0.001" wavelength_nm="532"
 receivedEnergyMin_W="0.005"><FWFSettings binSize_ns="0.5"/></channel>
<channel optics="risley" angle1_deg="10" refrIndex1="1.5" rotorFreq1_Hz="30">
<incidentBeam y="2" z="1"/></channel></channels>)");
  const Reading reading(
    files, Tripod, OneLeg + std::string(R"(<detectorSettings rangeMax_m="90"/>)"));
  const helios::SurveyData& data = Read(reading);
  const helios::ScannerData& first = data.Scanners.at(0);
  REQUIRE(first.GetNumberOfChannels() == 3);
  CHECK(first.Id == "tls, channel low");
  CHECK(first.Beam.Position == helios::Vec3(1, 0, 0));
  CHECK(first.ScanAngleMax == 120);
  const helios::ScannerData& second = first.GetChannel(1);
  CHECK(second.Channel == "1");
  CHECK(second.Beam.Position == helios::Vec3(0, 0, 0.2)); // the scanner's
  CHECK(second.ScanAngleMax == 60);
  CHECK(second.Receiver.RangeAccuracy == 0.02);
  CHECK(second.Receiver.Wavelength == 532);
  CHECK(second.Receiver.DetectionThreshold == Approx(0.005e-9));
  CHECK(second.Receiver.BinSize == 0.5);
  CHECK(second.Receiver.NumberOfCircles == 2);
  const helios::ScannerData& third = first.GetChannel(2);
  CHECK(third.Type == helios::Optics::RisleyPrisms);
  CHECK(third.ScanAngleMax == 0); // other optics inherit nothing of the scanner's
  CHECK(third.Prisms[0].WedgeAngle == 10);
  CHECK(third.IncidentBeam == helios::Vec3(0, 2, 1));
  for (std::size_t k = 0; k < 3; ++k)
  {
    CHECK(
      first.GetChannel(k).Receiver.RangeMax == 90); // changes of the survey apply to all channels
    CHECK(first.GetChannel(k).Receiver.PulseLength == 5);
  }
  const auto& scans = data.Legs.at(0).Scans;
  REQUIRE(scans.size() == 3);
  CHECK(scans[0].BeamDivergence == 0.0004);
  CHECK(scans[1].BeamDivergence == 0.001);
  CHECK(scans[1].VerticalAngleMax == 50); // scanAngleEffectiveMax_deg of the scanner
  CHECK(scans[1].ScanAngle == 60);
}

TEST_CASE("SurveyDialect: invalid channels are errors", "[SurveyDialect]")
{
  const std::string before = "<FWFSettings beamSampleQuality=\"2\"/>";
  const auto with = [&before](const std::string& channel)
  { return before + "<channels>\n" + channel + "</channels>"; };
  CheckAllRefused(Tripod, OneLeg,
    {
      { "assets.xml", before, with("<channel optics=\"turning\"/>"),
        { "assets.xml:9", "optics=\"turning\" is not valid" } },
      { "assets.xml", before, with("<channel><incidentBeam y=\"-1\"/></channel>"),
        { "assets.xml:9", "<incidentBeam> does not point at the prisms" } },
      { "assets.xml", before, with("<channel rangeMin_m=\"5\" rangeMax_m=\"4\"/>"),
        { "assets.xml:9", "channel 0", "rangeMin_m=\"5\" is not below" } },
      { "assets.xml", "optics=\"rotating\"", "",
        { "assets.xml:5", "scanner tls has no optics",
          "give rotating, oscillating, line, conic, palmer, risley or spinning" } },
    });
}

TEST_CASE("SurveyDialect: legs name their own platform and scanner", "[SurveyDialect]")
{
  const Files files;
  const std::string flight = R"( platform="assets.xml#plane" scanner="assets.xml#als")";
  const Reading reading(files, Tripod,
    Leg("", "x=\"1\"") + Leg(flight, "z=\"90\"") + Leg(flight, "x=\"5\" z=\"90\"") + Leg("", ""));
  const helios::SurveyData& data = Read(reading);
  CHECK(data.Scanners.size() == 2);
  CHECK(data.Platforms.size() == 2);
  REQUIRE(data.Legs.size() == 4);
  CHECK(data.GetScanner(0).Id == "tls");
  CHECK(data.GetScanner(1).Id == "als");
  CHECK(data.GetPlatform(2).Id == "plane");
  CHECK(data.Legs[3].Platform == 0);
  CHECK(data.Fires(0));
  CHECK(data.Fires(1));
  CHECK_FALSE(data.Fires(2)); // the end of the flight
  CHECK(data.Fires(3));
  CHECK(reading.Reader->GetSurvey()->GetPlatformName() == "tripod, plane");
  CHECK(reading.Reader->GetSurvey()->IsMoving());
}

TEST_CASE("SurveyDialect: the scans of planner documents (Java)", "[SurveyDialect]")
{
  const Files files;
  const Reading reading(files, "",
    R"(<leg platform="assets.xml#tripod" scanner="assets.xml#tls"><scannerSettings active="false"/></leg>
<scan platform="assets.xml#tripod" scanner="assets.xml#tls">
<scannerRotation axis="yaw" angle="0" start="20" end="-70"/>
<leg x="1" y="2" z="3"/><leg x="4"/></scan>)");
  const helios::SurveyData& data = Read(reading);
  REQUIRE(data.Legs.size() == 3);
  CHECK(data.Legs[1].Position == helios::Vec3(1, 2, 3));
  CHECK(data.Legs[2].Position == helios::Vec3(4, 0, 0));
  const helios::ScanData& scan = data.Legs[1].Scans.at(0);
  CHECK(scan.HeadRotateStart == 20);
  CHECK(scan.HeadRotateStop == -70);
  CHECK(scan.HeadRotateSpeed == -60); // the maximum of the head
  CHECK(scan.ScanFrequency == 120);   // and of the mirror
}

TEST_CASE(
  "SurveyDialect: models of platforms and scanners are named, not opened", "[SurveyDialect]")
{
  const Files files;
  files.Replace("assets.xml", "type=\"static\"", "type=\"static\" visModel=\"tripod.obj\"");
  files.Replace("assets.xml", "type=\"linearpath\"",
    "type=\"linearpath\" visModel=\"none.obj\" model=\"sr22/sr22.obj\"");
  files.Replace("assets.xml", "id=\"tls\"", "id=\"tls\" visModel=\"no such.obj\"");
  files.Write("tripod.obj", "this is no model\n");
  files.Write("Models/sr22/sr22.obj", "nor this\n");
  const std::string flight = R"( platform="assets.xml#plane" scanner="assets.xml#als")";
  const Reading reading(
    files, Tripod, Leg("", "z=\"5\"") + Leg(flight, "") + Leg(flight, "x=\"5\""));
  const helios::SurveyData& data = Read(reading);
  CHECK(data.GetPlatform(0).Model.Name == "tripod.obj");
  CHECK(data.GetPlatform(0).Model.File == files / "tripod.obj");
  CHECK(data.GetPlatform(0).Model.Where == files / "assets.xml:2: visModel=\"tripod.obj\"");
  CHECK(data.GetPlatform(1).Model.Name == "sr22/sr22.obj"); // model has priority
  CHECK(data.GetPlatform(1).Model.File == files / "Models/sr22/sr22.obj");
  CHECK(data.GetScanner(0).Model.Name == "no such.obj");
  CHECK(data.GetScanner(0).Model.File.empty());
  CHECK(data.GetScanner(0).Model.Where.find("assets.xml:5: visModel=\"no such.obj\"") !=
    std::string::npos);
  CHECK(data.GetScanner(1).Model.Name.empty());
  CHECK_FALSE(reading.Log->HasWarning("visModel")); // not needed by a simulation
  Playing playing(files, reading);
  CHECK(playing.Player->Run());
  CHECK_FALSE(playing.Log->HasWarning(".obj"));
}

TEST_CASE("SurveyDialect: an origin moves the following legs", "[SurveyDialect]")
{
  const Files files;
  const Reading reading(files, Tripod,
    Leg("", "x=\"1\"") + "<origin x=\"10\" z=\"5\"/>" + Leg("", "x=\"1\"") + "<origin y=\"7\"/>" +
      Leg("", "x=\"1\""));
  const auto& legs = Read(reading).Legs;
  CHECK(legs.at(0).Position == helios::Vec3(1, 0, 0));
  CHECK(legs.at(1).Position == helios::Vec3(11, 0, 5));
  CHECK(legs.at(2).Position == helios::Vec3(1, 7, 0));
}

TEST_CASE("SurveyDialect: seeds", "[SurveyDialect]")
{
  struct Case
  {
    const char* Text;
    vtkIdType Seed;
  };
  const Case cases[] = { { "AUTO", -1 }, { "", -1 }, { "42", 42 }, { "42.9", 42 }, { "0", 0 },
    { "2024-03-05 10:20:30", 20240305102030 } };
  for (const Case& one : cases)
  {
    INFO(one.Text);
    const Files files;
    const Reading reading(files, std::string(Tripod) + " seed=\"" + one.Text + "\"", OneLeg);
    CHECK(Read(reading).Seed == one.Seed);
  }
  for (const char* text :
    { "-1", "x", "1e3", "4611686018427387905", "2024-03-05 1x:20:30", "1.2.3" })
  {
    INFO(text);
    const Files files;
    const Reading reading(files, std::string(Tripod) + " seed=\"" + text + "\"", OneLeg);
    CHECK_FALSE(reading.Good);
    CHECK(reading.Log->HasError(std::string("seed=\"") + text + "\" is not valid"));
  }
}

TEST_CASE("SurveyDialect: navigation errors of a platform, and of the survey", "[SurveyDialect]")
{
  const Files files;
  files.Replace("assets.xml", "<scannerMount x=\"0\"",
    R"(<navigationError positionXRms_m="0.04" positionZRms_m="0.05" attitudeZRms_deg="0.02"
positionTime_s="300" attitudeTime_s="30" boresightY_deg="0.1" leverArmX_m="-0.2"
clockOffset_s="1e-3"/><scannerMount x="0")");
  const Reading reading(files, Tripod, OneLeg);
  const helios::NavigationErrorData& errors = Read(reading).Platforms.at(0).Errors;
  CHECK(errors.PositionRMS[0] == 0.04);
  CHECK(errors.PositionRMS[1] == -1.0); // not given
  CHECK(errors.Grade.empty());
  CHECK(errors.PositionRMS[2] == 0.05);
  CHECK(errors.AttitudeRMS[2] == 0.02);
  CHECK(errors.PositionTime == 300.0);
  CHECK(errors.AttitudeTime == 30.0);
  CHECK(errors.Boresight[1] == 0.1);
  CHECK(errors.LeverArm[0] == -0.2);
  CHECK(errors.ClockOffset == 1e-3);
  const Reading overriding(
    files, Tripod, OneLeg + std::string(R"(<navigationError attitudeXRms_deg="0.5"/>)"));
  const helios::NavigationErrorData& others = Read(overriding).Platforms.at(0).Errors;
  CHECK(others.AttitudeRMS[0] == 0.5);
  CHECK(others.PositionRMS[0] == -1.0); // all of them are overridden
  CHECK(others.PositionTime == 60.0);
  CheckAllRefused(Tripod, OneLeg,
    {
      { "assets.xml", "<scannerMount", "<navigationError positionXRms_m=\"-1\"/><scannerMount",
        { "assets.xml:2", "positionXRms_m=\"-1\" is out of range" } },
      { "assets.xml", "<scannerMount", "<navigationError attitudeTime_s=\"0\"/><scannerMount",
        { "assets.xml:2", "attitudeTime_s=\"0\" is out of range" } },
      { "assets.xml", "<scannerMount", "<navigationError boresightX_deg=\"200\"/><scannerMount",
        { "assets.xml:2", "boresightX_deg=\"200\" is out of range" } },
      { "assets.xml", "<scannerMount", "<navigationError grade=\"best\"/><scannerMount",
        { "assets.xml:2", "grade=\"best\"", "consumer" } },
    });
}

TEST_CASE("SurveyDialect: noise of a platform, and of the survey", "[SurveyDialect]")
{
  const Files files;
  files.Replace("assets.xml", "<scannerMount x=\"0\"",
    R"(<positionXNoise type="NORMAL" mean="1" stdev="0.02" clipEnabled="true" clipMin="-1" clipMax="2"/>
<attitudeZNoise type="UNIFORM" min="-0.1" max="0.1" fixedLifespan="5"/><scannerMount x="0")");
  const Reading reading(
    files, Tripod, OneLeg + std::string(R"(<positionXNoise stdev="0.5" fixedLifespan="0"/>)"));
  const helios::PlatformData& platform = Read(reading).Platforms.at(0);
  CHECK(platform.Noise[0].IsOn);
  CHECK(platform.Noise[0].Mean == 0.0); // the survey overrides the whole noise
  CHECK(platform.Noise[0].Deviation == 0.5);
  CHECK(platform.Noise[0].Lifespan == 0);
  CHECK_FALSE(platform.Noise[0].IsClipped);
  CHECK_FALSE(platform.Noise[1].IsOn);
  CHECK(platform.Noise[5].IsOn);
  CHECK(platform.Noise[5].IsUniform);
  CHECK(platform.Noise[5].Low == -0.1);
  CHECK(platform.Noise[5].High == 0.1);
  CHECK(platform.Noise[5].Lifespan == 5);

  CheckAllRefused(Tripod, OneLeg,
    {
      { "assets.xml", "<scannerMount", "<positionXNoise type=\"PINK\"/><scannerMount",
        { "assets.xml:2", "type=\"PINK\" is not valid", "NORMAL or UNIFORM" } },
      { "assets.xml", "<scannerMount", "<positionXNoise min=\"2\" max=\"1\"/><scannerMount",
        { "assets.xml:2", "min=\"2\" is above max=\"1\"" } },
      { "assets.xml", "<scannerMount", "<positionXNoise clipMin=\"2\"/><scannerMount",
        { "assets.xml:2", "clipMin=\"2\" is above clipMax=\"1\"" } },
      { "assets.xml", "<scannerMount", "<positionXNoise stdev=\"-1\"/><scannerMount",
        { "assets.xml:2", "stdev=\"-1\" is out of range" } },
    });
}

TEST_CASE("SurveyDialect: a trajectory from a file", "[SurveyDialect]")
{
  const Files files;
  files.Write("way.txt", "0;1;2;3;4;5;6\n");
  files.Replace("assets.xml", "<scannerMount z=\"0.7\">",
    "<positionZNoise stdev=\"0.1\"/><scannerMount z=\"0.7\">");
  const std::string flown =
    R"(platform="interpolated" basePlatform="assets.xml#plane" scanner="assets.xml#als" rotationSpec="CANONICAL")";
  const std::string settings = R"(<platformSettings id="file" trajectory="way.txt" toRadians="false"
 trajectory_separator=";" interpolationDomain="position" slopeFilterThreshold="0.1" xIndex="4"/>)";
  const Reading reading(files, flown,
    settings +
      "<leg><platformSettings template=\"file\" tStart=\"1\" tEnd=\"2\" teleportToStart=\"true\" "
      "syncGPSTime=\"1\" trajectory_seperator=\"&#9;\"/></leg>");
  const helios::SurveyData& data = Read(reading);
  CHECK(data.Convention == helios::AngleConvention::Canonical);
  CHECK(data.GetPlatform(0).Type == helios::PlatformType::Interpolated);
  CHECK(data.GetPlatform(0).Mount.Position[2] == 0.7);
  CHECK(data.GetPlatform(0).Noise[2].IsOn);
  const helios::TrajectoryFileData& file = data.Legs.at(0).Trajectory;
  CHECK(file.File == files / "way.txt");
  CHECK(file.Separator == "\t"); // either spelling; the leg overrides the template
  CHECK(file.IsInRadians);
  CHECK_FALSE(file.HasAttitude);
  CHECK(file.SlopeThreshold == 0.1);
  CHECK(file.Columns[0] == -1);
  CHECK(file.Columns[4] == 4);
  CHECK(file.StartTime == 1.0);
  CHECK(file.EndTime == 2.0);
  CHECK(file.KeepsTime);
  CHECK(file.TeleportsToStart);
  CHECK(data.Fires(0)); // no end point is needed

  const std::string leg =
    "<leg><platformSettings trajectory=\"way.txt\" interpolationDomain=\"position\"/></leg>";
  CheckAllRefused(Tripod, OneLeg,
    { { "survey.xml", Tripod, std::string(flown), { "survey.xml:5", "needs a trajectory" } },
      { "survey.xml", "x=\"1\"", "trajectory=\"none.txt\"",
        { "survey.xml:4", "trajectory=\"none.txt\": no such file" } },
      { "survey.xml", "x=\"1\"", "interpolationDomain=\"time\"",
        { "survey.xml:4", "interpolationDomain=\"time\" is not valid", "position_and_attitude" } },
      { "survey.xml", Tripod, std::string(Tripod) + " rotationSpec=\"ARINC\"",
        { "survey.xml:3", "rotationSpec=\"ARINC\" is not valid",
          "ARINC 705, CANONICAL or NAVIGATION" } } });
}

TEST_CASE("SurveyDialect: vehicle properties and turns", "[SurveyDialect]")
{
  const Files files;
  files.Replace("assets.xml", "type=\"linearpath\"",
    R"(type="multicopter" drag="0.01" engine_max_force="0.2" base_pitch_deg="-4" yaw_speed_deg="80")");
  const Reading reading(files, Flight,
    R"(<leg><platformSettings z="90" smoothTurn="true" slowdownEnabled="false" yawAtDeparture_deg="30"/>
</leg><leg stripId="7"><platformSettings x="50" z="90" stopAndTurn="false"/></leg>)");
  const helios::SurveyData& data = Read(reading);
  const helios::VehicleData& vehicle = data.GetPlatform(0).Vehicle;
  CHECK(data.GetPlatform(0).Type == helios::PlatformType::Multicopter);
  CHECK(reading.Log->HasWarning("attribute drag of <platform> is not used"));
  CHECK(reading.Log->HasWarning("attribute engine_max_force of <platform> is not used"));
  CHECK(vehicle.BasePitch == -4);
  CHECK(vehicle.YawSpeed == 80);
  CHECK(data.Legs[0].SmoothTurn);
  CHECK_FALSE(data.Legs[0].SlowsDown);
  CHECK(data.Legs[0].YawAtDeparture == 30);
  CHECK_FALSE(data.Legs[1].StopAndTurn);
  CHECK(data.Legs[1].Strip == "7");
  CheckAllRefused(Tripod, OneLeg,
    { { "survey.xml", "<leg>", "<leg stripId=\"a/b\">",
      { "survey.xml:4", "stripId=\"a/b\" is not valid in a file name" } } });
}
