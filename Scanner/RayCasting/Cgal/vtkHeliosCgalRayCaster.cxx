// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosCgalRayCaster.h"

#include "heliosCgalTree.h"
#include "vtkHeliosRayCasterFactory.h"

#include <vtkObjectFactory.h>

#include <algorithm>

class vtkHeliosCgalRayCaster::Internals : public helios::CgalTree
{
};

vtkStandardNewMacro(vtkHeliosCgalRayCaster);

namespace
{

const bool IsRegistered = vtkHeliosRayCasterFactory::Register(
  "cgal", 1, []() -> vtkHeliosRayCaster* { return vtkHeliosCgalRayCaster::New(); });

} // namespace

vtkHeliosCgalRayCaster::vtkHeliosCgalRayCaster()
  : Tree(new Internals)
{
}

vtkHeliosCgalRayCaster::~vtkHeliosCgalRayCaster() = default;

void vtkHeliosCgalRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

bool vtkHeliosCgalRayCaster::BuildAccelerator(const helios::TriangleMesh& mesh)
{
  this->Tree->Build(mesh, this->GetStopCheck());
  return true;
}

void vtkHeliosCgalRayCaster::Intersect(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const
{
  std::transform(rays, rays + count, hits,
    [this](const vtkHeliosRay& ray) { return this->Tree->Intersect(ray); });
}

void vtkHeliosCgalRayCaster::Occluded(
  const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const
{
  std::transform(rays, rays + count, occluded,
    [this](const vtkHeliosRay& ray) { return this->Tree->IsOccluded(ray); });
}

std::size_t vtkHeliosCgalRayCaster::GetAcceleratorSize() const
{
  return this->Tree->GetMemorySize();
}
