// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged waveform files give an error or complete waveforms, in any number of pieces.
#include "heliosMutation.h"
#include "heliosWaveformReading.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::WaveformReading;

namespace
{

const std::string Text =
  "\xEF\xBB\xBF# two beams\n0 476000.1235 5473000.4565 110.5 0.6 0 -0.8 667.1282 667.6282 0.25 1 "
  "2.5e3 -0.125\n1 1 2 3 0 0 1 10 10.2 1e5 4 5 # behind it\r\n\n"
  "12\t0 0 0 1 0 0 -3 -2 0 6 7 8 9 10\n13 0 0 0 -0.57735 0.57735 0.57735 5 6 7 8 9\n";

bool IsFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(array->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

/// Every row has all columns and its own samples, in order.
bool IsWhole(vtkTable* table)
{
  const vtkIdType rows = table->GetNumberOfRows();
  if (rows == 0)
  {
    return true;
  }
  vtkFieldData* data = table->GetRowData();
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  bool isWhole = data->GetNumberOfArrays() == 8 && samples && IsFinite(samples);
  for (int i = 0; isWhole && i < data->GetNumberOfArrays(); ++i)
  {
    isWhole = data->GetArray(i)->GetNumberOfTuples() == rows && IsFinite(data->GetArray(i));
  }
  double next = 0.0;
  for (vtkIdType row = 0; isWhole && row < rows; ++row)
  {
    const double count = data->GetArray(names::Count)->GetComponent(row, 0);
    isWhole = data->GetArray(names::Offset)->GetComponent(row, 0) == next && count >= 1.0 &&
      data->GetArray(names::BinSize)->GetComponent(row, 0) > 0.0;
    next += count;
  }
  return isWhole && next == static_cast<double>(samples->GetNumberOfTuples());
}

} // namespace

TEST_CASE(
  "WaveformMutations: damaged files give an error or waveforms", "[WaveformMutations][mutation]")
{
  helios::Mutator mutate(4711);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const std::string text = mutate(Text);
    WaveformReading reading(text);
    reading.Reader->SetOneWayTimes(i % 2 == 1);
    INFO("file " << i << "\n" << text);
    const bool isGood = reading.Read();
    const std::string error = reading.Log->Errors;
    const vtkIdType count = reading.CountWaveforms();
    (isGood ? goodCount : errorCount) += 1;
    REQUIRE(isGood == (count > 0));
    REQUIRE((isGood || error.find("a.txt:") != std::string::npos));
    REQUIRE(IsWhole(reading.Table()));

    vtkIdType sum = 0;
    bool areGood = true;
    for (int piece = 0; piece < 3; ++piece)
    {
      reading.Log->Clear();
      areGood = reading.Read(piece, 3) && areGood;
      REQUIRE(IsWhole(reading.Table()));
      sum += reading.CountWaveforms();
    }
    // A file of comments only is an error when read as a whole, and empty in pieces.
    REQUIRE((areGood == isGood || error.find("has no waveforms") != std::string::npos));
    REQUIRE((!isGood || sum == count));
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 10);
}
