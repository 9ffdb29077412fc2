// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosExactPhase.h"
#include "vtkHeliosOscillatingMirror.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// The mirror of the tests: 50 Hz, 30 degrees to either side, 4000 pulses per period.
void SetUp(vtkHeliosOscillatingMirror* mirror)
{
  mirror->SetPulseFrequency(200000.0);
  mirror->SetScanFrequency(50.0);
  mirror->SetScanAngle(30.0);
}

/// The across-track hit of a pulse on flat ground at y = 1000 m.
double Across(vtkHeliosOscillatingMirror* mirror, vtkIdType pulse)
{
  double d[3];
  REQUIRE(mirror->GetDirection(pulse, d));
  REQUIRE(d[0] == 0.0);
  REQUIRE(vtkMath::Norm(d) == Approx(1.0).epsilon(4e-16));
  return 1000.0 * d[2] / d[1];
}

/// The spacing of pulses at 200 kHz, from pulses 1000 times as dense.
double Spacing(vtkHeliosOscillatingMirror* mirror, vtkIdType pulse)
{
  mirror->SetPulseFrequency(2e8);
  const double spacing =
    50.0 * (Across(mirror, 1000 * pulse + 10) - Across(mirror, 1000 * pulse - 10));
  mirror->SetPulseFrequency(200000.0);
  return spacing;
}

/// The first pulse at 1 GHz with a mirror angle of at least 0.9 A, of 1e12 per period: by
/// bisection.
vtkIdType FirstBeyond(vtkHeliosOscillatingMirror* mirror)
{
  vtkIdType low = 0;
  vtkIdType high = 500000000000LL;
  while (high - low > 1)
  {
    const vtkIdType middle = (low + high) / 2;
    (mirror->GetScanAngle(middle) < 0.9 * mirror->GetScanAngle() ? low : high) = middle;
  }
  return high;
}

/// A period of the dialect (helios-dialect B.8): steps with ramps of 100 pulses around each end.
std::vector<double> MakeDialectPeriod(int period, double angle)
{
  const int half = period / 2;
  const double step = 2.0 * angle / (half - 100 + 49.5);
  const auto part = [half](int p, double rising, double falling)
  {
    const double up = (p - 1) / rising;
    const double down = (half - p) / falling;
    return std::min({ 1.0, up, down });
  };
  std::vector<double> angles = { -angle };
  for (int p = 1; p < half; ++p)
  {
    angles.push_back(angles.back() + step * part(p, 49.0, 50.0));
  }
  angles.push_back(angle);
  for (int p = 1; p < half; ++p)
  {
    angles.push_back(angles.back() - step * part(p, 50.0, 49.0));
  }
  return angles;
}

} // namespace

TEST_CASE("OscillatingMirror: triangular spacing in closed form", "[OscillatingMirror]")
{
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  SetUp(mirror);
  CHECK(Spacing(mirror, 1000) == Approx(0.523598776).epsilon(1e-9));
  CHECK(Spacing(mirror, 3000) == Approx(-0.523598776).epsilon(1e-9));
  // Compares the speed at 30 degrees with a mirror that oscillates to 60.
  mirror->SetScanFrequency(25.0);
  mirror->SetScanAngle(60.0);
  CHECK(mirror->GetScanAngle(3000) == Approx(30.0).epsilon(1e-14));
  CHECK(Spacing(mirror, 3000) == Approx(0.698131701).epsilon(1e-9));
}

TEST_CASE("OscillatingMirror: a zigzag along track in closed form", "[OscillatingMirror]")
{
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  SetUp(mirror);
  const double step = 60.0 / 200000.0; // m, at 60 m/s
  CHECK(mirror->GetScanAngle(1000) == Approx(0.0).margin(1e-13));
  CHECK(mirror->GetScanAngle(3000) == Approx(0.0).margin(1e-13));
  CHECK((3000 - 1000) * step == Approx(0.6).epsilon(1e-12));
  // At an end the lines come in pairs: 0 apart, then v / f.
  CHECK(mirror->GetScanAngle(0) == -30.0);
  CHECK(mirror->GetScanAngle(2000) == 30.0);
  CHECK(mirror->GetScanAngle(4000) == -30.0);
  CHECK(mirror->GetScanAngle(1999) == Approx(mirror->GetScanAngle(2001)).epsilon(1e-14));
  CHECK(4000 * step == Approx(1.2).epsilon(1e-12));
}

TEST_CASE("OscillatingMirror: sinusoidal spacing in closed form", "[OscillatingMirror]")
{
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  SetUp(mirror);
  mirror->SetPatternToSinusoidal();
  CHECK(mirror->GetScanAngle(0) == -30.0);
  CHECK(mirror->GetScanAngle(2000) == 30.0);
  CHECK(Spacing(mirror, 1000) == Approx(0.822467033).epsilon(1e-9));
}

TEST_CASE("OscillatingMirror: pulses near the ends in closed form", "[OscillatingMirror]")
{
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  mirror->SetPulseFrequency(1e9);
  mirror->SetScanFrequency(1e-3);
  CHECK(1.0 - 4.0 * (FirstBeyond(mirror) - 250000000000LL) / 1e12 == Approx(0.1).epsilon(1e-9));
  mirror->SetPatternToSinusoidal();
  CHECK(1.0 - 4.0 * (FirstBeyond(mirror) - 250000000000LL) / 1e12 ==
    Approx(0.287132586).epsilon(2e-9)); // nine digits are given
}

