// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Expected values and tables: w is the radius of the beam at 1/e^2, K the truncation, weights are
// fractions of the energy in the cone.
#include "vtkHeliosBeamSampler.h"

#include "heliosErrorObserver.h"

#include <catch2/catch.hpp>
#include <vtkMath.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace
{

/// The position of a sub-ray across the axis, in units of w.
struct Place
{
  double X;
  double Z;
  double Weight;

  double GetRadius() const { return std::hypot(this->X, this->Z); }
};

std::vector<Place> GetPlaces(vtkHeliosBeamSampler* sampler)
{
  const double w = 0.5 * sampler->GetBeamDivergence();
  std::vector<Place> places;
  for (int k = 0; k < sampler->GetNumberOfSubRays(); ++k)
  {
    double d[3];
    sampler->GetDirection(k, d);
    const double across = std::hypot(d[0], d[2]);
    const double scale = across > 0.0 ? std::atan2(across, d[1]) / (across * w) : 0.0;
    places.push_back({ scale * d[0], scale * d[2], sampler->GetWeight(k) });
  }
  return places;
}

/// The energy-weighted mean of the squared angle, over w^2.
double MeanSquare(vtkHeliosBeamSampler* sampler)
{
  long double sum = 0.0L;
  for (const Place& place : GetPlaces(sampler))
  {
    sum += place.Weight * place.GetRadius() * place.GetRadius();
  }
  return static_cast<double>(sum);
}

/// Its exact value: (1/2 - e (K^2 + 1/2)) / (1 - e), e = exp(-2 K^2).
double MeanSquareTruth(double k)
{
  const double e = std::exp(-2.0 * k * k);
  return (0.5 - e * (k * k + 0.5)) / (1.0 - e);
}

double SumOfWeights(vtkHeliosBeamSampler* sampler)
{
  double sum = 0.0;
  for (int k = 0; k < sampler->GetNumberOfSubRays(); ++k)
  {
    sum += sampler->GetWeight(k);
  }
  return sum;
}

/// Mean less R and standard deviation of the ranges of a plane at R = 100, inclined by 75 degrees.
struct PlaneRanges
{
  double Mean;
  double Deviation;
};

PlaneRanges GetPlaneRanges(vtkHeliosBeamSampler* sampler)
{
  const double slope = std::tan(vtkMath::RadiansFromDegrees(75.0));
  long double sum = 0.0L, sum2 = 0.0L, weights = 0.0L;
  for (int k = 0; k < sampler->GetNumberOfSubRays(); ++k)
  {
    double d[3];
    sampler->GetDirection(k, d);
    const long double r = 100.0L / (d[1] - slope * static_cast<long double>(d[2])) - 100.0L;
    weights += sampler->GetWeight(k);
    sum += sampler->GetWeight(k) * r;
    sum2 += sampler->GetWeight(k) * r * r;
  }
  sum /= weights;
  sum2 /= weights;
  return { static_cast<double>(sum), static_cast<double>(std::sqrt(sum2 - sum * sum)) };
}

/// The energy beyond a half-plane at s: 1 / (pi E) int exp(-2 (s / cos a)^2) - exp(-2 K^2) da.
double EdgeTruth(double s, double k)
{
  const double end = std::acos(s / k);
  const int steps = 400; // intervals of Simpson's rule
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i)
  {
    const double r = s / std::cos(end * i / steps);
    const double weight = i == 0 || i == steps ? 1.0 : i % 2 == 0 ? 2.0 : 4.0;
    sum += weight * (std::exp(-2.0 * r * r) - std::exp(-2.0 * k * k));
  }
  return sum * end / (3 * steps) / (-std::expm1(-2.0 * k * k) * vtkMath::Pi());
}

