// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTextFormat.h"

#include "heliosRandom.h"

#include <catch2/catch.hpp>

#include <string>

namespace
{

template <int Decimals>
std::string Fixed(double value)
{
  helios::TextBuffer text;
  text.AppendFixed<Decimals>(value);
  return { text.GetText(), text.GetSize() };
}

/// The library's correctly rounded text; zero without a sign.
std::string Reference(double value, int decimals)
{
  char buffer[400];
  std::string text(
    buffer, std::to_chars(buffer, buffer + 400, value, std::chars_format::fixed, decimals).ptr);
  return text[0] == '-' && text.find_first_not_of("-0.") == std::string::npos ? text.substr(1)
                                                                              : text;
}

template <int Decimals>
bool Agrees(double value)
{
  return Fixed<Decimals>(value) == Reference(value, Decimals);
}

} // namespace

TEST_CASE("TextBuffer: fixed decimals", "[TextFormat]")
{
  CHECK(Fixed<4>(0.0) == "0.0000");
  CHECK(Fixed<4>(-0.0) == "0.0000");
  CHECK(Fixed<4>(-0.00004) == "0.0000");
  CHECK(Fixed<4>(-0.00006) == "-0.0001");
  CHECK(Fixed<4>(5500000.654321) == "5500000.6543");
  CHECK(Fixed<9>(12.5) == "12.500000000");
  CHECK(Fixed<4>(0.99996) == "1.0000");
  CHECK(Fixed<4>(1e30) == Reference(1e30, 4));
  CHECK(Fixed<4>(-1e300) == Reference(-1e300, 4));
}

TEST_CASE("TextBuffer: rounds as the library everywhere", "[TextFormat]")
{
  std::size_t wrong = 0;
  for (std::uint64_t i = 0; i < 300000; ++i)
  {
    const auto u = helios::Uniform4(3, helios::RandomStream::Scene, i, 0);
    const double magnitude = std::pow(10.0, 16 * u[1] - 6);
    const double value = (2 * u[0] - 1) * magnitude;
    wrong += Agrees<4>(value) ? 0 : 1;
    wrong += Agrees<9>(value) ? 0 : 1;
    // numbers next to a tie, which rounds to even where it can be held exactly
    const double tie = (std::floor(1e5 * u[2]) + 0.5) / 1e4;
    wrong += Agrees<4>(tie) ? 0 : 1;
    wrong += Agrees<4>(std::nextafter(tie, 0)) ? 0 : 1;
    wrong += Agrees<4>(std::nextafter(tie, 1e9)) ? 0 : 1;
    const double binary = (std::floor(1e6 * u[3]) + 0.5) / 16; // ties in the fourth decimal
    wrong += Agrees<4>(binary) ? 0 : 1;
  }
  CHECK(wrong == 0);
}
