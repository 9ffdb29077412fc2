// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCellGrid.h"

#include "heliosStatus.h"

#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <algorithm>
#include <cmath>

namespace helios
{

//------------------------------------------------------------------------------
Status CellGrid::Set(vtkImageData* grid)
{
  int points[3];
  grid->GetDimensions(points);
  int extent[6];
  grid->GetExtent(extent);
  const double corner[3] = { static_cast<double>(extent[0]), static_cast<double>(extent[2]),
    static_cast<double>(extent[4]) };
  grid->TransformContinuousIndexToPhysicalPoint(corner, this->Corner.GetData());
  vtkIdType step = 1;
  double square = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double size = grid->GetSpacing()[axis];
    square += size * size;
    this->Count[axis] = points[axis] - 1;
    this->Step[axis] = step;
    step *= points[axis] - 1;
    for (int column = 0; column < 3; ++column)
    {
      // The axes are orthonormal: the transposed matrix is its inverse.
      this->ToGrid.M[axis][column] = grid->GetDirectionMatrix()->GetElement(column, axis);
      this->ToCells.M[axis][column] = this->ToGrid.M[axis][column] / size;
    }
    if (!(size > 0.0) || !std::isfinite(size) || !std::isfinite(this->Corner[axis]))
    {
      return Status::Error(
        "the voxel image has no spacing, or a spacing or origin that is not finite; give "
        "cells with a size");
    }
  }
  this->Diagonal = std::sqrt(square);
  return {};
}

//------------------------------------------------------------------------------
bool CellGrid::MayMeet(
  const Vec3& origin, const Vec3& direction, double tangent, double apexOffset) const
{
  const IndexRay ray = this->ToIndex(origin, direction);
  double reach = 0.0; // reach of the corner farthest along the ray
  for (int axis = 0; axis < 3; ++axis)
  {
    reach += std::max(std::abs(ray.Origin[axis]), std::abs(this->Count[axis] - ray.Origin[axis])) /
      Vec3(this->ToCells.M[axis]).Norm();
  }
  const double radius = tangent * (reach + apexOffset); // the largest radius at the grid
  double range[2] = { -radius, std::numeric_limits<double>::infinity() };
  for (int axis = 0; axis < 3; ++axis)
  {
    const double margin = radius * Vec3(this->ToCells.M[axis]).Norm() + 1e-9 * this->Count[axis];
    if (!ClipToSlab(
          ray.Origin[axis], ray.Direction[axis], -margin, this->Count[axis] + margin, range))
    {
      return false;
    }
  }
  return true;
}

} // namespace helios
