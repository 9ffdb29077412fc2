// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGroundHeight.h"

#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace helios::viewer
{

namespace
{

constexpr vtkIdType SampleSize = 20000;
constexpr std::size_t Closest = 8; // the ground is the lowest of these

} // namespace

//------------------------------------------------------------------------------
std::vector<Vec3> SampleMesh(vtkPolyData* scene)
{
  std::vector<Vec3> points;
  const vtkIdType count = scene ? scene->GetNumberOfPoints() : 0;
  const vtkIdType step = 1 + count / SampleSize;
  for (vtkIdType i = 0; i < count; i += step)
  {
    points.emplace_back(scene->GetPoint(i));
  }
  return points;
}

//------------------------------------------------------------------------------
double FindGround(const std::vector<Vec3>& points, const Vec3& place)
{
  std::vector<std::pair<double, double>> near; // distance, height
  near.reserve(points.size());
  for (const Vec3& point : points)
  {
    near.emplace_back(std::hypot(point[0] - place[0], point[1] - place[1]), point[2]);
  }
  const std::size_t count = std::min(Closest, near.size());
  std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end());
  double ground = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < count; ++i)
  {
    ground = std::fmin(ground, near[i].second);
  }
  return ground;
}

} // namespace helios::viewer
