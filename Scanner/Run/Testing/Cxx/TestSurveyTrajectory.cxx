// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Trajectories from a pipeline in place of the files of platforms.
#include "vtkHeliosPoseTextWriter.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSBETWriter.h"
#include "vtkHeliosSurveyPlayer.h"
#include "vtkHeliosSurveySource.h"
#include "vtkHeliosTrajectoryReader.h"

#include "heliosSceneCrs.h"
#include "heliosSurveyFiles.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;
namespace names = vtkHeliosArrayNames;
using helios::ErrorObserver;
using namespace helios::test;

namespace
{

const char* const Recorded =
  R"(platform="interpolated" basePlatform="assets.xml#plane" scanner="assets.xml#als")";

/// Half a second each: to the north, then to the east; the time between is flown, too.
const char* const TwoLegs =
  R"(<leg><platformSettings trajectory="way.txt" tEnd="100.5"/>
<scannerSettings scanFreq_hz="50" scanAngle_deg="5" pulseFreq_hz="20000"/></leg>
<leg><platformSettings trajectory="way.txt" tStart="101.5"/>
<scannerSettings scanFreq_hz="50" scanAngle_deg="5" pulseFreq_hz="20000"/></leg>)";

const char* const Way =
  "100,0,0,350,0,0,60\n100.3,1,-1,355,0,3,60.5\n101,0,0,10,0,10,60\n102,0,0,90,10,10,62\n";

/// A trajectory along x at a height, with a row every half second.
vtkSmartPointer<vtkPolyData> MakeFlight(double height, vtkIdType rows = 3)
{
  auto flight = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> times;
  times->SetName(names::GpsTime);
  vtkNew<vtkDoubleArray> orientations;
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  for (vtkIdType row = 0; row < rows; ++row)
  {
    const auto x = static_cast<double>(row);
    points->InsertNextPoint(x, 0.0, height);
    times->InsertNextValue(0.5 * x);
    orientations->InsertNextTuple4(1.0, 0.0, 0.0, 0.0);
  }
  flight->SetPoints(points);
  flight->GetPointData()->AddArray(times);
  flight->GetPointData()->AddArray(orientations);
  return flight;
}

/// A survey and a scene made by methods; its platform follows a trajectory and looks down.
struct Bench
{
  vtkNew<vtkHeliosSurvey> Survey;
  vtkNew<vtkHeliosSurveySource> Source;
  vtkSmartPointer<ErrorObserver> Log = Observe(Source);

  Bench()
  {
    vtkHeliosSurvey* survey = this->Survey;
    survey->AddScanner("als");
    survey->SetScannerAttribute(0, "optics", "conic");
    survey->SetScannerAttribute(0, "scanAngleMax_deg", "1");
    survey->SetScannerAttribute(0, "pulseFreqs_Hz", "2000");
    survey->AddPlatform("plane");
    survey->SetPlatformAttribute(0, "type", "interpolated");
    survey->SetPlatformAttribute(0, "scannerMount/rot/axis", "x");
    survey->SetPlatformAttribute(0, "scannerMount/rot/angle_deg", "-90");
    survey->AddLeg();
    survey->SetLegAttribute(0, "scanFreq_hz", "20");
    vtkNew<vtkPlaneSource> plane;
    plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    plane->SetOrigin(-500.0, -500.0, 0.0);
    plane->SetPoint1(500.0, -500.0, 0.0);
    plane->SetPoint2(-500.0, 500.0, 0.0);
    this->Source->SetInputConnection(0, plane->GetOutputPort());
    this->Source->SetSurvey(survey);
    this->Source->GetOptions()->NoiseOff();
  }

  /// The mean range of all echoes [m]; NaN without echoes.
  double FindRange()
  {
    this->Source->Update();
    vtkDataArray* ranges = this->Source->GetOutput()->GetPointData()->GetArray(names::Range);
    const vtkIdType count = ranges ? ranges->GetNumberOfTuples() : 0;
    double sum = 0.0;
    for (vtkIdType i = 0; i < count; ++i)
    {
      sum += ranges->GetTuple1(i);
    }
    return sum / static_cast<double>(count);
  }
};

