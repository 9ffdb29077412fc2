// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The optics of the dialect: read, checked, resolved for a leg, and run.
#include "heliosLegOptics.h"

#include "heliosSurveyFiles.h"
#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosSurveyPlayer.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

using namespace helios::test;

namespace
{

/// A survey on a tripod for 0.1 s, with these scanner and leg attributes.
struct Bench
{
  Files Folder;
  helios::test::Reading Reading;

  Bench(const std::string& scanner, const std::string& leg, const char* platform = Tripod)
    : Reading(Write(Folder, scanner), Use(platform), Legs(leg))
  {
  }

  const helios::ScanData& Scan() const { return this->Reading.Data().Legs.at(0).Scans.at(0); }

  vtkSmartPointer<vtkHeliosBeamDeflector> Deflector() const
  {
    return helios::MakeDeflector(this->Reading.Data().Scanners.at(0), this->Scan());
  }

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

  void CheckWarned(const std::string& message) const
  {
    INFO(this->Reading.Log->Errors << this->Reading.Log->Warnings << "missing: " << message);
    CHECK(this->Reading.Good);
    CHECK(this->Reading.Log->HasWarning(message));
  }

  /// No errors or warnings.
  void CheckQuiet() const
  {
    INFO(this->Reading.Log->Errors << this->Reading.Log->Warnings);
    REQUIRE(this->Reading.Good);
    CHECK(this->Reading.Log->Warnings.empty());
  }

private:
  static const Files& Write(const Files& files, const std::string& scanner)
  {
    files.Write("own.xml",
      "<document>\n<scanner id=\"own\" pulseFreqs_Hz=\"100000\" rangeMin_m=\"0.1\" " + scanner +
        "/></document>");
    return files;
  }
  static std::string Use(std::string platform)
  {
    const std::size_t scanner = platform.find("scanner=");
    return platform.substr(0, scanner) + "scanner=\"own.xml#own\"";
  }
  static std::string Legs(const std::string& leg)
  {
    return "<leg><platformSettings z=\"10\"/>\n<scannerSettings maxDuration_s=\"0.1\" " + leg +
      "/></leg>\n<leg><platformSettings x=\"10\" z=\"10\"/>\n<scannerSettings active=\"0\"/></leg>";
  }
};

const char* const Swinging = R"(optics="oscillating" scanAngleMax_deg="25" scanFreqMax_Hz="70")";
const char* const Prisms = R"(optics="risley" angle1_deg="-18" angle2_deg="18.5" refrIndex1="1.51"
 refrIndex2="1.52" rotorFreq1_Hz="-121.5" rotorFreq2_Hz="77.75" rotorPhase1_deg="45" rotorPhase2_deg="45" refrIndex_air="1.0003")";

} // namespace

TEST_CASE("SurveyOptics: an oscillating mirror", "[SurveyOptics]")
{
  const Bench bench(Swinging, R"(scanFreq_hz="50" scanAngle_deg="20")");
  bench.CheckQuiet();
  const auto deflector = bench.Deflector();
  REQUIRE(deflector->IsA("vtkHeliosOscillatingMirror"));
  CHECK(deflector->GetPulseFrequency() == 100000.0);
  CHECK(deflector->GetScanAngle(0) == -20.0); // 2000 pulses per period
  CHECK(deflector->GetScanAngle(250) == Approx(-10.0).epsilon(1e-13));
  CHECK(deflector->GetScanAngle(1000) == 20.0);
}

