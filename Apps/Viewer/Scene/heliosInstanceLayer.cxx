// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInstanceLayer.h"

#include "heliosSceneGeometry.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkIntArray.h>
#include <vtkMath.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace names = vtkHeliosArrayNames;

namespace helios::viewer
{

namespace
{

constexpr const char* SourceName = "Source";

/// Density of the triangles that fill the pixels of a sphere, and its reduction in the next trial.
constexpr double FirstDensity = 1.0;
constexpr double NextDensity = 0.5;
constexpr int MaximumTrials = 12;

/// Returns the triangles of each material of a mesh.
std::map<int, std::vector<vtkTypeInt32>> SortByMaterial(vtkDataSet* data, vtkIdType count)
{
  vtkDataArray* ids = data->GetCellData()->GetArray(names::MaterialIds);
  std::map<int, std::vector<vtkTypeInt32>> sorted;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const int material = ids ? static_cast<int>(ids->GetComponent(i, 0)) : 0;
    sorted[material].push_back(static_cast<vtkTypeInt32>(i));
  }
  return sorted;
}

} // namespace

/// The camera of a frame.
struct InstanceLayer::View
{
  explicit View(vtkRenderer* renderer)
    : Camera(renderer->GetActiveCamera())
    , Position(Camera->GetPosition())
  {
    this->Camera->GetFrustumPlanes(renderer->GetTiledAspectRatio(), this->Planes);
    const double half = this->Camera->GetParallelProjection()
      ? this->Camera->GetParallelScale()
      : std::tan(vtkMath::RadiansFromDegrees(0.5 * this->Camera->GetViewAngle()));
    this->PixelsPerUnit = 0.5 * renderer->GetSize()[1] / half;
  }

  /// Returns whether a part of a sphere is within the sides of the view.
  bool Sees(const Vec3& centre, double radius) const
  {
    for (int side = 0; side < 4; ++side)
    {
      const double* p = this->Planes + 4 * side;
      if (p[0] * centre[0] + p[1] * centre[1] + p[2] * centre[2] + p[3] < -radius)
      {
        return false;
      }
    }
    return true;
  }

  /// Returns the pixels of a sphere; infinite around the camera.
  double GetPixels(const Vec3& centre, double radius) const
  {
    const double distance = (centre - this->Position).Norm() - radius;
    const double depth = this->Camera->GetParallelProjection() ? 1.0 : std::max(0.0, distance);
    const double size = radius * this->PixelsPerUnit / depth;
    return M_PI * size * size;
  }

  vtkCamera* Camera;
  Vec3 Position;
  double Planes[24];
  double PixelsPerUnit; ///< at distance 1
};

//------------------------------------------------------------------------------
InstanceLayer::InstanceLayer(vtkRenderer* renderer, vtkProperty* property)
  : Renderer(renderer)
{
  this->Sources->SetName(SourceName);
  this->Mapper->SetInputData(this->Places);
  this->Mapper->SetOrientationArray(names::Orientation);
  this->Mapper->SetOrientationModeToQuaternion();
  this->Mapper->SetScaleArray(names::Scale);
  this->Mapper->SetScaleModeToScaleByMagnitude();
  this->Mapper->SetSourceIndexArray(SourceName);
  this->Mapper->SourceIndexingOn();
  this->Mapper->ClampingOff();
  this->Mapper->SetScalarModeToUsePointData();
  this->Mapper->SetColorModeToDirectScalars();
  this->Actor->SetMapper(this->Mapper);
  this->Actor->SetProperty(property);
  this->Actor->VisibilityOff();
  renderer->AddActor(this->Actor);
  this->Observer = renderer->AddObserver(vtkCommand::StartEvent, this, &InstanceLayer::ShowVisible);
}

//------------------------------------------------------------------------------
InstanceLayer::~InstanceLayer()
{
  this->Renderer->RemoveObserver(this->Observer);
  this->Renderer->RemoveActor(this->Actor);
}

//------------------------------------------------------------------------------
void InstanceLayer::SetScene(vtkHeliosScene* scene, const SceneGeometry& geometry)
{
  this->Scene = scene;
  this->Geometry = &geometry;
  this->Prototypes.clear();
  this->Meshes.clear();
  this->FirstSource.clear();
  this->Glyphs.clear();
  this->Places->Initialize();
  this->NumberOfTriangles = 0;
  for (int i = 0; scene && i < scene->GetNumberOfPrototypes(); ++i)
  {
    this->AddPrototype(
      scene->GetPrototype(i), geometry.GetPrototypes()[static_cast<std::size_t>(i)]);
  }
  if (scene)
  {
    this->AddSources();
    this->AddGlyphs();
  }
  this->SetVisible(false);
}

