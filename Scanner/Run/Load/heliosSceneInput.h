// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scene from a pipeline: any VTK data with surfaces as one mesh of triangles.

#ifndef heliosSceneInput_h
#define heliosSceneInput_h

#include <vtkSmartPointer.h>

#include <string>

class vtkDataObject;
class vtkPolyData;

namespace helios
{

class Messages;

/**
 * Returns the surfaces of a vtkPolyData, another vtkDataSet or a composite data set as triangles,
 * with their cell data. The arrays of a mesh that has only triangles are shared. Null for other
 * data. Warnings start with its name.
 */
vtkSmartPointer<vtkPolyData> MakeTriangles(
  vtkDataObject* data, const std::string& name, Messages& log);

} // namespace helios

#endif
