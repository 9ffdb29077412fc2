// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Times of trajectory files: ends of weeks and days, missing rows, other units, other clocks.
#include "heliosTrajectoryReading.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstring>
#include <fstream>
#include <sstream>

namespace
{

using Reading = helios::TrajectoryReading;

/// Rows at these times, each so far [m] after the one before.
std::string Rows(const std::vector<double>& times, double way = 1.0)
{
  std::ostringstream text;
  text.precision(17);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    text << times[i] << ",0,0,0," << way * static_cast<double>(i) << ",0,50\n";
  }
  return text.str();
}

/// TUM rows at these times.
std::string Poses(const std::vector<double>& times)
{
  std::ostringstream text;
  text.precision(17);
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    text << times[i] << " " << i << " 0 50 0 0 0 1\n";
  }
  return text.str();
}

/// SBET records at these times.
std::string Records(const std::vector<double>& times)
{
  std::string bytes;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const std::array<double, 17> record{ times[i], 0.8 + 1e-7 * static_cast<double>(i), 0.1,
      250.0 };
    bytes.append(reinterpret_cast<const char*>(record.data()), sizeof(record));
  }
  return bytes;
}

int CountWarnings(const Reading& reading)
{
  const std::string start = "Warning: In ";
  int count = 0;
  for (std::size_t at = reading.Log->Warnings.find(start); at != std::string::npos;
       at = reading.Log->Warnings.find(start, at + 1))
  {
    ++count;
  }
  return count;
}

std::vector<double> Steps(double first, double step, int count)
{
  std::vector<double> times;
  for (int i = 0; i < count; ++i)
  {
    times.push_back(first + i * step);
  }
  return times;
}

} // namespace

TEST_CASE("TrajectoryTimes: a flight over the end of a GPS week continues", "[TrajectoryTimes]")
{
  Reading reading;
  const std::vector<double> times = { 604799.85, 604799.9, 604799.95, 0.0, 0.05, 0.1 };
  const std::string warning = "time is 0 s, after 604799.95 s of the row before: a GPS week of "
                              "604800 s ends; times continue from here, with 604800 s added";
  const auto check = [&](const std::string& place)
  {
    CHECK(reading.Log->HasWarning(place + warning));
    CHECK(CountWarnings(reading) == 1);
    CHECK(reading.CountRows() == 6);
    CHECK(reading.GetTime(0) == 604799.85);
    CHECK(reading.GetTime(3) == 604800.0);
    CHECK(reading.GetTime(5) == Approx(604800.1).epsilon(1e-15));
  };
  REQUIRE(reading.Read(Rows(times)));
  check("a.trj:4: ");
  CHECK(reading.GetPosition(5)[0] == 5.0);

  reading.Reader->SetFileFormat(vtkHeliosTrajectoryReader::TUM);
  REQUIRE(reading.Read(Poses(times)));
  check("a.trj:4: ");

  reading.Reader->SetFileFormat(vtkHeliosTrajectoryReader::SBET);
  REQUIRE(reading.Read(Records(times)));
  check("a.trj, record 3 (byte 408): ");
}

TEST_CASE("TrajectoryTimes: seconds of the day continue after every midnight", "[TrajectoryTimes]")
{
  Reading reading;
  std::vector<double> times;
  for (int i = 0; i < 2 * 1728 + 1; ++i) // two days and a row, every 50 s, from noon
  {
    times.push_back(std::fmod(43200.0 + 50.0 * i, 86400.0));
  }
  REQUIRE(reading.Read(Rows(times, 50.0)));
  CHECK(CountWarnings(reading) == 1);
  CHECK(reading.Log->HasWarning("a.trj:865: time is 0 s, after 86350 s of the row before: a day of "
                                "86400 s ends; times continue from here, with 86400 s added"));
  for (vtkIdType i = 0; i < reading.CountRows(); ++i)
  {
    REQUIRE(reading.GetTime(i) == 43200.0 + 50.0 * static_cast<double>(i));
  }
}

