// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The layout of a text file of points: separators, names of columns, header lines and scans.

#ifndef heliosTextLayout_h
#define heliosTextLayout_h

#include "heliosColumnNames.h"
#include "heliosLineFile.h"
#include "heliosStatus.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace helios
{

struct TextReport;

/// Rows of a file that share a pose.
struct TextScan
{
  std::int64_t Begin = 0; ///< position of the first row
  std::int64_t End = 0;
  bool HasMatrix = false;
  double Matrix[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }; ///< row by row
};

/// A column that is read.
struct TextColumn
{
  int Index = 0; ///< from 0
  NamedColumn Column;
};

enum class TextKind
{
  Plain,  ///< x y z first, other columns are not read
  Echoes, ///< the columns of vtkHeliosPointTextWriter
  Named,  ///< columns by the names of a header line
  Pts,    ///< after lines with numbers of points: x y z, intensity, red green blue
  Ptx     ///< the same in the frame of scanners, after their poses
};

inline constexpr const char* BlankSeparators = " \t";

struct TextLayout
{
  TextKind Kind = TextKind::Plain;
  std::string Separators = BlankSeparators;
  int NumberOfColumns = 0; ///< columns of the first row
  int Coordinates[3] = { 0, 1, 2 };
  std::vector<TextColumn> Columns;  ///< without the coordinates
  std::vector<std::string> Unknown; ///< names of columns that are not read
  std::vector<TextScan> Scans;      ///< one, unless the file is PTX
  bool HasHeader = false;           ///< the header has unknown names, which are not used

  bool HasCounts() const { return this->Kind == TextKind::Pts; }
};

/// Splits a line at separators into columns, without quotes.
std::vector<std::string_view> SplitColumns(std::string_view line, const std::string& separators);

/// Finds the layout of an open file. Empty separators are found, too. Errors name the line; without
/// rows, NumberOfColumns is 0.
Status FindTextLayout(
  LineFile& file, const std::string& separators, TextLayout& layout, TextReport& report);

/// Finds the scans of a PTX file.
Status FindPtxScans(LineFile& file, TextLayout& layout, TextReport& report);

} // namespace helios

#endif
