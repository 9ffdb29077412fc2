// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosEmbreeRayCaster.h"

#include "heliosEmbreeTree.h"
#include "heliosStatus.h"
#include "vtkHeliosRayCasterFactory.h"

#include <vtkObjectFactory.h>

class vtkHeliosEmbreeRayCaster::Internals : public helios::EmbreeTree
{
};

vtkStandardNewMacro(vtkHeliosEmbreeRayCaster);

namespace
{

const bool IsRegistered = vtkHeliosRayCasterFactory::Register(
  "embree", 3, []() -> vtkHeliosRayCaster* { return vtkHeliosEmbreeRayCaster::New(); });

} // namespace

vtkHeliosEmbreeRayCaster::vtkHeliosEmbreeRayCaster()
  : Tree(new Internals)
{
}

vtkHeliosEmbreeRayCaster::~vtkHeliosEmbreeRayCaster() = default;

void vtkHeliosEmbreeRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

bool vtkHeliosEmbreeRayCaster::BuildAccelerator(const helios::TriangleMesh& mesh)
{
  const helios::Status status = this->Tree->Build(mesh, this->GetStopCheck());
  if (!status.IsOk())
  {
    this->Tree->Clear();
    vtkErrorMacro(<< "Build: " << status.Message() << ".");
  }
  return status.IsOk();
}

void vtkHeliosEmbreeRayCaster::Intersect(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const
{
  this->Tree->Intersect(rays, hits, count);
}

void vtkHeliosEmbreeRayCaster::Occluded(
  const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const
{
  this->Tree->Occluded(rays, occluded, count);
}

std::size_t vtkHeliosEmbreeRayCaster::GetAcceleratorSize() const
{
  return this->Tree->GetMemorySize();
}
