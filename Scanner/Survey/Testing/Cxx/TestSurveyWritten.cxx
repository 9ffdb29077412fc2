// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Surveys of any origin are written, and read back as they are.
#include "heliosSurveyEquality.h"
#include "heliosSurveyFiles.h"
#include "vtkHeliosDialect.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

using namespace helios;
using namespace helios::test;
namespace fs = std::filesystem;

namespace
{

/// Compares a survey with what is read from a file.
void CheckFile(
  vtkHeliosSurvey* survey, const std::string& copy, const std::vector<std::string>& assets)
{
  vtkNew<vtkHeliosSurveyReader> reader;
  const auto log = Observe(reader);
  reader->SetFileName(copy.c_str());
  reader->SetSceneRequired(survey->GetNumberOfParts() > 0);
  for (const std::string& folder : assets)
  {
    reader->AddAssetDirectory(folder.c_str());
  }
  const bool isRead = reader->Read();
  INFO(log->Errors << ReadText(copy));
  REQUIRE(isRead);
  CHECK(FindDifferences(survey->GetData(), reader->GetSurvey()->GetData()) == "");
}

/// Writes a survey to a new folder as XML and YAML, and compares what is read from there, and from each
/// when it is converted into the other. YAML, once written, stays the same text.
void CheckWritten(vtkHeliosSurvey* survey, const std::vector<std::string>& assets)
{
  const Files other;
  const std::string copy = other / "some/where/copy.";
  fs::create_directories(fs::path(copy).parent_path());
  vtkNew<vtkHeliosDialect> dialect;
  REQUIRE(survey->WriteFile(copy + "xml"));
  REQUIRE(survey->WriteFile(copy + "yaml"));
  REQUIRE(dialect->Convert(copy + "xml", copy + "2.yml"));
  REQUIRE(dialect->Convert(copy + "yaml", copy + "2.xml"));
  REQUIRE(dialect->Convert(copy + "2.xml", copy + "3.yaml"));
  for (const char* ending : { "xml", "yaml", "2.yml", "2.xml" })
  {
    CheckFile(survey, copy + ending, assets);
  }
  CHECK(ReadText(copy + "yaml") == ReadText(copy + "3.yaml"));
  CHECK(ReadText(copy + "yaml") == ReadText(copy + "2.yml"));
}

/// All surveys in a folder that can be read with asset directories.
int CheckFolder(const fs::path& folder, const std::vector<std::string>& assets)
{
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
  {
    if (entry.path().extension() != ".xml")
    {
      continue;
    }
    vtkNew<vtkHeliosSurveyReader> reader;
    const auto log = Observe(reader);
    reader->SetFileName(entry.path().c_str());
    for (const std::string& one : assets)
    {
      reader->AddAssetDirectory(one.c_str());
    }
    INFO(entry.path());
    if (reader->Read())
    {
      CheckWritten(reader->GetSurvey(), assets);
      ++count;
    }
  }
  return count;
}

const std::string Root = fs::path(__FILE__).parent_path() / "../../../..";

} // namespace

TEST_CASE("SurveyWritten: surveys of files", "[SurveyWritten]")
{
  const Files files;
  files.Write("plate.obj", ReadText(files / "plane.obj"));
  files.Write("pulse.txt", "0 0\n1 1\n2 0\n");
  files.Write("grass.xyz", "0 0 1\n1 0 1\n");
  files.Write("stand.csv", "model,x,y\nplane.obj,1,2\nplane.obj,3,4\n");
  files.Write("flight.txt", "0,0,0,0,0,0,50\n1,0,0,0,10,0,50\n");
  files.Write("beams.csv", "elevation_deg\n-10\n-20\n");
  files.Write("scene.xml", R"(<document><scene id="s" crs="EPSG:25832" dynTimeStep="0.1">
<part><filter type="objloader"><param key="efilepath" value="pl.*[.]obj"/></filter>
<filter type="Rotate"><param key="rotation"><rot axis="z" angle_deg="10"/></param></filter>
<dmotion loop="0"><motion type="rotation" axis="0;0;1" angle="3" selfMode="true"/></dmotion></part>
<part id="grass"><filter type="xyzloader"><param key="filepath" value="grass.xyz"/>
<param key="normalXIndex" value="0"/></filter></part>
<part><filter type="objloader"><param key="filepath" value="plane.obj"/></filter>
<swap><filter type="translate"><param key="offset" value="1;2;3"/></filter></swap></part>
<partTable file="stand.csv" seed="4" yawMax_deg="360"/></scene></document>)");
  files.Replace("assets.xml", "<scanner id=\"als\"",
    "<scanner id=\"two\" optics=\"spinning\" pulseFreqs_Hz=\"1000\"><beams file=\"beams.csv\"/>"
    "<channels><channel/><channel id=\"b\" maxNOR=\"3\"/></channels></scanner>\n<scanner "
    "id=\"als\"");
  const std::string legs = R"(<platformSettings id="t" onGround="true" x="7"/>
<FWFSettings binSize_ns="0.1"/>)" +
    std::string(OneLeg) +
    R"(<leg scanner="assets.xml#two"><platformSettings template="t" y="3"/>
