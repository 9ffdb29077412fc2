// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The columns of point text, as vtkHeliosPointTextWriter writes and vtkHeliosPointTextReader reads
// them.

#ifndef heliosPointColumns_h
#define heliosPointColumns_h

#include "heliosConstants.h"
#include "vtkHeliosArrayNames.h"

#include <vtkType.h>

namespace helios
{

struct PointColumn
{
  const char* Title; ///< for messages
  const char* Array; ///< empty: a coordinate; the next coordinate follows
  int Type;          ///< type of the array
  int Decimals;      ///< decimals of real numbers
  double Factor;     ///< a number in the text is the array's times this
  double Default;    ///< without an array
};

inline constexpr int NumberOfPointColumns = 15;
inline constexpr int NumberOfFlagColumns = 13;  ///< without the decibels
inline constexpr int NumberOfBasicColumns = 11; ///< without the flags of scan lines, too
inline constexpr int FirstArrayColumn = 3;      ///< after x, y, z
inline constexpr int PartColumn = 8;            ///< the name of a part, or its number

inline constexpr PointColumn PointColumns[NumberOfPointColumns] = {
  { "x", "", VTK_DOUBLE, 4, 1.0, 0.0 },
  { "y", "", VTK_DOUBLE, 4, 1.0, 0.0 },
  { "z", "", VTK_DOUBLE, 4, 1.0, 0.0 },
  { "intensity", vtkHeliosArrayNames::Amplitude, VTK_DOUBLE, 4, NanowattsPerWatt, 0.0 },
  { "echo width", vtkHeliosArrayNames::EchoWidth, VTK_DOUBLE, 4, 1.0, 0.0 },
  { "return number", vtkHeliosArrayNames::ReturnNumber, VTK_UNSIGNED_CHAR, 0, 1.0, 1.0 },
  { "number of returns", vtkHeliosArrayNames::NumberOfReturns, VTK_UNSIGNED_CHAR, 0, 1.0, 1.0 },
  { "pulse", vtkHeliosArrayNames::PulseIds, VTK_TYPE_INT64, 0, 1.0, -1.0 },
  { "part", vtkHeliosArrayNames::PartIds, VTK_INT, 0, 1.0, -1.0 },
  { "class", vtkHeliosArrayNames::ClassificationIds, VTK_INT, 0, 1.0, 0.0 },
  { "time", vtkHeliosArrayNames::GpsTime, VTK_DOUBLE, 9, 1.0, 0.0 },
  { "scan direction", vtkHeliosArrayNames::ScanDirectionFlag, VTK_UNSIGNED_CHAR, 0, 1.0, 0.0 },
  { "edge of flight line", vtkHeliosArrayNames::EdgeOfFlightLine, VTK_UNSIGNED_CHAR, 0, 1.0, 0.0 },
  { "relative amplitude", vtkHeliosArrayNames::RelativeAmplitude, VTK_DOUBLE, 4, 1.0, 0.0 },
  { "reflectance", vtkHeliosArrayNames::Reflectance, VTK_DOUBLE, 4, 1.0, 0.0 },
};

/// Returns the number of columns that are read from a row.
inline constexpr int GetColumnsToRead(int columns)
{
  return columns == NumberOfPointColumns || columns == NumberOfFlagColumns ||
      columns == NumberOfBasicColumns
    ? columns
    : FirstArrayColumn;
}

} // namespace helios

#endif
