// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged tables of beams cause an error with their file, or valid beams.
#include "heliosLegOptics.h"
#include "heliosMutation.h"
#include "heliosSurveyFiles.h"
#include "vtkHeliosBeamDeflector.h"

#include <catch2/catch.hpp>

#include <vtkMath.h>

#include <cmath>

using namespace helios::test;

namespace
{

const char* const Table = "# made up\nelevation_deg,azimuth_deg, originOffset_m,firingTime_s\r\n"
                          "-15.5,1.4,0.0158,0\n0,-1.4,1e-2 , 2e-6\n15.25,0,0,-1\n";

} // namespace

TEST_CASE("BeamMutations: damaged tables of beams are errors or give directions",
  "[BeamMutations][mutation]")
{
  const Files files;
  files.Write("own.xml",
    "<document><scanner id=\"own\" optics=\"spinning\" pulseFreqs_Hz=\"30000\">"
    "<beams file=\"beams.csv\"/></scanner></document>");
  helios::Mutator mutate(20233);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const std::string text = mutate(Table);
    files.Write("beams.csv", text);
    INFO("case " << i << "\n" << text);
    const Reading reading(files, R"(platform="assets.xml#tripod" scanner="own.xml#own")",
      "<leg><platformSettings z=\"2\"/>"
      "<scannerSettings scanFreq_hz=\"10\" maxDuration_s=\"0.1\"/></leg>");
    INFO(reading.Log->Errors);
    (reading.Good ? goodCount : errorCount) += 1;
    if (!reading.Good)
    {
      const bool isLate = reading.Log->HasError("survey.xml") && reading.Log->HasError("fires at");
      REQUIRE((isLate || reading.Log->HasError("beams.csv")));
      continue;
    }
    const auto& scan = reading.Data().Legs.at(0).Scans.at(0);
    const auto deflector = helios::MakeDeflector(reading.Data().Scanners.at(0), scan);
    for (vtkIdType pulse = 0; pulse < 100; ++pulse)
    {
      double d[3];
      double origin[3] = { 0.0, 0.0, 0.0 };
      REQUIRE(deflector->GetDirection(pulse, d));
      REQUIRE(vtkMath::Norm(d) == Approx(1.0).epsilon(1e-14));
      deflector->GetOrigin(pulse, origin);
      REQUIRE(vtkMath::Norm(origin) < 15.0);
    }
  }
  CHECK(errorCount > 0);
  CHECK(goodCount > 0);
}
