// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs of scanners with channels, of strips, and of several platforms in one survey.
#include "heliosSurveyPlaying.h"

#include <vtkCommand.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <set>

using namespace helios::test;

namespace
{

/// A scanner with a channel to each side; the second has another wavelength.
void AddChannels(const Files& files)
{
  files.Replace("assets.xml", "<FWFSettings beamSampleQuality=\"2\"/>",
    R"(<FWFSettings beamSampleQuality="1"/><channels>
<channel id="left"><beamOrigin x="-0.5"><rot axis="z" angle_deg="5"/></beamOrigin></channel>
<channel id="right" wavelength_nm="532"><beamOrigin x="0.5"/></channel></channels>)");
  files.Write("spectra/paint.txt", "0.5 20\n0.6 20\n1.0 60\n1.1 60\n");
  files.Write("plane.mtl", "newmtl paint\nhelios_spectra paint\n");
  files.Write("plane.obj",
    "mtllib plane.mtl\nusemtl paint\nv -50 -50 0\nv 50 -50 0\nv 50 50 0\nv -50 50 0\nf 1 2 3 4\n");
}

/// 0.5 s at 100 kHz, from 2 m above the plane.
const char* const Turn = R"(<leg><platformSettings z="2"/>
<scannerSettings scanFreq_hz="100" headRotatePerSec_deg="20" headRotateStop_deg="10"/></leg>)";

std::string RunChannels(const Files& files, const std::string& out, vtkIdType pulsesPerBlock)
{
  const Reading reading(files, Tripod, Turn);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  playing.Player->SetOutputDirectory((files / out).c_str());
  playing.Player->SetPulsesPerBlock(pulsesPerBlock);
  playing.Player->SetWriteWaveforms(true);
  playing.Player->SetWritePulses(true);
  REQUIRE(playing.Player->Run());
  INFO(playing.Log->Warnings);
  CHECK(playing.Log->Warnings.empty());
  CHECK(playing.Player->GetNumberOfPulses() == 2 * 50000);
  return ReadText(files / (out + "/test/leg000_points.xyz")) +
    ReadText(files / (out + "/test/leg000_fullwave.txt")) +
    ReadText(files / (out + "/test/leg000_pulse.txt"));
}

/// Checks between the blocks of the second leg whether a file has its final name.
class NameWatch : public vtkCommand
{
public:
  static NameWatch* New() { return new NameWatch; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    auto* player = static_cast<vtkHeliosSurveyPlayer*>(caller);
    if (player->GetCurrentLeg() == 1)
    {
      ++this->NumberOfLooks;
      this->WasThere = this->WasThere || std::filesystem::exists(this->Name);
    }
  }

  std::string Name;
  int NumberOfLooks = 0;
  bool WasThere = false;
};

} // namespace

TEST_CASE("SurveyChannels: fire at once, in the order of pulses", "[SurveyChannels]")
{
  const Files files;
  AddChannels(files);
  const std::string whole = RunChannels(files, "whole", 262144);
  CHECK(whole == RunChannels(files, "blocks", 7777)); // independent of the block size
  const std::vector<Point> points = ReadPoints(files / "whole/test/leg000_points.xyz");
  REQUIRE(points.size() > 10000);
  double x[2] = {};
  double strongest[2] = {};
  long long last = -1;
  for (const Point& p : points)
  {
    REQUIRE(p.Pulse > last);
    last = p.Pulse;
    const auto channel = static_cast<std::size_t>(p.Pulse % 2); // i n + c
    REQUIRE(p.Time == Approx(static_cast<double>(p.Pulse / 2) / 1e5).margin(1e-9));
    x[channel] += p.X;
    strongest[channel] = std::max(strongest[channel], p.Intensity);
  }
  CHECK(x[0] < x[1]); // the head rotates to the left
  // Each measures the plane at its own wavelength, from the same height.
  CHECK(strongest[0] / strongest[1] == Approx(60.0 / 20.0).epsilon(0.02));

  const std::vector<std::string> pulses = ReadLines(files / "whole/test/leg000_pulse.txt");
  CHECK(pulses.size() > points.size()); // including those into the sky
  CHECK(pulses[0].substr(pulses[0].size() - 4) == " 0 0");
  std::istringstream row(pulses[1]);
  double origin[3];
  row >> origin[0] >> origin[1] >> origin[2];
  CHECK(origin[0] == Approx(0.5)); // the second channel
  CHECK(origin[2] == Approx(3.5));
}

