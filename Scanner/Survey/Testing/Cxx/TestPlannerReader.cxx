// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Planning tasks from planner documents, surveys, scenes and meshes.
#include "vtkHeliosPlannerReader.h"

#include "heliosPlannerFiles.h"
#include "heliosPlannerSettings.h"
#include "vtkHeliosDialect.h"

#include <vtkCommand.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

using namespace helios::test;

namespace
{

/// A survey of one leg of the tripod.
const char* const Survey = R"(<document><survey name="test" scene="scene.xml#s"
 platform="assets.xml#tripod" scanner="assets.xml#tls"><leg><platformSettings x="1"/>
<scannerSettings pulseFreq_hz="300000" scanFreq_hz="50" verticalAngleMin_deg="-30"
 verticalAngleMax_deg="40" headRotatePerSec_deg="10" headRotateStop_deg="10"/></leg>
</survey></document>)";

} // namespace

TEST_CASE("PlannerReader: defaults", "[PlannerReader]")
{
  const Files files;
  const PlannerReading reading(WritePlanner(files, ""));
  INFO(reading.Log->Errors << reading.Log->Warnings);
  REQUIRE(reading.Good);
  CHECK(reading.Log->Warnings.empty());
  vtkHeliosPlannerReader* reader = reading.Reader;
  CHECK(reader->GetKind() == "planner");
  CHECK(reader->GetPlanName() == "yard");
  CHECK(reader->GetSceneReference() == files / "scene.xml" + "#s");
  CHECK(reader->GetPlatformReference() == files / "assets.xml" + "#tripod");
  CHECK(reader->GetScannerReference() == files / "assets.xml" + "#tls");
  CHECK(reader->GetMethod() == "reduce");
  CHECK(reader->GetSettings().RemoveOrder == "viewshedSize");
  CHECK(reader->GetSettings().RemoveFirst == "smallest");
  CHECK(reader->GetSettings().MinimumCoverage == 100.0);
  CHECK(reader->GetSettings().CoverageOf == "coverable");
  CHECK(reader->GetSettings().PositionStep[0] == 0.0);
  CHECK(reader->GetSettings().PositionStep[1] == 0.0);
  CHECK(reader->GetSettings().TestPointStep == 0.0);
  CHECK(reader->GetSettings().MaximumSlope == 15.0);
  CHECK(reader->GetSettings().GroundOnly == "auto");
  CHECK(reader->GetSettings().ScannerHeight ==
    Approx(1.7)); // the mount, and the beam origin in the head
  CHECK(reader->GetSettings().HitTolerance == 0.05);
  CHECK_FALSE(reader->GetScannerLimits());
  CHECK(reader->GetSettings().RangeMin == 0.0);
  CHECK(reader->GetSettings().RangeMax == VTK_DOUBLE_MAX);
  CHECK(reader->GetSettings().ElevationMin == -90.0);
  CHECK(reader->GetSettings().ElevationMax == 90.0);
  CHECK(reader->GetSettings().MaximumIncidenceAngle == 90.0);
  CHECK(reader->GetSettings().TestLines == "all");
  CHECK_FALSE(reader->GetSettings().TakesEnclosed);
  CHECK(reader->GetSettings().SeesBefore);
  CHECK(reader->GetSettings().MinimumPointDensity == 0.0);
  CHECK(reader->GetLegAngularStep() == Approx(0.1));
  CHECK_FALSE(reader->GetSettings().UseAreas);
  CHECK(reader->GetSettings().MinimumOverlap == 0.0);
  CHECK(reader->GetSettings().TimeLimit == 300.0);
  // 0.1 degrees: f r / (2 * 120), and r degrees per line
  CHECK(reader->GetLegPulseFrequency() == 100000.0);
  CHECK(reader->GetLegScanFrequency() == Approx(100000.0 * 0.1 / 240.0));
  CHECK(reader->GetLegHeadRotatePerSecond() == Approx(0.1 * reader->GetLegScanFrequency()));
  CHECK(reader->GetLegHeadRotateStart() == 0.0);
  CHECK(reader->GetLegHeadRotateStop() == 360.0);
  CHECK(reader->GetLegVerticalAngleMin() == -50.0);
  CHECK(reader->GetLegVerticalAngleMax() == 50.0);
  CHECK(reader->GetLegScanAngle() == 120.0);
  CHECK(reader->HasRotatingMirror());
}

