// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosExactPhase.h"
#include "vtkHeliosRotatingMirror.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <limits>

namespace
{

/// The across-track hit of a pulse on flat ground at y = 1000 m.
double Across(vtkHeliosRotatingMirror* mirror, vtkIdType pulse)
{
  double d[3];
  REQUIRE(mirror->GetDirection(pulse, d));
  return 1000.0 * d[2] / d[1];
}

double Radians(double degrees)
{
  return vtkMath::RadiansFromDegrees(degrees);
}

int CountPulses(vtkHeliosRotatingMirror* mirror, vtkIdType begin, vtkIdType end)
{
  int count = 0;
  double d[3];
  for (vtkIdType i = begin; i < end; ++i)
  {
    count += mirror->GetDirection(i, d) ? 1 : 0;
  }
  return count;
}

} // namespace

TEST_CASE("RotatingMirror: pulse 0 is along y, all directions are unit vectors", "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  double d[3];
  REQUIRE(mirror->GetDirection(0, d));
  CHECK(d[0] == 0.0);
  CHECK(d[1] == 1.0);
  CHECK(d[2] == 0.0);
  for (vtkIdType i = 0; i < 3000; ++i)
  {
    REQUIRE(mirror->GetDirection(i, d));
    const double beta = Radians(mirror->GetScanAngle(i));
    REQUIRE(d[0] == 0.0);
    REQUIRE(d[1] == Approx(std::cos(beta)).margin(1e-15));
    REQUIRE(d[2] == Approx(std::sin(beta)).margin(1e-15));
    REQUIRE(vtkMath::Norm(d) == Approx(1.0).epsilon(4e-16));
  }
}

TEST_CASE("RotatingMirror: spacing across track of 100 lines/s at 200 kHz over 60 degrees",
  "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetPulseFrequency(200000.0);
  mirror->SetScanFrequency(100.0);
  mirror->SetMirrorAngle(30.0);
  const double step = Radians(0.03);
  for (vtkIdType i = 200; i < 999; ++i)
  {
    const double a = Radians(0.03 * (static_cast<double>(i) + 0.5));
    const double expected = 1000.0 * (std::tan(a + 0.5 * step) - std::tan(a - 0.5 * step));
    REQUIRE(Across(mirror, i + 1) - Across(mirror, i) == Approx(expected).epsilon(1e-9));
  }
}

TEST_CASE("RotatingMirror: spacing across track in closed form", "[RotatingMirror]")
{
  // The same angular speed, six times the pulses over twice the sweep: pulses on both sides
  // of 0, 10, 20 and 30 degrees.
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetPulseFrequency(1200000.0);
  mirror->SetScanFrequency(50.0);
  mirror->SetMirrorAngle(60.0);
  const vtkIdType line = 24000;
  const double expected[4] = { 0.523598788, 0.539878105, 0.592962192, 0.698131733 };
  for (int k = 0; k < 4; ++k)
  {
    const vtkIdType i = line + 2000 * k; // at 10 k degrees
    CHECK(mirror->GetScanAngle(i) == Approx(10.0 * k).margin(1e-12));
    CHECK(Across(mirror, i + 3) - Across(mirror, i - 3) == Approx(expected[k]).margin(6e-10));
  }
}

TEST_CASE("RotatingMirror: skew of the lines in closed form", "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetPulseFrequency(200000.0);
  mirror->SetScanFrequency(100.0);
  mirror->SetMirrorAngle(30.0);
  vtkIdType begin = 0;
  while (mirror->GetScanAngle(begin) < mirror->GetScanAngle(begin + 1))
  {
    ++begin;
  }
  vtkIdType end = ++begin; // the first pulse of a line
  while (mirror->GetScanAngle(end) < mirror->GetScanAngle(end + 1))
  {
    ++end;
  }
  const double perPulse = 60.0 / 200000.0; // m, at 60 m/s
  CHECK(static_cast<double>(end - begin) * perPulse == Approx(0.5997).epsilon(1e-9));
  CHECK(static_cast<double>(end + 1 - begin) * perPulse == Approx(0.6).epsilon(1e-9));
}

