// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamPreparation.h"

#include "heliosConstants.h"
#include "heliosMovingModel.h"
#include "heliosScanModel.h"
#include "heliosStatus.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosInstrument.h"

#include <vtkMath.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

namespace helios
{
namespace
{

constexpr double MinimumDivergence = 1e-9; // [rad]; below, corners would be beyond 1 / u footprints
constexpr double LargestWaist = 10.0;      // [m], radius
const SubRay Axis{ Vec3(0.0, 1.0, 0.0), 1.0, Vec3(0.0, 0.0, 0.0) };

/// Returns all sub-rays of a sampler.
std::vector<SubRay> GetSubRays(vtkHeliosBeamSampler* sampler)
{
  std::vector<SubRay> subRays;
  for (int k = 0; k < sampler->GetNumberOfSubRays(); ++k)
  {
    double direction[3], offset[3];
    sampler->GetDirection(k, direction);
    sampler->GetOffset(k, offset);
    subRays.push_back({ Vec3(direction), sampler->GetWeight(k), Vec3(offset) });
  }
  return subRays;
}

/// Returns a sampler of the same beam, for another pattern.
vtkSmartPointer<vtkHeliosBeamSampler> CopyBeam(vtkHeliosBeamSampler* from)
{
  auto to = vtkSmartPointer<vtkHeliosBeamSampler>::New();
  to->SetBeamDivergence(from->GetBeamDivergence());
  to->SetDivergenceRatio(from->GetDivergenceRatio());
  to->SetTruncation(from->GetTruncation());
  to->SetBeamQualityFactor(from->GetBeamQualityFactor());
  to->SetWavelength(from->GetWavelength());
  return to;
}

/// Makes Vogel's spiral: the best fixed pattern for surfaces with edges.
std::vector<SubRay> MakeSpiral(vtkHeliosBeamSampler* sampler, int count)
{
  sampler->SetPatternToVogel();
  sampler->SetNumberOfSubRays(count);
  return GetSubRays(sampler);
}

/// Returns a number in [-1, 1] in ten bits, each followed by a zero bit.
unsigned SpreadBits(double x)
{
  const auto number = static_cast<unsigned>(511.999 * (x + 1.0));
  unsigned bits = 0;
  for (unsigned bit = 0; bit < 10; ++bit)
  {
    bits |= (number >> bit & 1u) << 2 * bit;
  }
  return bits;
}

/// Sorts adjacent sub-rays next to each other (Morton order): rays that are tested together hit the
/// same triangles.
void SortInSpace(std::vector<SubRay>& subRays)
{
  double reach = 0.0;
  for (const SubRay& ray : subRays)
  {
    reach = std::max({ reach, std::abs(ray.Direction[0]), std::abs(ray.Direction[2]) });
  }
  if (!(reach > 0.0))
  {
    return;
  }
  std::vector<std::pair<unsigned, std::size_t>> keys(subRays.size());
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    const Vec3& d = subRays[i].Direction;
    keys[i] = { 2 * SpreadBits(d[0] / reach) + SpreadBits(d[2] / reach), i };
  }
  std::sort(keys.begin(), keys.end());
  std::vector<SubRay> sorted;
  sorted.reserve(subRays.size());
  for (const auto& [key, index] : keys)
  {
    sorted.push_back(subRays[index]);
  }
  subRays.swap(sorted);
}

/// Makes Vogel's spiral of a size, for the few beams that need it.
std::unique_ptr<LazySubRays> MakeLazily(vtkHeliosBeamSampler* sampler, int count)
{
  const auto make = [beam = CopyBeam(sampler), count]
  {
    std::vector<SubRay> subRays = MakeSpiral(beam, count);
    SortInSpace(subRays);
    return subRays;
  };
  return std::make_unique<LazySubRays>(make);
}

/// Returns the Rayleigh range of the waist [m].
double GetApexOffset(vtkHeliosBeamSampler* sampler)
{
  const double w = 0.5 * sampler->GetBeamDivergence();
  return sampler->GetBeamQualityFactor() * 1e-9 * sampler->GetWavelength() /
    (vtkMath::Pi() * w * w);
}

/// Computes derived values of the sub-rays.
void FinishBeam(ScanModel& model)
{
  SortInSpace(model.SubRays);
  for (const SubRay& ray : model.SubRays)
  {
    model.HasOffsets = model.HasOffsets || ray.Offset.Norm() > 0.0;
  }
}

/// Returns the tangent of the half angle of a cone about sub-rays.
double GetTangent(const std::vector<SubRay>& subRays)
{
  double tangent = 0.0;
  for (const SubRay& ray : subRays)
  {
    tangent = std::max(tangent, std::hypot(ray.Direction[0], ray.Direction[2]) / ray.Direction[1]);
  }
  constexpr double rounding = 1e-9; // error of sub-rays, relative and absolute
  return tangent * (1.0 + rounding) + 1e-3 * rounding;
}

/// Returns the truncation of a beam without a fraction of its energy, at the rim: 1 - exp(-2 K^2)
/// is inside.
double LeaveOutRim(double truncation, double fraction)
{
  const double beyond = std::exp(-2.0 * truncation * truncation);
  return fraction > 0.0 ? std::sqrt(-0.5 * std::log(beyond + fraction * (1.0 - beyond)))
                        : truncation;
}

} // namespace

