// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The trees of a scene: of its mesh, of its prototypes, and of the boxes of its instances.

#ifndef heliosSceneTree_h
#define heliosSceneTree_h

#include "heliosBeamTree.h"
#include "heliosPlacedTree.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosRay.h"

#include <vector>

namespace helios
{

class HeightField;
class SceneGeometry;
class StopCheck;

class VTKHELIOSSCANNERRAYCASTING_EXPORT SceneTree
{
public:
  SceneTree() = default;
  SceneTree(const SceneTree&) = delete;
  void operator=(const SceneTree&) = delete;

  /// Builds over one mesh, which must outlive it. Throws Stopped on an abort request, here and
  /// below, and is then unusable.
  void Build(const TriangleMesh& mesh, StopCheck& check);

  /// Builds over a height field, which must outlive it.
  void Build(const HeightField& field);

  /// Builds over a scene, which must outlive it.
  void Build(const SceneGeometry& scene, StopCheck& check);

  std::size_t GetMemorySize() const;

  const PlacedTree& GetMesh() const { return this->Mesh; }

  bool HasInstances() const { return this->Scene != nullptr; }

  /// Returns the tree of the boxes of the instances: what is in its leaves are numbers of
  /// instances.
  const BeamTree& GetBoxes() const { return this->Boxes; }
  PlacedTree GetInstance(vtkTypeInt32 number) const;

  /// Returns the corners of a cell.
  void GetCellPoints(vtkIdType cell, double points[3][3]) const;

  /// Returns the first hit of a ray, without the outliers of the mesh.
  vtkHeliosHit Intersect(const vtkHeliosRay& ray) const;

  /// Returns the better of a hit of a ray and its first hit of the outliers of the mesh.
  vtkHeliosHit AddOutliers(const vtkHeliosRay& ray, const vtkHeliosHit& hit) const;

  /// Sets a hit of a ray to the first one of a tree, if it is better.
  static void Intersect(const PlacedTree& placed, const vtkHeliosRay& ray, vtkHeliosHit& hit);

  /// A leaf that occluded a ray.
  struct Occluder
  {
    PlacedTree Placed;
    int Count = 0;
    vtkTypeInt32 Triangles[BeamTree::LeafSize];
  };

  /// Returns whether a ray is occluded; the occluder, initially empty, stopped the previous ray and
  /// is tested first.
  bool IsOccluded(const vtkHeliosRay& ray, Occluder& occluder) const;

private:
  bool FindOccluder(const PlacedTree& placed, const vtkHeliosRay& ray, Occluder& occluder) const;

  template <typename VisitT>
  bool VisitInstances(const vtkHeliosRay& ray, const double& range, VisitT visit) const;

  BeamTree MeshTree;
  PlacedTree Mesh{ this->MeshTree, nullptr };
  const SceneGeometry* Scene = nullptr; ///< null: no instances
  std::vector<BeamTree> Prototypes;
  TriangleMesh BoxMesh; ///< a triangle for each instance, with the bounds of its box
  BeamTree Boxes;
};

} // namespace helios

#endif
