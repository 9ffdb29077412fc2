// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The materials of parts as rows of one table.

#ifndef heliosPartMaterials_h
#define heliosPartMaterials_h

#include "heliosMaterialTable.h"
#include "heliosSceneJoin.h"

#include <vtkType.h>

#include <vector>

class vtkIntArray;
class vtkPolyData;

namespace helios
{

/// Maps materials to rows of a table; adds those the table does not have yet.
std::vector<int> MergeMaterials(const MaterialTable& materials, MaterialTable& table);

/// Writes the rows of a part's triangles; returns the first triangle without a row, or -1.
vtkIdType MapMaterialIds(vtkPolyData* part, const std::vector<int>& rows, int* to);

/// Returns the material ids of a single part, if they need no change; else null.
vtkIntArray* GetSingleMaterialIds(const PartList& parts);

} // namespace helios

#endif
