// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPathTracer.h"

#include "heliosConstants.h"
#include "heliosFlatOptics.h"
#include "heliosFresnel.h"
#include "heliosGlint.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{
namespace
{

constexpr double Rounding = 8.0 * std::numeric_limits<double>::epsilon();

Vec3 GetPoint(const vtkHeliosRay& ray, double range)
{
  return Vec3(ray.Origin) + range * Vec3(ray.Direction);
}

double GetLargest(const Vec3& v)
{
  return std::max({ std::abs(v[0]), std::abs(v[1]), std::abs(v[2]) });
}

} // namespace

//------------------------------------------------------------------------------
PathTracer::PathTracer(const ScanModel& model, SurfaceResponse& response)
  : Model(model)
  , Response(response)
  , Column(0.5 * SpeedOfLight * model.Receiver.Shape.GetSigma())
{
}

//------------------------------------------------------------------------------
void PathTracer::StartPulse(const Vec3& receiver, std::vector<SubReturn>& returns)
{
  this->Returns = &returns;
  this->Ends.clear();
  this->Waiting.clear();
  this->Column.Clear();
  this->Receiver = receiver;
}

//------------------------------------------------------------------------------
void PathTracer::Add(const vtkHeliosRay& ray, const vtkHeliosHit& hit, double weight, int subRay)
{
  const Path start{ ray, Pencil(Vec3(ray.Direction), hit.Range), weight, subRay, 1.0, hit.Range,
    hit.Range, 1.0, 1.0, 0.0, nullptr, 0, 0u, hit.CellId };
  const SurfaceInteraction at = this->GetInteraction(start, hit);
  this->Glint(start, at);
  this->Split(start, at);
}

//------------------------------------------------------------------------------
void PathTracer::Follow()
{
  while (!this->Waiting.empty())
  {
    this->TraceGeneration();
  }
  this->AppendColumn();
}

//------------------------------------------------------------------------------
/// Traces all paths after as many events; paths that took the same turns are neighbours.
void PathTracer::TraceGeneration()
{
  std::swap(this->Current, this->Waiting);
  this->Waiting.clear();
  std::stable_sort(this->Current.begin(), this->Current.end(),
    [](const Path& a, const Path& b) { return a.Turns < b.Turns; });
  for (std::size_t first = 0, next = 0; first < this->Current.size(); first = next)
  {
    const auto differs = [&](const Path& path) { return path.Turns != this->Current[first].Turns; };
    next = static_cast<std::size_t>(
      std::find_if(
        this->Current.begin() + static_cast<std::ptrdiff_t>(first), this->Current.end(), differs) -
      this->Current.begin());
    this->TraceBranch(&this->Current[first], next - first);
  }
}

//------------------------------------------------------------------------------
/// Paths that took the same turns, as one beam.
void PathTracer::TraceBranch(const Path* first, std::size_t count)
{
  this->Rays.resize(count);
  this->Hits.resize(count);
  std::transform(
    first, first + count, this->Rays.begin(), [](const Path& path) { return path.Ray; });
  this->Model.Caster->IntersectBeams(
    this->Rays.data(), this->Hits.data(), static_cast<int>(count), 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Meet(first[i], this->Hits[i]);
  }
}

//------------------------------------------------------------------------------
/// Handles the hit of a path: the receiver or a surface.
void PathTracer::Meet(const Path& start, const vtkHeliosHit& hit)
{
  this->Receive(start, hit.Range);
  this->ScatterWithin(start, hit.Range);
  if (hit.CellId < 0)
  {
    return;
  }
  Path path = start;
  this->Advance(path, hit.Range);
  const SurfaceInteraction at = this->GetInteraction(path, hit);
  this->Scatter(path, at);
  if (at.Optics)
  {
    this->Glint(path, at);
    this->Split(path, at);
  }
}

