// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The iterative closest point method, composed of PCL's parts; motions are composed in double.

#ifndef heliosPclIcp_h
#define heliosPclIcp_h

#include "heliosStatus.h"

#include <pcl/correspondence.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/correspondence_estimation.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace helios
{

class PclIcp
{
public:
  double MaximumDistance = 1.0;
  int MaximumNumberOfIterations = 100;
  bool PointToPlane = true;
  int NumberOfNeighbors = 16;
  double MaximumCurvature = 0.01;

  /// Runs with the number of iterations done and the progress of the current one, the first of
  /// which is the preparation; false stops the work.
  std::function<bool(double)> OnProgress;

  /// Sets the fixed points, relative to an origin.
  void SetFixed(const pcl::PointCloud<pcl::PointXYZ>::Ptr& points);

  /// Sets the moving points, relative to the same origin, and the same points as a cloud.
  void SetMoving(
    std::vector<Eigen::Vector3d>&& points, const pcl::PointCloud<pcl::PointXYZ>::Ptr& local);

  /// Finds the motion.
  Status Run();

  const Eigen::Isometry3d& GetMotion() const { return this->Motion; }
  bool IsStopped() const { return this->Stopped; }
  bool HasSettled() const { return this->Settled; }
  const std::vector<Eigen::Vector3d>& GetMoving() const { return this->Moving; }

  /// @{
  /// Returns the state after the last motion but one; the last two differ little after convergence.
  double GetResidual() const { return this->Residual; }
  std::size_t GetNumberOfPairs() const { return this->NumberOfPairs; }
  ///@}

private:
  using Cloud = pcl::PointCloud<pcl::PointNormal>;

  using Estimation =
    pcl::registration::CorrespondenceEstimation<pcl::PointNormal, pcl::PointNormal>;

  bool GoesOn(double iterations) const;
  Cloud::Ptr MakeCloud(const pcl::PointCloud<pcl::PointXYZ>::Ptr& points, double from);
  void BuildTree(Estimation& estimation);
  bool FindPairs(Estimation& estimation, const Cloud::Ptr& moved, int iteration,
    pcl::Correspondences& pairs) const;
  Cloud::Ptr Move() const;
  bool IsFlat(const pcl::PointNormal& point) const;
  void Reject(const Cloud& moved, pcl::Correspondences& pairs);
  bool LowerLimit();
  void Measure(const Cloud& moved, const pcl::Correspondences& pairs);
  Eigen::Isometry3d Estimate(const Cloud& moved, const pcl::Correspondences& pairs) const;

  Cloud::Ptr Fixed;
  std::vector<Eigen::Vector3d> Moving;
  Cloud::Ptr MovingNormals; // and their curvatures, in the initial orientation
  Eigen::Isometry3d Motion = Eigen::Isometry3d::Identity();
  double Limit = std::numeric_limits<double>::infinity(); // limit of distances from planes
  bool Stopped = false;
  bool Settled = false;
  double Residual = 0.0;
  std::size_t NumberOfPairs = 0;
};

} // namespace helios

#endif