//------------------------------------------------------------------------------
void InstanceLayer::AddPrototype(vtkDataSet* data, const helios::Prototype& triangles)
{
  double b[6];
  triangles.GetBounds(b);
  Prototype prototype;
  prototype.Centre = 0.5 * Vec3(b[0] + b[1], b[2] + b[3], b[4] + b[5]);
  prototype.Radius = 0.5 * Vec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]).Norm();
  const auto add = [&](int material, std::unique_ptr<PrototypeMesh> mesh)
  {
    prototype.Materials.push_back(material);
    prototype.Meshes.push_back(this->Meshes.size());
    this->Meshes.push_back(std::move(mesh));
  };
  if (triangles.IsRaster())
  {
    add(0, std::make_unique<PrototypeRaster>(triangles.GetHeights(), prototype.Centre));
  }
  else
  {
    const TriangleMesh& mesh = triangles.GetMesh();
    for (auto& [material, some] : SortByMaterial(data, mesh.GetNumberOfTriangles()))
    {
      add(material, std::make_unique<PrototypeTriangles>(mesh, std::move(some), prototype.Centre));
    }
  }
  this->Prototypes.push_back(prototype);
}

//------------------------------------------------------------------------------
/// Adds empty sources, to be replaced by the levels of meshes that are drawn.
void InstanceLayer::AddSources()
{
  int count = 0;
  for (const auto& mesh : this->Meshes)
  {
    this->FirstSource.push_back(count);
    count += mesh->GetNumberOfLevels();
  }
  this->FirstSource.push_back(count);
  this->Set.assign(static_cast<std::size_t>(count) + 1, nullptr);
  vtkNew<vtkPolyData> nothing;
  this->Mapper->RemoveAllInputConnections(1);
  for (int i = 0; i <= count; ++i)
  {
    this->Mapper->SetSourceData(i, nothing);
  }
  this->Mapper->SetRange(0.0, count + 1.0); // a source for every number
}

//------------------------------------------------------------------------------
void InstanceLayer::AddGlyphs()
{
  const auto& instances = this->Geometry->GetInstances();
  for (std::size_t i = 0; i < instances.size(); ++i)
  {
    const Prototype& prototype =
      this->Prototypes[static_cast<std::size_t>(instances[i].PrototypeId)];
    for (std::size_t k = 0; k < prototype.Meshes.size(); ++k)
    {
      const int material =
        instances[i].Material >= 0 ? instances[i].Material : prototype.Materials[k];
      this->Glyphs.push_back({ i, material, prototype.Meshes[k] });
      this->NumberOfTriangles += this->Meshes[prototype.Meshes[k]]->GetCount(0);
    }
  }
  this->Chosen.assign(this->Glyphs.size(), -1);
}

