// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosCgalRayCaster
 * @brief   the ray caster on CGAL's AABB tree
 *
 * CGAL's AABB tree in double precision, with triangle indices as primitives over the scene's own
 * points. It finds the candidate triangles of a ray, the nearer box first; the common test decides
 * hits and ranges. Its hits are therefore bitwise identical to the hits of every other backend, and
 * it needs no local frame: no coordinate is rounded.
 *
 * An alternative to Embree and an independent check; Embree is many times faster
 * (Docs/ray-casters.md).
 *
 * @warning
 * CGAL's AABB tree is under the GPL, and so is a program that links this module.
 *
 * @sa
 * vtkHeliosRayCaster
 */

#ifndef vtkHeliosCgalRayCaster_h
#define vtkHeliosCgalRayCaster_h

#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScannerRayCastingCgalModule.h" // For export macro

class VTKHELIOSSCANNERRAYCASTINGCGAL_EXPORT vtkHeliosCgalRayCaster : public vtkHeliosRayCaster
{
public:
  static vtkHeliosCgalRayCaster* New();
  vtkTypeMacro(vtkHeliosCgalRayCaster, vtkHeliosRayCaster);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using vtkHeliosRayCaster::Intersect;
  void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const override;
  void Occluded(const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const override;
  const char* GetName() const override { return "cgal"; }
  std::size_t GetAcceleratorSize() const override;

protected:
  vtkHeliosCgalRayCaster();
  ~vtkHeliosCgalRayCaster() override;

  bool BuildAccelerator(const helios::TriangleMesh& mesh) override;

private:
  vtkHeliosCgalRayCaster(const vtkHeliosCgalRayCaster&) = delete;
  void operator=(const vtkHeliosCgalRayCaster&) = delete;

  class Internals;
  std::unique_ptr<Internals> Tree;
};

#endif
