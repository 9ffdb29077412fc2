// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a tree that a cone may touch. For sources only, which must first ignore -Wpsabi.

#ifndef heliosConeWalk_h
#define heliosConeWalk_h

#include "heliosCone.h"
#include "heliosLeafFilter.h"
#include "heliosPlacedTree.h"
#include "heliosSceneTree.h"
#include "heliosTriangleTest.h"
#include "vtkHeliosRay.h"

#include <algorithm>

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
 * Adds the triangles of a tree that may touch the cone, from front to back, as far as a depth along
 * its axis, which add() may reduce; false if add() returns false, or the cone is too wide. The axes
 * belong to the test of its axis. In the frame of the tree a length is scale times the length of
 * the depth; error: see BeamTree::SetFrustum().
 */
template <typename ConeType, typename AddT>
bool WalkTree(const ConeType& cone, const RayAxes& axes, const BeamTree& tree, double error,
  double scale, const double& farthest, AddT add)
{
  if (tree.IsEmpty())
  {
    return true;
  }
  Frustum hull;
  LeafFilter filter;
  if (!cone.SetHull(tree, axes, error, hull, filter))
  {
    return false;
  }
  const double stretch = scale * cone.GetStretch(axes);
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

/// Walks the tree of an instance, with the cone in the scene.
template <typename AddT>
bool WalkInstance(const Cone& cone, const PlacedTree& placed, const double& farthest, AddT add)
{
  const Similarity& place = placed.GetPlace();
  double origin[3], axis[3];
  place.ApplyInverseToPoint(cone.GetOrigin(), origin);
  place.ApplyInverse(cone.GetAxis(2), axis);
  TestRay local;
  return SetAxis(origin, axis, local) &&
    WalkTree(Cone(origin, axis, cone.GetTangent()), local.Axes, placed.GetTree(),
      placed.GetError(GetLargest(cone.GetOrigin())), 1.0 / place.Scale, farthest,
      [&](vtkTypeInt32 triangle) { return add(placed, triangle); });
}

/// Walks the instances of a scene whose boxes the cone enters.
template <typename ConeType, typename AddT>
bool WalkInstances(const ConeType& cone, const RayAxes& axes, const SceneTree& scene,
  const double& farthest, AddT add)
{
  return scene.VisitBoxes(
    [&](const BoxTree& boxes)
    {
      Frustum hull;
      LeafFilter unused; // leaves have boxes
      if (!cone.SetHull(boxes.Tree, axes, 0.0, hull, unused))
      {
        return false;
      }
      BeamWalk walk(boxes.Tree, hull);
      BeamTree::Leaf leaf;
      while (walk.GetNext(hull.GetLimit(farthest * cone.GetStretch(axes)), leaf))
      {
        for (int i = 0; i < leaf.Count; ++i)
        {
          const PlacedTree placed = scene.GetInstance(boxes.GetInstance(leaf.Triangles[i]));
          if (!WalkInstance(cone, placed, farthest, add))
          {
            return false;
          }
        }
      }
      return true;
    });
}

/// Walks all triangles of a scene; add() is given their tree, too.
template <typename ConeType, typename AddT>
bool WalkCone(const ConeType& cone, const RayAxes& axes, const SceneTree& scene,
  const double& farthest, AddT add)
{
  const PlacedTree& mesh = scene.GetMesh();
  const auto addOfMesh = [&](vtkTypeInt32 triangle) { return add(mesh, triangle); };
  const auto& outliers = mesh.GetTree().GetOutliers();
  return std::all_of(outliers.begin(), outliers.end(), addOfMesh) &&
    WalkTree(cone, axes, mesh.GetTree(), 0.0, 1.0, farthest, addOfMesh) &&
    (!scene.HasInstances() || WalkInstances(cone, axes, scene, farthest, add));
}

} // namespace helios

#endif
