// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs of small surveys: their output, and their results.
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveyPlayer.h"

#include "heliosSurveyPlaying.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosLASReader.h"

#include <vtkCommand.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;
namespace names = vtkHeliosArrayNames;
using namespace helios::test;

namespace
{

/// Records a player's messages at progress events, and aborts it after some.
class ProgressLog : public vtkCommand
{
public:
  static ProgressLog* New() { return new ProgressLog; }

  void Execute(vtkObject* caller, unsigned long, void* progress) override
  {
    auto* player = static_cast<vtkHeliosSurveyPlayer*>(caller);
    this->Messages.push_back(player->GetMessage());
    this->Progress.push_back(*static_cast<double*>(progress));
    if (player->GetCount("pulses") >= this->AbortAfter)
    {
      player->Abort();
    }
  }

  std::vector<std::string> Messages;
  std::vector<double> Progress;
  vtkIdType AbortAfter = VTK_ID_MAX;
};

} // namespace

TEST_CASE(
  "SurveyPlayer: legs are contiguous in time, without lost or repeated pulses", "[SurveyPlayer]")
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
  CHECK(player->GetCount("pulses") == 100000);
  CHECK(player->GetCount("points") == 100000);
  CHECK(player->GetCount("firstReturns") == 100000);
  CHECK_FALSE(fs::exists(files / "out/test/leg001_points.xyz"));
  CHECK_FALSE(fs::exists(files / "out/test/leg003_points.xyz"));

  std::ifstream points(files / "out/test/leg002_points.xyz");
  double x, y, z, intensity, width, time;
  long long number, returns, pulse, classification;
  std::string part;
  REQUIRE(points >> x >> y >> z >> intensity >> width >> number >> returns >> pulse >> part >>
    classification >> time);
  CHECK(pulse == 80000);      // continues where the first active leg ended
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

TEST_CASE("SurveyPlayer: byte-identical for any block size", "[SurveyPlayer]")
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
    player->GetOptions()->SetSeed(3);
    player->SetPulsesPerBlock(run == 0 ? 262144 : 777);
    REQUIRE(player->Run());
    texts[run] = ReadText(folder + "/test/leg000_points.xyz");
  }
  CHECK(texts[0].size() > 100000);
  CHECK(texts[0] == texts[1]);
}

TEST_CASE("SurveyPlayer: parts and legs are put on the ground", "[SurveyPlayer]")
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
  player->GetOptions()->SetNoise(false);
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
  CHECK(highest == Approx(30).margin(0.2)); // the wall: 10 m high, moved down from z = -3
}

TEST_CASE("SurveyPlayer: on a tripod time and pulses continue from leg to leg", "[SurveyPlayer]")
{
  const Files files;
  // 100 kHz; 1 s at 10 deg/s, then an inactive leg of 0.5 s, then a leg ended after 0.25 s
  const Reading reading(files, Tripod, R"(<scannerSettings id="s" scanFreq_hz="100"
 headRotatePerSec_deg="10" headRotateStop_deg="10"/>
<leg><scannerSettings template="s"/></leg>
<leg><scannerSettings template="s" active="false" headRotateStop_deg="5"/></leg>
<leg maxDuration_s="0.25"><platformSettings x="3"/><scannerSettings template="s"/></leg>)");
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  REQUIRE(playing.Player->Run());
  CHECK(playing.Player->GetNumberOfPulses() == 125000);
  CHECK(playing.Player->GetCount("pulsesFired") < 125000); // 100 of 240 degrees
  CHECK(playing.Player->GetNumberOfLegs() == 3);
  CHECK(playing.Player->GetCurrentLeg() == 2);
  CHECK(playing.Player->GetProgress() == 1.0);
  const std::vector<Point> first = ReadPoints(files / "out/test/leg000_points.xyz");
  const std::vector<Point> last = ReadPoints(files / "out/test/leg002_points.xyz");
  REQUIRE(!first.empty());
  REQUIRE(!last.empty());
  CHECK(static_cast<vtkIdType>(first.size() + last.size()) == playing.Player->GetCount("points"));
  CHECK_FALSE(fs::exists(files / "out/test/leg001_points.xyz"));
  for (const Point& point : first)
  {
    REQUIRE(point.Time == Approx(static_cast<double>(point.Pulse) / 1e5).margin(1e-9));
  }
  for (const Point& point : last)
  {
    REQUIRE(point.Pulse >= 100000);
    REQUIRE(
      point.Time == Approx(1.5 + static_cast<double>(point.Pulse - 100000) / 1e5).margin(1e-9));
  }
  CHECK(ReadLines(files / "out/test/leg002_trajectory.txt") ==
    std::vector<std::string>{ "3.0000 0.0000 0.0000 1.500000000 0.0000 0.0000 0.0000" });
}