TEST_CASE("SurveyChannels: platform noise is drawn once per shot", "[SurveyChannels]")
{
  const Files files;
  AddChannels(files);
  const Reading reading(
    files, Tripod, Turn + std::string(R"(<positionXNoise stdev="0.3" fixedLifespan="1"/>)"));
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  playing.Player->SetWritePulses(true);
  REQUIRE(playing.Player->Run());
  std::map<long long, std::map<int, double>> origins; // by shot and channel
  for (const std::string& line : ReadLines(files / "out/test/leg000_pulse.txt"))
  {
    double x, unused;
    long long pulse;
    int channel;
    std::istringstream row(line);
    row >> x >> unused >> unused >> unused >> unused >> unused >> unused >> pulse >> channel;
    origins[pulse / 2][channel] = x;
  }
  double spread = 0.0;
  for (const auto& shot : origins)
  {
    REQUIRE(shot.second.size() == 2);
    spread = std::max(spread, std::abs(shot.second.at(1)));
    // 0.5 m to either side of a head that rotates by up to 10 degrees
    REQUIRE(shot.second.at(1) - shot.second.at(0) > 0.98);
    REQUIRE(shot.second.at(1) - shot.second.at(0) < 1.0 + 1e-3);
  }
  CHECK(spread > 1.0);
}

TEST_CASE("SurveyChannels: one file per channel", "[SurveyChannels]")
{
  const Files files;
  AddChannels(files);
  const Reading reading(files, Tripod, Turn);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  playing.Player->SetSplitByChannel(true);
  REQUIRE(playing.Player->Run());
  const auto left = ReadPoints(files / "out/test/leg000_points_devleft.xyz");
  const auto right = ReadPoints(files / "out/test/leg000_points_devright.xyz");
  CHECK(static_cast<vtkIdType>(left.size() + right.size()) == playing.Player->GetCount("points"));
  REQUIRE(!left.empty());
  for (const Point& p : right)
  {
    REQUIRE(p.Pulse % 2 == 1);
  }
  CHECK_FALSE(std::filesystem::exists(files / "out/test/leg000_points.xyz"));
}

TEST_CASE("SurveyChannels: legs of a strip write to one file", "[SurveyChannels]")
{
  const Files files;
  std::string legs = ThreeLegs;
  const Reading apart(files, Flight, legs);
  REQUIRE(apart.Good);
  Playing alone(files, apart);
  alone.Player->SetOutputDirectory((files / "legs").c_str());
  REQUIRE(alone.Player->Run());
  for (std::size_t at = legs.find("<leg>"); at != std::string::npos; at = legs.find("<leg>"))
  {
    legs.replace(at, 5, "<leg stripId=\"7\">");
  }
  for (const char* format : { "xyz", "vtp" })
  {
    INFO(format);
    const Reading joined(files, Flight, legs);
    REQUIRE(joined.Good);
    Playing strip(files, joined);
    strip.Player->SetFormat(format);
    strip.Player->SetOverwrite(true);
    strip.Player->SetPulsesPerBlock(15000);
    strip.Player->GetOptions()->AccuracyReportOff(); // which follows when all files are complete
    const std::string name =
      files / (std::string("out/test/strip007_points.") + (format[0] == 'v' ? "pvtp" : "xyz"));
    vtkNew<NameWatch> watch;
    watch->Name = name;
    strip.Player->AddObserver(vtkCommand::ProgressEvent, watch);
    REQUIRE(strip.Player->Run());
    CHECK(watch->NumberOfLooks > 2);
    CHECK_FALSE(watch->WasThere); // only complete files have final names
    CHECK(strip.Player->GetCount("points") == alone.Player->GetCount("points"));
    if (std::string(format) == "xyz")
    {
      for (const char* ending : { "_points.xyz", "_trajectory.txt" })
      {
        CHECK(ReadText(files / (std::string("out/test/strip007") + ending)) ==
          ReadText(files / (std::string("legs/test/leg000") + ending)) +
            ReadText(files / (std::string("legs/test/leg001") + ending)));
      }
    }
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(files / "out/test"))
    {
      names.insert(entry.path().filename().string());
    }
    INFO(ReadText(files / "out/test/run_summary.json"));
    CHECK(names.count("leg000_points.xyz") == 0);
    CHECK(names.count(std::string("strip007_points.") + (format[0] == 'v' ? "pvtp" : "xyz")) == 1);
  }
}

