// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosWaveformTextWriter.h"

#include "heliosColumn.h"
#include "heliosTextFormat.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkHeliosWaveformTextWriter);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double NanowattsPerWatt = 1e9;
constexpr vtkIdType TypicalRowSize = 128; // without the samples
constexpr vtkIdType TypicalSampleSize = 13;

/// The columns of a block, and its lines.
struct WaveformLines
{
  helios::Column Pulse, Origin, Direction, Time, Start, Bin, Offset, Count, Samples;

  /// The first row whose samples are not all there; the number of rows where there is none.
  vtkIdType FindBadRow(vtkIdType rows, vtkIdType samples) const
  {
    vtkIdType row = 0;
    while (row < rows && this->HasSamples(row, samples))
    {
      ++row;
    }
    return row;
  }

  void AppendLine(vtkIdType row, helios::TextBuffer& text) const
  {
    const vtkIdType first = this->Offset.GetInteger(row);
    const vtkIdType count = this->Count.GetInteger(row);
    const double start = this->Start.GetNumber(row);
    text.AppendInteger(this->Pulse.GetInteger(row));
    for (int axis = 0; axis < 3; ++axis)
    {
      text.Append(' ');
      text.AppendFixed<4>(this->Origin.GetNumber(row, axis));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      text.Append(' ');
      text.AppendFixed<9>(this->Direction.GetNumber(row, axis));
    }
    text.Append(' ');
    text.AppendFixed<4>(start);
    text.Append(' ');
    text.AppendFixed<4>(start + static_cast<double>(count - 1) * this->Bin.GetNumber(row));
    text.Append(' ');
    text.AppendFixed<9>(this->Time.GetNumber(row));
    for (vtkIdType i = first; i < first + count; ++i)
    {
      text.Append(' ');
      text.AppendFixed<9>(NanowattsPerWatt * this->Samples.GetNumber(i));
    }
    text.Append('\n');
  }

private:
  bool HasSamples(vtkIdType row, vtkIdType samples) const
  {
    const vtkIdType first = this->Offset.GetInteger(row);
    const vtkIdType count = this->Count.GetInteger(row);
    return first >= 0 && first < samples && count >= 1 && count <= samples - first;
  }
};

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosWaveformTextWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
const char* vtkHeliosWaveformTextWriter::GetBlockSource() const
{
  return "the waveforms of vtkHeliosScanner (output port 1, with GenerateWaveforms on)";
}

//------------------------------------------------------------------------------
bool vtkHeliosWaveformTextWriter::Write(vtkDataObject* block)
{
  if (!this->CheckOpen())
  {
    return false;
  }
  auto* table = vtkTable::SafeDownCast(block);
  if (!table)
  {
    this->RefuseBlock(block, "vtkTable");
    return false;
  }
  const vtkIdType rows = table->GetNumberOfRows();
  if (rows == 0)
  {
    return true;
  }
  WaveformLines lines;
  vtkFieldData* data = table->GetRowData();
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  const vtkIdType sampleCount = samples ? samples->GetNumberOfTuples() : 0;
  const bool isComplete = this->GetIntegers(data, names::PulseIds, rows, lines.Pulse) &&
    this->GetNumbers(data, names::Origin, rows, 3, lines.Origin) &&
    this->GetNumbers(data, names::Direction, rows, 3, lines.Direction) &&
    this->GetNumbers(data, names::GpsTime, rows, 1, lines.Time) &&
    this->GetNumbers(data, names::StartTime, rows, 1, lines.Start) &&
    this->GetNumbers(data, names::BinSize, rows, 1, lines.Bin) &&
    this->GetIntegers(data, names::Offset, rows, lines.Offset) &&
    this->GetIntegers(data, names::Count, rows, lines.Count) &&
    this->GetNumbers(table->GetFieldData(), names::Samples, sampleCount, 1, lines.Samples);
  if (!isComplete)
  {
    return false;
  }
  const vtkIdType bad = lines.FindBadRow(rows, sampleCount);
  if (bad < rows)
  {
    vtkErrorMacro(<< this->GetOpenName() << ": row " << bad << " of the block has " << names::Offset
                  << " " << lines.Offset.GetInteger(bad) << " and " << names::Count << " "
                  << lines.Count.GetInteger(bad) << ", not within its " << sampleCount << " "
                  << names::Samples);
    return false;
  }
  return this->WriteRows(rows, TypicalRowSize + TypicalSampleSize * (sampleCount / rows),
    [&lines](vtkIdType row, helios::TextBuffer& text) { lines.AppendLine(row, text); });
}
