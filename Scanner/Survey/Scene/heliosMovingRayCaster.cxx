// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosMovingRayCaster.h"

#include "heliosConeProbe.h"
#include "heliosSceneGeometry.h"
#include "heliosStopCheck.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace helios
{

namespace
{

/// Returns the vertices of some triangles, as cells.
vtkSmartPointer<vtkCellArray> MakePolys(
  const TriangleMesh& mesh, const std::vector<vtkIdType>& cells)
{
  auto polys = vtkSmartPointer<vtkCellArray>::New();
  polys->Use32BitStorage();
  polys->AllocateExact(
    static_cast<vtkIdType>(cells.size()), 3 * static_cast<vtkIdType>(cells.size()));
  for (const vtkIdType cell : cells)
  {
    const vtkTypeInt32* corners = mesh.GetCorners() + 3 * cell;
    polys->InsertNextCell({ corners[0], corners[1], corners[2] });
  }
  return polys;
}

/// Returns the points, shared or copied.
vtkSmartPointer<vtkPoints> MakePoints(const TriangleMesh& mesh, bool copy)
{
  vtkNew<vtkDoubleArray> all;
  all->SetNumberOfComponents(3);
  all->SetArray(const_cast<double*>(mesh.GetPoints()), 3 * mesh.GetNumberOfPoints(), 1);
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  copy ? points->GetData()->DeepCopy(all) : points->SetData(all);
  return points;
}

} // namespace

//------------------------------------------------------------------------------
vtkStandardNewMacro(MovingRayCaster);

//------------------------------------------------------------------------------
void MovingRayCaster::SetUp(
  vtkHeliosRayCaster* kind, vtkPolyData* scene, const std::vector<int>& parts)
{
  this->Kind = kind;
  this->Moves.clear();
  vtkDataArray* ids = scene->GetCellData()->GetArray(vtkHeliosArrayNames::PartIds);
  for (vtkIdType i = 0; ids && i < ids->GetNumberOfTuples(); ++i)
  {
    const auto part = static_cast<int>(ids->GetComponent(i, 0));
    this->Moves.push_back(std::find(parts.begin(), parts.end(), part) != parts.end());
  }
}

//------------------------------------------------------------------------------
vtkIdType MovingRayCaster::Share::GetCell(vtkIdType cell, const SceneGeometry& whole) const
{
  const SceneGeometry& own = this->Caster->GetGeometry();
  const SceneGeometry::Cell at = own.Find(cell);
  if (!at.Instance)
  {
    return whole.GetCell(this->Cells[static_cast<std::size_t>(at.Triangle)]);
  }
  const auto instance = at.Instance - own.GetInstances().data();
  return whole.GetInstances()[static_cast<std::size_t>(instance)].FirstCell + at.Triangle;
}

//------------------------------------------------------------------------------
/// Names the cells of hits as in the whole scene.
void MovingRayCaster::NameCells(const Share& share, vtkHeliosHit* hits, vtkIdType count) const
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    vtkIdType& cell = hits[i].CellId;
    cell = cell >= 0 ? share.GetCell(cell, this->GetGeometry()) : cell;
  }
}

//------------------------------------------------------------------------------
bool MovingRayCaster::BuildAccelerator(const TriangleMesh& mesh)
{
  if (mesh.GetNumberOfTriangles() == 0)
  {
    return true; // the static part is kept
  }
  if (!this->Moving.Scene)
  {
    this->MakeShares(mesh);
  }
  return this->BuildShares(mesh);
}

//------------------------------------------------------------------------------
bool MovingRayCaster::BuildInstances(const SceneGeometry& scene)
{
  if (!this->Moving.Scene)
  {
    this->MakeShares(scene.GetMesh());
    this->AddInstances(scene);
  }
  return this->BuildShares(scene.GetMesh());
}

//------------------------------------------------------------------------------
/// Adds all instances to the static triangles; their cells have the order of the scene.
void MovingRayCaster::AddInstances(const SceneGeometry& scene)
{
  auto* whole = vtkHeliosScene::SafeDownCast(scene.GetScene());
  auto resting = vtkSmartPointer<vtkHeliosScene>::New();
  resting->ShallowCopy(this->Resting.Scene);
  for (int i = 0; i < whole->GetNumberOfPrototypes(); ++i)
  {
    resting->AddPrototype(whole->GetPrototype(i));
  }
  const std::vector<vtkIdType>& cells = this->Resting.Cells;
  vtkNew<vtkIdTypeArray> first;
  first->SetName(vtkHeliosArrayNames::FirstCellIds);
  for (const SceneInstance& instance : scene.GetInstances())
  {
    const vtkIdType before =
      std::lower_bound(cells.begin(), cells.end(), instance.CellsBefore) - cells.begin();
    first->InsertNextValue(instance.FirstCell - instance.CellsBefore + before);
  }
  vtkNew<vtkPolyData> instances;
  instances->ShallowCopy(whole->GetInstances());
  instances->GetPointData()->AddArray(first);
  resting->SetInstances(instances);
  this->Resting.Scene = resting;
  this->Resting.HasInstances = true;
}

