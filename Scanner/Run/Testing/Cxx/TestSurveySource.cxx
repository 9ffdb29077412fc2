// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Surveys in memory: the same echoes as by a player, in any parts.
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveySource.h"

#include "heliosSurveyPlaying.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <vector>

namespace names = vtkHeliosArrayNames;
using helios::ErrorObserver;
using namespace helios::test;

namespace fs = std::filesystem;

namespace
{

/// Two tripods: 100,000 pulses each.
const char* const TwoLegs = R"(<leg><platformSettings x="1" y="2" z="3"/>
<scannerSettings scanFreq_hz="50" headRotatePerSec_deg="10" headRotateStop_deg="10"/></leg>
<leg><platformSettings x="-4" y="2" z="3"/>
<scannerSettings scanFreq_hz="50" headRotatePerSec_deg="10" headRotateStop_deg="10"/></leg>)";

/// Two lasers on one head.
const char* const TwoChannels = R"(<document><scanner id="two" optics="conic" pulseFreqs_Hz="20000"
 scanAngleMax_deg="20" scanFreqMax_Hz="80"><channels><channel id="0"/>
<channel id="1"><beamOrigin x="0" y="0" z="0.1"/></channel></channels></scanner></document>)";

struct Source
{
  vtkNew<vtkHeliosSurveySource> Filter;
  vtkSmartPointer<ErrorObserver> Log = Observe(Filter);

  explicit Source(const Reading& reading) { this->Filter->SetSurvey(reading.Reader->GetSurvey()); }

  vtkSmartPointer<vtkPolyData> Run(vtkIdType first, vtkIdType last)
  {
    this->Filter->SetPulseWindow(first, last);
    this->Filter->Update();
    vtkSmartPointer<vtkPolyData> echoes = vtkSmartPointer<vtkPolyData>::New();
    echoes->ShallowCopy(this->Filter->GetOutput());
    return echoes;
  }
};

/// The values of an array component of all echoes.
std::vector<double> Get(vtkPolyData* echoes, const char* name, int component = 0)
{
  vtkDataArray* array = echoes->GetPointData()->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, component));
  }
  return values;
}

std::vector<double> Join(std::vector<double> a, const std::vector<double>& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

class CountProgress : public vtkCommand
{
public:
  static CountProgress* New() { return new CountProgress; }

  void Execute(vtkObject* caller, unsigned long, void*) override
  {
    if (++this->Events == this->AbortAt)
    {
      static_cast<vtkHeliosSurveySource*>(caller)->Abort();
    }
  }

  int Events = 0;
  int AbortAt = -1;
};

} // namespace

TEST_CASE("SurveySource: the same echoes as the player", "[SurveySource]")
{
  const Files files;
  const Reading reading(files, Tripod, TwoLegs);
  REQUIRE(reading.Good);
  Playing playing(files, reading);
  REQUIRE(playing.Player->Run());
  std::vector<Point> written = ReadPoints(files / "out/test/leg000_points.xyz");
  const std::size_t ofFirst = written.size();
  for (const Point& point : ReadPoints(files / "out/test/leg001_points.xyz"))
  {
    written.push_back(point);
  }

  Source source(reading);
  const auto echoes = source.Run(0, VTK_ID_MAX);
  INFO(source.Log->Errors);
  REQUIRE(static_cast<std::size_t>(echoes->GetNumberOfPoints()) == written.size());
  CHECK(source.Filter->GetNumberOfPulses() == playing.Player->GetNumberOfPulses());
  const std::vector<double> pulses = Get(echoes, names::PulseIds);
  const std::vector<double> legs = Get(echoes, names::LegIds);
  bool isSame = true;
  for (std::size_t i = 0; i < written.size(); ++i)
  {
    double p[3];
    echoes->GetPoint(static_cast<vtkIdType>(i), p);
    isSame = isSame && static_cast<double>(written[i].Pulse) == pulses[i] &&
      std::abs(p[0] - written[i].X) < 1e-4 && std::abs(p[1] - written[i].Y) < 1e-4 &&
      std::abs(p[2] - written[i].Z) < 1e-4 && legs[i] == (i < ofFirst ? 0.0 : 1.0);
  }
  CHECK(isSame);
}

