// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosSceneTree.h"

#include "heliosShapeTree.h"
#include "heliosStopCheck.h"
#include "heliosTriangleTest.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace helios
{

namespace
{

/// Returns the boxes of the instances at rest, and sets the numbers of those that move.
std::vector<std::array<double, 6>> FindBoxes(const SceneGeometry& scene, std::vector<int>& moving)
{
  std::vector<std::array<double, 6>> boxes;
  for (const SceneInstance& instance : scene.GetInstances())
  {
    if (instance.Motion >= 0)
    {
      moving.push_back(static_cast<int>(boxes.size()));
    }
    boxes.emplace_back();
    scene.GetBounds(instance, boxes.back().data());
  }
  return boxes;
}

/// Prepares a ray for a tree; false if it is no ray.
bool SetRay(const PlacedTree& placed, const vtkHeliosRay& ray, TestRay& local)
{
  return local.Set(placed.IsMoved() ? placed.GetLocal(ray) : ray);
}

double GetError(const PlacedTree& placed, const vtkHeliosRay& ray)
{
  return placed.IsMoved() ? placed.GetError(GetLargest(ray.Origin)) : 0.0;
}

} // namespace

//------------------------------------------------------------------------------
void SceneTree::Build(const TriangleMesh& mesh, StopCheck& check)
{
  this->Scene = nullptr;
  this->Instanced.clear();
  this->Shared = std::make_shared<Trees>();
  this->Shared->Mesh.Build(mesh, check);
  this->Mesh = PlacedTree(this->Shared->Mesh, nullptr);
}

//------------------------------------------------------------------------------
void SceneTree::Build(const HeightField& field)
{
  this->Scene = nullptr;
  this->Shared = std::make_shared<Trees>();
  this->Shared->Mesh.Build(field);
  this->Mesh = PlacedTree(this->Shared->Mesh, nullptr);
}

//------------------------------------------------------------------------------
void SceneTree::GetCellPoints(vtkIdType cell, double points[3][3]) const
{
  this->Scene ? this->Scene->GetCorners(cell, points)
              : this->Shared->Mesh.GetCellPoints(cell, points);
}

//------------------------------------------------------------------------------
void SceneTree::Build(const SceneGeometry& scene, StopCheck& check)
{
  this->Build(scene.GetMesh(), check);
  if (scene.GetInstances().empty())
  {
    return;
  }
  Trees& trees = *this->Shared;
  this->Mesh = PlacedTree(trees.Mesh, &scene);
  trees.Prototypes.resize(scene.GetPrototypes().size());
  for (std::size_t i = 0; i < trees.Prototypes.size(); ++i)
  {
    const Prototype& prototype = scene.GetPrototypes()[i];
    prototype.IsRaster() ? trees.Prototypes[i].Build(prototype.GetHeights())
                         : trees.Prototypes[i].BuildWhole(prototype.GetMesh(), check);
  }
  for (const BeamTree& tree : trees.Prototypes)
  {
    this->Instanced.push_back(&tree);
  }
  std::vector<int> moving;
  std::vector<std::array<double, 6>> boxes = FindBoxes(scene, moving);
  trees.Boxes.Build(boxes, check);
  for (const int number : moving)
  {
    boxes[static_cast<std::size_t>(number)] = {}; // a triangle without area, which is in no tree
  }
  if (!moving.empty() && moving.size() < boxes.size())
  {
    trees.Resting.Build(boxes, check);
  }
  this->Scene = &scene;
}

//------------------------------------------------------------------------------
void SceneTree::Share(const SceneTree& atRest, const SceneGeometry& moving)
{
  this->Shared = atRest.Shared;
  this->Mesh = atRest.Mesh;
  this->Scene = &moving;
  this->Instanced = atRest.Instanced;
  this->AddShapes();
  this->Moving = std::make_shared<MovingBoxes>();
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  auto& all = this->Shared->Motions;
  const auto isOver = [](const std::shared_ptr<MotionBoxes>& each) { return each->IsOver(); };
  all.erase(std::remove_if(all.begin(), all.end(), isOver), all.end());
  const auto known = std::find_if(all.begin(), all.end(),
    [&](const std::shared_ptr<MotionBoxes>& each) { return each->IsOf(moving); });
  this->Motion = known != all.end() ? *known : std::make_shared<MotionBoxes>(moving);
  if (known == all.end())
  {
    all.push_back(this->Motion);
  }
}

//------------------------------------------------------------------------------
/// Adds the trees of instances that deform: they are fitted once rays enter their boxes.
void SceneTree::AddShapes()
{
  MovedInstances& moved = *this->Scene->GetMoved();
  for (const SceneInstance& instance : this->Scene->GetInstances())
  {
    const MeshFrames* frames =
      instance.Motion >= 0 ? moved.GetMotions()->GetFrames(instance.Motion) : nullptr;
    if (frames)
    {
      auto tree = std::make_unique<ShapeTree>(moved.GetShape(instance),
        [shared = this->Shared, frames] { return shared->GetPlan(*frames); });
      this->Instanced.push_back(&tree->GetTree());
      moved.SetFollower(instance, std::move(tree), static_cast<int>(this->Instanced.size()) - 1);
    }
  }
}

//------------------------------------------------------------------------------
std::shared_ptr<const ShapePlan> SceneTree::Trees::GetPlan(const MeshFrames& frames)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  std::shared_ptr<const ShapePlan>& plan = this->Plans[&frames];
  if (!plan)
  {
    plan = std::make_shared<ShapePlan>(frames);
  }
  return plan;
}

