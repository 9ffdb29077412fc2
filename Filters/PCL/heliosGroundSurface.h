// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A surface through points of the ground.

#ifndef heliosGroundSurface_h
#define heliosGroundSurface_h

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace helios
{

/// At any place the height of the plane through the nearest points of the ground, each weighted by
/// 1 / (distance^2 + smoothing^2). Threads may ask at once.
class GroundSurface
{
public:
  void Build(const pcl::PointCloud<pcl::PointXYZ>& ground, double smoothing);

  double GetHeight(float x, float y) const;

private:
  pcl::PointCloud<pcl::PointXYZ>::Ptr Places; // at z = 0, so that the nearest are so on the map
  std::vector<float> Heights;
  pcl::KdTreeFLANN<pcl::PointXYZ> Tree;
  double Smoothing = 0.0;
};

} // namespace helios

#endif
