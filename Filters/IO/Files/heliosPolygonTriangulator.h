// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of a polygon in space, which may be concave and have holes.

#ifndef heliosPolygonTriangulator_h
#define heliosPolygonTriangulator_h

#include "heliosPose.h"
#include "vtkHeliosFiltersIOModule.h" // For export macro

#include <vtkType.h>

#include <vector>

namespace helios
{

/// Rings of vertex indices: the boundary, then the holes.
using PolygonRings = std::vector<std::vector<vtkTypeInt32>>;

class VTKHELIOSFILTERSIO_EXPORT PolygonTriangulator
{
public:
  /**
   * Triangulates a polygon: a convex one as a fan about its first corner, others by
   * vtkContourTriangulator. False if the polygon is not simple: the area of the triangles, seen
   * along its normal, is not its own. The triangles have the orientation of the boundary, whatever
   * that of the holes. A polygon without area has none.
   */
  bool Triangulate(const double* points, const PolygonRings& rings);

  /// Three vertex indices per triangle of the last polygon.
  const std::vector<vtkTypeInt32>& GetCorners() const { return this->Corners; }

private:
  void SetRings(const double* points, const PolygonRings& rings);
  bool IsConvex() const;
  void AddFan();
  void AddContours();
  double ComputeTriangleArea() const;

  const double* Points = nullptr;
  PolygonRings Rings;           // without repeated vertices, the holes opposite to the boundary
  Vec3 Normal{ 0.0, 0.0, 0.0 }; // unit
  double Area = 0.0;            // [m2], seen along the normal
  std::vector<vtkTypeInt32> Corners;
};

} // namespace helios

#endif
