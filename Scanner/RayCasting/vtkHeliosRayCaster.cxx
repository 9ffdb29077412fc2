// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRayCaster.h"

#include "heliosConeProbe.h"
#include "heliosFlatScene.h"
#include "heliosSceneGeometry.h"
#include "heliosStatus.h"
#include "heliosStopCheck.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosScene.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

/// The scene of the accelerator, and what is derived from it.
struct vtkHeliosRayCaster::Internals
{
  helios::StopCheck Check{ nullptr };
  std::unique_ptr<helios::ConeProbe> Probe;
  vtkWeakPointer<vtkPolyData> Scene;
  vtkPoints* Points = nullptr;      ///< points of the scene, which holds them
  vtkCellArray* Polys = nullptr;    ///< triangles of the scene, which holds them
  vtkPolyData* Instances = nullptr; ///< instances of the scene, which holds them
  helios::TriangleMesh Flat;        ///< copies of instances, if there are any
  vtkMTimeType Time = 0;

  void Set(vtkPolyData* scene)
  {
    this->Scene = scene;
    this->Points = scene->GetPoints();
    this->Polys = scene->GetPolys();
    this->Instances = GetInstances(scene);
    this->Time = scene->GetMTime();
  }

  void Clear()
  {
    this->Scene = nullptr;
    this->Probe.reset();
  }

  /// Returns whether it is this scene, or another one with the same triangles.
  bool Has(vtkPolyData* scene) const
  {
    if (!scene || !this->Scene)
    {
      return false;
    }
    if (scene == this->Scene)
    {
      return scene->GetMTime() <= this->Time;
    }
    return scene->GetPoints() == this->Points && scene->GetPolys() == this->Polys &&
      scene->GetNumberOfStrips() == 0 && this->Scene->GetNumberOfStrips() == 0 &&
      (!this->Points || this->Points->GetMTime() <= this->Time) &&
      this->Polys->GetMTime() <= this->Time && this->HasInstancesOf(scene);
  }

  /// Bytes of the copies of instances.
  std::size_t GetFlatSize() const
  {
    return static_cast<std::size_t>(this->Flat.GetNumberOfPoints()) * 3 * sizeof(double) +
      static_cast<std::size_t>(this->Flat.GetNumberOfTriangles()) * 3 * sizeof(vtkTypeInt32);
  }

private:
  static vtkPolyData* GetInstances(vtkPolyData* scene)
  {
    auto* whole = vtkHeliosScene::SafeDownCast(scene);
    return whole ? whole->GetInstances() : nullptr;
  }

  /// Returns whether the instances and their prototypes are the scene's.
  bool HasInstancesOf(vtkPolyData* scene) const
  {
    if (GetInstances(scene) != this->Instances)
    {
      return false;
    }
    auto* whole = vtkHeliosScene::SafeDownCast(scene);
    auto* own = vtkHeliosScene::SafeDownCast(this->Scene);
    bool areSame = !this->Instances || this->Instances->GetMTime() <= this->Time;
    for (int i = 0; this->Instances && i < own->GetNumberOfPrototypes(); ++i)
    {
      areSame = areSame && whole->GetPrototype(i) == own->GetPrototype(i) &&
        own->GetPrototype(i)->GetMTime() <= this->Time;
    }
    return areSame;
  }
};

vtkHeliosRayCaster::vtkHeliosRayCaster()
  : Built(new Internals)
  , Geometry(new helios::SceneGeometry)
{
}

vtkHeliosRayCaster::~vtkHeliosRayCaster() = default;

void vtkHeliosRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->GetName() << "\n";
  os << indent << "NumberOfTriangles: " << this->Geometry->GetNumberOfTriangles() << "\n";
  os << indent << "AcceleratorSize: " << this->GetAcceleratorSize() << "\n";
}

bool vtkHeliosRayCaster::Build(vtkPolyData* scene)
{
  if (this->Built->Has(scene))
  {
    return true;
  }
  this->Built->Clear();
  this->BuildAccelerator(helios::TriangleMesh()); // releases the old one before its mesh
  this->Built->Flat = helios::TriangleMesh();
  const helios::Status status = this->Geometry->Set(scene);
  if (!status.IsOk())
  {
    *this->Geometry = helios::SceneGeometry();
    vtkErrorMacro(<< "Build: " << status.Message() << ".");
    return false;
  }
  if (!this->TryToBuild())
  {
    *this->Geometry = helios::SceneGeometry();
    return false;
  }
  this->Built->Set(scene);
  return true;
}

