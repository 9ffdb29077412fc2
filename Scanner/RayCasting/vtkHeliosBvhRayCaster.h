// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosBvhRayCaster
 * @brief   the reference ray caster
 *
 * A binary bounding volume hierarchy in double precision, built with a binned
 * surface area heuristic. Every other backend must equal it bit for bit.
 *
 * @sa
 * vtkHeliosRayCaster
 */

#ifndef vtkHeliosBvhRayCaster_h
#define vtkHeliosBvhRayCaster_h

#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScannerRayCastingModule.h" // For export macro

class VTKHELIOSSCANNERRAYCASTING_EXPORT vtkHeliosBvhRayCaster : public vtkHeliosRayCaster
{
public:
  static vtkHeliosBvhRayCaster* New();
  vtkTypeMacro(vtkHeliosBvhRayCaster, vtkHeliosRayCaster);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using vtkHeliosRayCaster::Intersect;
  void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const override;
  void Occluded(const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const override;
  const char* GetName() const override { return "bvh"; }
  std::size_t GetAcceleratorSize() const override;

protected:
  vtkHeliosBvhRayCaster();
  ~vtkHeliosBvhRayCaster() override;

  bool BuildAccelerator(const helios::TriangleMesh& mesh) override;

private:
  vtkHeliosBvhRayCaster(const vtkHeliosBvhRayCaster&) = delete;
  void operator=(const vtkHeliosBvhRayCaster&) = delete;

  class Internals;
  std::unique_ptr<Internals> Tree;
};

#endif
