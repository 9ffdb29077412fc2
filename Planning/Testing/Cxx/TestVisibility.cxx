// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVisibility.h"
#include "vtkHeliosArrayNames.h"

#include <catch2/catch.hpp>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeUInt64Array.h>

namespace names = vtkHeliosArrayNames;

namespace
{

/// Candidates at the origin with rows of this many words, all zero.
vtkNew<vtkPolyData> MakeCandidates(int candidates, int words)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkTypeUInt64Array> rows;
  rows->SetName(names::Visibility);
  rows->SetNumberOfComponents(words);
  rows->SetNumberOfTuples(candidates);
  rows->Fill(0.0);
  for (int c = 0; c < candidates; ++c)
  {
    points->InsertNextPoint(0.0, 0.0, 0.0);
  }
  vtkNew<vtkPolyData> result;
  result->SetPoints(points);
  result->GetPointData()->AddArray(rows);
  return result;
}

void SetBit(vtkPolyData* candidates, int candidate, int testPoint)
{
  auto* rows =
    vtkTypeUInt64Array::SafeDownCast(candidates->GetPointData()->GetArray(names::Visibility));
  std::uint64_t word = rows->GetTypedComponent(candidate, testPoint / 64);
  rows->SetTypedComponent(candidate, testPoint / 64, word | std::uint64_t(1) << (testPoint % 64));
}

} // namespace

TEST_CASE("Visibility: bits are stored and returned", "[Visibility]")
{
  const auto candidates = MakeCandidates(3, 2);
  const std::vector<int> seen = { 0, 63, 64, 99 };
  for (const int v : seen)
  {
    SetBit(candidates, 1, v);
  }
  helios::Visibility matrix;
  REQUIRE(matrix.Set(candidates, 100).IsOk());
  CHECK(matrix.GetNumberOfCandidates() == 3);
  CHECK(matrix.GetSize(0) == 0);
  CHECK(matrix.GetSize(1) == 4);
  CHECK(matrix.IsVisible(1, 64));
  CHECK_FALSE(matrix.IsVisible(1, 65));
  CHECK_FALSE(matrix.IsVisible(2, 64));
  std::vector<int> visited;
  matrix.ForEach(1, [&visited](vtkIdType v) { visited.push_back(static_cast<int>(v)); });
  CHECK(visited == seen);
}

TEST_CASE("Visibility: a matrix of the wrong size is an error", "[Visibility]")
{
  helios::Visibility matrix;
  const auto candidates = MakeCandidates(2, 2);
  CHECK(matrix.Set(vtkNew<vtkPolyData>(), 100).Message() ==
    "the candidates have no point array Visibility; use those of vtkHeliosViewsheds, or add it");
  CHECK(matrix.Set(candidates, 129)
          .Message()
          .find("129 test points need 3 of unsigned 64-bit integers") != std::string::npos);
  SetBit(candidates, 1, 100);
  CHECK(matrix.Set(candidates, 101).IsOk());
  CHECK(matrix.Set(candidates, 100).Message() ==
    "Visibility of candidate 1 has bits beyond the last of 100 test points; clear them");
}
