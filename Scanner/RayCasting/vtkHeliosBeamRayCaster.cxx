// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "vtkHeliosBeamRayCaster.h"

#include "heliosBeamBundle.h"
#include "heliosBeamTree.h"
#include "heliosConeProbe.h"
#include "heliosSceneGeometry.h"
#include "heliosSceneTree.h"
#include "heliosTriangleMesh.h"

#include <vtkObjectFactory.h>

#include <algorithm>

class vtkHeliosBeamRayCaster::Internals : public helios::SceneTree
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

bool vtkHeliosBeamRayCaster::BuildInstances(const helios::SceneGeometry& scene)
{
  vtkIdType maximum = std::max<vtkIdType>(
    scene.GetMesh().GetNumberOfTriangles(), static_cast<vtkIdType>(scene.GetInstances().size()));
  for (const helios::Prototype& prototype : scene.GetPrototypes())
  {
    maximum = std::max(maximum, prototype.GetMesh().GetNumberOfTriangles());
  }
  if (maximum > helios::BeamTree::MaximumTriangles)
  {
    vtkErrorMacro(<< "Build: the mesh or a prototype of the scene has " << maximum
                  << " triangles, or there are as many instances, and the ray caster \"beam\" "
                  << "supports at most " << helios::BeamTree::MaximumTriangles
                  << "; use a part of the scene.");
    return false;
  }
  this->Tree->Build(scene, this->GetStopCheck());
  return true;
}

bool vtkHeliosBeamRayCaster::ShareAccelerator(const vtkHeliosRayCaster& atRest)
{
  const auto& other = static_cast<const vtkHeliosBeamRayCaster&>(atRest);
  this->Tree->Share(*other.Tree, this->GetGeometry());
  return true;
}

void vtkHeliosBeamRayCaster::MoveTo(const helios::SceneMoment& moment)
{
  this->Tree->MoveTo(moment);
}

std::unique_ptr<helios::ConeProbe> vtkHeliosBeamRayCaster::MakeConeProbe()
{
  return helios::MakeConeProbe(*this->Tree);
}

void vtkHeliosBeamRayCaster::Intersect(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const
{
  this->vtkHeliosBeamRayCaster::IntersectBeams(rays, hits, 1, count);
}

void vtkHeliosBeamRayCaster::IntersectBeams(
  const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const
{
  const helios::SceneTree& tree = *this->Tree;
  const bool hasOutliers = tree.GetMesh().GetTree().HasOutliers();
  helios::BeamBundle bundle(tree);
  for (vtkIdType beam = 0; beam < beams; ++beam)
  {
    for (int first = 0; first < raysPerBeam; first += helios::BeamBundle::MaximumRays)
    {
      const int count = std::min(helios::BeamBundle::MaximumRays, raysPerBeam - first);
      if (count == 1)
      {
        hits[first] = tree.Intersect(rays[first]);
        continue;
      }
      bundle.Trace(rays + first, hits + first, count);
    }
    for (int i = 0; i < raysPerBeam && hasOutliers; ++i)
    {
      hits[i] = tree.AddOutliers(rays[i], hits[i]);
    }
    rays += raysPerBeam;
    hits += raysPerBeam;
  }
}

void vtkHeliosBeamRayCaster::Occluded(
  const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const
{
  helios::SceneTree::Occluder occluder;
  for (vtkIdType i = 0; i < count; ++i)
  {
    occluded[i] = this->Tree->IsOccluded(rays[i], occluder);
  }
}

std::size_t vtkHeliosBeamRayCaster::GetAcceleratorSize() const
{
  return this->Tree->GetMemorySize();
}
