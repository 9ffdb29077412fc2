// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLineOfSight.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

// Rounding of sines and cosines: values on a limit are within it.
constexpr double Rounding = 1e-12;

// Distance behind the surface at which lines are aimed, as a share of the tolerance. Rounding would
// decide whether a line to a point on an edge, or one that touches an edge, hits it.
constexpr double BehindSurface = 1e-3;

} // namespace

LineOfSight::LineOfSight(
  const vtkHeliosRayCaster& caster, const SightTargets& targets, const SightLimits& limits)
  : Caster(caster)
  , Targets(targets)
  , Limits(limits)
  , Hits(PointsAtOnce)
  , IsHidden(PointsAtOnce)
{
  this->Aimed.reserve(PointsAtOnce);
  this->Rays.reserve(PointsAtOnce);
}

SightSum LineOfSight::FindVisible(const Vec3& eye, vtkIdType first, vtkTypeUInt64* words)
{
  this->Aim(eye, first);
  this->Cast();
  SightSum sum;
  sum.Rays = static_cast<vtkIdType>(this->Rays.size());
  for (std::size_t i = 0; i < this->Aimed.size(); ++i)
  {
    if (!this->IsHidden[i])
    {
      const Target& target = this->Aimed[i];
      words[target.Bit / 64] |= vtkTypeUInt64(1) << (target.Bit % 64);
      sum.Incidence += std::acos(std::min(1.0, target.Cosine));
    }
  }
  return sum;
}

void LineOfSight::Aim(const Vec3& eye, vtkIdType first)
{
  this->Aimed.clear();
  this->Rays.clear();
  const vtkIdType last = std::min(this->Targets.Count, first + PointsAtOnce);
  for (vtkIdType v = first; v < last; ++v)
  {
    const Vec3 way = Vec3(this->Targets.Points + 3 * v) - eye;
    Target target{ v - first, way.Norm(), 1.0 };
    if (target.Distance == 0.0)
    {
      continue; // no line, and not visible
    }
    const double perMetre = 1.0 / target.Distance;
    Vec3 aim = way;
    if (this->Targets.Normals)
    {
      const Vec3 normal(this->Targets.Normals + 3 * v);
      target.Cosine = perMetre * std::abs(way.Dot(normal));
      aim = way - BehindSurface * this->Limits.HitTolerance * normal;
    }
    if (this->IsWithinLimits(perMetre * way[2], target))
    {
      const double tolerance = perMetre * this->Limits.HitTolerance;
      this->Aimed.push_back(target);
      this->Rays.push_back({ { eye[0], eye[1], eye[2] }, { aim[0], aim[1], aim[2] },
        1.0 + (this->Limits.BothSides ? tolerance : -tolerance) });
    }
  }
}

bool LineOfSight::IsWithinLimits(double sine, const Target& target) const
{
  const SightLimits& limits = this->Limits;
  return target.Distance >= limits.MinimumRange && target.Distance <= limits.MaximumRange &&
    target.Cosine >= limits.MinimumCosine - Rounding && sine >= limits.MinimumSine - Rounding &&
    sine <= limits.MaximumSine + Rounding &&
    target.Cosine >= limits.DensityFactor * target.Distance * target.Distance;
}

void LineOfSight::Cast()
{
  const auto count = static_cast<vtkIdType>(this->Rays.size());
  if (!this->Limits.BothSides)
  {
    this->Caster.Occluded(this->Rays.data(), this->IsHidden.data(), count);
    return;
  }
  this->Caster.Intersect(this->Rays.data(), this->Hits.data(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkHeliosHit& hit = this->Hits[i];
    // Ranges are relative to the distance; rays end at the tolerance behind the test point.
    this->IsHidden[i] =
      hit.CellId < 0 || (1.0 - hit.Range) * this->Aimed[i].Distance > this->Limits.HitTolerance;
  }
}

} // namespace helios
