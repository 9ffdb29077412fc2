// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPulseTextWriter.h"

#include "heliosColumn.h"
#include "heliosConstants.h"
#include "heliosTextFormat.h"
#include "vtkHeliosArrayNames.h"

#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkHeliosPulseTextWriter);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr vtkIdType TypicalRowSize = 100;

/// The columns of a block, and their formatting.
struct PulseLines
{
  helios::Column Points, Direction, Time, Pulse, Channel;

  void Append(vtkIdType row, helios::TextBuffer& text) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      text.AppendFixed<4>(this->Points.GetNumber(row, axis));
      text.Append(' ');
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      text.AppendFixed<9>(this->Direction.GetNumber(row, axis));
      text.Append(' ');
    }
    text.AppendFixed<4>(helios::NanosecondsPerSecond * this->Time.GetNumber(row));
    text.Append(' ');
    text.AppendInteger(this->Pulse.GetInteger(row));
    text.Append(' ');
    text.AppendInteger(this->Channel.GetInteger(row));
    text.Append('\n');
  }
};

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPulseTextWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
const char* vtkHeliosPulseTextWriter::GetBlockSource() const
{
  return "the pulses of a vtkHeliosScanner";
}

//------------------------------------------------------------------------------
bool vtkHeliosPulseTextWriter::Write(vtkDataObject* block)
{
  vtkPolyData* pulses = this->CheckOpen() ? this->GetPoints(block) : nullptr;
  if (!pulses)
  {
    return false;
  }
  const vtkIdType count = pulses->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  PulseLines lines;
  lines.Points = helios::Column(pulses->GetPoints()->GetData());
  vtkPointData* data = pulses->GetPointData();
  return this->GetNumbers(data, names::Direction, count, 3, lines.Direction) &&
    this->GetNumbers(data, names::GpsTime, count, 1, lines.Time) &&
    this->GetIntegers(data, names::PulseIds, count, lines.Pulse) &&
    this->GetIntegers(data, names::ChannelIds, count, lines.Channel) &&
    this->WriteRows(count, TypicalRowSize,
      [&lines](vtkIdType row, helios::TextBuffer& text) { lines.Append(row, text); });
}
