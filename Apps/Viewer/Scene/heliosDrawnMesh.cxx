// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosDrawnMesh.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataNormals.h>
#include <vtkQuadricClustering.h>

#include <algorithm>

namespace helios::viewer
{

namespace
{

constexpr int MinimumDivisions = 2;

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSmooth(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SetFeatureAngle(40.0);
  normals->ConsistencyOff(); // keeps the order of the cells
  normals->Update();
  return normals->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeCoarse(vtkPolyData* mesh, vtkIdType maximum, double divisions)
{
  double size[3];
  vtkNew<vtkQuadricClustering> clustering;
  for (int axis = 0; axis < 3; ++axis)
  {
    size[axis] = mesh->GetBounds()[2 * axis + 1] - mesh->GetBounds()[2 * axis];
  }
  const double longest = *std::max_element(size, size + 3);
  clustering->SetInputData(mesh);
  clustering->AutoAdjustNumberOfDivisionsOff();
  clustering->CopyCellDataOn();
  for (;; divisions *= 0.7)
  {
    int counts[3];
    std::transform(size, size + 3, counts,
      [&](double side)
      { return std::max(MinimumDivisions, static_cast<int>(divisions * side / longest)); });
    clustering->SetNumberOfDivisions(counts);
    clustering->Update();
    if (clustering->GetOutput()->GetNumberOfCells() <= maximum || divisions < MinimumDivisions)
    {
      return clustering->GetOutput();
    }
  }
}

} // namespace helios::viewer
