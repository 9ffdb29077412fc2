// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosObbTreeRayCaster.h"

#include "heliosObbSearch.h"
#include "vtkHeliosRayCasterFactory.h"

#include <vtkObjectFactory.h>

#include <algorithm>

class vtkHeliosObbTreeRayCaster::Internals : public helios::ObbSearch
{
};

vtkStandardNewMacro(vtkHeliosObbTreeRayCaster);

namespace
{

const bool IsRegistered = vtkHeliosRayCasterFactory::Register(
  "obbtree", 0, []() -> vtkHeliosRayCaster* { return vtkHeliosObbTreeRayCaster::New(); });

} // namespace

vtkHeliosObbTreeRayCaster::vtkHeliosObbTreeRayCaster()
  : Tree(new Internals)
{
}

vtkHeliosObbTreeRayCaster::~vtkHeliosObbTreeRayCaster() = default;

void vtkHeliosObbTreeRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

bool vtkHeliosObbTreeRayCaster::BuildAccelerator(const helios::TriangleMesh& mesh)
{
  this->Tree->Build(mesh);
  return true;
}

void vtkHeliosObbTreeRayCaster::Intersect(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const
{
  std::transform(rays, rays + count, hits,
    [this](const vtkHeliosRay& ray) { return this->Tree->Intersect(ray); });
}

void vtkHeliosObbTreeRayCaster::Occluded(
  const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const
{
  std::transform(rays, rays + count, occluded,
    [this](const vtkHeliosRay& ray) { return this->Tree->IsOccluded(ray); });
}

std::size_t vtkHeliosObbTreeRayCaster::GetAcceleratorSize() const
{
  return this->Tree->GetMemorySize();
}
