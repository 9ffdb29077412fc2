// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRayCaster.h"

#include "heliosConeProbe.h"
#include "heliosStatus.h"
#include "heliosStopCheck.h"
#include "heliosTriangleMesh.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <string>
#include <vector>

/// The scene of the accelerator, and what is derived from it.
struct vtkHeliosRayCaster::Internals
{
  helios::StopCheck Check{ nullptr };
  std::unique_ptr<helios::ConeProbe> Probe;
  vtkWeakPointer<vtkPolyData> Scene;
  vtkPoints* Points = nullptr;   ///< of the scene, which holds it
  vtkCellArray* Polys = nullptr; ///< of the scene, which holds it
  vtkMTimeType Time = 0;

  void Set(vtkPolyData* scene)
  {
    this->Scene = scene;
    this->Points = scene->GetPoints();
    this->Polys = scene->GetPolys();
    this->Time = scene->GetMTime();
  }

  void Clear()
  {
    this->Scene = nullptr;
    this->Probe.reset();
  }

  /// Whether it is this scene, or another one with the same triangles.
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
      std::max(this->Points->GetMTime(), this->Polys->GetMTime()) <= this->Time;
  }
};

vtkHeliosRayCaster::vtkHeliosRayCaster()
  : Built(new Internals)
  , Mesh(new helios::TriangleMesh)
{
}

vtkHeliosRayCaster::~vtkHeliosRayCaster() = default;

void vtkHeliosRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Name: " << this->GetName() << "\n";
  os << indent << "NumberOfTriangles: " << this->Mesh->GetNumberOfTriangles() << "\n";
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
  const helios::Status status = this->Mesh->Set(scene);
  if (!status.IsOk())
  {
    *this->Mesh = helios::TriangleMesh();
    vtkErrorMacro(<< "Build: " << status.Message() << ".");
    return false;
  }
  if (!this->TryToBuild())
  {
    *this->Mesh = helios::TriangleMesh();
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
    return this->BuildAccelerator(*this->Mesh);
  }
  catch (const helios::Stopped&)
  {
    this->BuildAccelerator(helios::TriangleMesh());
    vtkErrorMacro(<< "Build: aborted; build again.");
    return false;
  }
}

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
  return this->GetAcceleratorSize() + probe + this->Mesh->GetMemorySize();
}

std::unique_ptr<helios::ConeProbe> vtkHeliosRayCaster::MakeConeProbe()
{
  return helios::MakeConeProbe(*this->Mesh, this->GetStopCheck());
}
