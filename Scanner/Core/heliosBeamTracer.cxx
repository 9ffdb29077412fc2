// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamTracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

/// Some sub-rays, or those of a finer step.
const std::vector<SubRay>& GetFiner(
  const std::vector<SubRay>& coarse, const std::vector<std::vector<SubRay>>& finer, int step)
{
  return step == 0 ? coarse : finer[static_cast<std::size_t>(step - 1)];
}

} // namespace

BeamTracer::BeamTracer(const ScanModel& model, SurfaceResponse& response)
  : Model(model)
  , Response(response)
  , SigmaRange(0.5 * SpeedOfLight * model.Receiver.Shape.GetSigma())
{
}

//------------------------------------------------------------------------------
void BeamTracer::Cast(
  const std::vector<SubRay>& subRays, const Pulse* pulses, std::size_t count, ScanCounts& counts)
{
  this->SubRays = &subRays;
  this->HasAnswers = false;
  const std::size_t size = count * subRays.size();
  this->Rays.resize(std::max(this->Rays.size(), size));
  this->Hits.resize(this->Rays.size());
  vtkHeliosRay* ray = this->Rays.data();
  for (const Pulse* pulse = pulses; pulse != pulses + count; ++pulse)
  {
    for (const SubRay& subRay : subRays)
    {
      const Vec3 direction = pulse->Beam * subRay.Direction;
      const Vec3 origin =
        this->Model.HasOffsets ? pulse->Origin + pulse->Beam * subRay.Offset : pulse->Origin;
      std::copy_n(origin.GetData(), 3, ray->Origin);
      std::copy_n(direction.GetData(), 3, ray->Direction);
      ++ray;
    }
  }
  this->Meet(pulses, count);
  counts.SubRays += static_cast<vtkIdType>(size);
}

//------------------------------------------------------------------------------
/// What the sub-rays meet: surfaces, or leaves before them.
void BeamTracer::Meet(const Pulse* pulses, std::size_t count)
{
  const std::size_t each = this->SubRays->size();
  if (this->Model.Caster)
  {
    this->Model.Caster->IntersectBeams(
      this->Rays.data(), this->Hits.data(), static_cast<int>(each), static_cast<vtkIdType>(count));
  }
  else
  {
    const double endless = std::numeric_limits<double>::infinity();
    std::fill(this->Hits.begin(), this->Hits.end(), vtkHeliosHit{ endless, -1 });
  }
  for (std::size_t i = 0; !this->Model.Medium.IsEmpty() && i < count; ++i)
  {
    this->Model.Medium.Intercept(this->Model.Seed, pulses[i].Id, this->Rays.data() + i * each, each,
      this->Hits.data() + i * each);
  }
}

//------------------------------------------------------------------------------
void BeamTracer::CastByTolerance(const Pulse& pulse, ScanCounts& counts)
{
  if (this->Model.MeetsMedium(pulse))
  {
    this->Cast(this->Model.SubRays, &pulse, 1, counts);
    return;
  }
  this->Cast(this->Model.Probes, &pulse, 1, counts);
  this->AskSurfaces(0);
  this->HasAnswers = true;
  const double spread = this->GetSpread();
  const int step = this->GetStep(spread);
  if (this->SeeEdge())
  {
    this->Cast(GetFiner(this->Model.SubRays, this->Model.FinerSubRays, step), &pulse, 1, counts);
  }
  else if (spread > this->Model.Plan.LargestSpread)
  {
    this->Cast(GetFiner(this->Model.Rings, this->Model.FinerRings, step), &pulse, 1, counts);
  }
}

//------------------------------------------------------------------------------
/// Asks what a pulse's sub-rays meet for their replies.
void BeamTracer::AskSurfaces(std::size_t slot)
{
  const std::size_t count = this->SubRays->size();
  this->Response.GetReplies(
    this->Rays.data() + slot * count, this->Hits.data() + slot * count, count, this->Answers);
}

//------------------------------------------------------------------------------
bool BeamTracer::SeeEdge()
{
  const auto& pairs = this->Model.ProbePairs;
  return std::any_of(pairs.begin(), pairs.end(),
    [this](const auto& pair) { return this->IsEdgeBetween(pair.first, pair.second); });
}