TEST_CASE("SurveySource: windows and pieces equal the whole, byte for byte", "[SurveySource]")
{
  const Files files;
  const Reading reading(files, Tripod, TwoLegs);
  Source source(reading);
  const auto whole = source.Run(0, VTK_ID_MAX);
  const auto first = source.Run(0, 33333);
  const auto second = source.Run(33333, 133333); // the end of one leg and the start of the next
  const auto third = source.Run(133333, VTK_ID_MAX);
  for (const char* name : { names::GpsTime, names::Range, names::Amplitude, names::PulseIds })
  {
    CAPTURE(name);
    CHECK(Get(whole, name) == Join(Join(Get(first, name), Get(second, name)), Get(third, name)));
  }
  source.Filter->SetPulseWindow(0, VTK_ID_MAX);
  std::vector<double> ranges;
  for (int piece = 0; piece < 3; ++piece)
  {
    source.Filter->UpdatePiece(piece, 3, 0);
    ranges = Join(ranges, Get(source.Filter->GetOutput(), names::Range));
  }
  CHECK(ranges == Get(whole, names::Range));
}

TEST_CASE("SurveySource: one pulse with all outputs", "[SurveySource]")
{
  const Files files;
  const Reading reading(files, Tripod, TwoLegs);
  Source source(reading);
  const auto whole = source.Run(0, VTK_ID_MAX);
  const auto pulse = static_cast<vtkIdType>(Get(whole, names::PulseIds)[500]);
  source.Filter->GenerateWaveformsOn();
  source.Filter->GeneratePulsesOn();
  source.Filter->GenerateSubRaysOn();
  source.Filter->GenerateTruthOn();
  const auto echo = source.Run(pulse, pulse + 1);
  REQUIRE(echo->GetNumberOfPoints() == 1);
  CHECK(Get(echo, names::Range)[0] == Get(whole, names::Range)[500]);
  CHECK(Get(echo, names::TruePoint).size() == 1);
  auto* waveforms = vtkTable::SafeDownCast(source.Filter->GetOutputDataObject(1));
  CHECK(waveforms->GetNumberOfRows() == 1);
  auto* pulses = vtkPolyData::SafeDownCast(source.Filter->GetOutputDataObject(2));
  CHECK(pulses->GetNumberOfPoints() == 1);
  auto* hits = vtkPolyData::SafeDownCast(source.Filter->GetOutputDataObject(3));
  CHECK(hits->GetNumberOfPoints() == 7); // beamSampleQuality 2
  CHECK(source.Filter->GetPulseTime(pulse) == Get(echo, names::GpsTime)[0]);

  source.Filter->GenerateWaveformsOff();
  source.Filter->GenerateSubRaysOff();
  CAPTURE(pulse, source.Log->Errors);
  CHECK(source.Run(pulse, pulse + 1)->GetNumberOfPoints() == 1);
  CHECK(vtkTable::SafeDownCast(source.Filter->GetOutputDataObject(1))->GetNumberOfRows() == 0);
  CHECK(vtkPolyData::SafeDownCast(source.Filter->GetOutputDataObject(3))->GetNumberOfPoints() == 0);
}