TEST_CASE("SurveyOptics: pattern of an oscillating mirror", "[SurveyOptics]")
{
  const std::string swinging = Swinging;
  const Bench sine(swinging + R"( scanPattern="sinusoidal")", R"(scanFreq_hz="50")");
  sine.CheckQuiet();
  CHECK(sine.Deflector()->GetScanAngle(250) == Approx(-25.0 * std::sqrt(0.5)).epsilon(1e-13));
  const Bench turning(
    swinging + R"( scanPattern="triangular" turningPulses="100")", R"(scanFreq_hz="50")");
  turning.CheckQuiet();
  CHECK(turning.Deflector()->GetScanAngle(50) ==
    Approx(-25.0 + 50.0 / (1000.0 - 50.0) * 25.0).epsilon(1e-13));
  Bench(swinging + R"( scanPattern="round")", R"(scanFreq_hz="50")")
    .CheckRefused(
      { "own.xml:2", "scanPattern=\"round\" is not valid", "expected triangular or sinusoidal" });
}

TEST_CASE("SurveyOptics: scan angle of an oscillating mirror", "[SurveyOptics]")
{
  CHECK(Bench(Swinging, R"(scanFreq_hz="50")").Scan().ScanAngle == 25.0);
  const Bench clipped(Swinging, R"(scanFreq_hz="50" scanAngle_deg="30")");
  clipped.CheckWarned("scanAngle_deg=\"30\" is clipped to 25, scanAngleMax_deg of scanner own");
  CHECK(clipped.Scan().ScanAngle == 25.0);
  // Catalogues may give only the scan product as a limit.
  const std::string product = R"(optics="oscillating" scanProduct="1000")";
  const Bench free(product, R"(scanFreq_hz="50" scanAngle_deg="20")");
  free.CheckQuiet();
  CHECK(free.Scan().ScanAngle == 20.0);
  const Bench capped(product, R"(scanFreq_hz="50" scanAngle_deg="25")");
  capped.CheckWarned("survey.xml:5: a scan angle of 25 deg is clipped to 20 deg, since "
                     "scanProduct=\"1000\" of scanner own allows no more at scanFreq_hz=\"50\"");
  CHECK(capped.Scan().ScanAngle == 20.0);
  CHECK(capped.Deflector()->GetScanAngle(1000) == 20.0);
  Bench(product, R"(scanFreq_hz="50")")
    .CheckRefused({ "survey.xml:5", "no scan angle",
      "give scanAngle_deg here, or "
      "scanAngleMax_deg for scanner own" });
}

TEST_CASE("SurveyOptics: a mirror that does not oscillate", "[SurveyOptics]")
{
  Bench(Swinging, "")
    .CheckRefused({ "survey.xml:5", "scanFreq_hz is missing or 0", "scanner own does not move" });
  Bench(Swinging, R"(scanFreq_hz="80")")
    .CheckWarned(
      "survey.xml:5: scanFreq_hz=\"80\" is clipped to 70, scanFreqMax_Hz of scanner own");
}

TEST_CASE("SurveyOptics: a fibre array", "[SurveyOptics]")
{
  const std::string line = R"(optics="line" numFibers="127" scanAngleMax_deg="7.15")";
  const Bench bench(line, "");
  bench.CheckQuiet();
  const auto deflector = bench.Deflector();
  REQUIRE(deflector->IsA("vtkHeliosFiberArray"));
  CHECK(deflector->GetScanAngle(0) == -7.15);
  CHECK(deflector->GetScanAngle(126) == 7.15);
  CHECK(deflector->GetScanAngle(127) == -7.15);
  Bench(line, R"(scanFreq_hz="600")").CheckWarned("scanFreq_hz is not used by line optics");
  Bench(R"(optics="line" numFibers="127")", "")
    .CheckRefused({ "own.xml:2", "scanner own", "scanAngleMax_deg is missing or 0" });
  Bench(R"(optics="line" numFibers="0" scanAngleMax_deg="7")", "")
    .CheckRefused({ "own.xml:2", "numFibers=\"0\" is out of range" });
}

