// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How far the triangles of one surface are from another one, bounded from above.

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

/// The distance of a point from a triangle, whatever its shape.
double GetDistance(const Vec3& point, const Triangle& triangle);

/**
 * A surface to be near to. The distance of a point from one of its triangles T is a convex
 * function, so over a convex polygon it is largest at a corner: max |v - T| bounds the distance of
 * the polygon from the surface. A triangle is cut along the sides of the T nearest to its middle,
 * or in halves, until that bound of every piece is good enough. Only the choice of T is up to
 * CGAL's tree of boxes: a poor one costs time, never the bound. Rounding adds a few units in the
 * last place of the coordinates: use a local frame.
 */
class SurfaceDistance
{
public:
  /// Throws Stopped where it is told to stop.
  SurfaceDistance(std::vector<Triangle> surface, StopCheck& check);
  ~SurfaceDistance();
  SurfaceDistance(const SurfaceDistance&) = delete;
  void operator=(const SurfaceDistance&) = delete;

  /// The bound, and the triangles of the surface that it comes from.
  struct Result
  {
    static constexpr int MaximumUsed = 6;

    double Bound = 0.0;   ///< no point of the triangle is further away, if it is within the limit
    vtkIdType Worst = -1; ///< the one next to where the limit is exceeded; -1: nowhere
    int NumberOfUsed = 0; ///< more than MaximumUsed: not all are listed
    std::array<vtkIdType, MaximumUsed> Used;

    void Use(vtkIdType triangle);
  };

  /**
   * Whether all of a triangle is within a limit of the surface, and a bound of its distance. Bounds
   * below enough are not made tighter. Says exceeded, too, where the distance is within a
   * thousandth of the limit. The hint is a triangle of the surface, the better the nearer.
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
