// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTurbidGrid.h"

#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkImageData.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace names = vtkHeliosArrayNames;

namespace helios
{

//------------------------------------------------------------------------------
Status TurbidGrid::Set(vtkImageData* grid)
{
  vtkDataArray* given = grid->GetCellData()->GetArray(names::PAD);
  int points[3];
  grid->GetDimensions(points);
  if (!given || given->GetNumberOfComponents() != 1 || *std::min_element(points, points + 3) < 2 ||
    given->GetNumberOfTuples() != grid->GetNumberOfCells())
  {
    return Status::Error(
      std::string("the voxel image needs cells along three axes and a cell array ") + names::PAD +
      " with one value per cell [m2/m3]");
  }
  this->Pad = vtkDoubleArray::FastDownCast(given);
  if (!this->Pad)
  {
    this->Pad = vtkSmartPointer<vtkDoubleArray>::New();
    this->Pad->DeepCopy(given);
  }
  if (Status status = this->Cells.Set(grid); !status.IsOk())
  {
    return status;
  }
  this->Leaves.Clear();
  if (vtkDataArray* table = grid->GetFieldData()->GetArray(names::LeafProjection))
  {
    if (Status status = this->Leaves.Set(table); !status.IsOk())
    {
      return status;
    }
  }
  return this->CheckDensities();
}

//------------------------------------------------------------------------------
Status TurbidGrid::CheckDensities() const
{
  const double* pad = this->Pad->GetPointer(0);
  for (vtkIdType i = 0; i < this->Pad->GetNumberOfValues(); ++i)
  {
    if (pad[i] < 0.0 || std::isinf(pad[i]))
    {
      return Status::Error(std::string(names::PAD) + " of cell " + std::to_string(i) +
        " of the voxels is " + std::to_string(pad[i]) +
        "; give 0 or more [m2/m3], or NaN if unknown");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
double TurbidGrid::GetProjection(const Vec3& direction) const
{
  if (this->Leaves.IsSpherical())
  {
    return LeafProjection::Spherical;
  }
  const Vec3 d = this->Cells.ToAxes(direction);
  return this->Leaves.Get(std::atan2(std::hypot(d[0], d[1]), std::abs(d[2])));
}

//------------------------------------------------------------------------------
TurbidHit TurbidGrid::FindDepth(
  const Vec3& origin, const Vec3& direction, double end, double depth) const
{
  TurbidHit hit{ end, -1 };
  const double* pad = this->Pad->GetPointer(0);
  double left = depth / this->GetProjection(direction); // in leaf area
  this->Traverse(origin, direction, end,
    [&hit, &left, pad](vtkIdType cell, double from, double to)
    {
      const double density = pad[cell];
      if (!(density > 0.0)) // zero, or unknown
      {
        return true;
      }
      const double passed = density * (to - from);
      if (passed <= left)
      {
        left -= passed;
        return true;
      }
      hit = { std::min(to, from + left / density), cell };
      return false;
    });
  return hit;
}

//------------------------------------------------------------------------------
double TurbidGrid::GetDepth(const Vec3& origin, const Vec3& direction, double end) const
{
  double area = 0.0; // area of leaves
  const double* pad = this->Pad->GetPointer(0);
  this->Traverse(origin, direction, end,
    [&area, pad](vtkIdType cell, double from, double to)
    {
      area += pad[cell] > 0.0 ? pad[cell] * (to - from) : 0.0;
      return true;
    });
  return area * this->GetProjection(direction);
}

} // namespace helios
