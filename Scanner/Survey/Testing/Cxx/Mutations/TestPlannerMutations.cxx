// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged planner documents give an error that names the file, or valid settings.
#include "heliosMutation.h"
#include "heliosPlannerFiles.h"
#include "heliosPlannerSettings.h"
#include "heliosXmlMutation.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace helios::test;

namespace
{

const char* const Planner = R"(<?xml version="1.0"?>
<document>
<scannerSettings id="base" pulseFreq_hz="300000" scanFreq_hz="60"/>
<surveyPlanner id="yard" name="my yard" method="reduce" scene="scene.xml#s" platform="assets.xml#tripod"
 scanner="assets.xml#tls" minCoverage_percent="95" hitTolerance_m="0.05" interactive="false"
 gridSizePSP_m="5" gridSizePSPy_m="4" gridSizeVTP_m="2" pspRemoveOrder="viewshedSize"
 pspRemoveFirst="smallest" coverageOf="coverable" maxSlope_deg="15" groundOnly="auto"
 scannerHeight_m="1.7" scannerLimits="true" rangeMin_m="1" rangeMax_m="600" elevationMin_deg="-40"
 elevationMax_deg="60" maxIncidence_deg="80" areaWeights="true" minOverlap_percent="10"
 timeLimit_s="30">
<scannerSettings template="base" headRotatePerSec_deg="6"/>
</surveyPlanner></document>
)";

bool IsWithin(double value, double low, double high)
{
  return value >= low && value <= high; // false for NaN
}

bool IsValid(vtkHeliosPlannerReader* reader)
{
  const double turn = reader->GetLegHeadRotateStop() - reader->GetLegHeadRotateStart();
  const helios::PlannerSettings& settings = reader->GetSettings();
  return !reader->GetPlanName().empty() && !settings.Method.empty() &&
    !reader->GetSceneReference().empty() && !settings.RemoveOrder.empty() &&
    IsWithin(settings.MinimumCoverage, 1e-6, 100.0) &&
    IsWithin(settings.MinimumOverlap, 0.0, 100.0) && IsWithin(settings.PositionStep[0], 0.0, 1e6) &&
    IsWithin(settings.PositionStep[1], 0.0, 1e6) && IsWithin(settings.TestPointStep, 0.0, 1e6) &&
    IsWithin(settings.MaximumSlope, 0.0, 90.0) && IsWithin(settings.ScannerHeight, 1e-6, 1e4) &&
    settings.HitTolerance > 0.0 && settings.RangeMin < settings.RangeMax &&
    settings.ElevationMin < settings.ElevationMax &&
    IsWithin(settings.MaximumIncidenceAngle, 0.0, 90.0) && settings.TimeLimit > 0.0 &&
    reader->GetLegPulseFrequency() > 0.0 && reader->GetLegScanFrequency() > 0.0 &&
    IsWithin(turn / reader->GetLegHeadRotatePerSecond(), 1e-12, 1e9);
}

} // namespace

TEST_CASE(
  "PlannerMutations: damaged files give an error or planning input", "[PlannerMutations][mutation]")
{
  helios::Mutator mutateText(4712);
  helios::XmlMutator mutateXml(4713);
  const Files files;
  files.Write("plan.xml", Planner);
  const PlannerReading whole(files);
  INFO(whole.Log->Errors);
  REQUIRE(whole.Good);
  REQUIRE(IsValid(whole.Reader));

  int count[2] = { 0, 0 };
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const std::string text = i % 2 == 0 ? mutateXml(Planner) : mutateText(Planner);
    files.Write("plan.xml", text);
    INFO("file " << i << "\n" << text);
    PlannerReading reading(files);
    INFO(reading.Log->Errors);
    ++count[reading.Good];
    REQUIRE(reading.Good == reading.Log->Errors.empty());
    const bool isPlanner = reading.Reader->GetKind() == "planner";
    REQUIRE((!reading.Good || !isPlanner || IsValid(reading.Reader)));
    REQUIRE((reading.Good || reading.Log->HasError("plan.xml") ||
      reading.Log->HasError("assets.xml") || reading.Log->HasError("scene.xml")));
  }
  CHECK(count[0] > 0);
  CHECK(count[1] > 0);
}
