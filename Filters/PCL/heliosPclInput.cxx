// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclInput.h"

#include "heliosPclCloud.h"
#include "heliosStatus.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

/// Returns an error if the number of tuples of an array is not the number of points.
Status CheckLengths(vtkPolyData* data)
{
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetPointData()->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != data->GetNumberOfPoints())
    {
      return Status::Error(std::string("the point array ") +
        (array->GetName() ? array->GetName() : "(no name)") + " has " +
        std::to_string(array->GetNumberOfTuples()) + " tuples for " +
        std::to_string(data->GetNumberOfPoints()) + " points; give it one per point, or remove it");
    }
  }
  return {};
}

} // namespace

Status PclInput::Read(vtkPolyData* data, double step)
{
  this->Data = data;
  this->Points = Cloud::Ptr(new Cloud);
  const vtkIdType count = data->GetNumberOfPoints();
  if (count > std::numeric_limits<pcl::index_t>::max())
  {
    return Status::Error(
      std::to_string(count) + " points are more than PCL can count; process them in pieces");
  }
  ChooseOrigin(data, this->Origin, step);
  this->Points->reserve(static_cast<std::size_t>(count));
  this->Ids.reserve(static_cast<std::size_t>(count));
  double p[3];
  for (vtkIdType i = 0; i < count; ++i)
  {
    data->GetPoint(i, p);
    if (!std::isfinite(p[0] + p[1] + p[2]))
    {
      ++this->NumberOfDropped;
      continue;
    }
    float local[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      local[axis] = static_cast<float>(p[axis] - this->Origin[axis]);
      this->Reach = std::max(this->Reach, std::abs(static_cast<double>(local[axis])));
    }
    this->Points->push_back(pcl::PointXYZ(local[0], local[1], local[2]));
    this->Ids.push_back(i);
  }
  return CheckLengths(data);
}

std::vector<vtkIdType> PclInput::GetIds(const pcl::Indices& indices) const
{
  std::vector<vtkIdType> ids;
  ids.reserve(indices.size());
  std::transform(indices.begin(), indices.end(), std::back_inserter(ids),
    [this](pcl::index_t index) { return this->GetId(index); });
  return ids;
}

} // namespace helios
