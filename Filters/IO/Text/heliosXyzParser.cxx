// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXyzParser.h"

#include "heliosCounted.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

constexpr double LargestWhole = 9007199254740992.0; // up to it, integers are exact

struct Range
{
  double Low, High;
};

template <typename T>
constexpr Range RangeOf()
{
  return { static_cast<double>(std::numeric_limits<T>::min()),
    static_cast<double>(std::numeric_limits<T>::max()) };
}

/// Returns the valid values of an integer type.
Range GetRange(int type)
{
  switch (type)
  {
    case VTK_UNSIGNED_CHAR:
      return RangeOf<unsigned char>();
    case VTK_UNSIGNED_SHORT:
      return RangeOf<unsigned short>();
    case VTK_INT:
      return RangeOf<int>();
    default:
      return { -LargestWhole, LargestWhole };
  }
}

bool IsReal(int type)
{
  return type == VTK_DOUBLE || type == VTK_FLOAT;
}

bool IsArray(const NamedColumn& column, const char* name)
{
  return std::string_view(column.Array) == name;
}

std::string ListColumns(const char* what, const int* columns, int count, int first)
{
  std::string text = std::string(", ") + what + " in";
  for (int k = 0; k < count; ++k)
  {
    text += ' ' + std::to_string(columns[k] + first);
  }
  return text;
}

/// Returns an array in words.
const char* Describe(const NamedColumn& column)
{
  return IsArray(column, names::RGB)  ? "colours"
    : IsArray(column, names::Normals) ? "normals"
                                      : column.Array;
}

} // namespace

std::string FormatPlain(double value)
{
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  text.erase(text.find_last_not_of('.') + 1);
  return text;
}

XyzParser::XyzParser(const XyzFormat& format, TextReport& report)
  : Format(format)
  , Report(report)
  , Row(" ")
{
}

void XyzParser::SetLayout(const TextLayout& layout)
{
  this->Layout = &layout;
  this->Row = TextRow(layout.Separators);
  this->Row.SetFirstNumber(this->Format.FirstNumber);
  this->Row.SetKeepInvalid(this->Format.KeepInvalid);
  this->HasCommas = layout.Separators.find(';') != std::string::npos &&
    layout.Separators.find(',') == std::string::npos;
  for (const int column : layout.Coordinates)
  {
    this->Row.Need(column);
  }
  for (const TextColumn& column : layout.Columns)
  {
    this->Row.Need(column.Index);
    auto found = std::find_if(this->Arrays.begin(), this->Arrays.end(),
      [&column](const Values& values) { return IsArray(values.Column, column.Column.Array); });
    if (found == this->Arrays.end())
    {
      this->Arrays.emplace_back();
      found = this->Arrays.end() - 1;
      found->Column = column.Column;
    }
    found->Indices[column.Column.Component] = column.Index;
  }
}

bool XyzParser::Read(
  LineFile& file, const TextScan& scan, std::int64_t begin, std::int64_t end, vtkIdType maximum)
{
  this->File = &file;
  this->Scan = &scan;
  file.SetRange(std::max(begin, scan.Begin), std::min(end, scan.End));
  std::string_view line;
  while ((maximum <= 0 || this->GetNumberOfPoints() < maximum) && file.NextLine(line))
  {
    if (!this->ReadRow(this->HasCommas ? this->GetPlain(line) : line))
    {
      return false;
    }
  }
  return file.GetError().empty() ? !file.IsStopped() : this->Report.Fail(file.GetError());
}

// Returns a line with plain numbers: between semicolons, a comma in a number is its point.
std::string_view XyzParser::GetPlain(std::string_view line)
{
  if (line.find(',') == std::string_view::npos)
  {
    return line;
  }
  this->Plain = line;
  std::replace(this->Plain.begin(), this->Plain.end(), ',', '.');
  return this->Plain;
}

bool XyzParser::ReadRow(std::string_view line)
{
  const TextRow::Result result = this->Row.Read(line);
  if (result != TextRow::Good)
  {
    return result == TextRow::Empty || this->ReadCount(result) ||
      (result == TextRow::Short ? this->FailShort() : this->Fail(this->Row.DescribeFault("point")));
  }
  if (this->IsDropped())
  {
    ++this->NumberOfDropped;
    return true;
  }
  this->AppendPoint();
  for (Values& values : this->Arrays)
  {
    if (!this->AppendValues(values))
    {
      return false;
    }
  }
  return true;
}

