// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Fresnel's equations and Snell's law against closed forms.
#include "heliosFresnel.h"

#include <vtkMath.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace helios;

namespace
{

constexpr double Tiny = 1e-14;

double Cosine(double degrees)
{
  return std::cos(vtkMath::RadiansFromDegrees(degrees));
}

} // namespace

TEST_CASE("Fresnel: normal incidence")
{
  const double n = GENERATE(1.0, 1.33, 1.5, 4.0);
  const double expected = std::pow((n - 1.0) / (n + 1.0), 2);
  for (const auto& shares :
    { GetFresnelReflectance(1.0, 1.0, n), GetFresnelReflectance(1.0, n, 1.0) })
  {
    CHECK(shares.S == Approx(expected).margin(Tiny));
    CHECK(shares.P == Approx(expected).margin(Tiny));
  }
}

TEST_CASE("Fresnel: at Brewster's angle no light of one polarisation is reflected")
{
  const double n = GENERATE(1.33, 1.5, 2.4);
  const double angle = std::atan(n);
  const PolarisedShares shares = GetFresnelReflectance(std::cos(angle), 1.0, n);
  CHECK(shares.P == Approx(0.0).margin(1e-30));
  // sin^2(a - b) with a + b = 90 degrees
  CHECK(shares.S == Approx(std::pow(std::cos(2.0 * angle), 2)).margin(Tiny));
}

TEST_CASE("Fresnel: the tangent and sine forms hold at any angle")
{
  const double degrees = GENERATE(1.0, 30.0, 45.0, 60.0, 85.0, 89.999);
  const double a = vtkMath::RadiansFromDegrees(degrees);
  const double b = std::asin(std::sin(a) / 1.5);
  const PolarisedShares shares = GetFresnelReflectance(std::cos(a), 1.0, 1.5);
  CHECK(shares.S == Approx(std::pow(std::sin(a - b) / std::sin(a + b), 2)).epsilon(1e-10));
  CHECK(shares.P == Approx(std::pow(std::tan(a - b) / std::tan(a + b), 2)).epsilon(1e-10));
  // backwards with the same result
  const PolarisedShares back = GetFresnelReflectance(std::cos(b), 1.5, 1.0);
  CHECK(back.GetMean() == Approx(shares.GetMean()).epsilon(1e-10));
}

TEST_CASE("Fresnel: everything is reflected at grazing incidence and beyond the critical angle")
{
  CHECK(GetFresnelReflectance(0.0, 1.0, 1.5).GetMean() == 1.0);
  const double critical = vtkMath::DegreesFromRadians(std::asin(1.0 / 1.33));
  CHECK(GetFresnelReflectance(Cosine(critical + 1e-6), 1.33, 1.0).GetMean() == 1.0);
  CHECK(GetFresnelReflectance(Cosine(critical - 1e-3), 1.33, 1.0).GetMean() < 1.0);
}

TEST_CASE("Fresnel: a pane is the sum of all reflections between its faces")
{
  const double degrees = GENERATE(0.0, 40.0, 70.0, 89.0);
  const double crossing = GENERATE(1.0, 0.8, 0.0);
  const PolarisedShares face = GetFresnelReflectance(Cosine(degrees), 1.0, 1.52);
  double through = 0.0;
  double back = 0.0;
  for (const double r : { face.S, face.P })
  {
    back += 0.5 * r;
    double inside = 0.5 * (1.0 - r);
    for (int i = 0; i < 20000; ++i)
    {
      inside *= crossing;
      (i % 2 == 0 ? through : back) += (1.0 - r) * inside;
      inside *= r;
    }
  }
  const PaneShares pane = GetPaneShares(Cosine(degrees), 1.52, crossing);
  CHECK(pane.Transmitted == Approx(through).margin(1e-12));
  CHECK(pane.Reflected == Approx(back).margin(1e-12));
  CHECK(pane.Transmitted + pane.Reflected <= 1.0 + Tiny);
  if (crossing == 1.0)
  {
    CHECK(pane.Transmitted + pane.Reflected == Approx(1.0).margin(1e-12));
  }
}

TEST_CASE("Fresnel: directions obey the laws of reflection and refraction")
{
  const double degrees = GENERATE(0.0, 10.0, 55.0, 80.0);
  const double a = vtkMath::RadiansFromDegrees(degrees);
  const Vec3 normal(0.0, 0.0, 1.0);
  const Vec3 down(std::sin(a), 0.0, -std::cos(a));
  const Vec3 mirrored = GetMirrored(down, normal);
  CHECK(mirrored[0] == Approx(std::sin(a)).margin(Tiny));
  CHECK(mirrored[2] == Approx(std::cos(a)).margin(Tiny));
  const Vec3 within =
    GetRefracted(down, normal, 1.0, 1.33, GetRefractedCosine(std::cos(a), 1.0, 1.33));
  CHECK(within[0] == Approx(std::sin(a) / 1.33).margin(Tiny));
  CHECK(within[1] == 0.0);
  CHECK(within.Norm() == Approx(1.0).margin(Tiny));
}

TEST_CASE("Fresnel: no energy is gained")
{
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  double largest = 0.0;
  double smallest = 1.0;
  for (int i = 0; i < 1000000; ++i)
  {
    const double cosine = std::pow(unit(random), 3); // many near grazing
    const double n = 1.0 + 3.0 * unit(random);
    const bool isInside = unit(random) < 0.5;
    const double reflected =
      GetFresnelReflectance(cosine, isInside ? n : 1.0, isInside ? 1.0 : n).GetMean();
    const PaneShares pane = GetPaneShares(cosine, n, unit(random));
    largest = std::max({ largest, reflected, pane.Reflected + pane.Transmitted });
    smallest = std::min({ smallest, reflected, pane.Reflected, pane.Transmitted });
  }
  CHECK(largest <= 1.0 + Tiny);
  CHECK(smallest >= 0.0);
}
