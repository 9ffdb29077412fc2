// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Surface heights of a scene.

#ifndef heliosGround_h
#define heliosGround_h

#include "heliosStatus.h"
#include "vtkHeliosScannerRayCastingModule.h" // For export macro

#include <vtkType.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * Computes the height of the highest surface at the x, y of each point, NaN without a surface; with
 * groundOnly only of surfaces with a ground material, if the scene has any.
 */
VTKHELIOSSCANNERRAYCASTING_EXPORT Status GetGroundHeights(
  vtkPolyData* points, vtkPolyData* scene, bool groundOnly, std::vector<double>& heights);

/// Finds, for each triangle of a scene, whether its material is a ground; empty if none is.
VTKHELIOSSCANNERRAYCASTING_EXPORT std::vector<bool> FindGroundCells(vtkPolyData* scene);

/// Returns "point 3 at x 1, y 2".
std::string DescribePlace(vtkPolyData* points, vtkIdType index);

} // namespace helios

#endif