/// All files of a run but the summary, by name.
std::map<std::string, std::string> ReadAll(const fs::path& folder)
{
  std::map<std::string, std::string> texts;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    const std::string name = entry.path().filename().string();
    if (name != "run_summary.json")
    {
      texts[name] = ReadText(entry.path().string());
    }
  }
  return texts;
}

} // namespace

TEST_CASE("SurveyTrajectory: an input gives the bytes of its file", "[SurveyTrajectory]")
{
  const Files files;
  files.Write("way.txt", Way);
  const Reading reading(files, Recorded, TwoLegs);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosTrajectoryReader> trajectory;
  trajectory->SetFileName((files / "way.txt").c_str());
  const auto run = [&](const std::string& folder, bool isInput)
  {
    vtkNew<vtkHeliosSurveyPlayer> player;
    const auto log = Observe(player);
    player->SetSurvey(reading.Reader->GetSurvey());
    player->SetOutputDirectory((files / folder).c_str());
    player->WriteWaveformsOn();
    player->WritePulsesOn();
    if (isInput)
    {
      trajectory->Update();
      player->GetSource()->SetInputConnection(2, trajectory->GetOutputPort());
      files.Write("way.txt", "not read\n");
    }
    CHECK(player->Run());
    INFO(log->Errors);
    CHECK(log->Errors.empty());
    return ReadAll(files / (folder + "/test"));
  };
  const auto fromFile = run("file", false);
  const auto fromInput = run("input", true);
  CHECK(fromFile.size() == 8); // points, trajectory, waveforms and pulses of two legs
  CHECK(fromFile.at("leg000_points.xyz").size() > 100000);
  CHECK(fromFile == fromInput);
  const std::string summary = ReadText(files / "input/test/run_summary.json");
  CHECK(summary.find("way.txt") == std::string::npos);
  CHECK(summary.find("\"trajectory\"") != std::string::npos);
  CHECK(ReadText(files / "file/test/run_summary.json").find("way.txt") != std::string::npos);
}

TEST_CASE(
  "SurveyTrajectory: SBET and TUM files fly as the text they are made of", "[SurveyTrajectory]")
{
  const Files files;
  const std::string crs = "ENU 49 9 250";
  files.Replace("scene.xml", "<scene id=\"s\"", "<scene id=\"s\" crs=\"" + crs + "\"");
  files.Write("way.txt", Way);
  vtkNew<vtkHeliosTrajectoryReader> trajectory;
  trajectory->SetFileName((files / "way.txt").c_str());
  trajectory->Update();
  helios::SetCRS(trajectory->GetOutput(), crs);
  vtkNew<vtkHeliosSBETWriter> sbet;
  vtkNew<vtkHeliosPoseTextWriter> tum;
  sbet->SetFileName((files / "way.sbet").c_str());
  tum->SetFileName((files / "way.tum").c_str());
  REQUIRE((sbet->Open() && sbet->Write(trajectory->GetOutput()) && sbet->Close()));
  REQUIRE((tum->Open() && tum->Write(trajectory->GetOutput()) && tum->Close()));
  const auto run = [&files](const std::string& name)
  {
    const std::string legs = std::regex_replace(TwoLegs, std::regex("way.txt"), name);
    const Reading reading(files, Recorded, legs);
    INFO(reading.Log->Errors);
    REQUIRE(reading.Good);
    vtkNew<vtkHeliosSurveyPlayer> player;
    const auto log = Observe(player);
    player->SetSurvey(reading.Reader->GetSurvey());
    player->GetOptions()->NoiseOff();
    player->SetOutputDirectory((files / name).append("d").c_str());
    CHECK(player->Run());
    INFO(log->Errors + log->Warnings);
    CHECK((log->Errors + log->Warnings).empty());
    std::istringstream text(ReadText(files / (name + "d/test/leg001_points.xyz")));
    std::vector<double> numbers;
    for (std::string line; std::getline(text, line);)
    {
      std::istringstream words(line);
      double x = 0.0, y = 0.0, z = 0.0;
      words >> x >> y >> z;
      numbers.insert(numbers.end(), { x, y, z });
    }
    return numbers;
  };
  const auto expected = run("way.txt");
  REQUIRE(expected.size() > 3000);
  for (const char* name : { "way.sbet", "way.tum" })
  {
    const auto points = run(name);
    REQUIRE(points.size() == expected.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      REQUIRE(points[i] == Approx(expected[i]).margin(2e-4));
    }
  }
}

