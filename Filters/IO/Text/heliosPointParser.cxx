// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPointParser.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace helios
{

namespace
{

struct Limits
{
  vtkTypeInt64 Low, High;
};

template <typename T>
constexpr Limits LimitsOf()
{
  return { std::numeric_limits<T>::min(), std::numeric_limits<T>::max() };
}

Limits GetLimits(int type)
{
  return type == VTK_UNSIGNED_CHAR ? LimitsOf<unsigned char>()
    : type == VTK_INT              ? LimitsOf<int>()
                                   : LimitsOf<vtkTypeInt64>();
}

/// Returns whether only a comment follows, which begins with # or //.
bool IsAtEnd(TextWords words)
{
  return !words.HasMore() || words.Rest().substr(0, 2) == "//";
}

/// Counts the columns of a row from the name of a part on, which may begin with #; 0 if other words
/// than numbers follow.
int CountFromPart(TextWords words)
{
  double number = 0.0;
  int count = words.NextName().empty() ? 0 : 1;
  for (; count > 0 && !IsAtEnd(words); ++count)
  {
    if (words.Next(number) != TextWords::Number::Good)
    {
      return 0;
    }
  }
  return count;
}

template <typename ArrayT, typename T>
void AddArray(vtkPointData* data, const char* name, const std::vector<T>& values)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::transform(values.begin(), values.end(), array->GetPointer(0),
    [](T value) { return static_cast<typename ArrayT::ValueType>(value); });
  data->AddArray(array);
}

} // namespace

int CountColumns(std::string_view row)
{
  TextWords words(row);
  int count = 0;
  for (; !IsAtEnd(words); ++count)
  {
    words.NextName();
  }
  const int all = count + CountFromPart(words); // the name of a part may look like a comment
  return count == PartColumn && GetColumnsToRead(all) == all ? all : count;
}

PointParser::PointParser(int columns, bool keepInvalid, PartNumbers& parts, TextReport& report)
  : Columns(columns)
  , KeepInvalid(keepInvalid)
  , Parts(parts)
  , Report(report)
{
}

bool PointParser::Read(LineFile& file, vtkIdType maximum)
{
  this->File = &file;
  std::string_view line;
  while ((maximum <= 0 || this->GetNumberOfPoints() < maximum) && file.NextLine(line))
  {
    if (!this->ReadRow(line))
    {
      return false;
    }
  }
  return file.GetError().empty() ? !file.IsStopped() : this->Report.Fail(file.GetError());
}

bool PointParser::ReadRow(std::string_view line)
{
  TextWords words(line);
  if (IsAtEnd(words))
  {
    return true;
  }
  this->Line = line;
  if (line.find('\0') != std::string_view::npos)
  {
    return this->Fail("has zero bytes, so it is not valid text: it is damaged, copy it again");
  }
  const int count = GetColumnsToRead(this->Columns);
  for (int column = 0; column < count; ++column)
  {
    const bool isRead = PointColumns[column].Decimals > 0 ? this->ReadReal(words, column)
      : column == PartColumn                              ? this->ReadPart(words)
                                                          : this->ReadInteger(words, column);
    if (!isRead)
    {
      return false;
    }
  }
  return count == FirstArrayColumn || IsAtEnd(words) || this->FailColumns();
}

bool PointParser::ReadReal(TextWords& words, int column)
{
  double value = 0.0;
  const TextWords word = words;
  if (words.Next(value) != TextWords::Number::Good)
  {
    return this->FailWord(word, column, "not a number");
  }
  if (!this->KeepInvalid && !std::isfinite(value))
  {
    return this->FailWord(word, column, "not finite");
  }
  this->Reals[column].push_back(1.0 / PointColumns[column].Factor * value);
  return true;
}

bool PointParser::ReadInteger(TextWords& words, int column)
{
  std::int64_t value = 0;
  const TextWords word = words;
  double real = 0.0;
  if (words.Next(value) != TextWords::Number::Good && words.Next(real) != TextWords::Number::Good)
  {
    return this->FailWord(word, column, "not a number");
  }
  constexpr double largest = 9007199254740992.0; // up to it, integers are exact
  const bool isWhole = std::abs(real) <= largest && std::trunc(real) == real;
  value = real != 0.0 && isWhole ? static_cast<std::int64_t>(real) : value;
  const Limits limits = GetLimits(PointColumns[column].Type);
  if (!isWhole || value < limits.Low || value > limits.High)
  {
    return this->FailWord(word, column,
      "not a whole number from " + std::to_string(limits.Low) + " to " +
        std::to_string(limits.High));
  }
  this->Integers[column].push_back(value);
  return true;
}

bool PointParser::ReadPart(TextWords& words)
{
  if (IsAtEnd(words) && words.Rest().empty())
  {
    return this->FailColumns();
  }
  this->Integers[PartColumn].push_back(this->Parts.Get(words.NextName()));
  return true;
}

bool PointParser::FailWord(TextWords words, int column, const std::string& problem)
{
  if (IsAtEnd(words))
  {
    return this->FailColumns();
  }
  return this->Fail(Quote(words.NextName()) + " in column " + std::to_string(column + 1) + " (" +
    PointColumns[column].Title + ") is " + problem + "; correct or remove the row");
}

bool PointParser::FailColumns()
{
  return this->Fail("has " + std::to_string(CountColumns(this->Line)) +
    " columns, but the first row has " + std::to_string(this->Columns) +
    "; correct or remove the row");
}

bool PointParser::Fail(const std::string& problem)
{
  return this->Report.Fail((this->File ? this->File->GetPlace() : "") + problem);
}

void PointParser::MoveTo(vtkPolyData* cloud)
{
  const auto count = static_cast<std::size_t>(this->GetNumberOfPoints());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(this->GetNumberOfPoints());
  for (std::size_t i = 0; i < count; ++i)
  {
    points->SetPoint(
      static_cast<vtkIdType>(i), this->Reals[0][i], this->Reals[1][i], this->Reals[2][i]);
  }
  cloud->SetPoints(points);
  vtkPointData* data = cloud->GetPointData();
  for (int column = FirstArrayColumn; column < GetColumnsToRead(this->Columns); ++column)
  {
    const PointColumn& c = PointColumns[column];
    switch (c.Type)
    {
      case VTK_DOUBLE:
        AddArray<vtkDoubleArray>(data, c.Array, this->Reals[column]);
        break;
      case VTK_UNSIGNED_CHAR:
        AddArray<vtkUnsignedCharArray>(data, c.Array, this->Integers[column]);
        break;
      case VTK_INT:
        AddArray<vtkIntArray>(data, c.Array, this->Integers[column]);
        break;
      default:
        AddArray<vtkTypeInt64Array>(data, c.Array, this->Integers[column]);
    }
  }
}

} // namespace helios
