// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamPreparation.h"

#include "heliosConstants.h"
#include "heliosScanModel.h"
#include "vtkHeliosBeamSampler.h"

#include <vtkMath.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace helios
{
namespace
{

/// All sub-rays of a sampler.
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

/// A sampler of the same beam, for another pattern.
vtkSmartPointer<vtkHeliosBeamSampler> CopyBeam(vtkHeliosBeamSampler* from)
{
  auto to = vtkSmartPointer<vtkHeliosBeamSampler>::New();
  to->SetBeamDivergence(from->GetBeamDivergence());
  to->SetTruncation(from->GetTruncation());
  to->SetBeamQualityFactor(from->GetBeamQualityFactor());
  to->SetWavelength(from->GetWavelength());
  return to;
}

/// Vogel's spiral: the best fixed pattern for surfaces with edges.
std::vector<SubRay> MakeSpiral(vtkHeliosBeamSampler* sampler, int count)
{
  sampler->SetPatternToVogel();
  sampler->SetNumberOfSubRays(count);
  return GetSubRays(sampler);
}

/// Gauss-Legendre rings: the best pattern for a smooth surface.
std::vector<SubRay> MakeRings(vtkHeliosBeamSampler* sampler, int rings)
{
  sampler->SetPatternToGaussLegendre();
  sampler->SetNumberOfRings(rings);
  return GetSubRays(sampler);
}

/// Adds sub-rays that share a weight at an angle [rad] from the axis.
void AddRing(double angle, int count, double weight, double setback, std::vector<SubRay>& subRays)
{
  for (int i = 0; i < count; ++i)
  {
    const double azimuth = 2.0 * vtkMath::Pi() * (i + 0.5) / count;
    const Vec3 direction(
      std::sin(angle) * std::sin(azimuth), std::cos(angle), std::sin(angle) * std::cos(azimuth));
    const Vec3 offset(setback * direction[2], 0.0, -setback * direction[0]);
    subRays.push_back({ direction, weight / count, offset });
  }
}

/// Many probe rays: Gauss-Legendre rings, and eight sub-rays without weight near the edge of a beam
/// truncated at an angle [rad].
std::vector<SubRay> MakeManyProbes(vtkHeliosBeamSampler* sampler, double angle, double setback)
{
  std::vector<SubRay> subRays = MakeRings(sampler, 4);
  AddRing(0.85 * angle, 8, 0.0, setback, subRays);
  return subRays;
}

/**
 * Few probe rays: one on the axis and rings of 8 and 12 within which 55 % and 95 % of the energy lie: few,
 * with nearly equal gaps. With p = (g / w)^2 their weights give E[p] and E[p^2] of the beam: exact
 * for polynomials of degree 5 across it.
 */
std::vector<SubRay> MakeFewProbes(double w, double truncation, double setback)
{
  const double e = std::exp(-2.0 * truncation * truncation);
  const auto getSquare = [e](double energy) { return -0.5 * std::log(1.0 - energy * (1.0 - e)); };
  const BeamMoments beam(2.0, truncation);
  const double mean = 2.0 * beam.Variance;
  const double meanSquare = (beam.Excess + 3.0) / 1.5 * mean * mean;
  const double p1 = getSquare(0.55);
  const double p2 = getSquare(0.95);
  const double weight2 = (meanSquare - mean * p1) / (p2 * (p2 - p1));
  const double weight1 = (mean - weight2 * p2) / p1;
  std::vector<SubRay> subRays;
  AddRing(0.0, 1, 1.0 - weight1 - weight2, setback, subRays);
  AddRing(w * std::sqrt(p1), 8, weight1, setback, subRays);
  AddRing(w * std::sqrt(p2), 12, weight2, setback, subRays);
  return subRays;
}

/// A number in [-1, 1] in ten bits, each followed by a zero bit.
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
  const auto getKey = [reach](const SubRay& ray)
  { return 2 * SpreadBits(ray.Direction[0] / reach) + SpreadBits(ray.Direction[2] / reach); };
  std::stable_sort(subRays.begin(), subRays.end(),
    [&getKey](const SubRay& a, const SubRay& b) { return getKey(a) < getKey(b); });
}

/// Rarely used sub-rays of a beam: a pattern of a size.
std::unique_ptr<LazySubRays> MakeLazily(vtkHeliosBeamSampler* beam,
  std::vector<SubRay> (*makePattern)(vtkHeliosBeamSampler*, int), int size)
{
  const auto make = [copy = CopyBeam(beam), makePattern, size]
  {
    std::vector<SubRay> subRays = makePattern(copy, size);
    SortInSpace(subRays);
    return subRays;
  };
  return std::make_unique<LazySubRays>(make);
}

/// The pairs of neighbours that form the minimum spanning tree of all sub-rays, by Prim's
/// algorithm.
std::vector<std::pair<std::size_t, std::size_t>> JoinNeighbours(const std::vector<SubRay>& subRays)
{
  const std::size_t count = subRays.size();
  const auto getDistance = [&subRays](std::size_t a, std::size_t b)
  { return (subRays[a].Direction - subRays[b].Direction).SquaredNorm(); };
  std::vector<std::pair<std::size_t, std::size_t>> tree;
  std::vector<std::size_t> nearest(count, 0); // in the tree
  std::vector<bool> isIn(count, false);
  isIn[0] = true;
  while (tree.size() + 1 < count)
  {
    std::size_t next = 0;
    for (std::size_t i = 1; i < count; ++i)
    {
      if (!isIn[i] && (next == 0 || getDistance(i, nearest[i]) < getDistance(next, nearest[next])))
      {
        next = i;
      }
    }
    isIn[next] = true;
    tree.emplace_back(nearest[next], next);
    for (std::size_t i = 1; i < count; ++i)
    {
      nearest[i] = getDistance(i, next) < getDistance(i, nearest[i]) ? next : nearest[i];
    }
  }
  return tree;
}

/// Derived values of the sub-rays.
void FinishBeam(ScanModel& model)
{
  SortInSpace(model.SubRays);
  SortInSpace(model.Rings);
  for (const SubRay& ray : model.SubRays)
  {
    model.HasOffsets = model.HasOffsets || ray.Offset.Norm() > 0.0;
  }
}

} // namespace

