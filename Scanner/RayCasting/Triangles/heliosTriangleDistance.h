// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Distance between a segment and a triangle.

#ifndef heliosTriangleDistance_h
#define heliosTriangleDistance_h

#include "heliosPose.h"
#include "vtkHeliosScannerRayCastingModule.h" // For export macro

namespace helios
{

/// Returns the smallest distance between two segments, each from a to b; either may be a point.
VTKHELIOSSCANNERRAYCASTING_EXPORT double SegmentToSegment(
  const Vec3& a0, const Vec3& b0, const Vec3& a1, const Vec3& b1);

/**
 * Returns the smallest distance between a segment from a to b and a triangle, 0 if they intersect.
 * It is that to an edge, or from an end of the segment to the inside of the triangle. The segment
 * may be a point, the triangle without area.
 */
VTKHELIOSSCANNERRAYCASTING_EXPORT double SegmentToTriangle(
  const Vec3& a, const Vec3& b, const Vec3 corners[3]);

} // namespace helios

#endif
