// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPeakDetector.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace
{

constexpr double Sigma = 1.6986436; // of a pulse of 4 ns

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

TEST_CASE("PeakDetector: exact for one Gaussian, wherever it lies", "[PeakDetector]")
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

TEST_CASE("PeakDetector: a plateau is one echo in its middle", "[PeakDetector]")
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