TEST_CASE("PlannerReader: all attributes", "[PlannerReader]")
{
  const Files files;
  const PlannerReading reading(WritePlanner(files, R"(name="a/b" method="optimal"
 pspRemoveOrder="meanIncidenceAngle" pspRemoveFirst="largest" minCoverage_percent="95"
 coverageOf="all" gridSizePSP_m="2" gridSizePSPy_m="3" gridSizeVTP_m="0.5" maxSlope_deg="30"
 vtpLines="vertical" hitBehind="false" minPointDensity_1_m2="9" enclosed="1"
 groundOnly="TRUE" scannerHeight_m="2.5" hitTolerance_m="0.1" rangeMin_m="1" rangeMax_m="80"
 elevationMin_deg="-40" elevationMax_deg="60" maxIncidence_deg="75" areaWeights="true"
 minOverlap_percent="20" timeLimit_s="5" interactive="true")",
    R"(<scannerSettings pulseFreq_hz="300000" scanFreq_hz="60" headRotatePerSec_deg="-12"
 headRotateStart_deg="90" headRotateStop_deg="-90" verticalAngleMin_deg="-20"/>)"));
  INFO(reading.Log->Errors << reading.Log->Warnings);
  REQUIRE(reading.Good);
  CHECK(reading.Log->Warnings.empty());
  vtkHeliosPlannerReader* reader = reading.Reader;
  CHECK(reader->GetPlanName() == "a_b");
  CHECK(reader->GetMethod() == "optimal");
  CHECK(reader->GetSettings().RemoveOrder == "meanIncidenceAngle");
  CHECK(reader->GetSettings().RemoveFirst == "largest");
  CHECK(reader->GetSettings().MinimumCoverage == 95.0);
  CHECK(reader->GetSettings().CoverageOf == "all");
  CHECK(reader->GetSettings().PositionStep[0] == 2.0);
  CHECK(reader->GetSettings().PositionStep[1] == 3.0);
  CHECK(reader->GetSettings().TestPointStep == 0.5);
  CHECK(reader->GetSettings().MaximumSlope == 30.0);
  CHECK(reader->GetSettings().GroundOnly == "true");
  CHECK(reader->GetSettings().ScannerHeight == 2.5);
  CHECK(reader->GetSettings().HitTolerance == 0.1);
  CHECK(reader->GetSettings().RangeMin == 1.0);
  CHECK(reader->GetSettings().RangeMax == 80.0);
  CHECK(reader->GetSettings().ElevationMin == -40.0);
  CHECK(reader->GetSettings().ElevationMax == 60.0);
  CHECK(reader->GetSettings().MaximumIncidenceAngle == 75.0);
  CHECK(reader->GetSettings().TestLines == "vertical");
  CHECK(reader->GetSettings().TakesEnclosed);
  CHECK_FALSE(reader->GetSettings().SeesBefore);
  CHECK(reader->GetSettings().MinimumPointDensity == 9.0);
  CHECK(reader->GetLegAngularStep() == Approx(0.2)); // 12 degrees per second, 60 lines
  CHECK(reader->GetSettings().UseAreas);
  CHECK(reader->GetSettings().MinimumOverlap == 20.0);
  CHECK(reader->GetSettings().TimeLimit == 5.0);
  CHECK(reader->GetLegPulseFrequency() == 300000.0);
  CHECK(reader->GetLegScanFrequency() == 60.0);
  CHECK(reader->GetLegHeadRotatePerSecond() == -12.0);
  CHECK(reader->GetLegHeadRotateStart() == 90.0);
  CHECK(reader->GetLegHeadRotateStop() == -90.0);
  CHECK(reader->GetLegVerticalAngleMin() == -20.0);
  CHECK(reader->GetLegVerticalAngleMax() == 50.0);
}

TEST_CASE("PlannerReader: one grid size applies to those not given", "[PlannerReader]")
{
  const Files files;
  const PlannerReading reading(WritePlanner(files, R"(gridSizePSP_m="4")"));
  CHECK(reading.Reader->GetSettings().PositionStep[1] == 4.0);
  CHECK(reading.Reader->GetSettings().TestPointStep == 4.0);
}

