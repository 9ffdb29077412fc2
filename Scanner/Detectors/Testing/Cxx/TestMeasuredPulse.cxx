// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Scans with a pulse of samples: asymmetric, with ringing.
#include "../../../Core/Testing/Cxx/heliosScannerBench.h"
#include "heliosConstants.h"
#include "heliosReceiver.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosLeadingEdgeDetector.h"
#include "vtkHeliosPeakDetector.h"

#include <vtkFieldData.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <string>

namespace names = vtkHeliosArrayNames;
using namespace helios::testing;

namespace
{

vtkSmartPointer<vtkDoubleArray> MakePulse(
  double from, double to, double step, const std::function<double(double)>& power)
{
  auto samples = vtkSmartPointer<vtkDoubleArray>::New();
  samples->SetNumberOfComponents(2);
  for (int i = 0; from + i * step <= to; ++i)
  {
    const double time = from + i * step;
    samples->InsertNextTuple2(time, power(time));
  }
  return samples;
}

/// Rises within 1 ns, falls with 3 ns, rings with 4 ns. Times start anywhere.
vtkSmartPointer<vtkDoubleArray> MakeRinging()
{
  return MakePulse(100.0, 130.0, 0.1,
    [](double time)
    {
      const double t = time - 100.0;
      const double rise = t < 1.0 ? t * t * (3.0 - 2.0 * t) : 1.0;
      return rise * std::exp(-t / 3.0) + 0.1 * rise * std::exp(-t / 6.0) * std::sin(t * 1.5708);
    });
}

void SetPulse(vtkHeliosScanner* scanner, vtkDataArray* samples)
{
  scanner->SetPulseShapeToSampled();
  scanner->SetPulseSamples(samples);
}

} // namespace

TEST_CASE("MeasuredPulse: samples of a Gaussian are the Gaussian", "[MeasuredPulse]")
{
  // A plane across a half, a slope and a step.
  const auto scene = MakeScene({ { { -50, 60, -50 }, { 50, 0, 0 }, { 0, 0, 100 } },
    { { -50, 61.7, -50 }, { 100, 30, 0 }, { 0, 0, 100 } } });
  const double sigma = 4.0 / helios::FwhmPerSigma;
  Bench exact(scene);
  Bench sampled(scene);
  SetPulse(sampled.Scanner,
    MakePulse(-12.0, 12.0, 0.02,
      [sigma](double t) { return 7.0 * std::exp(-0.5 * t * t / sigma / sigma); }));
  for (Bench* bench : { &exact, &sampled })
  {
    bench->Scanner->SetDuration(1e-3);
    bench->Scanner->GetBeamSampler()->SetBeamDivergence(2e-3);
    bench->Scanner->SetAngleAccuracy(1e-3);
  }
  vtkPolyData* truth = exact.Run();
  vtkPolyData* echoes = sampled.Run();
  REQUIRE(truth->GetNumberOfPoints() > 150); // two echoes of a pulse
  REQUIRE(echoes->GetNumberOfPoints() == truth->GetNumberOfPoints());
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    REQUIRE(Value(echoes, names::Range, i) == Approx(Value(truth, names::Range, i)).margin(1e-4));
    REQUIRE(Value(echoes, names::Amplitude, i) ==
      Approx(Value(truth, names::Amplitude, i)).epsilon(1e-4));
    REQUIRE(Value(echoes, names::EchoWidth, i) ==
      Approx(Value(truth, names::EchoWidth, i)).epsilon(5e-3));
  }
}

TEST_CASE("MeasuredPulse: every detector finds a plane at its range", "[MeasuredPulse]")
{
  for (const char* name : { "peak", "gaussian", "cfd", "leadingEdge" })
  {
    for (const bool isHelios : { false, true })
    {
      for (const double range : { 20.0, 77.013, 300.02 })
      {
        CAPTURE(name, isHelios, range);
        Bench bench(MakeScene({ Wall(range) }));
        const auto detector =
          vtkSmartPointer<vtkHeliosEchoDetector>::Take(vtkHeliosEchoDetection::MakeDetector(name));
        bench.Scanner->SetEchoDetector(detector);
        bench.Scanner->SetSamplingToTolerance();
        bench.Scanner->SetDuration(1e-4);
        bench.Scanner->GenerateWaveformsOn();
        SetPulse(bench.Scanner, MakeRinging());
        bench.Scanner->SetPulseShape(
          isHelios ? vtkHeliosScanner::HELIOS : vtkHeliosScanner::SAMPLED);
        if (auto* edge = vtkHeliosLeadingEdgeDetector::SafeDownCast(detector))
        {
          edge->SetFraction(0.3);
        }
        vtkPolyData* echoes = bench.Run();
        REQUIRE(bench.Log->Errors.empty());
        REQUIRE(echoes->GetNumberOfPoints() >= 10);
        const double margin = std::string(name) == "peak" ? 4e-3 : 2e-3; // a bin is 37 mm
        CHECK(Value(echoes, names::Range, 0) == Approx(range).margin(margin));
        vtkNew<vtkHeliosEchoDetection> filter;
        filter->SetInputConnection(bench.Scanner->GetOutputPort(1));
        filter->SetEchoDetector(detector);
        filter->Update();
        REQUIRE(filter->GetOutput()->GetNumberOfPoints() == echoes->GetNumberOfPoints());
        CHECK(Value(filter->GetOutput(), names::Range, 0) ==
          Approx(Value(echoes, names::Range, 0)).margin(1e-6));
      }
    }
  }
}

