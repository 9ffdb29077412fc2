// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parses the rows of point text.

#ifndef heliosPointParser_h
#define heliosPointParser_h

#include "heliosLineFile.h"
#include "heliosPartNumbers.h"
#include "heliosPointColumns.h"
#include "heliosTextFile.h"

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

class vtkPointData;
class vtkPolyData;

namespace helios
{

/// Counts the columns of a row, without a comment that begins with # or //.
int CountColumns(std::string_view row);

/// Reads rows of x y z and, in files of 11 or 13 columns, of the others.
class PointParser
{
public:
  /// Sets the number of columns of the file, at least 3; keepInvalid accepts numbers that are not
  /// finite.
  PointParser(int columns, bool keepInvalid, PartNumbers& parts, TextReport& report);

  /// Adds the points of the next lines, at most a number of them if positive; false after an error.
  bool Read(LineFile& file, vtkIdType maximum);

  vtkIdType GetNumberOfPoints() const { return static_cast<vtkIdType>(this->Reals[0].size()); }

  /// Moves the points and their arrays to a cloud.
  void MoveTo(vtkPolyData* cloud);

private:
  bool ReadRow(std::string_view line);
  bool ReadReal(TextWords& words, int column);
  bool ReadInteger(TextWords& words, int column);
  bool ReadPart(TextWords& words);
  bool FailWord(TextWords words, int column, const std::string& problem);
  bool FailColumns();
  bool Fail(const std::string& problem);

  const int Columns;
  const bool KeepInvalid;
  PartNumbers& Parts;
  TextReport& Report;
  const LineFile* File = nullptr;
  std::string_view Line;
  std::vector<double> Reals[NumberOfPointColumns];          // values of the real columns
  std::vector<vtkTypeInt64> Integers[NumberOfPointColumns]; // values of the integer columns
};

} // namespace helios

#endif
