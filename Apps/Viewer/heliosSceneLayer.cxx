// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneLayer.h"

#include "heliosTriangleMesh.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace helios
{

namespace
{

/// Points in floats, less an origin.
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

vtkSmartPointer<vtkPolyData> MakeSmooth(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SetFeatureAngle(40.0);
  normals->ConsistencyOff(); // the order of the cells stays
  normals->Update();
  return normals->GetOutput();
}

} // namespace

//------------------------------------------------------------------------------
SceneLayer::SceneLayer(vtkRenderer* renderer, vtkProperty* property)
  : Renderer(renderer)
{
  this->Mapper->SetScalarModeToUseCellData();
  this->Actor->SetMapper(this->Mapper);
  this->Actor->SetProperty(property);
  this->Actor->VisibilityOff();
  renderer->AddActor(this->Actor);
}

//------------------------------------------------------------------------------
SceneLayer::~SceneLayer()
{
  this->Renderer->RemoveActor(this->Actor);
}

//------------------------------------------------------------------------------
void SceneLayer::SetMesh(vtkPolyData* mesh, const std::vector<vtkIdType>& cells)
{
  this->Mesh = mesh;
  this->Cells = cells;
  this->Caster = nullptr;
  this->Drawn = nullptr;
  this->Mapper->SetInputData(vtkNew<vtkPolyData>());
  this->Actor->VisibilityOff();
}

//------------------------------------------------------------------------------
void SceneLayer::Move(vtkPolyData* mesh)
{
  vtkSmartPointer<vtkDataArray> colors =
    this->Drawn ? this->Drawn->GetCellData()->GetScalars() : nullptr;
  this->Mesh = mesh;
  this->Draw(this->Origin, this->Smooth);
  this->Drawn->GetCellData()->SetScalars(colors);
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
}

//------------------------------------------------------------------------------
void SceneLayer::SetVisible(bool on)
{
  this->Actor->SetVisibility(on && this->Mesh);
}

//------------------------------------------------------------------------------
bool SceneLayer::IsVisible() const
{
  return this->Actor->GetVisibility() != 0;
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
    this->Caster.TakeReference(vtkHeliosRayCaster::Create(nullptr));
  }
  if (!this->Caster->Build(this->Mesh))
  {
    return hit;
  }
  this->Caster->Intersect(&ray, &hit, 1);
  if (hit.CellId >= 0)
  {
    normal = this->Caster->GetMesh().GetNormal(hit.CellId);
    hit.CellId = this->GetSceneCell(hit.CellId);
  }
  return hit;
}

} // namespace helios
