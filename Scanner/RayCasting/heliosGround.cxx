// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosGround.h"

#include "heliosFlatScene.h"
#include "heliosMaterialTable.h"
#include "heliosRasterGround.h"
#include "heliosSceneGeometry.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBvhRayCaster.h"
#include "vtkHeliosScene.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// Positions on the ground, with a query whether any lies within the outline of a cell.
class Places
{
public:
  explicit Places(vtkPolyData* points)
  {
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      points->GetPoint(i, p);
      this->Sorted.push_back({ p[0], p[1] });
    }
    std::sort(this->Sorted.begin(), this->Sorted.end());
  }

  bool AreIn(vtkPoints* points, vtkIdType size, const vtkIdType* corners) const
  {
    vtkBoundingBox box;
    for (vtkIdType i = 0; i < size; ++i)
    {
      double p[3];
      points->GetPoint(corners[i], p);
      box.AddPoint(p);
    }
    return this->AreIn(box);
  }

  bool AreIn(const vtkBoundingBox& box) const
  {
    const std::array<double, 2> minimum = { box.GetMinPoint()[0], box.GetMinPoint()[1] };
    const std::array<double, 2> maximum = { box.GetMaxPoint()[0], box.GetMaxPoint()[1] };
    auto place = std::lower_bound(this->Sorted.begin(), this->Sorted.end(), minimum);
    while (place != this->Sorted.end() &&
      !((*place)[1] >= minimum[1] && (*place)[1] <= maximum[1]) && (*place)[0] <= maximum[0])
    {
      ++place;
    }
    return place != this->Sorted.end() && (*place)[0] <= maximum[0];
  }

  const std::vector<std::array<double, 2>>& Get() const { return this->Sorted; }

private:
  std::vector<std::array<double, 2>> Sorted;
};

/// A scene with some instances of another one, and copies of their prototypes near positions.
class NearScene
{
public:
  NearScene(const SceneGeometry& geometry, const Places& places)
    : Geometry(geometry)
    , All(vtkHeliosScene::SafeDownCast(geometry.GetScene()))
    , Near(places)
  {
    this->Scene->vtkPolyData::ShallowCopy(this->All);
    this->PrototypeIds->SetName(names::PrototypeIds);
  }

  /// Adds the instances at the positions, and makes one mesh.
  Status Flatten(vtkSmartPointer<vtkPolyData>& flat)
  {
    vtkPolyData* all = this->All->GetInstances();
    vtkNew<vtkPolyData> some;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    some->GetPointData()->CopyAllOn();
    some->GetPointData()->CopyAllocate(all->GetPointData());
    Status status;
    for (vtkIdType i = 0; status.IsOk() && i < all->GetNumberOfPoints(); ++i)
    {
      if (this->AddPrototype(this->Geometry.GetInstances()[static_cast<std::size_t>(i)], status))
      {
        some->GetPointData()->CopyData(
          all->GetPointData(), i, points->InsertNextPoint(all->GetPoint(i)));
      }
    }
    some->SetPoints(points);
    some->GetPointData()->RemoveArray(names::FirstCellIds);
    some->GetPointData()->AddArray(this->PrototypeIds);
    this->Scene->SetInstances(some);
    return status.IsOk() ? GetFlatScene(this->Scene, flat) : status;
  }

private:
  /// Adds the prototype of an instance; false if the instance has no triangles at the positions.
  bool AddPrototype(const SceneInstance& instance, Status& status)
  {
    double bounds[6];
    this->Geometry.GetBounds(instance, bounds);
    if (!this->Near.AreIn(vtkBoundingBox(bounds)))
    {
      return false;
    }
    const int next = this->Scene->GetNumberOfPrototypes();
    if (const Prototype& prototype = this->Geometry.GetPrototype(instance); prototype.IsRaster())
    {
      vtkNew<vtkPolyData> mesh;
      status = ExtractRasterGround(prototype.GetHeights(), instance.Place, this->Near.Get(), mesh);
      if (!status.IsOk() || mesh->GetNumberOfPolys() == 0)
      {
        return false;
      }
      this->Scene->AddPrototype(mesh);
      this->PrototypeIds->InsertNextValue(next);
      return true;
    }
    const auto [known, isNew] = this->Numbers.emplace(instance.PrototypeId, next);
    if (isNew)
    {
      this->Scene->AddPrototype(this->All->GetPrototype(instance.PrototypeId));
    }
    this->PrototypeIds->InsertNextValue(known->second);
    return true;
  }

  const SceneGeometry& Geometry;
  vtkHeliosScene* All;
  const Places& Near;
  vtkNew<vtkHeliosScene> Scene;
  vtkNew<vtkIntArray> PrototypeIds;
  std::map<int, int> Numbers; ///< number of each mesh in Scene, by its number in All
};

/// Returns whether any triangle of a scene with instances has a ground material.
bool HasGround(const SceneGeometry& geometry)
{
  auto* scene = vtkHeliosScene::SafeDownCast(geometry.GetScene());
  const MaterialTable materials = GetMaterials(scene);
  const auto isGround = [&materials](int id)
  {
    return id >= 0 && id < static_cast<int>(materials.size()) &&
      materials[static_cast<std::size_t>(id)].IsGround;
  };
  std::vector<bool> ofPrototypes;
  for (int i = 0; i < scene->GetNumberOfPrototypes(); ++i)
  {
    vtkDataArray* ids = scene->GetPrototype(i)->GetCellData()->GetArray(names::MaterialIds);
    bool has = !ids && isGround(0);
    for (vtkIdType cell = 0; ids && !has && cell < ids->GetNumberOfTuples(); ++cell)
    {
      has = isGround(static_cast<int>(ids->GetComponent(cell, 0)));
    }
    ofPrototypes.push_back(has);
  }
  const auto hasGround = [&](const SceneInstance& instance)
  {
    return instance.Material >= 0 ? isGround(instance.Material)
                                  : ofPrototypes[static_cast<std::size_t>(instance.PrototypeId)];
  };
  const auto& instances = geometry.GetInstances();
  return !FindGroundCells(scene).empty() ||
    std::any_of(instances.begin(), instances.end(), hasGround);
}

