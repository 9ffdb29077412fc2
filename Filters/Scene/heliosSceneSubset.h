// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene of some of the triangles of another one, with all they carry.

#ifndef heliosSceneSubset_h
#define heliosSceneSubset_h

#include "vtkHeliosFiltersSceneModule.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkDoubleArray;
class vtkPolyData;

namespace helios
{

/// The points of a scene in double precision: its own array if it is double.
VTKHELIOSFILTERSSCENE_EXPORT vtkSmartPointer<vtkDoubleArray> GetDoublePoints(vtkPolyData* scene);

/// Says which cell or point array is too short, and what to do; empty: none.
VTKHELIOSFILTERSSCENE_EXPORT std::string FindShortArray(vtkPolyData* scene);

/**
 * Fills output with triangles of input: cells lists the ones whose cell data they get, corners
 * three points of input each. Points that none of them uses are left out, the rest keep their order
 * and point data; field data pass. Arrays pass by reference where nothing is left out. Returns how
 * many points the output has.
 */
VTKHELIOSFILTERSSCENE_EXPORT vtkIdType ExtractTriangles(vtkPolyData* input,
  const std::vector<vtkIdType>& cells, const std::vector<vtkTypeInt32>& corners,
  vtkPolyData* output);

} // namespace helios

#endif
