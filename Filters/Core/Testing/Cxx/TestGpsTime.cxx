// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosGpsTime.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace
{

double Parse(const std::string& text)
{
  return vtkHeliosGpsTime::Parse(text);
}

} // namespace

TEST_CASE("GpsTime: GPS time is ahead of UTC by its leap seconds", "[GpsTime]")
{
  CHECK(Parse("1980-01-06 00:00:01") == 1.0);
  CHECK(Parse("1981-07-01 00:00:00Z") == Parse("1981-06-30 23:59:59Z") + 2.0);
  // 1 January 2017 is a Sunday, on which GPS week 1930 begins; UTC is 18 s late
  CHECK(Parse("2017-01-01 00:00:00") == 1930.0 * 604800.0 + 18.0);
  CHECK(Parse("2016-12-31 23:59:59") == 1930.0 * 604800.0 + 16.0);
  CHECK(Parse("2016-12-31 23:59:60") == 1930.0 * 604800.0 + 17.0);
  CHECK(Parse("2026-07-01 12:00:00") == 1466942418.0);
}

TEST_CASE("GpsTime: forms of a time", "[GpsTime]")
{
  const double noon = Parse("2024-05-01 12:00:00");
  CHECK(noon == 1714564800.0 - 315964800.0 + 18.0);
  for (const char* text : { "2024-05-01T12:00:00", "2024-05-01T12:00:00Z", "2024-05-01 12:00",
         "2024-05-01 12:00:00 UTC", "2024-05-01T14:00:00+02:00", "2024-05-01T06:30:00-0530",
         "2024-05-02T02:00:00+14:00", "1714564800", "1714564800.0", "gps:1398600018" })
  {
    INFO(text);
    CHECK(Parse(text) == noon);
  }
  CHECK(Parse("2024-05-01T12:00:00.25Z") == noon + 0.25);
  CHECK(Parse("2024-02-29 00:00:00") == Parse("2024-03-01 00:00:00") - 86400.0);
}

TEST_CASE("GpsTime: Unix time and back", "[GpsTime]")
{
  for (const double unixTime : { 315964800.0, 362793599.0, 362793600.0, 1483228799.5, 1483228800.0,
         1483228801.0, 1798761600.25 })
  {
    INFO(unixTime);
    CHECK(vtkHeliosGpsTime::ToUnixTime(vtkHeliosGpsTime::FromUnixTime(unixTime)) == unixTime);
  }
  const double leap = Parse("2016-12-31 23:59:60");
  CHECK(vtkHeliosGpsTime::ToUnixTime(leap) == 1483228800.0);
  CHECK(vtkHeliosGpsTime::ToUnixTime(leap + 1.0) == 1483228800.0);
}

TEST_CASE("GpsTime: other texts are refused with what is expected", "[GpsTime]")
{
  for (const char* text : { "", "noon", "2024-13-01 00:00:00", "2023-02-29 00:00:00",
         "2024-05-01 24:00:00", "2024-05-01 12:60:00", "2024-05-01 12:00:60", "2024-05-01",
         "01.05.2024 12:00:00", "gps:", "gps:x", "nan", "2024-05-01T12:00:00+25:00", "1e3 " })
  {
    INFO(text);
    CHECK(std::isnan(Parse(text)));
    CHECK(vtkHeliosGpsTime::GetFault(text).find(
            "is not a time; give YYYY-MM-DD hh:mm:ss of UTC, or with a zone") == 0);
  }
  for (const char* text :
    { "1980-01-06 00:00:00", "1979-01-01 00:00:00", "0", "-5", "gps:0", "1e12" })
  {
    INFO(text);
    CHECK(vtkHeliosGpsTime::GetFault(text).find(
            "is not after the begin of GPS time, 1980-01-06 00:00:00") == 0);
  }
  CHECK(vtkHeliosGpsTime::GetFault("2024-05-01 12:00:00").empty());
}
