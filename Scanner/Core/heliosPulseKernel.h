// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The fused kernel: pulses to sub-rays to hits to waveforms to echoes, in chunks of pulses, which
// heliosScanRun.h draws.

#ifndef heliosPulseKernel_h
#define heliosPulseKernel_h

#include "heliosBeamTracer.h"
#include "heliosMovingModel.h"
#include "heliosPulseGroups.h"
#include "heliosScanCounts.h"
#include "heliosScanModel.h"
#include "heliosScanRecords.h"
#include "heliosSurfaceResponse.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace helios
{

class WorkWatch;

/// One per thread; all its memory is scratch.
class PulseKernel
{
public:
  explicit PulseKernel(const ScanModel& model);

  /// Runs a chunk: the pulses [first, last) of the scan's sample; fewer if the watch has stopped.
  void Run(vtkIdType first, vtkIdType last, WorkWatch& watch, ChunkResult& result);

  const ScanCounts& GetCounts() const { return this->Counts; }

  /// Returns the first error of the detector, which has stopped the watch.
  const Status& GetFault() const { return this->Signal.GetFault(); }

private:
  /// The geometry of a beam on a plane.
  struct Incidence
  {
    double Reach;   ///< from the cone's apex: the footprint grows with it
    double Tangent; ///< tangent of the angle of incidence, for PlaneModel
  };
  /// Result of the cone probe of a beam, before its sub-rays are cast.
  struct Cone
  {
    vtkHeliosConeHit Hit; ///< the only surface in the beam, unless mixed
    bool MayHitTurbidVoxels;
    bool HasLayer;   ///< one continuous surface fills the beam
    Incidence Plane; ///< plane of PlanarFootprint
  };

  /// A pulse whose waveform is passed to the detector together with those of others.
  struct WaitingPulse
  {
    std::size_t Slot;
    vtkIdType Id;
    bool HasWaveform;
    bool IsDetected; ///< its echoes are known
    std::vector<SubReturn> Returns;
    std::vector<CastSubRay> SubRays;
    std::vector<PathEnd> Ends;
    std::vector<Echo> Echoes;
    std::vector<ScatteredProfile::Return> Scattered;
    Waveform Wave;
  };

  void AimPulses(vtkIdType first, vtkIdType last);
  void MoveTo(std::size_t slot);
  void CountFaults(const Pulse& pulse, vtkIdType index);
  Cone ProbeCone(std::size_t slot);
  bool FindMixedCrowd(const Pulse& pulse);
  bool Resolve(const Pulse& pulse, const vtkHeliosConeHit& hit, Cone& cone);
  Incidence GetIncidence(const Pulse& pulse, const vtkHeliosConeHit& hit);
  bool IsExact(const Incidence& plane, double range) const;
  bool HitsSpecularSurface(const Cone& cone) const;
  void RunOnOptics(const Pulse& pulse, bool hasLayer);
  void RunInAir(const Pulse& pulse);
  bool AreTogether() const;
  void RunFixed(std::size_t slot);
  void RunAdaptive(std::size_t slot);
  void RunOnPlane(const Pulse& pulse, const vtkHeliosConeHit& hit, const Incidence& plane);
  void FinishPlane(const PlaneEcho& echo);
  template <typename SampleT>
  void Refine(const Pulse& pulse, SampleT sample);
  bool AreNear(const std::vector<Echo>& echoes, const std::vector<Echo>& others) const;
  void RunReturns(const Pulse& pulse);
  void SampleScattering(const Pulse& pulse);
  void AddScatteredReturns();
  void CountPath(bool isBinned);
  bool FindEchoes();
  template <typename SourceT>
  void FillWaveform(const SourceT& source);
  void DetectEchoes();
  void DetectDarkCounts();
  double GetBackground();
  void AddToBlock(std::size_t slot, ChunkResult& result);
  void StoreBlock(ChunkResult& result);
  void SwapPulse(WaitingPulse& pulse);

  void StorePulse(std::size_t slot, ChunkResult& result);
  bool HasSurface() const;
  void SetScanFlags(vtkIdType index);
  void StoreEchoes(const Pulse& pulse, double scanAngle, ChunkResult& result);
  void StoreEcho(const Pulse& pulse, double scanAngle, const Echo& echo, std::size_t number,
    std::size_t count, ChunkResult& result);
  bool MoveToZone(vtkIdType index, EchoRecord& echo);
  void MoveToZones(vtkIdType index, std::size_t first, ChunkResult& result);
  void StoreWaveform(const Pulse& pulse, ChunkResult& result);
  void StoreSubRays(const Pulse& pulse, ChunkResult& result);
  void StoreMotion(const Pulse& pulse, const Echo& echo, ChunkResult& result);
  PathEnd FindEnd(const Pulse& pulse, const Echo& echo) const;
  double GetMeasuredRange(const Echo& echo, double theta, std::size_t number);
  double UseTerm(int term, double value, double variable, double otherwise);

  std::unique_ptr<MovingModel> Moving; ///< null: no instance moves
  const ScanModel& Model;
  SurfaceResponse Response;
  PulseGroups Groups;
  BeamTracer Tracer;
  Receiver Signal;
  std::unique_ptr<ScatteredLight> Scattered; ///< null: light is scattered once
  std::vector<vtkHeliosRay> Beam;            ///< for it: all sub-rays of a pulse
  PulseSource::Cursor Cursor;
  PulseSource::Cursor VelocityCursor; ///< cursor of the pulses whose velocity is stored
  PulseSource::Cursor ZoneCursor;     ///< cursor of the pulse an ambiguous echo is assigned to
  ScanCounts Counts;

  std::vector<Pulse> Pulses;
  std::vector<vtkIdType> Indices;
  bool AreCast = false; ///< fixed sampling: whether all their sub-rays have been

  // Members of the current pulse.
  vtkIdType PulseId = 0;
  unsigned char ScanDirection = 0; ///< flags, if requested
  unsigned char EdgeOfFlightLine = 0;
  Vec3 Velocity{ 0.0, 0.0, 0.0 }; ///< velocity of its origin, if requested
  ConeLayer Layer;
  bool IsCollected =
    false;                ///< whether the surfaces in its beam are known before the cone is tested
  bool IsInCrowd = false; ///< whether it, or the one before it, is known to be in leaves
  std::vector<SubReturn> Returns;
  std::vector<CastSubRay> SubRays;
  std::vector<Echo> Echoes;
  std::vector<Echo> Coarser; ///< echoes of fewer samples
  std::vector<std::size_t> Kept;
  bool HasWaveform = false;
  bool IsCut = false; ///< whether the waveform, filled or not, was cut

  // Pulses of a group that wait for a detector of blocks.
  const bool HasBlocks;
  bool CanWait = false; ///< whether the echoes of the current pulse are not needed at once
  bool IsWaiting = false;
  std::vector<WaitingPulse> Block; ///< keeps its memory
  std::size_t BlockSize = 0;
  std::size_t BlockSamples = 0;
};

} // namespace helios

#endif
