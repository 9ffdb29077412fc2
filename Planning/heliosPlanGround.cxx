// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlanGround.h"

#include "heliosGround.h"
#include "heliosMaterialTable.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// Finds, for each triangle of a mesh, whether it is ground; its materials are rows of the scene's
/// columns.
std::vector<bool> FindGround(vtkPolyData* mesh, vtkPolyData* scene)
{
  vtkNew<vtkPolyData> both;
  both->ShallowCopy(mesh);
  both->SetFieldData(scene->GetFieldData());
  return FindGroundCells(both);
}

bool AreAll(const std::vector<bool>& flags)
{
  return !flags.empty() && std::find(flags.begin(), flags.end(), false) == flags.end();
}

/// Copies some triangles of a mesh, with the same points; gets their ids.
std::vector<vtkIdType> CopySome(
  vtkPolyData* mesh, const std::vector<bool>& isCopied, vtkPolyData* part)
{
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  std::vector<vtkIdType> cells;
  for (std::size_t cell = 0; cell < isCopied.size(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* corners;
    if (isCopied[cell])
    {
      mesh->GetPolys()->GetCellAtId(static_cast<vtkIdType>(cell), size, corners);
      polys->InsertNextCell(size, corners);
      cells.push_back(static_cast<vtkIdType>(cell));
    }
  }
  part->SetPoints(mesh->GetPoints());
  part->SetPolys(polys);
  return cells;
}

} // namespace

//------------------------------------------------------------------------------
Status PlanGround::Set(vtkPolyData* scene)
{
  *this = PlanGround();
  this->Scene = scene;
  this->Mesh.IsGround = FindGround(scene, scene);
  if (!vtkHeliosScene::HasInstances(scene))
  {
    return {};
  }
  for (const Material& material : GetMaterials(scene))
  {
    this->IsGroundMaterial.push_back(material.IsGround);
  }
  auto* whole = vtkHeliosScene::SafeDownCast(scene);
  for (int i = 0; i < whole->GetNumberOfPrototypes(); ++i)
  {
    auto* mesh = vtkPolyData::SafeDownCast(whole->GetPrototype(i));
    Ground ground{ mesh ? FindGround(mesh, scene) : std::vector<bool>(), false, {} };
    ground.IsAll = mesh ? AreAll(ground.IsGround) : this->IsGroundMaterial[0]; // a raster has one
    this->Prototypes.push_back(ground);
  }
  return this->Geometry.Set(scene);
}

//------------------------------------------------------------------------------
const PlanGround::Ground& PlanGround::GetPrototype(const SceneInstance& instance) const
{
  return this->Prototypes[static_cast<std::size_t>(instance.PrototypeId)];
}

//------------------------------------------------------------------------------
/// Returns whether all triangles of an instance are ground.
bool PlanGround::IsWhole(const SceneInstance& instance) const
{
  const auto material = static_cast<std::size_t>(instance.Material);
  return instance.Material >= 0
    ? material < this->IsGroundMaterial.size() && this->IsGroundMaterial[material]
    : this->GetPrototype(instance).IsAll;
}

//------------------------------------------------------------------------------
/// Returns whether triangles of an instance are ground.
bool PlanGround::IsExtracted(const SceneInstance& instance) const
{
  return this->IsWhole(instance) ||
    (instance.Material < 0 && !this->GetPrototype(instance).IsGround.empty());
}

//------------------------------------------------------------------------------
bool PlanGround::IsEmpty() const
{
  const auto& instances = this->Geometry.GetInstances();
  return this->Mesh.IsGround.empty() &&
    std::none_of(instances.begin(), instances.end(),
      [this](const SceneInstance& instance) { return this->IsExtracted(instance); });
}

//------------------------------------------------------------------------------
bool PlanGround::Has(const SceneGeometry::Cell& at) const
{
  if (at.Instance && (at.Instance->Material >= 0 || this->IsWhole(*at.Instance)))
  {
    return this->IsWhole(*at.Instance);
  }
  const Ground& ground = at.Instance ? this->GetPrototype(*at.Instance) : this->Mesh;
  return !ground.IsGround.empty() && ground.IsGround[static_cast<std::size_t>(at.Triangle)];
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> PlanGround::Extract()
{
  auto part = vtkSmartPointer<vtkHeliosScene>::New();
  this->Mesh.Cells = CopySome(this->Scene, this->Mesh.IsGround, part);
  if (vtkHeliosScene::HasInstances(this->Scene))
  {
    this->ExtractInstances(vtkHeliosScene::SafeDownCast(this->Scene), part);
  }
  return part;
}

//------------------------------------------------------------------------------
void PlanGround::ExtractInstances(vtkHeliosScene* scene, vtkHeliosScene* part)
{
  vtkPolyData* all = scene->GetInstances();
  vtkNew<vtkPolyData> some;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> prototypes;
  prototypes->SetName(names::PrototypeIds);
  some->GetPointData()->CopyAllocate(all->GetPointData());
  for (std::size_t i = 0; i < this->Geometry.GetInstances().size(); ++i)
  {
    const SceneInstance& instance = this->Geometry.GetInstances()[i];
    if (this->IsExtracted(instance))
    {
      const auto id = static_cast<vtkIdType>(i);
      const bool isWhole = this->IsWhole(instance);
      some->GetPointData()->CopyData(
        all->GetPointData(), id, points->InsertNextPoint(all->GetPoint(id)));
      prototypes->InsertNextValue(this->AddPrototype(scene, instance.PrototypeId, isWhole, part));
      this->Sources.push_back({ &instance, isWhole });
    }
  }
  some->SetPoints(points);
  some->GetPointData()->RemoveArray(names::FirstCellIds);
  some->GetPointData()->AddArray(prototypes);
  part->SetInstances(some);
}

//------------------------------------------------------------------------------
/// Returns the number of an extracted prototype; adds a new one.
int PlanGround::AddPrototype(
  vtkHeliosScene* scene, int prototype, bool isWhole, vtkHeliosScene* part)
{
  const auto [number, isNew] =
    this->Numbers.emplace(std::pair(prototype, isWhole), part->GetNumberOfPrototypes());
  if (isNew && isWhole)
  {
    part->AddPrototype(scene->GetPrototype(prototype));
  }
  else if (isNew)
  {
    Ground& ground = this->Prototypes[static_cast<std::size_t>(prototype)];
    vtkNew<vtkPolyData> some;
    ground.Cells =
      CopySome(vtkPolyData::SafeDownCast(scene->GetPrototype(prototype)), ground.IsGround, some);
    part->AddPrototype(some);
  }
  return number->second;
}

//------------------------------------------------------------------------------
vtkIdType PlanGround::GetCell(const SceneGeometry& extracted, vtkIdType cell) const
{
  const SceneGeometry::Cell at = extracted.Find(cell);
  if (!at.Instance)
  {
    return this->Geometry.GetCell(this->Mesh.Cells[static_cast<std::size_t>(at.Triangle)]);
  }
  const auto number = static_cast<std::size_t>(at.Instance - extracted.GetInstances().data());
  const Source& source = this->Sources[number];
  const std::vector<vtkIdType>& cells = this->GetPrototype(*source.Instance).Cells;
  return source.Instance->FirstCell +
    (source.IsWhole ? at.Triangle : cells[static_cast<std::size_t>(at.Triangle)]);
}

} // namespace helios
