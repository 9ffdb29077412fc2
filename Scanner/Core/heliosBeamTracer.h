// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// From a beam to what its sub-rays return.

#ifndef heliosBeamTracer_h
#define heliosBeamTracer_h

#include "heliosPulse.h"
#include "heliosScanModel.h"
#include "heliosScanRecords.h"
#include "heliosSurfaceResponse.h"

#include <vector>

namespace helios
{

/// A sub-ray as it was cast: a unit vector in the world, and its share of the energy.
struct CastSubRay
{
  Vec3 Direction;
  double Weight;
};

/// Casts the sub-rays of pulses, and collects what they return. One a thread.
class BeamTracer
{
public:
  BeamTracer(const ScanModel& model, SurfaceResponse& response);

  /// Casts the same sub-rays for each of some pulses.
  void Cast(
    const std::vector<SubRay>& subRays, const Pulse* pulses, std::size_t count, ScanCounts& counts);

  /**
   * Casts sub-rays by tolerance: probes look at the beam first, and where neighbours among them meet
   * one surface they are all it takes. Else as many are cast as an edge needs: on a spiral, or in rings
   * where one surface runs away steeply; more, where it would show the gaps between them. A beam that may meet leaves takes the spiral at once.
   */
  void CastByTolerance(const Pulse& pulse, ScanCounts& counts);

  /// Replaces returns, and their sub-rays where these are wanted, by those of a pulse cast last.
  void Collect(std::size_t slot, std::vector<SubReturn>& returns, std::vector<CastSubRay>& cast,
    ScanCounts& counts);

private:
  void Meet(const Pulse* pulses, std::size_t count);
  void AskSurfaces(std::size_t slot);
  bool SeeEdge();
  bool IsEdgeBetween(std::size_t a, std::size_t b);
  double GetSpread() const;
  int GetStep(double spread);
  bool IsSilent(const vtkHeliosHit& hit) const { return this->Model.IsSilent(hit); }

  const ScanModel& Model;
  SurfaceResponse& Response;
  double SigmaRange;
  const std::vector<SubRay>* SubRays = nullptr; // those cast last
  std::vector<vtkHeliosRay> Rays;
  std::vector<vtkHeliosHit> Hits;
  Replies Answers;         // to the sub-rays of one pulse
  bool HasAnswers = false; // to those cast last
};

} // namespace helios

#endif
