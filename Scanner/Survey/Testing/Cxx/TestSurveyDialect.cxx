// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// From files in the HELIOS dialect to plain data, and from that to a run.
#include "heliosErrorObserver.h"
#include "heliosSurveyData.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveyPlayer.h"
#include "vtkHeliosSurveyReader.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace
{

/// A folder with a scene, two scanners and two platforms; a test adds its survey.
class Files
{
public:
  Files()
  {
    std::string name = (fs::temp_directory_path() / "vtkHeliosSurveyXXXXXX").string();
    this->Folder = ::mkdtemp(name.data());
    this->Write("plane.obj", "v -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\nf 1 2 3 4\n");
    this->Write("scene.xml", R"(<document><scene id="s"><part id="floor">
<filter type="objloader"><param type="string" key="filepath" value="plane.obj"/></filter>
</part></scene></document>)");
    this->Write("assets.xml", R"(<document>
<platform id="tripod" type="static"><scannerMount x="0" y="0" z="1.5"/></platform>
<platform id="plane" type="linearpath"><scannerMount z="0.7">
<rot axis="x" angle_deg="-90"/><rot axis="z" angle_deg="90"/></scannerMount></platform>
<scanner id="tls" optics="rotating" accuracy_m="0.005" beamDivergence_rad="0.0004"
 headRotatePerSecMax_deg="60" pulseFreqs_Hz="100000, 300000" pulseLength_ns="5" rangeMin_m="0.5"
 receivedEnergyMin_W="0.002" scanAngleMax_deg="120" scanAngleEffectiveMax_deg="50"
 scanFreqMin_Hz="3" scanFreqMax_Hz="120"><FWFSettings beamSampleQuality="2"/>
<beamOrigin x="0" y="0" z="0.2"/></scanner>
<scanner id="als" optics="conic" pulseFreqs_Hz="200000" scanAngleMax_deg="20" scanFreqMax_Hz="80"/>
</document>)");
  }
  ~Files() { fs::remove_all(this->Folder); }

  void Write(const std::string& name, const std::string& text) const
  {
    fs::create_directories((this->Folder / name).parent_path());
    std::ofstream(this->Folder / name) << text;
  }
  std::string operator/(const std::string& name) const { return (this->Folder / name).string(); }

private:
  fs::path Folder;
};

/// A reader of a survey whose inside is given.
struct Reading
{
  vtkNew<vtkHeliosSurveyReader> Reader;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  bool Good;

  Reading(const Files& files, const std::string& attributes, const std::string& inside)
  {
    files.Write("survey.xml",
      "<?xml version=\"1.0\"?>\n<document>\n" + inside.substr(0, inside.find("<leg")) +
        "<survey name=\"test\" scene=\"scene.xml#s\" " + attributes + ">\n" +
        inside.substr(inside.find("<leg")) + "\n</survey></document>");
    this->Log->Watch(this->Reader);
    this->Reader->SetFileName((files / "survey.xml").c_str());
    this->Good = this->Reader->Read();
  }
  const helios::SurveyData& Data() { return this->Reader->GetSurvey()->GetData(); }
};

const char* Tripod = R"(platform="assets.xml#tripod" scanner="assets.xml#tls")";
const char* Flight = R"(platform="assets.xml#plane" scanner="assets.xml#als")";

std::string ReadText(const std::string& path)
{
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

} // namespace

TEST_CASE("Survey: scanner, platform and units", "[Survey]")
{
  const Files files;
  Reading reading(files, Tripod, R"(<leg><platformSettings x="1" y="2" z="3"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="30" headRotateStop_deg="90"/></leg>)");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  const helios::ScannerData& scanner = reading.Data().Scanner;
  CHECK(scanner.PulseFrequencies == std::vector<double>{ 100000, 300000 });
  CHECK(scanner.PulseLength == 5.0);
  CHECK(scanner.Accuracy == 0.005);
  CHECK(scanner.DetectionThreshold == Approx(0.002e-9)); // counted in nanowatts
  CHECK(scanner.NumberOfCircles == 2);
  CHECK(scanner.Beam.Position[2] == 0.2);
  CHECK(reading.Data().Platform.Mount.Position[2] == 1.5);
  const helios::LegData& leg = reading.Data().Legs.at(0);
  CHECK(leg.Position[1] == 2.0);
  CHECK(leg.PulseFrequency == 100000); // the scanner's first
  CHECK(leg.BeamDivergence == 0.0004);
  CHECK(leg.VerticalAngleMin == -50);
  CHECK(leg.VerticalAngleMax == 50);
  CHECK(leg.GetHeadTime() == 3.0);
  CHECK(reading.Reader->GetSurvey()->GetName() == "test");
  CHECK(reading.Reader->GetSurvey()->GetNumberOfLegs() == 1);
}

TEST_CASE("Survey: rotations of a mount, the last outermost", "[Survey]")
{
  const Files files;
  Reading reading(files, Flight, R"(<leg><platformSettings z="100"/></leg>
<leg><platformSettings x="10" z="100"/></leg>)");
  REQUIRE(reading.Good);
  // x -90 turns y down; z 90 leaves it there
  const helios::Vec3 down = helios::Rotate(reading.Data().Platform.Mount.Orientation, { 0, 1, 0 });
  CHECK(down[2] == Approx(-1));
  const helios::Vec3 side = helios::Rotate(reading.Data().Platform.Mount.Orientation, { 1, 0, 0 });
  CHECK(side[1] == Approx(1));
}

TEST_CASE("Survey: templates are inherited by presence", "[Survey]")
{
  const Files files;
  Reading reading(
    files, Tripod, R"(<scannerSettings id="base" pulseFreq_hz="300000" scanFreq_hz="50"
 headRotatePerSec_deg="10" headRotateStop_deg="20" beamDivergence_rad="0.001"/>
<scannerSettings id="fast" template="base" headRotatePerSec_deg="20"/>
<platformSettings id="place" x="5" y="6" z="7"/>
<leg><platformSettings template="place" y="8"/><scannerSettings template="fast" active="false"/></leg>
<leg><platformSettings template="place"/><scannerSettings template="base" scanFreq_hz="60"/></leg>)");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  const auto& legs = reading.Data().Legs;
  REQUIRE(legs.size() == 2);
  CHECK(legs[0].Position == helios::Vec3(5, 8, 7));
  CHECK_FALSE(legs[0].Active);
  CHECK(legs[0].HeadRotateSpeed == 20);
  CHECK(legs[0].ScanFrequency == 50);
  CHECK(legs[0].BeamDivergence == 0.001);
  CHECK(legs[1].Position == helios::Vec3(5, 6, 7));
  CHECK(legs[1].HeadRotateSpeed == 10);
  CHECK(legs[1].ScanFrequency == 60);
  CHECK(legs[1].PulseFrequency == 300000);
}

TEST_CASE("Survey: resolution in degrees sets line rate and head speed", "[Survey]")
{
  const Files files;
  // f = 100 kHz, 240 degrees a facet: 0.12 deg take 50 lines a second, 0.1 deg a line 5 deg/s
  Reading reading(files, Tripod, R"(<leg><platformSettings/><scannerSettings
 verticalResolution_deg="0.12" horizontalResolution_deg="0.1" headRotateStop_deg="10"/></leg>)");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  CHECK(reading.Data().Legs[0].ScanFrequency == Approx(50));
  CHECK(reading.Data().Legs[0].HeadRotateSpeed == Approx(5));
}

TEST_CASE("Survey: asset folders come before the survey's own", "[Survey]")
{
  const Files files;
  std::string other = ReadText(files / "assets.xml");
  other.replace(other.find("pulseLength_ns=\"5\""), 18, "pulseLength_ns=\"9\"");
  files.Write("extra/assets.xml", other);
  Reading plain(files, Tripod,
    "<leg><platformSettings/><scannerSettings scanFreq_hz=\"50\" "
    "headRotatePerSec_deg=\"10\" headRotateStop_deg=\"20\"/></leg>");
  REQUIRE(plain.Good);
  CHECK(plain.Data().Scanner.PulseLength == 5);
  vtkNew<vtkHeliosSurveyReader> reader;
  reader->AddAssetDirectory((files / "extra").c_str());
  reader->SetFileName((files / "survey.xml").c_str());
  REQUIRE(reader->Read());
  CHECK(reader->GetSurvey()->GetData().Scanner.PulseLength == 9);
}

TEST_CASE("Survey: scene filters go rotate, scale, translate; the last scale counts", "[Survey]")
{
  const Files files;
  files.Write("scene.xml", R"(<document><scene id="s"><part>
<filter type="translate"><param type="vec3" key="offset" value="1;2;3"/></filter>
<filter type="scale"><param type="double" key="scale" value="5"/></filter>
<filter type="objloader"><param type="string" key="filepath" value="plane.obj"/></filter>
<filter type="rotate"><param key="rotation" type="rotation"><rot axis="z" angle_deg="90"/></param></filter>
<filter type="scale"><param type="double" key="scale" value="2"/></filter>
</part></scene></document>)");
  Reading reading(files, Tripod,
    "<leg><platformSettings/><scannerSettings scanFreq_hz=\"50\" "
    "headRotatePerSec_deg=\"10\" headRotateStop_deg=\"20\"/></leg>");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  const helios::PartData& part = reading.Data().Scene.Parts.at(0);
  CHECK(part.Scale == 2);
  CHECK(part.Translation == helios::Vec3(1, 2, 3));
  CHECK(helios::Rotate(part.Rotation, { 1, 0, 0 })[1] == Approx(1));
  CHECK(part.Name == "0");
  CHECK(reading.Log->HasWarning("scale"));
}

TEST_CASE("Survey: what does not exist yet is named with its place", "[Survey]")
{
  const Files files;
  const char* leg = "<leg><platformSettings/><scannerSettings scanFreq_hz=\"50\" "
                    "headRotatePerSec_deg=\"10\" headRotateStop_deg=\"20\"/></leg>";
  SECTION("a loader")
  {
    files.Write("scene.xml", R"(<document><scene id="s"><part>
<filter type="geotiffloader"><param type="string" key="filepath" value="a.tif"/></filter>
</part></scene></document>)");
    Reading reading(files, Tripod, leg);
    CHECK_FALSE(reading.Good);
    CHECK(reading.Log->HasError("scene.xml:2"));
    CHECK(reading.Log->HasError("geotiffloader"));
  }
  SECTION("optics")
  {
    std::string assets = ReadText(files / "assets.xml");
    assets.replace(assets.find("optics=\"rotating\""), 17, "optics=\"risley\"");
    files.Write("assets.xml", assets);
    Reading reading(files, Tripod, leg);
    CHECK_FALSE(reading.Good);
    CHECK(reading.Log->HasError("assets.xml:"));
    CHECK(reading.Log->HasError("risley"));
  }
  SECTION("a platform")
  {
    std::string assets = ReadText(files / "assets.xml");
    assets.replace(assets.find("type=\"static\""), 13, "type=\"multicopter\"");
    files.Write("assets.xml", assets);
    Reading reading(files, Tripod, leg);
    CHECK_FALSE(reading.Good);
    CHECK(reading.Log->HasError("multicopter"));
  }
  SECTION("a line rate beyond the scanner's")
  {
    Reading reading(files, Tripod,
      "<leg><platformSettings/><scannerSettings scanFreq_hz=\"500\" "
      "headRotatePerSec_deg=\"10\" headRotateStop_deg=\"20\"/></leg>");
    CHECK_FALSE(reading.Good);
    CHECK(reading.Log->HasError("500"));
    CHECK(reading.Log->HasError("120"));
  }
}

TEST_CASE("SurveyPlayer: legs share the time, lose and repeat no pulse", "[Survey]")
{
  const Files files;
  Reading reading(files, Flight, R"(<platformSettings id="p" z="100" movePerSec_m="50"/>
<scannerSettings id="c" pulseFreq_hz="200000" scanFreq_hz="80" scanAngle_deg="10"
 trajectoryTimeInterval_s="0.05"/>
<leg><platformSettings template="p" x="-10"/><scannerSettings template="c"/></leg>
<leg><platformSettings template="p" x="10"/><scannerSettings template="c" active="false"/></leg>
<leg><platformSettings template="p" x="15"/><scannerSettings template="c"/></leg>
<leg><platformSettings template="p" x="15" y="5"/><scannerSettings template="c"/></leg>)");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveyPlayer> player;
  reading.Log->Watch(player);
  player->SetSurvey(reading.Reader->GetSurvey());
  player->SetOutputDirectory((files / "out").c_str());
  player->SetPulsesPerBlock(30000);
  REQUIRE(player->Run());
  // 20 m and 5 m at 50 m/s and 200 kHz
  CHECK(player->GetNumberOfPulses() == 80000 + 20000);
  CHECK(player->GetNumberOfPulsesDone() == 100000);
  CHECK(player->GetNumberOfEchoes() == 100000);
  CHECK(player->GetNumberOfFirstReturns() == 100000);
  CHECK_FALSE(fs::exists(files / "out/test/leg001_points.xyz"));
  CHECK_FALSE(fs::exists(files / "out/test/leg003_points.xyz"));

  std::ifstream points(files / "out/test/leg002_points.xyz");
  double x, y, z, intensity, width, time;
  long long number, returns, pulse, classification;
  std::string part;
  REQUIRE(points >> x >> y >> z >> intensity >> width >> number >> returns >> pulse >> part >>
    classification >> time);
  CHECK(pulse == 80000);      // goes on where the first active leg ended
  CHECK(time == Approx(0.5)); // 0.4 s of leg 0, 0.1 s of leg 1
  CHECK(part == "floor");
  CHECK(std::abs(z) < 1e-3);
  std::ifstream trajectory(files / "out/test/leg000_trajectory.txt");
  int lines = 0;
  for (std::string line; std::getline(trajectory, line);)
  {
    ++lines;
  }
  CHECK(lines == 9); // 0 to 0.4 s in steps of 0.05 s

  CHECK_FALSE(player->Run());
  CHECK(reading.Log->HasError("earlier run"));
  player->SetOverwrite(true);
  CHECK(player->Run());
}

TEST_CASE("SurveyPlayer: the size of the blocks changes no byte", "[Survey]")
{
  const Files files;
  Reading reading(files, Tripod, R"(<leg><platformSettings onGround="true"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="60" headRotateStop_deg="30"/></leg>)");
  REQUIRE(reading.Good);
  std::string texts[2];
  for (const int run : { 0, 1 })
  {
    vtkNew<vtkHeliosSurveyPlayer> player;
    player->SetSurvey(reading.Reader->GetSurvey());
    const std::string folder = files / ("out" + std::to_string(run));
    player->SetOutputDirectory(folder.c_str());
    player->SetSeed(3);
    player->SetPulsesPerBlock(run == 0 ? 262144 : 777);
    REQUIRE(player->Run());
    texts[run] = ReadText(folder + "/test/leg000_points.xyz");
  }
  CHECK(texts[0].size() > 100000);
  CHECK(texts[0] == texts[1]);
}

TEST_CASE("SurveyPlayer: parts and legs go onto the ground", "[Survey]")
{
  const Files files;
  files.Write("hill.mtl", "newmtl earth\nhelios_isGround true\n");
  files.Write("hill.obj",
    "mtllib hill.mtl\nusemtl earth\nv -50 -50 20\nv 50 -50 20\nv 50 50 20\n"
    "v -50 50 20\nf 1 2 3 4\n");
  files.Write("wall.obj", "v -5 10 -3\nv 5 10 -3\nv 5 10 7\nv -5 10 7\nf 1 2 3 4\n");
  files.Write("scene.xml", R"(<document><scene id="s">
<part id="hill"><filter type="objloader"><param type="string" key="filepath" value="hill.obj"/></filter></part>
<part id="wall"><filter type="objloader"><param type="string" key="filepath" value="wall.obj"/></filter>
<filter type="translate"><param type="integer" key="onGround" value="1"/></filter></part>
</scene></document>)");
  Reading reading(files, Tripod, R"(<leg><platformSettings onGround="true"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="60" headRotateStart_deg="-5"
 headRotateStop_deg="5"/></leg>)");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveyPlayer> player;
  player->SetSurvey(reading.Reader->GetSurvey());
  player->SetOutputDirectory((files / "out").c_str());
  player->SetNoise(false);
  REQUIRE(player->Run());
  double lowest = 1e9, highest = -1e9;
  std::ifstream points(files / "out/test/leg000_points.xyz");
  for (std::string line; std::getline(points, line);)
  {
    std::istringstream words(line);
    double x, y, z;
    words >> x >> y >> z;
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
  }
  CHECK(lowest > 19.9);
  CHECK(highest == Approx(30).margin(0.2)); // the wall: 10 m high, put down from z = -3
}
