// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosConstants.h"
#include "heliosTestWaveform.h"
#include "vtkHeliosGaussianDecomposition.h"
#include "vtkHeliosPeakDetector.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <limits>
#include <string>

using namespace helios::testing;

namespace
{

/// Every echo has the true time, amplitude and width.
void CheckExact(const std::vector<Gaussian>& truth, const std::vector<vtkHeliosDetectedEcho>& found,
  double tolerance)
{
  REQUIRE(found.size() == truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    CHECK(found[i].Time == Approx(truth[i].Centre).epsilon(0).margin(tolerance));
    CHECK(found[i].Amplitude == Approx(truth[i].Amplitude).epsilon(tolerance));
    CHECK(found[i].Width == Approx(helios::FwhmPerSigma * truth[i].Sigma).epsilon(tolerance));
    CHECK(found[i].Deviation < 1e-5);
  }
}

void CheckNoneIsLost(const std::vector<float>& samples, std::size_t count, double bin = 1.0)
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  detector->SetDetectionThreshold(0.1);
  const auto echoes = Detect(detector, samples, bin);
  CHECK(echoes.size() == count);
  for (const vtkHeliosDetectedEcho& echo : echoes)
  {
    CHECK(IsFinite(echo));
  }
}

} // namespace

TEST_CASE("GaussianDecomposition: exact for one echo of any width", "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  for (const double bin : { 0.25, 1.0 })
  {
    for (const double sigma : { 1.0, 1.5, 6.0 })
    {
      const std::vector<Gaussian> truth = { { 3e-7, 30.123, sigma * PulseSigma } };
      CheckExact(truth, Detect(detector, MakeSamples(truth, bin), bin), 1e-6);
    }
  }
  CHECK(detector->GivesDeviation());
  CHECK_FALSE(detector->FindsMaxima());
}

TEST_CASE("GaussianDecomposition: exact for overlapping echoes", "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  detector->SetDetectionThreshold(1e-9);
  // Just above the separation at which two echoes have two maxima.
  const std::pair<double, double> limits[] = { { 1.0, 2.0 }, { 0.5, 2.627509132 },
    { 0.25, 2.980675341 }, { 0.1, 3.353995349 }, { 0.01, 4.088443543 } };
  for (const auto& [ratio, limit] : limits)
  {
    CAPTURE(ratio);
    const std::vector<Gaussian> truth = { { 1e-6, 20.03 },
      { ratio * 1e-6, 20.03 + 1.01 * limit * PulseSigma } };
    CheckExact(truth, Detect(detector, MakeSamples(truth, 0.25), 0.25), 1e-3);
  }
  // In fine bins the two maxima are resolved at far smaller separations.
  for (const double factor : { 1.01, 1.02, 1.03, 1.05 })
  {
    CAPTURE(factor);
    const std::vector<Gaussian> truth = { { 1e-6, 20.03 },
      { 1e-6, 20.03 + 2.0 * factor * PulseSigma } };
    CheckExact(truth, Detect(detector, MakeSamples(truth, 0.05), 0.05), 1e-3);
  }
  const std::vector<Gaussian> three = { { 1e-6, 20.03 }, { 5e-7, 25.4, 1.2 * PulseSigma },
    { 8e-7, 31.5 } };
  CheckExact(three, Detect(detector, MakeSamples(three, 0.25), 0.25), 1e-4);
}

TEST_CASE("GaussianDecomposition: a weak echo far from a strong one", "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  const std::vector<Gaussian> truth = { { 1e-6, 15.0 }, { 1e-8, 15.0 + 8.2 * PulseSigma },
    { 1e-6, 50.0 } };
  const auto found = Detect(detector, MakeSamples(truth, 0.25, 80.0), 0.25);
  REQUIRE(found.size() == 3);
  CHECK(found[1].Time == Approx(truth[1].Centre).epsilon(0).margin(1e-3));
  CHECK(found[1].Amplitude == Approx(1e-8).epsilon(1e-3));
}

TEST_CASE("GaussianDecomposition: reaches the Cramer-Rao bound", "[GaussianDecomposition]")
{
  constexpr int pulses = 1500;
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  detector->SetMinimumSeparation(40.0);
  detector->SetDetectionThreshold(0.5);
  for (const double bin : { 0.25, 1.0 })
  {
    for (const double snr : { 20.0, 50.0, 1000.0 })
    {
      CAPTURE(bin, snr);
      ErrorSums sums;
      for (int i = 0; i < pulses; ++i)
      {
        const double truth = 30.0 + bin * i / pulses;
        const auto samples = MakeSamples({ { 1.0, truth } }, bin, 60.0, 1.0 / snr, i);
        const auto echoes = Detect(detector, samples, bin);
        REQUIRE(echoes.size() == 1);
        sums.Add(echoes[0].Time - truth);
      }
      const double bound = GetTimeBound(snr, bin);
      CHECK(sums.GetRms() < 1.1 * bound);
      CHECK(std::abs(sums.GetMean()) < 3.0 * bound / std::sqrt(pulses));
    }
  }
}