TEST_CASE(
  "SurveyTrajectory: SBET without a system of the scene, and bad systems", "[SurveyTrajectory]")
{
  const Files files;
  const double record[17] = { 100.0, 0.85, 0.15, 250.0 };
  const double next[17] = { 101.0, 0.85, 0.15, 250.0 };
  files.Write("way.dat",
    std::string(reinterpret_cast<const char*>(record), sizeof record) +
      std::string(reinterpret_cast<const char*>(next), sizeof next));
  const auto leg = [](const std::string& more)
  {
    return "<leg><platformSettings trajectory=\"way.dat\" trajectoryFormat=\"SBET\" " + more +
      "/><scannerSettings scanFreq_hz=\"50\" scanAngle_deg=\"5\" pulseFreq_hz=\"20000\"/></leg>";
  };
  const Reading reading(files, Recorded, leg("trajectoryBody=\"forwardRightDown\""));
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveyPlayer> player;
  const auto log = Observe(player);
  player->SetSurvey(reading.Reader->GetSurvey());
  player->SetOutputDirectory((files / "out").c_str());
  CHECK_FALSE(player->Run()); // it flies beside the scene
  INFO(log->Errors + log->Warnings);
  // 8.594 degrees east is 29.85 km west of the central meridian of zone 32.
  CHECK(log->HasError("leg 0 starts at 470154.06"));
  CHECK(log->HasWarning("the scene has no coordinate system; "));
  CHECK(log->HasWarning("way.dat is in the UTM zone of its first record; give <scene> one"));

  const Reading bad(files, Recorded, leg("trajectoryCrs=\"EPSG:1\""));
  REQUIRE(bad.Good);
  vtkNew<vtkHeliosSurveyPlayer> other;
  const auto otherLog = Observe(other);
  other->SetSurvey(bad.Reader->GetSurvey());
  other->SetOutputDirectory((files / "other").c_str());
  CHECK_FALSE(other->Run());
  CHECK(otherLog->HasError("way.dat: FileCRS \"EPSG:1\" is not a coordinate system"));
}

TEST_CASE("SurveyTrajectory: a change of the trajectory is flown", "[SurveyTrajectory]")
{
  Bench bench;
  const auto flight = MakeFlight(100.0);
  bench.Source->SetInputData(2, flight);
  const double slant = 1.0 / std::cos(M_PI / 180.0);
  CHECK(bench.FindRange() == Approx(100.0 * slant).epsilon(1e-4));
  INFO(bench.Log->Errors);
  CHECK(bench.Source->GetNumberOfPulses() == 2000); // 1 s
  vtkPolyData* scene = bench.Source->GetScene();
  const vtkMTimeType before = bench.Source->GetOutput()->GetMTime();
  bench.Source->Update();
  CHECK(bench.Source->GetOutput()->GetMTime() == before); // nothing has changed

  for (vtkIdType row = 0; row < 3; ++row)
  {
    flight->GetPoints()->SetPoint(row, static_cast<double>(row), 0.0, 50.0);
  }
  flight->GetPoints()->Modified();
  CHECK(bench.FindRange() == Approx(50.0 * slant).epsilon(1e-4));
  vtkDataArray* times = flight->GetPointData()->GetArray(names::GpsTime);
  times->SetTuple1(2, 2.0);
  times->Modified();
  CHECK(bench.Source->Load());
  CHECK(bench.Source->GetNumberOfPulses() == 4000);
  CHECK(bench.Source->GetScene() == scene); // is not loaded again
  const auto way = bench.Source->GetTrajectory(0, 0.5);
  REQUIRE(way->GetNumberOfPoints() == 5);
  CHECK(way->GetPoint(1)[0] == Approx(1.0));
  CHECK(way->GetPoint(4)[0] == Approx(2.0));

  bench.Source->SetInputData(2, MakeFlight(20.0));
  CHECK(bench.FindRange() == Approx(20.0 * slant).epsilon(1e-4));
  CHECK(bench.Log->Errors.empty());
}

