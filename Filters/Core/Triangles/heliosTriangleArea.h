// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Tests for degenerate triangles, and for the side of a line a point is on.

#ifndef heliosTriangleArea_h
#define heliosTriangleArea_h

#include "vtkHeliosFiltersCoreModule.h"

namespace helios
{

/**
 * Returns whether three points are not collinear, decided exactly for the given coordinates: the
 * cross product of two sides is evaluated in double if Shewchuk's bound allows, otherwise as an
 * exact sum. (J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997.)
 */
VTKHELIOSFILTERSCORE_EXPORT bool SpansArea(const double a[3], const double b[3], const double c[3]);

/**
 * Returns whether three points are collinear within the rounding of their coordinates, half an ulp
 * each: their normal is noise.
 */
VTKHELIOSFILTERSCORE_EXPORT bool IsFlat(const double a[3], const double b[3], const double c[3]);

/**
 * Returns twice the signed area of a triangle in a plane: positive if c is left of a b, negative if
 * it is right, 0 if it is on the line. The sign is exact.
 */
VTKHELIOSFILTERSCORE_EXPORT double ComputeTurn(
  const double a[2], const double b[2], const double c[2]);

} // namespace helios

#endif
