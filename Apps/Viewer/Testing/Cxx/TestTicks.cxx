// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTicks.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace helios::viewer;

namespace
{

std::vector<std::string> GetTexts(const Ticks& ticks)
{
  std::vector<std::string> texts;
  for (const Tick& tick : ticks.List)
  {
    texts.push_back(tick.Text);
  }
  return texts;
}

using Texts = std::vector<std::string>;

} // namespace

TEST_CASE("Ticks: multiples of 1, 2 or 5 with equal decimals")
{
  CHECK(GetTexts(MakeTicks(0.0, 3.0, 6, "m")) == Texts{ "0", "1", "2", "3" });
  CHECK(GetTexts(MakeTicks(-0.0051, 0.0062, 6, "m")) ==
    Texts{ "-0.004", "-0.002", "0.000", "0.002", "0.004", "0.006" });
  CHECK(GetTexts(MakeTicks(101.3, 148.9, 6, "m")) == Texts{ "110", "120", "130", "140" });
  CHECK(GetTexts(MakeTicks(1.4e9, 1.4e9 + 0.5, 3, "s")) ==
    Texts{ "1400000000.0", "1400000000.2", "1400000000.4" });
  CHECK(MakeTicks(0.0, 3.0, 6, "m").Unit == "m");
}

TEST_CASE("Ticks: powers have an SI prefix")
{
  const Ticks ticks = MakeTicks(0.0, 1.215e-5, 6, "W");
  CHECK(ticks.Unit == "\xC2\xB5W");
  CHECK(GetTexts(ticks) == Texts{ "0", "5", "10" });
  CHECK(ticks.List[1].Value == Approx(5e-6));
  CHECK(MakeTicks(0.0, 3e5, 5, "Hz").Unit == "kHz");
}

TEST_CASE("Ticks: never more than asked for, none outside the range")
{
  for (int i = 0; i < 2000; ++i)
  {
    const double low = std::tan(0.37 * i) * std::pow(10.0, i % 13 - 6);
    const double high = low + (1.0 + i % 97) * std::pow(10.0, (7 * i) % 13 - 6);
    const int most = 2 + i % 8;
    const Ticks ticks = MakeTicks(low, high, most, "m");
    CAPTURE(low, high, most);
    CHECK(int(ticks.List.size()) <= most);
    for (std::size_t k = 0; k < ticks.List.size(); ++k)
    {
      const Tick& tick = ticks.List[k];
      CHECK(tick.Value >= low - 1e-5 * (high - low));
      CHECK(tick.Value <= high + 1e-5 * (high - low));
      CHECK(tick.Text != "-0");
      CHECK((k == 0 || tick.Text != ticks.List[k - 1].Text));
    }
  }
}

TEST_CASE("Ticks: empty and infinite ranges have none")
{
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(MakeTicks(2.0, 2.0, 6, "m").List.empty());
  CHECK(MakeTicks(3.0, 2.0, 6, "m").List.empty());
  CHECK(MakeTicks(0.0, infinity, 6, "m").List.empty());
  CHECK(MakeTicks(std::nan(""), 1.0, 6, "m").List.empty());
}

TEST_CASE("Ticks: logarithmic ranges have decades, with their units")
{
  CHECK(GetTexts(MakeLogTicks(2e-9, 3e-5, 6, "W")) ==
    Texts{ "10 nW", "100 nW", "1 \xC2\xB5W", "10 \xC2\xB5W" });
  CHECK(GetTexts(MakeLogTicks(0.9, 21.0, 6, "")) == Texts{ "1", "2", "5", "10", "20" });
  CHECK(GetTexts(MakeLogTicks(1e-12, 1.0, 5, "W")).size() <= 6);
  CHECK(GetTexts(MakeLogTicks(2e-6, 5e-6, 4, "W")) ==
    Texts{ "2 \xC2\xB5W", "3 \xC2\xB5W", "4 \xC2\xB5W", "5 \xC2\xB5W" });
}

TEST_CASE("Ticks: values in a suitable unit")
{
  CHECK(DescribeValue(2.5, "W") == "2.5 W");
  CHECK(DescribeValue(1.234e-8, "W") == "12.3 nW");
  CHECK(DescribeValue(5e-7, "W") == "500 nW");
  CHECK(DescribeValue(2e-6, "W") == "2 \xC2\xB5W");
  CHECK(DescribeValue(9.999e-7, "W") == "1 \xC2\xB5W");
  CHECK(DescribeValue(0.0, "W") == "0 W");
  CHECK(DescribeValue(12345.0, "") == "12345");
}

TEST_CASE("Ticks: round lengths")
{
  CHECK(RoundDown(7.3) == 5.0);
  CHECK(RoundDown(0.2) == Approx(0.2));
  CHECK(RoundDown(1999.0) == 1000.0);
  CHECK(DescribeLength(2000.0) == "2 km");
  CHECK(DescribeLength(20.0) == "20 m");
  CHECK(DescribeLength(0.5) == "50 cm");
  CHECK(DescribeLength(0.002) == "2 mm");
}