TEST_CASE("SurveyOptics: Risley prisms", "[SurveyOptics]")
{
  const Bench bench(Prisms, "");
  bench.CheckQuiet();
  const helios::ScannerData& scanner = bench.Reading.Data().Scanners.at(0);
  CHECK(scanner.Prisms[0].WedgeAngle == -18.0);
  CHECK(scanner.Prisms[1].RefractiveIndex == 1.52);
  CHECK(scanner.Prisms[1].RotorFrequency == 77.75);
  CHECK(scanner.Prisms[1].RotorPhase == 45.0);
  CHECK(scanner.Prisms[2].WedgeAngle == 0.0);
  CHECK(scanner.AirRefractiveIndex == 1.0003);
  const auto deflector = bench.Deflector();
  REQUIRE(deflector->IsA("vtkHeliosRisleyPrisms"));
  double d[3];
  REQUIRE(deflector->GetDirection(0, d));
  CHECK(d[0] == Approx(d[2]).epsilon(1e-13)); // at 45 degrees
  double widest = 0.0;
  for (vtkIdType i = 0; i < 100000; ++i)
  {
    widest = std::max(widest, deflector->GetScanAngle(i));
  }
  CHECK(widest == Approx(deflector->GetScanAngle(0)).epsilon(1e-3)); // both deflect in the same
                                                                     // direction
  Bench(Prisms, R"(scanFreq_hz="50")").CheckWarned("scanFreq_hz is not used by risley optics");
  Bench(Prisms, R"(scanAngle_deg="50")").CheckWarned("scanAngle_deg is not used by risley optics");
}

TEST_CASE("SurveyOptics: prisms without deflection", "[SurveyOptics]")
{
  const std::vector<std::string> messages = { "own.xml:2", "scanner own",
    "none of its prisms bends the beam", "give angle1_deg, and a refrIndex1 above refrIndex_air" };
  Bench(R"(optics="risley")", "").CheckRefused(messages);
  Bench(R"(optics="risley" refrIndex1="1.5")", "").CheckRefused(messages);
  Bench(R"(optics="risley" angle1_deg="18")", "").CheckRefused(messages);
  Bench(R"(optics="risley" angle1_deg="18" refrIndex1="1.5" angle3_deg="3")", "")
    .CheckWarned("own.xml:2: scanner own: prism 3 does not bend the beam; give a refrIndex3 above");
  Bench(R"(optics="risley" angle1_deg="90" refrIndex1="1.5")", "")
    .CheckRefused({ "own.xml:2", "angle1_deg=\"90\" is out of range" });
  Bench(R"(optics="risley" angle1_deg="18" refrIndex1="0.5")", "")
    .CheckRefused({ "own.xml:2", "refrIndex1=\"0.5\" is out of range" });
}

TEST_CASE("SurveyOptics: a polygon with unlike facets", "[SurveyOptics]")
{
  const std::string three =
    R"(optics="rotating" scanAngleMax_deg="60" facetPitches_deg="0, 10, -10")";
  const Bench bench(three + R"( facetRolls_deg="0,0.5,-0.25")", R"(scanFreq_hz="100")");
  bench.CheckQuiet();
  const auto deflector = bench.Deflector();
  double d[3];
  for (const int line : { 0, 1, 2, 3, 4 }) // line of 1000 pulses
  {
    REQUIRE(deflector->GetDirection(1000 * line, d));
    CHECK(std::asin(d[0]) * 180.0 / 3.14159265358979323846 ==
      Approx(line % 3 == 0 ? 0.0
          : line % 3 == 1  ? 10.0
                           : -10.0)
        .margin(1e-13));
    CHECK(deflector->GetScanAngle(1000 * line) ==
      Approx(line % 3 == 0 ? 0.0
          : line % 3 == 1  ? 0.5
                           : -0.25)
        .margin(1e-13));
  }
  const std::string leg = R"(scanFreq_hz="100")";
  Bench(three + R"( facetRolls_deg="1")", leg)
    .CheckRefused(
      { "own.xml:2: scanner own has facetPitches_deg of 3 facets, but facetRolls_deg of 1; "
        "give one value per facet" });
  Bench(R"(optics="rotating" scanAngleMax_deg="60" facetPitches_deg="0,90")", leg)
    .CheckRefused({ "own.xml:2", "facetPitches_deg=\"0,90\"", "out of range" });
  std::string many = "0";
  for (int i = 0; i < 1000; ++i)
  {
    many += ",0";
  }
  Bench(R"(optics="rotating" scanAngleMax_deg="60" facetRolls_deg=")" + many + "\"", leg)
    .CheckRefused({ "own.xml:2: scanner own has 1001 facets; give at most 1000" });
  Bench(R"(optics="conic" scanAngleMax_deg="20" facetRolls_deg="1,2")", leg)
    .CheckWarned("facetPitches_deg and facetRolls_deg are only used by rotating optics");
}