TEST_CASE("SurveyTrajectory: several are concatenated by time", "[SurveyTrajectory]")
{
  Bench bench;
  const auto first = MakeFlight(100.0);
  const auto second = MakeFlight(40.0);
  for (vtkIdType row = 0; row < 3; ++row)
  {
    second->GetPointData()->GetArray(names::GpsTime)->SetTuple1(row, 5.0 + 0.5 * double(row));
  }
  bench.Source->SetInputData(2, second);
  bench.Source->AddInputDataObject(2, first);
  bench.Survey->SetLegAttribute(0, "tEnd", "1");
  bench.Survey->AddLeg();
  bench.Survey->SetLegAttribute(1, "scanFreq_hz", "20");
  bench.Survey->SetLegAttribute(1, "tStart", "5");
  bench.Survey->SetLegAttribute(1, "teleportToStart", "true");
  CHECK(bench.FindRange() == Approx(70.0 / std::cos(M_PI / 180.0)).epsilon(1e-4));
  INFO(bench.Log->Errors);
  CHECK(bench.Source->GetNumberOfPulses() == 4000);
  second->GetPointData()->GetArray(names::GpsTime)->SetTuple1(0, 0.5);
  second->Modified();
  CHECK_FALSE(bench.Source->Load());
  CHECK(bench.Log->HasError("before trajectory 1 ends, at 1 s"));
}

TEST_CASE("SurveyTrajectory: wrong trajectories name array, row and value", "[SurveyTrajectory]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto get = [](vtkPolyData* flight, const char* name)
  { return flight->GetPointData()->GetArray(name); };
  const auto fails = [&](const std::string& text, const std::function<void(vtkPolyData*)>& change)
  {
    Bench bench;
    const auto flight = MakeFlight(100.0, 4);
    bench.Source->SetInputData(2, flight);
    CHECK(bench.Source->Load());
    change(flight);
    flight->Modified();
    CHECK_FALSE(bench.Source->Load());
    INFO(bench.Log->Errors);
    CHECK(bench.Log->HasError(text));
  };
  fails("input trajectory 0 has no points; give one per row of the trajectory, [m]",
    [](vtkPolyData* flight) { flight->Initialize(); });
  fails("input trajectory 0 has no point array GpsTime; add one, the time [s]",
    [](vtkPolyData* flight) { flight->GetPointData()->RemoveArray(names::GpsTime); });
  fails(
    "input trajectory 0 has no point array Orientation; add one, the unit quaternion w, x, y, z",
    [](vtkPolyData* flight) { flight->GetPointData()->RemoveArray(names::Orientation); });
  fails("input trajectory 0: point array Orientation has 2 components; give 4, the unit quaternion",
    [&](vtkPolyData* flight)
    {
      get(flight, names::Orientation)->SetNumberOfComponents(2);
      get(flight, names::Orientation)->SetNumberOfTuples(4);
    });
  fails("input trajectory 0: point array GpsTime has 3 rows for 4 points; give one per point",
    [&](vtkPolyData* flight) { get(flight, names::GpsTime)->SetNumberOfTuples(3); });
  fails("input trajectory 0, row 2: GpsTime is nan; give a finite time [s], or remove the row",
    [&](vtkPolyData* flight) { get(flight, names::GpsTime)->SetTuple1(2, nan); });
  fails("input trajectory 0, row 1: Points is (1, inf, 100); give finite coordinates [m]",
    [](vtkPolyData* flight) { flight->GetPoints()->SetPoint(1, 1.0, HUGE_VAL, 100.0); });
  fails("input trajectory 0, row 3: Orientation is (2, 0, 0, 0), which is not a unit quaternion w, "
        "x, y, z; normalize it",
    [&](vtkPolyData* flight) { get(flight, names::Orientation)->SetComponent(3, 0, 2.0); });
  fails("input trajectory 0, row 0: Orientation is (1, nan, 0, 0)",
    [&](vtkPolyData* flight) { get(flight, names::Orientation)->SetComponent(0, 1, nan); });
  fails("input trajectory 0, row 2: GpsTime is 0.25, before that of row 1, 0.5; sort the rows by "
        "GpsTime",
    [&](vtkPolyData* flight) { get(flight, names::GpsTime)->SetTuple1(2, 0.25); });
  fails(
    "input trajectory 0, row 2: GpsTime is 0.05, before that of row 1, 604799.95; a GPS week ends "
    "there: add 604800 s to the rows from this one on",
    [&](vtkPolyData* flight)
    {
      get(flight, names::GpsTime)->SetTuple1(1, 604799.95);
      get(flight, names::GpsTime)->SetTuple1(2, 0.05);
    });
  fails("input trajectory 0, row 1: time is 5000000, and rows are 5e+06 apart, which cannot be "
        "seconds; are the times nanoseconds? divide them by 1e9",
    [&](vtkPolyData* flight)
    {
      for (int row = 0; row < 4; ++row)
      {
        get(flight, names::GpsTime)->SetTuple1(row, 5e6 * row);
      }
    });
  fails("input trajectory 0, row 2: GpsTime is 0, as in the two rows before; two rows at one time "
        "are a jump, remove the others",
    [&](vtkPolyData* flight)
    {
      get(flight, names::GpsTime)->SetTuple1(1, 0.0);
      get(flight, names::GpsTime)->SetTuple1(2, 0.0);
    });
}

