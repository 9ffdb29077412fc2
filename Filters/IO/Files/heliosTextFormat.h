// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Fast, correctly rounded formatting of numbers.

#ifndef heliosTextFormat_h
#define heliosTextFormat_h

#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace helios
{

constexpr std::uint32_t PowerOfTen(int exponent)
{
  return exponent == 0 ? 1 : 10 * PowerOfTen(exponent - 1);
}

/// "00" to "99".
struct DigitPairs
{
  char Text[200] = {};

  constexpr DigitPairs()
  {
    for (int i = 0; i < 100; ++i)
    {
      this->Text[2 * i] = static_cast<char>('0' + i / 10);
      this->Text[2 * i + 1] = static_cast<char>('0' + i % 10);
    }
  }
};
inline constexpr DigitPairs Digits;

/// A growing text buffer for records of numbers.
class VTKHELIOSFILTERSIO_EXPORT TextBuffer
{
public:
  const char* GetText() const { return this->Text.data(); }
  std::size_t GetSize() const { return this->Size; }

  /// Returns false after a NaN or infinite number was appended; Cut() resets it.
  bool IsFinite() const { return this->Finite; }

  /// Truncates to an earlier size.
  void Cut(std::size_t size)
  {
    this->Size = size;
    this->Finite = true;
  }

  void Append(char c)
  {
    *this->Reserve(1) = c;
    ++this->Size;
  }

  void Append(std::string_view text)
  {
    std::memcpy(this->Reserve(text.size()), text.data(), text.size());
    this->Size += text.size();
  }

  void AppendInteger(std::int64_t value)
  {
    char* at = this->Reserve(24);
    this->Size += static_cast<std::size_t>(std::to_chars(at, at + 24, value).ptr - at);
  }

  /// Appends a number with 1 to 9 decimals, rounded like std::to_chars; zero has no sign.
  template <int Decimals>
  void AppendFixed(double value)
  {
    static_assert(Decimals >= 1 && Decimals <= 9, "the decimals fit into 30 bits");
    constexpr std::uint32_t scale = PowerOfTen(Decimals);
    const double magnitude = std::abs(value);
    if (!(magnitude < 0x1p53))
    {
      this->AppendHuge(value, Decimals);
      return;
    }
    auto whole = static_cast<std::int64_t>(magnitude);
    std::uint32_t fraction = RoundScaled(magnitude - static_cast<double>(whole), scale);
    if (fraction == scale)
    {
      fraction = 0;
      ++whole;
    }
    char* const begin = this->Reserve(28 + Decimals);
    char* at = begin;
    if (value < 0.0 && (whole != 0 || fraction != 0))
    {
      *at++ = '-';
    }
    at = std::to_chars(at, at + 20, whole).ptr;
    *at++ = '.';
    WriteDigits<Decimals>(at, fraction);
    this->Size += static_cast<std::size_t>(at + Decimals - begin);
  }

private:
  /**
   * Returns scale x rounded to nearest, ties to even, for x in [0, 1). The product p is below 2^30,
   * so a half is an integer multiple of its ulp: p is on the same side of a half as the exact
   * product, unless p is exactly a half; then the rounding error of p decides.
   */
  static std::uint32_t RoundScaled(double x, std::uint32_t scale)
  {
    const double p = x * scale;
    const auto floor = static_cast<std::uint32_t>(p);
    const double rest = p - floor;
    if (rest != 0.5)
    {
      return floor + (rest > 0.5 ? 1 : 0);
    }
    const double error = std::fma(x, scale, -p);
    return floor + (error > 0.0 || (error == 0.0 && floor % 2 == 1) ? 1 : 0);
  }

  template <int Count>
  static void WriteDigits(char* at, std::uint32_t value)
  {
    for (int i = Count - 2; i >= 0; i -= 2)
    {
      std::memcpy(at + i, Digits.Text + 2 * (value % 100), 2);
      value /= 100;
    }
    if (Count % 2 == 1)
    {
      *at = static_cast<char>('0' + value);
    }
  }

  void AppendHuge(double value, int decimals);

  char* Reserve(std::size_t count)
  {
    if (this->Size + count > this->Text.size())
    {
      this->Text.resize(2 * (this->Size + count));
    }
    return this->Text.data() + this->Size;
  }

  std::vector<char> Text;
  std::size_t Size = 0;
  bool Finite = true;
};

} // namespace helios

#endif
