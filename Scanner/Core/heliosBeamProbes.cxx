// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamProbes.h"

#include "vtkHeliosBeamSampler.h"

#include <vtkMath.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace helios
{
namespace
{

/// Adds eight sub-rays without weight near the rim of a beam cut at an angle [rad]: to see edges there.
void AddRim(double angle, double setback, std::vector<SubRay>& subRays)
{
  const double polar = 0.85 * angle;
  for (int i = 0; i < 8; ++i)
  {
    const double azimuth = 0.25 * vtkMath::Pi() * (i + 0.25);
    const Vec3 direction(
      std::sin(polar) * std::sin(azimuth), std::cos(polar), std::sin(polar) * std::cos(azimuth));
    const Vec3 offset(setback * direction[2], 0.0, -setback * direction[0]);
    subRays.push_back({ direction, 0.0, offset });
  }
}

} // namespace

//------------------------------------------------------------------------------
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

//------------------------------------------------------------------------------
std::vector<SubRay> MakeProbes(vtkHeliosBeamSampler* beam, int rings, double setback)
{
  vtkNew<vtkHeliosBeamSampler> sampler;
  sampler->SetBeamDivergence(beam->GetBeamDivergence());
  sampler->SetTruncation(beam->GetTruncation());
  sampler->SetBeamQualityFactor(beam->GetBeamQualityFactor());
  sampler->SetWavelength(beam->GetWavelength());
  sampler->SetPatternToGaussLegendre();
  sampler->SetNumberOfRings(rings);
  std::vector<SubRay> probes = GetSubRays(sampler);
  AddRim(0.5 * beam->GetBeamDivergence() * beam->GetTruncation(), setback, probes);
  return probes;
}

//------------------------------------------------------------------------------
std::vector<std::pair<int, int>> PairNeighbours(const std::vector<SubRay>& subRays)
{
  std::set<std::pair<int, int>> pairs;
  const int count = static_cast<int>(subRays.size());
  for (int i = 0; i < count; ++i)
  {
    const auto away = [&subRays, i](int k)
    {
      return (subRays[static_cast<std::size_t>(k)].Direction -
        subRays[static_cast<std::size_t>(i)].Direction)
        .SquaredNorm();
    };
    std::vector<int> others(subRays.size());
    std::iota(others.begin(), others.end(), 0);
    const int wanted = std::min(4, count); // the first is itself
    std::partial_sort(others.begin(), others.begin() + wanted, others.end(),
      [&away](int a, int b) { return std::make_pair(away(a), a) < std::make_pair(away(b), b); });
    for (int n = 1; n < wanted; ++n)
    {
      const int k = others[static_cast<std::size_t>(n)];
      pairs.emplace(std::min(i, k), std::max(i, k));
    }
  }
  return { pairs.begin(), pairs.end() };
}

//------------------------------------------------------------------------------
bool FindsPlanes(const ScanModel& model, vtkIdType numberOfPulses)
{
  const vtkIdType samples = std::min<vtkIdType>(numberOfPulses, 256);
  Trajectory::Cursor cursor;
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
  return 2 * answered >= asked;
}

} // namespace helios
