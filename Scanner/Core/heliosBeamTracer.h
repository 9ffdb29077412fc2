// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// From a beam to the returns of its sub-rays.

#ifndef heliosBeamTracer_h
#define heliosBeamTracer_h

#include "heliosFootprint.h"
#include "heliosPulse.h"
#include "heliosScanCounts.h"
#include "heliosScanModel.h"
#include "heliosScanRecords.h"
#include "heliosSurfaceResponse.h"

#include <vector>

namespace helios
{

/// A sub-ray as cast: a unit vector in the world, and its fraction of the energy.
struct CastSubRay
{
  Vec3 Direction;
  double Weight;
};

/// Casts the sub-rays of pulses, and collects their returns. One per thread.
class BeamTracer
{
public:
  BeamTracer(const ScanModel& model, SurfaceResponse& response);

  /// Casts all sub-rays of each of some pulses.
  void Cast(const std::vector<Pulse>& pulses, ScanCounts& counts);

  /// Divides the visible surfaces in the beam of a pulse into parts, and accepts these as its
  /// sub-rays; false if they are too many.
  bool FindFootprint(const Pulse& pulse, ScanCounts& counts);

  /// Casts all sub-rays of a pulse among leaves.
  void CastAll(const Pulse& pulse, ScanCounts& counts);

  /// Casts sub-rays for a pulse with too many triangles for visible areas: some hundred, and
  /// thousands unless all of those hit one surface.
  void SampleCrowd(const Pulse& pulse, ScanCounts& counts);

  /// Accepts the sub-rays cast last for a pulse as they are.
  void Select(std::size_t slot);

  /// Replaces returns, and their sub-rays if requested, by the accepted ones.
  void Collect(std::vector<SubReturn>& returns, std::vector<CastSubRay>& cast, ScanCounts& counts);

private:
  /// The same sub-rays of consecutive pulses, such as a group (heliosScanRun.h), and their hits.
  struct RayBatch
  {
    const std::vector<SubRay>* SubRays = nullptr;
    std::vector<vtkHeliosRay> Rays;
    std::vector<vtkHeliosHit> Hits;
  };
  void Cast(const std::vector<SubRay>& subRays, const Pulse* pulses, std::size_t count,
    RayBatch& batch, ScanCounts& counts);
  void Meet(const Pulse* pulses, std::size_t count, RayBatch& batch);
  void CastMore(const std::vector<SubRay>& subRays, const Pulse& pulse, ScanCounts& counts);
  void Select(const RayBatch& batch, std::size_t slot);

  bool IsSmooth();
  bool IsEdgeBetween(std::size_t a, std::size_t b);
  bool IsSilent(const vtkHeliosHit& hit) const { return this->Model.Gate.IsSilent(hit); }

  const ScanModel& Model;
  SurfaceResponse& Response;
  double SigmaRange;
  Footprint Surfaces;
  std::vector<FootprintPart> Parts;
  std::vector<SubRay> PartRays;
  RayBatch First; // of all pulses
  RayBatch More;  // of one pulse

  // Of the current pulse.
  const std::vector<SubRay>* SubRays = nullptr;
  const vtkHeliosRay* Rays = nullptr;
  const vtkHeliosHit* Hits = nullptr;
  Replies Answers; // their returns
};

} // namespace helios

#endif