TEST_CASE("SurveyTrajectory: a trajectory is needed, or not used", "[SurveyTrajectory]")
{
  Bench bench;
  CHECK(bench.Survey->Check()); // it may come from an input
  CHECK_FALSE(bench.Source->Load());
  CHECK(bench.Log->HasError("leg 0: platform plane needs a trajectory; set the leg's attribute "
                            "trajectory to a file, or connect one to input 2"));
  bench.Source->SetInputData(2, MakeFlight(100.0));
  CHECK(bench.Source->Load());
  bench.Survey->SetPlatformAttribute(0, "type", "static");
  bench.Survey->SetLegAttribute(0, "maxDuration_s", "1");
  CHECK_FALSE(bench.Source->Load());
  CHECK(
    bench.Log->HasError("the input trajectory is not used: no platform of survey survey follows "
                        "a trajectory; set the type of a platform to interpolated"));
  bench.Source->RemoveAllInputConnections(2);
  CHECK(bench.Source->Load());
}

TEST_CASE("SurveyTrajectory: a file of a survey made by methods", "[SurveyTrajectory]")
{
  const Files files;
  files.Write("way.txt", Way);
  Bench bench;
  bench.Survey->AddAssetDirectory(files / "");
  CHECK(bench.Survey->SetLegAttribute(0, "trajectory", "way.txt"));
  CHECK(bench.Survey->GetLegAttribute(0, "trajectory") == files / "way.txt");
  bench.Source->Update();
  CHECK(bench.Log->Errors.empty());
  CHECK(bench.Source->GetNumberOfPulses() == 4000); // 2 s
  CHECK(bench.Source->GetOutput()->GetNumberOfPoints() == 4000);
}

TEST_CASE("SurveyTrajectory: a run with another trajectory is not resumed", "[SurveyTrajectory]")
{
  const Files files;
  Bench bench;
  const auto flight = MakeFlight(100.0);
  bench.Source->SetInputData(2, flight);
  vtkNew<vtkHeliosSurveyPlayer> player;
  const auto log = Observe(player);
  player->SetSource(bench.Source);
  player->SetOutputDirectory((files / "out").c_str());
  CHECK(player->Run());
  player->ResumeOn();
  CHECK(player->Run());
  CHECK(player->GetWasFinished());
  flight->GetPoints()->SetPoint(0, 0.0, 0.0, 90.0);
  flight->GetPoints()->Modified();
  CHECK_FALSE(player->Run());
  CHECK(player->GetMessage().find("the input trajectory has changed") != std::string::npos);
}
