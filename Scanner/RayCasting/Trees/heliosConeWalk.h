// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a tree that a cone may touch. For sources only, which must first ignore -Wpsabi.

#ifndef heliosConeWalk_h
#define heliosConeWalk_h

#include "heliosCone.h"
#include "heliosLeafFilter.h"
#include "heliosTriangleTest.h"
#include "vtkHeliosRay.h"

#include <algorithm>
#include <cmath>

namespace helios
{

/// Prepares the test of the ray along a cone's axis; false if it is no ray.
inline bool SetAxis(const double origin[3], const double axis[3], TestRay& test)
{
  vtkHeliosRay ray;
  std::copy_n(origin, 3, ray.Origin);
  std::copy_n(axis, 3, ray.Direction);
  return test.Set(ray);
}

/**
 * Adds all triangles that may touch the cone, from front to back, as far as a depth along its axis,
 * which add() may reduce; false if add() returns false, or the cone is too wide. The axes are those
 * of the test of its axis.
 */
template <typename AddT>
bool WalkCone(
  const Cone& cone, const RayAxes& axes, const BeamTree& tree, const double& farthest, AddT add)
{
  for (const vtkTypeInt32 triangle : tree.GetOutliers())
  {
    if (!add(triangle))
    {
      return false;
    }
  }
  if (tree.IsEmpty())
  {
    return true;
  }
  Frustum hull;
  LeafFilter filter;
  if (!cone.SetHull(tree, axes, hull, filter))
  {
    return false;
  }
  // A depth h along the axis is at most h (w_z + T sqrt(1 - w_z^2)) along the frustum's Z.
  constexpr double margin = 1e-9;
  const double w = std::abs(cone.GetAxis(2)[axes.Z]);
  const double stretch =
    (w + cone.GetTangent() * std::sqrt(std::max(0.0, 1 - w * w))) * (1 + margin);
  BeamWalk walk(tree, hull);
  BeamTree::Leaf leaf;
  float limit = hull.GetLimit(farthest * stretch);
  while (walk.GetNext(limit, leaf))
  {
    int isAlive[BeamTree::LeafSize];
    filter.FindAlive(leaf, limit, isAlive);
    for (int i = 0; i < leaf.Count; ++i)
    {
      if (isAlive[i] && !add(leaf.Triangles[i]))
      {
        return false;
      }
    }
    limit = hull.GetLimit(farthest * stretch);
  }
  return true;
}

} // namespace helios

#endif
