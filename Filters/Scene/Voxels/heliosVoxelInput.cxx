// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVoxelInput.h"

#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// Returns the values of an array of three components, in the array itself or in a copy.
const double* GetDoubles(vtkDataArray* array, std::vector<double>& copy)
{
  if (auto* doubles = vtkDoubleArray::FastDownCast(array))
  {
    return doubles->GetPointer(0);
  }
  copy.resize(static_cast<std::size_t>(3 * array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    array->GetTuple(i, copy.data() + 3 * i);
  }
  return copy.data();
}

Status CheckTuples(vtkDataArray* array, vtkIdType count)
{
  if (array->GetNumberOfComponents() == 3 && array->GetNumberOfTuples() == count)
  {
    return {};
  }
  return Status::Error(std::string("the point array ") +
    (array->GetName() ? array->GetName() : "of normals") + " has " +
    std::to_string(array->GetNumberOfTuples()) + " tuples of " +
    std::to_string(array->GetNumberOfComponents()) + "; expected one of 3 for each of " +
    std::to_string(count) + " points");
}

} // namespace

Status VoxelInput::Set(vtkPointSet* data, bool withNormals)
{
  this->Points = this->Range = VoxelPoints();
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return {};
  }
  vtkDataArray* coordinates = data->GetPoints()->GetData();
  this->Epsilon = coordinates->GetDataType() == VTK_FLOAT ? 0x1p-23 : 0x1p-52;
  this->Points.Count = data->GetNumberOfPoints();
  this->Points.Points = GetDoubles(coordinates, this->OwnPoints);
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  normals = normals ? normals : data->GetPointData()->GetArray(names::Normals);
  vtkDataArray* colors = data->GetPointData()->GetArray(names::RGB);
  Status status;
  if (normals && withNormals)
  {
    status = CheckTuples(normals, this->Points.Count);
    this->Points.Normals = status.IsOk() ? GetDoubles(normals, this->OwnNormals) : nullptr;
  }
  if (colors && status.IsOk())
  {
    status = this->SetColors(colors);
  }
  this->SetRange(0, this->Points.Count);
  return status;
}

// Integers use the range of their type, others [0..1].
Status VoxelInput::SetColors(vtkDataArray* colors)
{
  Status status = CheckTuples(colors, this->Points.Count);
  if (!status.IsOk())
  {
    return status;
  }
  const bool isReal = colors->GetDataType() == VTK_FLOAT || colors->GetDataType() == VTK_DOUBLE;
  const double full = isReal ? 1.0 : colors->GetDataTypeMax();
  this->OwnColors.resize(static_cast<std::size_t>(3 * this->Points.Count));
  for (vtkIdType i = 0; i < 3 * this->Points.Count; ++i)
  {
    const double value = colors->GetComponent(i / 3, static_cast<int>(i % 3)) / full;
    if (!(value >= 0.0 && value <= 1.0))
    {
      return Status::Error(std::string("the point array ") + names::RGB + " has " +
        std::to_string(value) + " of the full colour value at point " + std::to_string(i / 3) +
        "; give bytes, 16-bit whole numbers, or reals within 0 and 1");
    }
    this->OwnColors[static_cast<std::size_t>(i)] =
      static_cast<std::uint16_t>(std::lround(value * 65535.0));
  }
  this->Points.Colors = this->OwnColors.data();
  return {};
}

void VoxelInput::SetRange(vtkIdType first, vtkIdType end)
{
  const VoxelPoints& all = this->Points;
  this->Range.Points = all.Points ? all.Points + 3 * first : nullptr;
  this->Range.Normals = all.Normals ? all.Normals + 3 * first : nullptr;
  this->Range.Colors = all.Colors ? all.Colors + 3 * first : nullptr;
  this->Range.Count = end - first;
}

VoxelBounds::VoxelBounds()
{
  std::fill(this->Low, this->Low + 3, std::numeric_limits<double>::infinity());
  std::fill(this->High, this->High + 3, -std::numeric_limits<double>::infinity());
}

vtkIdType VoxelBounds::Add(const VoxelInput& input)
{
  const VoxelPoints points = input.Get();
  double fault = 0.0; // NaN if a coordinate is not finite
  for (vtkIdType i = 0; i < points.Count; ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x = points.Points[3 * i + axis];
      this->Low[axis] = std::min(this->Low[axis], x);
      this->High[axis] = std::max(this->High[axis], x);
      fault += x * 0.0;
    }
  }
  this->Count += points.Count;
  this->NormalCount += points.Normals ? points.Count : 0;
  this->ColorCount += points.Colors ? points.Count : 0;
  this->Epsilon = points.Count > 0 ? std::max(this->Epsilon, input.GetEpsilon()) : this->Epsilon;
  if (fault == 0.0)
  {
    return -1;
  }
  const auto isBad = [](double x) { return !std::isfinite(x); };
  return (std::find_if(points.Points, points.Points + 3 * points.Count, isBad) - points.Points) / 3;
}

bool VoxelBounds::Holds(const VoxelBounds& other) const
{
  bool holds = other.Count <= this->Count &&
    other.NormalCount == (this->NormalCount > 0 ? other.Count : 0) &&
    other.ColorCount == (this->ColorCount > 0 ? other.Count : 0);
  for (int axis = 0; axis < 3; ++axis)
  {
    holds = holds && other.Low[axis] >= this->Low[axis] && other.High[axis] <= this->High[axis];
  }
  return holds;
}

double VoxelBounds::GetMagnitude() const
{
  double magnitude = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    magnitude = std::max({ magnitude, std::abs(this->Low[axis]), std::abs(this->High[axis]) });
  }
  return magnitude;
}

} // namespace helios
