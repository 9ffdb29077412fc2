// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Receivers that saturate, and their dead time.
#include "../../../Core/Testing/Cxx/heliosScannerBench.h"
#include "heliosConstants.h"
#include "heliosTestWaveform.h"
#include "vtkHeliosConstantFractionDetector.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosLeadingEdgeDetector.h"

#include <vtkFieldData.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using namespace helios::testing;

namespace
{

vtkSmartPointer<vtkHeliosEchoDetector> Make(const char* name)
{
  return vtkSmartPointer<vtkHeliosEchoDetector>::Take(vtkHeliosEchoDetection::MakeDetector(name));
}

/// One ray onto a wall at 100 m, in fine bins.
struct OneWall : Bench
{
  explicit OneWall(vtkHeliosEchoDetector* detector)
    : Bench(MakeScene({ Wall(100) }))
  {
    this->Scanner->SetEchoDetector(detector);
    this->Scanner->GetBeamSampler()->SetBeamDivergence(0.0);
    this->Scanner->SetBinSize(0.02);
    this->Scanner->SetDuration(1e-5);
  }

  /// An array of the echo, for a saturation relative to its amplitude; 0: none.
  double Get(const char* name, double saturation)
  {
    this->Scanner->SetSaturationPower(0.0);
    const double amplitude = Value(this->Run(), names::Amplitude, 0);
    this->Scanner->SetSaturationPower(saturation * amplitude);
    vtkPolyData* echoes = this->Run();
    REQUIRE(echoes->GetNumberOfPoints() == 1);
    return Value(echoes, name, 0) / (name == names::Amplitude ? amplitude : 1.0);
  }
};

} // namespace

TEST_CASE("Saturation: amplitudes are clipped, symmetric pulses stay in place", "[Saturation]")
{
  for (const char* name : { "peak", "cfd", "leadingEdge" })
  {
    CAPTURE(name);
    OneWall bench(Make(name));
    for (const double level : { 0.9, 0.5, 0.02 })
    {
      CHECK(bench.Get(names::Amplitude, level) == Approx(level).epsilon(1e-5));
    }
    CHECK(bench.Get(names::Amplitude, 2.0) == Approx(1.0).epsilon(1e-5));
  }
  OneWall bench(Make("peak"));
  CHECK(bench.Get(names::Range, 0.02) == Approx(100.0).margin(1.6e-3)); // half a bin
}

TEST_CASE("Saturation: the range walk of a constant fraction in closed form", "[Saturation]")
{
  vtkNew<vtkHeliosConstantFractionDetector> detector;
  const double fraction = detector->GetFraction();
  const double delay = PulseLength;
  OneWall bench(detector);
  const double unbiased = 0.5 * delay + PulseSigma * PulseSigma * std::log(fraction) / delay;
  for (const double level : { 0.125, 0.05 })
  {
    // The delayed edge crosses the fraction of the clipped top.
    const double crossing = delay - PulseSigma * std::sqrt(-2.0 * std::log(fraction * level));
    REQUIRE(std::abs(crossing) < PulseSigma * std::sqrt(-2.0 * std::log(level)));
    const double walk = 0.5 * helios::SpeedOfLight * (crossing - unbiased);
    REQUIRE(std::abs(walk) > 0.05);
    CHECK(bench.Get(names::Range, level) == Approx(100.0 + walk).margin(2e-4));
  }
}

TEST_CASE("Saturation: widths of clipped pulses in closed form", "[Saturation]")
{
  vtkNew<vtkHeliosLeadingEdgeDetector> detector;
  OneWall bench(detector);
  for (const double level : { 0.5, 0.05 })
  {
    const double width = 2.0 * PulseSigma * std::sqrt(2.0 * std::log(2.0 / level));
    CHECK(bench.Get(names::EchoWidth, level) == Approx(width).epsilon(1e-4));
  }
}

TEST_CASE("Saturation: stored waveforms are clipped, and have the same echoes", "[Saturation]")
{
  OneWall bench(Make("gaussian"));
  bench.Scanner->GenerateWaveformsOn();
  const double range = bench.Get(names::Range, 0.25);
  vtkNew<vtkHeliosEchoDetection> filter;
  filter->SetInputConnection(bench.Scanner->GetOutputPort(1));
  filter->SetEchoDetector(bench.Scanner->GetEchoDetector());
  filter->Update();
  CHECK(Value(filter->GetOutput(), names::Range, 0) == range);
  vtkDataArray* samples = vtkTable::SafeDownCast(bench.Scanner->GetOutputDataObject(1))
                            ->GetFieldData()
                            ->GetArray(names::Samples);
  CHECK(samples->GetRange()[1] == Approx(bench.Scanner->GetSaturationPower()).epsilon(1e-6));
}

TEST_CASE("Saturation: values out of range are errors", "[Saturation]")
{
  OneWall bench(Make("peak"));
  bench.Scanner->SetSaturationPower(-1.0);
  bench.Scanner->Update();
  CHECK(bench.Log->HasError("SaturationPower is -1 W, outside [0"));
}

TEST_CASE("DeadTime: an echo within it is lost and does not extend it", "[DeadTime]")
{
  for (const char* name : { "peak", "gaussian", "cfd", "leadingEdge" })
  {
    CAPTURE(name);
    const auto detector = Make(name);
    const auto samples = MakeSamples({ { 1.0, 15.0 }, { 1.0, 27.0 }, { 1.0, 39.0 } }, 0.25);
    detector->SetDetectionThreshold(0.1);
    CHECK(Detect(detector, samples, 0.25).size() == 3);
    detector->SetDeadTime(11.5);
    CHECK(Detect(detector, samples, 0.25).size() == 3);
    detector->SetDeadTime(12.5);
    const auto echoes = Detect(detector, samples, 0.25);
    REQUIRE(echoes.size() == 2);
    CHECK(echoes[1].Time - echoes[0].Time == Approx(24.0).margin(0.01));
    detector->SetDeadTime(25.0);
    CHECK(Detect(detector, samples, 0.25).size() == 1);
  }
}

TEST_CASE("DeadTime: scans with maxima found without bins", "[DeadTime]")
{
  Bench bench(MakeScene({ { { -50, 60, -50 }, { 50, 0, 0 }, { 0, 0, 100 } }, Wall(61.5) }));
  bench.Scanner->SetSamplingToTolerance(); // 10.0069 ns apart
  bench.Scanner->SetDuration(1e-4);
  CHECK(bench.Run()->GetNumberOfPoints() == 20);
  bench.Scanner->GetEchoDetector()->SetDeadTime(9.9);
  CHECK(bench.Run()->GetNumberOfPoints() == 20);
  bench.Scanner->GetEchoDetector()->SetDeadTime(10.1);
  CHECK(bench.Run()->GetNumberOfPoints() == 10);
  CHECK(Value(bench.Run(), names::Range, 9) == Approx(60.0).margin(1e-3));
}