TEST_CASE("RotatingMirror: a line rate that does not divide the pulse rate is kept for a day",
  "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetPulseFrequency(1e6);
  mirror->SetScanFrequency(99.7);
  mirror->SetMirrorAngle(30.0);
  for (const vtkIdType pulse : { 86400000000LL, 86399999999LL, 12345678901LL, 10030LL, 1LL })
  {
    const double phase = helios::ExactPhase(pulse, 99.7, 1000000);
    const double beta = 60.0 * (phase > 0.5 ? phase - 1.0 : phase);
    CHECK(mirror->GetScanAngle(pulse) == Approx(beta).margin(30.0 * 1e-15));
  }
  // 99.7 lines/s for 86400 s are 8614080 whole lines; the decimal is stored to 7e-15.
  CHECK(mirror->GetScanAngle(86400000000LL) == Approx(0.0).margin(60.0 * 86400.0 * 7.2e-15));
}

TEST_CASE("RotatingMirror: a window as wide as the sweep passes every pulse", "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetPulseFrequency(100000.0);
  mirror->SetScanFrequency(50.0);
  for (const double angle : { 30.0, 180.0, 360.0 })
  {
    mirror->SetMirrorAngle(angle);
    mirror->SetVerticalAngleMin(-angle);
    mirror->SetVerticalAngleMax(angle);
    CHECK(CountPulses(mirror, 0, 10000) == 10000);
    CHECK(mirror->GetScanAngle(1000) == angle); // the end of the sweep, not its start
  }
}

TEST_CASE("RotatingMirror: the window is open below and closed above", "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetPulseFrequency(300000.0);
  mirror->SetScanFrequency(100.0);
  mirror->SetMirrorAngle(120.0);
  mirror->SetVerticalAngleMin(-40.04); // pulses every 0.08 degrees, from -40 to 60
  mirror->SetVerticalAngleMax(60.04);
  CHECK(CountPulses(mirror, 0, 30000) == 12510);
  double d[3];
  CHECK(mirror->GetScanAngle(750) == 60.0);
  mirror->SetVerticalAngleMax(60.0);
  CHECK(mirror->GetDirection(750, d));
  CHECK_FALSE(mirror->GetDirection(751, d));
  mirror->SetVerticalAngleMin(60.0);
  CHECK(CountPulses(mirror, 0, 30000) == 0); // an empty window
  mirror->SetVerticalAngleMax(70.0);
  CHECK_FALSE(mirror->GetDirection(750, d));
  CHECK(mirror->GetDirection(751, d));
}

TEST_CASE("RotatingMirror: windows beyond half a revolution", "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetPulseFrequency(72000.0);
  mirror->SetScanFrequency(10.0); // 7200 pulses over 720 degrees
  mirror->SetMirrorAngle(360.0);
  mirror->SetVerticalAngleMin(170.0);
  mirror->SetVerticalAngleMax(300.0);
  CHECK(CountPulses(mirror, 0, 7200) == 1300);
  double d[3];
  REQUIRE(mirror->GetDirection(2700, d)); // 270 degrees: straight down
  CHECK(d[1] == Approx(0.0).margin(1e-15));
  CHECK(d[2] == Approx(-1.0).epsilon(1e-15));
}

TEST_CASE("RotatingMirror: no NaN for any index or frequency", "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  double d[3];
  for (const double frequency : { 0.0, 1e-9, 1e6, std::numeric_limits<double>::quiet_NaN() })
  {
    mirror->SetScanFrequency(frequency);
    for (const vtkIdType pulse : { 0LL, 1LL, 86400000000LL, 9007199254740991LL })
    {
      REQUIRE(mirror->GetDirection(pulse, d));
      REQUIRE(vtkMath::Norm(d) == Approx(1.0).epsilon(4e-16));
    }
  }
}

