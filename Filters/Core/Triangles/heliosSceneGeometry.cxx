// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneGeometry.h"

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// A point array of instances: its values, or a default.
class InstanceColumn
{
public:
  InstanceColumn(vtkPolyData* instances, const char* name, int components, Status& status)
    : Array(instances->GetPointData()->GetArray(name))
  {
    if (this->Array &&
      (this->Array->GetNumberOfComponents() != components ||
        this->Array->GetNumberOfTuples() != instances->GetNumberOfPoints()))
    {
      status = Status::Error("point array " + std::string(name) + " of the instances has " +
        std::to_string(this->Array->GetNumberOfTuples()) + " tuples of " +
        std::to_string(this->Array->GetNumberOfComponents()) + " for " +
        std::to_string(instances->GetNumberOfPoints()) + " instances; expected one tuple of " +
        std::to_string(components) + " each");
    }
  }

  bool Exists() const { return this->Array; }
  double Get(vtkIdType i, int component, double byDefault) const
  {
    return this->Array ? this->Array->GetComponent(i, component) : byDefault;
  }

private:
  vtkDataArray* Array;
};

std::string ToText(double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string Describe(vtkIdType instance)
{
  return "instance " + std::to_string(instance) + " of the scene";
}

/// Returns an error unless the numbers of a place are valid.
Status CheckPlace(vtkIdType i, const double q[4], double scale, const double t[3])
{
  const double length = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3]));
  if (!std::isfinite(length) || length == 0.0)
  {
    return Status::Error(Describe(i) +
      " has an Orientation that is no rotation; set a quaternion " +
      "w, x, y, z, finite and not 0");
  }
  if (!std::isfinite(scale) || scale <= 0.0)
  {
    return Status::Error(
      Describe(i) + " has Scale " + ToText(scale) + "; set a number greater than 0");
  }
  if (!std::isfinite(t[0]) || !std::isfinite(t[1]) || !std::isfinite(t[2]))
  {
    return Status::Error(Describe(i) + " has a point that is not finite; set finite coordinates");
  }
  return {};
}

void Widen(double bounds[6], const double p[3])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = std::min(bounds[2 * axis], p[axis]);
    bounds[2 * axis + 1] = std::max(bounds[2 * axis + 1], p[axis]);
  }
}

void ClearBounds(double bounds[6])
{
  for (int axis = 0; axis < 3; ++axis)
  {
    bounds[2 * axis] = std::numeric_limits<double>::infinity();
    bounds[2 * axis + 1] = -std::numeric_limits<double>::infinity();
  }
}

} // namespace

//------------------------------------------------------------------------------
MovedInstances::MovedInstances(std::shared_ptr<const InstanceMotions> motions)
  : Motions(std::move(motions))
  , Slots(static_cast<std::size_t>(this->Motions->GetNumberOfTracks()))
{
}

//------------------------------------------------------------------------------
SceneGeometry SceneGeometry::MakeMoving(const std::shared_ptr<const InstanceMotions>& motions) const
{
  SceneGeometry moving = *this;
  moving.Moved = std::make_shared<MovedInstances>(motions);
  return moving;
}

//------------------------------------------------------------------------------
Status SceneGeometry::Set(vtkPolyData* scene)
{
  *this = SceneGeometry();
  this->Scene = scene;
  auto* whole = vtkHeliosScene::SafeDownCast(scene);
  if (!whole || whole->GetNumberOfInstances() == 0)
  {
    const Status status = this->Shared->Mesh.Set(scene);
    this->Shared->NumberOfTriangles = this->Shared->Mesh.GetNumberOfTriangles();
    return status;
  }
  Status status;
  if (scene->GetNumberOfCells() > 0)
  {
    vtkNew<vtkPolyData> mesh; // without the instances
    mesh->ShallowCopy(scene);
    status = this->Shared->Mesh.Set(mesh);
  }
  status = status.IsOk() ? this->AddPrototypes(whole) : status;
  status = status.IsOk() ? this->AddInstances(whole->GetInstances()) : status;
  return status.IsOk() ? this->SetCells(whole->GetInstances()) : status;
}

