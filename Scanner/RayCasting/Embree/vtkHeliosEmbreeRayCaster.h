// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosEmbreeRayCaster
 * @brief   the ray caster for single rays: Embree traversal, double-precision triangles
 *
 * Embree 3 or 4, user geometry: it traverses padded float boxes in a frame local to
 * the scene, with the ray's origin advanced to the scene in double; every
 * candidate triangle is tested in double on the scene's own points. Rays are
 * traced in packets of 16, 8 or 4, as the machine supports.
 *
 * Consecutive cells that share an edge share a box. Triangles that reach far
 * out of the scene are kept in a tree of doubles, so that one outlier does not
 * reduce the float resolution.
 *
 * @warning
 * A hit at the very edge of a surface may be lost for a ray that starts more
 * than 1e7 times the size of the scene away from it.
 *
 * @sa
 * vtkHeliosRayCaster
 */

#ifndef vtkHeliosEmbreeRayCaster_h
#define vtkHeliosEmbreeRayCaster_h

#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScannerRayCastingEmbreeModule.h" // For export macro

class VTKHELIOSSCANNERRAYCASTINGEMBREE_EXPORT vtkHeliosEmbreeRayCaster : public vtkHeliosRayCaster
{
public:
  static vtkHeliosEmbreeRayCaster* New();
  vtkTypeMacro(vtkHeliosEmbreeRayCaster, vtkHeliosRayCaster);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using vtkHeliosRayCaster::Intersect;
  void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const override;
  void Occluded(const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const override;
  const char* GetName() const override { return "embree"; }
  std::size_t GetAcceleratorSize() const override;

protected:
  vtkHeliosEmbreeRayCaster();
  ~vtkHeliosEmbreeRayCaster() override;

  bool BuildAccelerator(const helios::TriangleMesh& mesh) override;

private:
  vtkHeliosEmbreeRayCaster(const vtkHeliosEmbreeRayCaster&) = delete;
  void operator=(const vtkHeliosEmbreeRayCaster&) = delete;

  class Internals;
  std::unique_ptr<Internals> Tree;
};

#endif