<scannerSettings maxDuration_s="2" scanFreq_hz="10"/></leg><origin x="5"/>
<scan platform="assets.xml#tripod" scanner="assets.xml#tls"><scannerRotation end="90"/>
<leg x="1"><maxDuration_s>3</maxDuration_s></leg></scan>
<leg platform="interpolated"><platformSettings trajectory="flight.txt" trajectory_separator=","/>
<scannerSettings scanFreq_hz="50"/></leg><FWFSettings pulseShape="pulse.txt"/>
<detectorSettings distanceMeasurementError="1 + t"/><attitudeZNoise stdev="0.1"/>
<scannerMount z="3"/>)";
  const Reading reading(
    files, Tripod + std::string(" seed=\"5\" basePlatform=\"assets.xml#plane\""), legs);
  INFO(reading.Log->Errors);
  REQUIRE(reading.Good);
  vtkHeliosSurvey* survey = reading.Reader->GetSurvey();
  CheckWritten(survey, {});
  const SurveyData before = survey->GetData();

  // Elements of other files and origins move into the document, and nothing else changes.
  CHECK(survey->SetScannerAttribute(0, "accuracy_m", "0.005"));
  CHECK(survey->SetChannelAttribute(1, 1, "maxNOR", "3"));
  CHECK(survey->SetScannerAttribute(0, "binSize_ns", "0.25"));
  CHECK(survey->SetPlatformAttribute(0, "attitudeZNoise/stdev", "0.1"));
  CHECK(survey->SetPlatformAttribute(1, "scannerMount/z", "3"));
  CHECK(survey->SetPartAttribute(1, "id", "1"));
  CHECK(survey->SetLegAttribute(2, "x", "6"));
  CHECK(FindDifferences(before, survey->GetData()) == "");
  CheckWritten(survey, {});

  CHECK(survey->SetLegAttribute(1, "y", "4"));
  CHECK(survey->SetScannerAttribute(0, "beamDivergence_rad", "0.001"));
  CHECK(survey->SetPlatformAttribute(1, "positionXNoise/stdev", "0.2"));
  CHECK(FindDifferences(before, survey->GetData()) ==
    "survey.Scanners[0].BeamDivergence\nsurvey.Platforms[1].Noise[0].IsOn\n"
    "survey.Platforms[1].Noise[0].Deviation\nsurvey.Settings[1].Leg.Position[1]\n"
    "survey.Legs[0].Scans[0].BeamDivergence\nsurvey.Legs[1].Position[1]\n"
    "survey.Legs[2].Scans[0].BeamDivergence\nsurvey.Legs[3].Scans[0].BeamDivergence\n");
  CheckWritten(survey, {});
}

TEST_CASE("SurveyWritten: surveys made by methods", "[SurveyWritten]")
{
  const Files files;
  vtkNew<vtkHeliosSurvey> survey;
  survey->AddAssetDirectory(files / "");
  survey->SetName("made");
  CHECK(survey->AddScanner("own") == 0);
  CHECK(survey->SetScannerAttribute(0, "scanAngleMax_deg", "60"));
  CHECK(survey->AddChannel(0) == 1);
  CHECK(survey->SetChannelAttribute(0, 1, "beamOrigin/rot/axis", "x"));
  CHECK(survey->SetChannelAttribute(0, 1, "beamOrigin/rot/angle_deg", "2"));
  CHECK(survey->AddScannerFromFile("assets.xml#tls") == 1);
  CHECK(survey->AddScannerFromFile("assets.xml#tls") == 2);
  CHECK(survey->SetScannerAttribute(2, "visModel", "plane.obj"));
  CHECK(survey->AddPlatformFromFile("assets.xml#tripod") == 0);
  CHECK(survey->AddPlatformFromFile("assets.xml#plane") == 1);
  CHECK(survey->SetPlatformAttribute(1, "navigationError/grade", "survey"));
  for (const auto& loader : { "objloader", "plyloader" })
  {
    CHECK(survey->AddPart(loader, "plane.obj") >= 0);
  }
  CHECK(survey->RotatePart(1, "z", 33.3));
  CHECK(survey->SetPartAttribute(1, "swap/force_null", "true"));
  CHECK(survey->AddPartTable("") == 0);
  CHECK(survey->SetPartTableAttribute(0, "model/id", "p"));
  CHECK(survey->SetPartTableAttribute(0, "model/objloader/filepath", "plane.obj"));
  CHECK(survey->SetPartTableRows(0, "model,x,y,z\np,1,2,0\np,0,-1,\n"));
  for (int leg = 0; leg < 6; ++leg)
  {
    CHECK(survey->AddLeg(leg % 3, leg < 4 ? 0 : 1) == leg);
    CHECK(survey->SetLegAttribute(leg, "pulseFreq_hz", "100000"));
    CHECK(survey->SetLegAttribute(leg, "maxDuration_s", "1"));
    CHECK(survey->SetLegPosition(leg, leg, 0.1, -leg));
  }
  const auto log = Observe(survey);
  const bool isGood = survey->Check();
  INFO(log->Errors);
  CHECK(isGood);
  CheckWritten(survey, { files / "" });
  CHECK_FALSE(survey->WriteFile(files / "plane.obj/survey.xml"));
  CHECK(log->HasError("plane.obj"));
}

