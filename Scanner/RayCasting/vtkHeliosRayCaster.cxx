// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosRayCaster.h"

#include "heliosBeamTree.h"
#include "heliosConeProbe.h"
#include "heliosStopCheck.h"
#include "heliosTriangleMesh.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosBvhRayCaster.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <string>
#include <vector>

namespace
{

struct Backend
{
  std::string Name;
  int Priority;
  vtkHeliosRayCaster::Factory Create;
};

/// The backends, in order of priority. Those of other libraries register when they are loaded.
std::vector<Backend>& GetBackends()
{
  static std::vector<Backend> backends = {
    { "beam", 4, []() -> vtkHeliosRayCaster* { return vtkHeliosBeamRayCaster::New(); } },
    { "bvh", 2, []() -> vtkHeliosRayCaster* { return vtkHeliosBvhRayCaster::New(); } }
  };
  return backends;
}

} // namespace

bool vtkHeliosRayCaster::Register(const char* name, int priority, Factory create)
{
  std::vector<Backend>& backends = GetBackends();
  const auto before = std::find_if(backends.begin(), backends.end(),
    [priority](const Backend& backend) { return backend.Priority < priority; });
  backends.insert(before, { name, priority, create });
  return true;
}

vtkHeliosRayCaster* vtkHeliosRayCaster::Create(const char* name)
{
  const std::string wanted = name ? name : "";
  std::string names;
  for (const Backend& backend : GetBackends())
  {
    if (wanted.empty() || wanted == backend.Name)
    {
      return backend.Create();
    }
    names += (names.empty() ? "" : ", ") + backend.Name;
  }
  vtkErrorWithObjectMacro(
    nullptr, << "There is no ray caster \"" << wanted << "\" in this build; give one of " << names);
  return nullptr;
}

int vtkHeliosRayCaster::GetNumberOfBackends()
{
  return static_cast<int>(GetBackends().size());
}

const char* vtkHeliosRayCaster::GetBackendName(int index)
{
  const bool isThere = index >= 0 && index < vtkHeliosRayCaster::GetNumberOfBackends();
  return isThere ? GetBackends()[static_cast<std::size_t>(index)].Name.c_str() : nullptr;
}

vtkHeliosRayCaster::vtkHeliosRayCaster()
  : Check(new helios::StopCheck(nullptr))
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
  if (this->IsBuilt(scene))
  {
    return true;
  }
  this->BuiltScene = nullptr;
  this->ConeTree = nullptr;
  this->OwnConeTree.reset();
  this->BuildAccelerator(helios::TriangleMesh()); // releases the old one before its mesh
  const std::string problem = this->Mesh->Set(scene);
  if (!problem.empty())
  {
    *this->Mesh = helios::TriangleMesh();
    vtkErrorMacro(<< "Build: " << problem << ".");
    return false;
  }
  if (!this->TryToBuild())
  {
    *this->Mesh = helios::TriangleMesh();
    return false;
  }
  this->BuiltScene = scene;
  this->BuiltPoints = scene->GetPoints();
  this->BuiltPolys = scene->GetPolys();
  this->BuiltTime = scene->GetMTime();
  return true;
}

/// Clears a partial build after an abort request.
bool vtkHeliosRayCaster::TryToBuild()
{
  try
  {
    this->Check->Ask();
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
  this->ShouldStop = shouldStop;
  *this->Check = helios::StopCheck(shouldStop);
}

bool vtkHeliosRayCaster::IsBuilt(vtkPolyData* scene) const
{
  if (!scene || !this->BuiltScene)
  {
    return false;
  }
  if (scene == this->BuiltScene)
  {
    return scene->GetMTime() <= this->BuiltTime;
  }
  return scene->GetPoints() == this->BuiltPoints && scene->GetPolys() == this->BuiltPolys &&
    scene->GetNumberOfStrips() == 0 && this->BuiltScene->GetNumberOfStrips() == 0 &&
    std::max(this->BuiltPoints->GetMTime(), this->BuiltPolys->GetMTime()) <= this->BuiltTime;
}

bool vtkHeliosRayCaster::Intersect(vtkDoubleArray* origins, vtkDoubleArray* directions,
  vtkDoubleArray* ranges, vtkIdTypeArray* cellIds)
{
  if (!this->BuiltScene)
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

void vtkHeliosRayCaster::PrepareConeProbe()
{
  if (!this->ConeTree && this->BuiltScene)
  {
    this->ConeTree = this->GetBeamTree();
    const vtkIdType count = this->Mesh->GetNumberOfTriangles();
    if (!this->ConeTree && count <= helios::BeamTree::MaximumTriangles)
    {
      auto tree = std::make_unique<helios::BeamTree>();
      try
      {
        tree->Build(*this->Mesh, *this->Check);
      }
      catch (const helios::Stopped&)
      {
        return;
      }
      this->OwnConeTree = std::move(tree);
      this->ConeTree = this->OwnConeTree.get();
    }
  }
}

vtkHeliosConeHit vtkHeliosRayCaster::ProbeCone(
  const double origin[3], const double axis[3], double tanHalfAngle, double planeTolerance) const
{
  if (!this->ConeTree)
  {
    return { vtkHeliosConeHit::Mixed, -1, 0.0 };
  }
  return helios::ConeProbe(origin, axis, tanHalfAngle, planeTolerance).Run(*this->ConeTree);
}
