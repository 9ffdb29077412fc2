// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Traces a beam to the returns of its sub-rays.

#ifndef heliosBeamTracer_h
#define heliosBeamTracer_h

#include "heliosFlatOptics.h"
#include "heliosFootprint.h"
#include "heliosLayerSampler.h"
#include "heliosPathTracer.h"
#include "heliosPulse.h"
#include "heliosPulseGroups.h"
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

  /// Casts all sub-rays of each of the pulses [first, last).
  void Cast(const std::vector<Pulse>& pulses, std::size_t first, std::size_t last,
    PulseGroups& groups, ScanCounts& counts);

  /// Returns whether a pulse cast last meets nothing, and needs no more.
  bool MeetsNothing(std::size_t slot) const { return this->Beams[slot] == Empty; }

  /// Samples the layer that fills the beam of a pulse, and accepts its sub-rays; false if its ranges
  /// spread too much, or reach a limit of the range gate.
  bool SampleLayer(const Pulse& pulse, const ConeLayer& layer, ScanCounts& counts);

  /// Collects the surfaces in the beam of a pulse; false if they can only be met by rays.
  bool CollectSurfaces(const Pulse& pulse);

  /// Returns whether the surfaces collected last are known to be neither one plane nor one layer.
  bool AreSurfacesMixed() const
  {
    return this->Surfaces.IsMixed(this->Model.ConeTangent, this->Model.Plan.GetLargestDistance());
  }

  /// Replaces returns by those behind a flat mirror or pane that fills the beam of a pulse as a layer;
  /// false if they have to be found by sampling.
  bool PassLayer(const Pulse& pulse, const ConeLayer& layer, std::vector<SubReturn>& returns,
    ScanCounts& counts);

  /// Whether a mirror or glass is among the surfaces collected last.
  bool HasOptics() const;

  /// Returns whether the surfaces collected last can be sampled.
  bool CanSampleSurfaces() const { return this->Surfaces.IsFlat(); }

  /// Returns the number of surfaces collected last.
  std::size_t GetNumberOfSurfaces() const { return this->Surfaces.GetNumberOfFaces(); }

  /// Computes the visible parts of the surfaces collected last, by division or by cells, whichever
  /// the plan expects to be faster, and accepts them as sub-rays of the pulse; false if they are too
  /// many.
  bool ComputeParts(const Pulse& pulse, ScanCounts& counts);

  /// Samples the surfaces collected last by cells, so many across the beam, and accepts the parts
  /// that these see as sub-rays of the pulse; false if the plan allows fewer.
  bool SampleSurfaces(const Pulse& pulse, int across, ScanCounts& counts);

  /// Casts the sub-rays of a level of the plan; false if there is no such level.
  bool CastLevel(const Pulse& pulse, int level, ScanCounts& counts);

  /// Traces a level of a beam on mirrors or glass; its first level has few sub-rays.
  bool CastOpticsLevel(const Pulse& pulse, int level, ScanCounts& counts);

  /// Casts all sub-rays of a pulse among leaves.
  void CastAll(const Pulse& pulse, ScanCounts& counts);

  /// Casts them, or more, in a beam that may meet turbid voxels: one for each dm2 of its footprint, up to the
  /// largest number of sub-rays.
  void CastAmongLeaves(const Pulse& pulse, ScanCounts& counts);

  /// Aims the sub-rays of a pulse whose light is scattered more than once.
  void AimLight(const Pulse& pulse, std::vector<vtkHeliosRay>& rays) const;

  /// Accepts the sub-rays cast last for a pulse as they are.
  void Select(std::size_t slot);

  /// Replaces the returns of a pulse, and their sub-rays if requested, by the accepted ones.
  void Collect(const Pulse& pulse, std::vector<SubReturn>& returns, std::vector<CastSubRay>& cast,
    ScanCounts& counts);

  /// Appends the returns of the air in a beam that meets nothing.
  void AddAtmosphericReturns(const Pulse& pulse, std::vector<SubReturn>& returns);

  /// The paths of the surfaces collected last behind mirrors and glass.
  const PathTracer& GetPaths() const { return this->Paths; }
  PathTracer& GetPaths() { return this->Paths; }

private:
  /// Sub-rays of consecutive pulses, such as a group (heliosScanRun.h), and their hits.
  struct RayBatch
  {
    const std::vector<SubRay>* SubRays = nullptr;
    std::vector<vtkHeliosRay> Rays;
    std::vector<vtkHeliosHit> Hits;
  };
  /// The knowledge of a beam.
  enum Contents
  {
    Unknown, ///< its rays have to be traced
    Known,   ///< their hits are known
    Empty    ///< nobody asks for its rays, which hit nothing
  };
  void Resize(RayBatch& batch, const std::vector<SubRay>& subRays, std::size_t pulses) const;
  Contents MeetGroup(const Pulse& pulse, const ConeGroup& group, RayBatch& batch, std::size_t slot);
  void Meet(const Pulse* pulses, std::size_t first, std::size_t last, RayBatch& batch);
  void CastMore(const std::vector<SubRay>& subRays, const Pulse& pulse, ScanCounts& counts);
  void Select(const RayBatch& batch, std::size_t slot);
  void SelectParts(const Vec3& origin);
  const MaterialOptics* GetFlatOptics(const ConeLayer& layer) const;
  bool CollectBeyond(const PassedBeam& beam, const MaterialOptics& optics,
    std::vector<SubReturn>& returns, ScanCounts& counts);
  void AppendAir(const Pulse& pulse, std::vector<SubReturn>& returns);
  void AppendHiddenAir(const Pulse& pulse, std::vector<SubReturn>& returns);
  void CollectPaths(const Pulse& pulse, std::vector<SubReturn>& returns);

  const ScanModel& Model;
  SurfaceResponse& Response;
  PathTracer Paths;
  LayerSampler Layers;
  Footprint Surfaces;
  std::vector<FootprintPart> Parts;
  std::vector<SubRay> PartRays;
  std::vector<PassedBeam> Passed;
  std::vector<Hidden> Hiding;
  RayBatch First;              // batch of all pulses
  std::vector<Contents> Beams; // contents per pulse
  RayBatch More;               // batch of one pulse

  // Members of the current pulse.
  const std::vector<SubRay>* SubRays = nullptr;
  const vtkHeliosRay* Rays = nullptr;
  const vtkHeliosHit* Hits = nullptr;
  SurfaceReturns Returned; // their returns
};

} // namespace helios

#endif
