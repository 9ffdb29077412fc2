// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneView.h"

#include "heliosMaterialColors.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosRayCaster.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataNormals.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// The world's coordinates less an origin, of a depth in [0, 1] at a pixel.
Vec3 ToWorld(vtkRenderer* renderer, double x, double y, double depth)
{
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  const double* p = renderer->GetWorldPoint();
  return Vec3(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
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
SceneView::SceneView(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->Mapper->SetScalarModeToUseCellData();
  this->Actor->SetMapper(this->Mapper);
  this->Actor->GetProperty()->SetInterpolationToFlat();
  this->Actor->VisibilityOff();
  renderer->AddActor(this->Actor);
}

//------------------------------------------------------------------------------
SceneView::~SceneView()
{
  this->Renderer->RemoveActor(this->Actor);
}

//------------------------------------------------------------------------------
std::string SceneView::SetScene(vtkPolyData* scene)
{
  this->Scene = nullptr;
  this->Caster = nullptr;
  this->Mesh = nullptr;
  this->Mapper->SetInputData(vtkNew<vtkPolyData>());
  this->Actor->VisibilityOff();
  if (!scene)
  {
    return "";
  }
  if (scene->GetNumberOfCells() == 0)
  {
    return "the scene has no triangles: nothing of it can be shown";
  }
  const std::string fault = TriangleMesh().Set(scene);
  if (!fault.empty())
  {
    return "the scene cannot be shown: " + fault;
  }
  this->Scene = scene;
  this->Materials = GetMaterials(scene);
  this->MakeMesh();
  this->Actor->VisibilityOn();
  return "";
}

//------------------------------------------------------------------------------
void SceneView::MakeMesh()
{
  vtkNew<vtkFloatArray> xyz;
  xyz->SetNumberOfComponents(3);
  xyz->SetNumberOfTuples(this->Scene->GetNumberOfPoints());
  for (vtkIdType i = 0; i < this->Scene->GetNumberOfPoints(); ++i)
  {
    double p[3];
    this->Scene->GetPoint(i, p);
    for (int axis = 0; axis < 3; ++axis)
    {
      xyz->SetTypedComponent(i, axis, static_cast<float>(p[axis] - this->Origin[axis]));
    }
  }
  vtkNew<vtkPoints> points;
  points->SetData(xyz);
  this->Mesh = vtkSmartPointer<vtkPolyData>::New();
  this->Mesh->SetPoints(points);
  this->Mesh->SetPolys(this->Scene->GetPolys());
  if (this->Smooth)
  {
    this->Mesh = MakeSmooth(this->Mesh);
  }
  this->ColorMesh();
  this->Mapper->SetInputData(this->Mesh);
}

//------------------------------------------------------------------------------
void SceneView::ColorMesh()
{
  if (!this->Mesh)
  {
    return;
  }
  vtkDataArray* parts = this->Scene->GetCellData()->GetArray(names::PartIds);
  vtkDataArray* materials = this->Scene->GetCellData()->GetArray(names::MaterialIds);
  std::vector<Rgb> materialColors;
  for (std::size_t row = 0; row < this->Materials.size(); ++row)
  {
    materialColors.push_back(GetMaterialColor(this->Materials[row], row));
  }
  const vtkIdType count = this->Mesh->GetNumberOfCells();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(count);
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    const int part = parts ? static_cast<int>(parts->GetComponent(cell, 0)) : -1;
    const auto row = static_cast<std::size_t>(materials ? materials->GetComponent(cell, 0) : 0.0);
    Rgb color = row < materialColors.size() ? materialColors[row] : Rgb{ 128, 128, 128 };
    if (this->ColorBy == Coloring::ByPart && part >= 0)
    {
      color = GetDistinctColor(part);
    }
    const bool isHighlighted = part >= 0 && part == this->HighlightedPart;
    const unsigned char* rgb = isHighlighted ? HighlightColor : color.data();
    std::copy(rgb, rgb + 3, colors->GetPointer(3 * cell));
  }
  this->Mesh->GetCellData()->SetScalars(colors);
}

//------------------------------------------------------------------------------
void SceneView::SetOrigin(const Vec3& origin)
{
  this->Origin = origin;
  if (this->Scene)
  {
    this->MakeMesh();
  }
}

//------------------------------------------------------------------------------
void SceneView::SetColoring(Coloring coloring)
{
  this->ColorBy = coloring;
  this->ColorMesh();
}

//------------------------------------------------------------------------------
void SceneView::SetHighlightedPart(int part)
{
  this->HighlightedPart = part;
  this->ColorMesh();
}

//------------------------------------------------------------------------------
void SceneView::SetSmooth(bool on)
{
  this->Smooth = on;
  this->Actor->GetProperty()->SetInterpolation(on ? VTK_PHONG : VTK_FLAT);
  if (this->Scene)
  {
    this->MakeMesh();
  }
}

//------------------------------------------------------------------------------
void SceneView::SetOpacity(double opacity)
{
  this->Actor->GetProperty()->SetOpacity(std::min(std::max(opacity, 0.0), 1.0));
}

//------------------------------------------------------------------------------
void SceneView::SetWireframe(bool on)
{
  vtkProperty* property = this->Actor->GetProperty();
  on ? property->SetRepresentationToWireframe() : property->SetRepresentationToSurface();
}

//------------------------------------------------------------------------------
void SceneView::SetVisible(bool on)
{
  this->Actor->SetVisibility(on && this->Scene);
}

//------------------------------------------------------------------------------
bool SceneView::IsVisible() const
{
  return this->Actor->GetVisibility() != 0;
}

//------------------------------------------------------------------------------
int SceneView::GetCellId(const char* name, vtkIdType cell) const
{
  vtkDataArray* ids = this->Scene->GetCellData()->GetArray(name);
  return ids ? static_cast<int>(ids->GetComponent(cell, 0)) : -1;
}

//------------------------------------------------------------------------------
std::optional<ScenePick> SceneView::Pick(double x, double y)
{
  if (!this->IsVisible())
  {
    return std::nullopt;
  }
  if (!this->Caster)
  {
    this->Caster.TakeReference(vtkHeliosRayCaster::Create(nullptr));
  }
  if (!this->Caster->Build(this->Scene))
  {
    return std::nullopt;
  }
  const Vec3 begin = ToWorld(this->Renderer, x, y, 0.0) + this->Origin;
  const Vec3 way = ToWorld(this->Renderer, x, y, 1.0) + this->Origin - begin;
  const vtkHeliosRay ray{ { begin[0], begin[1], begin[2] }, { way[0], way[1], way[2] }, 1.0 };
  vtkHeliosHit hit;
  this->Caster->Intersect(&ray, &hit, 1);
  if (hit.CellId < 0)
  {
    return std::nullopt;
  }
  ScenePick pick;
  pick.Position = begin + way * hit.Range;
  const Vec3 normal = this->Caster->GetMesh().GetNormal(hit.CellId);
  pick.Normal = normal.Dot(way) > 0.0 ? normal * -1.0 : normal;
  pick.Cell = hit.CellId;
  pick.Part = this->GetCellId(names::PartIds, hit.CellId);
  pick.PartName = pick.Part < 0 ? "" : this->GetPartName(pick.Part);
  pick.Material = std::max(0, this->GetCellId(names::MaterialIds, hit.CellId));
  const auto row = static_cast<std::size_t>(pick.Material);
  pick.MaterialName = row < this->Materials.size() ? this->Materials[row].Name : "";
  pick.IsGround = row < this->Materials.size() && this->Materials[row].IsGround;
  return pick;
}

//------------------------------------------------------------------------------
bool SceneView::GetBounds(double bounds[6]) const
{
  if (!this->Scene)
  {
    return false;
  }
  this->Scene->GetPoints()->GetBounds(bounds);
  return true;
}

//------------------------------------------------------------------------------
std::string SceneView::GetPartName(int part) const
{
  vtkFieldData* fields = this->Scene ? this->Scene->GetFieldData() : nullptr;
  auto* texts =
    fields ? vtkStringArray::SafeDownCast(fields->GetAbstractArray(names::PartName)) : nullptr;
  const bool isNamed = texts && part >= 0 && part < texts->GetNumberOfValues();
  return isNamed ? std::string(texts->GetValue(part)) : std::to_string(part);
}

} // namespace helios
