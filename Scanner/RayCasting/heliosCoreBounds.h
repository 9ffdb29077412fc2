// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Where the most of a scene is.

#ifndef heliosCoreBounds_h
#define heliosCoreBounds_h

#include "vtkHeliosScannerRayCastingModule.h"

namespace helios
{

class TriangleMesh;

/**
 * The box that holds all but a few corners in a thousand, with four times its size around it. What
 * reaches out of it (a stray corner at 1e30) would take away the floats' resolution from the rest.
 */
VTKHELIOSSCANNERRAYCASTING_EXPORT void GetCoreBounds(const TriangleMesh& mesh, double bounds[6]);

} // namespace helios

#endif
