// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRandom.h"
#include "vtkHeliosPeakDetector.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace
{

constexpr double Sigma = 1.6986436; // sigma of a pulse of 4 ns

std::vector<float> Gaussian(double centre, double bin, double sigma = Sigma)
{
  std::vector<float> samples;
  for (double t = 0; t < 40; t += bin)
  {
    samples.push_back(
      static_cast<float>(1e-6 * std::exp(-0.5 * std::pow((t - centre) / sigma, 2))));
  }
  return samples;
}

std::vector<vtkHeliosDetectedEcho> Detect(
  const std::vector<float>& samples, double bin, double threshold = 1e-13)
{
  vtkNew<vtkHeliosPeakDetector> detector;
  detector->SetDetectionThreshold(threshold);
  std::vector<vtkHeliosDetectedEcho> echoes;
  detector->Detect({ samples.data(), static_cast<vtkIdType>(samples.size()), bin, 4.0 }, echoes);
  return echoes;
}

} // namespace

TEST_CASE("PeakDetector: exact for one Gaussian at any position", "[PeakDetector]")
{
  for (const double centre : { 20.0, 20.1, 20.123456, 20.125, 20.375, 19.99 })
  {
    for (const double bin : { 0.25, 0.5, 1.0 })
    {
      const auto echoes = Detect(Gaussian(centre, bin), bin);
      REQUIRE(echoes.size() == 1);
      CHECK(echoes[0].Time == Approx(centre).epsilon(0).margin(4e-6)); // float samples
      CHECK(echoes[0].Amplitude == Approx(1e-6).epsilon(1e-6));
      CHECK(echoes[0].Width == Approx(2.35482 * Sigma).epsilon(1e-4));
    }
  }
}

TEST_CASE("PeakDetector: the width is that of the echo", "[PeakDetector]")
{
  const auto echoes = Detect(Gaussian(20.2, 0.25, 2.5), 0.25);
  REQUIRE(echoes.size() == 1);
  CHECK(echoes[0].Width == Approx(2.35482 * 2.5).epsilon(1e-4));
}

TEST_CASE("PeakDetector: a plateau is one echo at its centre", "[PeakDetector]")
{
  const auto echoes = Detect({ 0, 1, 2, 5, 5, 5, 2, 1, 0 }, 1.0);
  REQUIRE(echoes.size() == 1);
  CHECK(echoes[0].Time == Approx(4.0));
  CHECK(echoes[0].Amplitude >= 5.0);
}

TEST_CASE("PeakDetector: weak and narrow echoes with flanks below the threshold", "[PeakDetector]")
{
  CHECK(Detect({ 0, 0, 1, 5, 1, 0, 0 }, 1.0, 4.0).size() == 1);
  CHECK(Detect({ 0, 0, 1, 5, 1, 0, 0 }, 1.0, 6.0).empty());
  CHECK(Detect({ 0, 0, 0, 5, 0, 0, 0 }, 1.0, 4.0).size() == 1);
}

TEST_CASE("PeakDetector: the ends of the waveform", "[PeakDetector]")
{
  CHECK(Detect({ 5, 3, 1 }, 1.0).size() == 1);
  CHECK(Detect({ 1, 3, 5 }, 1.0).size() == 1);
  CHECK(Detect({ 0, 0, 0 }, 1.0).empty());
  CHECK(Detect({}, 1.0).empty());
}

TEST_CASE("PeakDetector: an echo of one sample has the width of the pulse", "[PeakDetector]")
{
  for (const std::vector<float>& samples :
    { std::vector<float>{ 0, 0, 5, 0, 0 }, { -1, -1, 5, -1, -1 }, { 0, 1, 5, 0, 0 } })
  {
    const auto echoes = Detect(samples, 0.5, 4.0);
    REQUIRE(echoes.size() == 1);
    CHECK(echoes[0].Time == 1.0);
    CHECK(echoes[0].Amplitude == 5.0);
    CHECK(echoes[0].Width == 4.0);
  }
}

TEST_CASE("PeakDetector: samples that are not finite give no echo", "[PeakDetector]")
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  CHECK(Detect({ nan, nan, nan }, 1.0).empty());
  CHECK(Detect({ 0, 1, inf, 1, 0 }, 1.0).empty());
  CHECK(Detect({ 0, 1, nan, 1, 3, 1, 0 }, 1.0).size() == 1);
  vtkNew<vtkHeliosPeakDetector> detector;
  detector->SetFitWindow(1.0);
  std::vector<vtkHeliosDetectedEcho> echoes;
  const std::vector<float> samples = { 0, 1, nan, 1, 3, 1, inf, 0, 2, 0 };
  detector->Detect({ samples.data(), 10, 1.0, 4.0 }, echoes);
  for (const vtkHeliosDetectedEcho& echo : echoes)
  {
    CHECK(std::isfinite(echo.Time + echo.Amplitude + echo.Width));
  }
}

