// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The lines of a waveform file in HELIOS columns, as a table.

#ifndef heliosWaveformParser_h
#define heliosWaveformParser_h

#include "heliosGrowingArray.h"
#include "heliosTextFile.h"
#include "heliosXyzFile.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkTypeInt64Array.h>

#include <cstdint>
#include <string>
#include <string_view>

class vtkTable;

namespace helios
{

/// What a line does not say.
struct WaveformFormat
{
  double TimesPerUnit = 1.0; ///< two-way times of one in the file: 2 for one-way times
  double BinSize = 0.0;      ///< [ns], two-way; 0: that of the line
};

/// Reads lines, each number of them checked.
class WaveformParser
{
public:
  WaveformParser(const WaveformFormat& format, TextReport& report)
    : Format(format)
    , Report(report)
  {
  }

  /// Adds the waveforms of the lines that start in [begin, end) of the file; false after an error.
  bool Read(XyzFile& file, std::int64_t begin, std::int64_t end);

  vtkIdType GetNumberOfWaveforms() const { return this->PulseIds.GetSize(); }

  /// Hands the columns and the samples over.
  void MoveTo(vtkTable* table);

private:
  /// The columns before the samples that are numbers.
  struct Head
  {
    double Origin[3];
    double Direction[3];
    double Start; // [ns], as the file has it
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
  XyzFile* File = nullptr;
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