/// The root mean square error of the energy beyond half-planes, randomly offset and rotated.
double EdgeError(vtkHeliosBeamSampler* sampler)
{
  const double k = sampler->GetTruncation();
  const std::vector<Place> places = GetPlaces(sampler);
  std::mt19937 random(1);
  double sum2 = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const double turn = 2.0 * vtkMath::Pi() * random() / 4294967296.0;
    const double offset = k * random() / 4294967296.0;
    double energy = 0.0;
    for (const Place& place : places)
    {
      const double along = place.X * std::cos(turn) + place.Z * std::sin(turn);
      energy += along > offset ? place.Weight : 0.0;
    }
    const double error = energy - EdgeTruth(offset, k);
    sum2 += error * error;
  }
  return std::sqrt(sum2 / 1000.0);
}

/// The largest error of the energy on a disc about the axis.
double DiscError(vtkHeliosBeamSampler* sampler)
{
  const double k = sampler->GetTruncation();
  const std::vector<Place> places = GetPlaces(sampler);
  double largest = 0.0;
  for (double r = 0.0005; r < k; r += 0.001)
  {
    double energy = 0.0;
    for (const Place& place : places)
    {
      energy += place.GetRadius() < r ? place.Weight : 0.0;
    }
    const double truth = std::expm1(-2.0 * r * r) / std::expm1(-2.0 * k * k);
    largest = std::max(largest, std::abs(energy - truth));
  }
  return largest;
}

} // namespace

TEST_CASE("BeamSampler: Gauss-Legendre rings, radii and weights to 15 digits", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  CHECK(sampler->GetPattern() == vtkHeliosBeamSampler::GAUSS_LEGENDRE);
  CHECK(sampler->GetNumberOfSubRays() == 16);
  sampler->SetNumberOfRings(4);
  CHECK(sampler->GetNumberOfSubRays() == 64);
  const double weights[4] = { 0.173927422568727, 0.326072577431273, 0.326072577431273,
    0.173927422568727 };
  const double radii[2][4] = { { 0.175944481781921, 0.409852986560349, 0.657980276943373,
                                 0.903564406010911 },
    { 0.188588751696703, 0.444429296670167, 0.736997562374046, 1.124414018384274 } };
  for (const int row : { 0, 1 })
  {
    sampler->SetTruncation(row == 0 ? 1.0 : 1.5);
    const std::vector<Place> places = GetPlaces(sampler);
    for (std::size_t i = 0; i < 64; ++i)
    {
      CHECK(places[i].GetRadius() == Approx(radii[row][i / 16]).epsilon(1e-14));
      CHECK(places[i].Weight == Approx(weights[i / 16] / 16).epsilon(1e-14));
    }
  }
}

TEST_CASE("BeamSampler: 4 q azimuths per ring, odd rings rotated by half a step", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetNumberOfRings(3);
  const std::vector<Place> places = GetPlaces(sampler);
  for (std::size_t ring = 0; ring < 3; ++ring)
  {
    std::vector<double> steps;
    for (std::size_t i = 12 * ring; i < 12 * (ring + 1); ++i)
    {
      const double step = std::atan2(places[i].X, places[i].Z) * 12.0 / (2.0 * vtkMath::Pi());
      steps.push_back(step < -1e-9 ? step + 12.0 : step);
    }
    std::sort(steps.begin(), steps.end());
    for (std::size_t i = 0; i < 12; ++i)
    {
      CHECK(steps[i] == Approx(i + (ring == 1 ? 0.5 : 0.0)).margin(1e-12));
    }
  }
}

TEST_CASE("BeamSampler: the sub-rays of the paper", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetPatternToCircles();
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
  sampler->SetPatternToCircles();
  sampler->SetBeamDivergence(0.001);
  double axis[3];
  sampler->GetDirection(0, axis);
  CHECK(axis[0] == 0.0);
  CHECK(axis[1] == 1.0);
  CHECK(axis[2] == 0.0);
  std::vector<Place> places = GetPlaces(sampler);
  for (std::size_t i = 1; i < 19; ++i)
  {
    CHECK(places[i].GetRadius() == Approx(1.5 / 2.5 * (i < 7 ? 1 : 2)).epsilon(1e-12));
  }
  sampler->LegacyWeightsOn(); // at i K w / q
  places = GetPlaces(sampler);
  for (std::size_t i = 1; i < 19; ++i)
  {
    CHECK(places[i].GetRadius() == Approx(1.5 / 3 * (i < 7 ? 1 : 2)).epsilon(1e-12));
  }
}

