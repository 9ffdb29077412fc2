// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosXyzParser.h"

#include "vtkHeliosArrayNames.h"

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

bool IsComment(const char* at, const char* end)
{
  return at != end && (*at == '#' || (*at == '/' && end - at > 1 && at[1] == '/'));
}

/// Reads a number and moves behind it. False where there is none.
bool ParseNumber(const char*& at, const char* end, double& value)
{
  const char* begin = at;
  if (begin != end && *begin == '+' && begin + 1 != end && begin[1] != '-')
  {
    ++begin;
  }
  const auto [behind, error] = std::from_chars(begin, end, value);
  at = error == std::errc() ? behind : at;
  return error == std::errc();
}

std::string ListColumns(const char* what, const int columns[3])
{
  return std::string(", ") + what + " in " + std::to_string(columns[0]) + ' ' +
    std::to_string(columns[1]) + ' ' + std::to_string(columns[2]);
}

} // namespace

XyzParser::XyzParser(const XyzFormat& format, TextReport& report)
  : Format(format)
  , Report(report)
{
  this->Classes.fill(InWord);
  for (const char c : format.Separators)
  {
    this->Classes[static_cast<unsigned char>(c)] = Separator;
    this->BlankSeparates = this->BlankSeparates || c == ' ' || c == '\t';
  }
  this->Classes[' '] = this->Classes['\t'] = Blank;
  const int xyz[3] = { 0, 1, 2 };
  this->MarkNeeded(xyz);
  if (format.HasNormals)
  {
    this->MarkNeeded(format.NormalColumns);
  }
  if (format.HasColors)
  {
    this->MarkNeeded(format.ColorColumns);
  }
  this->Values.resize(this->Needed.size());
}

void XyzParser::MarkNeeded(const int columns[3])
{
  const auto last = static_cast<std::size_t>(*std::max_element(columns, columns + 3));
  this->Needed.resize(std::max(this->Needed.size(), last + 1));
  for (int i = 0; i < 3; ++i)
  {
    this->Needed[static_cast<std::size_t>(columns[i])] = true;
  }
}

bool XyzParser::Read(XyzFile& file, std::int64_t begin, std::int64_t end)
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

const char* XyzParser::SkipBlanks(const char* at, const char* end) const
{
  while (at != end && (*at == ' ' || *at == '\t'))
  {
    ++at;
  }
  return at;
}

const char* XyzParser::SkipWord(const char* at, const char* end) const
{
  while (at != end && this->GetClass(*at) != Separator &&
    !(this->BlankSeparates && this->GetClass(*at) == Blank))
  {
    ++at;
  }
  return at;
}

// Whether a column ends at wordEnd, where next is the first character behind it that is no blank.
bool XyzParser::IsWordEnd(const char* wordEnd, const char* next, const char* end) const
{
  return next == end || this->GetClass(*next) == Separator ||
    (next != wordEnd && (this->BlankSeparates || IsComment(next, end)));
}

bool XyzParser::ReadRow(std::string_view line)
{
  const char* at = line.data();
  const char* const end = at + line.size();
  const int count = static_cast<int>(this->Needed.size());
  for (int column = 0; column < count; ++column)
  {
    at = this->SkipBlanks(at, end);
    if (at == end || IsComment(at, end))
    {
      return column == 0 || this->FailShort(column);
    }
    const char* const word = at;
    double& value = this->Values[static_cast<std::size_t>(column)];
    const bool isNeeded = this->Needed[static_cast<std::size_t>(column)];
    const bool isGood = !isNeeded || ParseNumber(at, end, value);
    const char* const wordEnd = isNeeded ? at : this->SkipWord(at, end);
    at = this->SkipBlanks(wordEnd, end);
    if (!isGood || !this->IsWordEnd(wordEnd, at, end) || (isNeeded && !std::isfinite(value)))
    {
      return this->FailNumber(line, word, column);
    }
    at += at != end && this->GetClass(*at) == Separator;
  }
  std::copy_n(this->Values.data(), 3, this->Points.Append(3));
  if (this->Format.HasNormals)
  {
    double* normal = this->Normals.Append(3);
    for (int i = 0; i < 3; ++i)
    {
      normal[i] = this->Values[static_cast<std::size_t>(this->Format.NormalColumns[i])];
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
    const double value = this->Values[static_cast<std::size_t>(column)];
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

bool XyzParser::FailShort(int columns)
{
  std::string wanted = "x y z in 0 1 2";
  wanted += this->Format.HasNormals ? ListColumns("normals", this->Format.NormalColumns) : "";
  wanted += this->Format.HasColors ? ListColumns("colours", this->Format.ColorColumns) : "";
  return this->Fail("the row has " + std::to_string(columns) +
    (columns == 1 ? " column" : " columns") + ", but columns are read up to " +
    std::to_string(this->Needed.size() - 1) + " from 0 (" + wanted +
    "); complete the row, or set what separates columns (Separators) and which are read");
}

// A first row without any number is a header, all else an error.
bool XyzParser::FailNumber(std::string_view line, const char* word, int column)
{
  if (!this->HasNumber(line) && this->IsFirstRow(this->File->GetLineStart()))
  {
    this->Report.Warn(
      this->File->GetPlace() + Quote(line) + " has no numbers; it is left out as a header");
    return true;
  }
  const char* const end = line.data() + line.size();
  const char* wordEnd = this->SkipWord(word, end);
  while (wordEnd != word && this->GetClass(wordEnd[-1]) == Blank)
  {
    --wordEnd;
  }
  const std::string_view text(word, static_cast<std::size_t>(wordEnd - word));
  const std::string place = " in column " + std::to_string(column);
  double value = 0.0;
  const char* at = word;
  if (text.empty())
  {
    return this->Fail("column " + std::to_string(column) + " is empty; write a number into it");
  }
  if (ParseNumber(at, wordEnd, value) && at == wordEnd)
  {
    return this->Fail(Quote(text) + place + " is not finite; correct the point or take it out");
  }
  return this->Fail(Quote(text) + place +
    " is not a number of double precision; write numbers such as -1.5 or 2e3, set what separates "
    "columns (Separators), and begin header lines with # or //");
}

bool XyzParser::HasNumber(std::string_view line) const
{
  const char* at = line.data();
  const char* const end = at + line.size();
  while ((at = this->SkipBlanks(at, end)) != end)
  {
    double value = 0.0;
    const char* const wordEnd = this->SkipWord(at, end);
    if (ParseNumber(at, wordEnd, value) && this->SkipBlanks(at, wordEnd) == wordEnd)
    {
      return true;
    }
    at = wordEnd + (wordEnd != end);
  }
  return false;
}

bool XyzParser::IsFirstRow(std::int64_t lineStart) const
{
  XyzFile before;
  if (!before.Open(this->File->GetPath()).empty())
  {
    return false;
  }
  before.SetRange(0, lineStart);
  std::string_view line;
  while (before.NextLine(line))
  {
    const char* const end = line.data() + line.size();
    const char* const at = this->SkipBlanks(line.data(), end);
    if (at != end && !IsComment(at, end))
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
