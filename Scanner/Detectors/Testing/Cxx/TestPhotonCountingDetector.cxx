// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Photon counts against the closed forms of Poisson processes.
#include "../../../Core/Testing/Cxx/heliosScannerBench.h"
#include "heliosConstants.h"
#include "heliosTestWaveform.h"
#include "vtkHeliosEchoDetection.h"
#include "vtkHeliosPhotonCountingDetector.h"

#include <vtkSMPTools.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace names = vtkHeliosArrayNames;
using namespace helios::testing;

namespace
{

constexpr int Pulses = 20000;
constexpr double Bin = 0.1; // [ns]
constexpr double Centre = 20.0;

/// The energy of a photon of 1064 nm [J].
constexpr double PhotonEnergy = 6.62607015e-34 * 2.99792458e8 / 1064e-9;

/// Times of the counts of many pulses.
using Counts = std::vector<std::vector<vtkHeliosDetectedEcho>>;

Counts Count(const vtkHeliosEchoDetector* detector, const std::vector<float>& samples,
  double gateStop = 0.0, int pulses = Pulses)
{
  Counts counts(static_cast<std::size_t>(pulses));
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    vtkHeliosWaveform wave{ samples.data(), static_cast<vtkIdType>(samples.size()), Bin,
      PulseLength };
    wave.GateStop = gateStop;
    wave.Seed = 11;
    wave.PulseId = i;
    detector->Detect(wave, counts[i]);
  }
  return counts;
}

/// A Gaussian echo with a mean number of detected photons.
std::vector<float> MakeEcho(vtkHeliosPhotonCountingDetector* detector, double photons)
{
  const double area = PulseSigma * std::sqrt(2.0 * std::acos(-1.0)) * 1e-9; // energy of 1 W [J]
  const double amplitude = photons * PhotonEnergy / detector->GetDetectionEfficiency() / area;
  return MakeSamples({ { amplitude, Centre } }, Bin, 2.0 * Centre);
}

ErrorSums Sum(const Counts& counts, const std::function<double(const Counts::value_type&)>& get,
  bool ofEmpty = true)
{
  ErrorSums sums;
  for (const auto& pulse : counts)
  {
    if (ofEmpty || !pulse.empty())
    {
      sums.Add(get(pulse));
    }
  }
  return sums;
}

double CountOf(const Counts::value_type& pulse)
{
  return static_cast<double>(pulse.size());
}

double FirstOf(const Counts::value_type& pulse)
{
  return pulse.front().Time;
}

/// The mean time of the first photon of a Gaussian of N photons from its centre: the integral of t
/// r(t) exp(-integral of r) over the probability of a photon.
double GetFirstPhoton(double photons)
{
  double sum = 0.0;
  double past = 0.0;
  const double step = 0.001;
  for (double t = -8.0 * PulseSigma; t < 8.0 * PulseSigma; t += step)
  {
    const double u = t / PulseSigma;
    const double rate =
      photons * std::exp(-0.5 * u * u) / (PulseSigma * std::sqrt(2.0 * std::acos(-1.0)));
    sum += t * rate * std::exp(-past - 0.5 * rate * step) * step;
    past += rate * step;
  }
  return sum / (1.0 - std::exp(-photons));
}

} // namespace

TEST_CASE("PhotonCounting: a pulse is detected with 1 - exp(-N)", "[PhotonCounting]")
{
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  detector->SetDeadTime(1e3); // Geiger mode
  for (const double photons : { 0.05, 0.7, 3.0 })
  {
    const Counts counts = Count(detector, MakeEcho(detector, photons));
    const double p = 1.0 - std::exp(-photons);
    const ErrorSums found = Sum(counts, CountOf);
    CHECK(found.GetMean() == Approx(p).margin(4.0 * std::sqrt(p * (1.0 - p) / Pulses)));
    for (const auto& pulse : counts)
    {
      REQUIRE(pulse.size() <= 1);
    }
  }
}

TEST_CASE("PhotonCounting: counts without dead time are Poisson's", "[PhotonCounting]")
{
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  for (const double photons : { 0.3, 5.0, 60.0 })
  {
    const ErrorSums found = Sum(Count(detector, MakeEcho(detector, photons)), CountOf);
    const double variance = found.GetRms() * found.GetRms() - found.GetMean() * found.GetMean();
    CHECK(found.GetMean() == Approx(photons).margin(4.0 * std::sqrt(photons / Pulses)));
    CHECK(variance == Approx(photons).epsilon(0.06));
  }
  const Counts many = Count(detector, MakeEcho(detector, 1e5), 0.0, 3);
  CHECK(many[0].size() == 255);
}

