// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Parses the rows of a text file of points.

#ifndef heliosXyzParser_h
#define heliosXyzParser_h

#include "heliosGrowingArray.h"
#include "heliosLineFile.h"
#include "heliosTextFile.h"
#include "heliosTextRow.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>

#include <cstdint>
#include <string>
#include <string_view>

class vtkPolyData;

namespace helios
{

/// Columns and separators of the format.
struct XyzFormat
{
  std::string Separators = " \t";
  int NormalColumns[3] = { 3, 4, 5 };
  int ColorColumns[3] = { 6, 7, 8 };
  bool HasNormals = false;
  bool HasColors = false;
  double MaximumColor = 255.0;
};

/// Reads rows of x, y, z and the columns of the format; every number used is checked.
class XyzParser
{
public:
  XyzParser(const XyzFormat& format, TextReport& report);

  /// Adds the points of the lines that start in [begin, end) of the file; false after an error.
  bool Read(LineFile& file, std::int64_t begin, std::int64_t end);

  vtkIdType GetNumberOfPoints() const { return this->Points.GetSize() / 3; }

  /// Moves the points and their arrays to a cloud.
  void MoveTo(vtkPolyData* cloud);

private:
  void Need(const int columns[3]);
  bool IsFirstRow(std::int64_t lineStart) const;

  bool ReadRow(std::string_view line);
  bool AppendColor();
  bool Fail(const std::string& message);
  bool FailShort();
  bool FailNumber(std::string_view line);

  const XyzFormat& Format;
  TextReport& Report;
  LineFile* File = nullptr;
  TextRow Row;
  GrowingArray<vtkDoubleArray> Points;
  GrowingArray<vtkDoubleArray> Normals;
  GrowingArray<vtkFloatArray> Colors;
};

} // namespace helios

#endif