TEST_CASE("PlannerReader: options override the file", "[PlannerReader]")
{
  const Files files;
  files.Replace("assets.xml", "<platform id=\"plane\"",
    "<platform id=\"mast\"><scannerMount x=\"1\" y=\"2\" z=\"8\"><rot axis=\"z\" "
    "angle_deg=\"90\"/></scannerMount></platform><platform id=\"plane\"");
  WritePlanner(files, "", R"(<scannerSettings scanFreq_hz="60" headRotatePerSec_deg="12"/>)");
  PlannerReading reading(files);
  reading.Reader->SetPlatform("assets.xml#mast");
  reading.Reader->SetPulseFrequency(300000.0);
  reading.Reader->SetResolution(0.04);
  REQUIRE(reading.Reader->Read());
  CHECK(reading.Reader->GetPlatformReference() == files / "assets.xml" + "#mast");
  CHECK(reading.Reader->GetSettings().ScannerHeight == Approx(8.2));
  double instrument[3];
  reading.Reader->GetInstrument(instrument);
  CHECK(instrument[0] == 1.0);
  CHECK(instrument[1] == 2.0);
  CHECK(reading.Reader->GetLegPulseFrequency() == 300000.0);
  CHECK(reading.Reader->GetLegScanFrequency() == Approx(50.0));
  CHECK(reading.Reader->GetLegHeadRotatePerSecond() == Approx(2.0));
  // The nearest of the scanner: at most 120 lines per second, and 60 degrees.
  reading.Reader->SetResolution(1.0);
  REQUIRE(reading.Reader->Read());
  CHECK(reading.Reader->GetLegScanFrequency() == 120.0);
  CHECK(reading.Reader->GetLegHeadRotatePerSecond() == 60.0);
  CHECK(reading.Log->Warnings.empty());
}

TEST_CASE("PlannerReader: limits of the scanner", "[PlannerReader]")
{
  const Files files;
  files.Replace("assets.xml", "rangeMin_m=\"0.5\"", "rangeMin_m=\"0.5\" rangeMax_m=\"90\"");
  const PlannerReading reading(WritePlanner(files, R"(scannerLimits="true" elevationMax_deg="30")",
    R"(<scannerSettings verticalAngleMin_deg="-35" verticalAngleMax_deg="60"/>)"));
  INFO(reading.Log->Errors << reading.Log->Warnings);
  REQUIRE(reading.Good);
  CHECK(reading.Reader->GetScannerLimits());
  CHECK(reading.Reader->GetSettings().RangeMin == 0.5);
  CHECK(reading.Reader->GetSettings().RangeMax == 90.0);
  CHECK(reading.Reader->GetSettings().ElevationMin == -35.0);
  CHECK(reading.Reader->GetSettings().ElevationMax == 30.0); // given
  // A tilted mount has no such window.
  files.Replace("assets.xml", "<scannerMount x=\"0\" y=\"0\" z=\"1.5\"/>",
    "<scannerMount z=\"1.5\"><rot axis=\"x\" angle_deg=\"10\"/></scannerMount>");
  const PlannerReading leaning(files);
  REQUIRE(leaning.Good);
  CHECK(leaning.Reader->GetSettings().ElevationMin == -90.0);
  CHECK(leaning.Log->HasWarning("tls is not a vertical polygon mirror with one channel"));
}

TEST_CASE("PlannerReader: a survey", "[PlannerReader]")
{
  const Files files;
  files.Write("survey.xml", Survey);
  PlannerReading reading(files, "survey.xml");
  INFO(reading.Log->Errors << reading.Log->Warnings);
  REQUIRE(reading.Good);
  CHECK(reading.Reader->GetKind() == "survey");
  CHECK(reading.Reader->GetPlanName() == "test");
  CHECK(reading.Reader->GetMethod().empty());
  CHECK(reading.Reader->GetSceneReference() == files / "scene.xml" + "#s");
  CHECK(reading.Reader->GetLegPulseFrequency() == 300000.0);
  CHECK(reading.Reader->GetLegScanFrequency() == 50.0);
  CHECK(reading.Reader->GetLegHeadRotatePerSecond() == 10.0);
  CHECK(reading.Reader->GetLegHeadRotateStop() == 360.0); // default of a plan
  CHECK(reading.Reader->GetLegVerticalAngleMin() == -30.0);
  CHECK(reading.Reader->GetLegVerticalAngleMax() == 40.0);
  // Leg settings for this scanner are not applied to another one.
  files.Replace("assets.xml", "<scanner id=\"als\"",
    "<scanner id=\"slow\" optics=\"rotating\" pulseFreqs_Hz=\"1000\" scanAngleMax_deg=\"60\" "
    "headRotatePerSecMax_deg=\"1\"/><scanner id=\"als\"");
  reading.Reader->SetScanner("assets.xml#slow");
  REQUIRE(reading.Reader->Read());
  CHECK(reading.Reader->GetScannerReference() == files / "assets.xml" + "#slow");
  CHECK(reading.Reader->GetLegPulseFrequency() == 1000.0);
  CHECK(reading.Log->Warnings.empty());
}

