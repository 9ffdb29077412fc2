// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTextFormat.h"

#include "heliosRandom.h"

#include <catch2/catch.hpp>

#include <cstring>
#include <limits>
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

/// Compares with std::to_chars, which rounds correctly, except for signed zero. Counts differences.
class Comparison
{
public:
  void Try(double value)
  {
    this->TryWith<1>(value);
    this->TryWith<4>(value);
    this->TryWith<9>(value);
  }

  /// Tests a value and its neighbours, of both signs.
  void TryAround(double value)
  {
    for (const double v : { value, -value })
    {
      this->Try(v);
      this->Try(std::nextafter(v, -1e300));
      this->Try(std::nextafter(v, 1e300));
    }
  }

  long NumberOfTries = 0;
  long NumberOfDifferences = 0;
  double Different = 0.0; // last difference

private:
  template <int Decimals>
  void TryWith(double value)
  {
    char buffer[400];
    const char* end =
      std::to_chars(buffer, buffer + 400, value, std::chars_format::fixed, Decimals).ptr;
    std::string_view expected(buffer, static_cast<std::size_t>(end - buffer));
    if (expected[0] == '-' && expected.find_first_not_of("-0.") == std::string_view::npos)
    {
      expected.remove_prefix(1);
    }
    this->Text.Cut(0);
    this->Text.AppendFixed<Decimals>(value);
    ++this->NumberOfTries;
    if (std::string_view(this->Text.GetText(), this->Text.GetSize()) != expected)
    {
      ++this->NumberOfDifferences;
      this->Different = value;
    }
  }

  helios::TextBuffer Text;
};

void CheckSame(const Comparison& comparison)
{
  INFO("differs: " << comparison.Different << " of " << comparison.NumberOfTries << " tries");
  CHECK(comparison.NumberOfTries > 0);
  CHECK(comparison.NumberOfDifferences == 0);
}

auto Uniform(std::uint64_t i)
{
  return helios::Uniform4(3, helios::RandomStream::Scene, i, 0);
}

} // namespace

TEST_CASE("TextBuffer: fixed decimals", "[TextFormat]")
{
  CHECK(Fixed<4>(0.0) == "0.0000");
  CHECK(Fixed<4>(-0.0) == "0.0000");
  CHECK(Fixed<4>(-0.00004) == "0.0000");
  CHECK(Fixed<4>(-0.00006) == "-0.0001");
  CHECK(Fixed<4>(-12.00006) == "-12.0001");
  CHECK(Fixed<4>(5500000.654321) == "5500000.6543");
  CHECK(Fixed<9>(12.5) == "12.500000000");
  CHECK(Fixed<9>(604799.123456789) == "604799.123456789");
  CHECK(Fixed<4>(0.99996) == "1.0000");
  CHECK(Fixed<4>(-9.99996) == "-10.0000");
  CHECK(Fixed<4>(0.00390625) == "0.0039");
  CHECK(Fixed<4>(0.03125) == "0.0312"); // a tie: to even
  CHECK(Fixed<4>(0.09375) == "0.0938");
  CHECK(Fixed<4>(9007199254740991) == "9007199254740991.0000");
  CHECK(Fixed<4>(1e22) == "10000000000000000000000.0000");
}

TEST_CASE("TextBuffer: reports whether all numbers were finite", "[TextFormat]")
{
  helios::TextBuffer text;
  text.AppendFixed<4>(-std::numeric_limits<double>::max());
  CHECK(text.GetSize() == 1 + 309 + 1 + 4);
  CHECK(text.IsFinite());
  for (const double bad :
    { std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() })
  {
    text.Cut(3);
    CHECK(text.IsFinite());
    text.AppendFixed<9>(bad);
    text.AppendFixed<9>(1.0);
    CHECK_FALSE(text.IsFinite());
  }
}

TEST_CASE("TextBuffer: integers up to their limits", "[TextFormat]")
{
  helios::TextBuffer text;
  text.AppendInteger(std::numeric_limits<std::int64_t>::min());
  text.Append(' ');
  text.AppendInteger(std::numeric_limits<std::int64_t>::max());
  text.Append(std::string_view(" end"));
  CHECK(
    std::string(text.GetText(), text.GetSize()) == "-9223372036854775808 9223372036854775807 end");
}

TEST_CASE("TextBuffer: rounds all magnitudes as std::to_chars", "[TextFormat]")
{
  Comparison comparison;
  for (std::uint64_t i = 0; i < 400000; ++i)
  {
    const auto u = Uniform(i);
    comparison.Try((2 * u[0] - 1) * std::pow(10.0, 24 * u[1] - 12));
    comparison.Try(u[2] * 1e6);
  }
  CheckSame(comparison);
}

TEST_CASE("TextBuffer: rounds random bits as std::to_chars", "[TextFormat]")
{
  Comparison comparison;
  for (std::uint64_t i = 0; i < 100000; ++i)
  {
    const auto u = Uniform(i);
    const std::uint64_t bits =
      (static_cast<std::uint64_t>(u[0] * 0x1p32) << 32) | static_cast<std::uint64_t>(u[1] * 0x1p32);
    double value;
    std::memcpy(&value, &bits, sizeof(value));
    if (std::isfinite(value))
    {
      comparison.Try(value);
    }
  }
  CheckSame(comparison);
}

TEST_CASE("TextBuffer: rounds close to halves as std::to_chars", "[TextFormat]")
{
  Comparison comparison;
  for (std::uint64_t i = 0; i < 60000; ++i)
  {
    const auto u = Uniform(i);
    const double whole = std::floor(std::pow(10.0, 8 * u[2]));
    // the closest double to a half of the last decimal
    comparison.TryAround(whole + (std::floor(1e4 * u[0]) + 0.5) / 1e4);
    comparison.TryAround((std::floor(1e9 * u[1]) + 0.5) / 1e9);
    // halves exactly representable in double: multiples of 2^-(decimals + 1)
    comparison.TryAround(whole + std::floor(32 * u[0]) / 32);
    comparison.TryAround(whole + std::floor(1024 * u[1]) / 1024);
  }
  CheckSame(comparison);
}

TEST_CASE("TextBuffer: rounds at the limits as std::to_chars", "[TextFormat]")
{
  Comparison comparison;
  for (int exponent = -1074; exponent <= 1023; ++exponent)
  {
    comparison.TryAround(std::ldexp(1.0, exponent));
    comparison.TryAround(std::ldexp(1.5, exponent));
  }
  for (int exponent = -15; exponent <= 22; ++exponent)
  {
    comparison.TryAround(std::pow(10.0, exponent));
    comparison.TryAround(std::pow(10.0, exponent) - std::pow(10.0, exponent - 10));
    comparison.TryAround(0.5 * std::pow(10.0, exponent));
  }
  CheckSame(comparison);
}
