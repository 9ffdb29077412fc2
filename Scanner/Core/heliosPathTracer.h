// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Sub-rays behind mirrors and glass.

#ifndef heliosPathTracer_h
#define heliosPathTracer_h

#include "heliosMaterialTable.h"
#include "heliosPencil.h"
#include "heliosReturn.h"
#include "heliosScanModel.h"
#include "heliosSurfaceResponse.h"

#include <vector>

namespace helios
{

/// Where the path of a return ends: the surface that scatters the light, or the receiver itself.
struct PathEnd
{
  Vec3 Point;
  int Events; ///< reflections and refractions on the way there
};

/**
 * Follows sub-rays that meet a mirror or glass. At each such surface a path splits into a reflected
 * and a transmitted one, whose energies follow from Fresnel's equations; a path ends after a number
 * of events, or when too little energy is left. What a path meets scatters light, which returns along
 * the same path. A path that comes back to the receiver is a return of its own.
 *
 * Left out: light that returns along another path than it came; triangles are flat, so that curved
 * surfaces focus by their sub-rays only; voxels behind the first surface. One per thread.
 */
class PathTracer
{
public:
  PathTracer(const ScanModel& model, SurfaceResponse& response)
    : Model(model)
    , Response(response)
  {
  }

  /// Forgets the ends of the previous pulse.
  void StartPulse(const Vec3& receiver);

  /// Appends the returns of a sub-ray of a weight whose first hit is a mirror or glass, without that
  /// of the hit itself.
  void Follow(const vtkHeliosRay& ray, const vtkHeliosHit& hit, double weight, int subRay,
    std::vector<SubReturn>& returns);

  /// Of SubReturn::Path.
  const PathEnd& GetEnd(int path) const { return this->Ends[static_cast<std::size_t>(path)]; }

private:
  /// A path from an event on.
  struct Path
  {
    vtkHeliosRay Ray;
    Pencil Spread;
    double Share;   // of the energy of the sub-ray, one way
    double Optical; // length, from the start [m]
    double InAir;   // of that [m]
    double Index;   // of the medium
    double Attenuation;
    const MaterialOptics* Medium; // null: air
    int Events;
    vtkIdType LastCell = -1; // of the last event
  };

  /// A surface that a path meets.
  struct Meeting
  {
    Vec3 Point;
    Vec3 Normal; // of the plane, against the path
    Vec3 Direction;
    double Cosine;
    double Reach; // largest coordinate and length, for rounding errors
    vtkIdType Cell;
    const MaterialOptics* Optics;
  };

  void Trace(const Path& start);
  void Advance(Path& path, double length) const;
  Meeting Meet(const Path& path, const vtkHeliosHit& hit);
  void Scatter(const Path& path, const Meeting& at);
  void Receive(const Path& path, double range);
  void Split(const Path& path, const Meeting& at);
  void Reflect(const Path& path, const Meeting& at, double share);
  void PassPane(const Path& path, const Meeting& at, double share);
  void Refract(const Path& path, const Meeting& at, double share);
  void Continue(
    Path path, const Meeting& at, const Vec3& from, const Vec3& direction, double share);
  void AddReturn(
    const Path& path, double range, double power, double cosine, vtkIdType cell, const Vec3& end);

  const ScanModel& Model;
  SurfaceResponse& Response;
  std::vector<PathEnd> Ends;
  Vec3 Receiver{ 0.0, 0.0, 0.0 };

  // Of the current sub-ray.
  std::vector<Path> Waiting;
  double Weight = 0.0;
  int SubRay = 0;
  std::vector<SubReturn>* Returns = nullptr;
};

} // namespace helios

#endif
