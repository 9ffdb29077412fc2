// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTrajectoryReading.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosPoseTextWriter.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

namespace names = vtkHeliosArrayNames;
using helios::Quaternion;
using helios::TrajectoryReading;
using helios::Vec3;

namespace
{

const Vec3 X(1, 0, 0), Y(0, 1, 0), Z(0, 0, 1);

/// A quarter turn to the left about z, w = z = sqrt(1/2).
const char* const TumRows = "# t x y z qx qy qz qw\n"
                            "1.5 1 2 3 0 0 0.70710678 0.70710678\n"
                            "1.75  4\t5 6 0 0 0 1\n";
const char* const EurocRows = "#timestamp, p_x, p_y, p_z, q_w, q_x, q_y, q_z, v_x\n"
                              "1500000000,1,2,3,0.70710678,0,0,0.70710678,9\n"
                              "1750000000,4,5,6,1,0,0,0,9\n";

std::string GetText(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

} // namespace

TEST_CASE("PoseText: rows of TUM and EuRoC files", "[PoseText]")
{
  for (const bool isTum : { true, false })
  {
    TrajectoryReading reading;
    reading.Reader->SetFileFormat(
      isTum ? vtkHeliosTrajectoryReader::TUM : vtkHeliosTrajectoryReader::EUROC);
    REQUIRE(reading.Read(isTum ? TumRows : EurocRows));
    REQUIRE(reading.CountRows() == 2);
    CHECK(reading.GetTime(0) == 1.5);
    CHECK(reading.GetTime(1) == 1.75);
    CHECK(reading.GetPosition(1) == Vec3(4, 5, 6));
    CHECK((reading.ToWorld(0, X) - Y).Norm() < 1e-8);
    CHECK(std::abs(reading.GetOrientation(0).Norm() - 1.0) < 1e-15);
    CHECK((reading.ToWorld(1, X) - X).Norm() < 1e-15);
  }
}

TEST_CASE("PoseText: axes of the body", "[PoseText]")
{
  struct Axes
  {
    int Frame;
    Vec3 Right, Forward, Up;
  };
  const Axes all[] = { { vtkHeliosTrajectoryReader::RIGHT_FORWARD_UP, X, Y, Z },
    { vtkHeliosTrajectoryReader::FORWARD_LEFT_UP, -1.0 * Y, X, Z },
    { vtkHeliosTrajectoryReader::FORWARD_RIGHT_DOWN, Y, X, -1.0 * Z } };
  for (const Axes& axes : all)
  {
    TrajectoryReading reading;
    reading.Reader->SetFileFormatToTum();
    reading.Reader->SetBodyFrame(axes.Frame);
    REQUIRE(reading.Read("0 0 0 0 0 0 0 1\n"));
    CHECK((reading.ToWorld(0, X) - axes.Right).Norm() < 1e-15);
    CHECK((reading.ToWorld(0, Y) - axes.Forward).Norm() < 1e-15);
    CHECK((reading.ToWorld(0, Z) - axes.Up).Norm() < 1e-15);
  }
}

TEST_CASE("PoseText: bad rows are errors with file and line", "[PoseText]")
{
  TrajectoryReading reading;
  reading.Reader->SetFileFormatToTum();
  CHECK(reading.FailsWith("0 1 2 3 0 0 0\n",
    "a.trj:1: the row has 7 columns; a row of a TUM file is t x y z qx qy qz qw"));
  CHECK(reading.FailsWith("# head\n0 1 2 x 0 0 0 1\n", "a.trj:2: "));
  CHECK(reading.FailsWith("0 1 2 nan 0 0 0 1\n", "a.trj:1: "));
  CHECK(reading.FailsWith("0 1 2 3 0 0 0 1\n0 1 2 3 0 0 0 1\n",
    "a.trj:2: time is 0 s, not after that of the row before, 0 s; sort the rows by time"));
  CHECK(reading.FailsWith("0 1 2 3 0.5 0 0 1\n",
    "a.trj:1: the quaternion (w 1, x 0.5, y 0, z 0) has length 1.118034; give unit quaternions, "
    "and "
    "rows t x y z qx qy qz qw"));
  CHECK(reading.FailsWith("# nothing\n", "a.trj: has no rows; give a TUM file with rows t x y z"));
  CHECK(reading.Read("0 1 2 3 0 0 0.0005 1.0005\n")); // few digits
  reading.Reader->SetFileFormatToEuroc();
  CHECK(reading.FailsWith("0,1,2,3,1,0,0\n",
    "a.trj:1: the row has 7 columns; a row of a EuRoC file is t,x,y,z,qw,qx,qy,qz"));
}

TEST_CASE("PoseText: what is written is read back", "[PoseText]")
{
  for (const bool isTum : { true, false })
  {
    TrajectoryReading reading;
    reading.Reader->SetFileFormatToTum();
    REQUIRE(reading.Read(TumRows));
    const helios::TempFolder folder;
    vtkNew<vtkHeliosPoseTextWriter> writer;
    const std::string path = folder / "b.txt";
    writer->SetFileName(path.c_str());
    writer->SetFileFormat(isTum ? vtkHeliosPoseTextWriter::TUM : vtkHeliosPoseTextWriter::EUROC);
    REQUIRE((writer->Open() && writer->Write(reading.Path()) && writer->Close()));
    CHECK(writer->GetNumberOfRecords() == 2);
    const std::string expected = isTum
      ? "1.500000000 1.000000 2.000000 3.000000 0.000000000 0.000000000 0.707106781 0.707106781\n"
        "1.750000000 4.000000 5.000000 6.000000 0.000000000 0.000000000 0.000000000 1.000000000\n"
      : "#timestamp [ns],p_x [m],p_y [m],p_z [m],q_w [],q_x [],q_y [],q_z []\n"
        "1500000000,1.000000,2.000000,3.000000,0.707106781,0.000000000,0.000000000,0.707106781\n"
        "1750000000,4.000000,5.000000,6.000000,1.000000000,0.000000000,0.000000000,0.000000000\n";
    CHECK(GetText(path) == expected);
    reading.Reader->SetFileName(path.c_str());
    reading.Reader->SetFileFormat(
      isTum ? vtkHeliosTrajectoryReader::TUM : vtkHeliosTrajectoryReader::EUROC);
    REQUIRE(reading.Update());
    CHECK(reading.GetTime(1) == 1.75);
    CHECK((reading.ToWorld(0, X) - Y).Norm() < 1e-8);
  }
}

TEST_CASE("PoseText: what cannot be written", "[PoseText]")
{
  TrajectoryReading reading;
  reading.Reader->SetFileFormatToTum();
  REQUIRE(reading.Read("1e10 1 2 3 0 0 0 1\n"));
  const helios::TempFolder folder;
  vtkNew<vtkHeliosPoseTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName((folder / "b.csv").c_str());
  writer->SetFileFormatToEuroc();
  REQUIRE(writer->Open());
  CHECK(!writer->Write(reading.Path()));
  CHECK(log->HasError("GpsTime is 1e+10 s in row 0 of a block; EuRoC files have times up to 9.2e9 "
                      "s: subtract an epoch, or write TUM"));
  REQUIRE(reading.Read(TumRows));
  reading.Path()->GetPointData()->GetArray(names::Orientation)->SetTuple4(0, 0, 0, 0, 0);
  CHECK(writer->Write(reading.Path())); // dropped with a warning
  CHECK(log->HasWarning("1 "));
  CHECK(writer->GetNumberOfRecords() == 1);
}