TEST_CASE("BeamSampler: weights are the exact energy of their circle", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetPatternToCircles();
  sampler->SetTruncation(1.0);
  const double whole = 1.0 - std::exp(-2.0);
  CHECK(whole == Approx(0.864664716763).epsilon(1e-12));
  CHECK(sampler->GetWeight(0) == Approx((1.0 - std::exp(-0.08)) / whole).epsilon(1e-14));
  CHECK(sampler->GetWeight(6) ==
    Approx((std::exp(-0.08) - std::exp(-0.72)) / whole / 6.0).epsilon(1e-14));
  CHECK(sampler->GetWeight(18) ==
    Approx((std::exp(-0.72) - std::exp(-2.0)) / whole / 12.0).epsilon(1e-14));
}

TEST_CASE("BeamSampler: weights sum to exactly 1, in any order", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  std::mt19937 random(7);
  const auto check = [&sampler, &random]
  {
    std::vector<Place> places = GetPlaces(sampler);
    INFO(sampler->GetPatternAsString()
      << " of " << places.size() << ", K " << sampler->GetTruncation());
    REQUIRE(SumOfWeights(sampler) == 1.0);
    std::shuffle(places.begin(), places.end(), random);
    double sum = 0.0;
    for (const Place& place : places)
    {
      REQUIRE(place.Weight > 0.0);
      REQUIRE(place.Weight <= 1.0);
      sum += place.Weight;
    }
    REQUIRE(sum == 1.0);
  };
  for (const double truncation : { 0.1, 1.0, 1.5, 3.0 })
  {
    sampler->SetTruncation(truncation);
    for (int q = 1; q <= 64; q += q < 20 ? 1 : 11)
    {
      sampler->SetPatternToCircles();
      sampler->SetNumberOfCircles(q);
      check();
      sampler->SetPatternToGaussLegendre();
      sampler->SetNumberOfRings(q);
      check();
      sampler->SetPatternToVogel();
      sampler->SetNumberOfSubRays(q * q);
      check();
    }
  }
}

TEST_CASE("BeamSampler: the weights of the paper are of first order, exact energies of second",
  "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetPatternToCircles();
  sampler->SetTruncation(1.0);
  const auto energyError = [&sampler](int circles)
  {
    sampler->SetNumberOfCircles(circles);
    return SumOfWeights(sampler) - 1.0;
  };
  SECTION("the paper: C / M too much energy")
  {
    sampler->LegacyWeightsOn();
    CHECK(2 * energyError(2) == Approx(1.066).margin(5e-4));
    CHECK(3 * energyError(3) == Approx(0.922).margin(5e-4));
    CHECK(5 * energyError(5) == Approx(0.776).margin(5e-4));
    CHECK(10 * energyError(10) == Approx(0.701).margin(5e-4));
    CHECK(50 * energyError(50) == Approx(0.634).margin(5e-4));
    CHECK(energyError(64) / energyError(32) == Approx(0.5).margin(0.01));
    const double e = std::exp(-2.0);
    const double c = 1 + 0.5 / vtkMath::Pi() - 2 * e / (1 - e) -
      std::sqrt(vtkMath::Pi() / 8) * std::erf(std::sqrt(2)) / (vtkMath::Pi() * (1 - e));
    CHECK(c == Approx(0.625924).margin(5e-7));
    CHECK(64 * energyError(64) == Approx(c).epsilon(0.015));
  }
  SECTION("exact energies: the second moment")
  {
    CHECK(MeanSquareTruth(1.0) == Approx(0.3434823572503343).epsilon(1e-14));
    const auto error = [&sampler](int circles)
    {
      sampler->SetNumberOfCircles(circles);
      return 1.0 - MeanSquare(sampler) / MeanSquareTruth(1.0);
    };
    CHECK(error(3) == Approx(7.65e-3).epsilon(0.005));
    CHECK(error(20) == Approx(1.60e-4).epsilon(0.005));
    CHECK(error(50) == Approx(2.5e-5).epsilon(0.025));
    CHECK(error(40) / error(20) == Approx(0.25).margin(0.01));
  }
}