//------------------------------------------------------------------------------
void PathTracer::Advance(Path& path, double length) const
{
  path.Spread.Advance(length);
  path.Optical += path.Slowness * length;
  path.InAir += path.Medium ? 0.0 : length;
  path.Share *= path.Attenuation > 0.0 ? std::exp(-path.Attenuation * length) : 1.0;
}

//------------------------------------------------------------------------------
PathTracer::SurfaceInteraction PathTracer::GetInteraction(const Path& path, const vtkHeliosHit& hit)
{
  const Vec3 direction(path.Ray.Direction);
  const Vec3& plane = this->Response.GetPlaneNormal(hit.CellId);
  const double cosine = plane.Dot(direction);
  const Vec3 point = GetPoint(path.Ray, hit.Range);
  return { point, cosine > 0.0 ? -1.0 * plane : plane, direction, std::min(1.0, std::abs(cosine)),
    GetLargest(point) + hit.Range, hit.CellId, this->Model.Surfaces.GetOptics(hit.CellId) };
}

//------------------------------------------------------------------------------
/// Adds the light that a surface scatters back along a path.
void PathTracer::Scatter(const Path& path, const SurfaceInteraction& at)
{
  const SceneSurfaces& surfaces = this->Model.Surfaces;
  const SurfaceReflection& surface = surfaces.GetReflection(surfaces.GetMaterialId(at.Cell));
  const double cosine = std::abs(this->Response.GetNormal(at.Cell).Dot(at.Direction));
  const double power = this->GetPower(path, GetBackscatter(surface, cosine));
  this->AddReturn(path, path.Optical, power, cosine, at.Cell, at.Point);
}

//------------------------------------------------------------------------------
/// The power that returns from the end of a path: for a response like GetBackscatter().
double PathTracer::GetPower(const Path& path, double response) const
{
  // n^2 of the medium: the aperture is seen under a smaller solid angle from within it.
  const double area = path.Spread.GetArea() * path.Index * path.Index;
  return this->Model.Power *
    this->Model.Equation.GetGain(
      std::sqrt(area), this->Model.Equation.GetTransmission(path.InAir)) *
    response * path.Share * path.Share;
}

//------------------------------------------------------------------------------
/// Adds the light that the medium of a path scatters back before the next surface: a slab of a
/// length is a surface of the response pi beta times that length.
void PathTracer::ScatterWithin(const Path& path, double length)
{
  const double beta = path.Medium ? path.Medium->Backscatter : this->Model.Air.GetBackscatter();
  if (!(beta > 0.0))
  {
    return;
  }
  const double end = std::min(path.Optical + path.Slowness * length, this->GetVisibleRange(path));
  const auto advance = [&](double range)
  {
    Path there = path;
    this->Advance(there, (range - path.Optical) / path.Slowness);
    return there;
  };
  const double response = path.Weight * vtkMath::Pi() * beta / path.Slowness; // per range
  const RangeGate& gate = this->Model.Gate;
  this->Column.Add(
    std::max(path.Optical, gate.Minimum), std::min(end, gate.Maximum),
    [&](double range) { return this->GetPower(advance(range), response); },
    [&](double range, ColumnProfile::Slab& slab)
    {
      slab.Cell = path.LastCell;
      slab.Point = GetPoint(path.Ray, (range - path.Optical) / path.Slowness);
      slab.Events = path.Events;
    });
}

//------------------------------------------------------------------------------
/// Returns the range from which on too little returns from the medium of a path.
double PathTracer::GetVisibleRange(const Path& path) const
{
  if (!path.Medium)
  {
    return this->Model.Air.GetEnd();
  }
  const double excess = path.Share * path.Share / this->Model.Optics.LeastShare;
  return path.Optical + path.Slowness * std::log(std::max(1.0, excess)) / (2.0 * path.Attenuation);
}

