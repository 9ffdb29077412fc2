// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Exact test for degenerate triangles.

#ifndef heliosTriangleArea_h
#define heliosTriangleArea_h

#include "vtkHeliosFiltersCoreModule.h"

namespace helios
{

/**
 * Whether three points are not collinear, decided exactly for the given coordinates: the cross
 * product of two sides is evaluated in double if Shewchuk's bound allows, otherwise as an exact
 * sum. (J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997.)
 */
VTKHELIOSFILTERSCORE_EXPORT bool SpansArea(const double a[3], const double b[3], const double c[3]);

} // namespace helios

#endif