/// Clears a partial build after an abort request.
bool vtkHeliosRayCaster::TryToBuild()
{
  try
  {
    this->Built->Check.Poll();
    return this->Geometry->GetInstances().empty()
      ? this->BuildAccelerator(this->Geometry->GetMesh())
      : this->BuildInstances(*this->Geometry);
  }
  catch (const helios::Stopped&)
  {
    this->BuildAccelerator(helios::TriangleMesh());
    vtkErrorMacro(<< "Build: aborted; build again.");
    return false;
  }
}

bool vtkHeliosRayCaster::BuildInstances(const helios::SceneGeometry& scene)
{
  vtkSmartPointer<vtkPolyData> mesh;
  helios::Status status = helios::GetFlatScene(scene.GetScene(), mesh);
  status = status.IsOk() ? this->Built->Flat.Set(mesh) : status;
  if (!status.IsOk())
  {
    vtkErrorMacro(<< "Build: " << status.Message() << ".");
    return false;
  }
  return this->BuildAccelerator(this->Built->Flat);
}

vtkSmartPointer<vtkHeliosRayCaster> vtkHeliosRayCaster::MakeMoving(
  const std::shared_ptr<const helios::InstanceMotions>& motions) const
{
  // Weak pointers to the scene are not thread-safe: threads make theirs one after the other.
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  auto moving = vtk::TakeSmartPointer(this->NewInstance());
  *moving->Geometry = this->Geometry->MakeMoving(motions);
  moving->Built->Scene = this->Built->Scene;
  return moving->ShareAccelerator(*this) ? moving : nullptr;
}

bool vtkHeliosRayCaster::ShareAccelerator(const vtkHeliosRayCaster&)
{
  return false;
}

void vtkHeliosRayCaster::MoveTo(const helios::SceneMoment&) {}

void vtkHeliosRayCaster::SetShouldStop(const std::function<bool()>& shouldStop)
{
  this->Built->Check = helios::StopCheck(shouldStop);
}

helios::StopCheck& vtkHeliosRayCaster::GetStopCheck()
{
  return this->Built->Check;
}

bool vtkHeliosRayCaster::Intersect(vtkDoubleArray* origins, vtkDoubleArray* directions,
  vtkDoubleArray* ranges, vtkIdTypeArray* cellIds)
{
  if (!this->Built->Scene)
  {
    vtkErrorMacro(<< "Intersect: the caster has no scene; call Build first.");
    return false;
  }
  if (!origins || !directions || !ranges || !cellIds)
  {
    vtkErrorMacro(<< "Intersect: origins, directions, ranges and cellIds must all be arrays.");
    return false;
  }
  const vtkIdType count = origins->GetNumberOfTuples();
  if (origins->GetNumberOfComponents() != 3 || directions->GetNumberOfComponents() != 3 ||
    directions->GetNumberOfTuples() != count)
  {
    vtkErrorMacro(<< "Intersect: origins (" << count << " x " << origins->GetNumberOfComponents()
                  << ") and directions (" << directions->GetNumberOfTuples() << " x "
                  << directions->GetNumberOfComponents()
                  << ") must be arrays of 3 components with the same number of tuples.");
    return false;
  }

  std::vector<vtkHeliosRay> rays(static_cast<std::size_t>(count));
  std::vector<vtkHeliosHit> hits(rays.size());
  for (vtkIdType i = 0; i < count; ++i)
  {
    origins->GetTypedTuple(i, rays[i].Origin);
    directions->GetTypedTuple(i, rays[i].Direction);
  }
  this->Intersect(rays.data(), hits.data(), count);
  ranges->SetNumberOfComponents(1);
  ranges->SetNumberOfTuples(count);
  cellIds->SetNumberOfComponents(1);
  cellIds->SetNumberOfTuples(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    ranges->SetValue(i, hits[i].Range);
    cellIds->SetValue(i, hits[i].CellId);
  }
  return true;
}

void vtkHeliosRayCaster::IntersectBeams(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const
{
  this->Intersect(rays, hits, raysPerBeam * beams);
}

const helios::ConeProbe* vtkHeliosRayCaster::GetConeProbe()
{
  if (!this->Built->Probe && this->Built->Scene)
  {
    try
    {
      this->Built->Probe = this->MakeConeProbe();
    }
    catch (const helios::Stopped&)
    {
      return nullptr;
    }
  }
  return this->Built->Probe.get();
}

std::size_t vtkHeliosRayCaster::GetMemorySize() const
{
  const std::size_t probe = this->Built->Probe ? this->Built->Probe->GetMemorySize() : 0;
  return this->GetAcceleratorSize() + probe + this->Geometry->GetMemorySize() +
    this->Built->GetFlatSize();
}

std::unique_ptr<helios::ConeProbe> vtkHeliosRayCaster::MakeConeProbe()
{
  const bool isFlat = this->Geometry->GetInstances().empty();
  return helios::MakeConeProbe(
    isFlat ? this->Geometry->GetMesh() : this->Built->Flat, this->GetStopCheck());
}
