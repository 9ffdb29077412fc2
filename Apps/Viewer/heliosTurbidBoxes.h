// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Turbid voxels as boxes: as many as can be drawn while the camera moves.

#ifndef heliosTurbidBoxes_h
#define heliosTurbidBoxes_h

#include "heliosPose.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkImageData;
class vtkPolyData;

namespace helios
{

/**
 * A box for every cell of a grid that has a plant area density; where that would be more than a number
 * of boxes, or the grid has many millions of cells, for cubes of n x n x n, with their mean. The volume
 * of a box goes with its density: the densest fill their cells. (The densest one in fifty is taken for
 * that, since single cells may be out of all proportion.) Colours are those of materials, shaded as if
 * the light came from above. Coordinates are the world's less an origin [m].
 */
vtkSmartPointer<vtkPolyData> MakeTurbidBoxes(
  vtkImageData* grid, vtkIdType most, const Vec3& origin);

/// The same of several, which share the number by their cells.
vtkSmartPointer<vtkPolyData> MakeTurbidBoxes(
  const std::vector<vtkSmartPointer<vtkImageData>>& grids, vtkIdType most, const Vec3& origin);

} // namespace helios

#endif
