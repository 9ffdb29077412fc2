// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of several scenes one after the other.

#ifndef heliosSceneJoin_h
#define heliosSceneJoin_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkCellArray;
class vtkFloatArray;
class vtkIntArray;
class vtkPoints;
class vtkPolyData;

namespace helios
{

using PartList = std::vector<vtkPolyData*>; // by connection; null: a part without triangles

vtkIdType CountPoints(const PartList& parts);
vtkIdType CountTriangles(const PartList& parts);

/// The one part there is; null where there are several.
vtkPolyData* GetSinglePart(const PartList& parts);

/// All points, double; a single part's own where they are.
vtkSmartPointer<vtkPoints> JoinPoints(const PartList& parts);

/// All triangles in 32-bit storage; a single part's own where they are.
vtkSmartPointer<vtkCellArray> JoinCells(const PartList& parts);

/// The normals of the triangles, (0, 0, 0) for a part that has none; null where no part has any.
vtkSmartPointer<vtkFloatArray> JoinNormals(const PartList& parts);

/// The connection that every triangle comes from.
vtkSmartPointer<vtkIntArray> MakePartIds(const PartList& parts);

} // namespace helios

#endif