//------------------------------------------------------------------------------
void PathTracer::AppendColumn()
{
  this->Column.ForEachReturn(
    [this](double range, double power, const ColumnProfile::Slab& slab)
    {
      this->Returns->push_back({ range, power, slab.Cosine, slab.Cell, SubReturn::Column,
        this->AddEnd({ slab.Point, slab.Events }) });
    });
}

//------------------------------------------------------------------------------
/// Adds the light that a retroreflector, or the facets of a rough surface, return.
void PathTracer::Glint(const Path& path, const SurfaceInteraction& at)
{
  const MaterialOptics& optics = *at.Optics;
  if (!(at.Cosine > 0.0))
  {
    return;
  }
  if (optics.Kind == OpticsKind::Retroreflector)
  {
    const double response = GetRetroreflection(optics.Retroreflection, at.Cosine);
    this->AddReturn(
      path, path.Optical, this->GetPower(path, response), at.Cosine, at.Cell, at.Point);
  }
  else if (optics.MeanSquareSlope > 0.0)
  {
    const double facet = optics.Kind == OpticsKind::Volume
      ? GetFresnelReflectance(1.0, path.Index, GetIndexBeyond(path, optics)).GetMean()
      : GetShare(optics, 1.0, true);
    const double response = GetGlint(facet, optics.MeanSquareSlope, at.Cosine);
    this->AddReturn(
      path, path.Optical, this->GetPower(path, response), at.Cosine, at.Cell, at.Point);
  }
}

//------------------------------------------------------------------------------
/// Adds the light of a path that comes back to the receiver before a range.
void PathTracer::Receive(const Path& path, double range)
{
  const Vec3 toReceiver = this->Receiver - Vec3(path.Ray.Origin);
  const Vec3 direction(path.Ray.Direction);
  const double length = toReceiver.Dot(direction);
  const double radius = 0.5 * this->Model.Equation.ReceiverDiameter;
  if (path.Medium || !(length > 0.0 && length < range) ||
    (toReceiver - length * direction).SquaredNorm() > radius * radius)
  {
    return;
  }
  const double half = 0.5 * (path.InAir + length);
  const double power = this->Model.Power * this->Model.Equation.OpticalEfficiency *
    this->Model.Equation.GetTransmission(half) * path.Share;
  this->AddReturn(path, 0.5 * (path.Optical + length), power, 1.0, path.LastCell, this->Receiver);
}

//------------------------------------------------------------------------------
void PathTracer::AddReturn(
  const Path& path, double range, double power, double cosine, vtkIdType cell, const Vec3& end)
{
  if (power > 0.0 && !this->Model.Gate.IsOutsideGate(cell, range))
  {
    this->Returns->push_back({ range, path.Weight * power, cosine, cell, path.SubRay,
      static_cast<int>(this->Ends.size()) });
    this->Ends.push_back({ end, path.Events });
  }
}

//------------------------------------------------------------------------------
void PathTracer::Split(const Path& path, const SurfaceInteraction& at)
{
  if (path.Events >= this->Model.Optics.MaximumEvents)
  {
    return;
  }
  const SceneSurfaces& surfaces = this->Model.Surfaces;
  const double left = // after what the surface scatters
    1.0 - surfaces.GetReflection(surfaces.GetMaterialId(at.Cell)).Reflectance;
  const MaterialOptics& optics = *at.Optics;
  if (optics.Kind == OpticsKind::Leaf)
  {
    this->Continue(path, at, at.Point, at.Direction, optics.Transmittance, false);
  }
  else if (optics.Kind == OpticsKind::Mirror || optics.Kind == OpticsKind::Pane)
  {
    if (optics.Kind == OpticsKind::Pane)
    {
      this->PassPane(path, at, left * GetShare(optics, at.Cosine, false));
    }
    this->Reflect(path, at, left * GetShare(optics, at.Cosine, true));
  }
  else if (optics.Kind == OpticsKind::Volume)
  {
    const double beyond = GetIndexBeyond(path, optics);
    const double reflected = GetFresnelReflectance(at.Cosine, path.Index, beyond).GetMean();
    this->Refract(path, at, left * (1.0 - reflected));
    this->Reflect(path, at, left * reflected);
  }
}