TEST_CASE(
  "GaussianDecomposition: the deviation equals that of the noise", "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  detector->SetMinimumSeparation(40.0);
  detector->SetDetectionThreshold(0.5);
  ErrorSums sums;
  for (int i = 0; i < 300; ++i)
  {
    const auto echoes = Detect(detector, MakeSamples({ { 1.0, 30.0 } }, 0.25, 60.0, 0.02, i), 0.25);
    REQUIRE(echoes.size() == 1);
    sums.Add(echoes[0].Deviation);
  }
  CHECK(sums.GetRms() == Approx(0.02).epsilon(0.1));
}

TEST_CASE("GaussianDecomposition: hidden echoes are exact without noise", "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  detector->ResolveHiddenOn();
  for (const double separation : { 0.5, 1.0, 1.5, 1.9 })
  {
    for (const double ratio : { 1.0, 0.5, 0.25 })
    {
      CAPTURE(separation, ratio);
      const std::vector<Gaussian> truth = { { 1e-6, 25.03 },
        { ratio * 1e-6, 25.03 + separation * PulseSigma } };
      CheckExact(truth, Detect(detector, MakeSamples(truth, 0.25), 0.25), 1e-3);
    }
  }
  const std::vector<Gaussian> shoulder = { { 1e-6, 25.03 }, { 1e-7, 25.03 + 3.2 * PulseSigma } };
  CheckExact(shoulder, Detect(detector, MakeSamples(shoulder, 0.25), 0.25), 1e-3);
}

TEST_CASE("GaussianDecomposition: a slope is one echo", "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  detector->ResolveHiddenOn();
  for (const double sigma : { 1.0, 1.01, 1.1, 1.5, 3.0 })
  {
    const std::vector<Gaussian> truth = { { 1e-6, 30.0, sigma * PulseSigma } };
    CheckExact(truth, Detect(detector, MakeSamples(truth, 0.25), 0.25), 1e-5);
  }
}

TEST_CASE("GaussianDecomposition: the separation of hidden echoes reaches its bound",
  "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  detector->ResolveHiddenOn();
  detector->SetMinimumSeparation(40.0);
  detector->SetDetectionThreshold(0.5);
  constexpr double bin = 1.0;
  constexpr int pulses = 600;
  // Range bounds at SNR 50, sigma known. Below sigma the best estimate has a bias that falls with
  // the square of the SNR: the bound is the bound of better ones.
  struct Case
  {
    double Separation, Snr, Bound;
  };
  for (const Case& c : { Case{ 1.0, 200.0, 8.85e-3 / 4 }, Case{ 2.0, 50.0, 5.43e-3 } })
  {
    CAPTURE(c.Separation);
    ErrorSums sums;
    for (int i = 0; i < pulses; ++i)
    {
      const double first = 30.0 + bin * i / pulses;
      const std::vector<Gaussian> truth = { { 1.0, first },
        { 1.0, first + c.Separation * PulseSigma } };
      const auto echoes = Detect(detector, MakeSamples(truth, bin, 60.0, 1.0 / c.Snr, i), bin);
      if (echoes.size() == 2)
      {
        const double error = echoes[1].Time - echoes[0].Time - c.Separation * PulseSigma;
        sums.Add(0.5 * helios::SpeedOfLight * error);
      }
    }
    CHECK(sums.Count > 0.95 * pulses);
    CHECK(sums.GetRms() < 1.1 * c.Bound);
  }
}

TEST_CASE("GaussianDecomposition: a background is fitted on request", "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  detector->SetDetectionThreshold(0.3);
  detector->FitBackgroundOn();
  const std::vector<Gaussian> truth = { { 1.0, 22.1 }, { 0.6, 30.4 } };
  const auto samples = MakeSamples(truth, 0.25, 60.0, 0.0, 0, 0.2);
  CheckExact(truth, Detect(detector, samples, 0.25), 1e-4);
}

