// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSingleMaximum.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

using helios::SingleMaximum;

namespace
{

using Terms = std::vector<std::pair<double, double>>; // places and powers

bool Find(SingleMaximum& sum, const Terms& terms, double sigma, SingleMaximum::Result& result)
{
  sum.Open(terms.size());
  for (const auto& [place, power] : terms)
  {
    sum.Add(99.0, 1.0, false);
    sum.Add(place, power);
  }
  return sum.Find(sigma, result);
}

} // namespace

TEST_CASE("SingleMaximum: the maximum of one Gaussian", "[SingleMaximum]")
{
  SingleMaximum sum;
  SingleMaximum::Result peak;
  REQUIRE(Find(sum, { { -0.3, 5.0 } }, 0.25, peak));
  CHECK(peak.Place == Approx(-0.3).epsilon(1e-15));
  CHECK(peak.Value == Approx(5.0).epsilon(1e-15));
  CHECK(peak.Variance == Approx(0.0).margin(1e-15));
}

TEST_CASE("SingleMaximum: two equal ones have their maximum in the middle, up to two sigma apart",
  "[SingleMaximum]")
{
  SingleMaximum sum;
  SingleMaximum::Result peak;
  for (const double apart : { 1e-9, 0.01, 0.5, 1.0, 1.9, 1.999 })
  {
    REQUIRE(Find(sum, { { 0.0, 2.0 }, { 3.0 * apart, 2.0 } }, 3.0, peak));
    CHECK(peak.Place == Approx(1.5 * apart).epsilon(1e-9));
    CHECK(peak.Value == Approx(4.0 * std::exp(-apart * apart / 8)).epsilon(2e-14));
    CHECK(peak.Variance == Approx(2.25 * apart * apart).epsilon(1e-9));
  }
}

TEST_CASE(
  "SingleMaximum: the slope is zero at the maximum, for any number of terms", "[SingleMaximum]")
{
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> place(-1.0, 1.0), power(0.0, 1.0);
  SingleMaximum sum;
  SingleMaximum::Result peak;
  for (std::size_t count = 2; count < 60; ++count) // also less than the one before, reused
  {
    Terms terms(count % 7 == 0 ? 2 : count);
    for (auto& term : terms)
    {
      term = { place(random), power(random) };
    }
    REQUIRE(Find(sum, terms, 1.0, peak));
    double value = 0.0, slope = 0.0;
    for (const auto& [x, p] : terms)
    {
      const double u = peak.Place - x;
      value += p * std::exp(-0.5 * u * u);
      slope += p * u * std::exp(-0.5 * u * u);
    }
    CHECK(std::abs(slope) < 1e-9 * value);
    CHECK(peak.Value == Approx(value).epsilon(2e-14));
  }
}

TEST_CASE("SingleMaximum: no terms have no maximum", "[SingleMaximum]")
{
  SingleMaximum sum;
  SingleMaximum::Result peak;
  CHECK_FALSE(Find(sum, { { 0.0, 0.0 }, { 1.0, 0.0 } }, 1.0, peak));
  REQUIRE(Find(sum, { { 0.0, 0.0 }, { 1.0, 2.0 } }, 1.0, peak));
  CHECK(peak.Place == Approx(1.0).epsilon(1e-12));
}
