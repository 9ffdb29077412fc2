// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosBeamRayCaster.h"

#include "heliosBeamTree.h"
#include "heliosTriangleMesh.h"

#include <vtkObjectFactory.h>

class vtkHeliosBeamRayCaster::Internals : public helios::BeamTree
{
};

vtkStandardNewMacro(vtkHeliosBeamRayCaster);

vtkHeliosBeamRayCaster::vtkHeliosBeamRayCaster()
  : Tree(new Internals)
{
}

vtkHeliosBeamRayCaster::~vtkHeliosBeamRayCaster() = default;

void vtkHeliosBeamRayCaster::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

bool vtkHeliosBeamRayCaster::BuildAccelerator(const helios::TriangleMesh& mesh)
{
  const vtkIdType count = mesh.GetNumberOfTriangles();
  if (count > helios::BeamTree::MaximumTriangles)
  {
    vtkErrorMacro(<< "Build: the scene has " << count << " triangles and the ray caster \"beam\" "
                  << "supports at most " << helios::BeamTree::MaximumTriangles
                  << "; use \"embree\" or \"bvh\", or a part of the scene.");
    return false;
  }
  this->Tree->Build(mesh, this->GetStopCheck());
  return true;
}

const helios::BeamTree* vtkHeliosBeamRayCaster::GetBeamTree() const
{
  return this->Tree.get();
}

void vtkHeliosBeamRayCaster::Intersect(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const
{
  this->Tree->Intersect(rays, hits, 1, count);
}

void vtkHeliosBeamRayCaster::IntersectBeams(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const
{
  this->Tree->Intersect(rays, hits, raysPerBeam, beams);
}

void vtkHeliosBeamRayCaster::Occluded(
  const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const
{
  helios::BeamTree::Leaf occluder;
  for (vtkIdType i = 0; i < count; ++i)
  {
    occluded[i] = this->Tree->IsOccluded(rays[i], occluder);
  }
}

std::size_t vtkHeliosBeamRayCaster::GetAcceleratorSize() const
{
  return this->Tree->GetMemorySize();
}
