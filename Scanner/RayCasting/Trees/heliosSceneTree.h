// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The trees of a scene: of its mesh, of its prototypes, and of the boxes of its instances.

#ifndef heliosSceneTree_h
#define heliosSceneTree_h

#include "heliosBeamTree.h"
#include "heliosBoxTree.h"
#include "heliosMotionBoxes.h"
#include "heliosPlacedTree.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosRay.h"

#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace helios
{

class HeightField;
class MeshFrames;
class SceneGeometry;
class ShapePlan;
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

  /// Returns whether all instances are at rest over a span with that moment; whether the boxes of
  /// those that move hold them over it.
  bool IsAtRest(const MomentSpan& span) const;
  bool HasBoxes(const MomentSpan& span) const;

  std::size_t GetMemorySize() const;

  const PlacedTree& GetMesh() const { return this->Mesh; }

  bool HasInstances() const { return this->Scene != nullptr; }

  /// Visits the trees of the boxes of all instances that are not empty, until visit() returns
  /// false; returns whether it never did.
  template <typename VisitT>
  bool VisitBoxes(VisitT visit) const
  {
    const auto pass = [&visit](const BoxTree& boxes)
    { return boxes.Tree.IsEmpty() || visit(boxes); };
    return this->Motion ? pass(this->Shared->Resting) && pass(this->Moving->Boxes)
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

  /// The trees of a scene at rest; and what moves in it, for all threads.
  struct Trees
  {
    BeamTree Mesh;
    std::vector<BeamTree> Prototypes;
    BoxTree Boxes;
    BoxTree Resting;  ///< the boxes of the instances that never move, if others do
    std::mutex Mutex; ///< guards what follows
    std::vector<std::shared_ptr<MotionBoxes>> Motions; ///< those in use
    std::map<const MeshFrames*, std::shared_ptr<const ShapePlan>> Plans;

    /// Returns what all threads share of a mesh that deforms.
    std::shared_ptr<const ShapePlan> GetPlan(const MeshFrames& frames);
  };
  void AddShapes();

  std::shared_ptr<Trees> Shared = std::make_shared<Trees>();
  PlacedTree Mesh{ this->Shared->Mesh, nullptr };
  std::vector<const BeamTree*> Instanced;    ///< trees of instances, by their number
  const SceneGeometry* Scene = nullptr;      ///< null: no instances
  std::shared_ptr<MotionBoxes> Motion;       ///< null: all are at rest
  std::shared_ptr<const MovingBoxes> Moving; ///< boxes at the moment, if some move
};

} // namespace helios

#endif