TEST_CASE("MeasuredPulse: an exponential tail on a target of some depth", "[MeasuredPulse]")
{
  // The convolution of exp(-t / tau), t > 0, with a box of length T and height 1 / T.
  constexpr double tau = 3.0;
  constexpr double depth = 8.0; // T [ns]
  constexpr int count = 4000;
  const auto truth = [](double t)
  {
    return t < 0.0 ? 0.0
      : t < depth  ? tau / depth * (1.0 - std::exp(-t / tau))
                   : tau / depth * (std::exp((depth - t) / tau) - std::exp(-t / tau));
  };
  vtkNew<vtkHeliosPeakDetector> detector;
  helios::ReceiverSettings settings;
  std::vector<double> times{ -1e-6 };
  std::vector<double> powers{ 0.0 };
  for (int i = 0; i < 4000; ++i)
  {
    times.push_back(0.01 * i);
    powers.push_back(5.0 * std::exp(-0.01 * i / tau));
  }
  settings.Shape = helios::PulseShape::MakeSampled(times, powers);
  settings.BinSize = settings.DetectionBin = 0.1;
  settings.Detector = detector;
  helios::Receiver receiver(settings);
  std::vector<helios::SubReturn> returns;
  for (int i = 0; i < count; ++i)
  {
    const double time = depth * (i + 0.5) / count;
    returns.push_back({ 100.0 + 0.5 * helios::SpeedOfLight * time, 1.0 / count, 1.0, 0, i });
  }
  receiver.Fill(returns, 0.0, 0);
  const helios::Waveform& wave = receiver.GetWaveform();
  const double start = wave.StartTime - 200.0 / helios::SpeedOfLight;
  double largest = 0.0;
  for (std::size_t i = 0; i < wave.Samples.size(); ++i)
  {
    const double time = start + 0.1 * static_cast<double>(i);
    REQUIRE(wave.Samples[i] == Approx(truth(time)).margin(3e-4));
    largest = std::max(largest, static_cast<double>(wave.Samples[i]));
  }
  CHECK(largest == Approx(truth(depth)).epsilon(2e-3));
}

TEST_CASE("MeasuredPulse: bad arrays are refused with their row", "[MeasuredPulse]")
{
  const auto expect = [](vtkDataArray* samples, const char* message)
  {
    Bench bench(MakeScene({ Wall(10) }));
    SetPulse(bench.Scanner, samples);
    bench.Scanner->Update();
    INFO(message);
    CHECK(bench.Log->HasError(message));
  };
  vtkNew<vtkDoubleArray> single;
  single->InsertNextValue(1.0);
  expect(single, "PulseSamples has 1 numbers per row; give two, a time [ns] and a power");
  const auto flat = [](double) { return -1.0; };
  expect(MakePulse(0, 5, 1, flat), "PulseSamples: a pulse needs at least three samples, and one");
  const auto good = MakePulse(0, 5, 1, [](double) { return 1.0; });
  const auto unsorted = vtkSmartPointer<vtkDoubleArray>::New();
  unsorted->DeepCopy(good);
  unsorted->SetTuple2(3, 2.0, 1.0);
  expect(unsorted, "PulseSamples, row 3: its time is not after that of the previous one");
  unsorted->SetTuple2(3, std::nan(""), 1.0);
  expect(unsorted, "PulseSamples, row 3: times and powers must be finite");
  unsorted->SetTuple2(3, 3.0, -9.0);
  expect(unsorted, "PulseSamples: the energy of the pulse is not positive: the integral is -5.0");
  expect(nullptr, "PulseShape is SAMPLED and PulseFileName is not set; give a file with a time");
}
