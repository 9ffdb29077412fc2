// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosPointTextWriter.h"

#include "heliosColumn.h"
#include "heliosCoordinateSystem.h"
#include "heliosPointColumns.h"
#include "heliosSceneCrs.h"
#include "heliosTextFormat.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHeliosPointTextWriter);

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr vtkIdType TypicalRowSize = 96;

using BasicColumns = std::make_integer_sequence<int, helios::NumberOfBasicColumns>;
using FlagColumns = std::make_integer_sequence<int, helios::NumberOfFlagColumns>;
using AllColumns = std::make_integer_sequence<int, helios::NumberOfPointColumns>;

/// The columns of a block, and their formatting.
struct EchoLines
{
  helios::Column Columns[helios::NumberOfPointColumns]; // x, y and z: the points
  std::vector<std::string> PartNames;
  bool IsFine[3] = { false, false, false }; // coordinates need 9 decimals

  /// Coordinates of degrees, and of files with finer steps than 0.1 mm.
  void SetDecimals(vtkPolyData* points)
  {
    constexpr double coarse = 0.99e-4; // within 4 decimals
    const std::string text = helios::GetCRS(points);
    helios::CoordinateSystem system;
    if (!text.empty())
    {
      static_cast<void>(system.Set(text)); // an unknown one has metres
    }
    const helios::CoordinateSteps steps = helios::GetCoordinateSteps(points);
    for (int axis = 0; axis < 3; ++axis)
    {
      this->IsFine[axis] =
        std::min(helios::GetResolution(system, axis), steps.Scale[axis]) < coarse;
    }
  }

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

  template <int Index>
  void AppendColumn(vtkIdType row, helios::TextBuffer& text) const
  {
    constexpr helios::PointColumn column = helios::PointColumns[Index];
    constexpr int axis = Index < helios::FirstArrayColumn ? Index : 0;
    if constexpr (Index < helios::FirstArrayColumn)
    {
      const double value = this->Columns[Index].GetNumber(row, axis);
      this->IsFine[axis] ? text.AppendFixed<9>(value) : text.AppendFixed<column.Decimals>(value);
    }
    else if constexpr (column.Decimals > 0)
    {
      text.AppendFixed<column.Decimals>(column.Factor * this->Columns[Index].GetNumber(row, axis));
    }
    else if constexpr (Index == helios::PartColumn)
    {
      this->AppendPart(this->Columns[Index].GetInteger(row), text);
    }
    else
    {
      text.AppendInteger(this->Columns[Index].GetInteger(row));
    }
  }

  template <int... Indices>
  void AppendLine(
    vtkIdType row, helios::TextBuffer& text, std::integer_sequence<int, Indices...>) const
  {
    ((this->AppendColumn<Indices>(row, text),
       text.Append(Indices + 1 < static_cast<int>(sizeof...(Indices)) ? ' ' : '\n')),
      ...);
  }
};

/// Adds the arrays without which a block cannot be written.
void AddMissing(vtkPointData* data, int columns, vtkIdType count)
{
  for (int i = helios::FirstArrayColumn; i < columns; ++i)
  {
    const helios::PointColumn& column = helios::PointColumns[i];
    if (!data->HasArray(column.Array))
    {
      const auto array =
        vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(column.Type));
      array->SetName(column.Array);
      array->SetNumberOfTuples(count);
      array->Fill(column.Default);
      data->AddArray(array);
    }
  }
}

} // namespace

//------------------------------------------------------------------------------
void vtkHeliosPointTextWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FillMissing: " << this->FillMissing << "\n"
     << indent << "WriteScanFlags: " << this->WriteScanFlags << "\n"
     << indent << "WriteDecibels: " << this->WriteDecibels << "\n";
}

//------------------------------------------------------------------------------
const char* vtkHeliosPointTextWriter::GetBlockSource() const
{
  return "the echoes of vtkHeliosScanner (output port 0)";
}

//------------------------------------------------------------------------------
int vtkHeliosPointTextWriter::GetNumberOfArrays()
{
  return helios::NumberOfBasicColumns - helios::FirstArrayColumn;
}

//------------------------------------------------------------------------------
const char* vtkHeliosPointTextWriter::GetArrayName(int index)
{
  const bool isValid = index >= 0 && index < vtkHeliosPointTextWriter::GetNumberOfArrays();
  return isValid ? helios::PointColumns[helios::FirstArrayColumn + index].Array : nullptr;
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
  const int columns = this->WriteDecibels ? helios::NumberOfPointColumns
    : this->WriteScanFlags                ? helios::NumberOfFlagColumns
                                          : helios::NumberOfBasicColumns;
  EchoLines lines;
  lines.SetDecimals(echoes);
  lines.SetPartNames(
    vtkStringArray::SafeDownCast(echoes->GetFieldData()->GetAbstractArray(names::PartName)));
  vtkNew<vtkPointData> data;
  data->ShallowCopy(echoes->GetPointData());
  if (this->FillMissing)
  {
    AddMissing(data, columns, count);
  }
  for (int i = 0; i < columns; ++i)
  {
    const helios::PointColumn& column = helios::PointColumns[i];
    helios::Column& read = lines.Columns[i];
    if (i < helios::FirstArrayColumn)
    {
      read = helios::Column(echoes->GetPoints()->GetData());
    }
    else if (!(column.Decimals > 0 ? this->GetNumbers(data, column.Array, count, 1, read)
                                   : this->GetIntegers(data, column.Array, count, read)))
    {
      return false;
    }
  }
  return this->WriteRows(count, TypicalRowSize,
    [&lines, columns](vtkIdType row, helios::TextBuffer& text)
    {
      switch (columns)
      {
        case helios::NumberOfPointColumns:
          return lines.AppendLine(row, text, AllColumns());
        case helios::NumberOfFlagColumns:
          return lines.AppendLine(row, text, FlagColumns());
        default:
          return lines.AppendLine(row, text, BasicColumns());
      }
    });
}
