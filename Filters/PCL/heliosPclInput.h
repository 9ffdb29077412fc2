// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The input points of a filter as a PCL cloud.

#ifndef heliosPclInput_h
#define heliosPclInput_h

#include "heliosStatus.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

#include <vtkType.h>

#include <string>
#include <vector>

class vtkPolyData;

namespace helios
{

class PclInput
{
public:
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;

  /// Takes the finite points, relative to an origin that is a multiple of a step [m].
  Status Read(vtkPolyData* data, double step);

  vtkPolyData* GetData() const { return this->Data; }
  const double* GetOrigin() const { return this->Origin; }
  const Cloud::Ptr& GetCloud() const { return this->Points; }
  int GetSize() const { return static_cast<int>(this->Points->size()); }

  /// Maps a point of the cloud to the point id of the data.
  vtkIdType GetId(pcl::index_t index) const { return this->Ids[static_cast<std::size_t>(index)]; }
  const std::vector<vtkIdType>& GetIds() const { return this->Ids; }
  std::vector<vtkIdType> GetIds(const pcl::Indices& indices) const;

  vtkIdType GetNumberOfDropped() const { return this->NumberOfDropped; }

  /// Returns the largest distance of a coordinate from the origin [m].
  double GetReach() const { return this->Reach; }

private:
  vtkPolyData* Data = nullptr;
  double Origin[3] = { 0.0, 0.0, 0.0 };
  Cloud::Ptr Points;
  std::vector<vtkIdType> Ids;
  vtkIdType NumberOfDropped = 0;
  double Reach = 0.0;
};

} // namespace helios

#endif
