// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Concatenates the triangles of several scenes.

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

/// Returns the part if there is only one, else null.
vtkPolyData* GetSinglePart(const PartList& parts);

/// Returns all points, double; a single part's own array if it is double.
vtkSmartPointer<vtkPoints> JoinPoints(const PartList& parts);

/// Returns all triangles in 32-bit storage; a single part's own array if it is 32-bit.
vtkSmartPointer<vtkCellArray> JoinCells(const PartList& parts);

/// Returns a cell array of real numbers of the triangles, with a value for parts without; null if
/// no part has any.
vtkSmartPointer<vtkFloatArray> JoinCellArrays(
  const PartList& parts, const char* name, int components, float otherwise);

/// Returns the connection of every triangle.
vtkSmartPointer<vtkIntArray> MakePartIds(const PartList& parts);

/**
 * Numbers the objects of connections that are split after all other parts: their PartIds, with their
 * Part.Name. The scene has the triangles of the connections in their order, with PartIds, and
 * Part.Name in its field data.
 */
void SplitParts(const PartList& parts, const std::vector<bool>& areSplit, vtkPolyData* scene);

} // namespace helios

#endif
