// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether a triangle has an area, without rounding.

#ifndef heliosTriangleArea_h
#define heliosTriangleArea_h

#include "vtkHeliosFiltersCoreModule.h"

namespace helios
{

/**
 * Whether three points are not on one line, decided exactly for their coordinates as they are: the
 * cross product of two sides is evaluated in double where Shewchuk's bound settles it, and as an
 * exact sum elsewhere. (J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic, 1997.)
 */
VTKHELIOSFILTERSCORE_EXPORT bool SpansArea(const double a[3], const double b[3], const double c[3]);

} // namespace helios

#endif