TEST_CASE("SurveyPlayer: a trajectory has the start and the end of its leg", "[SurveyPlayer]")
{
  const Files files;
  std::string legs = ThreeLegs;
  legs.replace(legs.find("scanFreq_hz"), 11, "trajectoryTimeInterval_s=\"0.06\" scanFreq_hz");
  const Reading reading(files, Flight, legs);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  REQUIRE(playing.Player->Run());
  const std::vector<std::string> stepped = ReadLines(files / "out/test/leg000_trajectory.txt");
  REQUIRE(stepped.size() == 5); // 0, 0.06, 0.12, 0.18, 0.2 s
  CHECK(stepped[1].find("3.0000 0.0000 100.0000 0.060000000") == 0);
  CHECK(stepped[4].find("10.0000 0.0000 100.0000 0.200000000") == 0);
  const std::vector<std::string> plain = ReadLines(files / "out/test/leg001_trajectory.txt");
  REQUIRE(plain.size() == 2);
  CHECK(plain[0].find("10.0000 0.0000 100.0000 0.200000000") == 0);
  CHECK(plain[1].find("20.0000 0.0000 100.0000 0.400000000") == 0);
}

TEST_CASE("SurveyPlayer: formats and waveforms", "[SurveyPlayer]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  playing.Player->SetWriteWaveforms(true);
  REQUIRE(playing.Player->Run());
  CHECK(ReadLines(files / "out/test/leg000_points.xyz").size() == 40000);
  CHECK(ReadLines(files / "out/test/leg000_fullwave.txt").size() == 40000);

  // The other format replaces all files of the first run, including the waveforms.
  playing.Player->SetOverwrite(true);
  playing.Player->SetWriteWaveforms(false);
  playing.Player->SetFormat("vtp");
  REQUIRE(playing.Player->Run());
  CHECK(fs::exists(files / "out/test/leg001_points.pvtp"));
  CHECK_FALSE(fs::exists(files / "out/test/leg000_points.xyz"));
  CHECK_FALSE(fs::exists(files / "out/test/leg000_fullwave.txt"));
  CHECK(fs::exists(files / "out/test/leg001_trajectory.pvtp"));
  CHECK_FALSE(fs::exists(files / "out/test/leg000_trajectory.txt"));

  playing.Player->SetFormat("doc");
  playing.CheckFails({ "Format is \"doc\"; give xyz, las, laz, copc or vtp" });
  playing.Player->SetSurvey(nullptr);
  playing.CheckFails({ "Survey is not set" });
}

namespace
{

/// Point format, and the points of a LAS file.
int ReadLas(const std::string& path, vtkHeliosLASReader* reader)
{
  reader->SetFileName(path.c_str());
  reader->ReadWaveformsOn();
  reader->Update();
  return ReadText(path)[104];
}

} // namespace

TEST_CASE(
  "SurveyPlayer: LAS points of format 6, and beside them those with waveforms", "[SurveyPlayer]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  playing.Player->SetFormat("las");
  playing.Player->SetWriteWaveforms(true);
  REQUIRE(playing.Player->Run());
  const std::string leg = files / "out/test/leg000";
  vtkNew<vtkHeliosLASReader> points;
  vtkNew<vtkHeliosLASReader> waves;
  CHECK(ReadLas(leg + "_points.las", points) == 6);
  CHECK(ReadLas(leg + "_fullwave.las", waves) == 9);
  CHECK_FALSE(fs::exists(leg + "_points.wdp"));
  CHECK(fs::exists(leg + "_fullwave.wdp"));
  CHECK(vtkTable::SafeDownCast(points->GetOutputDataObject(1))->GetNumberOfRows() == 0);
  CHECK(vtkTable::SafeDownCast(waves->GetOutputDataObject(1))->GetNumberOfRows() == 40000);
  REQUIRE(points->GetOutput()->GetNumberOfPoints() == waves->GetOutput()->GetNumberOfPoints());
  vtkPointData* data = points->GetOutput()->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* other = waves->GetOutput()->GetPointData()->GetArray(data->GetArrayName(i));
    INFO(data->GetArrayName(i));
    REQUIRE(other);
    for (vtkIdType row = 0; row < other->GetNumberOfTuples(); row += 997)
    {
      REQUIRE(other->GetComponent(row, 0) == data->GetArray(i)->GetComponent(row, 0));
    }
  }
}