//------------------------------------------------------------------------------
bool MovingRayCaster::BuildShares(const TriangleMesh& mesh)
{
  for (const Share* share : { &this->Resting, &this->Moving })
  {
    share->Caster->SetShouldStop(this->GetStopCheck().GetShouldStop());
  }
  const bool hasResting = !this->Resting.IsEmpty();
  if ((hasResting && !this->Resting.Caster->Build(this->Resting.Scene)) || !this->BuildMoving(mesh))
  {
    vtkErrorMacro(<< "Build: the ray caster \"" << this->GetName()
                  << "\" does not support a part of the scene; use another one.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void MovingRayCaster::MakeShares(const TriangleMesh& mesh)
{
  for (vtkIdType i = 0; i < mesh.GetNumberOfTriangles(); ++i)
  {
    const auto cell = static_cast<std::size_t>(i);
    const bool moves = cell < this->Moves.size() && this->Moves[cell];
    (moves ? this->Moving : this->Resting).Cells.push_back(i);
  }
  for (Share* share : { &this->Resting, &this->Moving })
  {
    share->Caster = vtkSmartPointer<vtkHeliosRayCaster>::Take(this->Kind->NewInstance());
    share->Scene = vtkSmartPointer<vtkPolyData>::New();
    share->Scene->SetPolys(MakePolys(mesh, share->Cells));
  }
  this->Resting.Scene->SetPoints(MakePoints(mesh, true));
}

//------------------------------------------------------------------------------
bool MovingRayCaster::BuildMoving(const TriangleMesh& mesh)
{
  this->Moving.Scene->SetPoints(MakePoints(mesh, false)); // the mesh outlives the caster
  return this->Moving.Caster->Build(this->Moving.Scene);
}

//------------------------------------------------------------------------------
/// Selects the lowest cell at equal ranges, like one caster.
void MovingRayCaster::SelectNearer(
  const vtkHeliosHit* moving, vtkHeliosHit* hits, vtkIdType count) const
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkHeliosHit& a = moving[i];
    vtkHeliosHit& b = hits[i];
    const bool isNearer =
      b.CellId < 0 || a.Range < b.Range || (a.Range == b.Range && a.CellId < b.CellId);
    b = a.CellId >= 0 && isNearer ? a : b;
  }
}

//------------------------------------------------------------------------------
void MovingRayCaster::Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const
{
  this->IntersectBeams(rays, hits, 1, count);
}

//------------------------------------------------------------------------------
void MovingRayCaster::IntersectBeams(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const
{
  const vtkIdType count = raysPerBeam * beams;
  if (this->Resting.IsEmpty())
  {
    this->Moving.Caster->IntersectBeams(rays, hits, raysPerBeam, beams);
    this->NameCells(this->Moving, hits, count);
    return;
  }
  this->Resting.Caster->IntersectBeams(rays, hits, raysPerBeam, beams);
  this->NameCells(this->Resting, hits, count);
  static thread_local std::vector<vtkHeliosHit> others;
  others.resize(static_cast<std::size_t>(count));
  this->Moving.Caster->IntersectBeams(rays, others.data(), raysPerBeam, beams);
  this->NameCells(this->Moving, others.data(), count);
  this->SelectNearer(others.data(), hits, count);
}

//------------------------------------------------------------------------------
/// The probes of static and moving triangles, which outlive it.
class MovingRayCaster::PairProbe : public ConeProbe
{
public:
  explicit PairProbe(const MovingRayCaster& caster)
    : Resting(caster.Resting, caster.GetGeometry())
    , Moving(caster.Moving, caster.GetGeometry())
  {
  }

  std::size_t GetMemorySize() const override
  {
    return (this->Resting.Cones ? this->Resting.Cones->GetMemorySize() : 0) +
      (this->Moving.Cones ? this->Moving.Cones->GetMemorySize() : 0);
  }

  /// Returns false if one is missing.
  bool IsComplete() const { return this->Resting.IsComplete() && this->Moving.IsComplete(); }

  vtkHeliosConeHit Probe(const double origin[3], const double axis[3], double tanHalfAngle,
    const PlaneLimits& limits, ConeLayer* layer) const override
  {
    const auto probe = [&](const Part& part)
    { return part.Probe(origin, axis, tanHalfAngle, limits, layer); };
    const vtkHeliosConeHit moving = probe(this->Moving);
    if (moving.Kind == vtkHeliosConeHit::Empty)
    {
      return probe(this->Resting);
    }
    // A layer of the moving triangles is one of all if the others are away.
    const bool isFilled =
      moving.Kind == vtkHeliosConeHit::PlanarFootprint || (layer && layer->Size > 0);
    ConeLayer none;
    if (isFilled &&
      this->Resting.Probe(origin, axis, tanHalfAngle, limits, layer ? &none : nullptr).Kind ==
        vtkHeliosConeHit::Empty)
    {
      return moving;
    }
    if (layer)
    {
      layer->Size = 0;
    }
    return { vtkHeliosConeHit::Unresolved, -1, 0.0 };
  }

  bool Collect(const double origin[3], const double axis[3], double tanHalfAngle, double nearest,
    std::size_t maximum, ConeView& view) const override
  {
    view.Triangles.clear();
    view.Farthest = HUGE_VAL;
    for (const Part* part : { &this->Resting, &this->Moving })
    {
      static thread_local ConeView some;
      some = ConeView();
      if (part->Cones && !part->Cones->Collect(origin, axis, tanHalfAngle, nearest, maximum, some))
      {
        return false;
      }
      for (ConeTriangle& triangle : some.Triangles)
      {
        triangle.Cell = part->GetCell(triangle.Cell);
        view.Triangles.push_back(triangle);
      }
      std::copy_n(&some.Frame[0][0], part->Cones ? 9 : 0, &view.Frame[0][0]);
      view.Farthest = std::min(view.Farthest, some.Farthest);
    }
    view.Finish();
    return view.Triangles.size() <= maximum;
  }

private:
  struct Part
  {
    const Share& Own;
    const SceneGeometry& Whole;
    const ConeProbe* Cones;

    Part(const Share& share, const SceneGeometry& whole)
      : Own(share)
      , Whole(whole)
      , Cones(share.IsEmpty() ? nullptr : share.Caster->GetConeProbe())
    {
    }
    bool IsComplete() const { return this->Own.IsEmpty() || this->Cones; }

    /// Returns the id of a cell in the whole scene.
    vtkIdType GetCell(vtkIdType cell) const { return this->Own.GetCell(cell, this->Whole); }

    /// Probes its triangles; the result names cells of the whole scene.
    vtkHeliosConeHit Probe(const double origin[3], const double axis[3], double tanHalfAngle,
      const PlaneLimits& limits, ConeLayer* layer) const
    {
      if (this->Own.IsEmpty())
      {
        if (layer)
        {
          layer->Size = 0;
        }
        return { vtkHeliosConeHit::Empty, -1, 0.0 };
      }
      PlaneLimits own = limits;
      if (limits.GetResponse)
      {
        own.GetResponse = [this, &limits](vtkIdType cell)
        { return limits.GetResponse(this->GetCell(cell)); };
      }
      vtkHeliosConeHit hit = this->Cones->Probe(origin, axis, tanHalfAngle, own, layer);
      const bool isPlane = hit.Kind == vtkHeliosConeHit::PlanarFootprint;
      hit.CellId = isPlane ? this->GetCell(hit.CellId) : hit.CellId;
      for (int i = 0; layer && i < layer->Size; ++i)
      {
        layer->Pieces[i].Cell = this->GetCell(layer->Pieces[i].Cell);
      }
      return hit;
    }
  };

  Part Resting;
  Part Moving;
};

//------------------------------------------------------------------------------
std::unique_ptr<ConeProbe> MovingRayCaster::MakeConeProbe()
{
  auto probe = std::make_unique<PairProbe>(*this);
  return probe->IsComplete() ? std::move(probe) : nullptr;
}

//------------------------------------------------------------------------------
void MovingRayCaster::Occluded(
  const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const
{
  std::vector<unsigned char> others(static_cast<std::size_t>(count));
  this->Moving.Caster->Occluded(rays, occluded, count);
  if (!this->Resting.IsEmpty())
  {
    this->Resting.Caster->Occluded(rays, others.data(), count);
  }
  for (std::size_t i = 0; i < others.size(); ++i)
  {
    occluded[i] = occluded[i] || others[i];
  }
}

//------------------------------------------------------------------------------
const char* MovingRayCaster::GetName() const
{
  return this->Kind ? this->Kind->GetName() : "moving";
}

//------------------------------------------------------------------------------
std::size_t MovingRayCaster::GetAcceleratorSize() const
{
  const auto size = [](const Share& share)
  { return share.Caster ? share.Caster->GetAcceleratorSize() : 0; };
  return size(this->Resting) + size(this->Moving);
}

} // namespace helios
