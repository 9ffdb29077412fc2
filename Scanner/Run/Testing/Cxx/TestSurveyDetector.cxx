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

/// The plug-in while it is loaded.
struct Plugin
{
  vtkNew<LargestSample> Detector;

  Plugin() { REQUIRE(vtkHeliosEchoDetection::AddDetector("largestSample", this->Detector)); }
  ~Plugin() { vtkHeliosEchoDetection::RemoveDetector("largestSample"); }
  Plugin(const Plugin&) = delete;
  void operator=(const Plugin&) = delete;
};

/// A survey of a tripod whose scanner names its detector.
struct Bench
{
  Files Folder;
  helios::test::Reading Reading;

  explicit Bench(const std::string& detector)
    : Reading(Write(Folder, detector), Tripod, OneLeg)
  {
  }

private:
  static const Files& Write(const Files& files, const std::string& detector)
  {
    files.Replace("assets.xml", "<FWFSettings beamSampleQuality=\"2\"/>",
      "<FWFSettings beamSampleQuality=\"2\" echoDetector=\"" + detector + "\"/>");
    return files;
  }
};

} // namespace

TEST_CASE("SurveyDetector: names of added detectors are checked", "[SurveyDetector]")
{
  const int own = vtkHeliosEchoDetection::GetNumberOfDetectors();
  {
    const Plugin plugin;
    vtkNew<LargestSample> detector;
    for (const char* name : { "largestSample", "peak", "", "two words" })
    {
      CHECK_FALSE(vtkHeliosEchoDetection::AddDetector(name, detector));
    }
    CHECK_FALSE(vtkHeliosEchoDetection::AddDetector("none", nullptr));
    CHECK(vtkHeliosEchoDetection::GetNumberOfDetectors() == own + 1);
    CHECK(std::string(vtkHeliosEchoDetection::GetDetectorName(own)) == "largestSample");
  }
  CHECK(vtkHeliosEchoDetection::GetNumberOfDetectors() == own);
  CHECK_FALSE(vtkHeliosEchoDetection::RemoveDetector("largestSample"));
  for (int i = own - 1; i >= 0; --i)
  {
    CHECK_FALSE(vtkHeliosEchoDetection::RemoveDetector(vtkHeliosEchoDetection::GetDetectorName(i)));
  }
}

TEST_CASE("SurveyDetector: a survey names the detector of a plug-in", "[SurveyDetector]")
{
  const Plugin plugin;
  const Bench bench("largestSample");
  INFO(bench.Reading.Log->Errors);
  REQUIRE(bench.Reading.Good);
  vtkNew<vtkHeliosSurveySource> source;
  source->SetSurvey(bench.Reading.Reader->GetSurvey());
  source->Update();
  vtkPolyData* echoes = source->GetOutput();
  REQUIRE(echoes->GetNumberOfPoints() > 0);
  vtkDataArray* widths = echoes->GetPointData()->GetArray(vtkHeliosArrayNames::EchoWidth);
  CHECK(widths->GetRange()[0] == 5.0); // the pulse length
  CHECK(widths->GetRange()[1] == 5.0);
  vtkDataArray* counts = echoes->GetPointData()->GetArray(vtkHeliosArrayNames::NumberOfReturns);
  CHECK(counts->GetRange()[1] == 1.0);

  source->GetOptions()->SetEchoDetector("peak");
  source->Update();
  widths = source->GetOutput()->GetPointData()->GetArray(vtkHeliosArrayNames::EchoWidth);
  CHECK(widths->GetRange()[1] != 5.0);
}

TEST_CASE("SurveyDetector: an unknown detector is an error that names all", "[SurveyDetector]")
{
  const Plugin plugin;
  const Bench bench("largestSampel");
  INFO(bench.Reading.Log->Errors);
  CHECK_FALSE(bench.Reading.Good);
  CHECK(bench.Reading.Log->HasError("did you mean largestSample?"));
}
