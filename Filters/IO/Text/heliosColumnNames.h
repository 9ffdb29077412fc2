// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The names that programs give the columns of point text and the properties of points.

#ifndef heliosColumnNames_h
#define heliosColumnNames_h

#include <string_view>

namespace helios
{

/// Array, or component of an array, that a column is read as.
struct NamedColumn
{
  const char* Array = nullptr; ///< null: not known; empty: a coordinate
  int Component = 0;
  int Components = 1;
  int Type = 0;            ///< type of the array
  bool IsFraction = false; ///< a colour in [0, 1]
  double Offset = 0.0;     ///< added to the number in the file
};

/// Finds a column by its name, in any case, without quotes, blanks, units in brackets, _ and -, and
/// without the prefix scalar_ of CloudCompare.
NamedColumn FindNamedColumn(std::string_view name);

/// Returns the name of an array in files of other programs, or null.
const char* GetCommonName(std::string_view array);

} // namespace helios

#endif
