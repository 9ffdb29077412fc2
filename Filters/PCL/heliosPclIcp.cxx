// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclIcp.h"

#include "heliosPclNormals.h"
#include "heliosStatus.h"

#include <pcl/registration/transformation_estimation_point_to_plane_lls.h>
#include <pcl/registration/transformation_estimation_svd.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace helios
{

namespace
{

constexpr double SmallMotion = 1e-6;    // [m]
constexpr double SmallDistance = 1e-5;  // [m], from a plane
constexpr double LargestRatio = 3.0;    // ratio of a distance to the residual
constexpr float MinimumCosine = 0.866F; // between normals of a pair
constexpr std::size_t MinimumPairs = 6;

using PointT = pcl::PointNormal;

/// Converts a motion in float to an exact one in double.
Eigen::Isometry3d MakeMotion(const Eigen::Matrix4f& matrix)
{
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  const Eigen::Matrix3d turn = matrix.topLeftCorner<3, 3>().cast<double>();
  motion.linear() = Eigen::Quaterniond(turn).normalized().toRotationMatrix();
  motion.translation() = matrix.topRightCorner<3, 1>().cast<double>();
  return motion;
}

double GetPlaneDistance(const PointT& p, const PointT& q)
{
  return static_cast<double>(
    std::abs((p.getVector3fMap() - q.getVector3fMap()).dot(q.getNormalVector3fMap())));
}

Eigen::Vector3d GetCentre(const pcl::PointCloud<PointT>& cloud)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const PointT& p : cloud)
  {
    sum += p.getVector3fMap().cast<double>();
  }
  return sum / static_cast<double>(cloud.size());
}

template <typename T>
const PointT& At(const pcl::PointCloud<PointT>& cloud, T index)
{
  return cloud[static_cast<std::size_t>(index)];
}

} // namespace

bool PclIcp::GoesOn(double iterations) const
{
  return !this->OnProgress || this->OnProgress(iterations);
}

/// Makes a cloud, with normals and curvatures if planes are used; null if it was stopped.
PclIcp::Cloud::Ptr PclIcp::MakeCloud(const pcl::PointCloud<pcl::PointXYZ>::Ptr& points, double from)
{
  Cloud::Ptr cloud(new Cloud);
  cloud->resize(points->size());
  pcl::PointCloud<pcl::Normal> normals;
  if (this->PointToPlane)
  {
    this->Stopped = !EstimateNormals(
      points, 0.0, this->NumberOfNeighbors,
      [this, from](double share) { return this->GoesOn(from + 0.5 * share); }, normals);
  }
  if (this->Stopped)
  {
    return nullptr;
  }
  for (std::size_t i = 0; i < points->size(); ++i)
  {
    PointT& point = (*cloud)[i];
    point.getVector3fMap() = (*points)[i].getVector3fMap();
    if (this->PointToPlane)
    {
      point.getNormalVector3fMap() = normals[i].getNormalVector3fMap();
      point.curvature = normals[i].curvature;
    }
  }
  return cloud;
}

void PclIcp::SetFixed(const pcl::PointCloud<pcl::PointXYZ>::Ptr& points)
{
  this->Fixed = this->MakeCloud(points, 0.0);
}

void PclIcp::SetMoving(
  std::vector<Eigen::Vector3d>&& points, const pcl::PointCloud<pcl::PointXYZ>::Ptr& local)
{
  this->Moving = std::move(points);
  this->MovingNormals = this->Stopped ? nullptr : this->MakeCloud(local, 0.5);
}

bool PclIcp::IsFlat(const PointT& point) const
{
  return point.getNormalVector3fMap().allFinite() &&
    static_cast<double>(point.curvature) <= this->MaximumCurvature;
}

PclIcp::Cloud::Ptr PclIcp::Move() const
{
  Cloud::Ptr moved(new Cloud);
  moved->resize(this->Moving.size());
  const Eigen::Matrix3f turn = this->Motion.linear().cast<float>();
  for (std::size_t i = 0; i < this->Moving.size(); ++i)
  {
    const PointT& from = (*this->MovingNormals)[i];
    PointT& to = (*moved)[i];
    to.getVector3fMap() = (this->Motion * this->Moving[i]).cast<float>();
    to.getNormalVector3fMap() = turn * from.getNormalVector3fMap();
    to.curvature = from.curvature;
  }
  return moved;
}

/// Removes pairs that are not of one plane: at edges, across corners, on surfaces visible in only
/// one of the scans.
void PclIcp::Reject(const Cloud& moved, pcl::Correspondences& pairs)
{
  const auto removeIf = [&pairs](const auto& isBad)
  { pairs.erase(std::remove_if(pairs.begin(), pairs.end(), isBad), pairs.end()); };
  removeIf(
    [this, &moved](const pcl::Correspondence& pair)
    {
      const PointT& p = At(moved, pair.index_query);
      const PointT& q = At(*this->Fixed, pair.index_match);
      return !this->IsFlat(p) || !this->IsFlat(q) ||
        std::abs(p.getNormalVector3fMap().dot(q.getNormalVector3fMap())) < MinimumCosine;
    });
  removeIf(
    [this, &moved](const pcl::Correspondence& pair)
    {
      return GetPlaneDistance(At(moved, pair.index_query), At(*this->Fixed, pair.index_match)) >
        this->Limit;
    });
}

