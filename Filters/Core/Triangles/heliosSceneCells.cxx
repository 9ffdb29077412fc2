// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneCells.h"

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>

#include <cmath>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// Returns a cell array of a mesh; null: it has none of as many components.
vtkDataArray* FindArray(vtkPolyData* mesh, const char* name, int components)
{
  vtkDataArray* array = mesh->GetCellData()->GetArray(name);
  return array && array->GetNumberOfComponents() == components ? array : nullptr;
}

int GetId(vtkDataArray* ids, vtkIdType cell, int byDefault)
{
  const bool isKnown = ids && cell < ids->GetNumberOfTuples();
  return isKnown ? static_cast<int>(ids->GetComponent(cell, 0)) : byDefault;
}

} // namespace

/// Rounds to float. Not inlined: GCC 12 drops the conversions to float and back of a vector of
/// doubles.
__attribute__((noinline)) double RoundToFloat(double x)
{
  return static_cast<float>(x);
}

//------------------------------------------------------------------------------
SceneCells::SceneCells(vtkPolyData* scene, const SceneGeometry& geometry)
  : Geometry(geometry)
{
  const auto find = [](vtkPolyData* mesh) // null: a raster
  {
    return !mesh ? Arrays()
                 : Arrays{ FindArray(mesh, names::PartIds, 1),
                     FindArray(mesh, names::MaterialIds, 1), FindArray(mesh, names::Normals, 3) };
  };
  this->Mesh = find(scene);
  auto* whole = vtkHeliosScene::SafeDownCast(scene);
  for (int i = 0; whole && i < whole->GetNumberOfPrototypes(); ++i)
  {
    this->Prototypes.push_back(find(vtkPolyData::SafeDownCast(whole->GetPrototype(i))));
  }
}

//------------------------------------------------------------------------------
const SceneCells::Arrays& SceneCells::GetArrays(const SceneGeometry::Cell& at) const
{
  return at.Instance ? this->Prototypes[static_cast<std::size_t>(at.Instance->PrototypeId)]
                     : this->Mesh;
}

//------------------------------------------------------------------------------
int SceneCells::GetPart(vtkIdType cell) const
{
  const SceneGeometry::Cell at = this->Geometry.Find(cell);
  const int byDefault = this->Geometry.GetInstances().empty() ? -1 : 0;
  return at.Instance ? at.Instance->Part : GetId(this->Mesh.Parts, at.Triangle, byDefault);
}

//------------------------------------------------------------------------------
int SceneCells::GetMaterial(vtkIdType cell) const
{
  const SceneGeometry::Cell at = this->Geometry.Find(cell);
  const int byDefault = this->Geometry.GetInstances().empty() ? -1 : 0;
  return at.Instance && at.Instance->Material >= 0
    ? at.Instance->Material
    : GetId(this->GetArrays(at).Materials, at.Triangle, byDefault);
}

//------------------------------------------------------------------------------
bool SceneCells::GetNormal(vtkIdType cell, Vec3& normal) const
{
  const SceneGeometry::Cell at = this->Geometry.Find(cell);
  vtkDataArray* normals = this->GetArrays(at).Normals;
  if (!normals || at.Triangle >= normals->GetNumberOfTuples())
  {
    return false;
  }
  Vec3 given;
  normals->GetTuple(at.Triangle, given.GetData());
  if (at.Instance)
  {
    const Vec3 turned = at.Instance->Place.Rotate(given);
    given = { RoundToFloat(turned[0]), RoundToFloat(turned[1]), RoundToFloat(turned[2]) };
  }
  const double length = given.Norm();
  const bool isValid = length > 0.0 && std::isfinite(length);
  normal = isValid ? given.Normalized() : normal;
  return isValid;
}

} // namespace helios
