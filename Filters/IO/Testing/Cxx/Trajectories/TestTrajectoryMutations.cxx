// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged trajectory files give an error or a complete trajectory.
#include "heliosMutation.h"
#include "heliosTrajectoryReading.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace
{

const std::string Named = "#HEADER: \"t\", \"roll\", \"pitch\", \"yaw\", \"x\", \"y\", \"z\"\n"
                          "0,0,0,350,-10,0,60\n0.5,1,2,355,-5,1,61\n1,2,1,1,0,2,60 # level\r\n"
                          "\n1.5,0,0,5,5,3,59\n2,0,0,9,10,4,60";
const std::string Plain =
  "#TIME_COLUMN: 0\n0 0 0 90 476000.5 5473000.25 120\n1 0.5 -1 91 2 2 3 // a bend\n"
  "1 0.5 -1 91 2 2 3\n2 1 0 95 3 2.5 1e2\n";

/// Times in order, positions finite, orientations of length 1.
bool IsWhole(helios::TrajectoryReading& reading)
{
  bool isWhole = true;
  for (vtkIdType i = 0; isWhole && i < reading.CountRows(); ++i)
  {
    const helios::Vec3 p = reading.GetPosition(i);
    const helios::Quaternion q = reading.GetOrientation(i);
    const double norm = std::hypot(std::hypot(q.GetW(), q.GetX()), std::hypot(q.GetY(), q.GetZ()));
    isWhole = std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]) &&
      std::isfinite(reading.GetTime(i)) && std::abs(norm - 1.0) < 1e-9 &&
      (i == 0 || reading.GetTime(i - 1) <= reading.GetTime(i));
  }
  return isWhole;
}

} // namespace

TEST_CASE("TrajectoryMutations: damaged files give an error or a trajectory",
  "[TrajectoryMutations][mutation]")
{
  helios::Mutator mutate(20201);
  helios::TrajectoryReading reading;
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const bool isNamed = i % 2 == 0;
    const std::string text = mutate(isNamed ? Named : Plain);
    reading.Reader->SetSeparators(isNamed ? "," : " ");
    reading.Reader->SetDomain(i / 2 % 2);
    reading.Reader->SetSlopeFilterThreshold(i % 3 == 0 ? 0.1 : 0.0);
    INFO("file " << i << "\n" << text);
    const bool isGood = reading.Read(text);
    (isGood ? goodCount : errorCount) += 1;
    REQUIRE(isGood == (reading.CountRows() > 0));
    REQUIRE((isGood || reading.Log->HasError("a.trj")));
    REQUIRE(IsWhole(reading));
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 20);
}

TEST_CASE("TrajectoryMutations: damaged SBET, TUM and EuRoC files give an error or a trajectory",
  "[TrajectoryMutations][mutation]")
{
  const double records[2][17] = { { 100, 0.85, 0.15, 250, 1, 2, 3, 0.1, 0.2, 0.3, 0.4 },
    { 101, 0.8500001, 0.15, 251, 1, 2, 3, 0.1, 0.2, 0.3, 0.4 } };
  const std::string sources[3] = { std::string(
                                     reinterpret_cast<const char*>(records), sizeof records),
    "# t x y z qx qy qz qw\n1.5 1 2 3 0 0 0.6 0.8\n1.75 4 5 6 0 0 0 1\n",
    "#timestamp\n1500000000,1,2,3,0.8,0,0,0.6,9\n1750000000,4,5,6,1,0,0,0,9\n" };
  helios::Mutator mutate(20202);
  helios::TrajectoryReading reading;
  int counts[2] = { 0, 0 };
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const std::string text = mutate(sources[i % 3]);
    reading.Reader->SetFileFormat(vtkHeliosTrajectoryReader::SBET + i % 3);
    INFO("file " << i << "\n" << text);
    const bool isGood = reading.Read(text);
    ++counts[isGood ? 1 : 0];
    REQUIRE(isGood == (reading.CountRows() > 0));
    REQUIRE((isGood || reading.Log->HasError("a.trj")));
    REQUIRE(IsWhole(reading));
  }
  CHECK(counts[0] > 10);
  CHECK(counts[1] > 10);
}
