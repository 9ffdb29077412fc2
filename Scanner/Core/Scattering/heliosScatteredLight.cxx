// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosScatteredLight.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{
namespace
{

// Paths with a smaller share of the energy go on with a probability, and then with this share.
constexpr double LeastShare = 0.05;

vtkHeliosRay MakeRay(const Vec3& from, const Vec3& direction)
{
  vtkHeliosRay ray;
  std::copy_n(from.GetData(), 3, ray.Origin);
  std::copy_n(direction.GetData(), 3, ray.Direction);
  return ray;
}

} // namespace

//------------------------------------------------------------------------------
ScatteredLight::ScatteredLight(const ScatteringSettings& settings, const LightScene& scene)
  : Settings(settings)
  , Scene(scene)
  , Versine(2.0 * std::pow(std::sin(0.5 * settings.HalfFieldOfView), 2))
  , SolidAngle(2.0 * vtkMath::Pi() * this->Versine)
  , Profile(settings.Step)
{
}

//------------------------------------------------------------------------------
void ScatteredLight::SetWeights(const std::vector<double>& weights)
{
  this->Sums.clear();
  double sum = 0.0;
  for (const double weight : weights)
  {
    sum += weight;
    this->Sums.push_back(sum);
  }
}

//------------------------------------------------------------------------------
void ScatteredLight::Sample(const Beam& beam)
{
  this->Profile.Clear();
  PulseRandom random(this->Settings.Seed, beam.PulseId);
  this->ChooseSubRays(beam, random);
  const bool isEmpty = this->Scene.Medium.IsEmpty() &&
    std::all_of(
      this->Hits.begin(), this->Hits.end(), [](const vtkHeliosHit& hit) { return hit.CellId < 0; });
  if (!isEmpty)
  {
    this->TraceView(beam, random);
  }
  for (std::size_t path = 0; !isEmpty && path < this->Rays.size(); ++path)
  {
    this->TracePath(beam, path, random);
  }
  this->Profile.Finish();
}

//------------------------------------------------------------------------------
/// Chooses a sub-ray for each path, by its weight, and finds its first surface. Each batch has paths
/// all over the beam.
void ScatteredLight::ChooseSubRays(const Beam& beam, PulseRandom& random)
{
  constexpr std::size_t batches = ScatteredProfile::NumberOfBatches;
  const std::size_t each = (static_cast<std::size_t>(this->Settings.Paths) + batches - 1) / batches;
  this->Rays.resize(each * batches);
  for (std::size_t k = 0; k < each * batches; ++k)
  {
    const double place = (static_cast<double>(k / batches) + random.Draw()[0]) /
      static_cast<double>(each) * this->Sums.back();
    const auto found = std::lower_bound(this->Sums.begin(), this->Sums.end(), place);
    const auto index = std::min<std::ptrdiff_t>(
      found - this->Sums.begin(), static_cast<std::ptrdiff_t>(this->Sums.size()) - 1);
    this->Rays[k] = beam.SubRays[static_cast<std::size_t>(index)];
  }
  this->TraceTogether(this->Rays, this->Hits);
}

//------------------------------------------------------------------------------
/// Follows a path until it leaves the scene or has all its orders.
void ScatteredLight::TracePath(const Beam& beam, std::size_t index, PulseRandom& random)
{
  this->Batch = index % ScatteredProfile::NumberOfBatches;
  LightPath path{ this->Rays[index], 1.0, 0.0, true };
  Scatterer at, seen;
  if (!this->Scene.Follow(path, this->Hits[index], random, at))
  {
    return;
  }
  const bool hasView = this->Scene.Meet(this->ViewRays[index], this->ViewHits[index], random, seen);
  for (int order = 2; order <= this->Settings.Orders; ++order)
  {
    const double survival = std::min(1.0, path.Share / LeastShare);
    if (hasView)
    {
      this->AddConnection(beam, path, at, seen, survival);
    }
    const auto u = random.Draw();
    const Vec3 out = at.Sample(u, [&random] { return random.Draw(); });
    const double density = at.GetDensity(out);
    const double response = at.GetResponse(out);
    if (u[3] > survival || !(response > 0.0))
    {
      return;
    }
    path.Share *= response / (vtkMath::Pi() * density * survival);
    const Vec3 from = at.GetStart(out);
    path.Ray = MakeRay(from, out);
    if (!this->Scene.Follow(path, this->Scene.Trace(path.Ray), random, at))
    {
      return;
    }
    this->AddArrival(beam, path, at, survival * density, from);
  }
}

//------------------------------------------------------------------------------
/// Finds the surfaces that random rays of the receiver meet in its field of view, one a path.
void ScatteredLight::TraceView(const Beam& beam, PulseRandom& random)
{
  this->ViewRays.clear();
  for (std::size_t k = 0; k < this->Rays.size(); ++k)
  {
    const auto u = random.Draw();
    const double versine = u[0] * this->Versine;
    this->ViewRays.push_back(MakeRay(beam.Receiver,
      GetAround(beam.Axis, 1.0 - versine, std::sqrt(versine * (2.0 - versine)),
        2.0 * vtkMath::Pi() * u[1])));
  }
  this->TraceTogether(this->ViewRays, this->ViewHits);
}

