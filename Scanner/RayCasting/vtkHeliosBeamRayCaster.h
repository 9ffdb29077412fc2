// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHeliosBeamRayCaster
 * @brief   the default ray caster: traverses the scene once per bundle of rays
 *
 * A hierarchy of boxes, eight per node, traversed once for all rays of a beam
 * (interval arithmetic on their origins and directions); triangles are tested
 * in double. Boxes are float in a frame local to the scene, rounded outwards;
 * triangles that reach far out of the scene are kept in a tree of doubles.
 * Intersect() treats each ray as a separate beam; for single rays
 * vtkHeliosEmbreeRayCaster is faster.
 *
 * @warning
 * For scenes of up to 2e8 triangles.
 *
 * @sa
 * vtkHeliosRayCaster
 */

#ifndef vtkHeliosBeamRayCaster_h
#define vtkHeliosBeamRayCaster_h

#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScannerRayCastingModule.h" // For export macro

class VTKHELIOSSCANNERRAYCASTING_EXPORT vtkHeliosBeamRayCaster : public vtkHeliosRayCaster
{
public:
  static vtkHeliosBeamRayCaster* New();
  vtkTypeMacro(vtkHeliosBeamRayCaster, vtkHeliosRayCaster);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  using vtkHeliosRayCaster::Intersect;
  void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const override;
  void IntersectBeams(
    const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const override;
  void Occluded(const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const override;
  const char* GetName() const override { return "beam"; }
  std::size_t GetAcceleratorSize() const override;
#ifndef __VTK_WRAP__
  void MoveTo(const helios::SceneMoment& moment) override;
#endif

protected:
  vtkHeliosBeamRayCaster();
  ~vtkHeliosBeamRayCaster() override;

  bool BuildAccelerator(const helios::TriangleMesh& mesh) override;
  bool BuildInstances(const helios::SceneGeometry& scene) override;
#ifndef __VTK_WRAP__
  bool ShareAccelerator(const vtkHeliosRayCaster& atRest) override;
  std::unique_ptr<helios::ConeProbe> MakeConeProbe() override;
#endif

private:
  vtkHeliosBeamRayCaster(const vtkHeliosBeamRayCaster&) = delete;
  void operator=(const vtkHeliosBeamRayCaster&) = delete;

  class Internals;
  std::unique_ptr<Internals> Tree;
};

#endif