TEST_CASE(
  "SurveyPlayer: scan flags always in LAS, in text and VTK XML on request", "[SurveyPlayer]")
{
  const Files files;
  files.Replace("assets.xml", "optics=\"conic\"", "optics=\"oscillating\"");
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  const std::string leg = files / "out/test/leg000";
  REQUIRE(playing.Player->Run());
  const std::vector<std::string> plain = ReadLines(leg + "_points.xyz");
  playing.Player->SetOverwrite(true);
  playing.Player->SetFormat("las");
  REQUIRE(playing.Player->Run());
  vtkNew<vtkHeliosLASReader> las;
  ReadLas(leg + "_points.las", las);
  vtkPointData* data = las->GetOutput()->GetPointData();
  playing.Player->SetFormat("xyz");
  playing.Player->WriteScanFlagsOn();
  REQUIRE(playing.Player->Run());
  const std::vector<std::string> flagged = ReadLines(leg + "_points.xyz");
  REQUIRE(flagged.size() == plain.size());
  REQUIRE(flagged.size() == static_cast<std::size_t>(las->GetOutput()->GetNumberOfPoints()));
  double edges = 0.0;
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    const auto get = [data, i](const char* name)
    { return data->GetArray(name)->GetComponent(static_cast<vtkIdType>(i), 0); };
    const double direction = get(names::ScanDirectionFlag);
    const double edge = get(names::EdgeOfFlightLine);
    REQUIRE(flagged[i] == plain[i] + (direction > 0.0 ? " 1" : " 0") + (edge > 0.0 ? " 1" : " 0"));
    edges += edge;
  }
  CHECK(edges > 1.0);
  CHECK(edges < 0.1 * static_cast<double>(plain.size()));
  playing.Player->SetFormat("vtp");
  for (const bool isOn : { true, false })
  {
    playing.Player->SetWriteScanFlags(isOn);
    REQUIRE(playing.Player->Run());
    const std::string piece = ReadText(leg + "_points_0000.vtp");
    CHECK((piece.find("\"EdgeOfFlightLine\"") != std::string::npos) == isOn);
    CHECK((piece.find("\"ScanDirectionFlag\"") != std::string::npos) == isOn);
  }
}

TEST_CASE("SurveyPlayer: decibels in text, VTK XML and LAS on request", "[SurveyPlayer]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  const std::string leg = files / "out/test/leg000";
  playing.Player->SetOverwrite(true);
  playing.Player->WriteDecibelsOn();
  REQUIRE(playing.Player->Run());
  const std::vector<std::string> text = ReadLines(leg + "_points.xyz");
  playing.Player->SetFormat("las");
  REQUIRE(playing.Player->Run());
  vtkNew<vtkHeliosLASReader> las;
  ReadLas(leg + "_points.las", las);
  vtkPointData* data = las->GetOutput()->GetPointData();
  for (const char* name : { names::RelativeAmplitude, names::Reflectance, names::Amplitude })
  {
    REQUIRE(data->HasArray(name));
  }
  REQUIRE(text.size() == static_cast<std::size_t>(las->GetOutput()->GetNumberOfPoints()));
  std::istringstream words(text[7]);
  std::vector<double> numbers(15);
  std::string part;
  for (std::size_t i = 0; i < 15; ++i)
  {
    i == 8 ? words >> part : words >> numbers[i];
  }
  REQUIRE(words);
  const double threshold = reading.Data().Scanners[0].Receiver.DetectionThreshold;
  const double amplitude = data->GetArray(names::Amplitude)->GetTuple1(7);
  const double decibels = data->GetArray(names::RelativeAmplitude)->GetTuple1(7);
  CHECK(decibels == Approx(10.0 * std::log10(amplitude / threshold)).epsilon(1e-12));
  CHECK(numbers[13] == Approx(decibels).margin(6e-5));
  CHECK(numbers[14] == Approx(data->GetArray(names::Reflectance)->GetTuple1(7)).margin(6e-5));
  playing.Player->SetFormat("vtp");
  for (const bool isOn : { true, false })
  {
    playing.Player->SetWriteDecibels(isOn);
    REQUIRE(playing.Player->Run());
    const std::string piece = ReadText(leg + "_points_0000.vtp");
    CHECK((piece.find("\"Reflectance\"") != std::string::npos) == isOn);
  }
}

