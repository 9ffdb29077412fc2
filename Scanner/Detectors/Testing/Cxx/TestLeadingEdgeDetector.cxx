// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTestWaveform.h"
#include "vtkHeliosLeadingEdgeDetector.h"

#include <vtkNew.h>

#include <catch2/catch.hpp>

#include <limits>

using namespace helios::testing;

namespace
{

/// Returns the time from the crossing of a level to the peak of a Gaussian [ns].
double RiseTime(double amplitude, double level)
{
  return PulseSigma * std::sqrt(2.0 * std::log(amplitude / level));
}

} // namespace

TEST_CASE("LeadingEdgeDetector: the walk error equals the closed form", "[LeadingEdgeDetector]")
{
  vtkNew<vtkHeliosLeadingEdgeDetector> detector;
  constexpr double level = 1e-7;
  constexpr double reference = 1e-6;
  detector->SetDetectionThreshold(level);
  detector->SetReferenceAmplitude(reference);
  for (const double amplitude : { 1.5e-7, 3e-7, 1e-6, 1e-5 })
  {
    CAPTURE(amplitude);
    const auto echoes = Detect(detector, MakeSamples({ { amplitude, 30.01 } }, 0.01), 0.01);
    REQUIRE(echoes.size() == 1);
    const double walk = RiseTime(reference, level) - RiseTime(amplitude, level);
    CHECK(echoes[0].Time == Approx(30.01 + walk).epsilon(0).margin(1e-4));
    CHECK(echoes[0].Amplitude == Approx(amplitude).epsilon(1e-4));
    CHECK(echoes[0].Width == Approx(PulseLength).epsilon(1e-4));
  }
}

TEST_CASE("LeadingEdgeDetector: without a reference half an amplitude has no walk error",
  "[LeadingEdgeDetector]")
{
  vtkNew<vtkHeliosLeadingEdgeDetector> detector;
  detector->SetDetectionThreshold(0.5);
  const auto echoes = Detect(detector, MakeSamples({ { 1.0, 30.01 } }, 0.01), 0.01);
  REQUIRE(echoes.size() == 1);
  CHECK(echoes[0].Time == Approx(30.01).epsilon(0).margin(1e-4));
}

TEST_CASE(
  "LeadingEdgeDetector: Fraction is relative to the largest sample", "[LeadingEdgeDetector]")
{
  vtkNew<vtkHeliosLeadingEdgeDetector> detector;
  detector->SetFraction(0.3);
  const auto samples = MakeSamples({ { 1e-6, 20.01 }, { 5e-7, 40.02 }, { 2e-7, 52.0 } }, 0.01);
  const auto echoes = Detect(detector, samples, 0.01);
  REQUIRE(echoes.size() == 2); // the third stays below the level
  CHECK(echoes[0].Time == Approx(20.01).epsilon(0).margin(1e-4));
  const double walk = RiseTime(1.0, 0.3) - RiseTime(0.5, 0.3);
  CHECK(echoes[1].Time == Approx(40.02 + walk).epsilon(0).margin(1e-4));
  detector->SetDetectionThreshold(6e-7); // higher than the fraction
  CHECK(Detect(detector, samples, 0.01).size() == 1);
}

TEST_CASE(
  "LeadingEdgeDetector: one echo per crossing, none in the dead time", "[LeadingEdgeDetector]")
{
  vtkNew<vtkHeliosLeadingEdgeDetector> detector;
  detector->SetDetectionThreshold(0.5);
  const auto samples = MakeSamples({ { 1.0, 15.0 }, { 1.0, 25.0 }, { 1.0, 45.0 } }, 0.25);
  CHECK(Detect(detector, samples, 0.25).size() == 3);
  detector->SetDeadTime(15.0);
  const auto echoes = Detect(detector, samples, 0.25);
  REQUIRE(echoes.size() == 2);
  CHECK(echoes[1].Time == Approx(45.0).epsilon(0).margin(0.01));
  CHECK(Detect(detector, MakeSamples({ { 1.0, 20.0 }, { 1.0, 22.0 } }, 0.25), 0.25).size() == 1);
}

TEST_CASE("LeadingEdgeDetector: ends of the waveform, no signal, and values that are not finite",
  "[LeadingEdgeDetector]")
{
  const float nan = std::numeric_limits<float>::quiet_NaN();
  vtkNew<vtkHeliosLeadingEdgeDetector> detector;
  detector->SetDetectionThreshold(2.0);
  CHECK(Detect(detector, {}, 1.0).empty());
  CHECK(Detect(detector, { 0, 0, 0 }, 1.0).empty());
  CHECK(Detect(detector, { nan, nan }, 1.0).empty());
  const auto first = Detect(detector, { 5, 3, 1 }, 1.0);
  REQUIRE(first.size() == 1);
  CHECK(first[0].Time >= 0.0);
  CHECK(Detect(detector, { 1, 3, 5 }, 1.0).size() == 1);
  CHECK(Detect(detector, { 0, 1, nan, 5, 1, 0 }, 1.0).size() == 1);
  detector->SetDetectionThreshold(0.0);
  for (const auto& echo : Detect(detector, { 0, 1, nan, 5, 1, 0, -1, 2 }, 1.0))
  {
    CHECK(IsFinite(echo));
  }
}
