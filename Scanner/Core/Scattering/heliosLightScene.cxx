// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLightScene.h"

#include "heliosFlatOptics.h"
#include "heliosFresnel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{
namespace
{

constexpr double Rounding = 32.0 * std::numeric_limits<double>::epsilon();

double GetReach(const Vec3& point, double range)
{
  return std::max({ std::abs(point[0]), std::abs(point[1]), std::abs(point[2]), range });
}

vtkHeliosRay MakeRay(const Vec3& from, const Vec3& direction, double length)
{
  vtkHeliosRay ray;
  std::copy_n(from.GetData(), 3, ray.Origin);
  std::copy_n(direction.GetData(), 3, ray.Direction);
  ray.MaximumRange = length;
  return ray;
}

} // namespace

//------------------------------------------------------------------------------
vtkHeliosHit LightScene::Trace(const vtkHeliosRay& ray) const
{
  vtkHeliosHit hit{ std::numeric_limits<double>::infinity(), -1 };
  if (this->Caster)
  {
    this->Caster->Intersect(&ray, &hit, 1);
  }
  return hit;
}

//------------------------------------------------------------------------------
/// Replaces the hit of a ray if a leaf in a voxel is nearer.
void LightScene::Stop(const vtkHeliosRay& ray, PulseRandom& random, vtkHeliosHit& hit) const
{
  if (!this->Medium.IsEmpty())
  {
    this->Medium.Stop(
      Vec3(ray.Origin), Vec3(ray.Direction), ray.MaximumRange,
      [&random](std::size_t) { return random.Draw()[0]; }, hit);
  }
}

//------------------------------------------------------------------------------
/// Fills what scatters the light of a ray at its hit.
void LightScene::Describe(const vtkHeliosRay& ray, const vtkHeliosHit& hit, Scatterer& found) const
{
  const int material = this->Surfaces.GetMaterialId(hit.CellId);
  const bool isTurbid = this->Surfaces.IsTurbid(hit.CellId);
  found.Cell = hit.CellId;
  found.Incoming = Vec3(ray.Direction);
  found.Point = Vec3(ray.Origin) + hit.Range * found.Incoming;
  found.Reflection = this->Surfaces.GetReflection(material);
  found.Probability = 1.0;
  if (isTurbid)
  {
    found.Kind = this->IsIsotropic ? Scatterer::Isotropic : Scatterer::Leaf;
    found.Plane = found.Normal = -1.0 * found.Incoming;
    found.Transmittance = this->Surfaces.GetLeafTransmittance(material);
    found.Step = 0.0;
    return;
  }
  const auto faceLight = [&found](const Vec3& normal)
  { return normal.Dot(found.Incoming) > 0.0 ? -1.0 * normal : normal; };
  Vec3 normal = this->Caster->GetGeometry().GetNormal(hit.CellId);
  found.Kind = Scatterer::Surface;
  found.Plane = faceLight(normal);
  this->Surfaces.GetNormal(hit.CellId, normal);
  found.Normal = faceLight(normal);
  found.Transmittance = 0.0;
  found.Step = Rounding * GetReach(found.Point, hit.Range);
}

//------------------------------------------------------------------------------
/// Returns the shares of the light at a surface with optics.
LightScene::Shares LightScene::GetShares(const MaterialOptics& optics, const Scatterer& at) const
{
  const double cosine = std::min(1.0, -at.Plane.Dot(at.Incoming));
  const double scattered = at.Reflection.Reflectance;
  const double left = optics.MeanSquareSlope == 0.0 ? 1.0 - scattered : 0.0;
  switch (optics.Kind)
  {
    case OpticsKind::Leaf:
      return { scattered, optics.Transmittance, 0.0 };
    case OpticsKind::Pane:
      return { scattered, (1.0 - scattered) * GetShare(optics, cosine, false),
        left * GetShare(optics, cosine, true) };
    case OpticsKind::Mirror:
      return { scattered, 0.0, left * GetShare(optics, cosine, true) };
    default:
      return { scattered, 0.0, 0.0 };
  }
}

