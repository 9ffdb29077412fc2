// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Which colour a point of a cloud has, and the legend that goes with it.

#ifndef heliosCloudColors_h
#define heliosCloudColors_h

#include "heliosCloud.h"
#include "heliosColorMaps.h"

#include <vector>

class vtkLookupTable;
class vtkUnsignedCharArray;

namespace helios
{

/// What colours show; all but One are columns of the cloud.
enum class ColorBy : int
{
  Height = static_cast<int>(CloudColumn::Height),
  Amplitude = static_cast<int>(CloudColumn::Amplitude), ///< by its logarithm
  ReturnNumber = static_cast<int>(CloudColumn::ReturnNumber),
  NumberOfReturns = static_cast<int>(CloudColumn::NumberOfReturns),
  Class = static_cast<int>(CloudColumn::Class),
  Time = static_cast<int>(CloudColumn::Time),
  Part = static_cast<int>(CloudColumn::Part),
  Material = static_cast<int>(CloudColumn::Material),
  Leg = static_cast<int>(CloudColumn::Leg),
  Incidence = static_cast<int>(CloudColumn::Incidence),
  Range = static_cast<int>(CloudColumn::Range),
  One = -1 ///< one colour for all
};

/// Maps numbers to colours: along the ramp between two ends, or number by number.
class CloudColors
{
public:
  ColorBy By = ColorBy::Height;
  Rgb One = { 200, 205, 210 };
  double Low = 0.0;
  double High = 1.0;

  /// Of a number that is not known.
  static constexpr Rgb Unknown = { 128, 128, 128 };

  /// Whether numbers stand for things (classes, parts ...) rather than amounts.
  bool IsCategory() const;
  bool IsLogarithmic() const { return this->By == ColorBy::Amplitude; }

  Rgb Map(double value) const;

  /// Writes the colours of points [begin, end) of a chunk as red, green, blue, opaque.
  void Map(const Cloud& cloud, const CloudChunk& chunk, vtkIdType begin, vtkIdType end,
    std::uint8_t* rgba) const;

  /// The ends that leave 2 % of the values out on either side, NaN aside; false: no values.
  bool FitRange(std::vector<double> values);

  /// "Height [m]" ...
  std::string GetTitle(const Cloud& cloud) const;

  /// Makes a table of the same colours; categories get the names of those among values.
  void FillTable(vtkLookupTable* table, const std::vector<double>& values) const;

private:
  std::string GetLabel(int category) const;
};

} // namespace helios

#endif
