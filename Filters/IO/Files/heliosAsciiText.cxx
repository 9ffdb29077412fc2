// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosAsciiText.h"

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <system_error>

namespace helios
{

namespace
{

void AppendUnit(std::string& text, std::uint32_t unit)
{
  char word[8];
  std::snprintf(word, sizeof(word), "\\u%04x", static_cast<unsigned int>(unit & 0xFFFFU));
  text += word;
}

/// Returns the character of UTF-8 at a position, and its number of bytes; a byte that is not UTF-8
/// is itself.
std::uint32_t DecodeCharacter(const std::string& text, std::size_t at, std::size_t& bytes)
{
  const auto lead = static_cast<unsigned char>(text[at]);
  bytes = lead >= 0xF0 && lead < 0xF5 ? 4 : lead >= 0xE0 ? 3 : lead >= 0xC2 ? 2 : 1;
  std::uint32_t code = bytes == 1 ? lead : lead & (0x7FU >> bytes);
  for (std::size_t k = 1; k < bytes; ++k)
  {
    const auto next = at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : 0U;
    if ((next & 0xC0U) != 0x80U || lead > 0xF4)
    {
      bytes = 1;
      return lead;
    }
    code = code << 6U | (next & 0x3FU);
  }
  return code;
}

void AppendCharacter(std::string& text, std::uint32_t code)
{
  const auto add = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  if (code < 0x80)
  {
    add(code);
  }
  else if (code < 0x800)
  {
    add(0xC0U | code >> 6U);
    add(0x80U | (code & 0x3FU));
  }
  else if (code < 0x10000)
  {
    add(0xE0U | code >> 12U);
    add(0x80U | (code >> 6U & 0x3FU));
    add(0x80U | (code & 0x3FU));
  }
  else
  {
    add(0xF0U | code >> 18U);
    add(0x80U | (code >> 12U & 0x3FU));
    add(0x80U | (code >> 6U & 0x3FU));
    add(0x80U | (code & 0x3FU));
  }
}

/// Parses \u and four digits at a position.
bool ParseUnit(const std::string& text, std::size_t at, std::uint32_t& unit)
{
  if (text.compare(at, 2, "\\u") != 0 || at + 6 > text.size())
  {
    return false;
  }
  const char* end = text.data() + at + 6;
  const auto result = std::from_chars(text.data() + at + 2, end, unit, 16);
  return result.ec == std::errc() && result.ptr == end;
}

} // namespace

std::string EscapeText(const std::string& text)
{
  std::string escaped;
  for (std::size_t at = 0, bytes = 1; at < text.size(); at += bytes)
  {
    const std::uint32_t code = DecodeCharacter(text, at, bytes);
    if (code < 0x80 && code != '\\')
    {
      escaped += text[at];
    }
    else if (code < 0x10000)
    {
      AppendUnit(escaped, code);
    }
    else
    {
      AppendUnit(escaped, 0xD800U + ((code - 0x10000U) >> 10U));
      AppendUnit(escaped, 0xDC00U + ((code - 0x10000U) & 0x3FFU));
    }
  }
  return escaped;
}

std::string UnescapeText(const std::string& text)
{
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at)
  {
    std::uint32_t unit = 0;
    std::uint32_t low = 0;
    if (!ParseUnit(text, at, unit))
    {
      plain += text[at];
      continue;
    }
    at += 5;
    if (unit >= 0xD800U && unit < 0xDC00U && ParseUnit(text, at + 1, low) && low >= 0xDC00U &&
      low < 0xE000U)
    {
      unit = 0x10000U + ((unit - 0xD800U) << 10U) + (low - 0xDC00U);
      at += 6;
    }
    unit = unit >= 0xD800U && unit < 0xE000U ? 0xFFFDU : unit; // half of a pair
    AppendCharacter(plain, unit);
  }
  return plain;
}

} // namespace helios
