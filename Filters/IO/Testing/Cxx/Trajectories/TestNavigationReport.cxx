// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosTempFolder.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosNavigationReport.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>

namespace
{

const char* const Header = "\"GpsTime\",\"NorthPositionRMS\",\"EastPositionRMS\","
                           "\"DownPositionRMS\",\"NorthVelocityRMS\",\"RollRMS\",\"PitchRMS\","
                           "\"HeadingRMS\"\n";

struct Reading
{
  helios::TempFolder Folder;
  vtkNew<vtkHeliosNavigationReport> Report;
  vtkSmartPointer<helios::ErrorObserver> Log = helios::WatchErrors(Report);

  bool Read(const std::string& bytes, const std::string& name = "a.txt")
  {
    this->Log->Clear();
    std::ofstream(this->Folder / name, std::ios::binary) << bytes;
    return this->Report->Read(this->Folder / name);
  }
  bool FailsWith(
    const std::string& bytes, const std::string& part, const std::string& name = "a.txt")
  {
    return !this->Read(bytes, name) && this->Log->HasError(part) &&
      this->Report->GetNumberOfRows() == 0 && this->Report->GetRMS(0) == 0.0;
  }
};

} // namespace

TEST_CASE("NavigationReport: quadratic means of the rows", "[NavigationReport]")
{
  Reading reading;
  REQUIRE(
    reading.Read(std::string(Header) + "1,0.03,0.3,0.5,9,0.6,6,12\n2,0.04,0.4,0.5,9,0.6,6,12\n"));
  CHECK(reading.Report->GetNumberOfRows() == 2);
  CHECK(reading.Report->GetRMS(0) == Approx(std::sqrt(0.125)));   // east
  CHECK(reading.Report->GetRMS(1) == Approx(std::sqrt(0.00125))); // north
  CHECK(reading.Report->GetRMS(2) == Approx(0.5));
  CHECK(reading.Report->GetRMS(3) == Approx(0.1)); // pitch, 6'
  CHECK(reading.Report->GetRMS(4) == Approx(0.01));
  CHECK(reading.Report->GetRMS(5) == Approx(0.2));
  CHECK(std::isnan(reading.Report->GetRMS(6)));
  CHECK(std::isnan(reading.Report->GetRMS(-1)));
}

TEST_CASE("NavigationReport: binary records", "[NavigationReport]")
{
  Reading reading;
  const double record[10] = { 1, 0.1, 0.2, 0.3, 9, 9, 9, 6, 12, 18 };
  const std::string bytes(reinterpret_cast<const char*>(record), sizeof record);
  REQUIRE(reading.Read(bytes + bytes, "smrmsg.out"));
  const double expected[6] = { 0.2, 0.1, 0.3, 0.2, 0.1, 0.3 };
  for (int k = 0; k < 6; ++k)
  {
    CHECK(reading.Report->GetRMS(k) == Approx(expected[k]));
  }
  CHECK(reading.FailsWith(bytes.substr(1),
    "smrmsg.out: has 79 bytes, no whole number of records of 80 bytes; copy the complete file",
    "smrmsg.out"));
  CHECK(reading.FailsWith("", "smrmsg.out: has no rows", "smrmsg.out"));
  const double bad[10] = { 1, 0.1, NAN, 0.3, 9, 9, 9, 6, 12, 18 };
  CHECK(reading.FailsWith(bytes + std::string(reinterpret_cast<const char*>(bad), sizeof bad),
    "smrmsg.out, record 1: EastPositionRMS is nan, not from 0 to 1e6", "smrmsg.out"));
}

TEST_CASE("NavigationReport: bad files are errors with file and line", "[NavigationReport]")
{
  Reading reading;
  CHECK(!reading.Report->Read("nowhere.txt"));
  CHECK(reading.Log->HasError("nowhere.txt"));
  CHECK(reading.FailsWith("1,2,3\n",
    "a.txt:1: the header does not name EastPositionRMS; give a "
    "first line with the names of the columns"));
  CHECK(reading.FailsWith(std::string(Header) + "1,0.03,0.3\n",
    "a.txt:2: the row has 3 columns, fewer than the header; complete or remove it"));
  CHECK(reading.FailsWith(std::string(Header) + "1,x,0.3,0.5,9,0.6,6,12\n", "a.txt:2: "));
  CHECK(reading.FailsWith(std::string(Header) + "1,0.03,0.3,0.5,9,-0.6,6,12\n",
    "a.txt:2: RollRMS is -0.6, not from 0 to 1e6; give RMS errors, or remove the row"));
  CHECK(reading.FailsWith(std::string(Header) + "1,0.03,1e200,0.5,9,0.6,6,12\n",
    "a.txt:2: EastPositionRMS is 1e+200, not from 0 to 1e6"));
  CHECK(reading.FailsWith(Header, "a.txt: has no rows; give an error report with a header"));
}
