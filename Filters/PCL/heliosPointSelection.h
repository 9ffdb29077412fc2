// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Selects points of a cloud with all their data.

#ifndef heliosPointSelection_h
#define heliosPointSelection_h

#include <vtkType.h>

#include <vector>

class vtkPolyData;

namespace helios
{

/// Copies points of input by id, bit by bit, with their point arrays and the field data. Vertices,
/// one per point, if the input has vertices; no other cells.
void SelectPoints(vtkPolyData* input, const std::vector<vtkIdType>& ids, vtkPolyData* output);

} // namespace helios

#endif
