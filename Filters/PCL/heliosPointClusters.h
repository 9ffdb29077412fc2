// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Clusters of points, as in pcl::EuclideanClusterExtraction. PCL searches all neighbours of every
// point, which is quadratic in the density, and it cannot be stopped.

#ifndef heliosPointClusters_h
#define heliosPointClusters_h

#include "heliosChunks.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace helios
{

/**
 * Finds, for each point, the first point of its cluster: steps between points of a cluster are
 * shorter than a tolerance, with squares compared in float, like PCL. Empty if it was stopped.
 *
 * All points in a cell of a grid of side tolerance / sqrt(3) belong to one cluster. Cells near each
 * other are joined at the first pair of near points; boxes of points that are too far apart are
 * skipped, by recursive bisection.
 */
std::vector<int> FindClusters(
  const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points, double tolerance, const GoOn& goOn);

} // namespace helios

#endif
