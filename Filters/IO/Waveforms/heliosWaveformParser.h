// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parses the lines of a waveform file in HELIOS columns into a table.

#ifndef heliosWaveformParser_h
#define heliosWaveformParser_h

#include "heliosGrowingArray.h"
#include "heliosLineFile.h"
#include "heliosTextFile.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkTypeInt64Array.h>

#include <cstdint>
#include <string>
#include <string_view>

class vtkTable;

namespace helios
{

/// Properties that a line does not contain.
struct WaveformFormat
{
  double TimesPerUnit = 1.0; ///< two-way time per file unit: 2 for one-way times
  double BinSize = 0.0;      ///< [ns], two-way; 0: from the line
};

/// Reads lines; every number is checked.
class WaveformParser
{
public:
  WaveformParser(const WaveformFormat& format, TextReport& report)
    : Format(format)
    , Report(report)
  {
  }

  /// Adds the waveforms of the lines that start in [begin, end) of the file; false after an error.
  bool Read(LineFile& file, std::int64_t begin, std::int64_t end);

  vtkIdType GetNumberOfWaveforms() const { return this->PulseIds.GetSize(); }

  /// Moves the columns and the samples to a table.
  void MoveTo(vtkTable* table);

private:
  /// The numeric columns before the samples.
  struct Head
  {
    double Origin[3];
    double Direction[3];
    double Start; // [ns], as in the file
    double End;
    double GpsTime;
  };

  bool ReadLine(std::string_view line);
  bool ReadPulseId(TextWords& words, std::int64_t& pulse);
  bool ReadNumber(TextWords& words, int column, double& value);
  bool ReadHead(TextWords& words, Head& head);
  bool ReadSamples(TextWords& words, vtkIdType& count);
  bool CheckDirection(Head& head);
  bool FindBinSize(const Head& head, vtkIdType count, double& binSize);
  bool Fail(const std::string& message);

  const WaveformFormat& Format;
  TextReport& Report;
  LineFile* File = nullptr;
  GrowingArray<vtkTypeInt64Array> PulseIds;
  GrowingArray<vtkDoubleArray> Origin;
  GrowingArray<vtkDoubleArray> Direction;
  GrowingArray<vtkDoubleArray> GpsTime;
  GrowingArray<vtkDoubleArray> StartTime;
  GrowingArray<vtkDoubleArray> BinSize;
  GrowingArray<vtkTypeInt64Array> Offset;
  GrowingArray<vtkTypeInt64Array> Count;
  GrowingArray<vtkFloatArray> Samples;
};

} // namespace helios

#endif
