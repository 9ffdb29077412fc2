// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRecordTimes.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace helios
{

namespace
{

constexpr double Day = 86400.0;
constexpr double Week = 7.0 * Day;

/// The time before and after the end of a period in which it is one [s].
constexpr double Edge = 3600.0;

/// Times above are not seconds of any clock: 3,000 years [s].
constexpr double LatestTime = 1e11;

/// Rows further apart are not seconds: a quarter of an hour [s].
constexpr double LongestUsualStep = 900.0;

/// Rows at least so far apart may be milliseconds [s], if the platform hardly moves [m/s].
constexpr double ShortestDoubtfulStep = 2.0;
constexpr double SlowestUsualSpeed = 0.05;

/// Rows are missing in steps so many times the usual one, and longer than a second.
constexpr double GapFactor = 50.0;
constexpr double ShortestGap = 1.0;
constexpr std::size_t MinimumRows = 4;

std::string Print(double number)
{
  std::ostringstream text;
  text.precision(15);
  text << number;
  return text.str();
}

std::string PrintBriefly(double number)
{
  std::ostringstream text;
  text.precision(6);
  text << number;
  return text.str();
}

/// The steps between rows that are not at one time, of so many rows of a long file.
constexpr std::size_t MaximumSteps = 100000;
std::vector<double> ListSteps(const TimedRows& rows)
{
  std::vector<double> steps;
  for (std::size_t i = 1; i < rows.Count; i += 1 + rows.Count / MaximumSteps)
  {
    const double step = rows.GetTime(i) - rows.GetTime(i - 1);
    if (step > 0.0)
    {
      steps.push_back(step);
    }
  }
  return steps;
}

/// Returns the lower median; 0 without steps.
double FindUsualStep(std::vector<double> steps)
{
  if (steps.empty())
  {
    return 0.0;
  }
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// Returns the unit of times at such steps, and its cure.
std::string NameUnit(double step)
{
  return step >= 2e5 ? "nanoseconds? divide them by 1e9"
    : step >= 1e3    ? "microseconds? divide them by 1e6"
                     : "milliseconds? divide them by 1e3";
}

/// Times too late, or rows too far apart, to be seconds.
TimeFinding FindOtherUnit(const TimedRows& rows, double usual)
{
  for (std::size_t i = 0; i < rows.Count; ++i)
  {
    const double time = rows.GetTime(i);
    if (std::abs(time) > LatestTime)
    {
      return { i,
        "time is " + Print(time) + ", which cannot be seconds" +
          (usual > 0.0 ? ": rows are " + PrintBriefly(usual) + " apart" : std::string()) +
          "; are the times " + NameUnit(usual > 0.0 ? usual : time),
        true };
    }
  }
  if (rows.Count >= MinimumRows && usual > LongestUsualStep)
  {
    return { 1,
      "time is " + Print(rows.GetTime(1)) + ", and rows are " + PrintBriefly(usual) +
        " apart, which cannot be seconds; are the times " + NameUnit(usual),
      true };
  }
  return {};
}

/// Steps of seconds with a platform that hardly moves.
TimeFinding FindSlowMotion(const TimedRows& rows, double usual)
{
  if (rows.Count < MinimumRows || usual < ShortestDoubtfulStep)
  {
    return {};
  }
  double way = 0.0;
  for (std::size_t i = 1; i < rows.Count; ++i)
  {
    way += (rows.GetPosition(i) - rows.GetPosition(i - 1)).Norm();
  }
  const double speed = way / (rows.GetTime(rows.Count - 1) - rows.GetTime(0));
  if (speed == 0.0 || speed >= SlowestUsualSpeed)
  {
    return {};
  }
  return { 1,
    "time is " + Print(rows.GetTime(1)) + ", rows are " + PrintBriefly(usual) +
      " s apart, and the platform moves at " + PrintBriefly(speed) + " m/s; are the times " +
      NameUnit(usual),
    false };
}

/// Returns the first gap, with the number of all and the longest; a step to another clock before
/// all.
TimeFinding FindGaps(const TimedRows& rows, double usual)
{
  std::size_t first = 0;
  std::size_t count = 0;
  double longest = 0.0;
  for (std::size_t i = 1; i < rows.Count; ++i)
  {
    const double step = rows.GetTime(i) - rows.GetTime(i - 1);
    if (step >= Week)
    {
      return { i,
        "time is " + Print(rows.GetTime(i)) + " s, " + PrintBriefly(step) +
          " s after that of the row before, " + Print(rows.GetTime(i - 1)) +
          " s: these are times of two clocks, such as seconds of a GPS week and GPS time since "
          "1980; "
          "give all rows times of one",
        true };
    }
    if (rows.Count >= MinimumRows && step > ShortestGap && step > GapFactor * usual)
    {
      first = count == 0 ? i : first;
      longest = std::max(longest, step);
      ++count;
    }
  }
  if (count == 0)
  {
    return {};
  }
  const double step = rows.GetTime(first) - rows.GetTime(first - 1);
  return { first,
    "rows are missing for " + PrintBriefly(step) + " s, from " + Print(rows.GetTime(first - 1)) +
      " s to " + Print(rows.GetTime(first)) + " s, where others are " + PrintBriefly(usual) +
      " s apart" +
      (count > 1 ? " (and " + std::to_string(count - 1) + " more gaps, up to " +
            PrintBriefly(longest) + " s)"
                 : std::string()) +
      "; a leg over it scans on a straight line: end one leg before it and start the next one "
      "after it, with tEnd and tStart",
    false };
}

} // namespace

//------------------------------------------------------------------------------
double FindEndedPeriod(double before, double time)
{
  for (const double period : { Week, Day })
  {
    const bool isStart = time >= 0.0 && time <= Edge;
    if (isStart && before >= period - Edge && before <= period + 1.0)
    {
      return period;
    }
  }
  return 0.0;
}

//------------------------------------------------------------------------------
std::string NamePeriod(double period)
{
  return period == Week ? "a GPS week" : "a day";
}

//------------------------------------------------------------------------------
double RecordClock::Continue(double time)
{
  this->Before = this->Last;
  const double period = this->HasLast ? FindEndedPeriod(this->Last, time) : 0.0;
  this->IsEnd = period > 0.0;
  if (this->IsEnd)
  {
    this->Period = period;
    this->Offset += period;
    ++this->NumberOfEnds;
  }
  this->Last = time;
  this->HasLast = true;
  return time + this->Offset;
}

//------------------------------------------------------------------------------
std::string RecordClock::DescribeEnd() const
{
  const std::string period = Print(this->Period);
  return "time is " + Print(this->Last) + " s, after " + Print(this->Before) +
    " s of the row before: " + NamePeriod(this->Period) + " of " + period +
    " s ends; times continue from here, with " + period + " s added";
}

//------------------------------------------------------------------------------
TimeFinding CheckRecordTimes(const TimedRows& rows)
{
  const double usual = FindUsualStep(ListSteps(rows));
  TimeFinding finding = FindOtherUnit(rows, usual);
  finding = finding.Message.empty() ? FindGaps(rows, usual) : finding;
  return finding.Message.empty() ? FindSlowMotion(rows, usual) : finding;
}

} // namespace helios