//------------------------------------------------------------------------------
bool FindsPlanes(const ScanModel& model, vtkIdType numberOfPulses)
{
  if (!model.Cones)
  {
    return false;
  }
  const vtkIdType samples = std::min<vtkIdType>((numberOfPulses + 31) / 32, 256);
  PulseSource::Cursor cursor;
  Pulse pulse;
  int asked = 0;
  int answered = 0;
  for (vtkIdType i = 0; i < samples; ++i)
  {
    if (model.Source.GetPulse(numberOfPulses / samples * i, cursor, pulse))
    {
      ++asked;
      answered += model.ProbeCone(pulse).Kind == vtkHeliosConeHit::Mixed ? 0 : 1;
    }
  }
  constexpr int cost = 5; // in sub-rays
  return answered * static_cast<int>(model.Probes.size()) >= cost * asked;
}

//------------------------------------------------------------------------------
void PrepareFixedBeam(vtkHeliosBeamSampler* sampler, ScanModel& model)
{
  model.SubRays = sampler->GetBeamDivergence() > 0.0
    ? GetSubRays(sampler)
    : std::vector<SubRay>{ { Vec3(0.0, 1.0, 0.0), 1.0, Vec3(0.0, 0.0, 0.0) } };
  FinishBeam(model);
}

//------------------------------------------------------------------------------
void PrepareAdaptiveBeam(vtkHeliosBeamSampler* sampler, ScanModel& model)
{
  const double w = 0.5 * sampler->GetBeamDivergence();
  const double angle = w * sampler->GetTruncation();
  model.Receiver.DetectionBin = model.Plan.DetectionBin;
  model.Plane = { BeamMoments(2.0 * w, sampler->GetTruncation()), model.Receiver.Shape.GetSigma() };
  model.ConeTangent = std::tan(angle);
  model.Setback =
    sampler->GetBeamQualityFactor() * 1e-9 * sampler->GetWavelength() / (vtkMath::Pi() * w * w);
  model.Footprints = { w, sampler->GetTruncation(), model.Setback,
    model.Plan.LargestDepth * 0.5 * SpeedOfLight * model.Receiver.Shape.GetSigma(),
    { model.Gate.Least, model.Gate.Most } };

  const auto beam = CopyBeam(sampler); // for other patterns
  const int count = model.Plan.NumberOfSubRays;
  const int rings = model.Plan.Rings;
  model.SubRays = MakeSpiral(beam, count);
  model.Rings = MakeRings(beam, rings);
  for (int step = 1; step <= model.Plan.FinerSteps; ++step)
  {
    model.FinerSubRays.push_back(MakeLazily(sampler, MakeSpiral, count << 2 * step));
    model.FinerRings.push_back(MakeLazily(sampler, MakeRings, rings << step));
  }
  FinishBeam(model);
  switch (model.Plan.Probes)
  {
    case ProbeRays::All:
      model.Probes = model.SubRays;
      break;
    case ProbeRays::Few:
      model.Probes = MakeFewProbes(w, sampler->GetTruncation(), model.Setback);
      break;
    case ProbeRays::Many:
      model.Probes = MakeManyProbes(beam, angle, model.Setback);
      break;
  }
  model.ProbePairs = JoinNeighbours(model.Probes);
}

} // namespace helios
