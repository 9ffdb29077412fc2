// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Some points of a cloud with all that belongs to them.

#ifndef heliosPointSelection_h
#define heliosPointSelection_h

#include <vtkType.h>

#include <vector>

class vtkPolyData;

namespace helios
{

/// Points of input by their ids, bit by bit, with their point arrays and the field data. Vertices,
/// one a point, where the input has vertices; no other cells.
void SelectPoints(vtkPolyData* input, const std::vector<vtkIdType>& ids, vtkPolyData* output);

} // namespace helios

#endif