//------------------------------------------------------------------------------
/// Reflects. A rough surface returns its reflected light by Glint(), or loses it.
void PathTracer::Reflect(const Path& path, const SurfaceInteraction& at, double share)
{
  if (at.Optics->MeanSquareSlope > 0.0)
  {
    return;
  }
  Path reflected = path;
  reflected.Spread.Reflect(at.Normal);
  this->Continue(reflected, at, at.Point, GetMirrored(at.Direction, at.Normal), share, true);
}

//------------------------------------------------------------------------------
/// Passes both faces: shifted, and later than in air.
void PathTracer::PassPane(const Path& path, const SurfaceInteraction& at, double share)
{
  const MaterialOptics& pane = *at.Optics;
  const double index = pane.RefractiveIndex;
  const double refracted = GetRefractedCosine(at.Cosine, 1.0, index);
  const Vec3 within = GetRefracted(at.Direction, at.Normal, 1.0, index, refracted);
  const double length = pane.Thickness / refracted;
  Path passed = path;
  passed.Spread.Refract(at.Direction, at.Normal, at.Cosine, refracted, index);
  passed.Spread.Advance(length);
  passed.Spread.Refract(within, at.Normal, refracted, at.Cosine, 1.0 / index);
  passed.Optical += pane.GroupIndex * length;
  this->Continue(passed, at, at.Point + length * within, at.Direction, share, false);
}

//------------------------------------------------------------------------------
/// Refracts into a volume, or out of one.
void PathTracer::Refract(const Path& path, const SurfaceInteraction& at, double share)
{
  const bool leaves = path.Medium == at.Optics;
  Path passed = path;
  passed.Index = leaves ? 1.0 : at.Optics->RefractiveIndex;
  passed.Slowness = leaves ? 1.0 : at.Optics->GroupIndex;
  passed.Attenuation = leaves ? 0.0 : at.Optics->Attenuation;
  passed.Medium = leaves ? nullptr : at.Optics;
  const double refracted = GetRefractedCosine(at.Cosine, path.Index, passed.Index);
  if (refracted > 0.0)
  {
    passed.Spread.Refract(at.Direction, at.Normal, at.Cosine, refracted, passed.Index / path.Index);
    this->Continue(passed, at, at.Point,
      GetRefracted(at.Direction, at.Normal, path.Index, passed.Index, refracted), share, false);
  }
}

//------------------------------------------------------------------------------
/// Returns the refractive index on the other side of the surface of a volume.
double PathTracer::GetIndexBeyond(const Path& path, const MaterialOptics& optics)
{
  return path.Medium == &optics ? 1.0 : optics.RefractiveIndex;
}

//------------------------------------------------------------------------------
/// Queues a path from a point of the surface that it met, unless too little energy is left.
void PathTracer::Continue(Path path, const SurfaceInteraction& at, const Vec3& from,
  const Vec3& direction, double share, bool isReflected)
{
  path.Share *= share;
  if (!(path.Share * path.Share >= this->Model.Optics.LeastShare))
  {
    return;
  }
  // Past the rounding errors of the point, so that it does not hit the same surface again.
  const double step = Rounding * at.Reach / std::max(at.Cosine, 1e-6);
  const Vec3 origin = from + step * direction;
  std::copy_n(origin.GetData(), 3, path.Ray.Origin);
  std::copy_n(direction.GetData(), 3, path.Ray.Direction);
  path.LastCell = at.Cell;
  path.Turns = path.Turns << 1 | (isReflected ? 1u : 0u); // last 32 turns: for the order only
  ++path.Events;
  this->Advance(path, step);
  this->Waiting.push_back(path);
}

} // namespace helios
