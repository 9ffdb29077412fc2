// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGpsTime.h"

#include "heliosStatus.h"

#include <vtkObjectFactory.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <regex>

vtkStandardNewMacro(vtkHeliosGpsTime);

namespace
{

constexpr double SecondsPerDay = 86400.0;

/// 6 January 1980 00:00 UTC.
constexpr double GpsOrigin = 315964800.0;

/// Times are given up to here: the year 2380 or so [s].
constexpr double LatestTime = 1.3e10;

/// The days after which a leap second was added, as Unix times of the midnights after them
/// (Bulletin C of the IERS); none has been announced since 31 December 2016.
constexpr double LeapSeconds[] = { 362793600.0, 394329600.0, 425865600.0, 489024000.0, 567993600.0,
  631152000.0, 662688000.0, 709948800.0, 741484800.0, 773020800.0, 820454400.0, 867715200.0,
  915148800.0, 1136073600.0, 1230768000.0, 1341100800.0, 1435708800.0, 1483228800.0 };

double CountLeapSeconds(double unixTime)
{
  const auto* after = std::upper_bound(std::begin(LeapSeconds), std::end(LeapSeconds), unixTime);
  return static_cast<double>(after - std::begin(LeapSeconds));
}

/// Returns the days from 1 January 1970 to a date of the Gregorian calendar (H. Hinnant,
/// days_from_civil).
std::int64_t CountDays(std::int64_t year, std::int64_t month, std::int64_t day)
{
  year -= month <= 2 ? 1 : 0;
  const std::int64_t era = (year >= 0 ? year : year - 399) / 400;
  const std::int64_t ofEra = year - era * 400;
  const std::int64_t ofYear = (153 * (month + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
  return era * 146097 + ofEra * 365 + ofEra / 4 - ofEra / 100 + ofYear - 719468;
}

int CountDaysOfMonth(int year, int month)
{
  return static_cast<int>(
    CountDays(month == 12 ? year + 1 : year, month % 12 + 1, 1) - CountDays(year, month, 1));
}

bool ReadNumber(const std::string& text, double& number)
{
  const char* const end = text.data() + text.size();
  const auto [behind, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && behind == end && std::isfinite(number);
}

/// Parses a date with its time of day; false for other text, and for a date that does not exist.
bool ReadDate(const std::string& text, double& gpsTime)
{
  static const std::regex form(R"((\d{4})-(\d\d)-(\d\d)[T ](\d\d):(\d\d)(?::(\d\d(?:\.\d*)?))?)"
                               R"( ?(Z|z|UTC|([+-])(\d\d):?(\d\d))?)");
  std::smatch found;
  if (!std::regex_match(text, found, form))
  {
    return false;
  }
  const auto get = [&found](int i) { return found[i].matched ? std::stoi(found[i]) : 0; };
  double seconds = 0.0;
  if (found[6].matched && !ReadNumber(found[6], seconds))
  {
    return false;
  }
  const int year = get(1), month = get(2), day = get(3), hour = get(4), minute = get(5);
  if (month < 1 || month > 12 || day < 1 || day > CountDaysOfMonth(year, month) || hour > 23 ||
    minute > 59 || get(9) > 23 || get(10) > 59)
  {
    return false;
  }
  const double zone = (found[8] == "-" ? -60.0 : 60.0) * (60 * get(9) + get(10));
  const double start = static_cast<double>(CountDays(year, month, day)) * SecondsPerDay +
    3600.0 * hour + 60.0 * minute - zone; // seconds of the minute
  const double leap = CountLeapSeconds(start + 60.0) - CountLeapSeconds(start);
  gpsTime = vtkHeliosGpsTime::FromUnixTime(start) + seconds;
  return seconds < 60.0 + leap;
}

/// Computes the GPS time [s] of a text; an error says which forms are expected.
helios::Status ParseTime(const std::string& text, double& gpsTime)
{
  const std::string gpsMark = "gps:";
  const bool isGps = text.compare(0, gpsMark.size(), gpsMark) == 0;
  double number = 0.0;
  double time = 0.0;
  if (ReadNumber(isGps ? text.substr(gpsMark.size()) : text, number))
  {
    time = isGps ? number : vtkHeliosGpsTime::FromUnixTime(number);
  }
  else if (isGps || !ReadDate(text, time))
  {
    return helios::Status::Error(
      "is not a time; give YYYY-MM-DD hh:mm:ss of UTC, or with a zone as in "
      "2026-07-01T12:00:00+02:00, Unix seconds, or GPS seconds as gps:1467000000");
  }
  if (!(time > 0.0 && time <= LatestTime))
  {
    return helios::Status::Error(
      "is not after the begin of GPS time, 1980-01-06 00:00:00, or more than 400 "
      "years after it; give a later time in seconds, or an earlier one");
  }
  gpsTime = time;
  return {};
}

} // namespace

//------------------------------------------------------------------------------
double vtkHeliosGpsTime::FromUnixTime(double unixTime)
{
  return unixTime - GpsOrigin + CountLeapSeconds(unixTime);
}

//------------------------------------------------------------------------------
double vtkHeliosGpsTime::ToUnixTime(double gpsTime)
{
  double leaps = 0.0;
  for (const double leap : LeapSeconds)
  {
    leaps += gpsTime >= leap - GpsOrigin + leaps + 1.0 ? 1.0 : 0.0;
  }
  return gpsTime + GpsOrigin - leaps;
}

//------------------------------------------------------------------------------
double vtkHeliosGpsTime::Parse(const std::string& text)
{
  double time = 0.0;
  return ParseTime(text, time).IsOk() ? time : std::numeric_limits<double>::quiet_NaN();
}

//------------------------------------------------------------------------------
std::string vtkHeliosGpsTime::GetFault(const std::string& text)
{
  double time = 0.0;
  return ParseTime(text, time).Message();
}