//------------------------------------------------------------------------------
void ScatteredLight::TraceTogether(
  const std::vector<vtkHeliosRay>& rays, std::vector<vtkHeliosHit>& hits) const
{
  hits.assign(rays.size(), { std::numeric_limits<double>::infinity(), -1 });
  if (this->Scene.Caster)
  {
    this->Scene.Caster->IntersectBeams(rays.data(), hits.data(), static_cast<int>(rays.size()), 1);
  }
}

//------------------------------------------------------------------------------
/// Adds the light that is scattered from the end of a path to a point in the field of view, and from
/// there to the receiver.
void ScatteredLight::AddConnection(const Beam& beam, const LightPath& path, const Scatterer& from,
  const Scatterer& seen, double survival)
{
  const Vec3 toReceiver = -1.0 * seen.Incoming;
  const Vec3 apart = seen.Point - from.Point;
  const double length = apart.Norm();
  const double distance = (seen.Point - beam.Receiver).Norm();
  if (!(length > 0.0 && distance > 0.0))
  {
    return;
  }
  const Vec3 way = (1.0 / length) * apart;
  // The light meets the side that the receiver sees, unless a leaf transmits it.
  Scatterer at = seen;
  at.Incoming = way;
  if (at.Kind == Scatterer::Surface)
  {
    if (at.Plane.Dot(way) >= 0.0 || at.Normal.Dot(way) >= 0.0)
    {
      return;
    }
  }
  else
  {
    at.Plane = at.Normal = -1.0 * way;
  }
  at.Probability = this->Scene.GetProbability(at);
  const double scattered = from.GetResponse(way) * at.GetResponse(toReceiver);
  if (!(scattered > 0.0))
  {
    return;
  }
  const LightLeg leg = this->Scene.Connect(from, at.GetStart(toReceiver));
  if (!(leg.Transmission > 0.0 && leg.IsClear))
  {
    return;
  }
  const double fromReceiver = this->Scene.GetTransmission(beam.Receiver, seen.Point);
  const double seenDensity = this->Scene.GetProjection(at, toReceiver) * fromReceiver /
    (this->SolidAngle * distance * distance);
  const double lit = this->Scene.GetProjection(at, way) * leg.Transmission / (length * length);
  const double drawnDensity = survival * from.GetDensity(way) * at.Probability * lit;
  const double share =
    path.Share * scattered / vtkMath::Pi() * lit * fromReceiver / (drawnDensity + seenDensity);
  this->AddReturn(at, path.Length + length, share, distance, toReceiver);
}

//------------------------------------------------------------------------------
/// Adds the light of a path that has met a point in the field of view.
void ScatteredLight::AddArrival(const Beam& beam, const LightPath& path, const Scatterer& at,
  double fromDensity, const Vec3& from)
{
  const Vec3 apart = beam.Receiver - at.Point;
  const double distance = apart.Norm();
  const Vec3 out = (1.0 / distance) * apart;
  const double response = at.GetResponse(out);
  if (!(response > 0.0) || 0.5 * (beam.Axis + out).SquaredNorm() > this->Versine)
  {
    return;
  }
  const LightLeg leg = this->Scene.Connect(at, beam.Receiver);
  if (!(leg.Transmission > 0.0))
  {
    return;
  }
  double weight = 1.0;
  if (path.IsStraight && leg.IsClear)
  {
    const double length = (at.Point - from).Norm();
    const double seen = this->Scene.GetProjection(at, out) * leg.Transmission /
      (this->SolidAngle * distance * distance);
    const double drawn = fromDensity * at.Probability * this->Scene.GetProjection(at, at.Incoming) *
      this->Scene.GetTransmission(from, at.Point) / (length * length);
    weight = drawn / (drawn + seen);
  }
  this->AddReturn(
    at, path.Length, weight * path.Share * response * leg.Transmission, distance, out);
}

//------------------------------------------------------------------------------
/// Adds light that is scattered to the receiver after a length of its path.
void ScatteredLight::AddReturn(
  const Scatterer& at, double length, double share, double distance, const Vec3& out)
{
  const LidarEquation& equation = this->Settings.Equation;
  const double range = 0.5 * (length + distance);
  // No more light returns than there is, however near.
  const double nearest = std::max(distance, 0.5 * equation.ReceiverDiameter);
  const double power = this->Settings.Power / static_cast<double>(this->Rays.size()) * share *
    equation.GetGain(nearest, equation.GetTransmission(range));
  if (power > 0.0 && range >= this->Settings.MinimumRange && range <= this->Settings.MaximumRange)
  {
    this->Profile.Add(
      { range, power, this->Batch, at.Cell, std::abs(at.Normal.Dot(out)), at.Point });
  }
}

} // namespace helios