TEST_CASE("PlannerReader: a tripod given as an option replaces a flight", "[PlannerReader]")
{
  const Files files;
  const Reading survey(files, Flight, ThreeLegs);
  PlannerReading reading(files, "survey.xml");
  CHECK_FALSE(reading.Good);
  CHECK(reading.Log->HasError("platform plane moves, but positions are planned for a static "
                              "one; give a platform of type=\"static\""));
  reading.Reader->SetPlatform("assets.xml#tripod");
  reading.Reader->SetScanner("assets.xml#tls");
  CHECK(reading.Reader->Read());
}

TEST_CASE("PlannerReader: scenes and meshes", "[PlannerReader]")
{
  const Files files;
  const PlannerReading scene(files, "scene.xml", true);
  INFO(scene.Log->Errors);
  REQUIRE(scene.Good);
  CHECK(scene.Reader->GetKind() == "scene");
  CHECK(scene.Reader->GetPlanName() == "scene");
  CHECK(scene.Reader->GetSceneReference() == files / "scene.xml" + "#s");
  files.Write("the yard & more.obj", ReadText(files / "plane.obj"));
  const PlannerReading mesh(files, "the yard & more.obj", true);
  INFO(mesh.Log->Errors);
  REQUIRE(mesh.Good);
  CHECK(mesh.Reader->GetSceneReference().empty());
  for (vtkHeliosPlannerReader* reader : { scene.Reader.Get(), mesh.Reader.Get() })
  {
    reader->Update();
    CHECK(reader->GetOutput()->GetNumberOfCells() == 2);
    CHECK(reader->GetOutput()->GetBounds()[0] == -50.0);
  }
  CHECK_FALSE(PlannerReading(files, "scene.xml").Good);
  CHECK(PlannerReading(files, "scene.xml")
          .Log->HasError("scene.xml:1: a scene has no platform, "
                         "and none was given; give one"));
}

TEST_CASE("PlannerReader: a scene on port 0", "[PlannerReader]")
{
  const Files files;
  const PlannerReading file(files, "scene.xml", true);
  vtkNew<vtkHeliosPlannerReader> reader;
  const auto log = Observe(reader);
  reader->SetDefaultPlatform("assets.xml#tripod");
  reader->SetDefaultScanner("assets.xml#tls");
  reader->AddAssetDirectory((files / "").c_str());
  CHECK_FALSE(reader->Read());
  CHECK(log->HasError("FileName is not set, and there is no scene on port 0"));
  reader->SetInputConnection(file.Reader->GetOutputPort());
  REQUIRE(reader->Read());
  CHECK(reader->GetKind() == "scene");
  CHECK(reader->GetPlanName() == "plan");
  CHECK(reader->GetSceneReference().empty());
  CHECK(reader->GetScannerReference() == files / "assets.xml" + "#tls");
  CHECK(reader->GetSettings().ScannerHeight == Approx(1.7));
  reader->Update();
  CHECK(reader->GetOutput()->GetNumberOfCells() == 2);
  reader->SetScanner("assets.xml#tsl");
  CHECK_FALSE(reader->Read());
  CHECK(log->HasError("scene: scanner=\"assets.xml#tsl\": "));
  // The settings of a file, whose own scene is not read.
  reader->SetScanner(nullptr);
  WritePlanner(files, R"(maxSlope_deg="3")");
  files.Replace("plan.xml", "scene.xml", "none.xml");
  reader->SetFileName((files / "plan.xml").c_str());
  REQUIRE(reader->Read());
  CHECK(reader->GetSettings().MaximumSlope == 3.0);
  CHECK(reader->GetSceneReference().empty());
}