TEST_CASE("SurveyChannels: a survey with a tripod and an aeroplane", "[SurveyChannels]")
{
  const Files files;
  const std::string flight = R"(<leg platform="assets.xml#plane" scanner="assets.xml#als">)";
  const std::string settings = R"(<scannerSettings scanFreq_hz="50" scanAngle_deg="5"/></leg>)";
  const Reading reading(files, Tripod,
    Turn + flight + R"(<platformSettings z="90" movePerSec_m="50"/>)" + settings + flight +
      R"(<platformSettings x="10" z="90" movePerSec_m="50"/>)" + settings + Turn);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  REQUIRE(playing.Player->Run());
  // 0.5 s at 100 kHz, 0.2 s at 200 kHz, 0.5 s at 100 kHz
  CHECK(playing.Player->GetNumberOfPulses() == 50000 + 40000 + 50000);
  const auto flown = ReadPoints(files / "out/test/leg001_points.xyz");
  REQUIRE(flown.size() == 40000);
  CHECK(flown.front().Time == Approx(0.5)); // after the tripod's leg
  CHECK(flown.front().Pulse == 50000);
  const auto last = ReadPoints(files / "out/test/leg003_points.xyz");
  REQUIRE(!last.empty());
  CHECK(last.front().Time >= 0.7);
  CHECK(last.front().Pulse >= 90000);
  CHECK_FALSE(std::filesystem::exists(files / "out/test/leg002_points.xyz"));
}

TEST_CASE("SurveyChannels: leg offset noise is applied once, by the seed", "[SurveyChannels]")
{
  const Files files;
  const auto run = [&files](const std::string& attributes, vtkIdType seed, bool noise)
  {
    const Reading reading(files, Tripod + attributes, std::string(Turn) + Turn);
    REQUIRE(reading.Good);
    Playing playing(files, reading);
    playing.Player->SetOverwrite(true);
    playing.Player->GetOptions()->SetSeed(seed);
    playing.Player->GetOptions()->SetNoise(noise);
    REQUIRE(playing.Player->Run());
    return ReadLines(files / "out/test/leg000_trajectory.txt").at(0) + "\n" +
      ReadLines(files / "out/test/leg001_trajectory.txt").at(0);
  };
  const std::string offset = R"( legRandomOffset="true" legRandomOffsetMean="3")";
  const std::string still = run("", 1, true);
  CHECK(still.substr(0, 20) == "0.0000 0.0000 2.0000");
  CHECK(run(offset, 1, false) == still);
  const std::string moved = run(offset, 1, true);
  double x, y, z;
  std::istringstream(moved) >> x >> y >> z;
  CHECK(std::abs(x - 3.0) < 0.5); // 5 sigma
  CHECK(std::abs(z - 5.0) < 0.5);
  CHECK(x != y);
  CHECK(moved.substr(0, 20) != moved.substr(moved.find('\n') + 1, 20));
  CHECK(run(offset, 1, true) == moved);
  CHECK(run(offset, 2, true) != moved);
  CHECK(run(offset + " seed=\"2\"", -1, true) == run(offset, 2, true)); // the survey's seed
}

TEST_CASE("SurveyChannels: a value clipped for all channels is reported once", "[SurveyChannels]")
{
  const Files files;
  AddChannels(files);
  const Reading reading(files, Tripod,
    R"(<leg><platformSettings z="2"/><scannerSettings pulseFreq_hz="5000" scanFreq_hz="500"
 headRotatePerSec_deg="20" headRotateStop_deg="10"/></leg>)");
  INFO(reading.Log->Errors << reading.Log->Warnings);
  REQUIRE(reading.Good);
  const std::string& said = reading.Log->Warnings;
  for (const char* warning : { "pulseFreq_hz=\"5000\" is not supported", "is clipped to 120" })
  {
    CAPTURE(warning);
    const std::size_t first = said.find(warning);
    REQUIRE(first != std::string::npos);
    CHECK(said.find(warning, first + 1) == std::string::npos);
  }
}
