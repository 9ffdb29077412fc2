// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Points that are farther from their neighbours than most, as pcl::StatisticalOutlierRemoval has them.
// PCL's filter cannot be stopped and has one thread; its search tree is used here.

#ifndef heliosOutliers_h
#define heliosOutliers_h

#include "heliosChunks.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace helios
{

/// The mean distance of each point from its nearest neighbours [m], fewer than there are points; empty
/// where it was stopped.
std::vector<float> GetNeighborDistances(
  const pcl::PointCloud<pcl::PointXYZ>::Ptr& points, int numberOfNeighbors, const GoOn& goOn);

/// The mean of at least two distances, plus so many of their standard deviations.
double GetDistanceLimit(const std::vector<float>& distances, double standardDeviations);

} // namespace helios

#endif
