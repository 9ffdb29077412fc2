// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPointTextFile.h"

#include "heliosTextFile.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt64Array.h>

#include <charconv>
#include <cmath>
#include <unordered_map>

namespace names = vtkHeliosArrayNames;

namespace helios::viewer
{

namespace
{

constexpr int NumberOfColumns = 11;
constexpr int PartColumn = 8;
constexpr vtkIdType BlockSize = 1 << 17;
constexpr double WattsPerNanowatt = 1e-9;

// The columns after x, y, z; the part is a name.
constexpr const char* Arrays[NumberOfColumns] = { "", "", "", names::Amplitude, names::EchoWidth,
  names::ReturnNumber, names::NumberOfReturns, names::PulseIds, names::PartIds,
  names::ClassificationIds, names::GpsTime };

struct PointRow
{
  double Values[NumberOfColumns];
  std::string_view Part;
};

/// Parses a line; returns the invalid column, or -1.
int ReadRow(std::string_view line, PointRow& row)
{
  TextWords words(line);
  for (int column = 0; column < NumberOfColumns; ++column)
  {
    if (column == PartColumn)
    {
      row.Part = words.NextName();
      row.Values[column] = 0.0;
      if (row.Part.empty())
      {
        return column;
      }
    }
    else if (words.Next(row.Values[column]) != TextWords::Number::Good ||
      !std::isfinite(row.Values[column]))
    {
      return column;
    }
  }
  return words.HasMore() ? NumberOfColumns : -1;
}

std::string DescribeFault(int column)
{
  constexpr const char* titles[] = { "x", "y", "z", "intensity", "echo width", "return number",
    "number of returns", "pulse", "part", "class", "time" };
  if (column == NumberOfColumns)
  {
    return "more columns than the 11 of the first row; remove them";
  }
  return "column " + std::to_string(column) + " (" + titles[column] +
    ") is missing or not a number; correct or remove the row";
}

bool IsEmptyLine(std::string_view line)
{
  return !TextWords(line).HasMore();
}

/// Numbers the parts.
class PartNumbers
{
public:
  explicit PartNumbers(std::vector<std::string>& texts)
    : Texts(texts)
  {
    for (std::size_t i = 0; i < texts.size(); ++i)
    {
      this->Rows.emplace(texts[i], static_cast<int>(i));
    }
  }

  int Get(std::string_view text)
  {
    int number = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    if (parsed.ec == std::errc() && parsed.ptr == end)
    {
      return number;
    }
    if (text != this->LastText)
    {
      this->LastText = text;
      const auto added = this->Rows.emplace(this->LastText, static_cast<int>(this->Texts.size()));
      if (added.second)
      {
        this->Texts.push_back(this->LastText);
      }
      this->LastRow = added.first->second;
    }
    return this->LastRow;
  }

private:
  std::vector<std::string>& Texts;
  std::unordered_map<std::string, int> Rows;
  std::string LastText;
  int LastRow = 0;
};

/// Rows collected for a vtkPolyData.
class PointBlock
{
public:
  explicit PointBlock(int leg)
    : Leg(leg)
  {
  }

  void Add(const PointRow& row)
  {
    this->Rows.insert(this->Rows.end(), row.Values, row.Values + NumberOfColumns);
  }
  vtkIdType GetSize() const { return static_cast<vtkIdType>(this->Rows.size()) / NumberOfColumns; }

  vtkSmartPointer<vtkPolyData> Take()
  {
    auto echoes = vtkSmartPointer<vtkPolyData>::New();
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    points->SetNumberOfPoints(this->GetSize());
    for (vtkIdType i = 0; i < this->GetSize(); ++i)
    {
      points->SetPoint(i, this->Rows.data() + NumberOfColumns * i);
    }
    echoes->SetPoints(points);
    for (int column = 3; column < NumberOfColumns; ++column)
    {
      const double scale = column == 3 ? WattsPerNanowatt : 1.0;
      this->AddColumn(echoes, Arrays[column], column, scale);
    }
    if (this->Leg >= 0)
    {
      vtkNew<vtkIntArray> legs;
      legs->SetName(names::LegIds);
      legs->SetNumberOfValues(this->GetSize());
      legs->FillValue(this->Leg);
      echoes->GetPointData()->AddArray(legs);
    }
    this->Rows.clear();
    return echoes;
  }

private:
  void AddColumn(vtkPolyData* echoes, const char* name, int column, double scale) const
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfValues(this->GetSize());
    for (vtkIdType i = 0; i < this->GetSize(); ++i)
    {
      array->SetValue(
        i, scale * this->Rows[static_cast<std::size_t>(NumberOfColumns * i + column)]);
    }
    echoes->GetPointData()->AddArray(array);
  }

  int Leg;
  std::vector<double> Rows;
};

} // namespace

//------------------------------------------------------------------------------
bool IsPointText(const std::string& path)
{
  TextFile file;
  std::string_view line;
  if (!file.Open(path).empty())
  {
    return false;
  }
  while (file.NextLine(line))
  {
    if (!IsEmptyLine(line))
    {
      PointRow row;
      return ReadRow(line, row) < 0;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::string ReadPointText(const std::string& path, int leg, std::vector<std::string>& partNames,
  const BlockFunction& onBlock)
{
  TextFile file;
  const std::string fault = file.Open(path);
  if (!fault.empty())
  {
    return path + ": " + fault;
  }
  double share = 0.0;
  file.OnBlock = [&share](double done)
  {
    share = done;
    return true;
  };
  PartNumbers parts(partNames);
  PointBlock block(leg);
  std::string_view line;
  while (file.NextLine(line))
  {
    PointRow row;
    if (IsEmptyLine(line))
    {
      continue;
    }
    const int column = ReadRow(line, row);
    if (column >= 0)
    {
      return file.GetPlace() + DescribeFault(column);
    }
    row.Values[PartColumn] = parts.Get(row.Part);
    block.Add(row);
    if (block.GetSize() == BlockSize && !onBlock(block.Take(), share))
    {
      return "";
    }
  }
  if (block.GetSize() > 0)
  {
    onBlock(block.Take(), 1.0);
  }
  return file.GetError();
}

} // namespace helios::viewer
