// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Turbid voxels as boxes, limited in number while the camera moves.

#ifndef heliosTurbidBoxes_h
#define heliosTurbidBoxes_h

#include "heliosPose.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkImageData;
class vtkPolyData;

namespace helios::viewer
{

/**
 * Returns a box for every grid cell with a plant area density; above a maximum number of boxes, or
 * for grids of many millions of cells, for cubes of n x n x n cells, with their mean. The volume of
 * a box is proportional to its density: the densest fill their cells. (The 98 % quantile is the
 * densest, since single cells may be extreme.) Colours come from materials, shaded as if lit from
 * above. Coordinates are world coordinates relative to an origin [m].
 */
vtkSmartPointer<vtkPolyData> MakeTurbidBoxes(
  vtkImageData* grid, vtkIdType maximum, const Vec3& origin);

/// Returns the same for several, sharing the number by their cells.
vtkSmartPointer<vtkPolyData> MakeTurbidBoxes(
  const std::vector<vtkSmartPointer<vtkImageData>>& grids, vtkIdType maximum, const Vec3& origin);

} // namespace helios::viewer

#endif
