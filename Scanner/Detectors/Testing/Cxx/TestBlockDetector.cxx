// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Detectors that are given many waveforms at once.
#include "../../../Core/Testing/Cxx/heliosScannerBench.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosPeakDetector.h"

#include <vtkObjectFactory.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <memory>
#include <string>
#include <vector>

using namespace helios::testing;

namespace
{

/// The maxima of waveforms: each on its own, or in blocks.
class Maxima : public vtkHeliosPeakDetector
{
public:
  static Maxima* New();
  vtkTypeMacro(Maxima, vtkHeliosPeakDetector);

  bool UsesBlocks = false;
  std::string Fault;
  mutable std::atomic<std::size_t> Calls{ 0 };
  mutable std::atomic<std::size_t> Largest{ 0 };
  mutable std::atomic<int> Prepared{ 0 };

  bool FindsMaxima() const override { return false; }
  bool PrefersBlocks() const override { return this->UsesBlocks; }
  bool DetectAll(const std::vector<vtkHeliosWaveform>& waveforms, std::vector<Echoes>& echoes,
    std::string& error) const override
  {
    ++this->Calls;
    this->Largest = std::max<std::size_t>(this->Largest, waveforms.size());
    error = this->Fault;
    return error.empty() && this->Superclass::DetectAll(waveforms, echoes, error);
  }
  std::shared_ptr<void> PrepareThreads() const override
  {
    ++this->Prepared;
    return std::shared_ptr<void>(nullptr, [this](void*) { --this->Prepared; });
  }
};

vtkStandardNewMacro(Maxima);

/// A step, in front of a wall, with beams on both.
vtkSmartPointer<vtkPolyData> MakeSteps()
{
  return MakeScene({ { { -50, 60, -50 }, { 50.001, 0, 0 }, { 0, 0, 100 } },
    { { -50, 61, -50 }, { 100, 30, 0 }, { 0, 0, 100 } } });
}

/// A scan with all outputs.
struct Scan
{
  Bench Setup{ MakeSteps() };
  vtkNew<Maxima> Detector;

  explicit Scan(bool usesBlocks)
  {
    this->Detector->UsesBlocks = usesBlocks;
    vtkHeliosScanner* scanner = this->Setup.Scanner;
    scanner->SetEchoDetector(this->Detector);
    scanner->GetBeamSampler()->SetBeamDivergence(4e-4);
    scanner->SetAngleAccuracy(2e-4);
    scanner->SetDetectorNoise(1e-12);
    scanner->GenerateWaveformsOn();
    scanner->GeneratePulsesOn();
    scanner->GenerateSubRaysOn();
    scanner->GenerateTruthOn();
  }

  std::vector<std::string> Run()
  {
    vtkHeliosScanner* scanner = this->Setup.Scanner;
    scanner->Modified();
    scanner->Update();
    std::vector<std::string> all;
    for (const int port : { 0, 2, 3 })
    {
      all.push_back(Bytes(vtkPolyData::SafeDownCast(scanner->GetOutputDataObject(port))));
    }
    return all;
  }
};

} // namespace

TEST_CASE("BlockDetector: blocks have the bytes of single waveforms", "[BlockDetector]")
{
  const auto sampling = GENERATE(vtkHeliosScanner::FIXED, vtkHeliosScanner::TOLERANCE);
  Scan single(false);
  Scan blocks(true);
  single.Setup.Scanner->SetSampling(sampling);
  blocks.Setup.Scanner->SetSampling(sampling);
  const std::vector<std::string> expected = single.Run();
  REQUIRE(single.Setup.Scanner->GetCount("points") > 100);
  CHECK(single.Detector->Calls == 0);
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::Initialize(threads);
    CHECK(blocks.Run() == expected);
  }
  vtkSMPTools::Initialize(0);
  CHECK(blocks.Detector->Largest > 16);
  CHECK(blocks.Detector->Largest <= 256);
  CHECK(blocks.Detector->Prepared == 0); // released
}

TEST_CASE("BlockDetector: an error ends the scan, once", "[BlockDetector]")
{
  Scan scan(true);
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(scan.Setup.Scanner);
  scan.Detector->Fault = "the detector \"own\" is broken";
  scan.Setup.Scanner->Update();
  CHECK(log->HasError("the detector \"own\" is broken"));
  CHECK(scan.Setup.Scanner->GetOutput()->GetNumberOfPoints() == 0);
  scan.Detector->Fault.clear();
  scan.Setup.Scanner->Modified();
  scan.Setup.Scanner->Update(); // the error is not kept
  CHECK(scan.Setup.Scanner->GetOutput()->GetNumberOfPoints() > 100);
}

TEST_CASE("BlockDetector: an error ends the detection in stored waveforms", "[BlockDetector]")
{
  Scan scan(true);
  scan.Run();
  vtkNew<vtkHeliosEchoDetection> detection;
  detection->SetInputData(scan.Setup.Scanner->GetOutputDataObject(1));
  detection->SetEchoDetector(scan.Detector);
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(detection);
  scan.Detector->Fault = "the detector \"own\" is broken";
  detection->Update();
  CHECK(log->HasError("the detector \"own\" is broken"));
  CHECK(scan.Detector->Prepared == 0);
}
