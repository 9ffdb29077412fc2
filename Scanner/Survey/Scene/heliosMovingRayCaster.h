// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A ray caster for a scene with moving triangles: only these are rebuilt.

#ifndef heliosMovingRayCaster_h
#define heliosMovingRayCaster_h

#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <vector>

class vtkPolyData;

namespace helios
{

/**
 * Two casters of one kind, for static and for moving triangles. Hits are bit-identical to the hits
 * of one caster for all. A cone that hits both is Unresolved. Instances are static, and are not
 * copied if that kind does not copy them.
 */
class VTKHELIOSSCANNERSURVEY_EXPORT MovingRayCaster : public vtkHeliosRayCaster
{
public:
  static MovingRayCaster* New();
  vtkTypeMacro(MovingRayCaster, vtkHeliosRayCaster);
  MovingRayCaster(const MovingRayCaster&) = delete;
  void operator=(const MovingRayCaster&) = delete;

  /// Sets the ray caster to use, the scene, and the PartIds that move.
  void SetUp(vtkHeliosRayCaster* kind, vtkPolyData* scene, const std::vector<int>& parts);

  using vtkHeliosRayCaster::Intersect;
  void Intersect(const vtkHeliosRay* rays, vtkHeliosHit* hits, vtkIdType count) const override;
  void IntersectBeams(
    const vtkHeliosRay* rays, vtkHeliosHit* hits, int raysPerBeam, vtkIdType beams) const override;
  void Occluded(const vtkHeliosRay* rays, unsigned char* occluded, vtkIdType count) const override;
  const char* GetName() const override;
  std::size_t GetAcceleratorSize() const override;

protected:
  MovingRayCaster() = default;
  ~MovingRayCaster() override = default;

  bool BuildAccelerator(const TriangleMesh& mesh) override;
  bool BuildInstances(const SceneGeometry& scene) override;
  std::unique_ptr<ConeProbe> MakeConeProbe() override;

private:
  class PairProbe;

  /// A subset of the triangles, with their numbers in the mesh of the scene.
  struct Share
  {
    vtkSmartPointer<vtkHeliosRayCaster> Caster;
    vtkSmartPointer<vtkPolyData> Scene;
    std::vector<vtkIdType> Cells;
    bool HasInstances = false; ///< the scene has instances

    bool IsEmpty() const { return this->Cells.empty() && !this->HasInstances; }

    /// Returns the id of its cell in the whole scene.
    vtkIdType GetCell(vtkIdType cell, const SceneGeometry& whole) const;
  };
  void MakeShares(const TriangleMesh& mesh);
  void AddInstances(const SceneGeometry& scene);
  bool BuildShares(const TriangleMesh& mesh);
  bool BuildMoving(const TriangleMesh& mesh);
  void NameCells(const Share& share, vtkHeliosHit* hits, vtkIdType count) const;
  void SelectNearer(const vtkHeliosHit* moving, vtkHeliosHit* hits, vtkIdType count) const;

  vtkSmartPointer<vtkHeliosRayCaster> Kind;
  std::vector<bool> Moves; // by cell
  Share Resting;
  Share Moving;
};

} // namespace helios

#endif