TEST_CASE("GaussianDecomposition: maxima below a fraction of the largest are no echoes on request",
  "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  detector->SetDetectionThreshold(0.01);
  const std::vector<Gaussian> all = { { 1.0, 22.1 }, { 0.05, 38.0 }, { 0.3, 52.0 } };
  const auto samples = MakeSamples(all, 0.25, 80.0, 0.0, 0);
  CheckExact(all, Detect(detector, samples, 0.25), 1e-4);
  detector->SetRelativeThreshold(0.1);
  CheckExact({ all[0], all[2] }, Detect(detector, samples, 0.25), 1e-4);
  detector->SetRelativeThreshold(1.0);
  CheckExact({ all[0] }, Detect(detector, samples, 0.25), 1e-4);
  detector->SetRingingTime(20.0); // only up to so long after a larger one
  CheckExact({ all[0], all[2] }, Detect(detector, samples, 0.25), 1e-4);
  detector->SetRingingTime(10.0);
  CheckExact(all, Detect(detector, samples, 0.25), 1e-4);
}

TEST_CASE("GaussianDecomposition: echoes that are not Gaussian are kept", "[GaussianDecomposition]")
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  CheckNoneIsLost({}, 0);
  CheckNoneIsLost({ 0, 0, 0, 0 }, 0);
  CheckNoneIsLost({ 5 }, 1);
  CheckNoneIsLost({ 0, 0, 0, 5, 0, 0, 0 }, 1);
  CheckNoneIsLost({ 0, 1, 2, 5, 5, 5, 5, 5, 2, 1, 0 }, 1);
  CheckNoneIsLost({ 5, 3, 1 }, 1);
  CheckNoneIsLost({ 1, 3, 5 }, 1);
  CheckNoneIsLost({ 5, 0, 5, 0, 5, 0, 5, 0, 5 }, 5);
  CheckNoneIsLost({ 1, 2, 3, nan, 3, 2, 1, 0, 0, 1, 3, 2, 0 }, 1);
  CheckNoneIsLost({ nan, nan, nan }, 0);
  CheckNoneIsLost({ 0, 1, inf, 1, 0, 0, 1, 3, 2, 0 }, 1);
  CheckNoneIsLost(std::vector<float>(100, 1.0f), 1);
}

TEST_CASE("GaussianDecomposition: a failed fit keeps the Gaussian of the maximum",
  "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  vtkNew<vtkHeliosPeakDetector> peaks;
  const auto samples = MakeSamples({ { 1.0, 22.1 }, { 0.8, 27.0 } }, 0.25);
  detector->SetMaximumNumberOfIterations(1);
  const auto found = Detect(detector, samples, 0.25);
  const auto expected = Detect(peaks, samples, 0.25);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    CHECK(found[i].Time == expected[i].Time);
    CHECK(found[i].Amplitude == expected[i].Amplitude);
    CHECK(found[i].Width == expected[i].Width);
    CHECK(std::isnan(found[i].Deviation));
  }
  const auto narrow = Detect(detector, { 0, 0, 0, 5, 0, 0, 0 }, 1.0);
  REQUIRE(narrow.size() == 1);
  CHECK(narrow[0].Time == 3.0);
  CHECK(narrow[0].Amplitude == 5.0);
  CHECK(narrow[0].Width == PulseLength);
}

TEST_CASE("GaussianDecomposition: a saturated echo keeps its position", "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  auto samples = MakeSamples({ { 1.0, 30.1 } }, 0.25);
  for (float& sample : samples)
  {
    sample = std::min(sample, 0.8f);
  }
  const auto echoes = Detect(detector, samples, 0.25);
  REQUIRE(echoes.size() == 1);
  CHECK(echoes[0].Time == Approx(30.1).epsilon(0).margin(0.02));
  CHECK(echoes[0].Amplitude == Approx(0.9).epsilon(0.1));
}

TEST_CASE("GaussianDecomposition: echoes of pure noise are finite", "[GaussianDecomposition]")
{
  vtkNew<vtkHeliosGaussianDecomposition> detector;
  vtkNew<vtkHeliosPeakDetector> peaks;
  for (const bool hidden : { false, true })
  {
    detector->SetResolveHidden(hidden);
    for (std::uint64_t i = 0; i < 30; ++i)
    {
      const auto samples = MakeSamples({}, 1.0, 60.0, 1.0, i);
      const auto echoes = Detect(detector, samples, 1.0);
      CHECK(echoes.size() >= Detect(peaks, samples, 1.0).size());
      for (std::size_t k = 0; k < echoes.size(); ++k)
      {
        CHECK(IsFinite(echoes[k]));
        CHECK(echoes[k].Amplitude > 0.0);
        CHECK((k == 0 || echoes[k - 1].Time <= echoes[k].Time));
      }
    }
  }
}
