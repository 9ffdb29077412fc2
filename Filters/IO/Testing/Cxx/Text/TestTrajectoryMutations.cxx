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