/// Returns the scene's cells at some positions; with groundOnly those with a ground material, if
/// any has it, or if it is known that others have.
vtkSmartPointer<vtkPolyData> ExtractSurfaces(
  vtkPolyData* scene, const Places& places, bool groundOnly, bool othersAreGround)
{
  std::vector<bool> isGround = groundOnly ? FindGroundCells(scene) : std::vector<bool>();
  if (groundOnly && othersAreGround)
  {
    isGround.resize(static_cast<std::size_t>(scene->GetPolys()->GetNumberOfCells()));
  }
  vtkCellArray* cells = scene->GetPolys();
  vtkNew<vtkCellArray> polys;
  polys->Use32BitStorage();
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    vtkIdType size;
    const vtkIdType* corners;
    cells->GetCellAtId(cell, size, corners);
    if ((isGround.empty() || isGround[cell]) && places.AreIn(scene->GetPoints(), size, corners))
    {
      polys->InsertNextCell(size, corners);
    }
  }
  auto ground = vtkSmartPointer<vtkPolyData>::New();
  ground->SetPoints(scene->GetPoints());
  ground->SetPolys(polys);
  return ground;
}

/// Returns the height of the highest surface at each point; otherwise NaN.
std::vector<double> GetHeights(vtkPolyData* points, const vtkHeliosRayCaster* caster)
{
  double bounds[6] = {};
  if (caster->GetGeometry().GetNumberOfTriangles() > 0)
  {
    caster->GetGeometry().GetBounds(bounds);
  }
  const double top = bounds[5] + std::max(1.0, bounds[5] - bounds[4]);
  std::vector<double> heights;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    const vtkHeliosRay ray{ { p[0], p[1], top }, { 0.0, 0.0, -1.0 } };
    vtkHeliosHit hit;
    caster->Intersect(&ray, &hit, 1);
    heights.push_back(hit.CellId < 0 ? std::nan("") : top - hit.Range);
  }
  return heights;
}

/// Finds the first point whose x or y is not a number, or -1.
vtkIdType FindPlaceNotFinite(vtkPolyData* points)
{
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]))
    {
      return i;
    }
  }
  return -1;
}

} // namespace

std::vector<bool> FindGroundCells(vtkPolyData* scene)
{
  const MaterialTable materials = GetMaterials(scene);
  vtkDataArray* ids = scene->GetCellData()->GetArray(names::MaterialIds);
  std::vector<bool> isGround(static_cast<std::size_t>(scene->GetPolys()->GetNumberOfCells()));
  bool hasGround = false;
  for (std::size_t cell = 0; cell < isGround.size(); ++cell)
  {
    const double id = ids ? ids->GetComponent(static_cast<vtkIdType>(cell), 0) : 0.0;
    isGround[cell] = id >= 0.0 && id < static_cast<double>(materials.size()) &&
      materials[static_cast<std::size_t>(id)].IsGround;
    hasGround = hasGround || isGround[cell];
  }
  return hasGround ? isGround : std::vector<bool>();
}

std::string DescribePlace(vtkPolyData* points, vtkIdType index)
{
  double p[3];
  points->GetPoint(index, p);
  std::ostringstream text;
  text << std::setprecision(15) << "point " << index << " at x " << p[0] << ", y " << p[1];
  return text.str();
}

Status GetGroundHeights(
  vtkPolyData* points, vtkPolyData* scene, bool groundOnly, std::vector<double>& heights)
{
  if (!scene || (scene->GetNumberOfCells() == 0 && !vtkHeliosScene::HasInstances(scene)))
  {
    return Status::Error("The scene on port 1 is empty: it has no ground for the points.");
  }
  const vtkIdType notFinite = FindPlaceNotFinite(points);
  if (notFinite >= 0)
  {
    return Status::Error(
      "No ground for " + DescribePlace(points, notFinite) + "; its coordinates must be finite.");
  }
  const Places places(points);
  vtkSmartPointer<vtkPolyData> mesh = scene;
  bool hasGround = false;
  if (vtkHeliosScene::HasInstances(scene))
  {
    SceneGeometry geometry;
    Status status = geometry.Set(scene);
    status = status.IsOk() ? NearScene(geometry, places).Flatten(mesh) : status;
    if (!status.IsOk())
    {
      return Status::Error("No ground in the scene on port 1: " + status.Message() + ".");
    }
    hasGround = groundOnly && HasGround(geometry);
  }
  vtkNew<vtkHeliosBvhRayCaster> caster;
  const auto surfaces = ExtractSurfaces(mesh, places, groundOnly, hasGround);
  if (surfaces->GetNumberOfCells() > 0 && !caster->Build(surfaces))
  {
    return Status::Error("No rays can be cast onto the scene on port 1.");
  }
  heights = GetHeights(points, caster);
  return {};
}

} // namespace helios
