// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A grid of cells with random attenuation: leaves too small and too many to be triangles.

#ifndef heliosTurbidGrid_h
#define heliosTurbidGrid_h

#include "heliosPose.h"
#include "heliosStatus.h"
#include "vtkHeliosScannerRayCastingModule.h"

#include <vtkDoubleArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;

namespace helios
{

/// The stop of a ray; Cell is -1 if it is not stopped.
struct TurbidHit
{
  double Range;
  vtkIdType Cell;
};

/**
 * The cells of an image with their plant area density PAD [m2/m3]. A ray along d is stopped in ds
 * with the probability k ds, k = PAD G(d): G is the projection of a unit of leaf area, 0.5 for
 * randomly oriented leaves. So the optical depth, the sum of k s over the cells, is exponential
 * with mean 1 (Beer and Lambert; Ross 1981, The Radiation Regime and Architecture of Plant Stands).
 */
class VTKHELIOSSCANNERRAYCASTING_EXPORT TurbidGrid
{
public:
  /// Projection of a spherical leaf angle distribution.
  static constexpr double SphericalProjection = 0.5;

  /// Reads an image and keeps its array alive.
  Status Set(vtkImageData* grid);

  vtkIdType GetNumberOfCells() const { return this->Pad->GetNumberOfValues(); }

  /// Returns G for a direction of any length: linear in its angle from the grid's z axis, symmetric
  /// about the horizontal.
  double GetProjection(const Vec3& direction) const;

  /**
   * Calls visit(cell, from, to) for the cells that a ray passes at ranges [from, to] within
   * [0, end], in order, until it returns false. Each from is the previous to: no gaps, no overlaps,
   * and nothing beyond the grid. A ray within a face between two cells is in the upper one; a ray
   * within the uppermost face is outside.
   */
  template <typename Visitor>
  void Traverse(const Vec3& origin, const Vec3& direction, double end, Visitor&& visit) const;

  /// Finds the point where a ray with a unit direction has passed an optical depth, at most to a
  /// range.
  TurbidHit FindDepth(const Vec3& origin, const Vec3& direction, double end, double depth) const;

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

  IndexRay ToIndex(const Vec3& origin, const Vec3& direction) const;
  static bool ClipToSlab(double from, double slope, double low, double high, double range[2]);
  Status SetLeafTable(vtkImageData* grid);
  Status CheckDensities() const;

  vtkSmartPointer<vtkDoubleArray> Pad;
  double Count[3] = { 0.0, 0.0, 0.0 };           // number of cells
  vtkIdType Step[3] = { 1, 0, 0 };               // to the next cell
  Vec3 Corner{ 0.0, 0.0, 0.0 };                  // lowest
  Rotation ToCells;                              // from metres to cells
  Rotation ToGrid;                               // from the world to the grid's axes
  std::vector<std::pair<double, double>> Leaves; // angle from the z axis [rad] in [0, pi/2], and G
};

//------------------------------------------------------------------------------
template <typename Visitor>
void TurbidGrid::Traverse(
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
