// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Finds the surfaces that a whole beam hits, without sampling it.

#ifndef heliosConeProbe_h
#define heliosConeProbe_h

#include "heliosConeLayer.h"
#include "heliosConeView.h"
#include "heliosPlaneLimits.h"
#include "vtkHeliosRay.h"
#include "vtkHeliosScannerRayCastingModule.h" // For export macro

#include <cstddef>
#include <memory>

namespace helios
{

class ConeGroup;
struct ConeAxis;
struct MomentSpan;
class SceneTree;
class StopCheck;
class TriangleMesh;

/// Probes cones in a scene. Thread-safe.
class VTKHELIOSSCANNERRAYCASTING_EXPORT ConeProbe
{
public:
  ConeProbe() = default;
  virtual ~ConeProbe() = default;
  ConeProbe(const ConeProbe&) = delete;
  void operator=(const ConeProbe&) = delete;

  /**
   * Probes a cone with its apex at origin about a unit axis. Empty and PlanarFootprint, within limits, are
   * exact for the whole cone; cell and range equal vtkHeliosRayCaster::Intersect() for the axis. A
   * layer, if given, is set to the surface that fills the cone, for PlanarFootprint and for Unresolved; to none
   * if there is no such surface within the limits.
   */
  virtual vtkHeliosConeHit Probe(const double origin[3], const double axis[3], double tanHalfAngle,
    const PlaneLimits& limits, ConeLayer* layer = nullptr) const = 0;

  /// Finds the triangles of a group of cones, see ConeGroup::Find().
  virtual bool FindGroup(const ConeAxis* /*cones*/, std::size_t /*count*/, double /*tanHalfAngle*/,
    const MomentSpan& /*span*/, ConeGroup& /*group*/) const
  {
    return false;
  }

  /// Probes a cone of a group that was found, without walking the trees.
  virtual vtkHeliosConeHit ProbeGroup(const double origin[3], const double axis[3],
    double tanHalfAngle, const PlaneLimits& limits, ConeLayer* layer,
    const ConeGroup& /*group*/) const
  {
    return this->Probe(origin, axis, tanHalfAngle, limits, layer);
  }

  /**
   * Collects the triangles that touch the cone beyond a depth along its axis, apart from some that
   * are hidden behind a triangle that covers the cone. Some that do not touch it may be among them.
   * False, and the view is not complete, if they are more than most, or if the cone is too wide.
   */
  virtual bool Collect(const double origin[3], const double axis[3], double tanHalfAngle,
    double nearest, std::size_t maximum, ConeView& view) const = 0;

  /// Bytes held besides the tree of a ray caster.
  virtual std::size_t GetMemorySize() const = 0;
};

/// Probes on the trees of a scene, which must outlive the result.
VTKHELIOSSCANNERRAYCASTING_EXPORT std::unique_ptr<ConeProbe> MakeConeProbe(const SceneTree& scene);

/// Probes on a tree of its own over a mesh, which must outlive the result; null if there are too
/// many triangles. Throws Stopped on an abort request.
std::unique_ptr<ConeProbe> MakeConeProbe(const TriangleMesh& mesh, StopCheck& check);

} // namespace helios

#endif
