// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The trees of a scene: of its mesh, of its prototypes, and of the boxes of its instances.

#ifndef heliosSceneTree_h
#define heliosSceneTree_h

#include "heliosBeamTree.h"
#include "heliosPlacedTree.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosRay.h"

#include <array>
#include <memory>
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

  /// Shares the trees over the same scene at rest, for a scene whose instances move and which must
  /// outlive it. One per thread.
  void Share(const SceneTree& atRest, const SceneGeometry& moving);

  /// Moves the instances to where they are at a moment.
  void MoveTo(const SceneMoment& moment);

  std::size_t GetMemorySize() const;

  const PlacedTree& GetMesh() const { return this->Mesh; }

  bool HasInstances() const { return this->Scene != nullptr; }

  /// A tree of the boxes of instances.
  struct BoxTree
  {
    TriangleMesh Mesh; ///< a triangle for each, with the bounds of its box
    BeamTree Tree;
    std::vector<int> Instances; ///< their numbers; empty: those of the triangles

    int GetInstance(vtkTypeInt32 triangle) const
    {
      return this->Instances.empty() ? triangle
                                     : this->Instances[static_cast<std::size_t>(triangle)];
    }
    void Build(const std::vector<std::array<double, 6>>& boxes, StopCheck& check);
    std::size_t GetMemorySize() const;
  };

  /// Visits the trees of the boxes of all instances that are not empty, until visit() returns
  /// false; returns whether it never did.
  template <typename VisitT>
  bool VisitBoxes(VisitT visit) const
  {
    const auto pass = [&visit](const BoxTree& boxes)
    { return boxes.Tree.IsEmpty() || visit(boxes); };
    return this->Moving ? pass(this->Shared->Resting) && pass(this->Moving->Boxes)
                        : pass(this->Shared->Boxes);
  }
  PlacedTree GetInstance(int number) const;

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

  /// The trees of a scene at rest.
  struct Trees
  {
    BeamTree Mesh;
    std::vector<BeamTree> Prototypes;
    BoxTree Boxes;
    BoxTree Resting; ///< the boxes of the instances that never move, if others do
  };
  /// The boxes of the instances that move, over a span.
  struct MovingBoxes
  {
    MomentSpan Span;
    vtkIdType Pulses = 64; ///< pulses of the next span: more if boxes grow little
    BoxTree Boxes;
  };
  double ComputeMovingBoxes(std::vector<std::array<double, 6>>& bounds) const;
  void BuildMovingBoxes(const SceneMoment& moment);

  std::shared_ptr<Trees> Shared = std::make_shared<Trees>();
  PlacedTree Mesh{ this->Shared->Mesh, nullptr };
  const SceneGeometry* Scene = nullptr; ///< null: no instances
  std::unique_ptr<MovingBoxes> Moving;  ///< null: all are at rest
};

} // namespace helios

#endif
