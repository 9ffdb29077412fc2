// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A subset of the triangles of a scene, with all their data.

#ifndef heliosSceneSubset_h
#define heliosSceneSubset_h

#include "heliosStatus.h"
#include "vtkHeliosFiltersSceneModule.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkDoubleArray;
class vtkPolyData;

namespace helios
{

/// Returns the points of a scene in double precision: its own array if it is double.
VTKHELIOSFILTERSSCENE_EXPORT vtkSmartPointer<vtkDoubleArray> GetDoublePoints(vtkPolyData* scene);

/// Returns an error if a cell or point array is too short: which one, and the remedy.
VTKHELIOSFILTERSSCENE_EXPORT Status FindShortArray(vtkPolyData* scene);

/**
 * Fills output with triangles of input: cells lists the cells whose data they get, corners three
 * points of input each. Unused points are left out, the rest keep their order and point data; field
 * data pass. Arrays pass by reference if nothing is left out. Returns the number of output points.
 */
VTKHELIOSFILTERSSCENE_EXPORT vtkIdType ExtractTriangles(vtkPolyData* input,
  const std::vector<vtkIdType>& cells, const std::vector<vtkTypeInt32>& corners,
  vtkPolyData* output);

} // namespace helios

#endif
