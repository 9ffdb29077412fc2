// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosWaveformTextWriter.h"

#include "heliosConstants.h"
#include "heliosStatus.h"
#include "heliosTextFormat.h"
#include "heliosWaveformTable.h"

#include <vtkObjectFactory.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkHeliosWaveformTextWriter);

namespace
{

constexpr vtkIdType TypicalRowSize = 128; // without the samples
constexpr vtkIdType TypicalSampleSize = 13;

void AppendLine(const helios::WaveformTable& table, vtkIdType row, helios::TextBuffer& text)
{
  const vtkIdType first = table.Offset.GetInteger(row);
  const vtkIdType count = table.Count.GetInteger(row);
  const double start = table.StartTime.GetNumber(row);
  text.AppendInteger(table.PulseIds.GetInteger(row));
  for (int axis = 0; axis < 3; ++axis)
  {
    text.Append(' ');
    text.AppendFixed<4>(table.Origin.GetNumber(row, axis));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    text.Append(' ');
    text.AppendFixed<9>(table.Direction.GetNumber(row, axis));
  }
  text.Append(' ');
  text.AppendFixed<4>(start);
  text.Append(' ');
  text.AppendFixed<4>(start + static_cast<double>(count - 1) * table.BinSize.GetNumber(row));
  text.Append(' ');
  text.AppendFixed<9>(table.GpsTime.GetNumber(row));
  for (vtkIdType i = first; i < first + count; ++i)
  {
    text.Append(' ');
    text.AppendFixed<9>(helios::NanowattsPerWatt * table.Samples.GetNumber(i));
  }
  text.Append('\n');
}

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
  helios::WaveformTable waveforms;
  const helios::Status status = waveforms.Set(table);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< this->GetOpenName() << ": the block " << status.Message() << "; write "
                  << this->GetBlockSource());
    return false;
  }
  const vtkIdType rows = waveforms.NumberOfRows;
  return rows == 0 ||
    this->WriteRows(rows, TypicalRowSize + TypicalSampleSize * (waveforms.NumberOfSamples / rows),
      [&waveforms](vtkIdType row, helios::TextBuffer& text) { AppendLine(waveforms, row, text); });
}
