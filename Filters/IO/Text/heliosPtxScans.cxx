// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCounted.h"
#include "heliosTextFile.h"
#include "heliosTextLayout.h"

namespace helios
{

namespace
{

constexpr int MaximumPtxLines = 10; // lines of the header of a scan

/// Reads the lines of a PTX file.
class PtxFinder
{
public:
  PtxFinder(LineFile& file, TextLayout& layout, TextReport& report)
    : File(file)
    , Layout(layout)
    , Report(report)
  {
  }

  Status Find()
  {
    this->File.SetRange(0, this->File.GetSize());
    while (this->NextLine())
    {
      TextScan scan;
      std::int64_t count = 0;
      if (Status status = this->ReadHeader(scan, count); !status.IsOk())
      {
        return status;
      }
      this->SkipRows(scan, count);
      this->Layout.Scans.push_back(scan);
    }
    return this->File.GetError().empty() ? Status() : Status::Error(this->File.GetError());
  }

private:
  /// Reads the next line that is not empty.
  bool NextLine()
  {
    do
    {
      if (!this->File.NextLine(this->Line))
      {
        return false;
      }
    } while (this->Line.find_first_not_of(" \t") == std::string_view::npos);
    return true;
  }

  Status ReadHeader(TextScan& scan, std::int64_t& count)
  {
    double numbers[MaximumPtxLines][4] = {};
    const int columns[MaximumPtxLines] = { 1, 1, 3, 3, 3, 3, 4, 4, 4, 4 };
    for (int i = 0; i < MaximumPtxLines; ++i)
    {
      if ((i > 0 && !this->NextLine()) || !this->ReadNumbers(numbers[i], columns[i]))
      {
        return Status::Error(this->File.GetPlace() + "line " + std::to_string(i + 1) +
          " of the header of scan " + std::to_string(this->Layout.Scans.size() + 1) + " has not " +
          Counted(columns[i], "number") +
          "; PTX has columns, rows, four lines of 3 and four of 4 numbers before the points: is "
          "the "
          "scan before it complete?");
      }
    }
    const double size = numbers[0][0] * numbers[1][0];
    if (!(numbers[0][0] >= 0.0) || !(numbers[1][0] >= 0.0) || !(size <= 1e15))
    {
      return Status::Error(this->File.GetPlace() + "the header of scan " +
        std::to_string(this->Layout.Scans.size() + 1) +
        " gives no valid numbers of columns and rows; correct them");
    }
    count = static_cast<std::int64_t>(size);
    scan.HasMatrix = true;
    for (int i = 0; i < 4; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        scan.Matrix[4 * k + i] = numbers[6 + i][k]; // PTX multiplies rows
      }
    }
    return {};
  }

  bool ReadNumbers(double* values, int count)
  {
    TextWords words(this->Line);
    for (int i = 0; i < count; ++i)
    {
      if (words.Next(values[i]) != TextWords::Number::Good)
      {
        return false;
      }
    }
    return !words.HasMore();
  }

  void SkipRows(TextScan& scan, std::int64_t count)
  {
    scan.Begin = scan.End = this->File.GetNextLine();
    std::int64_t done = 0;
    while (done < count && this->NextLine())
    {
      if (done == 0 && this->Layout.NumberOfColumns == 0)
      {
        this->SetColumns(static_cast<int>(SplitColumns(this->Line, " \t").size()));
      }
      ++done;
      scan.End = this->File.GetNextLine();
    }
    if (done < count)
    {
      this->Report.Warn(this->File.GetPath() + ": scan " +
        std::to_string(this->Layout.Scans.size() + 1) + " has " + std::to_string(done) +
        " of its " + std::to_string(count) + " points; it is cut off: copy it again");
    }
  }

  void SetColumns(int count)
  {
    this->Layout.NumberOfColumns = count;
    if (count >= 4)
    {
      this->Layout.Columns.push_back({ 3, FindNamedColumn("intensity") });
    }
    for (int k = 0; k < 3 && count >= 7; ++k)
    {
      this->Layout.Columns.push_back({ 4 + k, FindNamedColumn(std::string(1, "rgb"[k])) });
    }
  }

  LineFile& File;
  TextLayout& Layout;
  TextReport& Report;
  std::string_view Line;
};

} // namespace

Status FindPtxScans(LineFile& file, TextLayout& layout, TextReport& report)
{
  return PtxFinder(file, layout, report).Find();
}

} // namespace helios
