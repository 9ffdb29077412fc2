// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged point files give an error or complete points, in any number of pieces.
#include "heliosMutation.h"
#include "heliosXyzTesting.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::XyzReading;

namespace
{

const std::string Plain = "\xEF\xBB\xBF// a hedge, measured by hand\nx y z\n1 2 3\n4.5 -6e1 +7\n"
                          "0.1\t0.2\t0.3 # lone\n\n476000.123 5473000.456 110.5\r\n1 1 1\n2 2 2";
const std::string Columns = "# x, y, z, nx, ny, nz, r, g, b, name\n"
                            "1.5,2,3,0,0,1,255,128,0,leaf\n4, 5, 6, 0.6, 0.8, 0, 1, 2, 3,twig\r\n"
                            "7,8,9,-1,0,0,0,0,0,\n1,1,1,0,0,1,9,9,9,\"a, b\" // end\n";

bool IsFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    const double* t = array->GetTuple3(i);
    if (!std::isfinite(t[0]) || !std::isfinite(t[1]) || !std::isfinite(t[2]))
    {
      return false;
    }
  }
  return true;
}

/// Checks the points and the requested arrays.
bool IsWhole(vtkPolyData* cloud, bool hasColumns)
{
  const vtkIdType count = cloud->GetNumberOfPoints();
  bool isWhole = !cloud->GetPoints() || IsFinite(cloud->GetPoints()->GetData());
  for (const char* name : { names::Normals, names::RGB })
  {
    vtkDataArray* array = cloud->GetPointData()->GetArray(name);
    isWhole = isWhole && (array != nullptr) == hasColumns && IsFinite(array) &&
      (!array || array->GetNumberOfTuples() == count);
  }
  return isWhole;
}

} // namespace

TEST_CASE("XyzMutations: damaged files give an error or points", "[XyzMutations][mutation]")
{
  helios::Mutator mutate(20250);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const bool hasColumns = i % 2 == 1;
    const std::string text = mutate(hasColumns ? Columns : Plain);
    XyzReading reading;
    reading.Reader->SetSeparators(hasColumns ? "," : " ");
    reading.Reader->SetReadNormals(hasColumns);
    reading.Reader->SetReadColors(hasColumns);
    reading.Set(text);
    INFO("file " << i << "\n" << text);
    const bool isGood = reading.Read();
    const std::string error = reading.Log->Errors;
    const vtkIdType count = reading.CountPoints();
    (isGood ? goodCount : errorCount) += 1;
    REQUIRE(isGood == (count > 0));
    REQUIRE((isGood || error.find("a.xyz:") != std::string::npos));
    REQUIRE(IsWhole(reading.Cloud(), isGood && hasColumns));

    vtkIdType sum = 0;
    bool areGood = true;
    for (int piece = 0; piece < 3; ++piece)
    {
      reading.Log->Clear();
      const bool isPieceGood = reading.Read(piece, 3);
      REQUIRE(IsWhole(reading.Cloud(), isPieceGood && hasColumns));
      sum += reading.CountPoints();
      areGood = areGood && isPieceGood;
    }
    // A file of comments only is an error when read as a whole, and empty in pieces.
    REQUIRE((areGood == isGood || error.find("has no points") != std::string::npos));
    REQUIRE((!isGood || sum == count));
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 20);
}
