// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTicks.h"

#include "heliosFormat.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace helios::viewer
{

namespace
{

using Prefix = std::pair<double, const char*>;

constexpr Prefix Prefixes[] = { { 1e9, "G" }, { 1e6, "M" }, { 1e3, "k" }, { 1.0, "" },
  { 1e-3, "m" }, { 1e-6, "\xC2\xB5" }, { 1e-9, "n" }, { 1e-12, "p" }, { 1e-15, "f" } };

bool HasPrefixes(const std::string& unit)
{
  return unit == "W" || unit == "J" || unit == "Hz";
}

/// Finds the prefix with which a value is in [1, 1000).
Prefix FindPrefix(double value, const std::string& unit)
{
  constexpr double rounding = 0.9995; // 999.5 has three digits as 1000
  if (!HasPrefixes(unit) || value == 0.0)
  {
    return { 1.0, "" };
  }
  for (const Prefix& prefix : Prefixes)
  {
    if (std::abs(value) >= rounding * prefix.first)
    {
      return prefix;
    }
  }
  return *std::rbegin(Prefixes);
}

/// Returns the power of ten of the first digit.
int FindExponent(double value)
{
  return static_cast<int>(std::floor(std::log10(value) + 1e-9));
}

/// Returns the smallest of 1, 2, 5 times a power of ten that is not below a positive value.
double RoundUp(double value)
{
  const double power = std::pow(10.0, FindExponent(value));
  for (const double digit : { 1.0, 2.0, 5.0 })
  {
    if (digit * power >= value * (1.0 - 1e-9))
    {
      return digit * power;
    }
  }
  return 10.0 * power;
}

/// Returns a number with fixed decimals; never "-0".
std::string Write(double value, int decimals)
{
  const double rounded = std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value;
  return Format("%.*f", std::max(0, decimals), rounded);
}

bool IsRange(double low, double high)
{
  return std::isfinite(low) && std::isfinite(high) && low < high;
}

} // namespace

//------------------------------------------------------------------------------
double RoundDown(double value)
{
  const double power = std::pow(10.0, FindExponent(value));
  const double digit = value / power * (1.0 + 1e-9);
  return (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0) * power;
}

//------------------------------------------------------------------------------
Ticks MakeTicks(double low, double high, int maximum, const std::string& unit)
{
  Ticks ticks;
  const Prefix prefix = FindPrefix(std::max(std::abs(low), std::abs(high)), unit);
  ticks.Unit = prefix.second + unit;
  if (!IsRange(low, high))
  {
    return ticks;
  }
  // The next steps follow if rounding at the ends gives one tick too many.
  for (double step = RoundUp((high - low) / std::max(1, maximum));; step = RoundUp(1.01 * step))
  {
    const double tolerance = 1e-6 * step;
    const double first = std::ceil((low - tolerance) / step);
    const double last = std::floor((high + tolerance) / step);
    if (last - first + 1.0 > std::max(2, maximum))
    {
      continue;
    }
    const int decimals = -FindExponent(step / prefix.first);
    for (double i = first; i <= last; i += 1.0)
    {
      ticks.List.push_back({ i * step, Write(i * step / prefix.first, decimals) });
    }
    return ticks;
  }
}

//------------------------------------------------------------------------------
Ticks MakeLogTicks(double low, double high, int maximum, const std::string& unit)
{
  if (!IsRange(low, high) || !(low > 0.0) || high < 10.0 * low)
  {
    Ticks ticks = MakeTicks(low, high, maximum, unit);
    for (Tick& tick : ticks.List)
    {
      tick.Text += ticks.Unit.empty() ? "" : " " + ticks.Unit;
    }
    ticks.Unit.clear();
    return ticks;
  }
  Ticks ticks;
  const int first = FindExponent(low);
  const int last = FindExponent(high);
  const double decades = std::log10(high / low);
  const bool hasMore = 3.0 * decades <= maximum;
  const int stride =
    std::max(1, static_cast<int>(std::ceil((decades + 1.0) / std::max(2, maximum))));
  for (int exponent = first; exponent <= last; exponent += stride)
  {
    for (const double digit : { 1.0, 2.0, 5.0 })
    {
      const double value = digit * std::pow(10.0, exponent);
      const bool isInside = value >= low * (1.0 - 1e-9) && value <= high * (1.0 + 1e-9);
      if (isInside && (digit == 1.0 || hasMore))
      {
        ticks.List.push_back({ value, DescribeValue(value, unit) });
      }
    }
  }
  return ticks;
}

//------------------------------------------------------------------------------
std::string DescribeValue(double value, const std::string& unit)
{
  const Prefix prefix = FindPrefix(value, unit);
  const std::string name = prefix.second + unit;
  const double shown = value / prefix.first;
  return Format(std::abs(shown) < 999.5 ? "%.3g" : "%.0f", shown) +
    (name.empty() ? "" : " " + name);
}

//------------------------------------------------------------------------------
std::string DescribeLength(double metres)
{
  static const std::pair<double, const char*> units[] = { { 1e3, "km" }, { 1.0, "m" },
    { 1e-2, "cm" }, { 1e-3, "mm" } };
  for (const auto& unit : units)
  {
    if (metres >= unit.first * (1.0 - 1e-9))
    {
      return Format("%.4g %s", metres / unit.first, unit.second);
    }
  }
  return Format("%.2g mm", 1e3 * metres);
}

} // namespace helios::viewer
