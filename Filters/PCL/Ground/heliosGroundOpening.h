// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The progressive morphological filter (Zhang et al. 2003), as in
// pcl::ProgressiveMorphologicalFilter with exponential windows. PCL's version reads all points of
// each window and cannot be stopped.

#ifndef heliosGroundOpening_h
#define heliosGroundOpening_h

#include "heliosChunks.h"
#include "vtkHeliosFiltersPCLModule.h" // For export macro

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/types.h>

namespace helios
{

struct GroundWindows
{
  float CellSize;          // [m]
  float MaximumWindowSize; // [m]
  float Slope;             // rise over run
  float InitialDistance;   // [m]
  float MaximumDistance;   // [m]
};

/// Finds the points whose height above their opening (the highest of the lowest of a window around
/// each) is within the limits for windows of growing size. False if it was stopped.
VTKHELIOSFILTERSPCL_EXPORT bool FindGround(const pcl::PointCloud<pcl::PointXYZ>& points,
  const GroundWindows& settings, const GoOn& goOn, pcl::Indices& ground);

} // namespace helios

#endif
