// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosObbSearch.h"

#include "heliosTriangleArea.h"
#include "heliosTriangleMesh.h"

#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

constexpr double RelativeTolerance = 1e-9; // accuracy of the tree's own test, of the scene's size

vtkSmartPointer<vtkPoints> MakeLocalPoints(const TriangleMesh& mesh, const double middle[3])
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh.GetNumberOfPoints(); ++i)
  {
    const double* p = mesh.GetPoints() + 3 * i;
    points->SetPoint(i, p[0] - middle[0], p[1] - middle[1], p[2] - middle[2]);
  }
  return points;
}

/// Returns the range of the common test, for a triangle that the tree reports as hit.
double GetPlaneRange(const TestRay& ray, const double* const points[3])
{
  double corners[3][3];
  ComputeOffsets<double>(ray.Origin, points, corners);
  const TrianglePlane plane = GetPlane(points);
  RangeTerms<double> terms;
  terms.Set(plane, corners);
  return GetRange(ray, plane, terms);
}

} // namespace

//------------------------------------------------------------------------------
void ObbSearch::Build(const TriangleMesh& mesh)
{
  this->Mesh = &mesh;
  this->Triangles.clear();
  this->Tree->FreeSearchStructure();
  this->Local->Initialize();
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    if (SpansArea(mesh.GetCorner(i, 0), mesh.GetCorner(i, 1), mesh.GetCorner(i, 2)))
    {
      const vtkTypeInt32* corners = mesh.GetCorners() + 3 * i;
      cells->InsertNextCell({ corners[0], corners[1], corners[2] });
      this->Triangles.push_back(static_cast<vtkTypeInt32>(i));
    }
  }
  if (this->Triangles.empty())
  {
    return;
  }
  mesh.GetBounds(this->Bounds);
  double size = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double* range = this->Bounds + 2 * axis;
    this->Middle[axis] = range[0] + 0.5 * (range[1] - range[0]);
    size = std::max(size, range[1] - range[0]);
  }
  this->Tolerance = RelativeTolerance * size;
  this->Local->SetPoints(MakeLocalPoints(mesh, this->Middle));
  this->Local->SetPolys(cells);
  this->Local->BuildCells(); // now: queries must be const
  this->Tree->SetDataSet(this->Local);
  this->Tree->AutomaticOn();
  this->Tree->BuildLocator();
}

//------------------------------------------------------------------------------
/// Computes the part of a ray within the scene's box, about the middle; false for a miss.
bool ObbSearch::Clip(const TestRay& ray, double from[3], double to[3]) const
{
  double low[3], high[3], entry, exit;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = this->Bounds[2 * axis] - this->Tolerance - ray.Origin[axis];
    high[axis] = this->Bounds[2 * axis + 1] + this->Tolerance - ray.Origin[axis];
  }
  GetBoxRange(low, high, ray.Inverse, entry, exit);
  entry = std::max(entry, 0.0);
  exit = std::min(exit, ray.MaximumRange);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double origin = ray.Origin[axis] - this->Middle[axis];
    from[axis] = origin + entry * ray.Direction[axis];
    to[axis] = origin + exit * ray.Direction[axis];
  }
  return entry < exit;
}

//------------------------------------------------------------------------------
vtkHeliosHit ObbSearch::Intersect(const vtkHeliosRay& ray) const
{
  const vtkHeliosHit miss{ NoHit, -1 };
  TestRay test;
  double from[3], to[3];
  if (this->Triangles.empty() || !test.Set(ray) || !this->Clip(test, from, to))
  {
    return miss;
  }
  thread_local vtkNew<vtkGenericCell> cell;
  double s, point[3], parameters[3];
  int subId = 0;
  vtkIdType found = -1;
  auto* tree = const_cast<vtkOBBTree*>(this->Tree.Get()); // its queries change nothing
  if (!tree->IntersectWithLine(from, to, this->Tolerance, s, point, parameters, subId, found, cell))
  {
    return miss;
  }
  const vtkTypeInt32 triangle = this->Triangles[static_cast<std::size_t>(found)];
  const double* points[3] = { this->Mesh->GetCorner(triangle, 0),
    this->Mesh->GetCorner(triangle, 1), this->Mesh->GetCorner(triangle, 2) };
  const double range = GetPlaneRange(test, points);
  return range > 0.0 && range <= test.MaximumRange ? vtkHeliosHit{ range, triangle } : miss;
}

//------------------------------------------------------------------------------
std::size_t ObbSearch::GetMemorySize() const
{
  // The tree's own size, in KiB, covers only its arrays; a node is one vtkOBBNode and its ids.
  return 1024 * this->Local->GetActualMemorySize() +
    this->Triangles.capacity() * sizeof(vtkTypeInt32) +
    (std::size_t(2) << std::min(this->Tree->GetLevel(), 30)) * sizeof(vtkOBBNode);
}

} // namespace helios