TEST_CASE("SurveyPlayer: points as LAS with their waveforms", "[SurveyPlayer]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  playing.Player->SetFormat("las");
  playing.Player->SetWriteWaveforms(true);
  playing.Player->WaveformsInPointsOn();
  REQUIRE(playing.Player->Run());
  CHECK(fs::exists(files / "out/test/leg000_trajectory.txt"));
  vtkIdType sum = 0;
  for (const int leg : { 0, 1 })
  {
    vtkNew<vtkHeliosLASReader> las;
    las->SetFileName((files / ("out/test/leg00" + std::to_string(leg) + "_points.las")).c_str());
    las->ReadWaveformsOn();
    las->Update();
    vtkPolyData* cloud = las->GetOutput();
    REQUIRE(cloud->GetNumberOfPoints() > 0);
    sum += cloud->GetNumberOfPoints();
    for (const char* name : { names::PulseIds, names::Range, names::Amplitude, names::PartIds })
    {
      CHECK(cloud->GetPointData()->HasArray(name));
    }
    double legs[2];
    cloud->GetPointData()->GetArray(names::LegIds)->GetRange(legs);
    CHECK((legs[0] == leg && legs[1] == leg));
    auto* waveforms = vtkTable::SafeDownCast(las->GetOutputDataObject(1));
    double pulses[2];
    cloud->GetPointData()->GetArray(names::WaveformIds)->GetRange(pulses);
    REQUIRE(waveforms->GetNumberOfRows() > 0);
    CHECK(waveforms->GetValueByName(0, names::PulseIds).ToDouble() == pulses[0]);
  }
  CHECK(sum == playing.Player->GetCount("points"));
  CHECK_FALSE(fs::exists(files / "out/test/leg000_fullwave.las"));

  playing.Player->SetOverwrite(true);
  playing.Player->SetWriteWaveforms(false);
  REQUIRE(playing.Player->Run());
  CHECK(fs::exists(files / "out/test/leg000_points.las"));
  CHECK_FALSE(fs::exists(files / "out/test/leg000_points.wdp"));
}

TEST_CASE("SurveyPlayer: noise can be switched off, and depends on the seed", "[SurveyPlayer]")
{
  const Files files;
  const Reading reading(files, Tripod, OneLeg);
  std::vector<std::string> texts;
  for (const int run : { 0, 1, 2 })
  {
    Playing playing(files, reading);
    playing.Player->SetOverwrite(true);
    playing.Player->GetOptions()->SetNoise(run > 0);
    playing.Player->GetOptions()->SetSeed(run);
    REQUIRE(playing.Player->Run());
    texts.push_back(ReadText(files / "out/test/leg000_points.xyz"));
  }
  CHECK(texts[0] != texts[1]);
  CHECK(texts[1] != texts[2]);
}

TEST_CASE("SurveyPlayer: a file with several parts is read once", "[SurveyPlayer]")
{
  const Files files;
  files.Replace("scene.xml", "</scene>", R"(<part id="shelf"><filter type="objloader">
<param key="filepath" value="plane.obj"/></filter><filter type="translate">
<param key="offset" value="60;0;20"/></filter></part></scene>)");
  const Reading reading(files, Flight, ThreeLegs);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  vtkNew<ProgressLog> log;
  playing.Player->AddObserver(vtkCommand::ProgressEvent, log);
  REQUIRE(playing.Player->Run());
  const auto isReading = [](const std::string& message) { return message.find("reading") == 0; };
  CHECK(std::count_if(log->Messages.begin(), log->Messages.end(), isReading) == 1);
  CHECK(std::is_sorted(log->Progress.begin(), log->Progress.end()));
  CHECK(log->Progress.back() == 1.0);
  // At 5 degrees incidence, cut by the shelf's edge: 1.5 times 0.15 mrad at 100.4 m times tan(5
  // deg).
  const double halfFootprint = 1.5 * 0.15e-3 * 100.4 * 0.0875 + 5e-5;
  for (const Point& point : ReadPoints(files / "out/test/leg000_points.xyz"))
  {
    REQUIRE(point.Part == (point.Z > 10.0 ? "shelf" : "floor"));
    REQUIRE(point.Z == Approx(point.Part == "shelf" ? 20.0 : 0.0).margin(halfFootprint));
  }
}