TEST_CASE(
  "BeamSampler: the second moment of Gauss-Legendre converges exponentially", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  CHECK(MeanSquareTruth(1.5) == Approx(0.4747239664194075).epsilon(1e-14));
  for (const double k : { 1.0, 1.5 })
  {
    // The integrand -ln(1 - p E) / 2 is analytic except for p >= 1 / E: the error is O(rho^(-2 q)).
    const double x = -2.0 / std::expm1(-2.0 * k * k) - 1.0;
    const double rho = x + std::sqrt(x * x - 1.0);
    sampler->SetTruncation(k);
    for (const int q : { 2, 4, 8, 16, 32, 64 })
    {
      sampler->SetNumberOfRings(q);
      const double error = std::abs(MeanSquare(sampler) / MeanSquareTruth(k) - 1.0);
      INFO("q " << q << ", K " << k << ", error " << error);
      CHECK(error < std::pow(rho, -2 * q) + 1e-13);
    }
  }
}

TEST_CASE("BeamSampler: the echo width of a plane inclined by 75 degrees", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetBeamDivergence(1e-3);
  const auto error = [&sampler](double k)
  {
    sampler->SetTruncation(k);
    // R tan(theta) w / 2 of the whole beam; its square times 2 E[r^2] / w^2 of the cone
    const double truth = 9.330162055e-2 * std::sqrt(2.0 * MeanSquareTruth(k));
    return std::abs(GetPlaneRanges(sampler).Deviation / truth - 1.0);
  };
  SECTION("Gauss-Legendre")
  {
    const std::array<double, 3> rings{ 2, 4, 5 };
    const std::array<double, 3> bound{ 1e-2, 1e-3, 1e-4 };
    for (std::size_t i = 0; i < 3; ++i)
    {
      sampler->SetNumberOfRings(static_cast<int>(rings[i]));
      CHECK(error(1.0) < bound[i]);
    }
    const std::array<double, 3> rings15{ 4, 8, 12 };
    for (std::size_t i = 0; i < 3; ++i)
    {
      sampler->SetNumberOfRings(static_cast<int>(rings15[i]));
      CHECK(error(1.5) < bound[i]);
    }
  }
  SECTION("Vogel")
  {
    sampler->SetPatternToVogel();
    const std::array<double, 3> size{ 16, 68, 200 };
    const std::array<double, 3> size15{ 48, 200, 580 };
    const std::array<double, 3> bound{ 1e-2, 1e-3, 1e-4 };
    for (std::size_t i = 0; i < 3; ++i)
    {
      sampler->SetNumberOfSubRays(static_cast<int>(size[i]));
      CHECK(error(1.0) < bound[i]);
      sampler->SetNumberOfSubRays(static_cast<int>(size15[i]));
      CHECK(error(1.5) < bound[i]);
    }
  }
  SECTION("not reached by the weights of the paper")
  {
    sampler->SetPatternToCircles();
    sampler->LegacyWeightsOn();
    sampler->SetNumberOfCircles(5);
    CHECK(error(1.0) > 1e-2);
  }
  SECTION("mean and deviation to the end")
  {
    sampler->SetNumberOfRings(64);
    CHECK(error(1.5) < 1e-5);
    CHECK(GetPlaneRanges(sampler).Mean ==
      Approx(9.330152357e-5 * 2.0 * MeanSquareTruth(1.5)).epsilon(1e-5));
  }
}

