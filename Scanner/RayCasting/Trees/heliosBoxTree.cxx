// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBoxTree.h"

#include "heliosStopCheck.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// Enlarges a box by the rounding of corners.
void AddMargin(std::array<double, 6>& b)
{
  constexpr double rounding = 0x1p-48;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double margin = rounding *
      (std::max(std::abs(b[2 * axis]), std::abs(b[2 * axis + 1])) + b[2 * axis + 1] - b[2 * axis]);
    b[2 * axis] -= margin;
    b[2 * axis + 1] += margin;
  }
}

/// Returns a triangle for each box, with its bounds.
vtkSmartPointer<vtkPolyData> MakeTriangles(const std::vector<std::array<double, 6>>& boxes)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (std::array<double, 6> b : boxes)
  {
    AddMargin(b);
    const vtkIdType first = points->InsertNextPoint(b[0], b[2], b[4]);
    points->InsertNextPoint(b[1], b[2], b[5]);
    points->InsertNextPoint(b[0], b[3], b[5]);
    polys->InsertNextCell({ first, first + 1, first + 2 });
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

/// bytes of a box of MakeTriangles()
constexpr std::size_t SizeOfBox = 9 * sizeof(double) + 4 * sizeof(vtkTypeInt32);

} // namespace

//------------------------------------------------------------------------------
void BoxTree::Build(const std::vector<std::array<double, 6>>& boxes, StopCheck& check)
{
  this->Tree = BeamTree();
  if (!boxes.empty() && this->Mesh.Set(MakeTriangles(boxes)).IsOk())
  {
    this->Tree.BuildWhole(this->Mesh, check, 1); // all in a leaf that is entered are visited
  }
}

void BoxTree::Build(std::vector<std::array<double, 6>> boxes)
{
  std::for_each(boxes.begin(), boxes.end(), AddMargin);
  this->Tree.Build(boxes);
}

std::size_t BoxTree::GetMemorySize() const
{
  return this->Tree.GetMemorySize() +
    SizeOfBox * static_cast<std::size_t>(this->Mesh.GetNumberOfTriangles());
}

} // namespace helios
