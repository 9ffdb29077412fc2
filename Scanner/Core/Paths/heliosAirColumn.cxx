// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosAirColumn.h"

#include "heliosColumnProfile.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr double MaximumSlabs = 1e5;
constexpr double LeastShare = 1e-4; // share of the largest amplitude, without a threshold

/// Returns the power per range [W/m].
double GetDensity(const AirSettings& air, double range)
{
  return air.Gain * vtkMath::Pi() * air.Backscatter * std::exp(-2.0 * air.Extinction * range) /
    (range * range);
}

/// Returns the range from which on amplitudes do not matter.
double FindEnd(const AirSettings& air)
{
  const double perDensity = std::sqrt(2.0 * vtkMath::Pi()) * air.Step; // factor of amplitudes
  const double minimum = air.MinimumPower > 0.0 ? air.MinimumPower / perDensity
                                                : LeastShare * GetDensity(air, air.Start);
  double low = air.Start;
  double high = std::min(air.Stop, air.Start + MaximumSlabs * air.Step);
  for (int i = 0; i < 60 && GetDensity(air, high) < minimum; ++i)
  {
    const double middle = 0.5 * (low + high);
    (GetDensity(air, middle) < minimum ? high : low) = middle;
  }
  return high;
}

} // namespace

//------------------------------------------------------------------------------
AirColumn::AirColumn(const AirSettings& settings, const std::function<double(double)>& share)
  : Backscatter(settings.Backscatter)
  , Step(settings.Step)
{
  if (!(settings.Backscatter > 0.0))
  {
    return;
  }
  this->End = FindEnd(settings);
  ColumnProfile profile(settings.Step);
  profile.Add(
    settings.Start, this->End,
    [&](double range) { return GetDensity(settings, range) * (share ? share(range) : 1.0); },
    [](double, const ColumnProfile::Slab&) {});
  double near = 0.0;
  bool isFar = false; // returns come in pairs
  profile.ForEachReturn(
    [&](double range, double power, const ColumnProfile::Slab&)
    {
      if (isFar)
      {
        const double begin = this->Step * std::floor(0.5 * (near + range) / this->Step);
        this->Slabs.push_back({ begin, near, range, power });
      }
      near = range;
      isFar = !isFar;
    });
}

//------------------------------------------------------------------------------
void AirColumn::Append(std::vector<Hidden>& hits, std::vector<SubReturn>& returns) const
{
  std::sort(
    hits.begin(), hits.end(), [](const Hidden& a, const Hidden& b) { return a.Range < b.Range; });
  auto hit = hits.begin();
  double visible = 1.0; // share of the beam
  for (const Slab& slab : this->Slabs)
  {
    const double end = slab.Begin + this->Step;
    double share = visible;
    for (; hit != hits.end() && hit->Range < end; ++hit)
    {
      visible -= hit->Weight;
      share -= hit->Weight * std::min(1.0, (end - hit->Range) / this->Step);
    }
    if (!(share > 1e-9))
    {
      return;
    }
    for (const double range : { slab.Near, slab.Far })
    {
      returns.push_back({ range, share * slab.Power, 1.0, -1, SubReturn::Column });
    }
  }
}

} // namespace helios