/// Skips a line with a number of points, before the points of each scan of a PTS file.
bool XyzParser::ReadCount(TextRow::Result result)
{
  const double count = this->Row.GetValue(0);
  const bool isCount = this->Layout->HasCounts() && result == TextRow::Short &&
    this->Row.GetColumn() == 1 && count >= 0.0 && std::trunc(count) == count;
  this->NumberOfCounted += isCount ? count : 0.0;
  return isCount;
}

/// Returns whether a point is dropped. PTX has a point 0 0 0 for each pulse without a return.
bool XyzParser::IsDropped() const
{
  const int* columns = this->Layout->Coordinates;
  return this->Scan->HasMatrix && this->Row.GetValue(columns[0]) == 0.0 &&
    this->Row.GetValue(columns[1]) == 0.0 && this->Row.GetValue(columns[2]) == 0.0;
}

void XyzParser::AppendPoint()
{
  double* point = this->Points.Append(3);
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] = this->Row.GetValue(this->Layout->Coordinates[axis]);
  }
  if (this->Scan->HasMatrix)
  {
    const double local[3] = { point[0], point[1], point[2] };
    for (int axis = 0; axis < 3; ++axis)
    {
      const double* row = this->Scan->Matrix + 4 * axis;
      point[axis] = row[0] * local[0] + row[1] * local[1] + row[2] * local[2] + row[3];
    }
  }
}

bool XyzParser::AppendValues(Values& values)
{
  const int count = values.Column.Components;
  double* numbers = values.Numbers.Append(count);
  for (int k = 0; k < count; ++k)
  {
    numbers[k] = this->Row.GetValue(values.Indices[k]) + values.Column.Offset;
    if (!this->CheckValue(values, k, numbers[k]))
    {
      return false;
    }
  }
  return true;
}

bool XyzParser::CheckValue(const Values& values, int component, double value)
{
  const int column = values.Indices[component];
  if (values.Column.Type == VTK_FLOAT)
  {
    return !(value < 0.0 || value > this->Format.MaximumColor) || this->FailColor(column);
  }
  const Range range = GetRange(values.Column.Type);
  return IsReal(values.Column.Type) ||
    (std::trunc(value) == value && value >= range.Low && value <= range.High) ||
    this->Fail(FormatPlain(value) + " in column " +
      std::to_string(column + this->Format.FirstNumber) + " (" + values.Column.Array +
      ") is not a whole number from " + FormatPlain(range.Low) + " to " + FormatPlain(range.High) +
      "; correct or remove the row");
}

bool XyzParser::FailColor(int column)
{
  return this->Fail("the colour in column " + std::to_string(column + this->Format.FirstNumber) +
    " is not within 0 and " + this->Format.ColorCure);
}

bool XyzParser::Fail(const std::string& message)
{
  return this->Report.Fail(this->File->GetPlace() + message);
}

bool XyzParser::FailShort()
{
  const int columns = this->Row.GetColumn();
  const int first = this->Format.FirstNumber;
  std::string wanted = ListColumns("x y z", this->Layout->Coordinates, 3, first).substr(2);
  for (const Values& values : this->Arrays)
  {
    wanted += ListColumns(Describe(values.Column), values.Indices, values.Column.Components, first);
  }
  return this->Fail("the row has " + Counted(columns, "column") + ", but columns are read up to " +
    std::to_string(this->Row.GetNumberOfColumns() - 1 + first) + " from " + std::to_string(first) +
    " (" + wanted +
    "); complete the row, or set what separates columns (Separators) and which are read");
}

void XyzParser::MoveTo(vtkPolyData* cloud)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(this->Points.Finish(3));
  cloud->SetPoints(points);
  for (Values& values : this->Arrays)
  {
    if (values.Column.Type == VTK_FLOAT)
    {
      std::for_each(values.Numbers.GetValues(),
        values.Numbers.GetValues() + values.Numbers.GetSize(),
        [full = this->Format.MaximumColor](double& value) { value /= full; });
    }
    vtkSmartPointer<vtkDataArray> array = values.Numbers.Finish(values.Column.Components);
    if (values.Column.Type != VTK_DOUBLE)
    {
      const vtkSmartPointer<vtkDataArray> numbers = array;
      array.TakeReference(vtkDataArray::CreateDataArray(values.Column.Type));
      array->DeepCopy(numbers);
    }
    array->SetName(values.Column.Array);
    cloud->GetPointData()->AddArray(array);
    if (IsArray(values.Column, names::Normals))
    {
      cloud->GetPointData()->SetNormals(array);
    }
  }
}

} // namespace helios
