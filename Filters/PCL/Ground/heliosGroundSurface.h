// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A surface through ground points.

#ifndef heliosGroundSurface_h
#define heliosGroundSurface_h

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <vector>

namespace helios
{

/// Height of the plane through the nearest ground points, each weighted by
/// 1 / (distance^2 + smoothing^2). Thread-safe.
class GroundSurface
{
public:
  void Build(const pcl::PointCloud<pcl::PointXYZ>& ground, double smoothing);

  double GetHeight(float x, float y) const;

private:
  pcl::PointCloud<pcl::PointXYZ>::Ptr Places; // at z = 0, for nearest neighbours in the xy plane
  std::vector<float> Heights;
  pcl::KdTreeFLANN<pcl::PointXYZ> Tree;
  double Smoothing = 0.0;
};

} // namespace helios

#endif
