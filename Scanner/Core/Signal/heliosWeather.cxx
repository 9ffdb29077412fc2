// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWeather.h"

#include <array>
#include <cmath>
#include <sstream>

namespace helios
{
namespace
{

constexpr double PerMeter = 1e-3;                       // values are given per km
constexpr double Neper = PerMeter * 0.2302585092994046; // factor of dB/km: ln(10) / 10

/// Returns Kim's exponent of the wavelength.
double GetExponent(double visibility)
{
  const double v = visibility;
  return v > 50.0 ? 1.6 : v > 6.0 ? 1.3 : v > 1.0 ? 0.16 * v + 0.34 : v > 0.5 ? v - 0.5 : 0.0;
}

double FromVisibility(double visibility, double wavelength)
{
  return PerMeter * 3.912 / visibility * std::pow(wavelength / 550.0, -GetExponent(visibility));
}

double FromRain(double rate, double)
{
  return Neper * 1.076 * std::pow(rate, 0.67);
}

double FromSnow(double rate, double wavelength)
{
  return Neper * (5.42e-5 * wavelength + 5.4958776) * std::pow(rate, 1.38);
}

double FromSleet(double rate, double wavelength)
{
  return Neper * (1.023e-4 * wavelength + 3.7855466) * std::pow(rate, 0.72);
}

/// Returns the median diameter of drops by volume [m].
double GetDiameter(double rate)
{
  return 0.895e-3 * std::pow(rate, 0.21);
}

struct Kind
{
  const char* Name;
  double (*GetExtinction)(double amount, double wavelength);
  double LidarRatio;
  double Minimum, Maximum;
  const char* Amount;
};
constexpr std::array<Kind, 6> Kinds = { {
  { "fog", &FromVisibility, 18.8, 0.005, 1000.0, "the visibility in km, from 0.005 to 1000" },
  { "smoke", &FromVisibility, 70.0, 0.005, 1000.0, "the visibility in km, from 0.005 to 1000" },
  { "dust", &FromVisibility, 45.0, 0.005, 1000.0, "the visibility in km, from 0.005 to 1000" },
  { "rain", &FromRain, 18.8, 0.0, 300.0, "mm/h, from 0 to 300, and drops for single ones" },
  { "snow", &FromSnow, 25.0, 0.0, 50.0, "mm/h of water, from 0 to 50" },
  { "sleet", &FromSleet, 25.0, 0.0, 50.0, "mm/h of water, from 0 to 50" },
} };

} // namespace

Status ParseWeather(const std::string& text, double wavelength, Air& air)
{
  air = Air();
  std::istringstream words(text);
  std::string name, rest;
  if (!(words >> name) || (name == "clear" && !(words >> rest)))
  {
    return {};
  }
  for (const Kind& kind : Kinds)
  {
    if (name == kind.Name)
    {
      double amount = -1.0;
      const bool isGood = words >> amount && amount >= kind.Minimum && amount <= kind.Maximum;
      const bool hasDrops = isGood && words >> rest && rest == "drops" && name == "rain";
      if (!isGood || (!hasDrops && !rest.empty()) || words >> rest)
      {
        return Status::Error("give " + name + " and " + kind.Amount);
      }
      air = { kind.GetExtinction(amount, wavelength), kind.LidarRatio,
        hasDrops ? GetDiameter(amount) : 0.0 };
      return {};
    }
  }
  return Status::Error(
    "give clear, fog, smoke or dust and the visibility in km, or rain, snow or sleet "
    "and mm/h, such as \"fog 0.2\"");
}

Status FindWeatherFault(const std::string& text)
{
  constexpr double anyWavelength = 1064.0;
  Air air;
  return ParseWeather(text, anyWavelength, air);
}

} // namespace helios
