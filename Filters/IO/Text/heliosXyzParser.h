// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parses the rows of a text file of points.

#ifndef heliosXyzParser_h
#define heliosXyzParser_h

#include "heliosGrowingArray.h"
#include "heliosLineFile.h"
#include "heliosTextFile.h"
#include "heliosTextLayout.h"
#include "heliosTextRow.h"

#include <vtkDoubleArray.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

class vtkPolyData;

namespace helios
{

/// The range of numbers that are finite.
struct NumberRange
{
  double Low = 0.0; ///< 0 without any
  double High = 0.0;
  bool IsWhole = true;
  bool IsEmpty = true;

  void Add(double value)
  {
    if (std::isfinite(value))
    {
      this->Low = this->IsEmpty ? value : std::min(this->Low, value);
      this->High = this->IsEmpty ? value : std::max(this->High, value);
      this->IsWhole = this->IsWhole && std::trunc(value) == value;
      this->IsEmpty = false;
    }
  }
};

/// Formats a number without exponent and without zeros at its end.
std::string FormatPlain(double value);

/// Columns that are read from a row, in addition to its layout.
struct XyzFormat
{
  double MaximumColor = 255.0;
  std::string ColorCure; ///< for messages about colours that are not within it
  int FirstNumber = 0;   ///< number of the first column, for messages
  bool KeepInvalid = false;
};

/// Reads rows of x, y, z and the columns of a layout; every number used is checked.
class XyzParser
{
public:
  XyzParser(const XyzFormat& format, TextReport& report);

  /// Sets the layout of the next lines, which exists until they are read; its columns are of the same
  /// arrays as those before.
  void SetLayout(const TextLayout& layout);

  /// Adds the points of the lines that start in [begin, end) of a scan of the file, at most a number
  /// of them if positive; false after an error.
  bool Read(LineFile& file, const TextScan& scan, std::int64_t begin, std::int64_t end,
    vtkIdType maximum = 0);

  vtkIdType GetNumberOfPoints() const { return this->Points.GetSize() / 3; }
  /// Returns the points of PTX without a return, which are not read.
  vtkIdType GetNumberOfDropped() const { return this->NumberOfDropped; }
  /// Returns the sum of the numbers of points in lines of their own.
  double GetNumberOfCounted() const { return this->NumberOfCounted; }

  /// Moves the points and their arrays to a cloud.
  void MoveTo(vtkPolyData* cloud);

private:
  /// The values of an array, of which the columns are the components.
  struct Values
  {
    NamedColumn Column;
    int Indices[4] = {}; // columns of the components
    GrowingArray<vtkDoubleArray> Numbers;
  };

  bool IsDropped() const;
  std::string_view GetPlain(std::string_view line);
  bool ReadRow(std::string_view line);
  bool ReadCount(TextRow::Result result);
  void AppendPoint();
  bool AppendValues(Values& values);
  bool CheckValue(const Values& values, int component, double value);
  bool Fail(const std::string& message);
  bool FailShort();
  bool FailColor(int column);

  const TextLayout* Layout = nullptr;
  const XyzFormat& Format;
  TextReport& Report;
  const TextScan* Scan = nullptr;
  LineFile* File = nullptr;
  TextRow Row;
  bool HasCommas = false; // for points, in numbers
  std::string Plain;
  std::vector<Values> Arrays;
  GrowingArray<vtkDoubleArray> Points;
  vtkIdType NumberOfDropped = 0;
  double NumberOfCounted = 0.0;
};

} // namespace helios

#endif
