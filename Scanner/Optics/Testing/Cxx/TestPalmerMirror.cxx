// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosExactPhase.h"
#include "vtkHeliosPalmerMirror.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double Root2 = 1.41421356237309504880;

/// The wobble [deg], and the semi-axes over the height.
constexpr double Egg[4][3] = { { 1.0, 0.034920769492, 0.024688950945 },
  { 5.0, 0.176326980708, 0.124203912511 }, { 7.5, 0.267949192431, 0.187819542138 },
  { 10.0, 0.363970234266, 0.253333322866 } };

/// The hit of a pulse on flat ground at y = 1.
void Hit(vtkHeliosPalmerMirror* mirror, vtkIdType pulse, double& x, double& z)
{
  double d[3];
  REQUIRE(mirror->GetDirection(pulse, d));
  x = d[0] / d[1];
  z = d[2] / d[1];
}

/// Checks the mirror's normal, which bisects the directions to the laser and of the pulse.
void CheckNormal(const double d[3], double wobble, double phi)
{
  double n[3] = { d[0] + 1.0, d[1], d[2] }; // the laser shines along -x
  REQUIRE(vtkMath::Norm(d) == Approx(1.0).epsilon(1e-15));
  vtkMath::Normalize(n);
  const double b = vtkMath::RadiansFromDegrees(wobble);
  const double shaft = (n[0] + n[1]) / Root2;
  const double along = (n[0] - n[1]) / Root2;
  REQUIRE(shaft == Approx(std::cos(b)).margin(2e-15));
  REQUIRE(along == Approx(std::sin(b) * std::sin(phi)).margin(2e-15));
  REQUIRE(n[2] == Approx(std::sin(b) * std::cos(phi)).margin(2e-15));
}

} // namespace

TEST_CASE("PalmerMirror: spacing along the axis in closed form", "[PalmerMirror]")
{
  vtkNew<vtkHeliosPalmerMirror> mirror;
  mirror->SetPulseFrequency(200.0); // four pulses per revolution
  for (const auto& egg : Egg)
  {
    mirror->SetWobbleAngle(egg[0]);
    double x;
    double z;
    Hit(mirror, 1, x, z);
    CHECK(x == Approx(egg[1]).epsilon(1e-9));
    CHECK(x == Approx(std::tan(vtkMath::RadiansFromDegrees(2.0 * egg[0]))).epsilon(1e-14));
    CHECK(z == Approx(0.0).margin(1e-16));
    Hit(mirror, 3, x, z);
    CHECK(x == Approx(-egg[1]).epsilon(1e-9));
  }
}

TEST_CASE("PalmerMirror: spacing across the axis in closed form", "[PalmerMirror]")
{
  vtkNew<vtkHeliosPalmerMirror> mirror;
  mirror->SetPulseFrequency(5e8); // 1e7 pulses per revolution
  for (const auto& egg : Egg)
  {
    mirror->SetWobbleAngle(egg[0]);
    const double t = std::tan(vtkMath::RadiansFromDegrees(egg[0]));
    const auto widest = static_cast<vtkIdType>(std::asin(t) / (2.0 * Pi) * 1e7);
    double x;
    double z;
    Hit(mirror, widest, x, z);
    CHECK(z == Approx(egg[2]).epsilon(1e-9));
    CHECK(x == Approx(t * t / (1.0 - t * t)).epsilon(1e-4)); // an ellipse is widest at 0
    for (vtkIdType i = 0; i < 10000000; i += 9973)
    {
      double other;
      Hit(mirror, i, x, other);
      REQUIRE(std::abs(other) <= z * (1.0 + 1e-12));
      REQUIRE(std::abs(x) <= egg[1] * (1.0 + 1e-9));
    }
  }
}

TEST_CASE("PalmerMirror: the pattern is not an ellipse", "[PalmerMirror]")
{
  // The least-squares fit of A x^2 + B x z + C z^2 + D x + E z = 1 has residuals up to 3.5e-2.
  vtkNew<vtkHeliosPalmerMirror> mirror;
  mirror->SetPulseFrequency(50.0 * 3600.0);
  std::vector<std::array<double, 5>> rows;
  double normal[5][6] = {};
  for (vtkIdType i = 0; i < 3600; ++i)
  {
    double x;
    double z;
    Hit(mirror, i, x, z);
    rows.push_back({ x * x, x * z, z * z, x, z });
    for (std::size_t j = 0; j < 5; ++j)
    {
      for (std::size_t k = 0; k < 5; ++k)
      {
        normal[j][k] += rows.back()[j] * rows.back()[k];
      }
      normal[j][5] += rows.back()[j];
    }
  }
  double* lines[5];
  double fit[5];
  for (int j = 0; j < 5; ++j)
  {
    lines[j] = normal[j];
    fit[j] = normal[j][5];
  }
  REQUIRE(vtkMath::SolveLinearSystem(lines, fit, 5));
  double largest = 0.0;
  for (const auto& row : rows)
  {
    const double value = std::inner_product(row.begin(), row.end(), fit, 0.0);
    largest = std::max(largest, std::abs(value - 1.0));
  }
  CHECK(largest == Approx(3.5e-2).epsilon(0.01));
}

TEST_CASE("PalmerMirror: the mirror is tilted by the wobble and rotates evenly", "[PalmerMirror]")
{
  vtkNew<vtkHeliosPalmerMirror> mirror;
  mirror->SetPulseFrequency(100000.0);
  mirror->SetScanFrequency(50.0);
  for (const double wobble : { 1e-6, 1.0, 7.5, 44.0 })
  {
    mirror->SetWobbleAngle(wobble);
    for (vtkIdType i = 0; i < 2000; ++i)
    {
      double d[3];
      REQUIRE(mirror->GetDirection(i, d));
      CheckNormal(d, wobble, 2.0 * Pi * static_cast<double>(i) / 2000.0);
    }
  }
}

TEST_CASE("PalmerMirror: no drift after a day", "[PalmerMirror]")
{
  vtkNew<vtkHeliosPalmerMirror> mirror;
  mirror->SetPulseFrequency(1e6);
  mirror->SetScanFrequency(99.7);
  for (const vtkIdType pulse : { 86400000000LL, 86399999999LL, 77777777777LL })
  {
    double d[3];
    REQUIRE(mirror->GetDirection(pulse, d));
    CheckNormal(d, 7.5, 2.0 * Pi * helios::ExactPhase(pulse, 99.7, 1000000));
  }
}

TEST_CASE("PalmerMirror: a mirror perpendicular to its shaft, and other limits", "[PalmerMirror]")
{
  vtkNew<vtkHeliosPalmerMirror> mirror;
  double d[3];
  for (const double wobble : { 0.0, -5.0, std::numeric_limits<double>::quiet_NaN() })
  {
    mirror->SetWobbleAngle(wobble);
    CHECK(mirror->GetWobbleAngle() == 0.0);
    REQUIRE(mirror->GetDirection(123, d));
    CHECK(d[0] == 0.0);
    CHECK(d[1] == 1.0);
    CHECK(d[2] == 0.0);
  }
  mirror->SetWobbleAngle(90.0);
  CHECK(mirror->GetWobbleAngle() == 45.0);
  for (const double frequency : { 0.0, 1e6, std::numeric_limits<double>::quiet_NaN() })
  {
    mirror->SetScanFrequency(frequency);
    REQUIRE(mirror->GetDirection(86400000000LL, d));
    CHECK(vtkMath::Norm(d) == Approx(1.0).epsilon(1e-15));
  }
}
