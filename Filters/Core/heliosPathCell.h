// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The cell of a trajectory.

#ifndef heliosPathCell_h
#define heliosPathCell_h

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <numeric>
#include <vector>

namespace helios
{

/// Adds one polyline through all points in order, or a vertex for a single point.
inline void AddPathCell(vtkPolyData* path)
{
  std::vector<vtkIdType> ids(static_cast<std::size_t>(path->GetNumberOfPoints()));
  std::iota(ids.begin(), ids.end(), vtkIdType(0));
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(path->GetNumberOfPoints(), ids.data());
  ids.size() == 1 ? path->SetVerts(cells) : path->SetLines(cells);
}

} // namespace helios

#endif