TEST_CASE("PlannerReader: defaults are for scenes", "[PlannerReader]")
{
  const Files files;
  PlannerReading reading(files, "scene.xml");
  reading.Reader->SetDefaultPlatform("assets.xml#tripod");
  reading.Reader->SetDefaultScanner("assets.xml#als");
  reading.Reader->SetScanner("assets.xml#tls");
  reading.Reader->SetUseScannerLimits(true);
  REQUIRE(reading.Reader->Read());
  CHECK(reading.Reader->GetScannerReference() == files / "assets.xml" + "#tls");
  CHECK(reading.Reader->GetScannerLimits());
  CHECK(reading.Reader->GetSettings().RangeMin == 0.5);
  CHECK(reading.Reader->GetSettings().ElevationMax == 50.0);
  WritePlanner(files, "");
  files.Replace("plan.xml", "platform=\"assets.xml#tripod\"", "");
  reading.Reader->SetFileName((files / "plan.xml").c_str());
  CHECK_FALSE(reading.Reader->Read());
  CHECK(reading.Log->HasError("<surveyPlanner> has no attribute platform"));
}

TEST_CASE("PlannerReader: the first of several is used", "[PlannerReader]")
{
  const Files files;
  WritePlanner(files, "");
  files.Replace("plan.xml", "</document>", "<surveyPlanner id=\"b\"/></document>");
  const PlannerReading planners(files);
  CHECK(planners.Good);
  CHECK(planners.Log->HasWarning("of several <surveyPlanner> in one file only the first is used"));
  files.Replace("scene.xml", "</document>", "<scene id=\"t\"/></document>");
  const PlannerReading scenes(files, "scene.xml", true);
  CHECK(scenes.Good);
  CHECK(scenes.Log->HasWarning("of several <scene> in one file only the first is used"));
}

TEST_CASE("PlannerReader: swaps", "[PlannerReader]")
{
  const Files files;
  files.Replace("scene.xml", "</part>",
    "<swap><filter type=\"scale\"><param key=\"scale\" value=\"2\"/></filter></swap></part>");
  const PlannerReading reading(WritePlanner(files, ""));
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  CHECK(reading.Log->HasWarning("the plan uses the first of its 2 epochs"));
  reading.Reader->Update();
  CHECK(reading.Reader->GetOutput()->GetBounds()[0] == -50.0);
}

TEST_CASE("PlannerReader: warns about turbid voxels", "[PlannerReader]")
{
  const Files files;
  files.Write("hedge.vox", "");
  files.Replace("scene.xml", "</part>",
    "</part><part id=\"hedge\"><filter type=\"detailedvoxels\"><param key=\"filepath\" "
    "value=\"hedge.vox\"/></filter></part>");
  const PlannerReading reading(WritePlanner(files, ""));
  INFO(reading.Log->Errors << reading.Log->Warnings);
  REQUIRE(reading.Good);
  CHECK(reading.Log->HasWarning("part hedge is turbid and hides nothing in a plan; for"));
}

namespace
{

/// Adds a car that follows a trajectory from (30, 10, 0), its wheel, and a parked trailer on the floor.
void AddCar(const Files& files)
{
  files.Write("car.obj", "v 0 0 1\nv 2 0 1\nv 0 2 1\nf 1 2 3\n");
  files.Write("car.csv", "7,0,0,0,30,10,0\n9,0,0,0,40,10,0\n");
  const std::string mesh = "<filter type=\"objloader\"><param type=\"string\" key=\"filepath\" "
                           "value=\"car.obj\"/></filter>";
  files.Replace("scene.xml", "</part>",
    "</part><part id=\"car\">" + mesh + "<trajectory file=\"car.csv\"/></part>" +
      "<part id=\"wheel\" mount=\"car\">" + mesh + "</part><part id=\"trailer\" mount=\"floor\">" +
      mesh + "</part>");
}

} // namespace

