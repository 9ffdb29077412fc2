// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyFiles.h"
#include "vtkHeliosDialect.h"
#include "vtkHeliosSurveyPlayer.h"

#include <catch2/catch.hpp>

using namespace helios::test;

namespace
{

/// A reader that checks survey.xml.
struct Checking
{
  vtkNew<vtkHeliosSurveyReader> Reader;
  vtkSmartPointer<helios::ErrorObserver> Log = Observe(Reader);
  bool Good;

  explicit Checking(const Files& files)
  {
    this->Reader->SetFileName((files / "survey.xml").c_str());
    this->Good = this->Reader->Check();
  }

  int CountErrors() const
  {
    int count = 0;
    for (std::size_t at = this->Log->Errors.find("ERROR:"); at != std::string::npos;
         at = this->Log->Errors.find("ERROR:", at + 1))
    {
      ++count;
    }
    return count;
  }
};

const char* const NeverThere = R"(<leg><scannerSettings scanFreq_hz="50" headRotatePerSec_deg="-10"
 headRotateStop_deg="10"/></leg>)";

} // namespace

TEST_CASE("SurveyCheck: a valid survey", "[SurveyCheck]")
{
  const Files files;
  const Reading reading(files, Tripod, OneLeg);
  const Checking checking(files);
  INFO(checking.Log->Errors);
  CHECK(checking.Good);
  CHECK(checking.Reader->GetSurvey() == nullptr);
}

TEST_CASE("SurveyCheck: legs are checked despite errors of the scanner", "[SurveyCheck]")
{
  const Files files;
  files.Replace("assets.xml", "scanAngleMax_deg=\"120\"", "scanAngleMax_deg=\"wide\"");
  const Reading reading(files, Tripod, NeverThere);
  INFO(reading.Log->Errors);
  CHECK(reading.Log->HasError("scanAngleMax_deg=\"wide\" is not a number"));
  CHECK(reading.Log->HasError("never reaches it"));
  CHECK(Checking(files).CountErrors() == 2); // no consequential errors: no angle, no window
}

TEST_CASE("SurveyCheck: errors that follow from another are not reported", "[SurveyCheck]")
{
  const Files files;
  const auto count = [&files](const std::string& attributes, const std::string& legs)
  {
    const Reading reading(files, attributes, legs);
    const Checking checking(files);
    INFO(checking.Log->Errors);
    CHECK_FALSE(checking.Good);
    return checking.CountErrors();
  };
  CHECK(count(R"(platform="assets.xml#tripot" scanner="assets.xml#tls")", NeverThere) == 1);
  CHECK(count(R"(platform="assets.xml#tripod" scanner="assets.xml#tsl")", NeverThere) == 2);
  const std::string unread = std::string(NeverThere).replace(5, 0, "<platformSettings x=\"a\"/>");
  CHECK(count(Tripod, unread) == 1);
  CHECK(count(Tripod, unread + OneLeg + NeverThere) == 2);
}

TEST_CASE("SurveyCheck: unused elements, and names looked up by runs", "[SurveyCheck]")
{
  const Files files;
  files.Replace("assets.xml", "</document>",
    "<scanner id=\"unused\" optics=\"conic\"/>\n<scene id=\"empty\" crs=\"EPSG:0\"/></document>");
  files.Write("survey.xml", ReadText(files / "assets.xml"));
  const Checking checking(files);
  INFO(checking.Log->Errors);
  CHECK(checking.Log->HasError("scanner unused: scanAngleMax_deg is missing"));
  CHECK(checking.Log->HasError("scene empty has no <part>"));
  CHECK(checking.Log->HasError("crs=\"EPSG:0\""));
  CHECK(checking.CountErrors() == 3);
  const Reading reading(files, std::string(Tripod) + " rayCaster=\"torch\"", OneLeg);
  CHECK(reading.Good);
  CHECK(Checking(files).Log->HasError("rayCaster=\"torch\" is not in this build; give one of"));
  const Reading leg(files, Tripod, R"(<leg><platformSettings trajectoryCrs="EPSG:1"/></leg>)");
  CHECK(Checking(files).Log->HasError("survey.xml:4: trajectoryCrs=\"EPSG:1\" "));
  files.Write("survey.xml", "<document/>");
  CHECK(Checking(files).Log->HasError("survey.xml:1: <document> is empty"));
}

TEST_CASE("SurveyCheck: a missing FileName is an error", "[SurveyCheck]")
{
  vtkNew<vtkHeliosSurveyReader> reader;
  const auto log = Observe(reader);
  CHECK_FALSE(reader->Check());
  CHECK(log->HasError("FileName is not set"));
}

TEST_CASE("SurveyCheck: a trajectory has at most one sample per pulse", "[SurveyCheck]")
{
  const Files files;
  std::string leg = OneLeg;
  leg.replace(
    leg.find("scanFreq_hz"), 0, "pulseFreq_hz=\"100000\" trajectoryTimeInterval_s=\"1e-9\" ");
  const Reading reading(files, Tripod, leg);
  REQUIRE(reading.Good);
  CHECK(reading.Log->HasWarning(
    "trajectoryTimeInterval_s=\"1e-09\" is shorter than the time between pulses"));
  CHECK(reading.Data().Legs.front().TrajectoryTimeInterval == 1e-5);
}

TEST_CASE("SurveyCheck: errors of runs are reported with their position", "[SurveyCheck]")
{
  const Files files;
  vtkNew<vtkHeliosSurveyPlayer> player;
  const auto log = Observe(player);
  player->SetOutputDirectory((files / "out").c_str());
  SECTION("of a part")
  {
    files.Write("plane.obj", "v 0 0 nan\n");
    const Reading reading(files, Tripod, OneLeg);
    player->SetSurvey(reading.Reader->GetSurvey());
    CHECK_FALSE(player->Run());
    CHECK(log->HasError("scene.xml:1: "));
    CHECK(log->HasError("plane.obj:1: "));
  }
  SECTION("a leg without hits")
  {
    std::string leg = OneLeg;
    leg.replace(leg.find("z=\"3\""), 5, "z=\"-900\"");
    const Reading reading(files, Tripod, leg);
    player->SetSurvey(reading.Reader->GetSurvey());
    CHECK_FALSE(player->Run());
    CHECK(log->HasError("survey.xml:5: No points: "));
  }
  SECTION("of a leg with more pulses than can be")
  {
    std::string leg = OneLeg;
    leg.replace(leg.find("scanFreq_hz"), 0, "pulseFreq_hz=\"1e9\" maxDuration_s=\"1e9\" ");
    leg.replace(leg.find("_deg=\"10\" h"), 9, "_deg=\"1e-8\"");
    const Reading reading(files, Tripod, leg);
    REQUIRE(reading.Good);
    player->SetSurvey(reading.Reader->GetSurvey());
    player->SetPulsesPerBlock(100);
    CHECK_FALSE(player->Run());
    INFO(log->Errors);
    CHECK(log->HasError("pulses are more than a leg can have"));
  }
}

TEST_CASE("Dialect: every name is described, keywords are enumerated", "[Dialect]")
{
  CHECK(vtkHeliosDialect::FindUndescribed().empty());
  const std::string schema = vtkHeliosDialect::GetSchema();
  CHECK(schema.find("<xs:enumeration value=\"rotating\"/>") != std::string::npos);
  CHECK(schema.find("<xs:complexType name=\"scanner\">") != std::string::npos);
  CHECK(schema.find("filter:") == std::string::npos);
  CHECK(vtkHeliosDialect::GetTables().find("### filter `objloader`") != std::string::npos);
}