TEST_CASE("SurveySource: pulses of a leg by time", "[SurveySource]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Source source(reading);
  CHECK(source.Filter->GetScene() == nullptr);
  CHECK(source.Filter->GetNumberOfPulses() == 0);
  REQUIRE(source.Filter->Load());
  CHECK(source.Filter->GetScene()->GetNumberOfPolys() == 2);
  CHECK(source.Filter->GetNumberOfPulses() == 80000);
  vtkIdType ids[2];
  double times[2];
  source.Filter->GetLegPulses(1, ids);
  source.Filter->GetLegTimes(1, times);
  CHECK(ids[0] == 40000);
  CHECK(ids[1] == 80000);
  CHECK(times[0] == Approx(0.2)); // 10 m at 50 m/s
  CHECK(times[1] == Approx(0.4));
  source.Filter->GetLegPulses(2, ids); // an end point
  CHECK(ids[0] == ids[1]);
  CHECK(source.Filter->GetLegPulseLength(1) == 4.0); // the default
  CHECK(source.Filter->GetLegPulseLength(2) == 0.0);
  CHECK(source.Filter->GetPulseTime(50000) == Approx(0.25)); // at 200 kHz
  CHECK(source.Filter->FindPulse(0.25) == 50000);
  CHECK(source.Filter->FindPulse(-1.0) == 0);
  CHECK(source.Filter->FindPulse(9.0) == 80000);
  const auto way = source.Filter->GetTrajectory(1, 0.05);
  REQUIRE(way->GetNumberOfPoints() == 5);
  CHECK(way->GetNumberOfLines() == 1);
  CHECK(way->GetPoint(2)[0] == Approx(15.0));
  CHECK(source.Filter->GetTrajectory(2, 0.05) == nullptr);
}