TEST_CASE("BeamSampler: the energy beyond an edge", "[BeamSampler]")
{
  const double truth[2][4] = { { 0.41253860634451, 0.28915030337815, 0.12694075362597,
                                 0.033318177653278 },
    { 0.42006787315304, 0.30693343504042, 0.15592773783746, 0.063638861707145 } };
  const double offsets[4] = { 0.1, 0.25, 0.5, 0.75 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    CHECK(EdgeTruth(offsets[i], 1.0) == Approx(truth[0][i]).epsilon(1e-8));
    CHECK(EdgeTruth(offsets[i], 1.5) == Approx(truth[1][i]).epsilon(1e-8));
  }
  vtkNew<vtkHeliosBeamSampler> sampler;
  SECTION("Gauss-Legendre")
  {
    sampler->SetTruncation(1.0);
    sampler->SetNumberOfRings(5);
    CHECK(EdgeError(sampler) < 1e-2);
    sampler->SetNumberOfRings(25);
    CHECK(EdgeError(sampler) < 1e-3);
  }
  SECTION("Vogel, order 3/4")
  {
    sampler->SetPatternToVogel();
    for (const double k : { 1.0, 1.5 })
    {
      sampler->SetTruncation(k);
      sampler->SetNumberOfSubRays(200);
      CHECK(EdgeError(sampler) < 1e-2);
      sampler->SetNumberOfSubRays(2416);
      const double error = EdgeError(sampler);
      CHECK(error < 1e-3);
      sampler->SetNumberOfSubRays(16 * 2416);
      CHECK(EdgeError(sampler) < 0.25 * error);
    }
  }
  SECTION("circles")
  {
    sampler->SetPatternToCircles();
    sampler->SetTruncation(1.0);
    sampler->SetNumberOfCircles(8);
    CHECK(EdgeError(sampler) < 1e-2);
  }
}

TEST_CASE("BeamSampler: Vogel's spiral is the best for a disc about the axis", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetPatternToVogel();
  sampler->SetNumberOfSubRays(1000);
  CHECK(DiscError(sampler) < 2.0 / 1000.0 * 1.01);
  sampler->SetPatternToGaussLegendre();
  sampler->SetNumberOfRings(16);
  CHECK(DiscError(sampler) > 0.02);
}

TEST_CASE("BeamSampler: all patterns are isotropic", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetBeamDivergence(0.01);
  const auto check = [&sampler](bool quarters)
  {
    double mean[2] = { 0.0, 0.0 };
    double right = 0.0;
    double up = 0.0;
    for (const Place& place : GetPlaces(sampler))
    {
      mean[0] += place.Weight * place.X;
      mean[1] += place.Weight * place.Z;
      right += std::abs(place.X) < 1e-14 ? 0.0 : std::copysign(place.Weight, place.X);
      up += std::abs(place.Z) < 1e-14 ? 0.0 : std::copysign(place.Weight, place.Z);
    }
    INFO(sampler->GetPatternAsString() << " of " << sampler->GetNumberOfSubRays());
    CHECK(mean[0] == Approx(0.0).margin(5e-15));
    CHECK(mean[1] == Approx(0.0).margin(5e-15));
    CHECK(right == Approx(0.0).margin(1e-14)); // the half-planes x > 0 and x < 0 have equal energy
    if (quarters)
    {
      CHECK(up == Approx(0.0).margin(1e-14)); // z > 0 and z < 0 have equal weight
    }
  };
  for (const int q : { 2, 3, 4, 5, 8 })
  {
    sampler->SetPatternToCircles();
    sampler->SetNumberOfCircles(q);
    check(q <= 4); // circles of 6, 12, 18
    sampler->SetPatternToGaussLegendre();
    sampler->SetNumberOfRings(q);
    check(true);
    sampler->SetPatternToVogel();
    sampler->SetNumberOfSubRays(61 * q);
    check(true);
  }
}

