// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosWaveformTextWriter.h"

#include "heliosTextFormat.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkTable.h>

vtkStandardNewMacro(vtkHeliosWaveformTextWriter);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double NanowattsPerWatt = 1e9;

template <int Decimals>
void AppendTuple(helios::TextBuffer& text, vtkDataArray* array, vtkIdType row)
{
  for (int component = 0; component < array->GetNumberOfComponents(); ++component)
  {
    text.Append(' ');
    text.AppendFixed<Decimals>(array->GetComponent(row, component));
  }
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosWaveformTextWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
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
    vtkErrorMacro(<< this->FileName << ": a block is not a vtkTable");
    return false;
  }
  vtkFieldData* rows = table->GetRowData();
  vtkDataArray* pulses = this->GetArray(rows, names::PulseIds, 1);
  vtkDataArray* origins = this->GetArray(rows, names::Origin, 3);
  vtkDataArray* directions = this->GetArray(rows, names::Direction, 3);
  vtkDataArray* times = this->GetArray(rows, names::GpsTime, 1);
  vtkDataArray* starts = this->GetArray(rows, names::StartTime, 1);
  vtkDataArray* bins = this->GetArray(rows, names::BinSize, 1);
  vtkDataArray* offsets = this->GetArray(rows, names::Offset, 1);
  vtkDataArray* counts = this->GetArray(rows, names::Count, 1);
  vtkDataArray* samples = this->GetArray(table->GetFieldData(), names::Samples, 1);
  if (!pulses || !origins || !directions || !times || !starts || !bins || !offsets || !counts ||
    !samples)
  {
    return false;
  }
  return this->WriteRows(table->GetNumberOfRows(),
    [=](vtkIdType row, helios::TextBuffer& text)
    {
      const auto first = static_cast<vtkIdType>(offsets->GetComponent(row, 0));
      const auto count = static_cast<vtkIdType>(counts->GetComponent(row, 0));
      const double start = starts->GetComponent(row, 0);
      text.AppendInteger(static_cast<std::int64_t>(pulses->GetComponent(row, 0)));
      AppendTuple<4>(text, origins, row);
      AppendTuple<9>(text, directions, row);
      text.Append(' ');
      text.AppendFixed<4>(start);
      text.Append(' ');
      text.AppendFixed<4>(start + static_cast<double>(count - 1) * bins->GetComponent(row, 0));
      AppendTuple<9>(text, times, row);
      for (vtkIdType i = first; i < first + count; ++i)
      {
        text.Append(' ');
        text.AppendFixed<9>(NanowattsPerWatt * samples->GetComponent(i, 0));
      }
      text.Append('\n');
    });
}
