// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The box of most of a scene.

#ifndef heliosCoreBounds_h
#define heliosCoreBounds_h

#include "vtkHeliosScannerRayCastingModule.h"

namespace helios
{

class TriangleMesh;

/**
 * Computes the box that contains all but a few corners in a thousand, with a margin of four times
 * its size. Anything outside it (a stray corner at 1e30) would reduce the float resolution of the
 * rest.
 */
VTKHELIOSSCANNERRAYCASTING_EXPORT void GetCoreBounds(const TriangleMesh& mesh, double bounds[6]);

} // namespace helios

#endif
