// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The boxes of scenes with instances.

#ifndef heliosSceneBounds_h
#define heliosSceneBounds_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersCoreModule.h" // For export macro

class vtkPolyData;

namespace helios
{

class SceneGeometry;
struct SceneInstance;

/**
 * Computes the smallest and largest coordinates of all corners, x0 x1 y0 y1 z0 z1, bit by bit equal
 * to the bounds of the flattened mesh. Only the corners of instances that may reach a side are
 * computed.
 */
VTKHELIOSFILTERSCORE_EXPORT void ComputeTightBounds(
  const SceneGeometry& geometry, double bounds[6]);

/// Computes the bounds of one instance of a geometry.
VTKHELIOSFILTERSCORE_EXPORT void ComputeTightBounds(
  const SceneGeometry& geometry, const SceneInstance& instance, double bounds[6]);

/// Computes the bounds of any scene; without instances, of all points of the mesh. An empty box:
/// none.
VTKHELIOSFILTERSCORE_EXPORT Status GetSceneBounds(vtkPolyData* scene, double bounds[6]);

} // namespace helios

#endif