TEST_CASE("BeamSampler: Vogel's spiral has a multiple of four sub-rays", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetPatternToVogel();
  CHECK(sampler->GetNumberOfSubRays() == 64);
  const int asked[6] = { -3, 2, 4, 61, 65536, 100000 };
  const int given[6] = { 1, 4, 4, 64, 65536, 65536 };
  for (int i = 0; i < 6; ++i)
  {
    sampler->SetNumberOfSubRays(asked[i]);
    CHECK(sampler->GetNumberOfSubRays() == given[i]);
  }
}

TEST_CASE("BeamSampler: unit vectors also for wide beams", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetBeamDivergence(1.0);
  sampler->SetTruncation(3.0);
  sampler->SetNumberOfCircles(20);
  sampler->SetNumberOfRings(20);
  for (const int pattern : { 0, 1, 2 })
  {
    sampler->SetPattern(pattern);
    for (int i = 0; i < sampler->GetNumberOfSubRays(); ++i)
    {
      double d[3];
      sampler->GetDirection(i, d);
      REQUIRE(vtkMath::Norm(d) == Approx(1.0).epsilon(4e-16));
      REQUIRE(d[1] > 0.0);
    }
  }
}

TEST_CASE("BeamSampler: no divergence, one circle or one sub-ray: the axis", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetBeamQualityFactor(1.0);
  sampler->SetPattern(GENERATE(0, 1, 2));
  SECTION("no divergence")
  {
    sampler->SetBeamDivergence(0.0);
  }
  SECTION("one circle")
  {
    sampler->SetPatternToCircles();
    sampler->SetNumberOfCircles(1);
  }
  SECTION("one circle of the paper")
  {
    sampler->SetPatternToCircles();
    sampler->LegacyWeightsOn();
    sampler->SetNumberOfCircles(1);
  }
  SECTION("one sub-ray")
  {
    sampler->SetPatternToVogel();
    sampler->SetNumberOfSubRays(1);
  }
  CHECK(sampler->GetNumberOfSubRays() == 1);
  CHECK(sampler->GetWeight(0) == 1.0);
  double d[3];
  sampler->GetDirection(0, d);
  CHECK(d[0] == 0.0);
  CHECK(d[1] == 1.0);
  CHECK(d[2] == 0.0);
  sampler->GetOffset(0, d);
  CHECK(vtkMath::Norm(d) == 0.0);
}

TEST_CASE("BeamSampler: the waist of a beam", "[BeamSampler]")
{
  struct Row
  {
    double Wavelength; // nm
    double Angle;      // mrad, unit of w
    double Distance;   // m
    double Radius;     // m
    double Digits;
  };
  // w(R) = sqrt(w0^2 + (w R)^2), w0 = M2 lambda / (pi w)
  const Row rows[] = { { 1064, 0.25, 0, 1.354727e-3, 5e-10 },
    { 1064, 0.25, 10, 0.002843464, 5e-10 }, { 1064, 0.25, 100, 0.025036679, 5e-10 },
    { 1064, 0.25, 1000, 0.250003671, 5e-10 }, { 1550, 0.15, 0, 3.289202e-3, 5e-10 },
    { 1550, 0.15, 10, 0.003615087, 5e-10 }, { 1550, 0.15, 100, 0.015356394, 5e-10 },
    { 532, 0.5, 1, 0.000603908, 5e-10 }, { 532, 0.5, 10, 0.005011457, 5e-10 } };
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetBeamQualityFactor(1.0);
  for (const Row& row : rows)
  {
    sampler->SetWavelength(row.Wavelength);
    sampler->SetBeamDivergence(2e-3 * row.Angle);
    const double radius = sampler->GetFootprintRadius(row.Distance);
    CHECK(radius == Approx(row.Radius).epsilon(0).margin(row.Digits));
    for (const int pattern : { 0, 1, 2 })
    {
      sampler->SetPattern(pattern);
      for (int k = 0; k < sampler->GetNumberOfSubRays(); ++k)
      {
        double p[3], d[3];
        sampler->GetOffset(k, p);
        sampler->GetDirection(k, d);
        REQUIRE(p[1] == 0.0);
        REQUIRE(vtkMath::Norm(d) == Approx(1.0).epsilon(1e-15));
        REQUIRE(vtkMath::Dot(p, d) == Approx(0.0).margin(1e-20)); // the rulings are tangents
        const double t = row.Distance / d[1];
        const double rho = std::hypot(d[0], d[2]) / d[1] / (1e-3 * row.Angle);
        const double hit = std::hypot(p[0] + t * d[0], p[2] + t * d[2]);
        REQUIRE(hit == Approx(rho * radius).epsilon(1e-12));
      }
    }
  }
  SECTION("grows with M2")
  {
    const double ideal = sampler->GetFootprintRadius(0.0);
    sampler->SetBeamQualityFactor(1.7);
    CHECK(sampler->GetFootprintRadius(0.0) == Approx(1.7 * ideal).epsilon(1e-14));
  }
  SECTION("keeps the weights")
  {
    CHECK(SumOfWeights(sampler) == 1.0);
  }
  SECTION("no waist without BeamQualityFactor")
  {
    sampler->SetBeamQualityFactor(0.0);
    CHECK(sampler->GetFootprintRadius(0.0) == 0.0);
    for (int k = 0; k < sampler->GetNumberOfSubRays(); ++k)
    {
      double p[3];
      sampler->GetOffset(k, p);
      CHECK(vtkMath::Norm(p) == 0.0);
    }
  }
}