TEST_CASE("PlannerReader: parts that move are left out", "[PlannerReader]")
{
  const Files files;
  AddCar(files);
  const PlannerReading reading(WritePlanner(files, ""));
  INFO(reading.Log->Errors << reading.Log->Warnings);
  REQUIRE(reading.Good);
  CHECK(reading.Log->HasWarning(
    "scene.xml:1: the plan leaves out parts car and wheel, which move; "
    "set UseMovingParts (--moving-parts) to plan with them where they are at the start"));
  CHECK_FALSE(reading.Reader->GetMovingParts());
  reading.Reader->Update();
  CHECK(reading.Reader->GetOutput()->GetNumberOfPolys() == 3); // floor and trailer
}

TEST_CASE("PlannerReader: parts that move are where they start", "[PlannerReader]")
{
  const Files files;
  AddCar(files);
  const bool isAsked = GENERATE(false, true);
  const PlannerReading reading(
    WritePlanner(files, isAsked ? "movingParts=\"true\"" : ""), "plan.xml");
  reading.Reader->SetUseMovingParts(!isAsked);
  REQUIRE(reading.Reader->Read());
  CHECK(reading.Log->HasWarning(
    "the plan has parts car and wheel, which move, where they are at the start"));
  CHECK(reading.Reader->GetMovingParts());
  reading.Reader->Update();
  vtkPolyData* scene = reading.Reader->GetOutput();
  CHECK(scene->GetNumberOfPolys() == 5);
  double corner[3];
  scene->GetPoint(4, corner);
  CHECK((corner[0] == 30.0 && corner[1] == 10.0 && corner[2] == 1.0));
}

TEST_CASE("PlannerReader: a scene in which all moves is an error", "[PlannerReader]")
{
  const Files files;
  files.Replace("scene.xml", "</part>",
    "<dmotion id=\"a\" loop=\"0\"><motion type=\"translation\" vec=\"1;0;0\"/></dmotion></part>");
  const PlannerReading reading(WritePlanner(files, ""));
  CHECK_FALSE(reading.Good);
  CHECK(reading.Log->HasError(
    "scene.xml:1: all parts of the scene move (part floor), and a plan "
    "leaves them out; set UseMovingParts (--moving-parts) to plan with them"));
}

TEST_CASE("PlannerReader: values beyond a limit of the scanner are clipped", "[PlannerReader]")
{
  const Files files;
  const PlannerReading reading(WritePlanner(files, "",
    R"(<scannerSettings scanFreq_hz="500" headRotatePerSec_deg="1" headRotateStop_deg="360"/>)"));
  INFO(reading.Log->Errors << reading.Log->Warnings);
  CHECK(reading.Good);
  CHECK(reading.Log->HasWarning("scanFreq_hz=\"500\" is clipped to 120, scanFreqMax_Hz"));
}

TEST_CASE("PlannerReader: bad files are errors", "[PlannerReader]")
{
  const Files files;
  const auto fails =
    [&files](const std::string& more, const std::string& message, const std::string& children = "")
  {
    const PlannerReading reading(WritePlanner(files, more, children));
    INFO(more << children << "\n" << reading.Log->Errors);
    CHECK_FALSE(reading.Good);
    CHECK(reading.Log->HasError(message));
  };
  fails(R"(method="optimum")",
    "plan.xml:2: method=\"optimum\" is not valid; did you mean optimal? "
    "Expected reduce, bestcoverage, greedy, best or optimal");
  fails(R"(pspRemoveOrder="size")", "pspRemoveOrder=\"size\" is not valid: ");
  fails(R"(pspRemoveFirst="Largest")", "did you mean largest?");
  fails(R"(coverageOf="every")", "coverageOf=\"every\" is not valid: ");
  fails(R"(groundOnly="yes")", "groundOnly=\"yes\" is not valid: ");
  fails(R"(minCoverage_percent="101")", "minCoverage_percent=\"101\"");
  fails(R"(gridSizePSP_m="0")", "gridSizePSP_m=\"0\"");
  fails(R"(hitTolerance_m="5 cm")", "hitTolerance_m=\"5 cm\" is not a number");
  fails(R"(rangeMin_m="5" rangeMax_m="4")",
    "rangeMin_m=\"5\" is not below rangeMax_m=\"4\", so nothing is visible; give a smaller one");
  fails(R"(elevationMin_deg="5" elevationMax_deg="5")", "elevationMin_deg=\"5\" is not below");
  fails("", "never reaches it", R"(<scannerSettings headRotatePerSec_deg="-5" scanFreq_hz="50"/>)");

  WritePlanner(files, "");
  files.Replace("plan.xml", "#tls", "#als");
  CHECK(PlannerReading(files).Log->HasError("scanner als has a head that does not rotate"));
  files.Replace("plan.xml", "scanner=\"assets.xml#als\"", "");
  CHECK(PlannerReading(files).Log->HasError(
    "<surveyPlanner> has no attribute scanner; add scanner=\"file.xml#id\""));
  WritePlanner(files, "");
  files.Replace("plan.xml", "#tripod", "#tripot");
  CHECK(PlannerReading(files).Log->HasError("did you mean tripod?"));
  files.Replace("assets.xml", "z=\"1.5\"", "z=\"-1.5\"");
  CHECK(PlannerReading(WritePlanner(files, ""))
          .Log->HasError("platform tripod carries the scanner -1.3 m above the scan position, but "
                         "the height must be above 0"));
  CHECK(PlannerReading(files, "assets.xml").Log->HasError("the file has nothing to plan"));
  CHECK(PlannerReading(files, "none.xml")
          .Log->HasError("none.xml: no such file; give the name of an XML or YAML file"));
  CHECK(PlannerReading(files, "none.obj", true)
          .Log->HasError("none.obj: no such file; give the name of an existing mesh"));
}

