// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Decimates a patch within a proven distance.

#ifndef heliosPatchSimplifier_h
#define heliosPatchSimplifier_h

#include "heliosMeshDecimation.h"

namespace helios
{

struct SimplifiedPatch
{
  DecimatedPatch Mesh;
  double Distance =
    0.0; ///< proven bound on the distance of any point of either surface from the other
  bool IsUntouched = true; ///< nothing could be removed within the limit
};

/**
 * Decimates, bounds the distance of each changed triangle from the other surface, in both
 * directions, locks the triangles that exceed the limit and repeats; leaves the patch unchanged if
 * that fails. Throws Stopped if the stop check returns true.
 */
SimplifiedPatch Simplify(const Patch& patch, double limit, StopCheck& check);

} // namespace helios

#endif
