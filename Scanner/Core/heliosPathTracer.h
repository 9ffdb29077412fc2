// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Sub-rays behind mirrors, glass and water.

#ifndef heliosPathTracer_h
#define heliosPathTracer_h

#include "heliosColumnProfile.h"
#include "heliosMaterialTable.h"
#include "heliosPencil.h"
#include "heliosReceiver.h"
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
 * of events, or when too little energy is left. Every surface on a path scatters light, which
 * returns along the same path. A path that comes back to the receiver is a return of its own.
 *
 * Water and other volumes scatter light along the way; these returns are of no sub-ray.
 *
 * Left out: light that returns along another path than it came; triangles are flat, so that curved
 * surfaces focus by their sub-rays only; voxels behind the first surface. One per thread.
 */
class PathTracer
{
public:
  PathTracer(const ScanModel& model, SurfaceResponse& response);

  /// Forgets the paths of the previous pulse; returns of the next one are appended to these.
  void StartPulse(const Vec3& receiver, std::vector<SubReturn>& returns);

  /// Adds a sub-ray of a weight whose first hit is a mirror or glass.
  void Add(const vtkHeliosRay& ray, const vtkHeliosHit& hit, double weight, int subRay);

  /// Follows the paths that were added; light scattered by the first hits is not among the returns.
  void Follow();

  /// Adds the end of a path that was found otherwise; returns its number.
  int AddEnd(const PathEnd& end)
  {
    this->Ends.push_back(end);
    return static_cast<int>(this->Ends.size()) - 1;
  }

  /// Forgets the ends of the paths of the previous pulse.
  void ClearEnds() { this->Ends.clear(); }

  /// Swaps the ends of the paths of a pulse.
  void SwapEnds(std::vector<PathEnd>& ends) { this->Ends.swap(ends); }

  /// Returns the end of SubReturn::Path.
  const PathEnd& GetEnd(int path) const { return this->Ends[static_cast<std::size_t>(path)]; }

private:
  /// A path from an event on.
  struct Path
  {
    vtkHeliosRay Ray;
    Pencil Spread;
    double Weight; // weight of the sub-ray
    int SubRay;
    double Share;    // share of its energy, one way
    double Optical;  // length, from the start [m]
    double InAir;    // length in air [m]
    double Index;    // index of the medium
    double Slowness; // group index: slowness of pulses in the medium
    double Attenuation;
    const MaterialOptics* Medium; // null: air
    int Events;
    unsigned Turns;     // a bit for each event, the last one lowest: 1 reflected, 0 transmitted
    vtkIdType LastCell; // cell of the last event
  };

  /// A surface that a path meets.
  struct SurfaceInteraction
  {
    Vec3 Point;
    Vec3 Normal; // normal of the plane, against the path
    Vec3 Direction;
    double Cosine;
    double Reach; // largest coordinate and length, for rounding errors
    vtkIdType Cell;
    const MaterialOptics* Optics;
  };

  void TraceGeneration();
  void TraceBranch(const Path* first, std::size_t count);
  void Meet(const Path& start, const vtkHeliosHit& hit);
  void Advance(Path& path, double length) const;
  SurfaceInteraction GetInteraction(const Path& path, const vtkHeliosHit& hit);
  double GetPower(const Path& path, double response) const;
  void Scatter(const Path& path, const SurfaceInteraction& at);
  void ScatterWithin(const Path& path, double length);
  double GetVisibleRange(const Path& path) const;
  void Glint(const Path& path, const SurfaceInteraction& at);
  static double GetIndexBeyond(const Path& path, const MaterialOptics& optics);
  void AppendColumn();
  void Receive(const Path& path, double range);
  void Split(const Path& path, const SurfaceInteraction& at);
  void Reflect(const Path& path, const SurfaceInteraction& at, double share);
  void PassPane(const Path& path, const SurfaceInteraction& at, double share);
  void Refract(const Path& path, const SurfaceInteraction& at, double share);
  void Continue(Path path, const SurfaceInteraction& at, const Vec3& from, const Vec3& direction,
    double share, bool isReflected);
  void AddReturn(
    const Path& path, double range, double power, double cosine, vtkIdType cell, const Vec3& end);

  const ScanModel& Model;
  SurfaceResponse& Response;
  std::vector<PathEnd> Ends;
  Vec3 Receiver{ 0.0, 0.0, 0.0 };

  std::vector<Path> Waiting; // paths of the next generation
  std::vector<Path> Current;
  std::vector<vtkHeliosRay> Rays;
  std::vector<vtkHeliosHit> Hits;
  ColumnProfile Column; // column of the pulse
  std::vector<SubReturn>* Returns = nullptr;
};

} // namespace helios

#endif