TEST_CASE("TrajectoryTimes: missing rows are a warning with row and length", "[TrajectoryTimes]")
{
  Reading reading;
  std::vector<double> times = Steps(0.0, 0.01, 100);
  for (const double time : Steps(600.99, 0.01, 100))
  {
    times.push_back(time);
  }
  REQUIRE(reading.Read(Rows(times)));
  CHECK(reading.CountRows() == 200);
  CHECK(CountWarnings(reading) == 1);
  CHECK(reading.Log->HasWarning("a.trj:101: rows are missing for 600 s, from 0.99 s to 600.99 s, "
                                "where others are 0.01 s apart; "
                                "a leg over it scans on a straight line: end one leg before it and "
                                "start the next one after it, "
                                "with tEnd and tStart"));

  times.push_back(630.0);
  REQUIRE(reading.Read(Rows(times)));
  CHECK(reading.Log->HasWarning("apart (and 1 more gaps, up to 600 s); a leg"));

  REQUIRE(reading.Read(Rows({ 0.0, 1.0, 2.0, 30.0, 31.0 }))); // waypoints may be so far apart
  CHECK(reading.Log->Warnings.empty());
}

TEST_CASE("TrajectoryTimes: times that are not seconds are refused", "[TrajectoryTimes]")
{
  Reading reading;
  CHECK(reading.FailsWith(Rows(Steps(0.0, 5e6, 50)),
    "a.trj:2: time is 5000000, and rows are 5e+06 apart, which cannot be seconds; are the times "
    "nanoseconds? divide them by 1e9"));
  CHECK(reading.FailsWith(Rows(Steps(1.7e18, 5.12e6, 50)),
    "a.trj:1: time is 1.7e+18, which cannot be seconds: rows are 5.12e+06 apart; are the times "
    "nanoseconds? divide them by 1e9"));
  CHECK(
    reading.FailsWith(Rows(Steps(0.0, 5e3, 50)), "are the times microseconds? divide them by 1e6"));
  CHECK(reading.FailsWith(Rows(Steps(1.7e12, 5.0, 50)),
    "a.trj:1: time is 1700000000000, which cannot be seconds: rows are 5 apart; are the times "
    "milliseconds? divide them by 1e3"));
  reading.Reader->SetFileFormat(vtkHeliosTrajectoryReader::SBET);
  CHECK(
    reading.FailsWith(Records(Steps(0.0, 5e6, 50)), "a.trj, record 1 (byte 136): time is 5000000"));
  reading.Reader->SetFileFormat(vtkHeliosTrajectoryReader::COLUMNS);

  REQUIRE(reading.Read(Rows(Steps(0.0, 50.0, 50), 0.4)));
  CHECK(reading.Log->HasWarning(
    "a.trj:2: time is 50, rows are 50 s apart, and the platform moves at 0.008 m/s; are the times "
    "milliseconds? divide them by 1e3"));
  REQUIRE(reading.Read(Rows(Steps(0.0, 50.0, 50), 0.0))); // it may stand
  CHECK(reading.Log->Warnings.empty());
  for (const double epoch : { 0.0, 345600.0, 4.2e8, 1.42e9, 1.79e9 }) // all clocks of seconds
  {
    REQUIRE(reading.Read(Rows(Steps(epoch, 0.005, 50))));
    CHECK(reading.Log->Warnings.empty());
  }
}

TEST_CASE("TrajectoryTimes: times of two clocks are refused", "[TrajectoryTimes]")
{
  Reading reading;
  std::vector<double> times = Steps(345600.0, 0.01, 20);
  times.push_back(1.42e9);
  CHECK(reading.FailsWith(Rows(times),
    "a.trj:21: time is 1420000000 s, 1.41965e+09 s after that of the row before, 345600.19 s: "
    "these "
    "are times of two clocks, such as seconds of a GPS week and GPS time since 1980; give all rows "
    "times of one"));
}

TEST_CASE("TrajectoryTimes: rows out of order are sorted with a warning", "[TrajectoryTimes]")
{
  Reading reading;
  REQUIRE(reading.Read(Rows({ 5.0, 6.0, 3.5, 4.0 })));
  CHECK(CountWarnings(reading) == 1);
  CHECK(reading.Log->HasWarning("a.trj:3: time is 3.5 s, before that of the row before, 6 s; the "
                                "rows are used in order of time: "
                                "sort them, and remove those of other flights"));
  CHECK(reading.GetTime(0) == 3.5);
  CHECK(reading.GetPosition(0)[0] == 2.0);
}
