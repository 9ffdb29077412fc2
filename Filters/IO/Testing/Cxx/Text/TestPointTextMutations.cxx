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
