// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneLayer.h"

#include "heliosDrawnMesh.h"
#include "heliosSceneGeometry.h"
#include "vtkHeliosRayCasterFactory.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace helios::viewer
{

namespace
{

constexpr double Divisions = 160.0; // divisions of coarse meshes along the longest side, at most

/// Returns points in floats, relative to an origin.
vtkSmartPointer<vtkPoints> MakeLocal(vtkPolyData* mesh, const Vec3& origin)
{
  vtkNew<vtkFloatArray> xyz;
  xyz->SetNumberOfComponents(3);
  xyz->SetNumberOfTuples(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    for (int axis = 0; axis < 3; ++axis)
    {
      xyz->SetTypedComponent(i, axis, static_cast<float>(p[axis] - origin[axis]));
    }
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(xyz);
  return points;
}

} // namespace

//------------------------------------------------------------------------------
SceneLayer::SceneLayer(vtkRenderer* renderer, vtkProperty* property)
  : Renderer(renderer)
{
  const auto add = [&](vtkActor* actor, vtkPolyDataMapper* mapper)
  {
    mapper->SetScalarModeToUseCellData();
    actor->SetMapper(mapper);
    actor->SetProperty(property);
    actor->VisibilityOff();
    renderer->AddActor(actor);
  };
  add(this->Actor, this->Mapper);
  add(this->CoarseActor, this->CoarseMapper);
}

//------------------------------------------------------------------------------
SceneLayer::~SceneLayer()
{
  this->Renderer->RemoveActor(this->Actor);
  this->Renderer->RemoveActor(this->CoarseActor);
}

//------------------------------------------------------------------------------
void SceneLayer::SetMesh(vtkPolyData* mesh, const std::vector<vtkIdType>& cells)
{
  this->Mesh = mesh;
  this->Cells = cells;
  this->Caster = nullptr;
  this->Drawn = nullptr;
  this->Mapper->SetInputData(vtkNew<vtkPolyData>());
  this->DropCoarse();
  this->SetVisible(false);
}

//------------------------------------------------------------------------------
void SceneLayer::Move(vtkPolyData* mesh)
{
  vtkSmartPointer<vtkDataArray> colors =
    this->Drawn ? this->Drawn->GetCellData()->GetScalars() : nullptr;
  this->Mesh = mesh;
  this->Draw(this->Origin, this->Smooth);
  this->Drawn->GetCellData()->SetScalars(colors);
  this->DropCoarse();
  this->ShowWhatIsDue();
}

//------------------------------------------------------------------------------
void SceneLayer::Draw(const Vec3& origin, bool smooth)
{
  this->Origin = origin;
  this->Smooth = smooth;
  if (!this->Mesh)
  {
    return;
  }
  this->Drawn = vtkSmartPointer<vtkPolyData>::New();
  this->Drawn->SetPoints(MakeLocal(this->Mesh, origin));
  this->Drawn->SetPolys(this->Mesh->GetPolys());
  this->Drawn = smooth ? MakeSmooth(this->Drawn) : this->Drawn;
  this->DropCoarse();
  this->Mapper->SetInputData(this->Drawn);
}

//------------------------------------------------------------------------------
vtkIdType SceneLayer::GetSceneCell(vtkIdType cell) const
{
  return this->Cells.empty() || cell < 0 ? cell : this->Cells[static_cast<std::size_t>(cell)];
}

//------------------------------------------------------------------------------
void SceneLayer::Color(const std::function<Rgb(vtkIdType)>& getColor)
{
  if (!this->Drawn)
  {
    return;
  }
  const vtkIdType count = this->Drawn->GetNumberOfCells();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(count);
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    const Rgb color = getColor(this->GetSceneCell(cell));
    std::copy(color.begin(), color.end(), colors->GetPointer(3 * cell));
  }
  this->Drawn->GetCellData()->SetScalars(colors);
  this->DropCoarse();
  this->ShowWhatIsDue();
}

//------------------------------------------------------------------------------
void SceneLayer::SetVisible(bool on)
{
  this->Visible = on && this->Mesh;
  this->ShowWhatIsDue();
}

//------------------------------------------------------------------------------
void SceneLayer::SetInteracting(bool on)
{
  this->Interacting = on;
  this->ShowWhatIsDue();
}

//------------------------------------------------------------------------------
bool SceneLayer::IsCoarse() const
{
  return this->CoarseActor->GetVisibility() != 0;
}

//------------------------------------------------------------------------------
void SceneLayer::DropCoarse()
{
  this->Coarse = nullptr;
  this->CoarseMapper->SetInputData(vtkNew<vtkPolyData>());
}

//------------------------------------------------------------------------------
void SceneLayer::ShowWhatIsDue()
{
  const bool isCoarse = this->Visible && this->Interacting && this->Drawn &&
    this->Drawn->GetNumberOfCells() > MaximumWhileMoving;
  if (isCoarse && !this->Coarse)
  {
    this->Coarse = MakeCoarse(this->Drawn, MaximumWhileMoving, Divisions);
    this->CoarseMapper->SetInputData(this->Coarse);
  }
  this->Actor->SetVisibility(this->Visible && !isCoarse);
  this->CoarseActor->SetVisibility(isCoarse);
}

//------------------------------------------------------------------------------
void SceneLayer::SetClippingPlanes(vtkPlaneCollection* planes)
{
  this->Mapper->SetClippingPlanes(planes);
  this->CoarseMapper->SetClippingPlanes(planes);
}

//------------------------------------------------------------------------------
vtkHeliosHit SceneLayer::Pick(const vtkHeliosRay& ray, Vec3& normal)
{
  vtkHeliosHit hit;
  hit.CellId = -1;
  if (!this->IsVisible())
  {
    return hit;
  }
  if (!this->Caster)
  {
    this->Caster.TakeReference(vtkHeliosRayCasterFactory::Create(nullptr));
  }
  if (!this->Caster->Build(this->Mesh))
  {
    return hit;
  }
  this->Caster->Intersect(&ray, &hit, 1);
  if (hit.CellId >= 0)
  {
    normal = this->Caster->GetGeometry().GetNormal(hit.CellId);
    hit.CellId = this->GetSceneCell(hit.CellId);
  }
  return hit;
}

} // namespace helios::viewer