TEST_CASE("SurveyOptics: a Palmer scanner", "[SurveyOptics]")
{
  const Bench bench(R"(optics="palmer" scanAngleMax_deg="15")", R"(scanFreq_hz="25")");
  bench.CheckQuiet();
  const auto deflector = bench.Deflector();
  REQUIRE(deflector->IsA("vtkHeliosPalmerMirror"));
  CHECK(deflector->GetScanAngle(1000) == Approx(15.0).epsilon(1e-13)); // a quarter of a revolution
}

TEST_CASE("SurveyOptics: settings of a rotating mirror that others ignore", "[SurveyOptics]")
{
  const std::string leg = R"(scanFreq_hz="50" )";
  Bench(Swinging, leg + R"(verticalAngleMin_deg="-10")")
    .CheckWarned(
      "verticalAngleMin_deg and verticalAngleMax_deg are not used by oscillating optics");
  Bench(Swinging, leg + R"(verticalResolution_deg="0.1")")
    .CheckWarned("verticalResolution_deg and horizontalResolution_deg are not used by oscillating");
}

TEST_CASE("SurveyOptics: warm-up moves optics and head before the first pulse", "[SurveyOptics]")
{
  const std::string rotating = R"(optics="rotating" scanAngleMax_deg="180" )"
                               R"(headRotatePerSecMax_deg="100")";
  const std::string leg = R"(scanFreq_hz="50" headRotatePerSec_deg="20" headRotateStart_deg="5")";
  const Bench cold(rotating, leg + R"( headRotateStop_deg="25")");
  const Bench warm(rotating, leg + R"( headRotateStop_deg="25" opticsWarmupPhase_s="0.503")");
  cold.CheckQuiet();
  warm.CheckQuiet();
  CHECK(warm.Scan().WarmUpTime == 0.503);
  CHECK(warm.Scan().HeadRotateStart == Approx(5.0 + 20.0 * 0.503).epsilon(1e-15));
  CHECK(warm.Scan().GetHeadTime() == Approx(1.0 - 0.503).epsilon(1e-14));
  CHECK(cold.Deflector()->GetScanAngle(0) == 0.0);
  // 0.503 s are 25.15 revolutions
  CHECK(warm.Deflector()->GetScanAngle(0) == Approx(0.15 * 360.0).epsilon(1e-12));
  CHECK(warm.Deflector()->GetScanAngle(7) ==
    Approx(cold.Deflector()->GetScanAngle(50307)).epsilon(1e-12));

  Bench(rotating, leg + R"( headRotateStop_deg="25" opticsWarmupPhase_s="2")")
    .CheckRefused({ "survey.xml:5", "opticsWarmupPhase_s=\"2\" rotates the head by 40 deg",
      "headRotateStop_deg=\"25\" or beyond", "give less than 1 s" });
  Bench(rotating, leg + R"( opticsWarmupPhase_s="-1")")
    .CheckRefused({ "survey.xml:5", "opticsWarmupPhase_s=\"-1\" is out of range" });
  // On a moving platform the head rotates continuously.
  const Bench moving(
    rotating, leg + R"( headRotateStop_deg="25" opticsWarmupPhase_s="36")", Flight);
  INFO(moving.Reading.Log->Errors);
  REQUIRE(moving.Reading.Good);
  CHECK(moving.Scan().HeadRotateStart == 5.0);
}

