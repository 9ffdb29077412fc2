// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneView.h"

#include "heliosLights.h"
#include "heliosMaterialColors.h"
#include "heliosSceneBounds.h"
#include "heliosSceneCells.h"
#include "heliosStatus.h"
#include "heliosTriangleMesh.h"
#include "heliosTurbidBoxes.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>

#include <algorithm>

namespace names = vtkHeliosArrayNames;

namespace helios::viewer
{

namespace
{

constexpr double BoxOpacity = 0.35; // opacity of voxels: echoes are seen through

/// Returns world coordinates relative to an origin, for a pixel at a depth in [0, 1].
Vec3 ToWorld(vtkRenderer* renderer, double x, double y, double depth)
{
  renderer->SetDisplayPoint(x, y, depth);
  renderer->DisplayToWorld();
  const double* p = renderer->GetWorldPoint();
  return Vec3(p[0] / p[3], p[1] / p[3], p[2] / p[3]);
}

/// Extracts some triangles of a scene with their own points, their parts and materials.
vtkSmartPointer<vtkPolyData> Extract(vtkPolyData* scene, const std::vector<vtkIdType>& cells)
{
  TriangleMesh mesh;
  static_cast<void>(mesh.Set(scene)); // checked by SetScene()
  auto some = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  std::vector<vtkIdType> known(static_cast<std::size_t>(scene->GetNumberOfPoints()), -1);
  some->GetCellData()->CopyAllocate(scene->GetCellData(), static_cast<vtkIdType>(cells.size()));
  for (const vtkIdType cell : cells)
  {
    vtkIdType corners[3];
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType point = mesh.GetCorners()[3 * cell + k];
      vtkIdType& id = known[static_cast<std::size_t>(point)];
      id = id >= 0 ? id : points->InsertNextPoint(scene->GetPoint(point));
      corners[k] = id;
    }
    some->GetCellData()->CopyData(scene->GetCellData(), cell, polys->InsertNextCell(3, corners));
  }
  some->SetPoints(points);
  some->SetPolys(polys);
  some->GetFieldData()->ShallowCopy(scene->GetFieldData());
  return some;
}

} // namespace

//------------------------------------------------------------------------------
SceneView::SceneView(vtkRenderer* renderer)
  : Renderer(renderer)
  , Resting(renderer, this->Look)
  , Moving(renderer, this->Look)
  , Instances(renderer, this->Look)
{
  this->Look->SetInterpolationToFlat();
  SetUpSurface(this->Look);
  this->BoxMapper->SetScalarModeToUseCellData();
  this->Boxes->SetMapper(this->BoxMapper);
  this->Boxes->GetProperty()->LightingOff(); // colours are already shaded
  this->Boxes->GetProperty()->SetOpacity(BoxOpacity);
  this->Boxes->GetProperty()->BackfaceCullingOn();
  this->Boxes->PickableOff();
  this->Boxes->VisibilityOff();
  renderer->AddActor(this->Boxes);
  this->DrawBoxes();
}

//------------------------------------------------------------------------------
SceneView::~SceneView()
{
  this->Renderer->RemoveActor(this->Boxes);
}

//------------------------------------------------------------------------------
Status SceneView::SetScene(vtkPolyData* scene)
{
  this->Scene = nullptr;
  this->Resting.SetMesh(nullptr);
  this->Moving.SetMesh(nullptr);
  this->Instances.SetScene(nullptr, this->Geometry);
  if (!scene)
  {
    return {};
  }
  if (scene->GetNumberOfCells() == 0 && !vtkHeliosScene::HasInstances(scene))
  {
    return Status::Error("the scene has no triangles: it cannot be shown");
  }
  const Status status = this->Geometry.Set(scene);
  if (!status.IsOk())
  {
    return Status::Error("the scene cannot be shown: " + status.Message());
  }
  this->Scene = scene;
  this->Cells = std::make_unique<SceneCells>(scene, this->Geometry);
  this->Materials = GetMaterials(scene);
  this->Resting.SetMesh(scene);
  if (vtkHeliosScene::HasInstances(scene))
  {
    this->Instances.SetScene(vtkHeliosScene::SafeDownCast(scene), this->Geometry);
  }
  this->DrawMesh();
  this->SetVisible(true);
  return {};
}

//------------------------------------------------------------------------------
void SceneView::SetMovingParts(const std::vector<int>& parts)
{
  std::vector<vtkIdType> cells[2]; // static, moving
  for (vtkIdType cell = 0; this->Scene && cell < this->Scene->GetNumberOfCells(); ++cell)
  {
    const int part = this->GetPart(cell);
    cells[std::count(parts.begin(), parts.end(), part) > 0 ? 1 : 0].push_back(cell);
  }
  const bool wasVisible = this->IsVisible();
  const bool isSplit = !cells[1].empty();
  this->Resting.SetMesh(nullptr);
  this->Moving.SetMesh(nullptr);
  if (!isSplit)
  {
    this->Resting.SetMesh(this->Scene);
  }
  for (const int layer : { 0, 1 })
  {
    if (isSplit && !cells[layer].empty())
    {
      SceneLayer& some = layer == 0 ? this->Resting : this->Moving;
      some.SetMesh(Extract(this->Scene, cells[layer]), cells[layer]);
    }
  }
  this->DrawMesh();
  this->SetVisible(wasVisible);
}

