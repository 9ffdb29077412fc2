// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Clusters of points, as pcl::EuclideanClusterExtraction has them. PCL's search gives every point all
// its neighbours, which is quadratic in the density, and it cannot be stopped.

#ifndef heliosPointClusters_h
#define heliosPointClusters_h

#include "heliosChunks.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace helios
{

/**
 * For each point the first one of its cluster: steps between points of a cluster are shorter than a
 * tolerance, their squares compared in float as PCL does. Empty where it was stopped.
 *
 * All points within a cell of a grid of side tolerance / sqrt(3) are of one cluster. Cells near each
 * other are joined at the first two points that are near; boxes of points that are too far apart are
 * left out, half of a half at a time.
 */
std::vector<int> FindClusters(
  const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points, double tolerance, const GoOn& goOn);

} // namespace helios

#endif
