// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosExactPhase.h"
#include "vtkHeliosConicMirror.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{

/// A conic scanner 1000 m above flat ground (y = 1000 m in its own frame).
void SetUp(vtkHeliosConicMirror* mirror)
{
  mirror->SetPulseFrequency(200000.0);
  mirror->SetScanFrequency(100.0);
  mirror->SetScanAngle(20.0);
}

/// The ground hit of a pulse, relative to the point below; returns the range.
double Hit(vtkHeliosConicMirror* mirror, vtkIdType pulse, double point[2])
{
  double d[3];
  REQUIRE(mirror->GetDirection(pulse, d));
  const double range = 1000.0 / d[1];
  point[0] = range * d[0];
  point[1] = range * d[2];
  return range;
}

} // namespace

TEST_CASE("ConicMirror: radius, range and spacing of the circle in closed form", "[ConicMirror]")
{
  vtkNew<vtkHeliosConicMirror> mirror;
  SetUp(mirror);
  for (vtkIdType i = 0; i < 4000; ++i)
  {
    double p[2];
    double q[2];
    REQUIRE(Hit(mirror, i, p) == Approx(1064.177772475912).epsilon(1e-14));
    Hit(mirror, i + 1, q);
    const double radius = std::hypot(p[0], p[1]);
    const double turn = std::atan2(q[0] * p[1] - q[1] * p[0], p[0] * q[0] + p[1] * q[1]);
    REQUIRE(radius == Approx(363.970234266).epsilon(1e-9));
    REQUIRE(radius * turn == Approx(1.143446214).epsilon(1e-9)); // rotates from z to x
  }
}

TEST_CASE("ConicMirror: mean density at 60 m/s in closed form", "[ConicMirror]")
{
  vtkNew<vtkHeliosConicMirror> mirror;
  SetUp(mirror);
  double least = 0.0;
  double most = 0.0;
  for (vtkIdType i = 0; i < 2000; ++i) // one revolution
  {
    double p[2];
    Hit(mirror, i, p);
    least = std::min(least, p[1]);
    most = std::max(most, p[1]);
  }
  CHECK(200000.0 / 60.0 / (most - least) == Approx(4.579129032).epsilon(1e-9));
}

TEST_CASE("ConicMirror: the spacing follows the set frequency", "[ConicMirror]")
{
  vtkNew<vtkHeliosConicMirror> mirror;
  SetUp(mirror);
  mirror->SetScanFrequency(50.0);
  double p[2];
  Hit(mirror, 1, p);
  CHECK(std::hypot(p[0], p[1]) * std::atan2(p[0], p[1]) == Approx(0.5 * 1.143446214).epsilon(1e-9));
}

TEST_CASE("ConicMirror: pulse 0 is at azimuth 0, the axis is y", "[ConicMirror]")
{
  vtkNew<vtkHeliosConicMirror> mirror;
  CHECK(mirror->GetScanAngle() == 20.0);
  double d[3];
  REQUIRE(mirror->GetDirection(0, d));
  CHECK(d[0] == 0.0);
  CHECK(d[1] == Approx(std::cos(vtkMath::RadiansFromDegrees(20.0))).epsilon(1e-15));
  CHECK(d[2] == Approx(std::sin(vtkMath::RadiansFromDegrees(20.0))).epsilon(1e-15));
  CHECK(mirror->GetScanAngle(12345) == 20.0);
}

TEST_CASE("ConicMirror: no drift after a day", "[ConicMirror]")
{
  vtkNew<vtkHeliosConicMirror> mirror;
  mirror->SetPulseFrequency(1e6);
  mirror->SetScanFrequency(99.7);
  mirror->SetScanAngle(90.0);
  for (const vtkIdType pulse : { 86400000000LL, 86399999999LL, 77777777777LL })
  {
    const double phi = 2.0 * vtkMath::Pi() * helios::ExactPhase(pulse, 99.7, 1000000);
    double d[3];
    REQUIRE(mirror->GetDirection(pulse, d));
    CHECK(d[0] == Approx(std::sin(phi)).margin(3e-15));
    CHECK(d[2] == Approx(std::cos(phi)).margin(3e-15));
  }
}

TEST_CASE("ConicMirror: angles are clamped, never NaN", "[ConicMirror]")
{
  vtkNew<vtkHeliosConicMirror> mirror;
  mirror->SetScanAngle(200.0);
  CHECK(mirror->GetScanAngle() == 180.0);
  const vtkMTimeType before = mirror->GetMTime();
  mirror->SetScanAngle(180.0);
  CHECK(mirror->GetMTime() == before); // unchanged
  mirror->SetScanAngle(std::numeric_limits<double>::quiet_NaN());
  CHECK(mirror->GetScanAngle() == 0.0);
  CHECK(mirror->GetMTime() > before);
  double d[3];
  REQUIRE(mirror->GetDirection(9007199254740991LL, d));
  CHECK(d[0] == 0.0);
  CHECK(d[1] == 1.0);
  CHECK(d[2] == 0.0);
}