TEST_CASE("PhotonCounting: the first photon of a strong echo is early", "[PhotonCounting]")
{
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  detector->SetDeadTime(1e3);
  double before = 0.01;
  for (const double photons : { 0.01, 1.0, 5.0, 50.0, 1000.0 })
  {
    CAPTURE(photons);
    const double truth = GetFirstPhoton(photons);
    const ErrorSums found = Sum(Count(detector, MakeEcho(detector, photons)), FirstOf, false);
    CHECK(found.GetMean() - Centre ==
      Approx(truth).margin(4.0 * PulseSigma / std::sqrt(double(found.Count)) + 0.002));
    CHECK(truth < before);
    before = truth;
  }
  CHECK(before < -3.0 * PulseSigma);
}

TEST_CASE(
  "PhotonCounting: times of single photons have the spread of pulse and jitter", "[PhotonCounting]")
{
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  detector->SetTimeJitter(1.2);
  const Counts counts = Count(detector, MakeEcho(detector, 0.2));
  const ErrorSums found = Sum(
    counts, [](const auto& pulse) { return pulse.front().Time - Centre; }, false);
  const double spread = std::sqrt(found.GetRms() * found.GetRms() - std::pow(found.GetMean(), 2));
  CHECK(spread == Approx(std::hypot(PulseSigma, 1.2)).epsilon(0.04));
  for (const auto& pulse : Count(detector, MakeEcho(detector, 30.0), 0.0, 100))
  {
    CHECK(std::is_sorted(
      pulse.begin(), pulse.end(), [](const auto& a, const auto& b) { return a.Time < b.Time; }));
  }
}

TEST_CASE("PhotonCounting: dark counts are uniform in the gate", "[PhotonCounting]")
{
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  CHECK_FALSE(detector->HasDarkCounts());
  detector->SetDarkCountRate(2e6);
  CHECK(detector->HasDarkCounts());
  constexpr double gate = 500.0; // one count on average
  const Counts counts = Count(detector, {}, gate);
  CHECK(Sum(counts, CountOf).GetMean() == Approx(1.0).margin(4.0 / std::sqrt(Pulses)));
  ErrorSums times;
  for (const auto& pulse : counts)
  {
    for (const auto& echo : pulse)
    {
      times.Add(echo.Time / gate);
      REQUIRE((echo.IsDark && echo.Time >= 0.0 && echo.Time <= gate));
    }
  }
  CHECK(times.GetMean() == Approx(0.5).margin(0.01));
  CHECK(times.GetRms() == Approx(std::sqrt(1.0 / 3.0)).margin(0.01));
}

TEST_CASE("PhotonCounting: the dead time loses counts", "[PhotonCounting]")
{
  // Counts at rate r with dead time D are a renewal process: mean m = D + 1 / r, variance 1 / r^2;
  // the first comes after 1 / r. Of Cox 1962, Renewal Theory, section 4.
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  detector->SetDarkCountRate(1e7);
  detector->SetDeadTime(50.0);
  constexpr double gate = 2e4;
  const ErrorSums found = Sum(Count(detector, {}, gate, 2000), CountOf);
  const double mean = 150.0;
  const double truth = (gate - 100.0) / mean + (1e4 + mean * mean) / (2.0 * mean * mean);
  const double spread = std::sqrt(1e4 * gate / std::pow(mean, 3));
  CHECK(found.GetMean() == Approx(truth).margin(4.0 * spread / std::sqrt(2000.0)));
  CHECK(found.GetMean() < 0.7 * gate * 0.01);
}

TEST_CASE("PhotonCounting: counts are of the signal or dark in proportion", "[PhotonCounting]")
{
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  detector->SetDarkCountRate(5e7); // 2 in the window of 40 ns
  const Counts counts = Count(detector, MakeEcho(detector, 3.0));
  const ErrorSums dark = Sum(counts,
    [](const auto& pulse)
    {
      return static_cast<double>(
        std::count_if(pulse.begin(), pulse.end(), [](const auto& echo) { return echo.IsDark; }));
    });
  CHECK(dark.GetMean() == Approx(2.0).margin(4.0 * std::sqrt(2.0 / Pulses)));
  CHECK(Sum(counts, CountOf).GetMean() == Approx(5.0).margin(4.0 * std::sqrt(5.0 / Pulses)));
}