TEST_CASE("SurveyPlayer: several files of one part are one part", "[SurveyPlayer]")
{
  const Files files;
  files.Write("more/a.obj", "v -50 -50 0\nv 0 -50 0\nv 0 50 0\nv -50 50 0\nf 1 2 3 4\n");
  files.Write("more/b.obj", "v 0 -50 0\nv 50 -50 0\nv 50 50 0\nv 0 50 0\nf 1 2 3 4\n");
  files.Replace("scene.xml", "\"filepath\" value=\"plane.obj\"", "\"efilepath\" value=\"more/.*\"");
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  REQUIRE(playing.Player->Run());
  const std::vector<Point> points = ReadPoints(files / "out/test/leg000_points.xyz");
  CHECK(points.size() == 40000); // the halves cover the floor
  const auto isFloor = [](const Point& point) { return point.Part == "floor"; };
  CHECK(std::all_of(points.begin(), points.end(), isFloor));
}

TEST_CASE("SurveyPlayer: reflectance from a spectrum", "[SurveyPlayer]")
{
  const Files files;
  files.Write("plane.mtl", "newmtl m\nKd 1 1 1\nhelios_spectra moss\n");
  files.Replace("plane.obj", "v -50", "mtllib plane.mtl\nusemtl m\nv -50");
  // 1064 nm is at 0.64 between 20 and 30 %
  const std::string header =
    "Name: Moss\nX Units: Wavelength (micrometers)\nFirst X Value: 0.5\n\n";
  files.Write("spectra/moss.txt", header + "0.5\t10\t\n1.0\t20\n1.1\t30\r\n2.5\t90\n");
  const Reading reading(files, Flight, ThreeLegs);
  const auto intensity = [&files, &reading](const std::string& warning)
  {
    Playing playing(files, reading);
    playing.Player->SetOverwrite(true);
    REQUIRE(playing.Player->Run());
    INFO(playing.Log->Warnings);
    CHECK(playing.Log->HasWarning(warning));
    CHECK(playing.Log->Warnings.empty() == warning.empty());
    return ReadPoints(files / "out/test/leg000_points.xyz").front().Intensity;
  };
  const double from = intensity("");
  files.Write("spectra/moss.txt", header + "0.3 0\n1.0 50\n"); // ends before: its last value
  CHECK(intensity("") == Approx(from * 0.5 / 0.264).epsilon(1e-6));
  files.Write("spectra/moss.txt", header + "1.5 40\n2 0\n"); // starts beyond: its first value
  CHECK(intensity("") == Approx(from * 0.4 / 0.264).epsilon(1e-6));
  files.Write("spectra/moss.txt", header);
  CHECK(intensity("has no rows") == Approx(from * 0.5 / 0.264).epsilon(1e-6));
  files.Write("spectra/moss.txt", header + "2 10\n1 20\n");
  CHECK(intensity("do not ascend") == Approx(from * 0.5 / 0.264).epsilon(1e-6));
  files.Write("spectra/moss.txt", header + "0.5 10\n1.0 2x\n\n1.1 30\n");
  CHECK(intensity("moss.txt:6) has \"1.0 2x\" among its rows, which is not a wavelength") ==
    Approx(from * 0.5 / 0.264).epsilon(1e-6));
  files.Write("spectra/moss.txt", header + "0.5 10\n1.0.2\n");
  CHECK(intensity("moss.txt:6) has \"1.0.2\" among its rows") ==
    Approx(from * 0.5 / 0.264).epsilon(1e-6));
  files.Write("spectra/moss.txt", "Name: moss\n0.5 +10\n1.1 30\n");
  CHECK(intensity("moss.txt:2) has \"0.5 +10\" among its rows") ==
    Approx(from * 0.5 / 0.264).epsilon(1e-6));
  files.Write("spectra/moss.txt", header + "2 101\n");
  CHECK(intensity("outside 0 to 100 %") == Approx(from * 0.5 / 0.264).epsilon(1e-6));
  fs::remove(files / "spectra/moss.txt");
  fs::create_symlink("/proc/self/status", files / "spectra/moss.txt");
  CHECK(intensity("cannot be read: it is a file of the kernel") ==
    Approx(from * 0.5 / 0.264).epsilon(1e-6));
  fs::remove(files / "spectra/moss.txt");
  CHECK(intensity("Spectrum moss was not found in") == Approx(from * 0.5 / 0.264).epsilon(1e-6));
  files.Write("plane.mtl", "newmtl m\nKd 1 1 1\nhelios_spectra moss\nhelios_reflectance 0.1\n");
  CHECK(intensity("") == Approx(from * 0.1 / 0.264).epsilon(1e-6)); // a given value has priority
}

