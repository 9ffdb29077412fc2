// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged spectra cause a warning with their file, or reflectances between 0 and 1.
#include "heliosMutation.h"
#include "heliosSurveyFiles.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosSurveySource.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace helios::test;

namespace
{

const char* const Spectrum =
  "Name: moss\nType: made up\n\n0.4\t12.5\n0.9 40\n1.064, 45.25\r\n14 2.5\n";

} // namespace

TEST_CASE("SpectrumMutations: damaged spectra are reported or give amplitudes",
  "[SpectrumMutations][mutation]")
{
  const Files files;
  files.Write("plane.mtl", "newmtl m\nhelios_spectra moss\n");
  files.Write("plane.obj", "mtllib plane.mtl\nusemtl m\n" + ReadText(files / "plane.obj"));
  helios::Mutator mutate(20205);
  int warningCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const std::string text = mutate(Spectrum);
    files.Write("spectra/moss.txt", text);
    INFO("case " << i << "\n" << text);
    const Reading reading(files, Tripod,
      "<leg><platformSettings z=\"2\"/><scannerSettings pulseFreq_hz=\"100000\" scanFreq_hz=\"100\""
      " headRotatePerSec_deg=\"60\" headRotateStart_deg=\"0\" headRotateStop_deg=\"0.7\"/></leg>");
    REQUIRE(reading.Good);
    vtkNew<vtkHeliosSurveySource> source;
    const auto log = Observe(source);
    source->SetSurvey(reading.Reader->GetSurvey());
    source->Update();
    INFO(log->Errors);
    REQUIRE(log->Errors.empty());
    auto* echoes = vtkPolyData::SafeDownCast(source->GetOutputDataObject(0));
    vtkDataArray* amplitudes = echoes->GetPointData()->GetArray(vtkHeliosArrayNames::Amplitude);
    REQUIRE(echoes->GetNumberOfPoints() > 0);
    for (vtkIdType k = 0; amplitudes && k < amplitudes->GetNumberOfTuples(); ++k)
    {
      REQUIRE(std::isfinite(amplitudes->GetTuple1(k)));
      REQUIRE(amplitudes->GetTuple1(k) >= 0.0);
    }
    (log->Warnings.empty() ? goodCount : warningCount) += 1;
    REQUIRE((log->Warnings.empty() || log->HasWarning("moss")));
  }
  CHECK(warningCount > 20);
  CHECK(goodCount > 20);
}