//------------------------------------------------------------------------------
void SceneTree::MoveTo(const SceneMoment& moment)
{
  this->Scene->GetMoved()->MoveTo(moment);
  if (!this->Moving->Span.Has(moment))
  {
    this->Moving = this->Motion->Get(*this->Scene, moment);
  }
}

//------------------------------------------------------------------------------
bool SceneTree::IsAtRest(const MomentSpan& span) const
{
  return !this->Motion || this->Scene->GetMoved()->GetMotions()->AreAtRest(span);
}

//------------------------------------------------------------------------------
bool SceneTree::HasBoxes(const MomentSpan& span) const
{
  return !this->Motion ||
    (this->Moving->Span.Has({ span.First, span.Start }) &&
      this->Moving->Span.Has({ span.Last, span.End }));
}

//------------------------------------------------------------------------------
std::size_t SceneTree::GetMemorySize() const
{
  const Trees& trees = *this->Shared;
  std::size_t size =
    trees.Mesh.GetMemorySize() + trees.Boxes.GetMemorySize() + trees.Resting.GetMemorySize();
  for (const BeamTree& tree : trees.Prototypes)
  {
    size += tree.GetMemorySize();
  }
  return size;
}

//------------------------------------------------------------------------------
PlacedTree SceneTree::GetInstance(int number) const
{
  const SceneInstance& instance = this->Scene->GetInstance(static_cast<std::size_t>(number));
  return { *this->Instanced[static_cast<std::size_t>(instance.Tree)], instance };
}

//------------------------------------------------------------------------------
/// Visits the instances whose boxes a ray enters within a range, which visit() may reduce, until
/// visit() returns true; returns whether it did.
template <typename VisitT>
bool SceneTree::VisitInstances(const vtkHeliosRay& ray, const double& range, VisitT visit) const
{
  TestRay test;
  if (!test.Set(ray))
  {
    return false;
  }
  return !this->VisitBoxes(
    [&](const BoxTree& boxes)
    {
      Frustum hull;
      boxes.Tree.SetFrustum(hull, test, 0.0);
      BeamWalk walk(boxes.Tree, hull);
      BeamTree::Leaf leaf;
      while (walk.GetNext(hull.GetLimit(range * std::abs(test.Largest)), leaf))
      {
        for (int i = 0; i < leaf.Count; ++i)
        {
          if (visit(this->GetInstance(boxes.GetInstance(leaf.Triangles[i]))))
          {
            return false;
          }
        }
      }
      return true;
    });
}