//------------------------------------------------------------------------------
Status CheckBeam(vtkHeliosBeamSampler* sampler)
{
  const double divergence = sampler->GetBeamDivergence();
  const double waist = sampler->GetFootprintRadius(0.0);
  std::ostringstream text;
  if (divergence != 0.0 && !(divergence >= MinimumDivergence))
  {
    text << "BeamDivergence is " << divergence << " rad; give at least " << MinimumDivergence
         << " rad, or 0 for one ideal ray";
    return Status::Error(text.str());
  }
  const double ratio = sampler->GetDivergenceRatio();
  if (divergence != 0.0 && !(ratio * divergence >= MinimumDivergence))
  {
    text << "DivergenceRatio " << ratio << " and BeamDivergence " << divergence
         << " rad make a divergence of " << ratio * divergence
         << " rad along the minor axis; give at least " << MinimumDivergence
         << " rad, or DivergenceRatio 1 for a circular beam";
    return Status::Error(text.str());
  }
  if (!(waist <= LargestWaist))
  {
    text << "BeamQualityFactor " << sampler->GetBeamQualityFactor() << " and BeamDivergence "
         << divergence << " rad make a waist of " << waist << " m radius, more than "
         << LargestWaist
         << " m; raise the divergence, or give BeamQualityFactor 0 for a beam without a waist";
    return Status::Error(text.str());
  }
  return {};
}

//------------------------------------------------------------------------------
BeamWidth GetBeamWidth(vtkHeliosBeamSampler* sampler)
{
  const double w = 0.5 * sampler->GetBeamDivergence();
  return w > 0.0 ? BeamWidth{ w * std::sqrt(sampler->GetDivergenceRatio()), GetApexOffset(sampler),
    sampler->GetTruncation() }
                 : BeamWidth();
}

namespace
{

/// Motions of which few pulses are asked for: their boxes are of a least number of pulses.
class SparseMotions : public InstanceMotions
{
public:
  SparseMotions(std::shared_ptr<const InstanceMotions> motions, vtkIdType pulses)
    : Motions(std::move(motions))
    , Pulses(pulses)
  {
  }

  int GetNumberOfTracks() const override { return this->Motions->GetNumberOfTracks(); }
  std::unique_ptr<InstanceTrack> MakeTrack(int motion) const override
  {
    return this->Motions->MakeTrack(motion);
  }
  const MeshFrames* GetFrames(int motion) const override
  {
    return this->Motions->GetFrames(motion);
  }
  MomentSpan GetSpan(const SceneMoment& moment, vtkIdType pulses) const override
  {
    return this->Motions->GetSpan(moment, std::max(pulses, this->Pulses));
  }
  bool AreAtRest(const MomentSpan& span) const override { return this->Motions->AreAtRest(span); }

private:
  std::shared_ptr<const InstanceMotions> Motions;
  vtkIdType Pulses;
};

/// Returns the model of a scan of which few pulses are probed; null if no instance moves.
std::unique_ptr<MovingModel> MakeSparse(const ScanModel& model, vtkIdType pulses)
{
  if (!model.Motions)
  {
    return nullptr;
  }
  ScanModel sparse = model;
  sparse.Motions = std::make_shared<SparseMotions>(model.Motions, pulses);
  return MovingModel::Make(sparse);
}

} // namespace

//------------------------------------------------------------------------------
bool FindsPlanes(const ScanModel& model, vtkIdType numberOfPulses)
{
  if (!model.Cones)
  {
    return false;
  }
  constexpr vtkIdType spans = 8; // for which boxes are made
  const vtkIdType samples = std::min<vtkIdType>((numberOfPulses + 31) / 32, 256);
  const std::unique_ptr<MovingModel> moving = MakeSparse(model, numberOfPulses / spans + 1);
  const ScanModel& probe = moving ? moving->Get() : model;
  PulseSource::Cursor cursor;
  Pulse pulse;
  ConeLayer layer;
  int probed = 0;
  int resolved = 0;
  for (vtkIdType i = 0; i < samples; ++i)
  {
    const vtkIdType index = numberOfPulses / samples * i;
    if (model.Source.GetPulse(index, cursor, pulse))
    {
      ++probed;
      moving ? moving->MoveTo(index, pulse) : void();
      const bool isMixed = probe.ProbeCone(pulse, layer).Kind == vtkHeliosConeHit::Unresolved;
      resolved += isMixed && layer.Size == 0 ? 0 : 1;
    }
  }
  constexpr int resolvedShare = 4; // pays from one of 4 on
  return resolvedShare * resolved >= probed;
}

