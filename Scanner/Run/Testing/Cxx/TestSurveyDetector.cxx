// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A survey uses an echo detector of a plug-in: the example of CONTRIBUTING.md.

#include "heliosSurveyPlaying.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurveySource.h"

#include <catch2/catch.hpp>

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace helios::test;

namespace
{

/// Finds one echo: the largest sample of a waveform, if it exceeds the threshold.
class LargestSample : public vtkHeliosEchoDetector
{
public:
  static LargestSample* New();
  vtkTypeMacro(LargestSample, vtkHeliosEchoDetector);

  void SetInstrument(const vtkHeliosInstrumentData& instrument) override
  {
    this->Superclass::SetInstrument(instrument);
    this->Width = instrument.PulseLength;
  }

  void Detect(
    const vtkHeliosWaveform& waveform, std::vector<vtkHeliosDetectedEcho>& echoes) const override
  {
    const float* end = waveform.Samples + waveform.Count;
    const float* largest = std::max_element(waveform.Samples, end);
    if (largest != end && *largest > this->DetectionThreshold)
    {
      const auto index = static_cast<double>(largest - waveform.Samples);
      echoes.push_back({ index * waveform.BinSize, *largest, this->Width });
    }
  }

private:
  double Width = 0.0; // [ns]
};

vtkStandardNewMacro(LargestSample);

/// Adds the detector once, as a plug-in does that is loaded.
void LoadPlugin()
{
  vtkNew<LargestSample> detector;
  static const bool isAdded = vtkHeliosEchoDetection::AddDetector("largestSample", detector);
  REQUIRE(isAdded);
}

} // namespace

TEST_CASE("SurveyDetector: names of added detectors are checked", "[SurveyDetector]")
{
  LoadPlugin();
  vtkNew<LargestSample> detector;
  const int count = vtkHeliosEchoDetection::GetNumberOfDetectors();
  for (const char* name : { "largestSample", "peak", "", "two words" })
  {
    CHECK_FALSE(vtkHeliosEchoDetection::AddDetector(name, detector));
  }
  CHECK_FALSE(vtkHeliosEchoDetection::AddDetector("none", nullptr));
  CHECK(vtkHeliosEchoDetection::GetNumberOfDetectors() == count);
  CHECK(std::string(vtkHeliosEchoDetection::GetDetectorName(count - 1)) == "largestSample");
}

TEST_CASE("SurveyDetector: a survey names the detector of a plug-in", "[SurveyDetector]")
{
  LoadPlugin();
  const Files files;
  files.Replace("assets.xml", "<FWFSettings beamSampleQuality=\"2\"/>",
    "<FWFSettings beamSampleQuality=\"2\" echoDetector=\"largestSample\"/>");
  const Reading reading(files);
  REQUIRE(reading.Good);
  vtkNew<vtkHeliosSurveySource> source;
  source->SetSurvey(reading.Reader->GetSurvey());
  source->Update();
  vtkPolyData* echoes = source->GetOutput();
  REQUIRE(echoes->GetNumberOfPoints() > 0);
  vtkDataArray* widths = echoes->GetPointData()->GetArray(vtkHeliosArrayNames::EchoWidth);
  CHECK(widths->GetRange()[0] == 5.0); // width of the instrument
  CHECK(widths->GetRange()[1] == 5.0);
  vtkDataArray* counts = echoes->GetPointData()->GetArray(vtkHeliosArrayNames::NumberOfReturns);
  CHECK(counts->GetRange()[1] == 1.0);

  source->GetOptions()->SetEchoDetector("peak");
  source->Update();
  CHECK(
    source->GetOutput()->GetPointData()->GetArray(vtkHeliosArrayNames::EchoWidth)->GetRange()[1] !=
    5.0);
}

TEST_CASE("SurveyDetector: an unknown detector is an error that names all", "[SurveyDetector]")
{
  LoadPlugin();
  const Files files;
  files.Replace("assets.xml", "<FWFSettings beamSampleQuality=\"2\"/>",
    "<FWFSettings beamSampleQuality=\"2\" echoDetector=\"largestSampel\"/>");
  const Reading reading(files);
  INFO(reading.Log->Errors);
  CHECK_FALSE(reading.Good);
  CHECK(reading.Log->HasError("did you mean largestSample?"));
}