TEST_CASE("RotatingMirror: facets reflect a beam along the shaft", "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror; // a pyramid of three facets: nadir, forward, backward
  mirror->SetPulseFrequency(240000.0);
  mirror->SetScanFrequency(200.0); // 1200 pulses a line
  mirror->SetMirrorAngle(60.0);
  mirror->SetVerticalAngleMin(-60.0);
  mirror->SetVerticalAngleMax(60.0);
  mirror->SetNumberOfFacets(3);
  const double pitches[3] = { 0.0, -10.0, 10.0 };
  const double rolls[3] = { 0.0, 0.25, -0.125 };
  for (int k = 0; k < 3; ++k)
  {
    mirror->SetFacetPitch(k, pitches[k]);
    mirror->SetFacetRoll(k, rolls[k]);
  }
  const vtkIdType day = 240000LL * 86400;
  for (const vtkIdType pulse : { 0LL, 600LL, 601LL, 1200LL, 1799LL, 1800LL, 1801LL, 2400LL, 3000LL,
         3001LL, 3600LL, day, day + 601LL, day + 1801LL, day + 3001LL })
  {
    INFO("pulse " << pulse);
    const vtkIdType line = (pulse + 599) / 1200; // a sweep ends with its last angle
    const double along = static_cast<double>(pulse - 1200 * line) / 10.0; // 120 degrees a line
    const auto facet = static_cast<std::size_t>(line % 3);
    REQUIRE(mirror->GetFacet(pulse) == static_cast<int>(facet));
    CHECK(mirror->GetScanAngle(pulse) == Approx(along + rolls[facet]).margin(1e-11));
    // The law of reflection, d = u - 2 (u . n) n.
    const double tilt = Radians(45.0 + 0.5 * pitches[facet]);
    const double turn = Radians(along + rolls[facet]);
    const double n[3] = { -std::cos(tilt), std::sin(tilt) * std::cos(turn),
      std::sin(tilt) * std::sin(turn) };
    double d[3];
    REQUIRE(mirror->GetDirection(pulse, d));
    for (int k = 0; k < 3; ++k)
    {
      CHECK(d[k] == Approx((k == 0 ? 1.0 : 0.0) - 2.0 * n[0] * n[k]).margin(1e-13));
    }
  }
}

TEST_CASE("RotatingMirror: the lines of a facet are conics on flat ground", "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  mirror->SetMirrorAngle(60.0);
  mirror->SetNumberOfFacets(2);
  mirror->SetFacetPitch(1, 10.0);
  CHECK(mirror->GetFacet(500) == 0); // a sweep ends with its last angle
  CHECK(mirror->GetFacet(501) == 1);
  CHECK(mirror->GetFacet(1500) == 1);
  CHECK(mirror->GetFacet(1501) == 0);
  double d[3];
  for (vtkIdType i = 600; i < 1400; ++i) // second line of 1000 pulses
  {
    REQUIRE(mirror->GetFacet(i) == 1);
    REQUIRE(mirror->GetDirection(i, d));
    const double x = d[0] / d[1];
    const double z = d[2] / d[1];
    REQUIRE(x == Approx(std::tan(Radians(10.0)) * std::sqrt(1.0 + z * z)).epsilon(1e-13));
  }
}

TEST_CASE("RotatingMirror: facets out of range", "[RotatingMirror]")
{
  vtkNew<vtkHeliosRotatingMirror> mirror;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(mirror);
  mirror->SetNumberOfFacets(0);
  CHECK(mirror->GetNumberOfFacets() == 1);
  mirror->SetNumberOfFacets(2000);
  CHECK(mirror->GetNumberOfFacets() == 1000);
  mirror->SetFacetPitch(999, 100.0);
  mirror->SetFacetRoll(999, -200.0);
  CHECK(mirror->GetFacetPitch(999) == 89.0);
  CHECK(mirror->GetFacetRoll(999) == -180.0);
  mirror->SetFacetPitch(999, std::numeric_limits<double>::quiet_NaN());
  CHECK(mirror->GetFacetPitch(999) == 0.0);
  CHECK(mirror->GetFacetPitch(1000) == 0.0);
  mirror->SetFacetPitch(1000, 1.0);
  CHECK(
    log->HasError("there is no facet 1000; give one from 0 to 999, or set NumberOfFacets first"));
  mirror->SetFacetRoll(-1, 1.0);
  CHECK(log->HasError("there is no facet -1"));
}
