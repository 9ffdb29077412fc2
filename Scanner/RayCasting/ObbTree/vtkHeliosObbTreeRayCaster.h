// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosObbTreeRayCaster
 * @brief   the ray caster on vtkOBBTree: a cross-check
 *
 * VTK's tree of oriented boxes over the scene, translated to its middle. Each ray is clipped to the
 * scene's box first, since the tree's cost grows with the length of the segment, and intersected
 * with a tolerance of 1e-9 of the scene's size; without it the tree loses hits at edges. The tree
 * decides whether a triangle is hit; the common test on the scene's own points computes the range.
 *
 * It is hundreds to thousands of times slower than Embree (numbers: Docs/ray-casters.md), loses
 * some hits at shared edges, hits a surface up to 1e-9 of the scene's size beside it, and of
 * triangles at equal range returns any. Use it only to check other casters against a different
 * traversal.
 *
 * @sa
 * vtkHeliosRayCaster
 */

#ifndef vtkHeliosObbTreeRayCaster_h
#define vtkHeliosObbTreeRayCaster_h

#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScannerRayCastingObbTreeModule.h" // For export macro

class VTKHELIOSSCANNERRAYCASTINGOBBTREE_EXPORT vtkHeliosObbTreeRayCaster : public vtkHeliosRayCaster
{
public:
  static vtkHeliosObbTreeRayCaster* New();
  vtkTypeMacro(vtkHeliosObbTreeRayCaster, vtkHeliosRayCaster);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using vtkHeliosRayCaster::Intersect;
  void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const override;
  void Occluded(const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const override;
  const char* GetName() const override { return "obbtree"; }
  std::size_t GetAcceleratorSize() const override;

protected:
  vtkHeliosObbTreeRayCaster();
  ~vtkHeliosObbTreeRayCaster() override;

  bool BuildAccelerator(const helios::TriangleMesh& mesh) override;

private:
  vtkHeliosObbTreeRayCaster(const vtkHeliosObbTreeRayCaster&) = delete;
  void operator=(const vtkHeliosObbTreeRayCaster&) = delete;

  class Internals;
  std::unique_ptr<Internals> Tree;
};

#endif
