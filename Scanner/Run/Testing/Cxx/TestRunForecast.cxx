// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunForecast.h"

#include "heliosMessages.h"
#include "heliosSurveyPlaying.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveySource.h"

#include <vtkPolyData.h>

#include <catch2/catch.hpp>

using namespace helios::test;

namespace
{

/// A flight over a plane of 100 m, beside it at both ends: 1.2 million pulses.
const std::string Legs = R"(<platformSettings id="p" z="100" movePerSec_m="20"/>
<scannerSettings id="c" pulseFreq_hz="200000" scanFreq_hz="50" scanAngle_deg="15"/>
<leg><platformSettings template="p" x="-60"/><scannerSettings template="c"/></leg>
<leg><platformSettings template="p" x="60"/><scannerSettings template="c"/></leg>)";

/// Forecasts of a survey, with any effort.
class Bench
{
public:
  explicit Bench(const std::string& legs = Legs)
    : Survey(this->Folder, Flight, legs)
    , Log(this->Source)
  {
    this->Source->SetSurvey(this->Survey.Reader->GetSurvey());
    REQUIRE(this->Source->Load());
  }

  Json::Value Run(const helios::RunForecast::Effort& effort, int steps = VTK_INT_MAX)
  {
    helios::RunSettings settings;
    helios::LegRunner runner(this->Survey.Data(), this->Source->GetScene(), settings, this->Log);
    REQUIRE(runner.Plan());
    helios::RunForecast forecast(runner, settings, this->Log);
    forecast.Measure(effort, [&steps](double) { return steps-- > 0; });
    return forecast.Describe();
  }

private:
  Files Folder;
  Reading Survey;
  vtkNew<vtkHeliosSurveySource> Source;
  helios::Messages Log;
};

/// An effort that no time limits.
helios::RunForecast::Effort MakeEffort(bool isFull)
{
  helios::RunForecast::Effort effort = helios::RunForecast::MakeEffort(isFull);
  effort.Seconds = 1e6;
  effort.ShortestRun = 0.0;
  return effort;
}

} // namespace

TEST_CASE("RunForecast: times fall with wider tolerances", "[RunForecast]")
{
  const auto falling = [](std::vector<double> times)
  {
    helios::MakeFalling(times);
    return times;
  };
  CHECK(falling({ 4.0, 2.0, 1.0 }) == std::vector<double>{ 4.0, 2.0, 1.0 });
  CHECK(falling({ 3.0, 1.0, 2.0 }) == std::vector<double>{ 3.0, 1.5, 1.5 });
  CHECK(falling({ 1.0, 2.0, 6.0 }) == std::vector<double>{ 3.0, 3.0, 3.0 });
  CHECK(falling({ 5.0, 1.0, 2.0, 6.0 }) == std::vector<double>{ 5.0, 3.0, 3.0, 3.0 });
  CHECK(falling({}).empty());
}

TEST_CASE("RunForecast: computes at most 2 % of the pulses of a run", "[RunForecast]")
{
  Bench bench;
  const Json::Value found = bench.Run(MakeEffort(false));
  INFO(found.toStyledString());
  REQUIRE(found["ways"].size() == 4);
  CHECK(found["pulsesComputed"].asInt64() <= 0.02 * 1200000);
  CHECK(found["pulses"].asInt64() >= 50);
  for (const Json::Value& way : found["ways"])
  {
    CHECK(way["run_s"].asDouble() >= 0.0);
    CHECK(way["rangeP95_m"][0].asDouble() < 1e-3); // on a plane
    CHECK(way["missedAndInvented"][0].asDouble() == 0.0);
  }
  for (const int wider : { 1, 2 })
  {
    CHECK(found["ways"][wider]["run_s"].asDouble() <= found["ways"][wider - 1]["run_s"].asDouble());
  }
  CHECK(found["ways"][0]["rangeTolerance_m"].asDouble() == 0.001);
  CHECK(found["ways"][2]["energyTolerance"].asDouble() == Approx(0.1));
  CHECK(found["ways"][3]["subRays"].asInt() == 19);
}

TEST_CASE("RunForecast: a full one has more ways", "[RunForecast]")
{
  Bench bench;
  const Json::Value found = bench.Run(MakeEffort(true));
  INFO(found.toStyledString());
  REQUIRE(found["ways"].size() == 10);
  CHECK(found["ways"][4]["energyTolerance"].asDouble() == 0.5);
  CHECK(found["ways"][9]["subRays"].asInt() == 223);
  CHECK(found["reference"]["rangeTolerance_m"].asDouble() == 1e-4);
}

TEST_CASE("RunForecast: none of a short run, and it can be stopped", "[RunForecast]")
{
  Bench bench;
  helios::RunForecast::Effort effort = MakeEffort(false);
  effort.ShortestRun = 1e9;
  CHECK(bench.Run(effort)["reason"].asString() == "the run is short");
  CHECK(bench.Run(MakeEffort(false), 1)["reason"].asString() == "it was stopped");
  effort = MakeEffort(false);
  effort.ShareOfPulses = 1e-4; // 120 of them for all ways and windows
  CHECK(bench.Run(effort)["reason"].asString() == "the run is short");
  effort = MakeEffort(false);
  effort.Seconds = 0.0;
  CHECK(bench.Run(effort)["reason"].asString() == "its pulses take too long for a sample");
}

TEST_CASE("RunForecast: a scanner without noise has the tolerance of the survey, and a warning",
  "[RunForecast]")
{
  const Files files;
  const Reading reading(files, Flight, ThreeLegs);
  Playing playing(files, reading);
  playing.Player->GetOptions()->SetAccuracy("instrument");
  playing.Player->ForecastOn();
  REQUIRE(playing.Player->Run());
  INFO(playing.Log->Warnings);
  CHECK(playing.Log->HasWarning(
    "Accuracy is \"instrument\", but scanner als has no range noise: its beams are sampled within "
    "0.001 m; give it accuracy_m, or RangeTolerance (--range-tolerance)"));
  CHECK(playing.Player->GetReport().find("\"accuracy\" : \"instrument\"") != std::string::npos);
  CHECK(playing.Player->GetForecastReport().find("the run is short") != std::string::npos);
}
