// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text, fast and correctly rounded.

#ifndef heliosTextFormat_h
#define heliosTextFormat_h

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

namespace helios
{

constexpr std::int64_t PowerOfTen(int exponent)
{
  return exponent == 0 ? 1 : 10 * PowerOfTen(exponent - 1);
}

/// Text that grows; rows of numbers are appended to it.
class TextBuffer
{
public:
  const char* GetText() const { return this->Text.data(); }
  std::size_t GetSize() const { return this->Size; }
  void Clear() { this->Size = 0; }

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

  /**
   * A number with a fixed number of decimals, as std::to_chars rounds it; zero has no sign. The
   * fast way scales to an integer: the product is off by at most 2^-7 below 2^46, so its rounding
   * is right unless its fraction is close to a half, and then std::to_chars decides.
   */
  template <int Decimals>
  void AppendFixed(double value)
  {
    constexpr std::int64_t scale = PowerOfTen(Decimals);
    const double scaled = std::abs(value) * static_cast<double>(scale);
    if (!(scaled < 0x1p46))
    {
      this->AppendSlowly(value, Decimals);
      return;
    }
    const auto whole = static_cast<std::int64_t>(scaled);
    const double rest = scaled - static_cast<double>(whole);
    if (std::abs(rest - 0.5) < 0x1p-6)
    {
      this->AppendSlowly(value, Decimals);
      return;
    }
    const std::int64_t digits = whole + (rest > 0.5 ? 1 : 0);
    char* at = this->Reserve(24 + Decimals);
    char* const begin = at;
    if (value < 0.0 && digits != 0)
    {
      *at++ = '-';
    }
    at = std::to_chars(at, at + 20, digits / scale).ptr;
    *at++ = '.';
    std::int64_t fraction = digits % scale;
    for (int i = Decimals - 1; i >= 0; --i)
    {
      at[i] = static_cast<char>('0' + fraction % 10);
      fraction /= 10;
    }
    this->Size += static_cast<std::size_t>(at + Decimals - begin);
  }

private:
  void AppendSlowly(double value, int decimals)
  {
    constexpr std::size_t longest = std::numeric_limits<double>::max_exponent10 + 32;
    char* at = this->Reserve(longest);
    const char* end =
      std::to_chars(at, at + longest, value, std::chars_format::fixed, decimals).ptr;
    std::string_view text(at, static_cast<std::size_t>(end - at));
    if (text[0] == '-' && text.find_first_not_of("-0.") == std::string_view::npos)
    {
      std::memmove(at, at + 1, text.size() - 1);
      text.remove_suffix(1);
    }
    this->Size += text.size();
  }

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
};

} // namespace helios

#endif
