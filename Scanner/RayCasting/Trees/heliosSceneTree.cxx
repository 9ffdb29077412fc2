// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosSceneTree.h"

#include "heliosStopCheck.h"
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

/// Returns a triangle for each instance of a scene, with the bounds of its box.
vtkSmartPointer<vtkPolyData> MakeBoxes(const SceneGeometry& scene)
{
  constexpr double rounding = 0x1p-48; // rounding of corners, beyond a box
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto boxes = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (const SceneInstance& instance : scene.GetInstances())
  {
    double b[6];
    scene.GetBounds(instance, b);
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
  boxes->SetPoints(points);
  boxes->SetPolys(polys);
  return boxes;
}

/// bytes of a box of MakeBoxes()
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
void SceneTree::Build(const TriangleMesh& mesh, StopCheck& check)
{
  this->Scene = nullptr;
  this->Prototypes.clear();
  this->Boxes = BeamTree();
  this->MeshTree.Build(mesh, check);
  this->Mesh = PlacedTree(this->MeshTree, nullptr);
}

//------------------------------------------------------------------------------
void SceneTree::Build(const HeightField& field)
{
  this->Scene = nullptr;
  this->Prototypes.clear();
  this->Boxes = BeamTree();
  this->MeshTree.Build(field);
  this->Mesh = PlacedTree(this->MeshTree, nullptr);
}

//------------------------------------------------------------------------------
void SceneTree::GetCellPoints(vtkIdType cell, double points[3][3]) const
{
  this->Scene ? this->Scene->GetCorners(cell, points) : this->MeshTree.GetCellPoints(cell, points);
}

//------------------------------------------------------------------------------
void SceneTree::Build(const SceneGeometry& scene, StopCheck& check)
{
  this->Build(scene.GetMesh(), check);
  if (scene.GetInstances().empty())
  {
    return;
  }
  this->Mesh = PlacedTree(this->MeshTree, &scene);
  this->Prototypes.resize(scene.GetPrototypes().size());
  for (std::size_t i = 0; i < this->Prototypes.size(); ++i)
  {
    const Prototype& prototype = scene.GetPrototypes()[i];
    prototype.IsRaster() ? this->Prototypes[i].Build(prototype.GetHeights())
                         : this->Prototypes[i].BuildWhole(prototype.GetMesh(), check);
  }
  if (this->BoxMesh.Set(MakeBoxes(scene)).IsOk())
  {
    this->Boxes.BuildWhole(this->BoxMesh, check);
    this->Scene = &scene;
  }
}

//------------------------------------------------------------------------------
std::size_t SceneTree::GetMemorySize() const
{
  std::size_t size = this->MeshTree.GetMemorySize() + this->Boxes.GetMemorySize() +
    SizeOfBox * static_cast<std::size_t>(this->BoxMesh.GetNumberOfTriangles());
  for (const BeamTree& tree : this->Prototypes)
  {
    size += tree.GetMemorySize();
  }
  return size;
}

//------------------------------------------------------------------------------
PlacedTree SceneTree::GetInstance(vtkTypeInt32 number) const
{
  const SceneInstance& instance = this->Scene->GetInstances()[static_cast<std::size_t>(number)];
  return { this->Prototypes[static_cast<std::size_t>(instance.PrototypeId)], instance };
}

//------------------------------------------------------------------------------
/// Visits the instances whose boxes a ray enters within a range, which visit() may reduce, until
/// visit() returns true; returns whether it did.
template <typename VisitT>
bool SceneTree::VisitInstances(const vtkHeliosRay& ray, const double& range, VisitT visit) const
{
  TestRay test;
  Frustum hull;
  if (!test.Set(ray) || !this->Boxes.SetFrustum(hull, test, 0.0))
  {
    return false;
  }
  BeamWalk walk(this->Boxes, hull);
  BeamTree::Leaf leaf;
  while (walk.GetNext(hull.GetLimit(range * std::abs(test.Largest)), leaf))
  {
    for (int i = 0; i < leaf.Count; ++i)
    {
      if (visit(this->GetInstance(leaf.Triangles[i])))
      {
        return true;
      }
    }
  }
  return false;
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
  vtkHeliosHit other = this->MeshTree.IntersectOutliers(rest);
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
    this->MeshTree.IsOccludedByOutliers(test);
}

} // namespace helios