TEST_CASE("PeakDetector: a fit over a window is exact for a Gaussian", "[PeakDetector]")
{
  vtkNew<vtkHeliosPeakDetector> detector;
  CHECK(detector->FindsMaxima());
  detector->SetFitWindow(1.0);
  CHECK_FALSE(detector->FindsMaxima());
  for (const double sigma : { Sigma, 2.5 })
  {
    const auto samples = Gaussian(20.1234, 0.25, sigma);
    std::vector<vtkHeliosDetectedEcho> echoes;
    detector->Detect({ samples.data(), static_cast<vtkIdType>(samples.size()), 0.25, 4.0 }, echoes);
    REQUIRE(echoes.size() == 1);
    CHECK(echoes[0].Time == Approx(20.1234).epsilon(0).margin(1e-6));
    CHECK(echoes[0].Amplitude == Approx(1e-6).epsilon(1e-6));
    CHECK(echoes[0].Width == Approx(2.35482 * sigma).epsilon(1e-5));
  }
}

TEST_CASE(
  "PeakDetector: with noise, a fit over a window is accurate for fine bins", "[PeakDetector]")
{
  constexpr int pulses = 600;
  constexpr double snr = 50.0;
  const auto errorOverBound = [](double bin, double window)
  {
    vtkNew<vtkHeliosPeakDetector> detector;
    detector->SetFitWindow(window);
    detector->SetMinimumSeparation(40.0);
    double sum = 0.0;
    for (std::uint32_t pulse = 0; pulse < pulses; ++pulse)
    {
      const double centre = 20.0 + bin * pulse / pulses;
      auto samples = Gaussian(centre, bin);
      for (std::uint32_t i = 0; i < samples.size(); ++i)
      {
        const auto noise = helios::NormalPair(3, helios::RandomStream::DetectorNoise, pulse, i);
        samples[i] += static_cast<float>(1e-6 / snr * noise[0]);
      }
      std::vector<vtkHeliosDetectedEcho> echoes;
      detector->Detect(
        { samples.data(), static_cast<vtkIdType>(samples.size()), bin, 4.0 }, echoes);
      REQUIRE(echoes.size() == 1);
      sum += (echoes[0].Time - centre) * (echoes[0].Time - centre);
    }
    const double bound = std::sqrt(2.0 * Sigma * bin / std::sqrt(std::acos(-1.0))) / snr;
    return std::sqrt(sum / pulses) / bound;
  };
  // Three samples: 11 and 2.1 times the Cramer-Rao bound.
  CHECK(errorOverBound(0.25, 0.0) > 5.0);
  CHECK(errorOverBound(1.0, 0.0) > 1.8);
  CHECK(errorOverBound(0.25, 1.0) < 1.9);
  CHECK(errorOverBound(0.25, 1.5) < 1.3);
  CHECK(errorOverBound(1.0, 1.5) < 1.3);
}

TEST_CASE("PeakDetector: of maxima within MinimumSeparation the largest is kept", "[PeakDetector]")
{
  const std::vector<float> samples = { 0, 3, 1, 5, 1, 4, 1, 4, 0, 0, 0, 0, 2, 0 };
  const auto timesOf = [&samples](double separation)
  {
    vtkNew<vtkHeliosPeakDetector> detector;
    detector->SetMinimumSeparation(separation);
    std::vector<vtkHeliosDetectedEcho> echoes;
    detector->Detect({ samples.data(), static_cast<vtkIdType>(samples.size()), 1.0, 4.0 }, echoes);
    std::vector<int> bins;
    for (const auto& echo : echoes)
    {
      bins.push_back(static_cast<int>(std::lround(echo.Time)));
    }
    return bins;
  };
  CHECK(timesOf(0.0) == std::vector<int>{ 1, 3, 5, 7, 12 });
  CHECK(timesOf(2.0) == std::vector<int>{ 1, 3, 5, 7, 12 }); // nearer than, exclusive
  CHECK(timesOf(2.1) == std::vector<int>{ 3, 12 }); // the first of two equal ones, itself too near
  CHECK(timesOf(20.0) == std::vector<int>{ 3 });
}
