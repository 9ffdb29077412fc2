// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A flight over a 2 m step with the edge below the track: ranges are known.
#include "heliosInspector.h"

#include "heliosCloudView.h"
#include "heliosSceneView.h"
#include "heliosStepFiles.h"
#include "heliosViewer.h"
#include "heliosViewerTest.h"
#include "vtkHeliosSurveyPlayer.h"

#include <catch2/catch.hpp>

#include <vtkChartXY.h>
#include <vtkPlot.h>
#include <vtkTable.h>

#include <json/json.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

using namespace helios;
using namespace helios::viewer;
namespace fs = std::filesystem;

namespace
{

ViewerOptions MakeOptions(const StepFiles& files)
{
  ViewerOptions options;
  options.Inputs = { (files.Folder / "survey.xml").string() };
  options.Offscreen = true;
  options.Still = (files.Folder / "still.png").string();
  options.Width = 640;
  options.Height = 480;
  return options;
}

void Wait(Inspector& inspector)
{
  for (int i = 0; i < 3000 && inspector.IsWaiting(); ++i)
  {
    inspector.OnFrame();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  REQUIRE_FALSE(inspector.IsWaiting());
}

/// Looks down on an echo, 12 m high: its pixel is the window's centre.
void ViewFromAbove(Viewer& viewer, const Vec3& position)
{
  const Vec3 at = position - viewer.GetOrigin();
  vtkCamera* camera = viewer.GetRenderer()->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(6.0);
  camera->SetPosition(at[0], at[1], at[2] + 50.0);
  camera->SetFocalPoint(at[0], at[1], at[2]);
  camera->SetViewUp(0.0, 1.0, 0.0);
  viewer.GetRenderer()->ResetCameraClippingRange();
}

/// The row of the first echo of a pulse with n returns whose axis hits y in (low, high).
vtkIdType FindRow(Viewer& viewer, int returns, double low, double high)
{
  const Cloud& cloud = viewer.GetCloud();
  for (vtkIdType row = cloud.GetNumberOfPoints() / 2; row < cloud.GetNumberOfPoints(); ++row)
  {
    const Echo echo = cloud.GetEcho(row);
    if (echo.NumberOfReturns == returns && echo.ReturnNumber == 1 && echo.Position[1] > low &&
      echo.Position[1] < high)
    {
      return row;
    }
  }
  return -1;
}

/// Range along a beam axis to a horizontal plane [m].
double GetRangeTo(const PulseReading& reading, double z)
{
  return (z - reading.Origin[2]) / reading.Direction[2];
}

} // namespace

TEST_CASE("Inspector: a click selects a pulse on two steps")
{
  const StepFiles files;
  Viewer viewer(MakeOptions(files));
  REQUIRE(viewer.Run() == 0);
  const vtkIdType row = FindRow(viewer, 2, -0.12, 0.12);
  REQUIRE(row >= 0);
  const Echo planted = viewer.GetCloud().GetEcho(row);
  ViewFromAbove(viewer, planted.Position);

  Inspector inspector(viewer);
  CHECK_FALSE(inspector.OnKey("n", false)); // no selection: the key is not the inspector's
  CHECK_FALSE(inspector.OnClick(360, 240)); // between two lines of the scan
  REQUIRE(inspector.OnClick(320, 240));
  CHECK(inspector.GetRow() == row);
  CHECK(inspector.GetReading().Pulse == planted.PulseId);
  CHECK(inspector.GetReading().Echoes.size() == 2); // from the cloud, at once
  Wait(inspector);

  const PulseReading& reading = inspector.GetReading();
  REQUIRE(reading.Echoes.size() == 2);
  REQUIRE(reading.Gaussians.size() == 2);
  for (const int i : { 0, 1 })
  {
    CAPTURE(i);
    const auto k = static_cast<std::size_t>(i);
    const Echo echo = viewer.GetCloud().GetEcho(row + i);
    const double truth = GetRangeTo(reading, i == 0 ? StepHeight : 0.0);
    CHECK(reading.Gaussians[k].Range == Approx(truth).margin(2e-3));
    CHECK(reading.Echoes[k].Range == Approx(truth).margin(2e-3));
    CHECK(reading.Echoes[k].Range == Approx(echo.Range).margin(1e-4));
    CHECK(reading.Echoes[k].Amplitude == Approx(echo.Amplitude).epsilon(1e-3));
    CHECK((reading.Echoes[k].Position - echo.Position).Norm() < 1e-4);
    CHECK(reading.Echoes[k].Part == 1 - i); // the plate's, then the ground's
  }

  SECTION("sub-rays end on the step they hit, and all are drawn")
  {
    REQUIRE(reading.SubRays.size() > 1);
    CHECK(inspector.GetView().GetNumberOfBeams() == vtkIdType(reading.SubRays.size()));
    CHECK(inspector.GetView().GetNumberOfHits() == vtkIdType(reading.SubRays.size()));
    vtkPolyData* beams = inspector.GetView().GetBeams();
    CHECK((Vec3(beams->GetPoint(0)) + viewer.GetOrigin() - reading.Origin).Norm() < 1e-4);
    double weights = 0.0;
    int hitsOfPlate = 0;
    for (const SubRayHit& hit : reading.SubRays)
    {
      const bool isPlate = hit.Position[1] > 0.0;
      // Ranges are of a part on average: R w^2 / 4 farther than at its centroid.
      CHECK(hit.Position[2] == Approx(isPlate ? StepHeight : 0.0).margin(2e-4));
      CHECK(viewer.GetSceneView()->GetPartName(hit.Part) == (isPlate ? "plate" : "ground"));
      hitsOfPlate += isPlate;
      weights += hit.Weight;
    }
    CHECK(hitsOfPlate > 0);
    CHECK(hitsOfPlate < int(reading.SubRays.size()));
    CHECK(weights == Approx(1.0).margin(0.05));
  }
  SECTION("the chart draws every sample")
  {
    vtkChartXY* chart = inspector.GetChart().GetChart();
    CHECK(
      chart->GetNumberOfPlots() == 7); // the pulse, samples, 2 Gaussians, the echo, echoes, times
    CHECK(chart->GetPlot(1)->GetInput()->GetNumberOfRows() == vtkIdType(reading.Samples.size()));
    CHECK(inspector.GetChart().GetTitle().find("return 1 of 2") != std::string::npos);
    CHECK(inspector.GetChart().Contains(100, 100));
    CHECK(inspector.OnClick(100, 100)); // clicks on it select nothing
    CHECK(inspector.GetRow() == row);
  }
  SECTION("the waveform is drawn along the beam")
  {
    vtkPolyData* curve = inspector.GetView().GetWaveforms();
    REQUIRE(inspector.GetView().GetNumberOfWaveforms() == 1);
    REQUIRE(curve->GetNumberOfPoints() == vtkIdType(reading.Samples.size()));
    for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
    {
      const Vec3 from = Vec3(curve->GetPoint(i)) + viewer.GetOrigin() - reading.Origin;
      const double range = reading.Ranges[static_cast<std::size_t>(i)];
      CHECK(from.Dot(reading.Direction) == Approx(range).margin(1e-4));
    }
  }
  SECTION("the state file shows it; keys step and close")
  {
    Json::Value state;
    inspector.Describe(state);
    const Json::Value& value = state["inspector"];
    CHECK(value["pulse"].asInt64() == planted.PulseId);
    CHECK(value["return"].asInt() == 1);
    CHECK(value["echoes"].asInt() == 2);
    CHECK(value["gaussians"].asInt() == 2);
    CHECK(value["waveformSamples"].asUInt64() == reading.Samples.size());
    CHECK(value["subRays"].asUInt64() == reading.SubRays.size());
    CHECK(value["chart"].asBool());
    CHECK(value["position"][2].asDouble() == Approx(StepHeight).margin(1e-3));
    CHECK(inspector.OnKey("n", false));
    CHECK(inspector.GetRow() == row + 1);
    CHECK_FALSE(inspector.IsWaiting()); // the same pulse
    CHECK(inspector.OnKey("Up", false));
    CHECK(inspector.GetReading().Pulse == planted.PulseId + 1);
    CHECK(inspector.OnKey("Escape", false));
    CHECK(inspector.GetRow() == -1);
    CHECK_FALSE(inspector.GetChart().IsVisible());
    CHECK(inspector.GetView().GetNumberOfBeams() == 0);
    CHECK_FALSE(inspector.OnKey("Escape", false));
  }
  SECTION("the waveforms of the line")
  {
    CHECK(inspector.OnKey("u", false));
    Wait(inspector);
    CHECK(inspector.GetView().GetNumberOfWaveforms() > 10);
    CHECK(inspector.GetView().GetNumberOfWaveforms() <= 256);
  }
}

TEST_CASE("Inspector: a pulse with one echo on a plane")
{
  const StepFiles files;
  Viewer viewer(MakeOptions(files));
  REQUIRE(viewer.Run() == 0);
  Inspector inspector(viewer);
  const vtkIdType row = FindRow(viewer, 1, -2.0, -1.0);
  REQUIRE(row >= 0);
  inspector.Inspect(row);
  Wait(inspector);
  const PulseReading& reading = inspector.GetReading();
  REQUIRE(reading.Gaussians.size() == 1);
  CHECK(reading.Gaussians[0].Range == Approx(GetRangeTo(reading, 0.0)).margin(1e-3));
  CHECK(reading.PulseLength == 4.0);
  CHECK(inspector.GetView().GetNumberOfBeams() >= 1); // its axis, if no sub-ray was needed
  CHECK(reading.Samples.size() == reading.Ranges.size());
}

TEST_CASE("Inspector: a finished run is read with its waveform files")
{
  const StepFiles files;
  Viewer viewer(MakeOptions(files));
  REQUIRE(viewer.Run() == 0);
  vtkNew<vtkHeliosSurveyPlayer> player;
  player->SetSurvey(viewer.GetSurvey());
  player->SetOutputDirectory((files.Folder / "out").c_str());
  player->WriteWaveformsOn();
  REQUIRE(player->Run());
  const std::string points = (files.Folder / "out/step/leg000_points.xyz").string();
  const auto found = FindWaveformFiles({ points });
  REQUIRE(found.size() == 1);
  CHECK(FindWaveformFiles({ (files.Folder / "out").string() }) == found);
  CHECK(FindWaveformFiles({ (files.Folder / "scene.xml").string() }).empty());

  const vtkIdType row = FindRow(viewer, 2, -0.12, 0.12);
  REQUIRE(row >= 0);
  const std::int64_t pulse = viewer.GetCloud().GetEcho(row).PulseId;
  Inspector inspector(viewer);
  inspector.Inspect(row);
  Wait(inspector);
  WaveformSearch search;
  const PulseReading reading =
    ReadPulse(search.Find(found, 0, pulse, pulse + 1).get(), pulse, nullptr);
  REQUIRE(reading.Samples.size() == inspector.GetReading().Samples.size());
  REQUIRE(reading.Gaussians.size() == 2);
  CHECK(
    reading.Gaussians[0].Range == Approx(inspector.GetReading().Gaussians[0].Range).margin(1e-3));
  ViewerOptions options;
  options.Inputs = { (files.Folder / "out/step").string() };
  options.Offscreen = true;
  options.Still = (files.Folder / "replay.png").string();
  Viewer replay(options);
  REQUIRE(replay.Run() == 0);
  Inspector ofFile(replay);
  ofFile.Inspect(FindRow(replay, 2, -0.12, 0.12));
  Wait(ofFile);
  CHECK(ofFile.GetChart().GetNumberOfSamples() == vtkIdType(ofFile.GetReading().Samples.size()));
  CHECK(ofFile.GetChart().GetNumberOfSamples() > 0);
  CHECK(ofFile.GetReading().Gaussians.size() == 2);
  CHECK(ofFile.GetReading().Echoes.size() == 2);

  auto none = search.Find(found, 0, 1000000, 1000001);
  CHECK_THROWS_WITH(none.get(),
    "pulse 1000000 has no waveform in the files next to the points; were they written by the same "
    "run?");
}

TEST_CASE("Inspector: a LAS file is read with its packets")
{
  const StepFiles files;
  files.Replace("survey.xml", "movePerSec_m=\"20\"", "movePerSec_m=\"5\""); // several pieces
  Viewer viewer(MakeOptions(files));
  REQUIRE(viewer.Run() == 0);
  const vtkIdType row = FindRow(viewer, 2, -0.12, 0.12);
  REQUIRE(row >= 0);
  Inspector live(viewer);
  live.Inspect(row);
  Wait(live);
  const PulseReading& truth = live.GetReading();

  vtkNew<vtkHeliosSurveyPlayer> player;
  player->SetSurvey(viewer.GetSurvey());
  player->SetOutputDirectory((files.Folder / "out").c_str());
  player->SetFormat("las");
  const bool hasWaveforms = GENERATE(true, false);
  player->SetWriteWaveforms(hasWaveforms);
  const bool isInPoints = GENERATE(true, false);
  player->SetWaveformsInPoints(isInPoints);
  REQUIRE(player->Run());
  const std::string run = (files.Folder / "out/step").string();
  const std::string points = run + "/leg000_points.las";
  const std::string waves = isInPoints ? points : run + "/leg000_fullwave.las";
  const std::vector<std::string> wanted(hasWaveforms ? 1 : 0, waves);
  CHECK(FindWaveformFiles({ run }) == wanted);
  CHECK(FindWaveformFiles({ points }) == wanted);
  CHECK(FindWaveformFiles({ run + "/run_summary.json" }).empty());

  ViewerOptions options;
  options.Inputs = { points };
  options.Offscreen = true;
  options.Still = (files.Folder / "replay.png").string();
  Viewer replay(options);
  REQUIRE(replay.Run() == 0);
  CHECK(replay.GetCloud().GetNumberOfPoints() == viewer.GetCloud().GetNumberOfPoints());
  Inspector ofFile(replay);
  ofFile.Inspect(row);
  Wait(ofFile);
  const PulseReading& reading = ofFile.GetReading();
  CHECK(reading.Pulse == truth.Pulse);
  CHECK((reading.Samples.size() > 0) == hasWaveforms);
  if (!hasWaveforms)
  {
    CHECK(ofFile.GetChart().GetTitle().find("no LAS file has waveforms") != std::string::npos);
    return;
  }
  CHECK(fs::file_size(points) > 400000); // two pieces
  REQUIRE(reading.Gaussians.size() == 2);
  REQUIRE(reading.Samples.size() <= truth.Samples.size()); // except for trailing zeros
  const double highest = *std::max_element(truth.Samples.begin(), truth.Samples.end());
  for (std::size_t i = 0; i < reading.Samples.size(); ++i)
  {
    CHECK(reading.Samples[i] == Approx(truth.Samples[i]).margin(1e-5 * highest));
    CHECK(reading.Ranges[i] == Approx(truth.Ranges[i]).margin(1e-3));
  }
  for (const std::size_t k : { 0, 1 })
  {
    CHECK(reading.Gaussians[k].Range == Approx(truth.Gaussians[k].Range).margin(1e-3));
  }
  CHECK(ofFile.OnKey("u", false));
  Wait(ofFile);
  CHECK(ofFile.GetView().GetNumberOfWaveforms() > 10);

  WaveformSearch search;
  auto none = search.Find({ waves }, 0, 1000000, 1000001);
  CHECK_THROWS_WITH(none.get(), Catch::Contains("pulse 1000000 has no waveform"));
  const std::string packets = fs::path(waves).replace_extension(".wdp").string();
  fs::remove(packets);
  auto lost = search.Find({ waves }, 0, truth.Pulse, truth.Pulse + 1);
  CHECK_THROWS_WITH(lost.get(), Catch::Contains(packets + ": cannot be read"));
}

TEST_CASE("Inspector: a missing waveform is reported with the reason")
{
  ViewerOptions options;
  options.Inputs = { "cloud.xyz" };
  options.Offscreen = true;
  Viewer viewer(options);
  REQUIRE(viewer.Run() == 1); // the file does not exist; the test supplies the points
  auto echoes = MakeEchoes({ { 1, 2, 3 }, { 4, 5, 6 } });
  const bool hasPulses = GENERATE(false, true);
  if (hasPulses)
  {
    AddColumn(echoes, vtkHeliosArrayNames::PulseIds, { 7, 8 });
  }
  viewer.GetCloud().Append(echoes);
  Inspector inspector(viewer);
  inspector.Inspect(1);
  CHECK_FALSE(inspector.IsWaiting());
  CHECK(inspector.GetChart().IsVisible());
  CHECK(inspector.GetChart().GetNumberOfSamples() == 0);
  const std::string wanted = hasPulses ? "or run it\nwith --waveforms" : "have no pulse numbers";
  CHECK(inspector.GetChart().GetTitle().find(wanted) != std::string::npos);
}
