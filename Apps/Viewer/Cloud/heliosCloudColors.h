// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Maps the points of a cloud to colours, with the legend.

#ifndef heliosCloudColors_h
#define heliosCloudColors_h

#include "heliosCloud.h"
#include "heliosColorMaps.h"
#include "heliosLegend.h"

#include <string>
#include <vector>

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
  Own = static_cast<int>(CloudColumn::Color), ///< red, green and blue of the points
  One = -1                                    ///< one colour for all
};

/// Maps values to colours: along the ramp between two ends, or per category.
class CloudColors
{
public:
  ColorBy By = ColorBy::Height;
  Rgb One = { 200, 205, 210 };
  double Low = 0.0;
  double High = 1.0;
  Ramp Colors = MakeRamp(RampPart()); ///< colours of quantities

  /// For unknown values.
  static constexpr Rgb Unknown = { 128, 128, 128 };

  /// Returns whether values are categories (classes, parts ...) rather than quantities.
  bool IsCategory() const;
  /// Returns whether colours show no value: the points' own colours, or one for all.
  bool IsPlain() const { return this->By == ColorBy::One || this->By == ColorBy::Own; }
  bool IsLogarithmic() const { return this->By == ColorBy::Amplitude; }

  Rgb Map(double value) const;

  /// Writes the colours of points [begin, end) of a chunk as red, green, blue, opaque.
  void Map(const Cloud& cloud, const CloudChunk& chunk, vtkIdType begin, vtkIdType end,
    std::uint8_t* rgba) const;

  /// Fits the ends to exclude 2 % of the values on either side, NaN ignored; false: no values.
  bool FitRange(std::vector<double> values);

  /// Returns "Height", "Amplitude" ...
  std::string GetName(const Cloud& cloud) const;

  /// Returns the legend; of categories: those among values.
  Legend MakeLegend(const Cloud& cloud, const std::vector<double>& values) const;

private:
  std::string GetUnit(const Cloud& cloud) const;
  void AddTicks(const Cloud& cloud, Legend& legend) const;
  void AddCategories(const Cloud& cloud, const std::vector<double>& values, Legend& legend) const;
  double GetShare(double value) const;
  std::string GetLabel(const Cloud& cloud, int category) const;
};

} // namespace helios::viewer

#endif
