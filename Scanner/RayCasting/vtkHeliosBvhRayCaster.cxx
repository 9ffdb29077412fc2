// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBvhRayCaster.h"

#include "heliosBvh.h"

#include <vtkObjectFactory.h>

class vtkHeliosBvhRayCaster::Internals : public helios::Bvh
{
};

vtkStandardNewMacro(vtkHeliosBvhRayCaster);

vtkHeliosBvhRayCaster::vtkHeliosBvhRayCaster()
  : Tree(new Internals)
{
}

vtkHeliosBvhRayCaster::~vtkHeliosBvhRayCaster() = default;

void vtkHeliosBvhRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

bool vtkHeliosBvhRayCaster::BuildAccelerator(const helios::TriangleMesh& mesh)
{
  this->Tree->Build(mesh, this->GetStopCheck());
  return true;
}

void vtkHeliosBvhRayCaster::Intersect(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const
{
  helios::TestRay ray;
  for (vtkIdType i = 0; i < count; ++i)
  {
    hits[i] = ray.Set(rays[i]) ? this->Tree->Intersect(ray) : vtkHeliosHit{ helios::NoHit, -1 };
  }
}

void vtkHeliosBvhRayCaster::Occluded(
  const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const
{
  helios::TestRay ray;
  for (vtkIdType i = 0; i < count; ++i)
  {
    occluded[i] = ray.Set(rays[i]) && this->Tree->IsOccluded(ray);
  }
}

std::size_t vtkHeliosBvhRayCaster::GetAcceleratorSize() const
{
  return this->Tree->GetMemorySize();
}
