// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene from a pipeline: any VTK data with surfaces as one mesh of triangles.

#ifndef heliosSceneInput_h
#define heliosSceneInput_h

#include <vtkSmartPointer.h>

class vtkDataObject;
class vtkPolyData;

namespace helios
{

/**
 * The surfaces of a vtkPolyData, another vtkDataSet or a composite data set as triangles, with their
 * cell data. The arrays of a mesh that has only triangles are shared. Null for other data.
 */
vtkSmartPointer<vtkPolyData> MakeTriangles(vtkDataObject* data);

} // namespace helios

#endif
