// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFlightPattern.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace helios
{

namespace
{

constexpr double CoarseStep = 0.25; // [deg]
constexpr int FineSteps = 25;       // fine steps on either side of a coarse one
constexpr std::size_t BestOnes = 4; // coarse headings that are refined
constexpr double Rounding = 1e-9;   // rounding of a number of lines

/// Returns the number of lines that cover a width.
double CountLines(double width, const PatternSettings& settings)
{
  const double more = (width - settings.Swath) / settings.Spacing;
  return more > Rounding ? 1.0 + std::ceil(more - Rounding) : 1.0;
}

void AddLines(const FlightArea& area, const PatternSettings& settings, FlightPattern& pattern)
{
  const Interval width = area.GetWidth();
  const double count = CountLines(width.GetLength(), settings);
  const double spacing = count > 1.0 ? (width.GetLength() - settings.Swath) / (count - 1.0) : 0.0;
  const double middle = 0.5 * (width.Low + width.High);
  for (double i = 0.0; i < count; ++i)
  {
    const double across = middle + (i - 0.5 * (count - 1.0)) * spacing;
    const double half = 0.5 * settings.Swath;
    const Interval along = area.GetLength({ across - half, across + half });
    if (!along.IsEmpty())
    {
      const double first = along.Low - settings.RunIn;
      const double last = along.High + settings.RunIn;
      const bool isForward = pattern.Lines.size() % 2 == 0;
      pattern.Lines.push_back({ across, isForward ? first : last, isForward ? last : first });
    }
  }
}

void AddTimes(const PatternSettings& settings, FlightPattern& pattern)
{
  const std::vector<PatternLine>& lines = pattern.Lines;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    pattern.LineLength += std::abs(lines[i].Last - lines[i].First);
    if (i > 0 && settings.TurnTime > 0.0)
    {
      pattern.TurnLength += settings.TurnTime * settings.Speed;
    }
    else if (i > 0)
    {
      pattern.TurnLength += ComputeTurnLength(lines[i].Across - lines[i - 1].Across,
        lines[i].First - lines[i - 1].Last, settings.TurnRadius);
    }
  }
  pattern.Time = (pattern.LineLength + pattern.TurnLength) / settings.Speed;
}

} // namespace

//------------------------------------------------------------------------------
double ComputeTurnLength(double across, double along, double radius)
{
  const double distance = std::abs(across);
  const double level = std::abs(along);
  if (radius <= 0.0)
  {
    return std::hypot(distance, level);
  }
  if (distance >= 2.0 * radius)
  {
    return level + distance + (vtkMath::Pi() - 2.0) * radius;
  }
  const double angle = std::acos(0.5 + 0.25 * distance / radius);
  return level + (vtkMath::Pi() + 4.0 * angle) * radius;
}

//------------------------------------------------------------------------------
FlightPattern MakePattern(const FlightArea& area, double heading, const PatternSettings& settings)
{
  FlightPattern pattern;
  pattern.Heading = heading;
  AddLines(area.Turn(heading), settings, pattern);
  AddTimes(settings, pattern);
  return pattern;
}

//------------------------------------------------------------------------------
FlightPattern FindPattern(const FlightArea& area, const PatternSettings& settings)
{
  std::vector<FlightPattern> coarse;
  const auto add = [&](double heading, std::vector<FlightPattern>& patterns)
  { patterns.push_back(MakePattern(area, heading, settings)); };
  for (double heading = 0.0; heading < 180.0; heading += CoarseStep)
  {
    add(heading, coarse);
  }
  for (const double heading : area.GetHullHeadings())
  {
    add(heading, coarse);
  }
  const auto isFaster = [](const FlightPattern& a, const FlightPattern& b)
  { return a.Time < b.Time; };
  std::stable_sort(coarse.begin(), coarse.end(), isFaster);
  coarse.resize(std::min(coarse.size(), BestOnes));
  std::vector<FlightPattern> fine = coarse;
  for (const FlightPattern& pattern : coarse)
  {
    for (int i = -FineSteps; i <= FineSteps; ++i)
    {
      add(std::fmod(pattern.Heading + CoarseStep * i / FineSteps + 180.0, 180.0), fine);
    }
  }
  return *std::min_element(fine.begin(), fine.end(), isFaster);
}

} // namespace helios