TEST_CASE("PhotonCounting: scans detect by the lidar equation", "[PhotonCounting]")
{
  Bench bench(MakeScene({ Wall(1000, 500) }));
  bench.Scanner->SetSamplingToTolerance();
  bench.Scanner->SetDuration(0.05);
  bench.Scanner->SetAveragePower(0.5);
  const double power = Value(bench.Run(), names::Amplitude, 0);
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  detector->SetDetectionEfficiency(0.03);
  detector->SetDeadTime(1e5);
  bench.Scanner->SetEchoDetector(detector);
  const double energy = power * PulseSigma * std::sqrt(2.0 * std::acos(-1.0)) * 1e-9;
  const double photons = 0.03 * energy / PhotonEnergy;
  REQUIRE(photons > 0.1);
  REQUIRE(photons < 5.0);
  const double p = 1.0 - std::exp(-photons);
  vtkPolyData* echoes = bench.Run();
  CHECK(static_cast<double>(echoes->GetNumberOfPoints()) ==
    Approx(5000.0 * p).margin(4.0 * std::sqrt(5000.0 * p * (1.0 - p))));
  CHECK(Value(echoes, names::Amplitude, 0) ==
    Approx(PhotonEnergy / (0.03 * 4e-9)).epsilon(1e-12)); // one photon
  CHECK(Value(echoes, names::EchoWidth, 0) == 4.0);
  CHECK(Value(echoes, names::PartIds, 0) == 0.0);

  const std::string bytes = Bytes(echoes);
  vtkSMPTools::Initialize(1);
  bench.Scanner->Modified();
  CHECK(Bytes(bench.Run()) == bytes);
  vtkSMPTools::Initialize();
  bench.Scanner->SetSeed(1);
  CHECK(Bytes(bench.Run()) != bytes);
  bench.Scanner->SetAveragePower(0.0);
  CHECK(bench.Run()->GetNumberOfPoints() == 0);
}

TEST_CASE("PhotonCounting: scans have dark counts of no surface in the gate", "[PhotonCounting]")
{
  Bench bench(MakeScene({ Wall(-10) })); // behind the scanner
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  detector->SetDarkCountRate(1e6);
  bench.Scanner->SetEchoDetector(detector);
  bench.Scanner->SetDuration(0.05);
  bench.Scanner->GenerateTruthOn();
  bench.Scanner->Update();
  CHECK(bench.Log->HasError("m, and the EchoDetector has dark counts within the range gate; set "
                            "RangeMax (rangeMax_m) to at most 1e+08 m"));
  bench.Scanner->SetRangeMin(50.0);
  bench.Scanner->SetRangeMax(200.0);
  for (const bool isAdaptive : { false, true })
  {
    bench.Scanner->SetSampling(isAdaptive);
    vtkPolyData* echoes = bench.Run();
    const double mean = 5000.0 * 1e-3 * 2.0 * 150.0 / helios::SpeedOfLight;
    const auto count = echoes->GetNumberOfPoints();
    CHECK(static_cast<double>(count) == Approx(mean).margin(4.0 * std::sqrt(mean)));
    double range[2];
    echoes->GetPointData()->GetArray(names::Range)->GetRange(range);
    CHECK(range[0] >= 50.0);
    CHECK(range[0] < 51.0);
    CHECK(range[1] <= 200.0);
    CHECK(range[1] > 199.0);
    for (const char* name : { names::CellIds, names::MaterialIds, names::PartIds })
    {
      CHECK(Value(echoes, name, count / 2) == -1.0);
    }
    CHECK(bench.Scanner->GetCount("pulsesHit") == 0);
    CHECK(bench.Scanner->GetCount("points") == count);
  }
}

TEST_CASE("PhotonCounting: stored waveforms have the same counts", "[PhotonCounting]")
{
  Bench bench(MakeScene({ Wall(100) }));
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  detector->SetDetectionEfficiency(1e-4);
  detector->SetTimeJitter(0.5);
  bench.Scanner->SetEchoDetector(detector);
  bench.Scanner->SetSeed(5);
  bench.Scanner->SetDuration(1e-2);
  bench.Scanner->GenerateWaveformsOn();
  bench.Scanner->SetRangeMin(50.0);
  vtkPolyData* echoes = bench.Run();
  REQUIRE(echoes->GetNumberOfPoints() > 300);
  vtkNew<vtkHeliosEchoDetection> filter;
  filter->SetInputConnection(bench.Scanner->GetOutputPort(1));
  filter->SetEchoDetector(detector);
  filter->SetSeed(5);
  filter->Update();
  REQUIRE(filter->GetOutput()->GetNumberOfPoints() == echoes->GetNumberOfPoints());
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); i += 17)
  {
    CHECK(Value(filter->GetOutput(), names::Range, i) ==
      Approx(Value(echoes, names::Range, i)).margin(1e-9));
  }
}

TEST_CASE("PhotonCounting: a scan without counts says so", "[PhotonCounting]")
{
  Bench bench(MakeScene({ Wall(100) }));
  vtkNew<vtkHeliosPhotonCountingDetector> detector;
  detector->SetDetectionEfficiency(0.0);
  bench.Scanner->SetEchoDetector(detector);
  bench.Run();
  CHECK(bench.Log->HasWarning("no photon was counted: the largest amplitude of 1000 pulses is "));
  CHECK(bench.Log->HasWarning("W; raise AveragePower or the efficiency of the EchoDetector"));
}