TEST_CASE("SurveyWritten: a scanner and a scene are files of their own", "[SurveyWritten]")
{
  const Files files;
  vtkNew<vtkHeliosSurvey> survey;
  const auto log = Observe(survey);
  survey->AddAssetDirectory(files / "");
  CHECK(survey->AddScanner("own") == 0);
  CHECK(survey->SetScannerAttribute(0, "name", "a & b"));
  CHECK(survey->SetScannerAttribute(0, "use", "airborne"));
  CHECK(survey->SetScannerAttribute(0, "sources/source[0]/kind", "derived"));
  CHECK(survey->SetScannerAttribute(0, "sources/source[1]/note", "by hand"));
  CHECK(survey->SetScannerAttribute(0, "beams/beam[0]/elevation_deg", "3"));
  CHECK(survey->GetScannerAttribute(0, "sources/source[1]/note") == "by hand");
  CHECK(survey->MakeFileText("scanner", 0, " mine ", "") ==
    R"(<?xml version="1.0" encoding="UTF-8"?>
<!-- mine -->
<document>
  <scanner id="own" optics="rotating" name="a &amp; b" use="airborne">
    <sources>
      <source kind="derived" />
      <source note="by hand" />
    </sources>
    <beams>
      <beam elevation_deg="3" />
    </beams>
  </scanner>
</document>
)");
  CHECK(survey->AddPart("objloader", "plane.obj") == 0);
  CHECK_THAT(survey->MakeFileText("scene", 0, "", files / "new.xml"),
    Catch::Contains(R"(value="plane.obj")"));
  CHECK(survey->MakeFileText("scanner", 1, "", "").empty());
  CHECK(log->HasError("scanner 1 does not exist; there are 1, counted from 0"));
  CHECK(survey->MakeFileText("detector", 0, "", "").empty());
}

TEST_CASE("SurveyWritten: what is named need not exist yet", "[SurveyWritten]")
{
  const Files files;
  vtkNew<vtkHeliosSurvey> survey;
  survey->AddAssetDirectory(files / "");
  survey->SetSources("later.xml#s", "assets.xml#tripod", "assets.xml#tls");
  REQUIRE(survey->WriteFile(files / "new.xml"));
  CHECK_THAT(ReadText(files / "new.xml"), Catch::Contains(R"(scene="later.xml#s")"));
  CHECK_FALSE(survey->Check());
  survey->SetSources(files / "plane.obj", "", "");
  CHECK(survey->GetNumberOfParts() == 1);
  CHECK(survey->GetNumberOfScanners() == 1);
  CHECK(survey->AddLeg() == 0);
  CHECK(survey->SetLegAttribute(0, "scanFreq_hz", "50"));
  CHECK(survey->SetLegAttribute(0, "headRotatePerSec_deg", "10"));
  CHECK(survey->SetLegAttribute(0, "headRotateStop_deg", "10"));
  CHECK(survey->Check());
  REQUIRE(survey->WriteFile(files / "new.xml"));
  CHECK_THAT(ReadText(files / "new.xml"),
    Catch::Contains(R"(value="plane.obj")") && Catch::Contains(R"(scene="scene")"));
}

TEST_CASE("SurveyWritten: names are as given in the same folder", "[SurveyWritten]")
{
  const Files files;
  files.Write("below/survey.xml",
    std::string(
      "<document><survey name=\"n\" scene=\"../scene.xml#s\" platform=\"../assets.xml#tripod\" "
      "scanner=\"../assets.xml#tls\">") +
      OneLeg + "</survey></document>");
  vtkNew<vtkHeliosSurveyReader> reader;
  reader->SetFileName((files / "below/survey.xml").c_str());
  REQUIRE(reader->Read());
  REQUIRE(reader->GetSurvey()->WriteFile(files / "below/new.xml"));
  CHECK_THAT(ReadText(files / "below/new.xml"), Catch::Contains(R"(scene="../scene.xml#s")"));
  REQUIRE(reader->GetSurvey()->WriteFile(files / "new.xml"));
  CHECK_THAT(ReadText(files / "new.xml"), Catch::Contains(R"(scene="scene.xml#s")"));
}

TEST_CASE("SurveyWritten: surveys of the tree and of HELIOS_SURVEYS", "[SurveyWritten]")
{
  const std::vector<std::string> assets = { Root + "/Data/Assets", Root + "/Data" };
  const Files files;
  files.Replace("scene.xml", "id=\"s\"", "id=\"village\"");
  fs::rename(files / "scene.xml", files / "village_scene.xml");
  for (const auto& entry : fs::directory_iterator(Root + "/Data/Surveys"))
  {
    fs::copy(entry.path(), files / "");
  }
  CHECK(CheckFolder(files / "", assets) > 3);
  if (const char* folder = std::getenv("HELIOS_SURVEYS"))
  {
    CHECK(CheckFolder(folder, { folder, assets[0], assets[1] }) > 0);
  }
}
