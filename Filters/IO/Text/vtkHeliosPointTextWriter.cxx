// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointTextWriter.h"

#include "heliosColumn.h"
#include "heliosTextFormat.h"
#include "vtkHeliosArrayNames.h"

#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeliosPointTextWriter);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr double NanowattsPerWatt = 1e9;
constexpr vtkIdType TypicalRowSize = 96;

/// The columns of a block, and their formatting.
struct EchoLines
{
  helios::Column Points, Amplitude, Width, ReturnNumber, NumberOfReturns, Pulse, Part, Class, Time;
  std::vector<std::string> PartNames;

  /// Sets the names, each as one word.
  void SetPartNames(vtkStringArray* parts)
  {
    for (vtkIdType part = 0; parts && part < parts->GetNumberOfValues(); ++part)
    {
      std::string name = parts->GetValue(part);
      std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isspace(c) != 0; }, '_');
      this->PartNames.push_back(name);
    }
  }

  void AppendPart(vtkTypeInt64 part, helios::TextBuffer& text) const
  {
    const auto index = static_cast<std::size_t>(part); // a negative index is out of range
    if (index < this->PartNames.size() && !this->PartNames[index].empty())
    {
      text.Append(std::string_view(this->PartNames[index]));
    }
    else
    {
      text.AppendInteger(part);
    }
  }

  void AppendLine(vtkIdType row, helios::TextBuffer& text) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      text.AppendFixed<4>(this->Points.GetNumber(row, axis));
      text.Append(' ');
    }
    text.AppendFixed<4>(NanowattsPerWatt * this->Amplitude.GetNumber(row));
    text.Append(' ');
    text.AppendFixed<4>(this->Width.GetNumber(row));
    for (const helios::Column* column :
      { &this->ReturnNumber, &this->NumberOfReturns, &this->Pulse })
    {
      text.Append(' ');
      text.AppendInteger(column->GetInteger(row));
    }
    text.Append(' ');
    this->AppendPart(this->Part.GetInteger(row), text);
    text.Append(' ');
    text.AppendInteger(this->Class.GetInteger(row));
    text.Append(' ');
    text.AppendFixed<9>(this->Time.GetNumber(row));
    text.Append('\n');
  }
};

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPointTextWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
const char* vtkHeliosPointTextWriter::GetBlockSource() const
{
  return "the echoes of vtkHeliosScanner (output port 0)";
}

//------------------------------------------------------------------------------
bool vtkHeliosPointTextWriter::Write(vtkDataObject* block)
{
  vtkPolyData* echoes = this->CheckOpen() ? this->GetPoints(block) : nullptr;
  if (!echoes)
  {
    return false;
  }
  const vtkIdType count = echoes->GetNumberOfPoints();
  if (count == 0)
  {
    return true;
  }
  EchoLines lines;
  lines.Points = helios::Column(echoes->GetPoints()->GetData());
  lines.SetPartNames(
    vtkStringArray::SafeDownCast(echoes->GetFieldData()->GetAbstractArray(names::PartName)));
  vtkPointData* data = echoes->GetPointData();
  const bool isComplete = this->GetNumbers(data, names::Amplitude, count, 1, lines.Amplitude) &&
    this->GetNumbers(data, names::EchoWidth, count, 1, lines.Width) &&
    this->GetIntegers(data, names::ReturnNumber, count, lines.ReturnNumber) &&
    this->GetIntegers(data, names::NumberOfReturns, count, lines.NumberOfReturns) &&
    this->GetIntegers(data, names::PulseIds, count, lines.Pulse) &&
    this->GetIntegers(data, names::PartIds, count, lines.Part) &&
    this->GetIntegers(data, names::ClassificationIds, count, lines.Class) &&
    this->GetNumbers(data, names::GpsTime, count, 1, lines.Time);
  if (!isComplete)
  {
    return false;
  }
  return this->WriteRows(count, TypicalRowSize,
    [&lines](vtkIdType row, helios::TextBuffer& text) { lines.AppendLine(row, text); });
}
