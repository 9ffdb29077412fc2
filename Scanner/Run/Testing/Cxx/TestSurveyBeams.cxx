// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Spinning heads of the dialect: beams in XML and in tables.
#include "heliosLegOptics.h"
#include "heliosSurveyFiles.h"
#include "vtkHeliosSpinningChannels.h"
#include "vtkHeliosSurveyPlayer.h"

#include <catch2/catch.hpp>

#include <string>
#include <utility>
#include <vector>

using namespace helios::test;

namespace
{

const std::string Head = R"(optics="spinning" pulseFreqs_Hz="20000" spin="clockwise" )"
                         R"(spinStart_deg="90" rangeMin_m="0.1">)";
const std::string Beams = R"(<beams><beam elevation_deg="-30" azimuth_deg="1.5"/>
<beam elevation_deg="-45" originOffset_m="0.0125" originHeight_m="-0.002" firingTime_s="0.00001"/>
</beams></scanner>)";

/// A survey on a tripod for 0.1 s with this scanner, and a table of beams.
struct Bench
{
  Files Folder;
  helios::test::Reading Reading;

  Bench(const std::string& scanner, const std::string& table,
    const std::string& leg = R"(scanFreq_hz="10")")
    : Reading(Write(Folder, scanner, table),
        R"(platform="assets.xml#tripod" scanner="own.xml#own")",
        "<leg><platformSettings z=\"10\"/>\n<scannerSettings maxDuration_s=\"0.1\" " + leg +
          "/></leg>")
  {
  }

  const helios::ScannerData& Scanner() const { return this->Reading.Data().Scanners.at(0); }

  void CheckRefused(const std::vector<std::string>& messages) const
  {
    INFO(this->Reading.Log->Errors);
    CHECK_FALSE(this->Reading.Good);
    for (const std::string& message : messages)
    {
      INFO("missing: " << message);
      CHECK(this->Reading.Log->HasError(message));
    }
  }

private:
  static const Files& Write(
    const Files& files, const std::string& scanner, const std::string& table)
  {
    files.Write("own.xml", "<document>\n<scanner id=\"own\" " + scanner + "</document>");
    files.Write("beams.csv", table);
    return files;
  }
};

const std::string FromTable = Head + R"(<beams file="beams.csv"/></scanner>)";

} // namespace

TEST_CASE("SurveyBeams: a spinning head of beams in XML", "[SurveyBeams]")
{
  const Bench bench(Head + Beams, "");
  INFO(bench.Reading.Log->Errors << bench.Reading.Log->Warnings);
  REQUIRE(bench.Reading.Good);
  CHECK(bench.Reading.Log->Warnings.empty());
  const auto deflector =
    helios::MakeDeflector(bench.Scanner(), bench.Reading.Data().Legs.at(0).Scans.at(0));
  auto* head = vtkHeliosSpinningChannels::SafeDownCast(deflector);
  REQUIRE(head);
  CHECK(head->GetPulseFrequency() == 20000.0);
  CHECK(head->GetScanFrequency() == -10.0);
  CHECK(head->GetStartAngle() == 90.0);
  REQUIRE(head->GetNumberOfChannels() == 2);
  CHECK(head->GetElevation(0) == -30.0);
  CHECK(head->GetAzimuth(0) == 1.5);
  CHECK(head->GetFiringTime(0) < 0.0); // evenly
  CHECK(head->GetOriginOffset(0) == 0.0);
  CHECK(head->GetElevation(1) == -45.0);
  CHECK(head->GetOriginOffset(1) == 0.0125);
  CHECK(head->GetOriginHeight(1) == -0.002);
  CHECK(head->GetFiringTime(1) == 1e-5);
}

TEST_CASE("SurveyBeams: a run hits the floor where the beams point", "[SurveyBeams]")
{
  const Bench bench(Head + Beams, "");
  vtkNew<vtkHeliosSurveyPlayer> player;
  player->SetSurvey(bench.Reading.Reader->GetSurvey());
  player->SetOutputDirectory((bench.Folder / "out").c_str());
  REQUIRE(player->Run());
  CHECK(player->GetNumberOfPulses() == 2000);
  CHECK(player->GetCount("firstReturns") == 2000); // 11.5 m up, both within 20 m
}

TEST_CASE("SurveyBeams: a table has the names of attributes", "[SurveyBeams]")
{
  const Bench bench(FromTable,
    "# a comment\n\nfiringTime_s , elevation_deg,originOffset_m\r\n0,-30,0.0125\n # again\n"
    "1e-5,-45 , -0.5\n");
  INFO(bench.Reading.Log->Errors << bench.Reading.Log->Warnings);
  REQUIRE(bench.Reading.Good);
  CHECK(bench.Scanner().BeamFile == bench.Folder / "beams.csv");
  const auto& beams = bench.Scanner().Beams;
  REQUIRE(beams.size() == 2);
  CHECK(beams[0].Elevation == -30.0);
  CHECK(beams[0].FiringTime == 0.0);
  CHECK(beams[0].OriginOffset == 0.0125);
  CHECK(beams[1].Elevation == -45.0);
  CHECK(beams[1].FiringTime == 1e-5);
  CHECK(beams[1].OriginOffset == -0.5);
  CHECK(beams[1].Azimuth == 0.0);
}

