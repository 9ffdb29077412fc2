// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTurbidGrid.h"

#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>

#include <cmath>

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
  int extent[6];
  grid->GetExtent(extent);
  const double corner[3] = { static_cast<double>(extent[0]), static_cast<double>(extent[2]),
    static_cast<double>(extent[4]) };
  grid->TransformContinuousIndexToPhysicalPoint(corner, this->Corner.GetData());
  vtkIdType step = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double size = grid->GetSpacing()[axis];
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
  const Status status = this->SetLeafTable(grid);
  return status.IsOk() ? this->CheckDensities() : status;
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
/// Rows with the same angle are merged to their mean.
Status TurbidGrid::SetLeafTable(vtkImageData* grid)
{
  this->Leaves.clear();
  vtkDataArray* table = grid->GetFieldData()->GetArray(names::LeafProjection);
  if (!table)
  {
    return {};
  }
  std::vector<std::pair<double, double>> rows;
  for (vtkIdType i = 0; table->GetNumberOfComponents() == 4 && i < table->GetNumberOfTuples(); ++i)
  {
    double row[4];
    table->GetTuple(i, row);
    const double angle = std::atan2(std::hypot(row[0], row[1]), std::abs(row[2]));
    const bool isGood =
      Vec3(row).Norm() > 0.0 && std::isfinite(angle) && row[3] >= 0.0 && std::isfinite(row[3]);
    if (!isGood)
    {
      rows.clear();
      break;
    }
    rows.emplace_back(angle, row[3]);
  }
  if (rows.empty())
  {
    return Status::Error(std::string("field array ") + names::LeafProjection +
      " of the voxels needs rows x y z G: a direction, and a projection of 0 or more");
  }
  std::sort(rows.begin(), rows.end());
  constexpr double same = 1e-6; // [rad]
  for (std::size_t i = 0; i < rows.size();)
  {
    std::size_t end = i;
    double sum = 0.0;
    for (; end < rows.size() && rows[end].first - rows[i].first <= same; ++end)
    {
      sum += rows[end].second;
    }
    this->Leaves.emplace_back(rows[i].first, sum / static_cast<double>(end - i));
    i = end;
  }
  return {};
}

//------------------------------------------------------------------------------
double TurbidGrid::GetProjection(const Vec3& direction) const
{
  if (this->Leaves.empty())
  {
    return SphericalProjection;
  }
  const Vec3 d = this->ToGrid * direction;
  const double angle = std::atan2(std::hypot(d[0], d[1]), std::abs(d[2]));
  const auto above =
    std::lower_bound(this->Leaves.begin(), this->Leaves.end(), std::make_pair(angle, 0.0));
  if (above == this->Leaves.begin() || above == this->Leaves.end())
  {
    return above == this->Leaves.end() ? this->Leaves.back().second : above->second;
  }
  const auto below = above - 1;
  const double share = (angle - below->first) / (above->first - below->first);
  return below->second + share * (above->second - below->second);
}

//------------------------------------------------------------------------------
TurbidGrid::IndexRay TurbidGrid::ToIndex(const Vec3& origin, const Vec3& direction) const
{
  return { this->ToCells * (origin - this->Corner), this->ToCells * direction };
}

//------------------------------------------------------------------------------
/// Clips the ranges of a line from + t slope to [low, high); false if nothing is left.
bool TurbidGrid::ClipToSlab(double from, double slope, double low, double high, double range[2])
{
  if (slope == 0.0)
  {
    return from >= low && from < high;
  }
  const double first = ((slope > 0.0 ? low : high) - from) / slope;
  const double last = ((slope > 0.0 ? high : low) - from) / slope;
  range[0] = std::max(range[0], first);
  range[1] = std::min(range[1], last);
  return range[0] < range[1];
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
bool TurbidGrid::MayMeet(
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