TEST_CASE("SurveySource: windows contain complete shots of channels", "[SurveySource]")
{
  const Files files;
  files.Write("two.xml", TwoChannels);
  const Reading reading(files, R"(platform="assets.xml#plane" scanner="two.xml#two")", ThreeLegs);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  Source source(reading);
  const auto whole = source.Run(0, VTK_ID_MAX);
  CHECK(source.Filter->GetNumberOfPulses() == 16000);
  CHECK(source.Filter->FindPulse(source.Filter->GetPulseTime(4001)) == 4000);
  const auto a = source.Run(0, 4001); // with pulse 4001, of the same shot as pulse 4000
  CHECK(Get(a, names::PulseIds).back() == 4001.0);
  const auto b = source.Run(4001, VTK_ID_MAX);
  CHECK(Get(b, names::PulseIds).front() == 4002.0);
  CHECK(Get(whole, names::Range) == Join(Get(a, names::Range), Get(b, names::Range)));
}

TEST_CASE("SurveySource: parts have moved at the time of the window", "[SurveySource]")
{
  const Files files;
  files.Replace("scene.xml", "</part>",
    R"(<dmotion id="all" loop="0"><motion type="translation" vec="0;0;0.01"/></dmotion></part>)");
  files.Replace("scene.xml", "<scene id=\"s\"", "<scene id=\"s\" dynStep=\"100\"");
  const Reading reading(files, Flight, ThreeLegs);
  REQUIRE(reading.Good);
  Source source(reading);
  source.Filter->GetOptions()->NoiseOff();
  const auto part = source.Run(39950, 40150); // across the end of a leg and a step
  REQUIRE(part->GetNumberOfPoints() == 200);
  const std::vector<double> pulses = Get(part, names::PulseIds);
  CHECK(pulses.front() == 39950.0);
  bool isThere = true;
  for (vtkIdType i = 0; i < 200; ++i)
  {
    const double z = 0.01 * std::floor(pulses[static_cast<std::size_t>(i)] / 100.0);
    isThere = isThere && std::abs(part->GetPoint(i)[2] - z) < 1e-3;
  }
  CHECK(isThere);
}

TEST_CASE("SurveySource: unchanged scenes are not loaded again", "[SurveySource]")
{
  const Files files;
  const Reading reading(files, Tripod, OneLeg);
  Source source(reading);
  source.Run(0, 10);
  vtkPolyData* scene = source.Filter->GetScene();
  source.Filter->GetOptions()->NoiseOff();
  source.Filter->GenerateTruthOn();
  source.Run(10, 20);
  CHECK(source.Filter->GetScene() == scene);
  source.Filter->GetOptions()->SetSeed(7); // random materials depend on it
  source.Run(10, 20);
  CHECK(source.Filter->GetScene() != scene);
  files.Write("plane.obj", "v -50 -50 1\nv 50 -50 1\nv 50 50 1\nf 1 2 3\n");
  source.Filter->Modified();
  source.Run(10, 20);
  CHECK(source.Filter->GetScene()->GetNumberOfPolys() == 1);
}

TEST_CASE("SurveySource: fingerprints tell changed files and options", "[SurveySource]")
{
  const Files files;
  const Reading reading(files, Tripod, OneLeg);
  Source source(reading);
  const std::string before = source.Filter->GetFingerprint();
  CHECK(source.Filter->GetScene() == nullptr); // not loaded
  CHECK(before.find("sha256") != std::string::npos);
  CHECK(source.Filter->CompareFingerprint(before).empty());
  source.Filter->GetOptions()->SetSeed(7);
  CHECK(source.Filter->CompareFingerprint(before).find("is 7") != std::string::npos);
  source.Filter->GetOptions()->SetSeed(-1);
  files.Write("plane.obj", "v -50 -50 1\nv 50 -50 1\nv 50 50 1\nf 1 2 3\n");
  CHECK(
    source.Filter->CompareFingerprint(before).find("plane.obj has changed") != std::string::npos);
  CHECK(source.Filter->CompareFingerprint("{") == "the other fingerprint is not valid");
  CHECK(source.Filter->CompareFingerprint(R"({"inputs": [7]})").find("is not valid: ") !=
    std::string::npos);
  CHECK(source.Log->Errors.empty());
  source.Filter->GetOptions()->SetEpoch(3);
  CHECK(source.Filter->GetFingerprint().empty());
  CHECK(source.Log->HasError("Epoch is 3, but the survey has 1 epoch"));
  CHECK(source.Filter->CompareFingerprint(before) == "the survey is not valid");
}

TEST_CASE(
  "SurveySource: loaded fingerprints have the files that other files name", "[SurveySource]")
{
  const Files files;
  files.Write("plane.mtl", "newmtl m\nKd 1 1 1\nhelios_spectra moss\n");
  files.Replace("plane.obj", "v -50", "mtllib plane.mtl\nusemtl m\nv -50");
  files.Write("spectra/moss.txt", "0.5 10\n2.5 90\n");
  const Reading reading(files, Tripod, OneLeg);
  Source source(reading);
  Source other(reading);
  const std::string before = source.Filter->ComputeLoadedFingerprint();
  CHECK(source.Filter->GetScene() != nullptr);
  for (const char* name : { "plane.obj", "plane.mtl", "moss.txt" })
  {
    CHECK(before.find(name) != std::string::npos);
    CHECK((source.Filter->GetFingerprint().find(name) != std::string::npos) ==
      (name == std::string("plane.obj")));
  }
  CHECK(source.Filter->ComputeLoadedFingerprint() == before);
  CHECK(other.Filter->CompareFingerprint(before).empty());
  CHECK(source.Filter->CompareFingerprint(other.Filter->GetFingerprint()).empty());
  const auto time = fs::last_write_time(files / "spectra/moss.txt");
  files.Write("spectra/moss.txt", "0.5 20\n2.5 90\n");
  fs::last_write_time(files / "spectra/moss.txt", time);
  CHECK(other.Filter->CompareFingerprint(before) == files / "spectra/moss.txt" + " has changed");
  source.Filter->Modified();
  source.Run(0, 10); // reads it again
  CHECK(source.Filter->CompareFingerprint(before) == files / "spectra/moss.txt" + " has changed");
  const vtkSmartPointer<vtkPolyData> scene = source.Filter->GetScene();
  const auto timeOfMaterial = fs::last_write_time(files / "plane.mtl");
  files.Write("plane.mtl", "newmtl m\nKd 1 1 1\nhelios_spectra mess\n");
  fs::last_write_time(files / "plane.mtl", timeOfMaterial);
  source.Filter->Modified();
  source.Run(0, 10);
  CHECK(source.Filter->GetScene() != scene);
  CHECK(source.Filter->CompareFingerprint(before) ==
    files / "plane.mtl" + " has changed and " + files / "spectra/moss.txt" + " is no longer read");
  source.Filter->GetOptions()->SetEpoch(3);
  CHECK(source.Filter->ComputeLoadedFingerprint().empty());
}

TEST_CASE("SurveySource: noise, seed and sampling are those requested", "[SurveySource]")
{
  const Files files;
  const Reading reading(files, Tripod, OneLeg);
  Source source(reading);
  const auto noisy = Get(source.Run(0, 2000), names::Range);
  source.Filter->GetOptions()->SetSeed(5);
  const auto other = Get(source.Run(0, 2000), names::Range);
  source.Filter->GetOptions()->NoiseOff();
  const auto exact = Get(source.Run(0, 2000), names::Range);
  CHECK(noisy != other);
  CHECK(exact != other);
  source.Filter->GetOptions()->SetNumberOfSubRays(19);
  source.Filter->GenerateSubRaysOn();
  const auto pulse = static_cast<vtkIdType>(Get(source.Run(0, 2000), names::PulseIds)[200]);
  CHECK(source.Run(pulse, pulse + 1)->GetNumberOfPoints() == 1);
  CHECK(
    vtkPolyData::SafeDownCast(source.Filter->GetOutputDataObject(3))->GetNumberOfPoints() == 19);
  CHECK(source.Filter->DescribeSampling().find("19 sub-rays") != std::string::npos);
}

TEST_CASE(
  "SurveySource: an abort leaves no output, and the next update is complete", "[SurveySource]")
{
  const Files files;
  const Reading reading(files, Tripod, TwoLegs);
  Source source(reading);
  vtkNew<CountProgress> progress;
  source.Filter->AddObserver(vtkCommand::ProgressEvent, progress);
  const auto whole = source.Run(0, VTK_ID_MAX);
  const int events = progress->Events;
  CHECK(events > 2);
  progress->Events = 0;
  progress->AbortAt = 2; // block of the second leg
  CHECK(source.Run(1, VTK_ID_MAX)->GetNumberOfPoints() == 0);
  CHECK(source.Log->Errors.empty());
  progress->AbortAt = -1;
  CHECK(source.Run(0, VTK_ID_MAX)->GetNumberOfPoints() == whole->GetNumberOfPoints());
}

TEST_CASE("SurveySource: bad input is an error", "[SurveySource]")
{
  const Files files;
  const Reading reading(files, Tripod, OneLeg);
  vtkNew<vtkHeliosSurveySource> empty;
  auto log = Observe(empty);
  empty->Update();
  CHECK(log->HasError("Survey is not set or has no legs"));

  Source source(reading);
  source.Run(5, 4);
  CHECK(source.Log->HasError("PulseWindow is [5, 4); give 0 <= i0 <= i1"));
  source.Filter->GetOptions()->SetRangeTolerance(2.0);
  source.Run(0, 4);
  CHECK(source.Log->HasError("RangeTolerance is 2; give 1e-06 to 1 m"));
  source.Filter->GetOptions()->SetRangeTolerance(0.0);
  source.Filter->GetOptions()->SetRayCaster("nonesuch");
  source.Run(0, 5);
  CHECK(source.Log->HasError("RayCaster=\"nonesuch\" is not in this build"));
  source.Filter->GetOptions()->SetRayCaster("");
  source.Filter->GetOptions()->SetEpoch(3);
  source.Run(0, 6);
  CHECK(source.Log->HasError("Epoch is 3, but the survey has 1 epoch"));
  source.Filter->GetOptions()->SetEpoch(0);
  files.Write("plane.obj", "no mesh\n");
  CHECK_FALSE(source.Filter->Load());
  CHECK(source.Log->HasError("scene.xml:1: The scene is empty"));
  CHECK(source.Filter->GetScene() == nullptr);
}
