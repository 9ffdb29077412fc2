// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The dialect: planning tasks.
#include "heliosXmlTables.h"

#include "heliosPlannerSettings.h"

namespace helios
{

using namespace rows;

//------------------------------------------------------------------------------
std::vector<XmlElementRule> MakePlannerRules()
{
  // clang-format off
  return {
  { "surveyPlanner", "planning of scan positions by vtkhelios plan: PSP are potential scan positions, VTP are visibility test points. Of several in a file the first is used",
    {
      Text("id", "used as the name if there is no name"),
      Text("name", "name of the output folder and of the survey in it").Default("the id, else the name of the file"),
      Reference("scene", "the scene to scan").Required(),
      Reference("platform", "the platform that carries the scanner; it must be static").Required(),
      Reference("scanner", "the instrument").Required(),
      Word("method", "reduce bestcoverage greedy best optimal", "reduce: removes positions in the order of pspRemoveOrder; bestcoverage, greedy: adds the best position; best: reduces the problem first; optimal: proves the minimum number").Default("reduce").At<&PlannerSettings::Method>(),
      Word("pspRemoveOrder", "viewshedSize meanIncidenceAngle", "reduce: criterion by which positions are removed").At<&PlannerSettings::RemoveOrder>(),
      Word("pspRemoveFirst", "smallest largest", "reduce: whether the smallest or the largest value is removed first").At<&PlannerSettings::RemoveFirst>(),
      Number("minCoverage_percent", "share of the test points that must be visible from the selected positions").In("%", { 1e-6, 100.0 }).At<&PlannerSettings::MinimumCoverage>(),
      Word("coverageOf", "coverable all", "base of the coverage: the test points visible from any position, or all").At<&PlannerSettings::CoverageOf>(),
      Number("gridSizePSP_m", "spacing of potential scan positions along x").In("m", GridStep).Default("a twentieth of the scene's diagonal").At<&PlannerSettings::PositionStep, 0>(),
      Number("gridSizePSPy_m", "spacing along y").In("m", GridStep).Default("gridSizePSP_m").At<&PlannerSettings::PositionStep, 1>(),
      Number("gridSizeVTP_m", "spacing of test points").In("m", GridStep).Default("gridSizePSP_m").At<&PlannerSettings::TestPointStep>(),
      Word("vtpLines", "all vertical horizontal", "test points are the intersections of surfaces with lines of these directions").At<&PlannerSettings::TestLines>(),
      Number("maxSlope_deg", "steeper places are excluded as scan positions").In("deg", RightAngle).At<&PlannerSettings::MaximumSlope>(),
      Word("groundOnly", "~auto true false 1 0 open", "scan positions on ground only, by helios_isGround of materials; auto: if any material is ground; open: with nothing above").At<&PlannerSettings::GroundOnly>(),
      Flag("enclosed", "whether places enclosed on all sides are used if there are others").At<&PlannerSettings::TakesEnclosed>(),
      Number("scannerHeight_m", "height of the instrument above the scan position").In("m", { 1e-6, 1e4 }).Default("from the platform").At<&PlannerSettings::ScannerHeight>(),
      Number("hitTolerance_m", "a test point is visible if the ray ends at most this far before it").In("m", { 1e-6, 1e3 }).At<&PlannerSettings::HitTolerance>(),
      Flag("hitBehind", "whether a test point is also visible if the ray ends more than hitTolerance_m behind it; false is the test of Bechtold and Hoefle (2016)").At<&PlannerSettings::SeesBefore>(),
      Flag("scannerLimits", "whether ranges and field of view of the scanner limit visibility").At<&PlannerSettings::HasScannerLimits>(),
      Flag("movingParts", "whether parts that move are part of the plan, where they are at the start of the survey; else they are left out").At<&PlannerSettings::HasMovingParts>(),
      Number("rangeMin_m", "minimum range of visibility").In("m", NotNegative).Default("0, or the scanner's").At<&PlannerSettings::RangeMin>(),
      Number("rangeMax_m", "maximum range of visibility").In("m", Distance).Default("no limit, or the scanner's").At<&PlannerSettings::RangeMax>(),
      Number("elevationMin_deg", "minimum elevation angle of visibility, from the horizontal").In("deg", Elevation).Default("-90, or the scanner's").At<&PlannerSettings::ElevationMin>(),
      Number("elevationMax_deg", "maximum elevation angle").In("deg", Elevation).Default("90, or the scanner's").At<&PlannerSettings::ElevationMax>(),
      Number("maxIncidence_deg", "maximum incidence angle, from the surface normal").In("deg", RightAngle).At<&PlannerSettings::MaximumIncidenceAngle>(),
      Number("minPointDensity_1_m2", "minimum point density from one scan position").In("1/m^2", NotNegative).At<&PlannerSettings::MinimumPointDensity>(),
      Flag("areaWeights", "whether test points are weighted by the area they represent").At<&PlannerSettings::UseAreas>(),
      Number("minOverlap_percent", "share of its test points that each scan must share with the others").In("%", { 0.0, 99.9 }).At<&PlannerSettings::MinimumOverlap>(),
      Number("timeLimit_s", "optimal: limit of the search time").In("s", Seconds).At<&PlannerSettings::TimeLimit>(),
      Flag("interactive", "the Java program prompts between its steps").Ignored(),
    },
    { One("scannerSettings") } },
  };
  // clang-format on
}

} // namespace helios
