// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRandom.h"

#include <catch2/catch.hpp>

#include <cmath>

using helios::NormalPair;
using helios::RandomStream;

TEST_CASE("NormalPair: a pure function of its key", "[Random]")
{
  const auto a = NormalPair(7, RandomStream::RangeNoise, 123456789, 1);
  CHECK(a == NormalPair(7, RandomStream::RangeNoise, 123456789, 1));
  CHECK(a != NormalPair(8, RandomStream::RangeNoise, 123456789, 1));
  CHECK(a != NormalPair(7, RandomStream::Scene, 123456789, 1));
  CHECK(a != NormalPair(7, RandomStream::RangeNoise, 123456790, 1));
  CHECK(a != NormalPair(7, RandomStream::RangeNoise, 123456789, 2));
}

TEST_CASE("NormalPair: mean 0, variance 1, kurtosis 3, uncorrelated", "[Random]")
{
  constexpr int n = 200000;
  double sum = 0, sum2 = 0, sum4 = 0, cross = 0, lag = 0, last = 0;
  for (int i = 0; i < n; ++i)
  {
    const auto x = NormalPair(0, RandomStream::RangeNoise, i, 0);
    sum += x[0] + x[1];
    sum2 += x[0] * x[0] + x[1] * x[1];
    sum4 += std::pow(x[0], 4) + std::pow(x[1], 4);
    cross += x[0] * x[1];
    lag += x[0] * last;
    last = x[0];
  }
  // five standard errors of each estimate
  CHECK(std::abs(sum / (2 * n)) < 5 / std::sqrt(2.0 * n));
  CHECK(std::abs(sum2 / (2 * n) - 1) < 5 * std::sqrt(2 / (2.0 * n)));
  CHECK(std::abs(sum4 / (2 * n) - 3) < 5 * std::sqrt(96 / (2.0 * n)));
  CHECK(std::abs(cross / n) < 5 / std::sqrt(1.0 * n));
  CHECK(std::abs(lag / n) < 5 / std::sqrt(1.0 * n));
}

TEST_CASE("Uniform4: inside (0, 1)", "[Random]")
{
  for (int i = 0; i < 10000; ++i)
  {
    for (const double u : helios::Uniform4(1, RandomStream::Scene, i, 0))
    {
      REQUIRE(u > 0.0);
      REQUIRE(u < 1.0);
    }
  }
}
