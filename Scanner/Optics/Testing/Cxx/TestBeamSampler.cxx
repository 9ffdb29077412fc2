// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBeamSampler.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>

#include <cmath>
#include <limits>

namespace
{

/// The polar angle of a sub-ray from the axis of the beam [rad].
double Polar(vtkHeliosBeamSampler* sampler, int subRay)
{
  double d[3];
  sampler->GetDirection(subRay, d);
  return std::atan2(std::hypot(d[0], d[2]), d[1]);
}

/// The energy-weighted mean of the squared angle, over w^2.
double MeanSquare(vtkHeliosBeamSampler* sampler)
{
  const double w = 0.5 * sampler->GetBeamDivergence();
  long double sum = 0.0L;
  for (int i = 0; i < sampler->GetNumberOfSubRays(); ++i)
  {
    const double r = Polar(sampler, i) / w;
    sum += sampler->GetWeight(i) * r * r;
  }
  return static_cast<double>(sum);
}

} // namespace

TEST_CASE("BeamSampler: the sub-rays of the paper", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  CHECK(sampler->GetNumberOfSubRays() == 19);
  const int expected[8] = { 1, 7, 19, 37, 62, 93, 130, 173 };
  for (int q = 1; q <= 8; ++q)
  {
    sampler->SetNumberOfCircles(q);
    CHECK(sampler->GetNumberOfSubRays() == expected[q - 1]);
  }
}

TEST_CASE("BeamSampler: circles at i K w / (q - 1/2), the axis first", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetBeamDivergence(0.001);
  const double spacing = 1.5 * 0.0005 / 2.5;
  double axis[3];
  sampler->GetDirection(0, axis);
  CHECK(axis[0] == 0.0);
  CHECK(axis[1] == 1.0);
  CHECK(axis[2] == 0.0);
  for (int i = 1; i < 19; ++i)
  {
    CHECK(Polar(sampler, i) == Approx(spacing * (i < 7 ? 1 : 2)).epsilon(1e-12));
  }
}

TEST_CASE("BeamSampler: weights are the exact energy of their circle", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetTruncation(1.0);
  const double whole = 1.0 - std::exp(-2.0);
  CHECK(whole == Approx(0.864664716763).epsilon(1e-12)); // accuracy A2
  CHECK(sampler->GetWeight(0) == Approx((1.0 - std::exp(-0.08)) / whole).epsilon(1e-14));
  CHECK(sampler->GetWeight(6) ==
    Approx((std::exp(-0.08) - std::exp(-0.72)) / whole / 6.0).epsilon(1e-14));
  CHECK(sampler->GetWeight(18) ==
    Approx((std::exp(-0.72) - std::exp(-2.0)) / whole / 12.0).epsilon(1e-14));
}

TEST_CASE("BeamSampler: weights sum to 1 within 4 u, each in (0, 1]", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  for (const double truncation : { 0.1, 1.0, 1.5, 3.0 })
  {
    sampler->SetTruncation(truncation);
    for (int q = 1; q <= 64; ++q)
    {
      sampler->SetNumberOfCircles(q);
      long double sum = 0.0L;
      for (int i = 0; i < sampler->GetNumberOfSubRays(); ++i)
      {
        const double weight = sampler->GetWeight(i);
        REQUIRE(weight > 0.0);
        REQUIRE(weight <= 1.0);
        sum += weight;
      }
      INFO("q " << q << ", K " << truncation);
      REQUIRE(
        std::abs(static_cast<double>(sum - 1.0L)) <= 2.0 * std::numeric_limits<double>::epsilon());
    }
  }
}

TEST_CASE("BeamSampler: the second moment converges by accuracy A2", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetTruncation(1.0);
  const double truth = 0.3434823572503343;
  const int circles[3] = { 3, 20, 50 };
  const double expected[3] = { 7.65e-3, 1.60e-4, 2.5e-5 };
  for (int k = 0; k < 3; ++k)
  {
    sampler->SetNumberOfCircles(circles[k]);
    CHECK(1.0 - MeanSquare(sampler) / truth == Approx(expected[k]).epsilon(0.005));
  }
}

TEST_CASE("BeamSampler: no direction is preferred", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetBeamDivergence(0.01);
  for (const int q : { 2, 3, 4, 5, 8 })
  {
    sampler->SetNumberOfCircles(q);
    double mean[3] = { 0.0, 0.0, 0.0 };
    double right = 0.0;
    double up = 0.0;
    for (int i = 0; i < sampler->GetNumberOfSubRays(); ++i)
    {
      double d[3];
      sampler->GetDirection(i, d);
      const double weight = sampler->GetWeight(i);
      vtkMath::MultiplyScalar(d, weight);
      vtkMath::Add(mean, d, mean);
      right += std::abs(d[0]) < 1e-17 ? 0.0 : std::copysign(weight, d[0]);
      up += std::abs(d[2]) < 1e-17 ? 0.0 : std::copysign(weight, d[2]);
    }
    INFO("q " << q);
    CHECK(mean[0] == Approx(0.0).margin(1e-17));
    CHECK(mean[2] == Approx(0.0).margin(1e-17));
    CHECK(right == Approx(0.0).margin(1e-14)); // the half-planes x > 0 and x < 0 have equal energy
    if (q <= 4)                                // circles of 6, 12, 18: so have z > 0 and z < 0
    {
      CHECK(up == Approx(0.0).margin(1e-14));
    }
  }
}

TEST_CASE("BeamSampler: unit vectors for wide beams too", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetBeamDivergence(1.0);
  sampler->SetTruncation(3.0);
  sampler->SetNumberOfCircles(20);
  for (int i = 0; i < sampler->GetNumberOfSubRays(); ++i)
  {
    double d[3];
    sampler->GetDirection(i, d);
    REQUIRE(vtkMath::Norm(d) == Approx(1.0).epsilon(4e-16));
    REQUIRE(d[1] > 0.0);
  }
}

TEST_CASE("BeamSampler: no divergence, or one circle, is one ray", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  SECTION("no divergence")
  {
    sampler->SetBeamDivergence(0.0);
  }
  SECTION("one circle")
  {
    sampler->SetNumberOfCircles(1);
  }
  CHECK(sampler->GetNumberOfSubRays() == 1);
  CHECK(sampler->GetWeight(0) == 1.0);
  double d[3];
  sampler->GetDirection(0, d);
  CHECK(d[0] == 0.0);
  CHECK(d[1] == 1.0);
  CHECK(d[2] == 0.0);
}
