// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The files of a plan written by vtkhelios plan.

#ifndef heliosPlanFiles_h
#define heliosPlanFiles_h

#include "heliosStatus.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>

class vtkPolyData;

namespace helios::viewer
{

/// Either Positions or Lines is not null.
struct Plan
{
  vtkSmartPointer<vtkPolyData> Positions;  ///< scan positions selected, largest gain first
  vtkSmartPointer<vtkPolyData> Candidates; ///< may be null
  vtkSmartPointer<vtkPolyData> TestPoints; ///< may be null
  vtkSmartPointer<vtkPolyData> Lines;      ///< waypoints of flight lines
  vtkSmartPointer<vtkPolyData> Cells;      ///< cells of the area flown; may be null
  std::string Survey;                      ///< file; empty: missing
};

/// Returns whether a path is a plan's folder, or its positions.vtp or lines.vtp.
bool IsPlan(const std::string& path);

/// Reads a plan.
Status ReadPlan(const std::string& path, Plan& plan);

/// Returns the value of a point; missing: if there is no such array.
double GetPlanned(vtkPolyData* points, const char* name, vtkIdType row, double missing);

} // namespace helios::viewer

#endif