//------------------------------------------------------------------------------
Status SceneGeometry::AddPrototypes(vtkHeliosScene* scene)
{
  for (int i = 0; i < scene->GetNumberOfPrototypes(); ++i)
  {
    this->Shared->Prototypes.emplace_back();
    const Status status = this->Shared->Prototypes.back().Set(scene->GetPrototype(i));
    if (!status.IsOk())
    {
      return Status::Error("prototype " + std::to_string(i) + ": " + status.Message());
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status SceneGeometry::AddInstances(vtkPolyData* instances)
{
  Status status;
  const InstanceColumn prototypes(instances, names::PrototypeIds, 1, status);
  const InstanceColumn orientations(instances, names::Orientation, 4, status);
  const InstanceColumn scales(instances, names::Scale, 1, status);
  const InstanceColumn parts(instances, names::PartIds, 1, status);
  const InstanceColumn materials(instances, names::MaterialIds, 1, status);
  const InstanceColumn motions(instances, names::MotionIds, 1, status);
  const auto count = static_cast<double>(this->Shared->Prototypes.size());
  this->Shared->Instances.resize(static_cast<std::size_t>(instances->GetNumberOfPoints()));
  for (vtkIdType i = 0; status.IsOk() && i < instances->GetNumberOfPoints(); ++i)
  {
    const double prototype = prototypes.Get(i, 0, 0.0);
    if (!(prototype >= 0.0 && prototype < count))
    {
      return Status::Error(Describe(i) + " has PrototypeIds " + ToText(prototype) +
        ", but there are " + std::to_string(this->Shared->Prototypes.size()) +
        " prototypes, from 0");
    }
    const double q[4] = { orientations.Get(i, 0, 1.0), orientations.Get(i, 1, 0.0),
      orientations.Get(i, 2, 0.0), orientations.Get(i, 3, 0.0) };
    const double scale = scales.Get(i, 0, 1.0);
    const double* t = instances->GetPoint(i);
    status = CheckPlace(i, q, scale, t);
    SceneInstance& instance = this->Shared->Instances[static_cast<std::size_t>(i)];
    instance.Place = Similarity(q, scale, t);
    instance.PrototypeId = static_cast<int>(prototype);
    instance.Tree = instance.PrototypeId;
    instance.Part = static_cast<int>(parts.Get(i, 0, 0.0));
    instance.Material = static_cast<int>(materials.Get(i, 0, -1.0));
    instance.Motion = static_cast<int>(motions.Get(i, 0, -1.0));
  }
  return status;
}

//------------------------------------------------------------------------------
/// Sets the cell ids of the instances.
Status SceneGeometry::SetCells(vtkPolyData* instances)
{
  Status status;
  const InstanceColumn first(instances, names::FirstCellIds, 1, status);
  const vtkIdType own = this->Shared->Mesh.GetNumberOfTriangles();
  vtkIdType ofInstances = 0; // triangles of the instances before
  vtkIdType before = 0;      // triangles of the mesh before
  for (std::size_t i = 0; status.IsOk() && i < this->Shared->Instances.size(); ++i)
  {
    SceneInstance& instance = this->Shared->Instances[i];
    const auto id = static_cast<vtkIdType>(i);
    instance.FirstCell =
      first.Exists() ? static_cast<vtkIdType>(first.Get(id, 0, 0.0)) : own + ofInstances;
    instance.CellsBefore = instance.FirstCell - ofInstances;
    if (instance.CellsBefore < before || instance.CellsBefore > own)
    {
      return Status::Error(Describe(id) + " has FirstCellIds " +
        std::to_string(instance.FirstCell) + ", expected " + std::to_string(before + ofInstances) +
        " to " + std::to_string(own + ofInstances) + ": cell ids must ascend without gaps");
    }
    before = instance.CellsBefore;
    ofInstances += this->GetPrototype(instance).GetNumberOfTriangles();
  }
  this->Shared->NumberOfTriangles = own + ofInstances;
  return status;
}

//------------------------------------------------------------------------------
SceneGeometry::Cell SceneGeometry::FindInstance(vtkIdType cell) const
{
  const auto after =
    std::upper_bound(this->Shared->Instances.begin(), this->Shared->Instances.end(), cell,
      [](vtkIdType id, const SceneInstance& instance) { return id < instance.FirstCell; });
  if (after == this->Shared->Instances.begin())
  {
    return { nullptr, cell };
  }
  const SceneInstance& instance = *(after - 1);
  const vtkIdType triangle = cell - instance.FirstCell;
  const vtkIdType count = this->GetPrototype(instance).GetNumberOfTriangles();
  return triangle < count ? Cell{ &this->Place(instance), triangle }
                          : Cell{ nullptr, instance.CellsBefore + triangle - count };
}

//------------------------------------------------------------------------------
vtkIdType SceneGeometry::CountCells(vtkIdType triangle) const
{
  const auto after =
    std::upper_bound(this->Shared->Instances.begin(), this->Shared->Instances.end(), triangle,
      [](vtkIdType id, const SceneInstance& instance) { return id < instance.CellsBefore; });
  if (after == this->Shared->Instances.begin())
  {
    return triangle;
  }
  const SceneInstance& instance = *(after - 1);
  const vtkIdType end = instance.FirstCell + this->GetPrototype(instance).GetNumberOfTriangles();
  return end + triangle - instance.CellsBefore;
}

//------------------------------------------------------------------------------
void SceneGeometry::GetCorners(vtkIdType cell, double corners[3][3]) const
{
  const Cell at = this->Find(cell);
  if (at.Instance)
  {
    at.Instance->GetCorners(this->GetPrototype(*at.Instance), at.Triangle, corners);
    return;
  }
  for (int corner = 0; corner < 3; ++corner)
  {
    std::copy_n(this->Shared->Mesh.GetCorner(at.Triangle, corner), 3, corners[corner]);
  }
}

//------------------------------------------------------------------------------
Vec3 SceneGeometry::GetNormal(vtkIdType cell) const
{
  if (this->Shared->Instances.empty())
  {
    return this->Shared->Mesh.GetNormal(cell);
  }
  double p[3][3];
  this->GetCorners(cell, p);
  return GetTriangleNormal(p[0], p[1], p[2]);
}

//------------------------------------------------------------------------------
void SceneGeometry::GetBounds(double bounds[6]) const
{
  ClearBounds(bounds);
  if (this->Shared->Mesh.GetNumberOfTriangles() > 0)
  {
    this->Shared->Mesh.GetBounds(bounds);
  }
  for (const SceneInstance& instance : this->Shared->Instances)
  {
    double own[6];
    this->GetBounds(instance, own);
    const double low[3] = { own[0], own[2], own[4] };
    const double high[3] = { own[1], own[3], own[5] };
    Widen(bounds, low);
    Widen(bounds, high);
  }
}

//------------------------------------------------------------------------------
void SceneGeometry::GetBounds(const SceneInstance& instance, double bounds[6]) const
{
  ClearBounds(bounds);
  double own[6];
  this->GetPrototype(instance).GetBounds(own);
  for (int corner = 0; corner < 8; ++corner)
  {
    const double p[3] = { own[corner & 1], own[2 + (corner >> 1 & 1)], own[4 + (corner >> 2)] };
    double q[3];
    instance.Place.Apply(p, q);
    Widen(bounds, q);
  }
}

//------------------------------------------------------------------------------
std::size_t SceneGeometry::GetMemorySize() const
{
  std::size_t size =
    this->Shared->Mesh.GetMemorySize() + this->Shared->Instances.capacity() * sizeof(SceneInstance);
  for (const Prototype& prototype : this->Shared->Prototypes)
  {
    size += prototype.GetMemorySize();
  }
  return size;
}

} // namespace helios
