// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Normals and curvatures of points by PCL, in chunks of points.

#ifndef heliosPclNormals_h
#define heliosPclNormals_h

#include "heliosChunks.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

namespace helios
{

/// Estimates normals from the points within a radius [m] of each, or from the nearest ones if it is
/// 0. False if it was stopped.
bool EstimateNormals(const pcl::PointCloud<pcl::PointXYZ>::Ptr& points, double radius,
  int numberOfNeighbors, const GoOn& goOn, pcl::PointCloud<pcl::Normal>& normals);

} // namespace helios

#endif