TEST_CASE("SurveyBeams: tables that are not valid", "[SurveyBeams]")
{
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases = {
    { "", { "beams.csv: has no beams", "a line per beam" } },
    { "elevation_deg\n", { "beams.csv: has no beams" } },
    { "azimuth_deg\n1\n", { "beams.csv:1: there is no column elevation_deg; add it" } },
    { "elevation_deg,azimut_deg\n1,2\n",
      { "beams.csv:1: column \"azimut_deg\" is unknown; did you mean azimuth_deg?" } },
    { "elevation_deg,temperature\n1,2\n",
      { "beams.csv:1: column \"temperature\" is unknown; the columns are elevation_deg, " } },
    { "elevation_deg,azimuth_deg\n1,2\n3\n",
      { "beams.csv:3: a row of 1 columns, and the first has 2 names" } },
    { "elevation_deg\n1\nhigh\n", { "beams.csv:3: elevation_deg=\"high\" is not" } },
    { "elevation_deg\n91\n", { "beams.csv:2: elevation_deg=\"91\" is out of range" } },
    { "elevation_deg,originOffset_m\n1,20\n",
      { "beams.csv:2: originOffset_m=\"20\" is out of range" } },
  };
  for (const auto& [table, messages] : cases)
  {
    INFO(table);
    Bench(FromTable, table).CheckRefused(messages);
  }
  std::string many = "elevation_deg\n";
  for (int i = 0; i <= 100000; ++i)
  {
    many += "1\n";
  }
  Bench(FromTable, many).CheckRefused({ "beams.csv:100002: more than 100000 beams" });
}

TEST_CASE("SurveyBeams: beams that are not valid", "[SurveyBeams]")
{
  Bench(Head + "</scanner>", "")
    .CheckRefused({ "own.xml:2: scanner own has no beams; give <beams>" });
  Bench(Head + "<beams/></scanner>", "").CheckRefused({ "scanner own has no beams" });
  Bench(Head + "<beams><beam azimuth_deg=\"1\"/></beams></scanner>", "")
    .CheckRefused({ "own.xml:2: <beam> has no elevation_deg; give its angle" });
  Bench(Head + "<beams file=\"beams.csv\"><beam elevation_deg=\"1\"/></beams></scanner>", "")
    .CheckRefused({ "own.xml:2: <beams> has a file and <beam> children; give one of them" });
  Bench(Head + "<beams file=\"none.csv\"/></scanner>", "")
    .CheckRefused({ "own.xml:2: file=\"none.csv\": no such file", "looked for" });
  Bench(Head + "<beams><beam elevation_deg=\"-91\"/></beams></scanner>", "")
    .CheckRefused({ "elevation_deg=\"-91\" is out of range" });
}

TEST_CASE("SurveyBeams: settings of a leg", "[SurveyBeams]")
{
  Bench(Head + Beams, "", "")
    .CheckRefused(
      { "survey.xml:5: scanFreq_hz is missing or 0, so the head of scanner own does not" });
  Bench(FromTable, "elevation_deg,firingTime_s\n1,0\n2,0.0001\n")
    .CheckRefused(
      { "survey.xml:5: beam 1 of scanner own fires at firingTime_s=\"0.0001\", after "
        "the cycle of 0.0001 s that 2 beams have at pulseFreq_hz=\"20000\"; give a lower" });
  const Bench angle(Head + Beams, "", R"(scanFreq_hz="10" scanAngle_deg="20")");
  CHECK(angle.Reading.Good);
  CHECK(angle.Reading.Log->HasWarning("scanAngle_deg is not used by spinning optics"));
}

TEST_CASE("SurveyBeams: a channel inherits the beams or has its own", "[SurveyBeams]")
{
  const std::string list = Beams.substr(0, Beams.rfind("</scanner>"));
  const Bench bench(Head + list +
      R"(<channels><channel/><channel><beams file="beams.csv"/></channel></channels></scanner>)",
    "elevation_deg\n-10\n-20\n-30\n");
  INFO(bench.Reading.Log->Errors);
  REQUIRE(bench.Reading.Good);
  CHECK(bench.Scanner().GetChannel(0).Beams.size() == 2);
  CHECK(bench.Scanner().GetChannel(1).Beams.size() == 3);
}

TEST_CASE("SurveyBeams: beams are set by paths", "[SurveyBeams]")
{
  const Files files;
  files.Write("beams.csv", "elevation_deg\n-10\n-20\n-30\n");
  vtkNew<vtkHeliosSurvey> made;
  const auto log = Observe(made);
  made->AddAssetDirectory(files / "");
  made->AddScanner("own");
  CHECK(made->SetScannerAttribute(0, "optics", "spinning"));
  CHECK(made->SetScannerAttribute(0, "beams/beam/elevation_deg", "-30"));
  CHECK(made->SetScannerAttribute(0, "beams/beam[1]/elevation_deg", "-45"));
  CHECK(made->SetScannerAttribute(0, "beams/beam[1]/originOffset_m", "0.0125"));
  INFO(log->Errors);
  REQUIRE(made->GetData().Scanners.at(0).Beams.size() == 2);
  CHECK(made->GetData().Scanners.at(0).Beams[1].OriginOffset == 0.0125);
  CHECK(made->SetScannerAttribute(0, "beams/beam[1]", ""));
  CHECK(made->SetScannerAttribute(0, "beams/beam[0]", ""));
  CHECK(made->SetScannerAttribute(0, "beams/file", "beams.csv"));
  CHECK(made->GetData().Scanners.at(0).Beams.size() == 3);
}
