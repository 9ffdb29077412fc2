// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTestWaveform.h"
#include "vtkHeliosConstantFractionDetector.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <limits>

using namespace helios::testing;

TEST_CASE("ConstantFractionDetector: echo at the peak for any fraction and delay",
  "[ConstantFractionDetector]")
{
  vtkNew<vtkHeliosConstantFractionDetector> detector;
  for (const double fraction : { 0.2, 0.5, 1.0 })
  {
    for (const double delay : { 0.0, 2.0, 5.03 })
    {
      CAPTURE(fraction, delay);
      detector->SetFraction(fraction);
      detector->SetDelay(delay);
      const auto echoes = Detect(detector, MakeSamples({ { 1e-6, 30.013 } }, 0.05), 0.05);
      REQUIRE(echoes.size() == 1);
      CHECK(echoes[0].Time == Approx(30.013).epsilon(0).margin(2e-3));
      CHECK(echoes[0].Amplitude == Approx(1e-6).epsilon(1e-3));
      CHECK(echoes[0].Width == Approx(PulseLength).epsilon(1e-3));
    }
  }
}

TEST_CASE("ConstantFractionDetector: no range walk with amplitude", "[ConstantFractionDetector]")
{
  vtkNew<vtkHeliosConstantFractionDetector> detector;
  const auto timeOf = [&detector](double amplitude)
  {
    const auto echoes = Detect(detector, MakeSamples({ { amplitude, 30.1 } }, 0.25), 0.25);
    REQUIRE(echoes.size() == 1);
    return echoes[0].Time;
  };
  const double reference = timeOf(1e-6);
  for (const double amplitude : { 1e-12, 1e-9, 1e-3 })
  {
    CHECK(timeOf(amplitude) == Approx(reference).epsilon(0).margin(2e-6)); // float samples
  }
}

TEST_CASE("ConstantFractionDetector: the error of a wider echo equals the closed form",
  "[ConstantFractionDetector]")
{
  vtkNew<vtkHeliosConstantFractionDetector> detector;
  detector->SetFraction(0.3);
  detector->SetDelay(3.0);
  const double sigma = 1.5 * PulseSigma;
  const auto echoes = Detect(detector, MakeSamples({ { 1.0, 30.1, sigma } }, 0.05), 0.05);
  REQUIRE(echoes.size() == 1);
  const double error = (sigma * sigma - PulseSigma * PulseSigma) * std::log(0.3) / 3.0;
  CHECK(echoes[0].Time == Approx(30.1 + error).epsilon(0).margin(2e-3));
}

TEST_CASE("ConstantFractionDetector: threshold and dead time", "[ConstantFractionDetector]")
{
  vtkNew<vtkHeliosConstantFractionDetector> detector;
  const auto samples = MakeSamples({ { 1.0, 15.0 }, { 0.2, 27.0 }, { 1.0, 45.0 } }, 0.25);
  CHECK(Detect(detector, samples, 0.25).size() == 3);
  detector->SetDetectionThreshold(0.5);
  CHECK(Detect(detector, samples, 0.25).size() == 2);
  detector->SetDetectionThreshold(0.1);
  detector->SetDeadTime(20.0);
  const auto echoes = Detect(detector, samples, 0.25);
  REQUIRE(echoes.size() == 2);
  CHECK(echoes[1].Time == Approx(45.0).epsilon(0).margin(0.02));
}

TEST_CASE("ConstantFractionDetector: no signal, and values that are not finite",
  "[ConstantFractionDetector]")
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  vtkNew<vtkHeliosConstantFractionDetector> detector;
  detector->SetDetectionThreshold(0.0);
  CHECK(Detect(detector, {}, 1.0).empty());
  CHECK(Detect(detector, { 0, 0, 0, 0 }, 1.0).empty());
  CHECK(Detect(detector, { nan, nan }, 1.0).empty());
  for (const auto& echo : Detect(detector, { 1, nan, 5, 1, 0, -1, 2, 0, 0, 0, 0, 0 }, 1.0))
  {
    CHECK(IsFinite(echo));
  }
}
