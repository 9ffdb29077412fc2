// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Decimates a patch, and proves that it stayed where it was.

#ifndef heliosPatchSimplifier_h
#define heliosPatchSimplifier_h

#include "heliosMeshDecimation.h"

namespace helios
{

struct SimplifiedPatch
{
  DecimatedPatch Mesh;
  double Distance = 0.0;   ///< proven: no point of either surface is further from the other one
  bool IsUntouched = true; ///< nothing could be taken out within the limit
};

/**
 * Decimates, bounds the distance of each changed triangle from the other surface, in both
 * directions, locks the triangles where that exceeds the limit and begins anew; leaves the patch as
 * it is in the end. Throws Stopped where it is told to stop.
 */
SimplifiedPatch Simplify(const Patch& patch, double limit, StopCheck& check);

} // namespace helios

#endif