//------------------------------------------------------------------------------
bool LightScene::Follow(
  LightPath& path, vtkHeliosHit hit, PulseRandom& random, Scatterer& found) const
{
  path.IsStraight = true;
  for (int events = 0; events <= this->MaximumEvents; ++events)
  {
    this->Stop(path.Ray, random, hit);
    if (hit.CellId < 0)
    {
      return false;
    }
    this->Describe(path.Ray, hit, found);
    path.Length += hit.Range;
    const MaterialOptics* optics = this->Surfaces.GetOptics(hit.CellId);
    if (!optics)
    {
      return true;
    }
    const Shares shares = this->GetShares(*optics, found);
    const double sum = shares.GetSum();
    if (!(sum > 0.0))
    {
      return false;
    }
    const double choice = sum * random.Draw()[0];
    if (choice < shares.Scattered)
    {
      found.Probability = shares.Scattered / sum;
      path.Share /= found.Probability;
      return true;
    }
    path.Share *= sum;
    path.IsStraight = false;
    const Vec3 out = choice < shares.Scattered + shares.Passed
      ? found.Incoming
      : GetMirrored(found.Incoming, found.Plane);
    path.Ray = MakeRay(found.GetStart(out), out, std::numeric_limits<double>::infinity());
    hit = this->Trace(path.Ray);
  }
  return false;
}

//------------------------------------------------------------------------------
bool LightScene::Meet(
  const vtkHeliosRay& ray, vtkHeliosHit hit, PulseRandom& random, Scatterer& found) const
{
  this->Stop(ray, random, hit);
  if (hit.CellId < 0)
  {
    return false;
  }
  this->Describe(ray, hit, found);
  return found.Reflection.Reflectance > 0.0 || found.Transmittance > 0.0;
}

//------------------------------------------------------------------------------
double LightScene::GetProbability(const Scatterer& at) const
{
  const MaterialOptics* optics = this->Surfaces.GetOptics(at.Cell);
  if (!optics)
  {
    return 1.0;
  }
  const Shares shares = this->GetShares(*optics, at);
  return shares.GetSum() > 0.0 ? shares.Scattered / shares.GetSum() : 0.0;
}

//------------------------------------------------------------------------------
LightLeg LightScene::Connect(const Scatterer& from, const Vec3& to) const
{
  Vec3 way = to - from.Point;
  Vec3 start = from.GetStart(way);
  LightLeg leg{ this->GetTransmission(start, to), true };
  bool isHit = this->Caster != nullptr && leg.Transmission > 0.0;
  for (int events = 0; isHit; ++events)
  {
    way = to - start;
    const double length = way.Norm();
    const vtkHeliosRay ray = MakeRay(start, (1.0 / length) * way, length);
    if (!this->Surfaces.HasOptics())
    {
      unsigned char isOccluded = 0;
      this->Caster->Occluded(&ray, &isOccluded, 1);
      return { isOccluded ? 0.0 : leg.Transmission, true };
    }
    const vtkHeliosHit hit = this->Trace(ray);
    isHit = hit.CellId >= 0 && hit.Range <= length;
    if (isHit)
    {
      Scatterer at;
      this->Describe(ray, hit, at);
      const MaterialOptics* optics = this->Surfaces.GetOptics(hit.CellId);
      const bool passes = optics && events < this->MaximumEvents;
      leg.Transmission *= passes ? this->GetShares(*optics, at).Passed : 0.0;
      leg.IsClear = false;
      start = at.GetStart(at.Incoming);
      isHit = leg.Transmission > 0.0;
    }
  }
  return leg;
}

//------------------------------------------------------------------------------
double LightScene::GetTransmission(const Vec3& from, const Vec3& to) const
{
  if (this->Medium.IsEmpty())
  {
    return 1.0;
  }
  const Vec3 way = to - from;
  const double length = way.Norm();
  return std::exp(-this->Medium.GetDepth(from, (1.0 / length) * way, length));
}

//------------------------------------------------------------------------------
double LightScene::GetProjection(const Scatterer& scatterer, const Vec3& direction) const
{
  return scatterer.Kind == Scatterer::Surface
    ? std::abs(scatterer.Plane.Dot(direction))
    : this->Medium.GetProjection(scatterer.Cell, direction);
}

} // namespace helios