TEST_CASE("SurveyOptics: all optics run", "[SurveyOptics]")
{
  const std::vector<std::pair<std::string, std::string>> runs = {
    { Swinging, R"(scanFreq_hz="50")" },
    { R"(optics="line" numFibers="127" scanAngleMax_deg="7.15")", "" },
    { Prisms, "" },
    { R"(optics="palmer" scanAngleMax_deg="15")", R"(scanFreq_hz="25")" },
    { R"(optics="conic" scanAngleMax_deg="15")", R"(scanFreq_hz="25")" },
  };
  for (const auto& [scanner, leg] : runs)
  {
    INFO(scanner);
    const Bench bench(scanner, leg, Flight); // nadir
    INFO(bench.Reading.Log->Errors);
    REQUIRE(bench.Reading.Good);
    vtkNew<vtkHeliosSurveyPlayer> player;
    bench.Reading.Log->Watch(player);
    player->SetSurvey(bench.Reading.Reader->GetSurvey());
    player->SetOutputDirectory((bench.Folder / "out").c_str());
    REQUIRE(player->Run());
    CHECK(player->GetNumberOfPulses() == 10000);
    CHECK(player->GetCount("firstReturns") == 10000); // all on the floor
  }
}

TEST_CASE("SurveyOptics: the instruments of the catalogue", "[SurveyOptics]")
{
  const std::filesystem::path root = std::filesystem::path(__FILE__).parent_path() / "../../../..";
  const std::vector<std::pair<std::string, std::string>> instruments = {
    { "oscillating_als", R"(scanFreq_hz="40" scanAngle_deg="25")" }, { "fiber_als", "" },
    { "risley_uls", "" }, { "livox_mid70", "" }, { "livox_avia", "" },
    { "velodyne_vlp16", R"(scanFreq_hz="10")" }, { "velodyne_hdl32e", R"(scanFreq_hz="10")" },
    { "hesai_xt32", R"(scanFreq_hz="10")" }
  };
  for (const auto& [id, leg] : instruments)
  {
    INFO(id);
    const Files files;
    files.Write("own.xml", ReadText((root / "Data/Assets/scanners.xml").string()));
    std::filesystem::copy(root / "Data/Assets/beams", files / "beams");
    const std::string flight = Flight;
    const Reading reading(files,
      flight.substr(0, flight.find("scanner=")) + "scanner=\"own.xml#" + id + "\"",
      "<leg><platformSettings z=\"100\"/><scannerSettings " + leg +
        "/></leg><leg><platformSettings x=\"10\" z=\"100\"/></leg>");
    INFO(reading.Log->Errors << reading.Log->Warnings);
    REQUIRE(reading.Good);
    CHECK(reading.Log->Warnings.empty());
  }
}

TEST_CASE(
  "SurveyOptics: prisms with total reflection of every pulse are reported", "[SurveyOptics]")
{
  const Bench bench(R"(optics="risley" angle1_deg="-45" refrIndex1="1.5")", "", Flight);
  REQUIRE(bench.Reading.Good);
  vtkNew<vtkHeliosSurveyPlayer> player;
  bench.Reading.Log->Watch(player);
  player->SetSurvey(bench.Reading.Reader->GetSurvey());
  player->SetOutputDirectory((bench.Folder / "out").c_str());
  player->Run();
  INFO(player->GetMessage() << bench.Reading.Log->Errors << bench.Reading.Log->Warnings);
  CHECK((bench.Reading.Log->HasWarning("its prisms reflect all of them") ||
    player->GetMessage().find("its prisms reflect all of them") != std::string::npos));
}
