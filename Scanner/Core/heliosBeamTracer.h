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

  /// Casts the first sub-rays of each of some pulses: all of fixed sampling, or those that look.
  void Cast(const std::vector<Pulse>& pulses, ScanCounts& counts);

  /// Casts all that a pulse's beam takes among leaves, which no look tells.
  void CastAll(const Pulse& pulse, ScanCounts& counts);

  /**
   * Takes what was cast last for a pulse, and casts more by tolerance: where neighbours among its sub-rays
   * meet one surface they are all it takes. Else as many are cast as an edge needs: on a spiral, or in
   * rings where one surface runs away steeply; more, where it would show the gaps between them.
   */
  void Refine(std::size_t slot, const Pulse& pulse, ScanCounts& counts);

  /// Takes what was cast last for a pulse as it is.
  void Take(std::size_t slot);

  /// Replaces returns, and their sub-rays where these are wanted, by those that were taken.
  void Collect(std::vector<SubReturn>& returns, std::vector<CastSubRay>& cast, ScanCounts& counts);

private:
  /// The same sub-rays of pulses, one after the other, and what they meet.
  struct Volley
  {
    const std::vector<SubRay>* SubRays = nullptr;
    std::vector<vtkHeliosRay> Rays;
    std::vector<vtkHeliosHit> Hits;
  };
  void Cast(const std::vector<SubRay>& subRays, const Pulse* pulses, std::size_t count,
    Volley& volley, ScanCounts& counts);
  void Meet(const Pulse* pulses, std::size_t count, Volley& volley);
  void CastMore(const std::vector<SubRay>& subRays, const Pulse& pulse, ScanCounts& counts);
  void Take(const Volley& volley, std::size_t slot);

  /// What probes meet, at first sight.
  struct Glance
  {
    double Spread; ///< of their ranges, in sigma_R
    bool IsCut;    ///< by the range gate
  };
  Glance GetGlance() const;
  bool SeeEdge(const Glance& glance);
  bool IsEdgeBetween(std::size_t a, std::size_t b);
  int GetStep(double spread);
  bool IsSilent(const vtkHeliosHit& hit) const { return this->Model.Gate.IsSilent(hit); }

  const ScanModel& Model;
  SurfaceResponse& Response;
  double SigmaRange;
  Volley First; // of all pulses
  Volley More;  // of one

  // Of the pulse at work.
  const std::vector<SubRay>* SubRays = nullptr;
  const vtkHeliosRay* Rays = nullptr;
  const vtkHeliosHit* Hits = nullptr;
  Replies Answers; // to them
};

} // namespace helios

#endif
