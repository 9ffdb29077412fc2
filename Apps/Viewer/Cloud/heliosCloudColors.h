// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Maps the points of a cloud to colours, with the legend.

#ifndef heliosCloudColors_h
#define heliosCloudColors_h

#include "heliosCloud.h"
#include "heliosColorMaps.h"

#include <vector>

class vtkLookupTable;
class vtkUnsignedCharArray;

namespace helios::viewer
{

/// Coloured quantity; all but One are columns of the cloud.
enum class ColorBy : int
{
  Height = static_cast<int>(CloudColumn::Height),
  Amplitude = static_cast<int>(CloudColumn::Amplitude), ///< logarithmic
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

/// Maps values to colours: along the ramp between two ends, or per category.
class CloudColors
{
public:
  ColorBy By = ColorBy::Height;
  Rgb One = { 200, 205, 210 };
  double Low = 0.0;
  double High = 1.0;

  /// For unknown values.
  static constexpr Rgb Unknown = { 128, 128, 128 };

  /// Whether values are categories (classes, parts ...) rather than quantities.
  bool IsCategory() const;
  bool IsLogarithmic() const { return this->By == ColorBy::Amplitude; }

  Rgb Map(double value) const;

  /// Writes the colours of points [begin, end) of a chunk as red, green, blue, opaque.
  void Map(const Cloud& cloud, const CloudChunk& chunk, vtkIdType begin, vtkIdType end,
    std::uint8_t* rgba) const;

  /// The ends that exclude 2 % of the values on either side, NaN ignored; false: no values.
  bool FitRange(std::vector<double> values);

  /// "Height [m]" ...
  std::string GetTitle(const Cloud& cloud) const;

  /// Fills a table with the same colours; categories get the names of those among values.
  void FillTable(vtkLookupTable* table, const std::vector<double>& values) const;

private:
  std::string GetLabel(int category) const;
};

} // namespace helios::viewer

#endif
