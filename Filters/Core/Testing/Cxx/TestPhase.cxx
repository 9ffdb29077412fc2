// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPhase.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace
{

/// frac(i f / r) in integer arithmetic, for integer frequencies.
double ExactPhase(std::int64_t i, std::int64_t frequency, std::int64_t rate)
{
  const auto product = static_cast<__int128>(i) * frequency;
  const auto rest = static_cast<std::int64_t>((product % rate + rate) % rate);
  return static_cast<double>(rest) / static_cast<double>(rate);
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

TEST_CASE("Phase: is at least 0 and below 1", "[Phase]")
{
  for (std::int64_t i = 0; i < 100000; ++i)
  {
    const double phase = helios::Phase(i, 0.1, 0.3);
    REQUIRE(phase >= 0.0);
    REQUIRE(phase < 1.0);
  }
}

TEST_CASE("Phase: a negative frequency reverses the rotation", "[Phase]")
{
  for (const std::int64_t i : { 0LL, 1LL, 999999LL, 86399999999LL, 4503599627370495LL })
  {
    CHECK(helios::Phase(i, -7294, 6000000) == Approx(ExactPhase(i, -7294, 6000000)).margin(1e-15));
  }
  CHECK(helios::Phase(1, -1e-30, 1.0) == 0.0); // 1 - 1e-30 has no double below 1
}

TEST_CASE("Phase: phase at a time", "[Phase]")
{
  // 86400.001 s is stored as 86400 + m 2^-36; 997 Hz times that, in integers.
  const double time = 86400.001;
  const auto scaled = static_cast<__int128>(std::ldexp(time, 36)) * 997;
  const auto rest = static_cast<std::int64_t>(scaled % (std::int64_t(1) << 36));
  CHECK(helios::Phase(time, 997.0) == Approx(std::ldexp(double(rest), -36)).margin(1e-15));
  CHECK(helios::Phase(time, -997.0) == Approx(1.0 - std::ldexp(double(rest), -36)).margin(1e-15));
  CHECK(helios::Phase(0.0, 997.0) == 0.0);
  CHECK(helios::Phase(0.25, 3.0) == 0.75);
}

TEST_CASE("PulseTime: a day of pulses does not drift", "[Phase]")
{
  CHECK(helios::PulseTime(0.0, 86400000000LL, 1e6) == 86400.0);
}