//------------------------------------------------------------------------------
/// Whether b does not lie near the plane of a, or one returns less than half as much.
bool BeamTracer::IsEdgeBetween(std::size_t a, std::size_t b)
{
  const vtkHeliosHit& hitA = this->Hits[a];
  const vtkHeliosHit& hitB = this->Hits[b];
  if (hitA.CellId == hitB.CellId)
  {
    return this->IsSilent(hitA) != this->IsSilent(hitB);
  }
  if (this->IsSilent(hitA) || this->IsSilent(hitB))
  {
    return this->IsSilent(hitA) != this->IsSilent(hitB);
  }
  const double powerA = this->Answers.Powers[a];
  const double powerB = this->Answers.Powers[b];
  if (std::min(powerA, powerB) < 0.5 * std::max(powerA, powerB))
  {
    return true;
  }
  const vtkHeliosRay& rayA = this->Rays[a];
  const vtkHeliosRay& rayB = this->Rays[b];
  const Vec3& normal = this->Response.GetPlaneNormal(hitA.CellId);
  double toPlane = hitA.Range * normal.Dot(Vec3(rayA.Direction));
  if (this->Model.HasOffsets)
  {
    toPlane += normal.Dot(Vec3(rayA.Origin) - Vec3(rayB.Origin));
  }
  const double slope = normal.Dot(Vec3(rayB.Direction));
  return !(std::abs(toPlane - slope * hitB.Range) <=
    std::abs(slope) * this->Model.Plan.GetEdgeTolerance());
}

//------------------------------------------------------------------------------
/// The ranges that the probes meet spread over, in sigma_R.
double BeamTracer::GetSpread() const
{
  double nearest = VTK_DOUBLE_MAX;
  double farthest = -VTK_DOUBLE_MAX;
  for (std::size_t i = 0; i < this->SubRays->size(); ++i)
  {
    const vtkHeliosHit& hit = this->Hits[i];
    if (hit.CellId >= 0)
    {
      nearest = std::min(nearest, hit.Range);
      farthest = std::max(farthest, hit.Range);
    }
  }
  return (farthest - nearest) / this->SigmaRange;
}

//------------------------------------------------------------------------------
/// How much finer than usual the steepest surface needs the sub-rays; no edge makes them so.
int BeamTracer::GetStep(double spread)
{
  if (this->Model.Plan.GetStep(spread) == 0)
  {
    return 0;
  }
  double slope = 0.0; // of the range, by angle
  for (const auto& [a, b] : this->Model.ProbePairs)
  {
    if (!this->IsSilent(this->Hits[a]) && !this->IsEdgeBetween(a, b))
    {
      const double angle = (Vec3(this->Rays[a].Direction) - Vec3(this->Rays[b].Direction)).Norm();
      slope = std::max(slope, std::abs(this->Hits[a].Range - this->Hits[b].Range) / angle);
    }
  }
  return this->Model.Plan.GetStep(
    std::min(spread, 2.0 * this->Model.ConeTangent * slope / this->SigmaRange));
}

//------------------------------------------------------------------------------
void BeamTracer::Collect(std::size_t slot, std::vector<SubReturn>& returns,
  std::vector<CastSubRay>& cast, ScanCounts& counts)
{
  const std::size_t count = this->SubRays->size();
  const SubRay* subRays = this->SubRays->data();
  const vtkHeliosRay* rays = this->Rays.data() + slot * count;
  const vtkHeliosHit* hits = this->Hits.data() + slot * count;
  if (!this->HasAnswers)
  {
    this->AskSurfaces(slot);
  }
  returns.resize(count);
  SubReturn* to = returns.data();
  for (std::size_t k = 0; k < count; ++k)
  {
    const vtkHeliosHit hit = hits[k];
    if (this->IsSilent(hit))
    {
      counts.HitsOutOfRange += hit.CellId >= 0 ? 1 : 0;
      continue;
    }
    if (!(subRays[k].Weight > 0.0))
    {
      continue;
    }
    to->Power = subRays[k].Weight * this->Answers.Powers[k];
    to->Range = hit.Range;
    to->CosIncidence = this->Answers.Cosines[k];
    to->CellId = hit.CellId;
    to->SubRay = static_cast<int>(k);
    ++to;
  }
  returns.resize(static_cast<std::size_t>(to - returns.data()));
  cast.clear();
  for (std::size_t k = 0; this->Model.WantsSubRays && k < count; ++k)
  {
    cast.push_back({ Vec3(rays[k].Direction), subRays[k].Weight });
  }
}

} // namespace helios
