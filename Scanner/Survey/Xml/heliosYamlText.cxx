// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosYamlText.h"

#include "heliosXmlRules.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstring>
#include <set>
#include <sstream>

namespace helios
{

namespace
{

/// Returns the length of a character that YAML does not show, or takes for the end of a line; 0: none.
std::size_t FindHidden(const std::string& text, std::size_t at)
{
  const auto byte = [&](std::size_t i)
  { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : 0U; };
  const bool isControl = byte(0) == 0xC2 && byte(1) >= 0x80 && byte(1) < 0xA0;
  const bool isEnd = byte(0) == 0xE2 && byte(1) == 0x80 && (byte(2) == 0xA8 || byte(2) == 0xA9);
  const bool isMark = byte(0) == 0xEF &&
    ((byte(1) == 0xBB && byte(2) == 0xBF) || (byte(1) == 0xBF && byte(2) >= 0xBE));
  return byte(0) < ' ' || byte(0) == 0x7F ? 1 : isControl ? 2 : isEnd || isMark ? 3 : 0;
}

} // namespace

//------------------------------------------------------------------------------
bool IsPlainYaml(const std::string& text, bool isNumber)
{
  static const std::set<std::string> words = { "y", "n", "yes", "no", "on", "off", "true", "false",
    "null" };
  const auto isGood = [](unsigned char c)
  { return std::isalnum(c) || std::strchr(" _-./+#:()=;@%^*", c); };
  const auto first = static_cast<unsigned char>(text.empty() ? ' ' : text.front());
  return (std::isalpha(first) || first == '/' ||
           (isNumber && (std::isdigit(first) || (std::strchr("+-.", first) && text.size() > 1)))) &&
    std::all_of(text.begin(), text.end(), isGood) && text.back() != ' ' && text.back() != ':' &&
    text.find(" #") == std::string::npos && text.find(": ") == std::string::npos &&
    (isNumber || !words.count(ToLower(text)));
}

//------------------------------------------------------------------------------
std::string EscapeYaml(const std::string& text, const char* others)
{
  std::string escaped;
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    const std::size_t length = FindHidden(text, i);
    if (length == 0)
    {
      escaped += std::strchr(others, text[i]) ? std::string("\\") + text[i] : text.substr(i, 1);
      continue;
    }
    unsigned code =
      static_cast<unsigned char>(text[i]) & (length == 1 ? 0x7F : 0x1F >> (length - 2));
    for (std::size_t k = 1; k < length; ++k)
    {
      code = code << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3F);
    }
    char shown[16];
    std::snprintf(shown, sizeof(shown), "\\u%04X", code);
    escaped += shown;
    i += length - 1;
  }
  return escaped;
}

//------------------------------------------------------------------------------
std::string QuoteYaml(const std::string& text)
{
  return "\"" + EscapeYaml(text, "\"\\") + "\"";
}

//------------------------------------------------------------------------------
std::vector<std::string> SplitYamlComment(const std::string& text)
{
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
  {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    !lines.empty() || !line.empty() ? lines.push_back(line) : void();
  }
  while (!lines.empty() && lines.back().empty())
  {
    lines.pop_back();
  }
  const auto dedent = [&lines](std::size_t from, std::size_t to)
  {
    std::size_t indent = std::string::npos;
    for (std::size_t i = from; i < to; ++i)
    {
      indent = lines[i].empty() ? indent : std::min(indent, lines[i].find_first_not_of(" \t"));
    }
    for (std::size_t i = from; i < to; ++i)
    {
      lines[i].erase(0, indent);
    }
  };
  const bool isBeside = text.find_first_not_of(" \t\r") != text.find('\n');
  const std::size_t first = isBeside ? std::min<std::size_t>(1, lines.size()) : 0;
  dedent(0, first);
  dedent(first, lines.size());
  return lines;
}

} // namespace helios