TEST_CASE("BeamSampler: independent of earlier settings", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> straight;
  straight->SetPatternToVogel();
  straight->SetNumberOfSubRays(100);
  straight->SetBeamQualityFactor(1.2);
  vtkNew<vtkHeliosBeamSampler> detour;
  detour->SetBeamQualityFactor(1.2);
  detour->SetNumberOfSubRays(3000);
  detour->SetPatternToVogel();
  detour->SetBeamDivergence(0.2);
  detour->SetBeamDivergence(straight->GetBeamDivergence());
  detour->SetNumberOfSubRays(100);
  REQUIRE(detour->GetNumberOfSubRays() == 100);
  for (int k = 0; k < 100; ++k)
  {
    double a[6], b[6];
    straight->GetDirection(k, a);
    detour->GetDirection(k, b);
    straight->GetOffset(k, a + 3);
    detour->GetOffset(k, b + 3);
    CHECK(std::equal(a, a + 6, b));
    CHECK(straight->GetWeight(k) == detour->GetWeight(k));
  }
}

TEST_CASE("BeamSampler: invalid values are refused", "[BeamSampler]")
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(sampler);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  sampler->SetBeamDivergence(-0.001);
  CHECK(log->HasError("BeamDivergence is -0.001; it must be in [0, 1] rad; 0 is one ideal ray"));
  sampler->SetBeamDivergence(nan);
  CHECK(log->HasError("BeamDivergence is nan"));
  CHECK(sampler->GetBeamDivergence() == 0.0003);
  sampler->SetBeamQualityFactor(0.5);
  CHECK(log->HasError(
    "BeamQualityFactor is 0.5; it must be in [1, 10000], or 0 for a beam without a waist"));
  CHECK(sampler->GetBeamQualityFactor() == 0.0);
  sampler->SetWavelength(0.0);
  CHECK(log->HasError("Wavelength is 0; it must be in [1, 1000000] nm"));
  CHECK(sampler->GetWavelength() == 1064.0);
  for (const double ratio : { 0.0099, 1.01, nan })
  {
    sampler->SetDivergenceRatio(ratio);
    CHECK(log->HasError("; it must be in [0.01, 1]; 1 is a circular beam"));
    log->Clear();
  }
  CHECK(sampler->GetDivergenceRatio() == 1.0);
  sampler->SetMajorAxisAngle(361.0);
  CHECK(log->HasError(
    "MajorAxisAngle is 361; it must be in [-360, 360] deg; 0 is across the scan lines"));
  CHECK(sampler->GetMajorAxisAngle() == 0.0);
}

