// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Areas on a map, given by their outlines.

#ifndef heliosAreas_h
#define heliosAreas_h

#include <array>
#include <vector>

class vtkPolyData;

namespace helios
{

/// The polygons and closed lines of a data set, in plan view.
class Areas
{
public:
  /// Reads outlines; null: no areas.
  explicit Areas(vtkPolyData* outlines);

  /// Returns whether a position is inside one of the areas or on its border.
  bool Contain(double x, double y) const;

private:
  using Place = std::array<double, 2>;
  struct Outline
  {
    std::vector<Place> Corners;
    Place Low;
    Place High;
  };
  static bool Contains(const Outline& outline, const Place& p);

  std::vector<Outline> Outlines;
};

} // namespace helios

#endif