//------------------------------------------------------------------------------
void SceneView::Move(vtkPolyData* parts)
{
  if (this->Moving.GetMesh())
  {
    this->Moving.Move(parts);
  }
}

//------------------------------------------------------------------------------
void SceneView::SetGrids(const std::vector<vtkSmartPointer<vtkImageData>>& grids)
{
  this->Grids = grids;
  this->DrawBoxes();
  this->Boxes->SetVisibility(this->GetNumberOfBoxes() > 0 && this->IsVisible());
}

//------------------------------------------------------------------------------
vtkIdType SceneView::GetNumberOfBoxes() const
{
  vtkPolyData* boxes = this->BoxMapper->GetInput();
  return boxes ? boxes->GetNumberOfCells() / 6 : 0;
}

//------------------------------------------------------------------------------
void SceneView::DrawBoxes()
{
  this->BoxSets[0] = MakeTurbidBoxes(this->Grids, MaximumBoxes, this->Origin);
  this->BoxSets[1] = MakeTurbidBoxes(this->Grids, MaximumMovingBoxes, this->Origin);
  this->BoxMapper->SetInputData(this->BoxSets[this->Interacting ? 1 : 0]);
}

//------------------------------------------------------------------------------
void SceneView::SetInteracting(bool on)
{
  if (on != this->Interacting)
  {
    this->Interacting = on;
    this->Instances.SetInteracting(on);
    this->Resting.SetInteracting(on); // moving ones are rebuilt in each frame
    this->BoxMapper->SetInputData(this->BoxSets[on ? 1 : 0]);
  }
}

//------------------------------------------------------------------------------
void SceneView::DrawMesh()
{
  this->Resting.Draw(this->Origin, this->Smooth);
  this->Moving.Draw(this->Origin, this->Smooth);
  this->Instances.Draw(this->Origin, this->Smooth);
  this->ColorMesh();
}

//------------------------------------------------------------------------------
void SceneView::ColorMesh()
{
  std::vector<Rgb> colors;
  for (std::size_t row = 0; row < this->Materials.size(); ++row)
  {
    colors.push_back(GetMaterialColor(this->Materials[row], row));
  }
  const auto getColor = [&](vtkIdType triangle)
  {
    const vtkIdType cell = this->Geometry.GetCell(triangle);
    return this->GetColor(colors, this->Cells->GetPart(cell), this->Cells->GetMaterial(cell));
  };
  this->Resting.Color(getColor);
  this->Moving.Color(getColor);
  this->Instances.Color(
    [&](int part, int material) { return this->GetColor(colors, part, material); });
}

//------------------------------------------------------------------------------
Rgb SceneView::GetColor(const std::vector<Rgb>& materialColors, int part, int material) const
{
  if (part >= 0 && part == this->HighlightedPart)
  {
    return { HighlightColor[0], HighlightColor[1], HighlightColor[2] };
  }
  const auto row = static_cast<std::size_t>(std::max(0, material));
  return this->Cover.Over(this->ColorBy == Coloring::ByPart && part >= 0 ? GetDistinctColor(part)
      : row < materialColors.size()                                      ? materialColors[row]
                                                                         : Rgb{ 128, 128, 128 });
}

//------------------------------------------------------------------------------
void SceneView::SetOrigin(const Vec3& origin)
{
  this->Origin = origin;
  this->DrawMesh();
  this->DrawBoxes();
}

//------------------------------------------------------------------------------
void SceneView::SetColoring(Coloring coloring)
{
  this->ColorBy = coloring;
  this->ColorMesh();
}

//------------------------------------------------------------------------------
void SceneView::SetVeil(const Veil& veil)
{
  this->Cover = veil;
  this->ColorMesh();
}

//------------------------------------------------------------------------------
void SceneView::SetSection(const std::optional<Slab>& slab)
{
  this->Planes->RemoveAllItems();
  slab ? slab->RelativeTo(this->Origin).AddPlanes(this->Planes) : void();
  vtkPlaneCollection* planes = slab ? this->Planes.Get() : nullptr;
  this->Resting.SetClippingPlanes(planes);
  this->Moving.SetClippingPlanes(planes);
  this->Instances.SetClippingPlanes(planes);
  this->BoxMapper->SetClippingPlanes(planes);
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
  this->Look->SetInterpolation(on ? VTK_PHONG : VTK_FLAT);
  this->DrawMesh();
}

