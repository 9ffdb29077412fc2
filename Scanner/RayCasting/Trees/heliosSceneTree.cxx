// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosSceneTree.h"

#include "heliosStopCheck.h"
#include "heliosThreadLoop.h"
#include "heliosTriangleTest.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// Returns a triangle for each box, with its bounds.
vtkSmartPointer<vtkPolyData> MakeTriangles(const std::vector<std::array<double, 6>>& boxes)
{
  constexpr double rounding = 0x1p-48; // rounding of corners, beyond a box
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (std::array<double, 6> b : boxes)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double margin = rounding *
        (std::max(std::abs(b[2 * axis]), std::abs(b[2 * axis + 1])) + b[2 * axis + 1] -
          b[2 * axis]);
      b[2 * axis] -= margin;
      b[2 * axis + 1] += margin;
    }
    const vtkIdType first = points->InsertNextPoint(b[0], b[2], b[4]);
    points->InsertNextPoint(b[1], b[2], b[5]);
    points->InsertNextPoint(b[0], b[3], b[5]);
    polys->InsertNextCell({ first, first + 1, first + 2 });
  }
  mesh->SetPoints(points);
  mesh->SetPolys(polys);
  return mesh;
}

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

double GetDiagonal(const double bounds[6])
{
  return std::hypot(bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4]);
}

/// bytes of a box of MakeTriangles()
constexpr std::size_t SizeOfBox = 9 * sizeof(double) + 4 * sizeof(vtkTypeInt32);

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
void SceneTree::BoxTree::Build(const std::vector<std::array<double, 6>>& boxes, StopCheck& check)
{
  this->Tree = BeamTree();
  if (!boxes.empty() && this->Mesh.Set(MakeTriangles(boxes)).IsOk())
  {
    this->Tree.BuildWhole(this->Mesh, check, 1); // all in a leaf that is entered are visited
  }
}

std::size_t SceneTree::BoxTree::GetMemorySize() const
{
  return this->Tree.GetMemorySize() +
    SizeOfBox * static_cast<std::size_t>(this->Mesh.GetNumberOfTriangles());
}

//------------------------------------------------------------------------------
void SceneTree::Build(const TriangleMesh& mesh, StopCheck& check)
{
  this->Scene = nullptr;
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
  this->Moving = std::make_unique<MovingBoxes>();
  FindBoxes(moving, this->Moving->Boxes.Instances);
}

//------------------------------------------------------------------------------
void SceneTree::MoveTo(const SceneMoment& moment)
{
  this->Scene->GetMoved()->MoveTo(moment);
  if (!this->Moving->Span.Has(moment))
  {
    this->BuildMovingBoxes(moment);
  }
}

//------------------------------------------------------------------------------
/// Computes the boxes of the moving instances over the span; returns the sum of their sizes,
/// relative to that of the boxes of their prototypes.
double SceneTree::ComputeMovingBoxes(std::vector<std::array<double, 6>>& bounds) const
{
  MovedInstances& moved = *this->Scene->GetMoved();
  double atRest = 0.0;
  double swept = 0.0;
  bounds.clear();
  for (const int number : this->Moving->Boxes.Instances)
  {
    const SceneInstance& instance = this->Scene->GetInstances()[static_cast<std::size_t>(number)];
    double own[6];
    this->Scene->GetPrototype(instance).GetBounds(own);
    bounds.emplace_back();
    moved.GetTrack(instance).ComputeBounds(this->Moving->Span, own, bounds.back().data());
    atRest += instance.Place.Scale * GetDiagonal(own);
    swept += GetDiagonal(bounds.back().data());
  }
  return swept / atRest;
}

//------------------------------------------------------------------------------
/// Builds the boxes in which the moving instances are over a span with a moment: of more pulses, the
/// less they move. Results do not depend on it.
void SceneTree::BuildMovingBoxes(const SceneMoment& moment)
{
  constexpr double small = 1.1; // relative sizes of boxes
  constexpr double large = 1.5;
  constexpr vtkIdType maximum = 8192;
  MovingBoxes& moving = *this->Moving;
  const auto count = static_cast<vtkIdType>(moving.Boxes.Instances.size());
  const InstanceMotions& motions = this->Scene->GetMoved()->GetMotions();
  std::vector<std::array<double, 6>> bounds;
  moving.Span = motions.GetSpan(moment, moving.Pulses);
  const double size = this->ComputeMovingBoxes(bounds);
  StopCheck never(nullptr);
  const OneThreadScope alone; // it runs between two pulses of a thread
  moving.Boxes.Build(bounds, never);
  if (size < small && moving.Pulses < maximum)
  {
    moving.Pulses *= 2;
  }
  else if (size > large && moving.Pulses > count)
  {
    moving.Pulses = std::max<vtkIdType>(1, moving.Pulses / 2);
  }
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
  return { this->Shared->Prototypes[static_cast<std::size_t>(instance.PrototypeId)], instance };
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