void PclIcp::Measure(const Cloud& moved, const pcl::Correspondences& pairs)
{
  double sum = 0.0;
  for (const pcl::Correspondence& pair : pairs)
  {
    const double distance =
      GetPlaneDistance(At(moved, pair.index_query), At(*this->Fixed, pair.index_match));
    sum += this->PointToPlane ? distance * distance : static_cast<double>(pair.distance);
  }
  this->NumberOfPairs = pairs.size();
  this->Residual = pairs.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(pairs.size()));
}

Eigen::Isometry3d PclIcp::Estimate(const Cloud& moved, const pcl::Correspondences& pairs) const
{
  Eigen::Matrix4f step = Eigen::Matrix4f::Identity();
  if (this->PointToPlane)
  {
    pcl::registration::TransformationEstimationPointToPlaneLLS<PointT, PointT>()
      .estimateRigidTransformation(moved, *this->Fixed, pairs, step);
  }
  else
  {
    pcl::registration::TransformationEstimationSVD<PointT, PointT>().estimateRigidTransformation(
      moved, *this->Fixed, pairs, step);
  }
  return MakeMotion(step);
}

/// Lowers the limit of distances: after convergence, distant pairs are of two surfaces. False if
/// there are none.
bool PclIcp::LowerLimit()
{
  const double limit = std::max(SmallDistance, LargestRatio * this->Residual);
  const bool isLower = this->PointToPlane && limit < 0.7 * this->Limit;
  this->Limit = isLower ? limit : this->Limit;
  return isLower;
}

void PclIcp::BuildTree(Estimation& estimation)
{
  using Tree = pcl::search::KdTree<PointT>;
  const Tree::Ptr tree(new Tree);
  const Cloud::Ptr fixed = this->Fixed;
  this->Stopped = !RunApart([this](double share) { return this->GoesOn(share); }, 1.0,
    [tree, fixed] { tree->setInputCloud(fixed); });
  estimation.setInputTarget(this->Fixed);
  estimation.setSearchMethodTarget(tree, true);
}

/// Pairs each moved point with the nearest fixed one; false if it was stopped.
bool PclIcp::FindPairs(
  Estimation& estimation, const Cloud::Ptr& moved, int iteration, pcl::Correspondences& pairs) const
{
  estimation.setInputSource(moved);
  return ForChunks(
    moved->size(), [this, iteration](double share) { return this->GoesOn(iteration + share); },
    [&](std::size_t begin, std::size_t end)
    {
      const pcl::IndicesPtr chunk(new pcl::Indices(end - begin));
      std::iota(chunk->begin(), chunk->end(), static_cast<pcl::index_t>(begin));
      estimation.setIndicesSource(chunk);
      pcl::Correspondences found;
      estimation.determineCorrespondences(found, this->MaximumDistance);
      pairs.insert(pairs.end(), found.begin(), found.end());
    });
}

Status PclIcp::Run()
{
  double reach = 1.0;
  for (const Eigen::Vector3d& p : this->Moving)
  {
    reach = std::max(reach, p.norm());
  }
  const double small = std::max(SmallMotion, 1e-7 * reach); // float precision
  Estimation estimation;
  if (!this->Stopped)
  {
    this->BuildTree(estimation);
  }
  for (int i = 1; i <= this->MaximumNumberOfIterations && !this->Settled && !this->Stopped; ++i)
  {
    const Cloud::Ptr moved = this->Move();
    pcl::Correspondences pairs;
    if (!this->FindPairs(estimation, moved, i, pairs))
    {
      this->Stopped = true;
      return {};
    }
    const std::size_t near = pairs.size();
    if (this->PointToPlane)
    {
      this->Reject(*moved, pairs);
    }
    this->Measure(*moved, pairs);
    if (pairs.size() < MinimumPairs)
    {
      return Status::Error("only " + std::to_string(near) +
        " points of input 1 have a point of input 0 within " + "MaximumDistance, and " +
        std::to_string(pairs.size()) +
        " of these pairs lie on one plane; align the scans better first, or set a larger "
        "MaximumDistance or MaximumCurvature");
    }
    const Eigen::Isometry3d step = this->Estimate(*moved, pairs);
    const Eigen::Vector3d centre = GetCentre(*moved);
    const double shift = (step * centre - centre).norm();
    if (!step.matrix().allFinite() || !(shift <= 2.0 * this->MaximumDistance))
    {
      return Status::Error("the " + std::to_string(pairs.size()) +
        " pairs of points do not determine the motion; " +
        "scans need surfaces in three directions");
    }
    this->Motion = step * this->Motion;
    const double angle = std::abs(Eigen::AngleAxisd(step.linear()).angle());
    this->Settled = step.translation().norm() + angle * reach < small && !this->LowerLimit();
  }
  return {};
}

} // namespace helios
