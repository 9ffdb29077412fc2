// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged point text gives an error or complete points, as a whole and in parts.
#include "heliosMutation.h"
#include "heliosPointTextTesting.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;

TEST_CASE("PointTextMutations: damaged files give an error or points", "[mutation]")
{
  const std::string text = "500000.1234 5500000.5678 110.5000 1.2500 4.0625 1 2 7 oak_tree 2 0.5\n"
                           "1 2 3 4 5 1 2 5000000001 -1 6 0.000070000\r\n# end of strip\n"
                           "1 -2 3 0.0000 5 1 1 8 12 0 1.5 // last\n1 2 3 4 5 1 1 9 house 2 2";
  helios::Mutator mutate(20260);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const std::string damaged = mutate(text);
    helios::PointTextReading reading(damaged);
    INFO("file " << i << "\n" << damaged);
    const bool isGood = reading.Read();
    const vtkIdType count = reading.CountPoints();
    (isGood ? goodCount : errorCount) += 1;
    REQUIRE(isGood == (count > 0));
    REQUIRE((isGood || reading.Log->Errors.find("a.xyz:") != std::string::npos));
    for (vtkIdType row = 0; row < count; ++row)
    {
      REQUIRE(std::isfinite(reading.Cloud()->GetPoint(row)[0]));
    }
    for (int array = 0; array < reading.Cloud()->GetPointData()->GetNumberOfArrays(); ++array)
    {
      REQUIRE(reading.Cloud()->GetPointData()->GetArray(array)->GetNumberOfTuples() == count);
    }
    reading.Reader->SetMaximumNumberOfPoints(1);
    vtkIdType sum = 0;
    bool areGood = true;
    for (vtkIdType begin = 0; areGood && begin < static_cast<vtkIdType>(damaged.size());
         begin = reading.Reader->GetEnd())
    {
      reading.Reader->SetBegin(begin);
      areGood = reading.Read();
      sum += reading.CountPoints();
    }
    REQUIRE((areGood && sum == count && count > 0) == isGood);
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 20);
}

TEST_CASE("PointTextMutations: damaged files of other programs", "[mutation]")
{
  const std::string scan = "2\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n5 6 7 1\n"
                           "1 2 3 0.5 255 0 9\n0 0 0 0.5 0 0 0\n4 5 6 1 9 9 9\n7 8 9 0.25 1 2 3\n";
  const std::string texts[] = { "\"X\",\"Y\",\"Z\",\"Intensity\",\"Classification\",\"Red\","
                                "\"Green\",\"Blue\"\n1.5,2,3,9,6,255,0,"
                                "51\n4,-5e1,6,65535,2,1,2,3\n7,8,9,1,2,65535,5,6",
    "//X Y Z R G B Nx Ny Nz Own\r\n1 2 3 255 0 51 0 0 1 a\r\n4 5 6 1 2 3 0.6 0 0.8 b // end\r\n",
    "2\n1 2 3 -2048 255 0 51\n4 5 6 2047 1 2 3\n1\n7 8 9 12 1 1 1\n", "x;y;z\r1,5;2;3\r4;5,25;6\r",
    scan + scan };
  int errorCount = 0;
  int goodCount = 0;
  for (const std::string& text : texts)
  {
    helios::Mutator mutate(20261);
    for (int i = 0; i < helios::GetNumberOfMutations() / 4; ++i)
    {
      const std::string damaged = mutate(text);
      helios::PointTextReading reading(damaged);
      INFO("file " << i << "\n" << damaged);
      const bool isGood = reading.Read();
      const vtkIdType count = reading.CountPoints();
      (isGood ? goodCount : errorCount) += 1;
      REQUIRE((isGood || (count == 0 && reading.Log->Errors.find("a.xyz:") != std::string::npos)));
      for (vtkIdType row = 0; row < count; ++row)
      {
        const double* p = reading.Cloud()->GetPoint(row);
        REQUIRE(std::isfinite(p[0] + p[1] + p[2]));
      }
      for (int array = 0; array < reading.Cloud()->GetPointData()->GetNumberOfArrays(); ++array)
      {
        REQUIRE(reading.Cloud()->GetPointData()->GetArray(array)->GetNumberOfTuples() == count);
      }
      reading.Reader->SetMaximumNumberOfPoints(1);
      vtkIdType sum = 0;
      bool areGood = true;
      for (vtkIdType begin = 0; areGood && begin < static_cast<vtkIdType>(damaged.size());
           begin = reading.Reader->GetEnd())
      {
        reading.Reader->SetBegin(begin);
        areGood = reading.Read();
        sum += reading.CountPoints();
      }
      REQUIRE((damaged.empty() || areGood == isGood));
      REQUIRE((!isGood || sum == count));
    }
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 20);
}