//------------------------------------------------------------------------------
void SceneView::SetOpacity(double opacity)
{
  this->Look->SetOpacity(std::min(std::max(opacity, 0.0), 1.0));
}

//------------------------------------------------------------------------------
void SceneView::SetWireframe(bool on)
{
  on ? this->Look->SetRepresentationToWireframe() : this->Look->SetRepresentationToSurface();
}

//------------------------------------------------------------------------------
void SceneView::SetVisible(bool on)
{
  this->Resting.SetVisible(on);
  this->Moving.SetVisible(on);
  this->Instances.SetVisible(on);
  this->Boxes->SetVisibility(on && this->GetNumberOfBoxes() > 0);
}

//------------------------------------------------------------------------------
bool SceneView::IsVisible() const
{
  return this->Resting.IsVisible() || this->Moving.IsVisible();
}

//------------------------------------------------------------------------------
int SceneView::GetPart(vtkIdType cell) const
{
  const bool isCell = this->Scene && cell >= 0 && cell < this->Geometry.GetNumberOfTriangles();
  return isCell ? this->Cells->GetPart(cell) : -1;
}

//------------------------------------------------------------------------------
std::optional<ScenePick> SceneView::Pick(double x, double y)
{
  const Vec3 begin = ToWorld(this->Renderer, x, y, 0.0) + this->Origin;
  const Vec3 way = ToWorld(this->Renderer, x, y, 1.0) + this->Origin - begin;
  const vtkHeliosRay ray{ { begin[0], begin[1], begin[2] }, { way[0], way[1], way[2] }, 1.0 };
  Vec3 normals[2];
  vtkHeliosHit hit = this->Resting.Pick(ray, normals[0]);
  const vtkHeliosHit moving = this->Moving.Pick(ray, normals[1]);
  const bool isMoving = moving.CellId >= 0 && (hit.CellId < 0 || moving.Range < hit.Range);
  hit = isMoving ? moving : hit;
  if (hit.CellId < 0)
  {
    return std::nullopt;
  }
  ScenePick pick;
  pick.Position = begin + way * hit.Range;
  const Vec3 normal = normals[isMoving ? 1 : 0];
  pick.Normal = normal.Dot(way) > 0.0 ? normal * -1.0 : normal;
  pick.Cell = hit.CellId;
  pick.Part = this->GetPart(hit.CellId);
  pick.PartName = pick.Part < 0 ? "" : this->GetPartName(pick.Part);
  pick.Material = std::max(0, this->Cells->GetMaterial(hit.CellId));
  const auto row = static_cast<std::size_t>(pick.Material);
  pick.MaterialName = row < this->Materials.size() ? this->Materials[row].Name : "";
  pick.IsGround = row < this->Materials.size() && this->Materials[row].IsGround;
  return pick;
}

//------------------------------------------------------------------------------
std::optional<double> SceneView::FindHeight(const Vec3& place)
{
  constexpr double above = 1.0; // [m], where the ray begins
  const vtkHeliosRay ray{ { place[0], place[1], place[2] + above }, { 0.0, 0.0, -1.0 } };
  Vec3 normal;
  const vtkHeliosHit hit = this->Resting.Pick(ray, normal);
  return hit.CellId < 0 ? std::nullopt : std::optional<double>(hit.Range - above);
}

//------------------------------------------------------------------------------
bool SceneView::GetBounds(double bounds[6]) const
{
  if (!this->Scene)
  {
    return false;
  }
  return GetSceneBounds(this->Scene, bounds).IsOk();
}

//------------------------------------------------------------------------------
bool SceneView::FindPart(const std::string& name, int& part, double bounds[6]) const
{
  vtkBoundingBox box;
  const vtkIdType count = this->Scene ? this->Geometry.GetMesh().GetNumberOfTriangles() : 0;
  const auto isNamed = [&](int id)
  {
    part = part < 0 && id >= 0 && this->GetPartName(id) == name ? id : part;
    return part >= 0 && id == part;
  };
  part = -1;
  for (vtkIdType triangle = 0; triangle < count; ++triangle)
  {
    const vtkIdType cell = this->Geometry.GetCell(triangle);
    double corners[3][3];
    if (isNamed(this->Cells->GetPart(cell)))
    {
      this->Geometry.GetCorners(cell, corners);
      std::for_each(corners, corners + 3, [&box](double* corner) { box.AddPoint(corner); });
    }
  }
  for (const SceneInstance& instance : this->Geometry.GetInstances())
  {
    double b[6];
    if (isNamed(instance.Part))
    {
      ComputeTightBounds(this->Geometry, instance, b);
      box.AddBounds(b);
    }
  }
  part >= 0 ? box.GetBounds(bounds) : void();
  return part >= 0;
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

} // namespace helios::viewer
