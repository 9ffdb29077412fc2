// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells of an image, and the cells that a ray passes.

#ifndef heliosCellGrid_h
#define heliosCellGrid_h

#include "heliosPose.h"
#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <limits>

class vtkImageData;

namespace helios
{

/// Geometry of the cells of an image: of any origin, spacing and axes.
class VTKHELIOSFILTERSCORE_EXPORT CellGrid
{
public:
  /// Reads the geometry of an image.
  Status Set(vtkImageData* grid);

  vtkIdType GetNumberOfCells() const
  {
    return static_cast<vtkIdType>(this->Count[0] * this->Count[1] * this->Count[2]);
  }

  /// Returns the length of the diagonal of a cell [m].
  double GetDiagonal() const { return this->Diagonal; }

  /// Rotates a direction from the world to the grid's axes.
  Vec3 ToAxes(const Vec3& direction) const { return this->ToGrid * direction; }

  /**
   * Calls visit(cell, from, to) for the cells that a ray passes at ranges [from, to] within
   * [0, end], in order, until it returns false. Each from is the previous to: no gaps, no overlaps,
   * and nothing beyond the grid. A ray within a face between two cells is in the upper one; a ray
   * within the uppermost face is outside.
   */
  template <typename Visitor>
  void Traverse(const Vec3& origin, const Vec3& direction, double end, Visitor&& visit) const;

  /**
   * Returns false if nothing within (t + apexOffset) tangent of a ray with a unit direction can hit
   * the grid, t being the range along the ray.
   */
  bool MayMeet(const Vec3& origin, const Vec3& direction, double tangent, double apexOffset) const;

private:
  /// A ray in units of cells, counted from the grid's lowest corner.
  struct IndexRay
  {
    Vec3 Origin;
    Vec3 Direction;
  };

  IndexRay ToIndex(const Vec3& origin, const Vec3& direction) const
  {
    return { this->ToCells * (origin - this->Corner), this->ToCells * direction };
  }

  /// Clips the ranges of a line from + t slope to [low, high); false if nothing is left.
  static bool ClipToSlab(double from, double slope, double low, double high, double range[2])
  {
    if (slope == 0.0)
    {
      return from >= low && from < high;
    }
    const double first = ((slope > 0.0 ? low : high) - from) / slope;
    const double last = ((slope > 0.0 ? high : low) - from) / slope;
    range[0] = std::max(range[0], first);
    range[1] = std::min(range[1], last);
    return range[0] < range[1];
  }

  double Count[3] = { 0.0, 0.0, 0.0 }; // number of cells
  vtkIdType Step[3] = { 1, 0, 0 };     // to the next cell
  double Diagonal = 0.0;
  Vec3 Corner{ 0.0, 0.0, 0.0 }; // lowest
  Rotation ToCells;             // from metres to cells
  Rotation ToGrid;              // from the world to the grid's axes
};

//------------------------------------------------------------------------------
template <typename Visitor>
void CellGrid::Traverse(
  const Vec3& origin, const Vec3& direction, double end, Visitor&& visit) const
{
  const IndexRay ray = this->ToIndex(origin, direction);
  double range[2] = { 0.0, end };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (!ClipToSlab(ray.Origin[axis], ray.Direction[axis], 0.0, this->Count[axis], range))
    {
      return;
    }
  }
  vtkIdType cell = 0;
  double plane[3]; // where the ray leaves its cell
  double next[3];  // the ranges of these
  const auto setNext = [&](int axis)
  {
    const double slope = ray.Direction[axis];
    next[axis] = slope != 0.0 ? (plane[axis] - ray.Origin[axis]) / slope
                              : std::numeric_limits<double>::infinity();
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double at = ray.Origin[axis] + range[0] * ray.Direction[axis];
    const double index = std::min(std::max(std::floor(at), 0.0), this->Count[axis] - 1.0);
    cell += static_cast<vtkIdType>(index) * this->Step[axis];
    plane[axis] = ray.Direction[axis] > 0.0 ? index + 1.0 : index;
    setNext(axis);
  }
  double at = range[0];
  while (at < range[1])
  {
    const int axis =
      next[0] <= next[1] ? (next[0] <= next[2] ? 0 : 2) : (next[1] <= next[2] ? 1 : 2);
    const double to = std::min(std::max(next[axis], at), range[1]);
    if ((to > at && !visit(cell, at, to)) || next[axis] >= range[1])
    {
      return;
    }
    const double step = ray.Direction[axis] > 0.0 ? 1.0 : -1.0;
    plane[axis] += step;
    cell += step > 0.0 ? this->Step[axis] : -this->Step[axis];
    setNext(axis);
    at = to;
  }
}

} // namespace helios

#endif
