// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Meshes as drawn: smooth, or with large triangles for small ones.

#ifndef heliosDrawnMesh_h
#define heliosDrawnMesh_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkPolyData;

namespace helios::viewer
{

/// Returns the triangles with normals that are smooth over edges below 40 degrees, in the same
/// order.
vtkSmartPointer<vtkPolyData> MakeSmooth(vtkPolyData* mesh);

/// Returns the triangles with corners merged in cubes so large that at most this many triangles
/// remain; divisions: the first number of cubes along the longest side.
vtkSmartPointer<vtkPolyData> MakeCoarse(vtkPolyData* mesh, vtkIdType maximum, double divisions);

} // namespace helios::viewer

#endif