TEST_CASE("BeamSampler: an elliptical beam is narrowed along z, waist and slope", "[BeamSampler]")
{
  const double factor = GENERATE(0.0, 1.5);
  vtkNew<vtkHeliosBeamSampler> circular;
  vtkNew<vtkHeliosBeamSampler> elliptical;
  for (vtkHeliosBeamSampler* sampler : { circular.Get(), elliptical.Get() })
  {
    sampler->SetBeamDivergence(0.0016);
    sampler->SetBeamQualityFactor(factor);
    sampler->SetNumberOfRings(20);
  }
  elliptical->SetDivergenceRatio(0.3125);
  elliptical->SetMajorAxisAngle(30.0); // for scanners only
  CHECK(elliptical->GetFootprintRadius(20.0) == circular->GetFootprintRadius(20.0));
  double square[2] = { 0.0, 0.0 }; // along x and z
  for (int k = 0; k < circular->GetNumberOfSubRays(); ++k)
  {
    double p[3], d[3], q[3], e[3];
    circular->GetOffset(k, p);
    circular->GetDirection(k, d);
    elliptical->GetOffset(k, q);
    elliptical->GetDirection(k, e);
    REQUIRE(elliptical->GetWeight(k) == circular->GetWeight(k));
    REQUIRE(vtkMath::Norm(e) == Approx(1.0).epsilon(1e-15));
    for (const double y : { 0.0, 20.0, 300.0 })
    {
      REQUIRE(q[0] + y * e[0] / e[1] == Approx(p[0] + y * d[0] / d[1]).epsilon(1e-13));
      REQUIRE(q[2] + y * e[2] / e[1] == Approx(0.3125 * (p[2] + y * d[2] / d[1])).epsilon(1e-13));
    }
    square[0] += elliptical->GetWeight(k) * std::pow(e[0] / e[1], 2);
    square[1] += elliptical->GetWeight(k) * std::pow(e[2] / e[1], 2);
  }
  // w^2 / 4 of a whole Gaussian, and 0.9494 of it up to 1.5 w (TestPlaneEcho), of 1.6 and 0.5 mrad.
  const double share = 2.0 * 0.4747239664194075;
  CHECK(square[0] == Approx(share * 0.25 * 0.8e-3 * 0.8e-3).epsilon(1e-5));
  CHECK(square[1] == Approx(share * 0.25 * 0.25e-3 * 0.25e-3).epsilon(1e-5));
}

TEST_CASE("BeamSampler: sizes of patterns and their numbers of sub-rays", "[BeamSampler]")
{
  using Sampler = vtkHeliosBeamSampler;
  vtkNew<Sampler> sampler;
  for (const int size : { 1, 2, 3, 9, 18, 64 })
  {
    sampler->SetNumberOfRings(size);
    sampler->SetNumberOfCircles(size);
    sampler->SetNumberOfSubRays(size);
    for (int pattern = 0; Sampler::GetPatternName(pattern); ++pattern)
    {
      INFO(Sampler::GetPatternName(pattern) << " " << size);
      sampler->SetPattern(pattern);
      CHECK(std::string(sampler->GetPatternAsString()) == Sampler::GetPatternName(pattern));
      const int count = sampler->GetNumberOfSubRays();
      CHECK(Sampler::CountSubRays(pattern, size) == count);
      CHECK(Sampler::CountSubRays(pattern, Sampler::FindPatternSize(pattern, count - 1)) <= count);
      CHECK(Sampler::CountSubRays(pattern, Sampler::FindPatternSize(pattern, count)) == count);
    }
  }
  CHECK(Sampler::FindPatternSize(Sampler::CIRCLES, 20) == 4);
  CHECK(Sampler::FindPatternSize(Sampler::CIRCLES, 1000000) == 64);
  CHECK(Sampler::FindPatternSize(Sampler::GAUSS_LEGENDRE, 17) == 3);
  CHECK(Sampler::GetPatternName(3) == nullptr);
  CHECK(Sampler::GetPatternName(-1) == nullptr);
}
