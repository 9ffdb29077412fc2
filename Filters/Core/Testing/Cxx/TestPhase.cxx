// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPhase.h"

#include <catch2/catch.hpp>

namespace
{

/// frac(i f / r) in integer arithmetic, for whole frequencies.
double ExactPhase(std::int64_t i, std::int64_t frequency, std::int64_t rate)
{
  const auto product = static_cast<__int128>(i) * frequency;
  return static_cast<double>(static_cast<std::int64_t>(product % rate)) / static_cast<double>(rate);
}

} // namespace

TEST_CASE("Phase: exact after a day at 1 MHz", "[Phase]")
{
  for (const std::int64_t i :
    { 0LL, 1LL, 999999LL, 86399999999LL, 86400000001LL, 4503599627370495LL })
  {
    CHECK(helios::Phase(i, 120, 1000000) == Approx(ExactPhase(i, 120, 1000000)).margin(1e-15));
    CHECK(helios::Phase(i, 997, 550000) == Approx(ExactPhase(i, 997, 550000)).margin(1e-15));
  }
}

TEST_CASE("Phase: fractional line rates keep their rate", "[Phase]")
{
  // 99.7 Hz at 200 kHz: 997 turns in 2,000,000 pulses.
  CHECK(helios::Phase(2000000, 99.7, 200000) == Approx(0.0).margin(3e-13));
  CHECK(helios::Phase(1000000, 99.7, 200000) == Approx(0.5).margin(2e-13));
}

TEST_CASE("Phase: stays in [0, 1)", "[Phase]")
{
  for (std::int64_t i = 0; i < 100000; ++i)
  {
    const double phase = helios::Phase(i, 0.1, 0.3);
    REQUIRE(phase >= 0.0);
    REQUIRE(phase < 1.0);
  }
}

TEST_CASE("PulseTime: a day of pulses does not drift", "[Phase]")
{
  CHECK(helios::PulseTime(0.0, 86400000000LL, 1e6) == 86400.0);
}
