// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Upper bounds of the distance of triangles of one surface from another surface.

#ifndef heliosSurfaceDistance_h
#define heliosSurfaceDistance_h

#include "heliosPose.h"
#include "heliosStopCheck.h"

#include <vtkType.h>

#include <array>
#include <memory>
#include <vector>

namespace helios
{

using Triangle = std::array<Vec3, 3>;

/// Returns the distance of a point from a triangle of any shape.
double GetDistance(const Vec3& point, const Triangle& triangle);

/**
 * The reference surface of the distances. The distance of a point from one of its triangles T is a
 * convex function, so over a convex polygon it is largest at a corner: max |v - T| bounds the
 * distance of the polygon from the surface. A triangle is split along the sides of the T nearest to
 * its centre, or in halves, until that bound of every piece is tight enough. Only the choice of T
 * depends on CGAL's AABB tree: a poor one costs time, never the bound. Rounding adds a few units in
 * the last place of the coordinates: use a local frame.
 */
class SurfaceDistance
{
public:
  /// Throws Stopped if the stop check returns true.
  SurfaceDistance(std::vector<Triangle> surface, StopCheck& check);
  ~SurfaceDistance();
  SurfaceDistance(const SurfaceDistance&) = delete;
  void operator=(const SurfaceDistance&) = delete;

  /// The bound, and the triangles of the surface that it comes from.
  struct Result
  {
    static constexpr int MaximumUsed = 6;

    double Bound = 0.0;   ///< no point of the triangle is further away, if it is within the limit
    vtkIdType Worst = -1; ///< the one nearest to a place beyond the limit; -1: none
    int NumberOfUsed = 0; ///< more than MaximumUsed: not all are listed
    std::array<vtkIdType, MaximumUsed> Used;

    void Use(vtkIdType triangle);
  };

  /**
   * Measures whether all of a triangle is within a limit of the surface, and a bound of its
   * distance. Bounds below enough are not tightened. Also reports exceeded if the distance is
   * within a thousandth of the limit. The hint is a triangle of the surface, preferably a near one.
   * Thread-safe.
   */
  Result Measure(const Triangle& triangle, double limit, double enough, vtkIdType hint = 0) const;

private:
  class Tree;
  class Walk;

  std::vector<Triangle> Surface;
  std::unique_ptr<Tree> Boxes;
};

} // namespace helios

#endif
