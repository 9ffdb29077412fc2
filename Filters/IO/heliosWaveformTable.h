// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A table of waveforms as the scanner gives it, checked.

#ifndef heliosWaveformTable_h
#define heliosWaveformTable_h

#include "heliosColumn.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <string>

class vtkFieldData;
class vtkTable;

namespace helios
{

/// One row a waveform; its samples are Count values of Samples from Offset on.
struct VTKHELIOSFILTERSIO_EXPORT WaveformTable
{
  Column PulseIds, Origin, Direction, GpsTime, StartTime, BinSize, Offset, Count;
  Column Samples; ///< all of the table, one behind the other
  vtkIdType NumberOfRows = 0;
  vtkIdType NumberOfSamples = 0;

  /// Takes the columns of a table, or says what is wrong with it: "has no array Samples". A table
  /// without rows needs no columns.
  std::string Take(vtkTable* table);

private:
  std::string CheckSamples() const;
};

/// Says which array has a value that is not finite, or which row bins of no width; empty: none.
std::string CheckValues(vtkTable* table);

} // namespace helios

#endif
