// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A tree at its place in a scene.

#ifndef heliosPlacedTree_h
#define heliosPlacedTree_h

#include "heliosBeamTree.h"
#include "heliosSceneGeometry.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosRay.h"

#include <algorithm>
#include <cmath>

namespace helios
{

/**
 * The tree of the mesh of a scene, or of a prototype at an instance. Rays traverse the latter in
 * the frame of the prototype, but are tested against its triangles in the scene: hits equal the
 * hits of a copy of the prototype, to the last bit.
 */
class PlacedTree
{
public:
  PlacedTree() = default;

  /// Places the tree of a mesh; scene: gives the cell ids, null: the tree does.
  PlacedTree(const BeamTree& tree, const SceneGeometry* scene)
    : Tree(&tree)
    , Scene(scene)
  {
  }
  PlacedTree(const BeamTree& tree, const SceneInstance& instance)
    : Tree(&tree)
    , Instance(&instance)
    , HasFrame(!instance.Place.IsIdentity())
  {
  }

  const BeamTree& GetTree() const { return *this->Tree; }

  /// Returns whether it is an instance that moves over time.
  bool HasMotion() const { return this->Instance && this->Instance->Motion >= 0; }

  /// Returns whether another one is the same tree at the same place.
  bool IsSame(const PlacedTree& other) const
  {
    return this->Tree == other.Tree && this->Instance == other.Instance;
  }

  /// Returns whether the tree has a frame of its own, unlike the scene's.
  bool IsMoved() const { return this->HasFrame; }

  /// Returns the cell id of a triangle.
  vtkIdType GetCell(vtkIdType triangle) const
  {
    return this->Instance ? this->Instance->FirstCell + this->Tree->GetCell(triangle)
      : this->Scene       ? this->Scene->GetCell(triangle)
                          : this->Tree->GetCell(triangle);
  }

  /// Returns the corners of a triangle in the scene, in the buffer if they are not stored.
  void GetPoints(vtkTypeInt32 triangle, double buffer[3][3], const double* points[3]) const
  {
    this->Tree->GetPoints(triangle, buffer, points);
    for (int corner = 0; corner < 3 && this->IsMoved(); ++corner)
    {
      this->Instance->Place.Apply(points[corner], buffer[corner]);
      points[corner] = buffer[corner];
    }
  }

  /// Returns the properties of an instance, moved or not; for instances only.
  /// @{
  const Similarity& GetPlace() const { return this->Instance->Place; }

  /// Returns a ray in the frame of the tree, with the same ranges.
  vtkHeliosRay GetLocal(const vtkHeliosRay& ray) const
  {
    vtkHeliosRay local;
    this->GetPlace().ApplyInverseToPoint(ray.Origin, local.Origin);
    this->GetPlace().ApplyInverse(ray.Direction, local.Direction);
    local.MaximumRange = ray.MaximumRange;
    return local;
  }

  /**
   * Returns a bound of the distance by which a ray and a triangle in the frame of the tree differ
   * from the same in the scene, for a ray that starts within a distance of the scene's origin,
   * along each axis. Each coordinate is a sum of four terms of at most three times that size.
   */
  double GetError(double origin) const
  {
    constexpr double rounding = 64 * 0x1p-53;
    const Similarity& place = this->GetPlace();
    const Vec3 t = place.Translation + place.Scale * place.Pivot;
    const double shift = std::max({ std::abs(t[0]), std::abs(t[1]), std::abs(t[2]) });
    return rounding * ((origin + shift) / place.Scale + this->Tree->GetReach());
  }
  ///@}

private:
  const BeamTree* Tree = nullptr;
  const SceneGeometry* Scene = nullptr;
  const SceneInstance* Instance = nullptr;
  bool HasFrame = false;
};

/// Returns the largest coordinate of a point, without its sign.
inline double GetLargest(const double p[3])
{
  return std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
}

} // namespace helios

#endif