TEST_CASE("OscillatingMirror: turningPulses as in the dialect", "[OscillatingMirror]")
{
  // The dialect ramps up over 49 pulses and down over 50, and rests at an end for two: no more than
  // a step from a constant deceleration of the same duration.
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  SetUp(mirror);
  mirror->SetTurningPulses(100);
  const std::vector<double> dialect = MakeDialectPeriod(4000, 30.0);
  const double step = 60.0 / (2000 - 100 + 49.5);
  REQUIRE(dialect.size() == 4000);
  CHECK(dialect[1999] == Approx(30.0).epsilon(1e-12));
  CHECK(dialect[3999] == Approx(-30.0).epsilon(1e-12));
  double largest = 0.0;
  double withoutTurning = 0.0;
  for (vtkIdType i = 0; i < 4000; ++i)
  {
    const double expected = dialect[static_cast<std::size_t>(i)];
    largest = std::max(largest, std::abs(mirror->GetScanAngle(i) - expected));
    mirror->SetTurningPulses(0);
    withoutTurning = std::max(withoutTurning, std::abs(mirror->GetScanAngle(i) - expected));
    mirror->SetTurningPulses(100);
  }
  CHECK(largest < 0.6 * step);
  CHECK(withoutTurning > 12.0 * step);
}

TEST_CASE("OscillatingMirror: constant deceleration at the ends", "[OscillatingMirror]")
{
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  SetUp(mirror);
  mirror->SetTurningPulses(400);
  CHECK(mirror->GetScanAngle(0) == -30.0);
  CHECK(mirror->GetScanAngle(2000) == 30.0);
  const double step = 60.0 / (2000 - 200); // between turns
  for (vtkIdType i = 0; i < 4000; ++i)
  {
    const double last = mirror->GetScanAngle(i + 3999);
    const double here = mirror->GetScanAngle(i);
    const double next = mirror->GetScanAngle(i + 1);
    REQUIRE(std::abs(here) <= 30.0);
    REQUIRE(here == Approx(mirror->GetScanAngle(8000 - i)).margin(1e-13)); // symmetric in time
    // The second difference: zero between turns, constant in a turn.
    const double bend = next - 2.0 * here + last;
    const vtkIdType fromEnd = std::min(i % 2000, 2000 - i % 2000);
    if (fromEnd != 200)
    {
      const double sign = i % 4000 < 1000 || i % 4000 > 3000 ? 1.0 : -1.0;
      REQUIRE(bend == Approx(fromEnd < 200 ? sign * step / 200.0 : 0.0).margin(2e-13));
    }
  }
  CHECK(mirror->GetScanAngle(1001) - mirror->GetScanAngle(1000) == Approx(step).epsilon(1e-11));
  mirror->SetTurningPulses(1000000); // longer than a line: the whole line is a turn
  CHECK(mirror->GetScanAngle(0) == -30.0);
  CHECK(mirror->GetScanAngle(500) == Approx(-22.5).epsilon(1e-13));
  CHECK(mirror->GetScanAngle(1000) == Approx(0.0).margin(1e-13));
  CHECK(mirror->GetScanAngle(2000) == 30.0);
}

TEST_CASE("OscillatingMirror: no drift after a day", "[OscillatingMirror]")
{
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  mirror->SetPulseFrequency(1e6);
  mirror->SetScanFrequency(49.7);
  for (const vtkIdType pulse : { 86400000000LL, 86399999999LL, 77777777777LL, 1LL })
  {
    const double phase = helios::ExactPhase(pulse, 49.7, 1000000);
    const double triangle = 4.0 * std::min(phase, 1.0 - phase) - 1.0;
    mirror->SetPatternToTriangular();
    CHECK(mirror->GetScanAngle(pulse) == Approx(20.0 * triangle).margin(20.0 * 4e-15));
    mirror->SetPatternToSinusoidal();
    CHECK(mirror->GetScanAngle(pulse) ==
      Approx(-20.0 * std::cos(2.0 * Pi * phase)).margin(20.0 * 4e-15));
  }
}

TEST_CASE("OscillatingMirror: values are clamped to their ranges, never NaN", "[OscillatingMirror]")
{
  vtkNew<vtkHeliosOscillatingMirror> mirror;
  mirror->SetPattern(7);
  CHECK(mirror->GetPattern() == vtkHeliosOscillatingMirror::SINUSOIDAL);
  mirror->SetTurningPulses(-5);
  CHECK(mirror->GetTurningPulses() == 0);
  mirror->SetScanAngle(std::numeric_limits<double>::quiet_NaN());
  CHECK(mirror->GetScanAngle() == 0.0);
  mirror->SetScanAngle(300.0);
  CHECK(mirror->GetScanAngle() == 180.0);
  for (const double frequency : { 0.0, 1e-9, 1e6, std::numeric_limits<double>::quiet_NaN() })
  {
    mirror->SetScanFrequency(frequency);
    for (const int pattern : { 0, 1 })
    {
      for (const int turning : { 0, 100, 1000000000 })
      {
        mirror->SetPattern(pattern);
        mirror->SetTurningPulses(turning);
        for (const vtkIdType pulse : { 0LL, 1LL, 86400000000LL, 9007199254740991LL })
        {
          REQUIRE(std::abs(mirror->GetScanAngle(pulse)) <= 180.0);
        }
      }
    }
  }
}
