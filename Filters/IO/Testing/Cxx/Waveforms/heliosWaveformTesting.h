// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Waveforms for the tests of writers, readers and display.

#ifndef heliosWaveformTesting_h
#define heliosWaveformTesting_h

#include "heliosWriterTesting.h"

#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkTable.h>

namespace helios
{

/// Row i has 1 + i % 40 samples.
inline vtkSmartPointer<vtkTable> MakeWaveforms(vtkIdType count)
{
  namespace names = vtkHeliosArrayNames;
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkFieldData* rows = table->GetRowData();
  AddColumn<vtkTypeInt64Array>(
    rows, names::PulseIds, count, [](vtkIdType i) { return 40 + 3 * i; });
  vtkNew<vtkDoubleArray> origins;
  origins->SetName(names::Origin);
  vtkNew<vtkDoubleArray> directions;
  directions->SetName(names::Direction);
  for (vtkDoubleArray* vectors : { origins.Get(), directions.Get() })
  {
    vectors->SetNumberOfComponents(3);
    rows->AddArray(vectors);
  }
  vtkIdType first = 0;
  vtkNew<vtkTypeInt64Array> offsets;
  offsets->SetName(names::Offset);
  vtkNew<vtkTypeInt64Array> counts;
  counts->SetName(names::Count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto x = static_cast<double>(i);
    origins->InsertNextTuple3(500000 + x / 3, -x, 100.5);
    directions->InsertNextTuple3(std::cos(x), std::sin(x), 1e-9);
    offsets->InsertNextValue(first);
    counts->InsertNextValue(1 + i % 40);
    first += 1 + i % 40;
  }
  rows->AddArray(offsets);
  rows->AddArray(counts);
  AddColumn<vtkDoubleArray>(
    rows, names::GpsTime, count, [](vtkIdType i) { return 0.25 * static_cast<double>(i); });
  AddColumn<vtkDoubleArray>(
    rows, names::StartTime, count, [](vtkIdType i) { return 667.125 + static_cast<double>(i); });
  AddColumn<vtkDoubleArray>(rows, names::BinSize, count, [](vtkIdType) { return 0.25; });
  AddColumn<vtkFloatArray>(table->GetFieldData(), names::Samples, first,
    [](vtkIdType i) { return 1e-9 * static_cast<double>(i % 1000); });
  return table;
}

} // namespace helios

#endif