//------------------------------------------------------------------------------
void InstanceLayer::Draw(const Vec3& origin, bool smooth)
{
  if (!this->Scene)
  {
    return;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> orientations, scales;
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  scales->SetName(names::Scale);
  this->Sources->SetNumberOfValues(static_cast<vtkIdType>(this->Glyphs.size()));
  this->Sources->FillValue(this->FirstSource.back());
  this->Centres.clear();
  this->Radii.clear();
  vtkDataArray* given = this->Scene->GetInstances()->GetPointData()->GetArray(names::Orientation);
  for (const Glyph& glyph : this->Glyphs)
  {
    const SceneInstance& instance = this->Geometry->GetInstances()[glyph.Instance];
    const Prototype& prototype = this->Prototypes[static_cast<std::size_t>(instance.PrototypeId)];
    Vec3 centre;
    instance.Place.Apply(prototype.Centre.GetData(), centre.GetData());
    centre = centre - origin;
    Quaternion q(1.0, 0.0, 0.0, 0.0);
    given ? given->GetTuple(static_cast<vtkIdType>(glyph.Instance), q.GetData()) : void();
    q.Normalize();
    points->InsertNextPoint(centre.GetData());
    orientations->InsertNextTuple(q.GetData());
    scales->InsertNextValue(instance.Place.Scale);
    this->Centres.push_back(centre);
    this->Radii.push_back(prototype.Radius * instance.Place.Scale);
  }
  for (const auto& mesh : this->Meshes)
  {
    mesh->SetSmooth(smooth);
  }
  this->Places->SetPoints(points);
  this->Places->GetPointData()->AddArray(orientations);
  this->Places->GetPointData()->AddArray(scales);
  this->Places->GetPointData()->AddArray(this->Sources);
  this->Chosen.assign(this->Glyphs.size(), -1);
  this->IsDirty = true;
}

//------------------------------------------------------------------------------
void InstanceLayer::Color(const std::function<Rgb(int part, int material)>& getColor)
{
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(static_cast<vtkIdType>(this->Glyphs.size()));
  for (std::size_t i = 0; i < this->Glyphs.size(); ++i)
  {
    const Glyph& glyph = this->Glyphs[i];
    const Rgb color = getColor(this->Geometry->GetInstances()[glyph.Instance].Part, glyph.Material);
    std::copy(color.begin(), color.end(), colors->GetPointer(3 * static_cast<vtkIdType>(i)));
  }
  this->Places->GetPointData()->SetScalars(colors);
}

//------------------------------------------------------------------------------
void InstanceLayer::SetClippingPlanes(vtkPlaneCollection* planes)
{
  this->Mapper->SetClippingPlanes(planes);
}

//------------------------------------------------------------------------------
void InstanceLayer::SetVisible(bool on)
{
  this->Visible = on && this->Scene;
  this->Actor->SetVisibility(this->Visible);
}

//------------------------------------------------------------------------------
void InstanceLayer::SetInteracting(bool on)
{
  this->IsDirty = this->IsDirty || on != this->Interacting;
  this->Interacting = on;
}

//------------------------------------------------------------------------------
/// Chooses the levels of detail before each frame, if the view has changed.
void InstanceLayer::ShowVisible()
{
  const vtkIdType maximum = this->Interacting ? MaximumWhileMoving : MaximumWhenStill;
  const vtkMTimeType time = this->Renderer->GetActiveCamera()->GetMTime();
  const int height = this->Renderer->GetSize()[1];
  if (!this->Visible || (!this->IsDirty && time == this->ViewTime && height == this->ViewHeight))
  {
    return;
  }
  this->IsDirty = false;
  this->ViewTime = time;
  this->ViewHeight = height;
  const std::vector<int> before = this->Chosen;
  const bool isAll = this->NumberOfTriangles <= maximum;
  if (isAll)
  {
    this->Chosen.assign(this->Glyphs.size(), 0);
    this->NumberDrawn = this->NumberOfTriangles;
  }
  else
  {
    const View view(this->Renderer);
    double density = FirstDensity;
    this->NumberDrawn = this->ChooseLevels(view, density);
    for (int trial = 1; trial<MaximumTrials&& this->NumberDrawn> maximum; ++trial)
    {
      density *= NextDensity;
      this->NumberDrawn = this->ChooseLevels(view, density);
    }
    this->Hide(maximum);
  }
  if (this->Chosen != before)
  {
    this->SetSources();
  }
}

//------------------------------------------------------------------------------
/// Chooses the levels for a number of triangles per pixel; returns the number of triangles.
vtkIdType InstanceLayer::ChooseLevels(const View& view, double density)
{
  vtkIdType sum = 0;
  for (std::size_t i = 0; i < this->Glyphs.size(); ++i)
  {
    const PrototypeMesh& mesh = *this->Meshes[this->Glyphs[i].Mesh];
    int& level = this->Chosen[i];
    level = -1;
    if (view.Sees(this->Centres[i], this->Radii[i]))
    {
      const double wanted = density * view.GetPixels(this->Centres[i], this->Radii[i]);
      level = mesh.GetNumberOfLevels() - 1;
      while (level > 0 && static_cast<double>(mesh.GetCount(level)) < wanted)
      {
        --level;
      }
      sum += mesh.GetCount(level);
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
/// Leaves out glyphs, evenly, until few enough triangles remain.
void InstanceLayer::Hide(vtkIdType maximum)
{
  const double share = static_cast<double>(maximum) / static_cast<double>(this->NumberDrawn);
  double kept = 0.0;
  for (std::size_t i = 0; share < 1.0 && i < this->Glyphs.size(); ++i)
  {
    if (this->Chosen[i] < 0)
    {
      continue;
    }
    kept += share;
    if (kept < 1.0)
    {
      this->NumberDrawn -= this->Meshes[this->Glyphs[i].Mesh]->GetCount(this->Chosen[i]);
      this->Chosen[i] = -1;
    }
    kept -= kept < 1.0 ? 0.0 : 1.0;
  }
}

//------------------------------------------------------------------------------
void InstanceLayer::SetSources()
{
  for (std::size_t i = 0; i < this->Glyphs.size(); ++i)
  {
    const std::size_t mesh = this->Glyphs[i].Mesh;
    const int level = this->Chosen[i];
    const int source = level < 0 ? this->FirstSource.back() : this->FirstSource[mesh] + level;
    vtkPolyData*& set = this->Set[static_cast<std::size_t>(source)];
    vtkPolyData* data = level < 0 ? set : this->Meshes[mesh]->GetLevel(level);
    if (data != set)
    {
      set = data;
      this->Mapper->SetSourceData(source, data);
    }
    this->Sources->SetValue(static_cast<vtkIdType>(i), source);
  }
  this->Sources->Modified();
  this->Places->Modified();
}

} // namespace helios::viewer
