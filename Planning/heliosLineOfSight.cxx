// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLineOfSight.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

// Of sines and cosines: what lies on a limit keeps it.
constexpr double Rounding = 1e-12;

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

SightSum LineOfSight::Look(const Vec3& eye, vtkIdType first, vtkTypeUInt64* words)
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
    const double distance = way.Norm();
    const Vec3 sight = distance > 0.0 ? (1.0 / distance) * way : Vec3(0.0, 0.0, -1.0);
    Target target{ v - first, distance, 1.0 };
    if (this->Targets.Normals)
    {
      target.Cosine = std::abs(sight.Dot(Vec3(this->Targets.Normals + 3 * v)));
    }
    if (this->IsWithinLimits(sight, target))
    {
      this->Aimed.push_back(target);
      this->Rays.push_back({ { eye[0], eye[1], eye[2] }, { sight[0], sight[1], sight[2] },
        distance + (this->Limits.BothSides ? 1.0 : -1.0) * this->Limits.HitTolerance });
    }
  }
}

bool LineOfSight::IsWithinLimits(const Vec3& sight, const Target& target) const
{
  const SightLimits& limits = this->Limits;
  return target.Distance >= limits.MinimumRange && target.Distance <= limits.MaximumRange &&
    target.Cosine >= limits.MinimumCosine - Rounding && sight[2] >= limits.MinimumSine - Rounding &&
    sight[2] <= limits.MaximumSine + Rounding &&
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
    this->IsHidden[i] =
      hit.CellId < 0 || std::abs(hit.Range - this->Aimed[i].Distance) > this->Limits.HitTolerance;
  }
}

} // namespace helios
