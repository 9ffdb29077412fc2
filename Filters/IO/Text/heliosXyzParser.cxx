// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXyzParser.h"

#include "vtkHeliosArrayNames.h"

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

std::string ListColumns(const char* what, const int columns[3])
{
  return std::string(", ") + what + " in " + std::to_string(columns[0]) + ' ' +
    std::to_string(columns[1]) + ' ' + std::to_string(columns[2]);
}

} // namespace

XyzParser::XyzParser(const XyzFormat& format, TextReport& report)
  : Format(format)
  , Report(report)
  , Row(format.Separators)
{
  const int xyz[3] = { 0, 1, 2 };
  this->Need(xyz);
  if (format.HasNormals)
  {
    this->Need(format.NormalColumns);
  }
  if (format.HasColors)
  {
    this->Need(format.ColorColumns);
  }
}

void XyzParser::Need(const int columns[3])
{
  for (int i = 0; i < 3; ++i)
  {
    this->Row.Need(columns[i]);
  }
}

bool XyzParser::Read(LineFile& file, std::int64_t begin, std::int64_t end)
{
  this->File = &file;
  file.SetRange(begin, end);
  std::string_view line;
  while (file.NextLine(line))
  {
    if (!this->ReadRow(line))
    {
      return false;
    }
  }
  return file.GetError().empty() ? !file.IsStopped() : this->Report.Fail(file.GetError());
}

bool XyzParser::ReadRow(std::string_view line)
{
  const TextRow::Result result = this->Row.Read(line);
  if (result != TextRow::Good)
  {
    return result == TextRow::Empty ||
      (result == TextRow::Short ? this->FailShort() : this->FailNumber(line));
  }
  std::copy_n(this->Row.GetValues(), 3, this->Points.Append(3));
  if (this->Format.HasNormals)
  {
    double* normal = this->Normals.Append(3);
    for (int i = 0; i < 3; ++i)
    {
      normal[i] = this->Row.GetValue(this->Format.NormalColumns[i]);
    }
  }
  return !this->Format.HasColors || this->AppendColor();
}

bool XyzParser::AppendColor()
{
  float* color = this->Colors.Append(3);
  for (int i = 0; i < 3; ++i)
  {
    const int column = this->Format.ColorColumns[i];
    const double value = this->Row.GetValue(column);
    if (value < 0.0 || value > this->Format.MaximumColor)
    {
      std::string range = std::to_string(this->Format.MaximumColor);
      range.erase(range.find_last_not_of('0') + 1);
      range.erase(range.find_last_not_of('.') + 1);
      return this->Fail("the colour in column " + std::to_string(column) +
        " is not within 0 and MaximumColorValue, " + range +
        "; set MaximumColorValue, or the column of the colour");
    }
    color[i] = static_cast<float>(value / this->Format.MaximumColor);
  }
  return true;
}

bool XyzParser::Fail(const std::string& message)
{
  return this->Report.Fail(this->File->GetPlace() + message);
}

bool XyzParser::FailShort()
{
  const int columns = this->Row.GetColumn();
  std::string wanted = "x y z in 0 1 2";
  wanted += this->Format.HasNormals ? ListColumns("normals", this->Format.NormalColumns) : "";
  wanted += this->Format.HasColors ? ListColumns("colours", this->Format.ColorColumns) : "";
  return this->Fail("the row has " + std::to_string(columns) +
    (columns == 1 ? " column" : " columns") + ", but columns are read up to " +
    std::to_string(this->Row.GetNumberOfColumns() - 1) + " from 0 (" + wanted +
    "); complete the row, or set what separates columns (Separators) and which are read");
}

// A first row without any number is a header; any other is an error.
bool XyzParser::FailNumber(std::string_view line)
{
  if (!this->Row.HasNumber() && this->IsFirstRow(this->File->GetLineStart()))
  {
    this->Report.Warn(
      this->File->GetPlace() + Quote(line) + " has no numbers; it is left out as a header");
    return true;
  }
  return this->Fail(this->Row.DescribeFault("point"));
}

bool XyzParser::IsFirstRow(std::int64_t lineStart) const
{
  LineFile before;
  if (!before.Open(this->File->GetPath()).IsOk())
  {
    return false;
  }
  before.SetRange(0, lineStart);
  std::string_view line;
  while (before.NextLine(line))
  {
    if (!TextRow::IsEmpty(line))
    {
      return false;
    }
  }
  return true;
}

void XyzParser::MoveTo(vtkPolyData* cloud)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(this->Points.Finish(3));
  cloud->SetPoints(points);
  if (this->Format.HasNormals)
  {
    vtkDoubleArray* normals = this->Normals.Finish(3);
    normals->SetName(names::Normals);
    cloud->GetPointData()->SetNormals(normals);
  }
  if (this->Format.HasColors)
  {
    vtkFloatArray* colors = this->Colors.Finish(3);
    colors->SetName(names::RGB);
    cloud->GetPointData()->AddArray(colors);
  }
}

} // namespace helios
