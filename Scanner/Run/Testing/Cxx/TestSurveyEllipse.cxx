// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Elliptical beams of the dialect.
#include "heliosReceiverSetup.h"

#include "heliosSurveyFiles.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosScanner.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <string>

using namespace helios::test;

namespace
{

const std::string MiniVux = R"(beamDivergence_rad="0.0016" beamDivergenceMinor_rad="0.0005" )";

/// A survey on a tripod with these attributes of its scanner and of its leg, and channels.
struct Bench
{
  Files Folder;
  helios::test::Reading Reading;

  explicit Bench(
    const std::string& scanner, const std::string& channels = "", const std::string& leg = "")
    : Reading(Write(Folder, scanner, channels),
        R"(platform="assets.xml#tripod" scanner="own.xml#own")",
        "<leg><platformSettings z=\"10\"/>\n<scannerSettings maxDuration_s=\"0.1\" " + leg +
          "/></leg>")
  {
    INFO(this->Reading.Log->Warnings);
    CHECK(this->Reading.Log->Warnings.empty());
  }

  vtkSmartPointer<vtkHeliosScanner> SetUp(std::size_t channel = 0) const
  {
    INFO(this->Reading.Log->Errors);
    REQUIRE(this->Reading.Good);
    auto scanner = vtkSmartPointer<vtkHeliosScanner>::New();
    helios::SetUpReceiver(
      this->Reading.Data().Scanners.at(0).GetChannel(channel), helios::RunOptions(), scanner);
    return scanner;
  }

private:
  static const Files& Write(
    const Files& files, const std::string& scanner, const std::string& channels)
  {
    files.Write("own.xml",
      "<document>\n<scanner id=\"own\" optics=\"line\" pulseFreqs_Hz=\"1000\" numFibers=\"3\" "
      "scanAngleMax_deg=\"5\"\n" +
        scanner + ">" + channels + "</scanner></document>");
    return files;
  }
};

} // namespace

TEST_CASE("SurveyEllipse: two divergences make an elliptical beam", "[SurveyEllipse]")
{
  const Bench bench(MiniVux + R"(beamMajorAxis_deg="90")");
  const auto scanner = bench.SetUp();
  CHECK(scanner->GetBeamSampler()->GetDivergenceRatio() == 0.3125);
  CHECK(scanner->GetBeamSampler()->GetMajorAxisAngle() == 90.0);
  CHECK(Bench("").SetUp()->GetBeamSampler()->GetDivergenceRatio() == 1.0);
  CHECK(
    Bench(R"(beamDivergenceMinor_rad="0")").SetUp()->GetBeamSampler()->GetDivergenceRatio() == 1.0);
}

TEST_CASE("SurveyEllipse: the divergence of a leg scales both axes", "[SurveyEllipse]")
{
  const Bench bench(MiniVux, "", R"(beamDivergence_rad="0.0008")");
  CHECK(bench.SetUp()->GetBeamSampler()->GetDivergenceRatio() == 0.3125);
  CHECK(bench.Reading.Data().Legs.at(0).Scans.at(0).BeamDivergence == 0.0008);
}

TEST_CASE("SurveyEllipse: channels inherit the ellipse of their scanner", "[SurveyEllipse]")
{
  const Bench bench(MiniVux,
    R"(<channels><channel/><channel beamDivergence_rad="0.001" beamMajorAxis_deg="45"/>)"
    R"(<channel beamDivergenceMinor_rad="0"/></channels>)");
  CHECK(bench.SetUp(0)->GetBeamSampler()->GetDivergenceRatio() == 0.3125);
  CHECK(bench.SetUp(1)->GetBeamSampler()->GetDivergenceRatio() == 0.5);
  CHECK(bench.SetUp(1)->GetBeamSampler()->GetMajorAxisAngle() == 45.0);
  CHECK(bench.SetUp(2)->GetBeamSampler()->GetDivergenceRatio() == 1.0);
}

TEST_CASE("SurveyEllipse: a minor axis that is not the shorter one is an error", "[SurveyEllipse]")
{
  for (const std::string minor : { "0.0017", "1e-06" })
  {
    const Bench bench("beamDivergence_rad=\"0.0016\" beamDivergenceMinor_rad=\"" + minor + "\"");
    CHECK_FALSE(bench.Reading.Good);
    CHECK(bench.Reading.Log->HasError("survey.xml:5: beamDivergenceMinor_rad=\"" + minor +
      "\" of scanner own is not 0.01 to 1 times its beamDivergence_rad=\"0.0016\"; give the larger "
      "angle as beamDivergence_rad, and turn the beam by beamMajorAxis_deg"));
  }
}
