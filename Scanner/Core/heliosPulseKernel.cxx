// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPulseKernel.h"

#include "heliosConstants.h"
#include "heliosWorkWatch.h"
#include "vtkHeliosBeamDeflector.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>

namespace helios
{
namespace
{

constexpr vtkIdType MaximumPulses = 32;    // pulses of a group, traced together
constexpr vtkIdType MaximumWaiting = 256;  // likewise, for a detector of blocks
constexpr std::size_t MaximumRays = 16384; // rays of a group with several pulses
// share of a full footprint, for echoes that the tolerances bound
constexpr double LeastShare = 0.02;

} // namespace

PulseKernel::PulseKernel(const ScanModel& model)
  : Moving(MovingModel::Make(model))
  , Model(this->Moving ? this->Moving->Get() : model)
  , Response(this->Model)
  , Groups(this->Model)
  , Tracer(this->Model, this->Response)
  , Signal(model.Receiver)
  , HasBlocks(model.Path.Echo == EchoPath::Waveform && model.Receiver.Detector->PrefersBlocks())
{
  const ScanModel& m = this->Model;
  if (m.Scattering.Orders > 1)
  {
    this->Scattered = std::make_unique<ScatteredLight>(m.Scattering,
      LightScene{
        m.Caster, m.Surfaces, m.Medium, m.Scattering.IsIsotropic, m.Optics.MaximumEvents });
    std::vector<double> weights;
    std::transform(m.LightSubRays.begin(), m.LightSubRays.end(), std::back_inserter(weights),
      [](const SubRay& subRay) { return subRay.Weight; });
    this->Scattered->SetWeights(weights);
  }
}

//------------------------------------------------------------------------------
void PulseKernel::Run(vtkIdType first, vtkIdType last, WorkWatch& watch, ChunkResult& result)
{
  result.Echoes.reserve(static_cast<std::size_t>(last - first));
  const bool isAdaptive = this->Model.Path.IsAdaptive();
  const std::size_t rays = isAdaptive ? 1 : std::max<std::size_t>(1, this->Model.SubRays.size());
  const vtkIdType size =
    std::clamp<vtkIdType>(MaximumRays / rays, 1, this->HasBlocks ? MaximumWaiting : MaximumPulses);
  for (vtkIdType begin = first; begin < last && !watch.IsStopped(); begin += size)
  {
    const vtkIdType end = std::min(last, begin + size);
    this->AimPulses(begin, end);
    this->Groups.Start(this->Pulses, this->Indices);
    this->AreCast = !isAdaptive && this->AreTogether();
    if (this->AreCast)
    {
      this->MoveTo(0);
      this->Tracer.Cast(this->Pulses, 0, this->Pulses.size(), this->Groups, this->Counts);
    }
    for (std::size_t slot = 0; slot < this->Pulses.size() && !watch.IsStopped(); ++slot)
    {
      this->PulseId = this->Model.Source.Ids.Get(this->Indices[slot]);
      this->Echoes.clear();
      this->HasWaveform = false;
      this->CanWait = this->HasBlocks;
      this->IsWaiting = false;
      this->MoveTo(slot);
      this->Response.StartPulse();
      this->SampleScattering(this->Pulses[slot]);
      isAdaptive ? this->RunAdaptive(slot) : this->RunFixed(slot);
      this->DetectDarkCounts();
      this->HasBlocks ? this->AddToBlock(slot, result) : this->StorePulse(slot, result);
    }
    this->StoreBlock(result);
    if (!this->GetFault().IsOk())
    {
      watch.Stop();
    }
    watch.Count(end - begin);
  }
}

//------------------------------------------------------------------------------
void PulseKernel::AimPulses(vtkIdType first, vtkIdType last)
{
  this->Pulses.clear();
  this->Indices.clear();
  Pulse pulse;
  for (vtkIdType n = first; n < last; ++n)
  {
    const vtkIdType i = this->Model.Sample.Get(n);
    if (this->Model.Source.GetPulse(i, this->Cursor, pulse))
    {
      this->Pulses.push_back(pulse);
      this->Indices.push_back(i);
      if (pulse.FaultyTerms != 0)
      {
        this->CountFaults(pulse, i);
      }
    }
  }
  this->Counts.PulsesFired += static_cast<vtkIdType>(this->Pulses.size());
}

//------------------------------------------------------------------------------
/// Moves the instances to where they are at a pulse.
void PulseKernel::MoveTo(std::size_t slot)
{
  if (this->Moving)
  {
    this->Moving->MoveTo(this->Indices[slot], this->Pulses[slot]);
    this->Response.ForgetMoving();
  }
}

//------------------------------------------------------------------------------
void PulseKernel::CountFaults(const Pulse& pulse, vtkIdType index)
{
  const double angle = this->Model.Source.Deflector->GetScanAngle(index);
  for (std::size_t term = 0; term < this->Counts.Faults.size(); ++term)
  {
    if ((pulse.FaultyTerms >> term & 1u) != 0)
    {
      this->Counts.Faults[term].Add(pulse.Id, vtkMath::RadiansFromDegrees(angle));
    }
  }
}

//------------------------------------------------------------------------------
/// Returns whether the pulses of the group meet the same scene, and can be traced together.
bool PulseKernel::AreTogether() const
{
  return !this->Pulses.empty() &&
    (!this->Moving || this->Model.Motions->AreAtRest(this->Groups.GetSpan(0, this->Pulses.size())));
}

//------------------------------------------------------------------------------
void PulseKernel::RunFixed(std::size_t slot)
{
  if (!this->AreCast)
  {
    this->Tracer.Cast(this->Pulses, slot, slot + 1, this->Groups, this->Counts);
  }
  if (this->Tracer.MeetsNothing(slot))
  {
    this->Returns.clear();
    this->SubRays.clear();
    return;
  }
  this->Tracer.Select(slot);
  this->RunReturns(this->Pulses[slot]);
}

//------------------------------------------------------------------------------
PulseKernel::Cone PulseKernel::ProbeCone(std::size_t slot)
{
  const Pulse& pulse = this->Pulses[slot];
  this->IsCollected = false;
  Cone cone{ { vtkHeliosConeHit::Unresolved, -1, 0.0 }, this->Model.MayHitTurbidVoxels(pulse),
    false, {} };
  if (this->Model.Path.Beam == BeamPath::ConeFirst && !cone.MayHitTurbidVoxels &&
    !this->Resolve(pulse, this->Groups.FindOnly(slot), cone) && !this->FindMixedCrowd(pulse))
  {
    this->Resolve(pulse, this->Model.ProbeCone(pulse, this->Layer, this->Groups.Get(slot)), cone);
    cone.HasLayer = this->Layer.Size > 0;
  }
  return cone;
}

//------------------------------------------------------------------------------
/// Collects the surfaces in the beam of a pulse after one in leaves; returns whether they are known to be
/// mixed, so that a cone test would not resolve them.
bool PulseKernel::FindMixedCrowd(const Pulse& pulse)
{
  const bool isExpected = std::exchange(this->IsInCrowd, false);
  this->IsCollected = isExpected && this->Tracer.CollectSurfaces(pulse);
  this->IsInCrowd = this->IsCollected && this->Tracer.AreSurfacesMixed();
  return this->IsInCrowd;
}

//------------------------------------------------------------------------------
/// Sets the only surface in a cone, if its echo has a closed form; false otherwise.
bool PulseKernel::Resolve(const Pulse& pulse, const vtkHeliosConeHit& hit, Cone& cone)
{
  const bool isPlanar = hit.Kind == vtkHeliosConeHit::PlanarFootprint;
  if (isPlanar)
  {
    cone.Plane = this->GetIncidence(pulse, hit);
  }
  const bool isResolved = hit.Kind == vtkHeliosConeHit::Empty ||
    (isPlanar && this->Model.Air.IsEmpty() && this->IsExact(cone.Plane, hit.Range));
  if (isResolved)
  {
    cone.Hit = hit;
  }
  return isResolved;
}

//------------------------------------------------------------------------------
/// Returns whether a mirror or glass is the plane, or in the surface, that fills a beam.
bool PulseKernel::HitsSpecularSurface(const Cone& cone) const
{
  const SceneSurfaces& surfaces = this->Model.Surfaces;
  bool isOn = surfaces.HasOptics() && surfaces.GetOptics(cone.Hit.CellId);
  for (int i = 0; surfaces.HasOptics() && cone.HasLayer && !isOn && i < this->Layer.Size; ++i)
  {
    isOn = surfaces.GetOptics(this->Layer.Pieces[i].Cell);
  }
  return isOn;
}

//------------------------------------------------------------------------------
void PulseKernel::RunAdaptive(std::size_t slot)
{
  const Pulse& pulse = this->Pulses[slot];
  const Cone cone = this->ProbeCone(slot);
  if (this->HitsSpecularSurface(cone))
  {
    this->RunOnOptics(pulse, cone.HasLayer);
    return;
  }
  if (cone.Hit.Kind == vtkHeliosConeHit::Empty && !this->Model.Air.IsEmpty())
  {
    this->RunInAir(pulse);
    return;
  }
  if (cone.Hit.Kind != vtkHeliosConeHit::Unresolved)
  {
    this->RunOnPlane(pulse, cone.Hit, cone.Plane);
    return;
  }
  if (cone.HasLayer && this->Tracer.SampleLayer(pulse, this->Layer, this->Counts))
  {
    this->RunReturns(pulse);
    return;
  }
  if (cone.MayHitTurbidVoxels || this->Model.UsesRays)
  {
    cone.MayHitTurbidVoxels ? this->Tracer.CastAmongLeaves(pulse, this->Counts)
                            : this->Tracer.CastAll(pulse, this->Counts);
    this->RunReturns(pulse);
    return;
  }
  const auto castLevel = [&](int level)
  { return this->Tracer.CastLevel(pulse, level, this->Counts); };
  if (!this->Model.Cones || !(this->IsCollected || this->Tracer.CollectSurfaces(pulse)))
  {
    this->Refine(pulse, castLevel);
    return;
  }
  this->IsInCrowd = this->Tracer.AreSurfacesMixed();
  if (this->Tracer.HasOptics())
  {
    this->RunOnOptics(pulse, false);
    return;
  }
  if (this->Tracer.ComputeParts(pulse, this->Counts))
  {
    this->RunReturns(pulse);
    return;
  }
  const SamplingPlan& plan = this->Model.Plan;
  const bool isFlat = this->Tracer.CanSampleSurfaces();
  const std::size_t surfaces = this->Tracer.GetNumberOfSurfaces();
  this->Refine(pulse,
    [&](int level)
    {
      return isFlat
        ? this->Tracer.SampleSurfaces(pulse, plan.GetCellsAtLevel(surfaces, level), this->Counts)
        : castLevel(level);
    });
}

//------------------------------------------------------------------------------
/// Finds the echoes of a beam that meets no surface.
void PulseKernel::RunInAir(const Pulse& pulse)
{
  this->Returns.clear();
  this->SubRays.clear();
  this->Tracer.AddAtmosphericReturns(pulse, this->Returns);
  this->CountPath(this->FindEchoes());
}

//------------------------------------------------------------------------------
/// Finds the echoes of a beam that may meet a mirror or glass.
void PulseKernel::RunOnOptics(const Pulse& pulse, bool hasLayer)
{
  if (hasLayer && this->Tracer.PassLayer(pulse, this->Layer, this->Returns, this->Counts))
  {
    this->SubRays.clear();
    this->CountPath(this->FindEchoes());
    return;
  }
  this->Refine(
    pulse, [&](int level) { return this->Tracer.CastOpticsLevel(pulse, level, this->Counts); });
}

//------------------------------------------------------------------------------
/// Finds the echoes of a beam that is sampled, at levels from 0 until two successive ones agree.
template <typename SampleT>
void PulseKernel::Refine(const Pulse& pulse, SampleT sample)
{
  ++this->Counts.PulsesSampled;
  this->Returns.clear();
  this->CanWait = false;
  bool isBinned = false;
  bool isResolved = false;
  for (int level = 0; !isResolved && sample(level); ++level)
  {
    std::swap(this->Echoes, this->Coarser);
    this->Echoes.clear();
    this->Tracer.Collect(pulse, this->Returns, this->SubRays, this->Counts);
    isBinned = this->FindEchoes();
    isResolved = level > 0 && this->AreNear(this->Echoes, this->Coarser) &&
      this->AreNear(this->Coarser, this->Echoes);
  }
  this->Counts.PulsesUnresolved += isResolved ? 0 : 1;
  this->CountPath(isBinned);
}

//------------------------------------------------------------------------------
/// Returns whether every echo that counts has one of others within the tolerances.
bool PulseKernel::AreNear(const std::vector<Echo>& echoes, const std::vector<Echo>& others) const
{
  const SamplingPlan& plan = this->Model.Plan;
  return std::all_of(echoes.begin(), echoes.end(),
    [&](const Echo& echo)
    {
      const double full = this->Model.GetFullAmplitude(echo.Range);
      return echo.Amplitude < LeastShare * full ||
        std::any_of(others.begin(), others.end(),
          [&](const Echo& other)
          {
            return std::abs(other.Range - echo.Range) <= plan.RangeTolerance &&
              std::abs(other.Amplitude - echo.Amplitude) <= plan.EnergyTolerance * full;
          });
    });
}

//------------------------------------------------------------------------------
/// Finds the echoes of the sub-rays that were selected.
void PulseKernel::RunReturns(const Pulse& pulse)
{
  this->Tracer.Collect(pulse, this->Returns, this->SubRays, this->Counts);
  this->CountPath(this->FindEchoes());
}

//------------------------------------------------------------------------------
/// Samples the light of a pulse that is scattered more than once, if it is modelled.
void PulseKernel::SampleScattering(const Pulse& pulse)
{
  if (this->Scattered)
  {
    this->Tracer.AimLight(pulse, this->Beam);
    this->Scattered->Sample({ pulse.Id, pulse.Origin, pulse.GetDirection(), this->Beam });
  }
}

//------------------------------------------------------------------------------
/// Adds that light to the returns.
void PulseKernel::AddScatteredReturns()
{
  PathTracer& paths = this->Tracer.GetPaths();
  if (!this->Model.Surfaces.HasOptics())
  {
    paths.ClearEnds();
  }
  for (const ScatteredProfile::Return& r : this->Scattered->GetProfile().GetReturns())
  {
    this->Returns.push_back(
      { r.Range, r.Power, r.Cosine, r.Cell, SubReturn::Column, paths.AddEnd({ r.Point, 0 }) });
  }
}

//------------------------------------------------------------------------------
void PulseKernel::CountPath(bool isBinned)
{
  if (!this->Returns.empty())
  {
    ++(isBinned ? this->Counts.PulsesBinned : this->Counts.PulsesWithoutBins);
    this->Counts.CutWaveforms += this->IsCut ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
/// Returns the geometry of a beam on a plane.
PulseKernel::Incidence PulseKernel::GetIncidence(const Pulse& pulse, const vtkHeliosConeHit& hit)
{
  const Vec3& normal = this->Response.GetPlaneNormal(hit.CellId);
  const double cosPlane = std::abs(normal.Dot(pulse.GetDirection()));
  const double ratio = this->Model.Plane.Ratio;
  const double slope = ratio == 1.0
    ? std::sqrt(std::max(0.0, 1.0 - cosPlane * cosPlane))
    : std::hypot(normal.Dot(pulse.GetMajorAxis()), ratio * normal.Dot(pulse.GetMinorAxis()));
  return { std::hypot(hit.Range, this->Model.ApexOffset), slope / cosPlane };
}

//------------------------------------------------------------------------------
/// Returns whether the closed form of the planar echo is accurate enough.
bool PulseKernel::IsExact(const Incidence& plane, double range) const
{
  if (!(range > 0.0))
  {
    return false;
  }
  const ScanModel& m = this->Model;
  const bool isGaussian = m.Receiver.Shape.IsGaussian();
  const double widest = isGaussian ? m.Plan.LargestWidening : m.Plan.EnergyTolerance;
  const double rim = 2.0 * plane.Reach * m.ConeTangent * plane.Tangent; // in range
  return m.Plane.GetWidening(plane.Reach, plane.Tangent) <= widest &&
    m.Plane.GetShift(plane.Reach, plane.Tangent) <= m.Plan.LargestShift &&
    std::abs(range - m.Gate.Minimum) > rim && std::abs(range - m.Gate.Maximum) > rim;
}

//------------------------------------------------------------------------------
/// Finds the echo of a beam that hits one plane, or nothing.
void PulseKernel::RunOnPlane(
  const Pulse& pulse, const vtkHeliosConeHit& hit, const Incidence& plane)
{
  const ScanModel& m = this->Model;
  this->Returns.clear();
  this->SubRays.clear();
  if (hit.Kind == vtkHeliosConeHit::Empty)
  {
    return;
  }
  ++this->Counts.PulsesOnPlane;
  if (m.Gate.IsOutsideGate(hit.CellId, hit.Range))
  {
    ++this->Counts.HitsOutOfRange;
    return;
  }
  const Vec3 axis = pulse.GetDirection();
  const SurfaceReturn onAxis = this->Response.GetReturn(hit.CellId, hit.Range, axis.GetData());
  PlaneEcho echo = m.Plane.GetEcho(hit.Range, plane.Reach, plane.Tangent, onAxis.Power);
  if (m.Path.Echo == EchoPath::Mean)
  {
    echo.Power = onAxis.Power; // power of the whole pulse, however wide
  }
  this->Returns.push_back({ echo.Range, echo.Power, onAxis.CosIncidence, hit.CellId, 0 });
  if (m.Wants.SubRays)
  {
    this->SubRays.push_back({ axis, 1.0 });
  }
  this->FinishPlane(echo);
}

//------------------------------------------------------------------------------
/// Fills the waveform of the pulse with returns, or with the echo of a plane.
template <typename SourceT>
void PulseKernel::FillWaveform(const SourceT& source)
{
  this->IsCut = this->Signal.Fill(source, this->GetBackground(), this->PulseId);
  this->HasWaveform = true;
}

//------------------------------------------------------------------------------
void PulseKernel::FinishPlane(const PlaneEcho& echo)
{
  const bool isInWaveform = this->Model.Path.Echo == EchoPath::Waveform;
  if (this->Model.Wants.Waveforms || isInWaveform)
  {
    this->FillWaveform(echo);
    this->Counts.CutWaveforms += this->IsCut ? 1 : 0;
  }
  if (isInWaveform)
  {
    this->DetectEchoes();
  }
  else if (echo.Power > 0.0 && echo.Power >= this->Model.Receiver.Detector->GetDetectionThreshold())
  {
    this->Echoes.push_back(
      { echo.Range, echo.Power, FwhmPerSigma * echo.Sigma, this->Returns.data() });
  }
}

//------------------------------------------------------------------------------
/// Adds the echoes of the returns of a pulse; returns whether they needed bins.
bool PulseKernel::FindEchoes()
{
  if (this->Scattered)
  {
    this->AddScatteredReturns();
  }
  if (this->Returns.empty())
  {
    return false;
  }
  bool isBinned = true;
  this->IsCut = false;
  switch (this->Model.Path.Echo)
  {
    case EchoPath::Maxima:
      isBinned = !this->Signal.FindMaxima(this->Returns, this->Echoes);
      this->IsCut = this->Signal.IsCut();
      if (this->Model.Wants.Waveforms)
      {
        this->FillWaveform(this->Returns);
      }
      break;
    case EchoPath::Mean:
      isBinned = false;
      this->Signal.MergeReturns(this->Returns, this->Echoes);
      if (this->Model.Wants.Waveforms)
      {
        this->FillWaveform(this->Returns);
      }
      break;
    case EchoPath::BinnedMaxima:
      if (this->Signal.FindBinnedMaxima(this->Returns, this->Echoes))
      {
        break;
      }
      [[fallthrough]];
    case EchoPath::Waveform:
      this->FillWaveform(this->Returns);
      this->DetectEchoes();
      break;
  }
  return isBinned;
}

//------------------------------------------------------------------------------
/// Detects the echoes in the waveform, or later, in a block.
void PulseKernel::DetectEchoes()
{
  this->IsWaiting = this->CanWait;
  if (!this->IsWaiting)
  {
    this->Signal.DetectEchoes(this->Returns, this->Echoes);
  }
}

//------------------------------------------------------------------------------
/// Detects the dark counts of a pulse that returns nothing.
void PulseKernel::DetectDarkCounts()
{
  const ScanModel& m = this->Model;
  if (this->Returns.empty() && m.Path.Echo == EchoPath::Waveform &&
    m.Receiver.Detector->HasDarkCounts())
  {
    this->Signal.FillEmpty(this->PulseId);
    this->DetectEchoes();
  }
}

//------------------------------------------------------------------------------
/// Returns the sunlight in the pulse's waveform; every return fills its fraction of the field of
/// view.
double PulseKernel::GetBackground()
{
  double sum = 0.0;
  std::size_t surfaces = 0;
  for (std::size_t i = 0; this->Model.Background > 0.0 && i < this->Returns.size(); ++i)
  {
    const SubReturn& r = this->Returns[i];
    if (r.SubRay != SubReturn::Column)
    {
      sum += this->Response.GetBackground(r.CellId, r.Range);
      ++surfaces;
    }
  }
  return surfaces == 0 ? 0.0 : sum / static_cast<double>(surfaces);
}

} // namespace helios