TEST_CASE("PlannerReader: bad options are errors", "[PlannerReader]")
{
  const Files files;
  PlannerReading reading(files, "scene.xml", true);
  reading.Reader->SetScanner("assets.xml#tsl");
  CHECK_FALSE(reading.Reader->Read());
  CHECK(reading.Log->HasError("scene.xml: scanner=\"assets.xml#tsl\": "));
  CHECK(reading.Log->HasError("did you mean tls?"));
  reading.Reader->SetFileName(nullptr);
  CHECK_FALSE(reading.Reader->Read());
  CHECK(reading.Log->HasError("FileName is not set"));
}

TEST_CASE("PlannerReader: misspelt names, and runs of planner documents", "[PlannerReader]")
{
  const Files files;
  const PlannerReading reading(WritePlanner(files, R"(gridSizePSP="3" minCoverage_procent="3")"));
  CHECK(reading.Log->HasWarning("attribute gridSizePSP of <surveyPlanner> is unknown; did you mean "
                                "gridSizePSP_m?"));
  CHECK(reading.Log->HasWarning("did you mean minCoverage_percent?"));
  vtkNew<vtkHeliosSurveyReader> survey;
  const auto log = Observe(survey);
  survey->SetFileName((files / "plan.xml").c_str());
  CHECK_FALSE(survey->Read());
  CHECK(
    log->HasError("the file has no <survey>; vtkhelios plan creates one from its <surveyPlanner>"));
}

TEST_CASE("PlannerReader: is checked with the rest of the file", "[PlannerReader]")
{
  const Files files;
  vtkNew<vtkHeliosSurveyReader> reader;
  const auto log = Observe(reader);
  reader->SetFileName((files / "plan.xml").c_str());
  WritePlanner(files, R"(method="best")");
  CHECK(reader->Check());
  WritePlanner(files, R"(method="beast" maxSlope_deg="91")");
  CHECK_FALSE(reader->Check());
  CHECK(log->HasError("plan.xml:2: method=\"beast\" is not valid"));
  CHECK(log->HasError("plan.xml:2: maxSlope_deg=\"91\""));
  WritePlanner(files, "");
  files.Replace("scene.xml", "id=\"s\"", "id=\"s\" crs=\"EPSG:0\"");
  CHECK_FALSE(reader->Check());
  CHECK(log->HasError("crs=\"EPSG:0\""));
}

TEST_CASE("PlannerReader: can be aborted while loading", "[PlannerReader]")
{
  const Files files;
  const PlannerReading reading(files, "scene.xml", true);
  reading.Reader->AddObserver(
    vtkCommand::ProgressEvent, reading.Reader.Get(), &vtkHeliosPlannerReader::AbortExecuteOn);
  reading.Reader->Update();
  CHECK(reading.Log->HasError("stopped while the scene was loaded"));
  CHECK(reading.Reader->GetOutput()->GetNumberOfCells() == 0);
}
