// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXmlValue.h"

#include "heliosMessages.h"
#include "heliosXmlRules.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace helios
{

namespace
{

/// Parses a number that is the whole text; a sign + is allowed, like in C.
template <typename NumberT>
bool FromText(const std::string& text, NumberT& number)
{
  const char* first = text.data();
  const char* last = first + text.size();
  if (text.size() > 1 && *first == '+' && first[1] != '-')
  {
    ++first;
  }
  const auto result = std::from_chars(first, last, number);
  return result.ec == std::errc() && result.ptr == last;
}

bool FiniteFromText(const std::string& text, double& number)
{
  return FromText(text, number) && std::isfinite(number);
}

std::string Quote(const XmlValue& value)
{
  return value.Where + ": " + value.Name + "=\"" + Shorten(value.Text) + "\"";
}

std::string UnitOf(const XmlValueRule& rule)
{
  return *rule.Unit ? std::string(" [") + rule.Unit + "]" : std::string();
}

/// Returns "give a number above 0 and up to 10 [Hz]".
std::string RangeText(const XmlValueRule& rule)
{
  const XmlRange& range = rule.Range;
  MessageBuilder text;
  text << "give a number ";
  text << (range.AboveLow ? "above " : "from ") << range.Low
       << (range.AboveLow ? " and up to " : " to ") << range.High << UnitOf(rule);
  return text.str();
}

bool CheckRange(const XmlValue& value, const XmlValueRule& rule, Messages& log, double number)
{
  if (rule.Range.Contains(number))
  {
    return true;
  }
  const bool isTiny = number > 0.0 && number < SmallestNumber;
  log.Error(Quote(value) + " is out of range; " + RangeText(rule) +
    (isTiny ? ", 0 or at least 1e-30 in size" : ""));
  return false;
}

std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for (const char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else if (!std::isspace(static_cast<unsigned char>(c)) || !parts.back().empty())
    {
      parts.back() += c;
    }
  }
  for (std::string& part : parts)
  {
    part.erase(part.find_last_not_of(" \t\r\n") + 1);
  }
  return parts;
}

constexpr vtkIdType HighestSeed = 4611686018427387904LL; // 2^62

/// Returns the digits of a date, the integer part of a decimal number; negative: not a seed.
vtkIdType FindSeed(std::string text)
{
  const bool isDate = text.find_first_of("-:") != std::string::npos && text.size() == 19;
  const auto isNoDigit = [](char c) { return c < '0' || c > '9'; };
  if (isDate)
  {
    text.erase(std::remove_if(text.begin(), text.end(), isNoDigit), text.end());
  }
  vtkIdType seed = -1;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, seed);
  const bool isWhole = parsed.ec == std::errc() &&
    (parsed.ptr == end || (*parsed.ptr == '.' && std::none_of(parsed.ptr + 1, end, isNoDigit)));
  return isWhole && seed <= HighestSeed && (!isDate || text.size() == 14) ? seed : -1;
}

} // namespace

//------------------------------------------------------------------------------
std::string TrimBlanks(std::string text)
{
  text.erase(0, std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return text;
}

//------------------------------------------------------------------------------
bool ParseReal(const XmlValue& value, const XmlValueRule& rule, Messages& log, double& target)
{
  double number = 0.0;
  if (!FiniteFromText(value.Text, number))
  {
    log.Error(
      Quote(value) + " is not a number; give one" + UnitOf(rule) + ", digits with a decimal point");
    return false;
  }
  if (!CheckRange(value, rule, log, number))
  {
    return false;
  }
  target = number == 0.0 ? 0.0 : number; // no -0
  return true;
}

//------------------------------------------------------------------------------
bool ParseInteger(const XmlValue& value, const XmlValueRule& rule, Messages& log, int& target)
{
  int number = 0;
  if (!FromText(value.Text, number))
  {
    log.Error(Quote(value) + " is not an integer; give one" + UnitOf(rule) + ", digits only");
    return false;
  }
  if (!CheckRange(value, rule, log, number))
  {
    return false;
  }
  target = number;
  return true;
}

//------------------------------------------------------------------------------
bool ParseBoolean(const XmlValue& value, Messages& log, bool& target)
{
  std::string text = value.Text;
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (text == "true" || text == "1")
  {
    target = true;
    return true;
  }
  if (text == "false" || text == "0")
  {
    target = false;
    return true;
  }
  log.Error(Quote(value) + " is neither true nor false; give true, false, 1 or 0");
  return false;
}

//------------------------------------------------------------------------------
bool ParseRealList(
  const XmlValue& value, const XmlValueRule& rule, Messages& log, std::vector<double>& target)
{
  std::vector<double> numbers;
  for (const std::string& part : Split(value.Text, ','))
  {
    double number = 0.0;
    if (!FiniteFromText(part, number))
    {
      log.Error(Quote(value) + " is not a list of numbers: \"" + Shorten(part) +
        "\" is not one; give numbers" + UnitOf(rule) + " with commas between them");
      return false;
    }
    if (!CheckRange(value, rule, log, number))
    {
      return false;
    }
    numbers.push_back(number == 0.0 ? 0.0 : number);
  }
  target = numbers;
  return true;
}

//------------------------------------------------------------------------------
bool ParseVector(const XmlValue& value, Messages& log, Vec3& target)
{
  const std::vector<std::string> parts = Split(value.Text, ';');
  Vec3 vector;
  bool good = parts.size() == 3;
  for (int k = 0; good && k < 3; ++k)
  {
    good = FiniteFromText(parts[static_cast<std::size_t>(k)], vector[k]);
  }
  if (!good)
  {
    log.Error(
      Quote(value) + " is not a vector; give three numbers with semicolons, as in 1.5;0;-2");
    return false;
  }
  static const XmlValueRule component;
  for (int k = 0; k < 3; ++k)
  {
    if (!CheckRange(value, component, log, vector[k]))
    {
      return false;
    }
    vector[k] += 0.0; // no -0
  }
  target = vector;
  return true;
}

//------------------------------------------------------------------------------
bool ParseSeed(const XmlValue& value, Messages& log, vtkIdType& target)
{
  const bool isAuto = value.Text.empty() || ToLower(value.Text) == "auto";
  const vtkIdType seed = isAuto ? -1 : FindSeed(value.Text);
  const bool isGood = isAuto || seed >= 0;
  target = isGood ? seed : target;
  if (!isGood)
  {
    log.Error(Quote(value) +
      " is not valid: expected an integer from 0 to 2^62, YYYY-MM-DD hh:mm:ss, or AUTO");
  }
  return isGood;
}

} // namespace helios