//------------------------------------------------------------------------------
bool FindsCrowds(const ScanModel& model, vtkIdType numberOfPulses)
{
  constexpr std::size_t many = 32; // triangles
  constexpr int crowdShare = 2;    // pays from one of 2 on
  const vtkIdType samples = std::min<vtkIdType>((numberOfPulses + 31) / 32, 256);
  PulseSource::Cursor cursor;
  Pulse pulse;
  ConeLayer layer;
  ConeView view;
  int unresolved = 0;
  int crowded = 0;
  for (vtkIdType i = 0; model.Cones && i < samples; ++i)
  {
    if (model.Source.GetPulse(numberOfPulses / samples * i, cursor, pulse) &&
      model.ProbeCone(pulse, layer).Kind == vtkHeliosConeHit::Unresolved && layer.Size == 0)
    {
      ++unresolved;
      const bool isWhole = model.Cones->Collect(pulse.Origin.GetData(),
        pulse.GetDirection().GetData(), model.ConeTangent, 0.0, Footprint::MaximumTriangles, view);
      crowded += isWhole && view.Triangles.size() <= many ? 0 : 1;
    }
  }
  return crowdShare * crowded > unresolved;
}

//------------------------------------------------------------------------------
void PrepareFixedBeam(vtkHeliosBeamSampler* sampler, ScanModel& model)
{
  model.SubRays =
    sampler->GetBeamDivergence() > 0.0 ? GetSubRays(sampler) : std::vector<SubRay>{ Axis };
  FinishBeam(model);
  model.ConeTangent = GetTangent(model.SubRays);
}

//------------------------------------------------------------------------------
void PrepareAdaptiveBeam(vtkHeliosBeamSampler* sampler, ScanModel& model)
{
  const double w = 0.5 * sampler->GetBeamDivergence();
  model.Receiver.DetectionBin = model.Plan.DetectionBin;
  model.Receiver.MaximumRefined = model.Plan.MaximumRefined;
  const double ratio = sampler->GetDivergenceRatio();
  model.Plane = { BeamMoments(2.0 * w, sampler->GetTruncation()), model.Receiver.Shape.GetSigma(),
    ratio };
  model.ConeTangent = std::tan(w * sampler->GetTruncation());
  model.ApexOffset = GetApexOffset(sampler);
  model.Footprints = { w, LeaveOutRim(sampler->GetTruncation(), model.Plan.RimEnergy),
    model.ApexOffset,
    model.Plan.LargestDepth * 0.5 * SpeedOfLight * model.Receiver.Shape.GetSigma(),
    { model.Gate.Minimum, model.Gate.Maximum }, model.Plan.PartError, ratio, {} };

  if (!model.Surfaces.HasOptics())
  {
    model.Footprints.IsCrowd = [plan = model.Plan](std::size_t surfaces, double layers)
    { return surfaces > plan.MaximumSurfaces || plan.PrefersCells(surfaces, layers); };
    model.Footprints.PairTilt = model.Plan.PairTilt;
  }

  model.SubRays = MakeSpiral(CopyBeam(sampler), model.Plan.NumberOfSubRays);
  if (model.Plan.LayerRings > 0 && model.ApexOffset == 0.0)
  {
    const auto rings = CopyBeam(sampler);
    rings->SetPatternToGaussLegendre();
    rings->SetNumberOfRings(model.Plan.LayerRings);
    model.LayerSubRays = GetSubRays(rings);
  }
  const int minimum = model.Plan.MinimumSubRays;
  for (int count = minimum; count <= model.Plan.MaximumSubRays; count *= 4)
  {
    model.RayLevels.push_back(MakeLazily(sampler, count));
  }
  if (model.Surfaces.HasOptics()) // mostly plain surfaces behind them
  {
    model.CoarseSubRays = MakeSpiral(CopyBeam(sampler), minimum / 4);
    SortInSpace(model.CoarseSubRays);
  }
  FinishBeam(model);
}

//------------------------------------------------------------------------------
void PrepareScattering(
  const vtkHeliosInstrumentData& instrument, vtkHeliosBeamSampler* sampler, ScanModel& model)
{
  constexpr int subRays = 256; // from which paths start
  constexpr double step =
    0.1; // largest difference in a return, in standard deviations of the pulse
  ScatteringSettings& s = model.Scattering;
  s.Orders = instrument.ScatteringOrders;
  s.Paths = instrument.ScatteringPaths;
  s.IsIsotropic = instrument.ScatteringPhase == vtkHeliosInstrument::ISOTROPIC;
  s.HalfFieldOfView = std::max(0.5 * instrument.FieldOfView, std::atan(model.ConeTangent));
  s.Power = model.Power;
  s.Equation = model.Equation;
  s.MinimumRange = model.Gate.Minimum;
  s.MaximumRange = model.Gate.Maximum;
  s.Step = step * 0.5 * SpeedOfLight * model.Receiver.Shape.GetSigma();
  s.Seed = model.Seed;
  if (s.Orders > 1)
  {
    model.LightSubRays = sampler->GetBeamDivergence() > 0.0 ? MakeSpiral(CopyBeam(sampler), subRays)
                                                            : std::vector<SubRay>{ Axis };
  }
}

} // namespace helios
