// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGroundSurface.h"

#include <algorithm>

namespace helios
{

namespace
{

constexpr int NumberOfNearest = 12;

// Regularization relative to the sum of squares, so that collinear points also have a plane.
constexpr double Ridge = 1e-3;

} // namespace

void GroundSurface::Build(const pcl::PointCloud<pcl::PointXYZ>& ground, double smoothing)
{
  this->Places.reset(new pcl::PointCloud<pcl::PointXYZ>(ground));
  this->Smoothing = smoothing;
  this->Heights.reserve(ground.size());
  for (pcl::PointXYZ& p : *this->Places)
  {
    this->Heights.push_back(p.z);
    p.z = 0.0F;
  }
  this->Tree.setInputCloud(this->Places);
}

double GroundSurface::GetHeight(float x, float y) const
{
  pcl::Indices nearest;
  std::vector<float> squares;
  this->Tree.nearestKSearch(pcl::PointXYZ(x, y, 0.0F),
    std::min(NumberOfNearest, static_cast<int>(this->Heights.size())), nearest, squares);
  // the normal equations of z = h + a u + b v, with u and v from the position
  Eigen::Matrix3d sums = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  const double smoothing = this->Smoothing * this->Smoothing;
  for (const pcl::index_t i : nearest)
  {
    const auto index = static_cast<std::size_t>(i);
    const pcl::PointXYZ& p = (*this->Places)[index];
    const Eigen::Vector3d row(1.0, static_cast<double>(p.x - x), static_cast<double>(p.y - y));
    const double weight = 1.0 / (row[1] * row[1] + row[2] * row[2] + smoothing);
    sums += weight * row * row.transpose();
    right += weight * static_cast<double>(this->Heights[index]) * row;
  }
  sums(1, 1) += Ridge * smoothing * sums(0, 0);
  sums(2, 2) += Ridge * smoothing * sums(0, 0);
  return sums.ldlt().solve(right)[0];
}

} // namespace helios