//------------------------------------------------------------------------------
void SceneTree::Intersect(const PlacedTree& placed, const vtkHeliosRay& ray, vtkHeliosHit& hit)
{
  TestRay local, rest; // its MaximumRange shrinks to the best hit so far
  Frustum hull;
  if (!rest.Set(ray) || !SetRay(placed, ray, local) ||
    !placed.GetTree().SetFrustum(hull, local, GetError(placed, ray)))
  {
    return;
  }
  rest.MaximumRange = std::min(rest.MaximumRange, hit.Range);
  const double speed = std::abs(local.Largest);
  BeamWalk walk(placed.GetTree(), hull);
  float limit = hull.GetLimit(rest.MaximumRange * speed);
  BeamTree::Leaf leaf;
  while (walk.GetNext(limit, leaf))
  {
    for (int i = 0; i < leaf.Count; ++i)
    {
      double buffer[3][3];
      const double* points[3];
      placed.GetPoints(leaf.Triangles[i], buffer, points);
      const double range = TestTriangle(rest, points);
      if (range > hit.Range || range == NoHit)
      {
        continue;
      }
      const vtkIdType cell = placed.GetCell(leaf.Triangles[i]);
      if (range < hit.Range || cell < hit.CellId)
      {
        hit = { range, cell };
        rest.MaximumRange = range;
        limit = hull.GetLimit(range * speed);
      }
    }
  }
}

vtkHeliosHit SceneTree::Intersect(const vtkHeliosRay& ray) const
{
  vtkHeliosHit hit{ NoHit, -1 };
  Intersect(this->Mesh, ray, hit);
  if (this->HasInstances())
  {
    double range = std::min(ray.MaximumRange, hit.Range);
    this->VisitInstances(ray, range,
      [&](const PlacedTree& placed)
      {
        Intersect(placed, ray, hit);
        range = std::min(range, hit.Range);
        return false;
      });
  }
  return hit;
}

//------------------------------------------------------------------------------
vtkHeliosHit SceneTree::AddOutliers(const vtkHeliosRay& ray, const vtkHeliosHit& hit) const
{
  TestRay rest;
  if (!rest.Set(ray))
  {
    return hit;
  }
  rest.MaximumRange = Min(rest.MaximumRange, hit.Range);
  vtkHeliosHit other = this->Mesh.GetTree().IntersectOutliers(rest);
  if (other.CellId < 0)
  {
    return hit;
  }
  other.CellId = this->Mesh.GetCell(other.CellId);
  const bool isBetter =
    other.Range < hit.Range || (other.Range == hit.Range && other.CellId < hit.CellId);
  return isBetter ? other : hit;
}

//------------------------------------------------------------------------------
namespace
{

bool IsHidden(
  const PlacedTree& placed, const TestRay& ray, int count, const vtkTypeInt32* triangles)
{
  for (int i = 0; i < count; ++i)
  {
    double buffer[3][3];
    const double* points[3];
    placed.GetPoints(triangles[i], buffer, points);
    if (TestTriangle(ray, points) < NoHit)
    {
      return true;
    }
  }
  return false;
}

} // namespace

bool SceneTree::FindOccluder(
  const PlacedTree& placed, const vtkHeliosRay& ray, Occluder& occluder) const
{
  TestRay test, local;
  Frustum hull;
  if (!test.Set(ray) || !SetRay(placed, ray, local) ||
    !placed.GetTree().SetFrustum(hull, local, GetError(placed, ray)))
  {
    return false;
  }
  BeamWalk walk(placed.GetTree(), hull);
  const float limit = hull.GetLimit(test.MaximumRange * std::abs(local.Largest));
  BeamTree::Leaf leaf;
  while (walk.GetNext(limit, leaf))
  {
    if (IsHidden(placed, test, leaf.Count, leaf.Triangles))
    {
      occluder.Placed = placed;
      occluder.Count = leaf.Count;
      std::copy_n(leaf.Triangles, leaf.Count, occluder.Triangles);
      return true;
    }
  }
  return false;
}

bool SceneTree::IsOccluded(const vtkHeliosRay& ray, Occluder& occluder) const
{
  TestRay test;
  if (!test.Set(ray))
  {
    return false;
  }
  const auto find = [&](const PlacedTree& placed)
  { return this->FindOccluder(placed, ray, occluder); };
  return IsHidden(occluder.Placed, test, occluder.Count, occluder.Triangles) || find(this->Mesh) ||
    (this->HasInstances() && this->VisitInstances(ray, test.MaximumRange, find)) ||
    this->Mesh.GetTree().IsOccludedByOutliers(test);
}

} // namespace helios
