// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorReport.h"

#include "heliosLineFile.h"
#include "heliosTextRow.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string_view>
#include <vector>

namespace helios
{

namespace
{

constexpr double MinutesPerDegree = 60.0;
constexpr double LargestError = 1e6; // [m, arc minutes]; squares of larger ones may overflow
constexpr const char* Names[6] = { "EastPositionRMS", "NorthPositionRMS", "DownPositionRMS",
  "PitchRMS", "RollRMS", "HeadingRMS" };
constexpr std::size_t BinaryColumns[6] = { 2, 1, 3, 8, 7, 9 };

using Record = std::array<double, 10>;

/// Adds the squares of a row; an error for a number that is no RMS.
Status AddRow(const std::array<double, 6>& row, const std::string& place, ErrorReport& report)
{
  for (std::size_t k = 0; k < 6; ++k)
  {
    if (!(row[k] >= 0.0 && row[k] <= LargestError))
    {
      std::ostringstream text;
      text << place << Names[k] << " is " << row[k]
           << ", not from 0 to 1e6; give RMS errors, or remove the row";
      return Status::Error(text.str());
    }
    report.Squares[k] += row[k] * row[k];
  }
  ++report.Rows;
  return {};
}

std::string_view Trim(std::string_view text)
{
  constexpr std::string_view edges = " \t\"";
  text.remove_prefix(std::min(text.find_first_not_of(edges), text.size()));
  return text.substr(0, text.find_last_not_of(edges) + 1);
}

/// Returns the columns of the header; the name of one that is missing, or null.
const char* FindColumns(std::string_view header, std::array<int, 6>& columns)
{
  columns.fill(-1);
  for (int column = 0; !header.empty(); ++column)
  {
    const std::size_t comma = std::min(header.find(','), header.size());
    const auto found = std::find(Names, Names + 6, Trim(header.substr(0, comma)));
    if (found != Names + 6)
    {
      columns[static_cast<std::size_t>(found - Names)] = column;
    }
    header.remove_prefix(std::min(comma + 1, header.size()));
  }
  const auto missing = std::find(columns.begin(), columns.end(), -1);
  return missing == columns.end() ? nullptr : Names[missing - columns.begin()];
}

Status CheckRows(const std::string& path, const ErrorReport& report)
{
  return report.Rows > 0 ? Status()
                         : Status::Error(path +
                             ": has no rows; give an error report with a header and rows of RMS "
                             "errors");
}

} // namespace

//------------------------------------------------------------------------------
double ErrorReport::GetRMS(std::size_t component) const
{
  const double unit = component < 3 ? 1.0 : 1.0 / MinutesPerDegree;
  return this->Rows > 0
    ? unit * std::sqrt(this->Squares[component] / static_cast<double>(this->Rows))
    : 0.0;
}

//------------------------------------------------------------------------------
Status ErrorReport::ReadText(const std::string& path)
{
  LineFile file;
  if (Status status = file.Open(path); !status.IsOk())
  {
    return status;
  }
  file.SetRange(0, file.GetSize());
  TextRow row(",");
  std::array<int, 6> columns{};
  bool hasHeader = false;
  std::string_view line;
  while (file.NextLine(line))
  {
    if (TextRow::IsEmpty(line))
    {
      continue;
    }
    if (!hasHeader)
    {
      if (const char* missing = FindColumns(line, columns))
      {
        return Status::Error(file.GetPlace() + "the header does not name " + missing +
          "; give a first line with the names of the columns, such as \"GpsTime\","
          "\"NorthPositionRMS\"");
      }
      std::for_each(columns.begin(), columns.end(), [&row](int column) { row.Need(column); });
      hasHeader = true;
      continue;
    }
    const TextRow::Result result = row.Read(line);
    if (result == TextRow::Short)
    {
      return Status::Error(file.GetPlace() + "the row has " + std::to_string(row.GetColumn()) +
        " columns, fewer than the header; complete or remove it");
    }
    if (result != TextRow::Good)
    {
      return Status::Error(file.GetPlace() + row.DescribeFault("row"));
    }
    std::array<double, 6> values{};
    std::transform(columns.begin(), columns.end(), values.begin(),
      [&row](int column) { return row.GetValue(column); });
    if (Status status = AddRow(values, file.GetPlace(), *this); !status.IsOk())
    {
      return status;
    }
  }
  return file.GetError().empty() ? CheckRows(path, *this) : Status::Error(file.GetError());
}

//------------------------------------------------------------------------------
Status ErrorReport::ReadBinary(const std::string& path)
{
  InputFile file;
  std::int64_t size = 0;
  if (Status status = OpenInput(path, file, size); !status.IsOk())
  {
    return status;
  }
  if (size % static_cast<std::int64_t>(sizeof(Record)) != 0)
  {
    return Status::Error(path + ": has " + std::to_string(size) +
      " bytes, no whole number of records of 80 bytes; copy the complete file again");
  }
  Record record{};
  while (std::fread(record.data(), sizeof record, 1, file.get()) == 1)
  {
    std::array<double, 6> values{};
    std::transform(std::begin(BinaryColumns), std::end(BinaryColumns), values.begin(),
      [&record](std::size_t column) { return record[column]; });
    const std::string place = path + ", record " + std::to_string(this->Rows) + ": ";
    if (Status status = AddRow(values, place, *this); !status.IsOk())
    {
      return status;
    }
  }
  return CheckRows(path, *this);
}

} // namespace helios
