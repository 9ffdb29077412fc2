// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A validated table of waveforms in the layout of the scanner.

#ifndef heliosWaveformTable_h
#define heliosWaveformTable_h

#include "heliosColumn.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <string>

class vtkFieldData;
class vtkTable;

namespace helios
{

/// One row per waveform; its samples are Count values of Samples from Offset on.
struct VTKHELIOSFILTERSIO_EXPORT WaveformTable
{
  Column PulseIds, Origin, Direction, GpsTime, StartTime, BinSize, Offset, Count;
  Column Samples; ///< all samples of the table, concatenated
  vtkIdType NumberOfRows = 0;
  vtkIdType NumberOfSamples = 0;

  /// Reads the columns of a table. Returns an error: "has no array Samples". A table without rows
  /// needs no columns.
  Status Set(vtkTable* table);

  /// Returns an error about the first row with a number that is not valid: "is not valid: GpsTime of row
  /// 3 is not a finite number".
  Status CheckNumbers() const;

private:
  Status CheckNumbers(vtkIdType row) const;
  Status CheckSamples() const;
};

/// Returns an error if an array has a non-finite value or a row a bin size <= 0: which one.
Status CheckValues(vtkTable* table);

} // namespace helios

#endif
