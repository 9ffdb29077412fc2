// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Statistical outliers, as in pcl::StatisticalOutlierRemoval. PCL's filter cannot be stopped and
// has one thread; its search tree is used here.

#ifndef heliosOutliers_h
#define heliosOutliers_h

#include "heliosChunks.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace helios
{

/// Returns the mean distance of each point to its nearest neighbours [m], fewer than there are
/// points; empty if it was stopped.
std::vector<float> GetNeighborDistances(
  const pcl::PointCloud<pcl::PointXYZ>::Ptr& points, int numberOfNeighbors, const GoOn& goOn);

/// Returns the mean of at least two distances, plus standardDeviations times their standard
/// deviation.
double GetDistanceLimit(const std::vector<float>& distances, double standardDeviations);

} // namespace helios

#endif