TEST_CASE("SurveyPlayer: output that cannot be written is an error", "[SurveyPlayer]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  playing.Player->SetOutputDirectory((files / "plane.obj/below").c_str());
  playing.CheckFails({ "plane.obj/below", "cannot be created", "OutputDirectory" });
  playing.Player->SetOutputDirectory((files / "out").c_str());
  files.Write("out/test", "a file");
  playing.CheckFails({ "out/test: the output folder cannot be created" });
}

TEST_CASE("SurveyPlayer: an earlier run is kept, also if the new one fails early", "[SurveyPlayer]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  files.Write("out/test/leg000_points.xyz.part", "earlier");
  files.Write("out/test/notes.txt", "mine");
  playing.CheckFails({ "out/test: holds the files of an earlier run", "Overwrite" });
  playing.Player->SetOverwrite(true);
  files.Write("plane.obj", "v a b c\n");
  playing.CheckFails({ "plane.obj:1" });
  CHECK(ReadText(files / "out/test/leg000_points.xyz.part") == "earlier");
  files.Write("plane.obj", ReadText(Files() / "plane.obj"));
  CHECK(playing.Player->Run());
  CHECK_FALSE(fs::exists(files / "out/test/leg000_points.xyz.part"));
  CHECK(ReadText(files / "out/test/notes.txt") == "mine");
}

TEST_CASE("SurveyPlayer: a run without points reports the reason", "[SurveyPlayer]")
{
  const Files files;
  SECTION("no leg is active")
  {
    const Reading reading(files, Tripod, "<leg><scannerSettings active=\"false\"/></leg>");
    Playing(files, reading).CheckFails({ "No points: no leg fires a pulse", "active=\"true\"" });
  }
  SECTION("no pulse leaves the scanner")
  {
    files.Replace("assets.xml", "scanAngleEffectiveMax_deg=\"50\"", "");
    std::string leg = OneLeg;
    leg.replace(leg.find("scanFreq_hz"), 11,
      "verticalAngleMin_deg=\"130\" verticalAngleMax_deg=\"140\" scanFreq_hz");
    const Reading reading(files, Tripod, leg);
    Playing(files, reading)
      .CheckFails({ "No points: no pulse left the scanner", "verticalAngleMin" });
  }
  SECTION("no pulse hits the scene")
  {
    std::string legs = ThreeLegs;
    legs.replace(legs.find("z=\"100\""), 7, "z=\"-100\"")
      .replace(legs.find("z=\"100\""), 7, "z=\"-100\"");
    legs.replace(legs.find("z=\"100\""), 7, "z=\"-100\"");
    const Reading reading(files, Flight, legs);
    Playing(files, reading)
      .CheckFails({ "No points: none of 80000 pulses hit the scene", "x -50 to 50", "z 0 to 0",
        "leg 0 starts at 0, 0, -100" });
  }
  SECTION("all points too near")
  {
    files.Replace("assets.xml", "id=\"als\"", "id=\"als\" rangeMin_m=\"500\"");
    const Reading reading(files, Flight, ThreeLegs);
    Playing(files, reading)
      .CheckFails({ "No points: every surface hit is nearer than rangeMin_m=\"500\"" });
  }
  SECTION("all signals too weak")
  {
    files.Replace("assets.xml", "id=\"als\"", "id=\"als\" receivedEnergyMin_W=\"1e9\"");
    const Reading reading(files, Flight, ThreeLegs);
    Playing(files, reading)
      .CheckFails(
        { "No points: the strongest of 80000 returns", "below the detection threshold of 1 W" });
  }
}

