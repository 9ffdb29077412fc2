// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The area of a flight: closed rings in x, y, measured along and across a heading.

#ifndef heliosFlightArea_h
#define heliosFlightArea_h

#include "heliosStatus.h"

#include <vtkVector.h>

#include <vector>

class vtkPolyData;

namespace helios
{

/// A closed interval; empty if Low > High.
struct Interval
{
  double Low = 1.0;
  double High = -1.0;

  bool IsEmpty() const { return !(this->Low <= this->High); }
  double GetLength() const { return this->IsEmpty() ? 0.0 : this->High - this->Low; }
  void Add(double value);
};

class FlightArea
{
public:
  /// Reads the polygons and closed lines of a data set.
  Status Read(vtkPolyData* polygons);

  /// Turns the area, so that the first coordinate is along a heading (degrees clockwise from y) and
  /// the second one to its right.
  FlightArea Turn(double heading) const;

  /// Returns the extent across.
  Interval GetWidth() const;

  /// Returns the extent along of the part in a band across.
  Interval GetLength(const Interval& band) const;

  /// Returns the headings of the edges of the convex hull, in [0, 180).
  std::vector<double> GetHullHeadings() const;

  /// Turns coordinates back to x, y.
  static vtkVector2d TurnBack(const vtkVector2d& place, double heading);

private:
  using Ring = std::vector<vtkVector2d>;

  std::vector<vtkVector2d> GetHull() const;

  std::vector<Ring> Rings;
};

} // namespace helios

#endif