TEST_CASE("SurveyPlayer: scenes that cannot be composed are errors", "[SurveyPlayer]")
{
  const Files files;
  SECTION("all parts on a missing ground")
  {
    files.Replace("scene.xml", "</part>",
      "<filter type=\"translate\"><param key=\"onGround\" value=\"1\"/></filter></part>");
    const Reading reading(files, Flight, ThreeLegs);
    Playing(files, reading).CheckFails({ "scene.xml:1", "every part has onGround" });
  }
  SECTION("a ground without triangles")
  {
    files.Write("empty.obj", "v 0 0 0\n");
    files.Replace("scene.xml", "</scene>", R"(
<part><filter type="objloader"><param key="filepath" value="plane.obj"/></filter>
<filter type="translate"><param key="onGround" value="1"/></filter></part></scene>)");
    files.Replace("scene.xml", "plane.obj", "empty.obj");
    const Reading reading(files, Flight, ThreeLegs);
    Playing(files, reading)
      .CheckFails({ "scene.xml:1: The scene is empty: none of its 1 parts has triangles" });
  }
  SECTION("a part outside the ground")
  {
    files.Replace("scene.xml", "</scene>", R"(
<part><filter type="objloader"><param key="filepath" value="plane.obj"/></filter>
<filter type="translate"><param key="offset" value="500;0;0"/><param key="onGround" value="1"/></filter>
</part></scene>)");
    const Reading reading(files, Flight, ThreeLegs);
    REQUIRE(reading.Good);
    Playing playing(files, reading);
    CHECK_FALSE(playing.Player->Run());
    CHECK(
      playing.Log->HasError("scene.xml:4: part 1 is on the ground, but there is no ground above "
                            "or below its lowest corner at x 450, y -50; move the part"));
  }
  SECTION("a leg outside the ground")
  {
    std::string leg = OneLeg;
    leg.replace(leg.find("x=\"1\""), 5, "x=\"99\" onGround=\"true\"");
    const Reading reading(files, Tripod, leg);
    Playing playing(files, reading);
    CHECK_FALSE(playing.Player->Run());
    CHECK(playing.Log->HasError("no ground above or below point 0 at x 99, y 2"));
    CHECK(playing.Log->HasError("survey.xml: legs with onGround"));
  }
  SECTION("no geometry")
  {
    files.Write("plane.obj", "");
    const Reading reading(files, Flight, ThreeLegs);
    Playing playing(files, reading);
    CHECK_FALSE(playing.Player->Run());
    CHECK_FALSE(playing.Log->Errors.empty());
  }
}

TEST_CASE("SurveyPlayer: a stopped run keeps its data", "[SurveyPlayer]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  vtkNew<ProgressLog> log;
  playing.Player->AddObserver(vtkCommand::ProgressEvent, log);
  playing.Player->SetPulsesPerBlock(10000);
  SECTION("in its second leg")
  {
    log->AbortAfter = 50000;
    CHECK_FALSE(playing.Player->Run());
    CHECK(playing.Log->Errors.empty());
    CHECK(playing.Player->GetMessage().find(
            "Stopped after 50000 of 80000 pulses; the 50000 points") == 0);
    CHECK(playing.Player->GetMessage().find("out/test") != std::string::npos);
    CHECK(ReadPoints(files / "out/test/leg000_points.xyz").size() == 40000);
    CHECK(ReadPoints(files / "out/test/leg001_points.xyz.part").size() == 10000);
    CHECK_FALSE(fs::exists(files / "out/test/leg001_points.xyz"));
  }
  SECTION("during loading")
  {
    log->AbortAfter = 0;
    CHECK_FALSE(playing.Player->Run());
    CHECK(playing.Log->Errors.empty());
    CHECK(playing.Player->GetMessage().find("nothing was written") != std::string::npos);
  }
  SECTION("after the last pulse: complete")
  {
    log->AbortAfter = 80000;
    CHECK(playing.Player->Run());
  }
}
