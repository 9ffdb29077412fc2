// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosBeamTracer.h"

#include "heliosRayVectors.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace helios
{

namespace
{

/// Aims sub-rays along a pulse: their directions and offsets, rotated by the beam's rotation.
HELIOS_CLONES
vtkHeliosRay* Aim(
  const Pulse& pulse, const std::vector<SubRay>& subRays, bool hasOffsets, vtkHeliosRay* ray)
{
  static_assert(offsetof(vtkHeliosRay, Direction) == 3 * sizeof(double) &&
      sizeof(vtkHeliosRay) == 7 * sizeof(double),
    "origin, direction and range are written as two vectors that overlap");
  const auto& m = pulse.Beam.M;
  const Doubles x = { m[0][0], m[1][0], m[2][0], 0.0 };
  const Doubles y = { m[0][1], m[1][1], m[2][1], 0.0 };
  const Doubles z = { m[0][2], m[1][2], m[2][2], 0.0 };
  const Doubles apex = { pulse.Origin[0], pulse.Origin[1], pulse.Origin[2], 0.0 };
  const Doubles range = Doubles() + vtkHeliosRay().MaximumRange;
  constexpr Masks isRange = { 0, 0, 0, -1 };
  for (const SubRay& subRay : subRays)
  {
    const Vec3& d = subRay.Direction;
    const Doubles direction = isRange ? range : x * d[0] + y * d[1] + z * d[2];
    Doubles origin = apex;
    if (hasOffsets)
    {
      const Vec3& o = subRay.Offset;
      origin = apex + (x * o[0] + y * o[1] + z * o[2]);
    }
    auto* place = reinterpret_cast<char*>(ray++);
    Store(place, origin);
    Store(place + offsetof(vtkHeliosRay, Direction), direction);
  }
  return ray;
}

constexpr double RimOfRings = 1.75; // at least; times the outermost Gauss-Legendre ring

std::vector<Vec3> GetDirections(const std::vector<SubRay>& subRays)
{
  std::vector<Vec3> directions;
  for (const SubRay& subRay : subRays)
  {
    directions.push_back(subRay.Direction);
  }
  return directions;
}

} // namespace

BeamTracer::BeamTracer(const ScanModel& model, SurfaceResponse& response)
  : Model(model)
  , Response(response)
  , Paths(model, response)
  , Layers(GetDirections(model.LayerSubRays))
  , Surfaces(model.Footprints,
      [&model](vtkIdType a, vtkIdType b) { return model.Surfaces.AreAlike(a, b); })
{
}

//------------------------------------------------------------------------------
bool BeamTracer::SampleLayer(const Pulse& pulse, const ConeLayer& layer, ScanCounts& counts)
{
  const std::vector<SubRay>& subRays = this->Model.LayerSubRays;
  const std::size_t count = subRays.size();
  RayBatch& batch = this->More;
  this->Resize(batch, subRays, 1);
  if (this->Model.Plane.Ratio != 1.0)
  {
    this->Layers.Align(layer.Frame, pulse.GetMajorAxis(), pulse.GetMinorAxis());
  }
  this->Layers.Trace(layer, pulse.Origin.GetData(), batch.Rays.data(), batch.Hits.data());
  const auto [nearest, farthest] =
    std::minmax_element(batch.Hits.begin(), batch.Hits.begin() + static_cast<std::ptrdiff_t>(count),
      [](const vtkHeliosHit& a, const vtkHeliosHit& b) { return a.Range < b.Range; });
  const double spread = RimOfRings * (farthest->Range - nearest->Range);
  const RangeGate& gate = this->Model.Gate;
  const auto isNear = [&](double limit)
  { return limit > nearest->Range - spread && limit < farthest->Range + spread; };
  if (!(nearest->Range > 0.0) || spread > this->Model.Plan.LayerSpread || isNear(gate.Minimum) ||
    isNear(gate.Maximum))
  {
    return false;
  }
  this->Select(batch, 0);
  counts.SubRays += static_cast<vtkIdType>(count);
  return true;
}

//------------------------------------------------------------------------------
bool BeamTracer::CollectSurfaces(const Pulse& pulse)
{
  const Vec3 axis = pulse.GetDirection();
  const Vec3 minor = pulse.GetMinorAxis();
  return this->Surfaces.Collect(
           *this->Model.Cones, pulse.Origin.GetData(), axis.GetData(), minor.GetData()) &&
    this->Surfaces.AreEdgesStraight();
}

//------------------------------------------------------------------------------
bool BeamTracer::ComputeParts(const Pulse& pulse, ScanCounts& counts)
{
  const SamplingPlan& plan = this->Model.Plan;
  const std::size_t faces = this->Surfaces.GetNumberOfFaces();
  if (this->Surfaces.IsCrowd() ||
    (plan.PrefersCells(faces, this->Surfaces.GetLayers()) && this->Surfaces.IsFlat() &&
      !this->Surfaces.MeetsGate()))
  {
    return this->SampleSurfaces(pulse, plan.GetCellsAcross(faces), counts);
  }
  if (faces > plan.MaximumSurfaces || !this->Surfaces.Divide(this->Parts))
  {
    return false;
  }
  counts.SubRays += static_cast<vtkIdType>(this->Parts.size());
  this->SelectParts(pulse.Origin);
  return true;
}

//------------------------------------------------------------------------------
bool BeamTracer::SampleSurfaces(const Pulse& pulse, int across, ScanCounts& counts)
{
  if (across > this->Model.Plan.MaximumCellsAcross)
  {
    return false;
  }
  this->Surfaces.Sample(across, this->Parts);
  counts.SubRays += static_cast<vtkIdType>(this->Parts.size());
  this->SelectParts(pulse.Origin);
  return true;
}

//------------------------------------------------------------------------------
/// Accepts the parts as sub-rays from an origin.
void BeamTracer::SelectParts(const Vec3& origin)
{
  const std::size_t count = this->Parts.size();
  this->PartRays.resize(count);
  RayBatch& batch = this->More;
  this->Resize(batch, this->PartRays, 1);
  for (std::size_t i = 0; i < count; ++i)
  {
    const FootprintPart& part = this->Parts[i];
    this->PartRays[i].Weight = part.Energy;
    vtkHeliosRay& ray = batch.Rays[i];
    std::copy_n(origin.GetData(), 3, ray.Origin);
    std::copy_n(part.Direction, 3, ray.Direction);
    batch.Hits[i] = { part.Range, part.Cell };
  }
  this->Select(batch, 0);
}

//------------------------------------------------------------------------------
/// Makes room for the sub-rays of some pulses.
void BeamTracer::Resize(
  RayBatch& batch, const std::vector<SubRay>& subRays, std::size_t pulses) const
{
  batch.SubRays = &subRays;
  batch.Rays.resize(std::max(batch.Rays.size(), pulses * subRays.size()));
  batch.Hits.resize(batch.Rays.size());
}

//------------------------------------------------------------------------------
void BeamTracer::Cast(const std::vector<Pulse>& pulses, std::size_t first, std::size_t last,
  PulseGroups& groups, ScanCounts& counts)
{
  RayBatch& batch = this->First;
  this->Resize(batch, this->Model.SubRays, pulses.size());
  this->Beams.resize(pulses.size());
  counts.SubRays += static_cast<vtkIdType>((last - first) * this->Model.SubRays.size());
  for (std::size_t i = first; i < last; ++i) // first: of the pulses that have to be traced
  {
    const ConeGroup* group = groups.Get(i);
    this->Beams[i] = group ? this->MeetGroup(pulses[i], *group, batch, i) : Unknown;
    if (this->Beams[i] != Unknown)
    {
      this->Meet(pulses.data(), first, i, batch);
      first = i + 1;
    }
  }
  this->Meet(pulses.data(), first, last, batch);
}

//------------------------------------------------------------------------------
/// Aims the sub-rays of a pulse, and finds their hits if one triangle, or none, fills its beam.
BeamTracer::Contents BeamTracer::MeetGroup(
  const Pulse& pulse, const ConeGroup& group, RayBatch& batch, std::size_t slot)
{
  const ScanModel& m = this->Model;
  const Vec3 axis = pulse.GetDirection();
  const ConeTriangles found = group.Select(pulse.Origin.GetData(), axis.GetData(), m.ConeTangent);
  if (found.AreNone() && m.Air.IsEmpty() && !m.Wants.SubRays)
  {
    return Empty;
  }
  if (!found.IsOne())
  {
    return Unknown;
  }
  const std::size_t each = m.SubRays.size();
  vtkHeliosRay* rays = batch.Rays.data() + slot * each;
  Aim(pulse, m.SubRays, m.HasOffsets, rays);
  group.Meet(found.Covering, rays, each, batch.Hits.data() + slot * each);
  return Known;
}

//------------------------------------------------------------------------------
/// Aims the sub-rays of the pulses [first, last), and finds their hits: surfaces, or leaves before them.
void BeamTracer::Meet(const Pulse* pulses, std::size_t first, std::size_t last, RayBatch& batch)
{
  if (first == last)
  {
    return;
  }
  const std::size_t each = batch.SubRays->size();
  vtkHeliosRay* const rays = batch.Rays.data() + first * each;
  vtkHeliosHit* const hits = batch.Hits.data() + first * each;
  vtkHeliosRay* ray = rays;
  for (std::size_t i = first; i < last; ++i)
  {
    ray = Aim(pulses[i], *batch.SubRays, this->Model.HasOffsets, ray);
  }
  if (this->Model.Caster)
  {
    this->Model.Caster->IntersectBeams(
      rays, hits, static_cast<int>(each), static_cast<vtkIdType>(last - first));
  }
  else
  {
    const double endless = std::numeric_limits<double>::infinity();
    std::fill_n(hits, (last - first) * each, vtkHeliosHit{ endless, -1 });
  }
  for (std::size_t i = first; !this->Model.Medium.IsEmpty() && i < last; ++i)
  {
    this->Model.Medium.Intercept(this->Model.Seed, pulses[i].Id, batch.Rays.data() + i * each, each,
      batch.Hits.data() + i * each);
  }
}

//------------------------------------------------------------------------------
/// Selects a pulse's part of a ray batch, and computes the returns of its hits.
void BeamTracer::Select(const RayBatch& batch, std::size_t slot)
{
  const std::size_t count = batch.SubRays->size();
  this->SubRays = batch.SubRays;
  this->Rays = batch.Rays.data() + slot * count;
  this->Hits = batch.Hits.data() + slot * count;
  this->Response.GetReturns(this->Rays, this->Hits, count, this->Returned);
}

//------------------------------------------------------------------------------
void BeamTracer::Select(std::size_t slot)
{
  this->Select(this->First, slot);
}

//------------------------------------------------------------------------------
void BeamTracer::CastMore(
  const std::vector<SubRay>& subRays, const Pulse& pulse, ScanCounts& counts)
{
  this->Resize(this->More, subRays, 1);
  this->Meet(&pulse, 0, 1, this->More);
  counts.SubRays += static_cast<vtkIdType>(subRays.size());
  this->Select(this->More, 0);
}

//------------------------------------------------------------------------------
void BeamTracer::CastAll(const Pulse& pulse, ScanCounts& counts)
{
  this->CastMore(this->Model.SubRays, pulse, counts);
}

//------------------------------------------------------------------------------
/// Casts more sub-rays than usual in a wide footprint: its many leaves even out what it returns.
void BeamTracer::CastAmongLeaves(const Pulse& pulse, ScanCounts& counts)
{
  constexpr double share =
    0.01; // [m2], of a sub-ray, where the beam meets the first leaf or surface
  this->CastAll(pulse, counts);
  const std::size_t count = this->SubRays->size();
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < count; ++k)
  {
    nearest = std::min(nearest, this->Hits[k].Range);
  }
  const double radius = this->Model.ConeTangent * (nearest + this->Model.ApexOffset);
  const double wanted = vtkMath::Pi() * radius * radius / share;
  if (!(nearest < std::numeric_limits<double>::infinity()) || wanted <= 1.0 * count)
  {
    return;
  }
  int level = 0;
  for (double rays = this->Model.Plan.MinimumSubRays; rays < wanted; rays *= 4.0)
  {
    ++level;
  }
  const int last = static_cast<int>(this->Model.RayLevels.size()) - 1;
  this->CastLevel(pulse, std::min(level, last), counts);
}

//------------------------------------------------------------------------------
void BeamTracer::AimLight(const Pulse& pulse, std::vector<vtkHeliosRay>& rays) const
{
  rays.resize(this->Model.LightSubRays.size());
  Aim(pulse, this->Model.LightSubRays, this->Model.HasOffsets, rays.data());
}

//------------------------------------------------------------------------------
bool BeamTracer::CastLevel(const Pulse& pulse, int level, ScanCounts& counts)
{
  const auto& levels = this->Model.RayLevels;
  if (static_cast<std::size_t>(level) >= levels.size())
  {
    return false;
  }
  this->CastMore(levels[static_cast<std::size_t>(level)]->Get(), pulse, counts);
  return true;
}

//------------------------------------------------------------------------------
bool BeamTracer::CastOpticsLevel(const Pulse& pulse, int level, ScanCounts& counts)
{
  if (level > 0)
  {
    return this->CastLevel(pulse, level - 1, counts);
  }
  this->CastMore(this->Model.CoarseSubRays, pulse, counts);
  return true;
}

//------------------------------------------------------------------------------
void BeamTracer::Collect(const Pulse& pulse, std::vector<SubReturn>& returns,
  std::vector<CastSubRay>& cast, ScanCounts& counts)
{
  const std::size_t count = this->SubRays->size();
  const SubRay* subRays = this->SubRays->data();
  const double* powers = this->Returned.Powers.data();
  const double* cosines = this->Returned.Cosines.data();
  const RangeGate gate = this->Model.Gate;
  returns.resize(count);
  SubReturn* to = returns.data();
  for (std::size_t k = 0; k < count; ++k)
  {
    const vtkHeliosHit hit = this->Hits[k];
    if (gate.IsOutsideGate(hit))
    {
      counts.HitsOutOfRange += hit.CellId >= 0 ? 1 : 0;
      continue;
    }
    const double weight = subRays[k].Weight;
    if (weight > 0.0)
    {
      *to++ = { hit.Range, weight * powers[k], cosines[k], hit.CellId, static_cast<int>(k) };
    }
  }
  returns.resize(static_cast<std::size_t>(to - returns.data()));
  if (this->Model.Surfaces.HasOptics())
  {
    this->CollectPaths(pulse, returns);
  }
  if (!this->Model.Air.IsEmpty())
  {
    this->AppendAir(pulse, returns);
  }
  cast.clear();
  for (std::size_t k = 0; this->Model.Wants.SubRays && k < count; ++k)
  {
    cast.push_back({ Vec3(this->Rays[k].Direction), subRays[k].Weight });
  }
}

//------------------------------------------------------------------------------
/// Appends the returns of the air before the hits of the selected sub-rays.
void BeamTracer::AppendAir(const Pulse& pulse, std::vector<SubReturn>& returns)
{
  this->Hiding.clear();
  for (std::size_t k = 0; k < this->SubRays->size(); ++k)
  {
    if (this->Hits[k].CellId >= 0)
    {
      this->Hiding.push_back({ this->Hits[k].Range, (*this->SubRays)[k].Weight });
    }
  }
  this->AppendHiddenAir(pulse, returns);
}

//------------------------------------------------------------------------------
void BeamTracer::AddAtmosphericReturns(const Pulse& pulse, std::vector<SubReturn>& returns)
{
  this->Hiding.clear();
  this->AppendHiddenAir(pulse, returns);
}

//------------------------------------------------------------------------------
void BeamTracer::AppendHiddenAir(const Pulse& pulse, std::vector<SubReturn>& returns)
{
  const ScanModel& m = this->Model;
  m.Air.Append(this->Hiding, returns);
  if (!m.Drops.IsEmpty())
  {
    m.Drops.Append(m.Seed, pulse.Id, this->Hiding, returns);
  }
}

//------------------------------------------------------------------------------
/// Appends what sub-rays meet behind mirrors and glass; these return nothing themselves if clean.
void BeamTracer::CollectPaths(const Pulse& pulse, std::vector<SubReturn>& returns)
{
  const SceneSurfaces& surfaces = this->Model.Surfaces;
  returns.erase(
    std::remove_if(returns.begin(), returns.end(),
      [&](const SubReturn& r) { return r.Power == 0.0 && surfaces.GetOptics(r.CellId); }),
    returns.end());
  this->Paths.StartPulse(pulse.Origin, returns);
  for (std::size_t k = 0; k < this->SubRays->size(); ++k)
  {
    const double weight = (*this->SubRays)[k].Weight;
    if (weight > 0.0 && surfaces.GetOptics(this->Hits[k].CellId))
    {
      this->Paths.Add(this->Rays[k], this->Hits[k], weight, static_cast<int>(k));
    }
  }
  this->Paths.Follow();
}

//------------------------------------------------------------------------------
/// Returns the optics of a layer of one plane, if it is clean; else null.
const MaterialOptics* BeamTracer::GetFlatOptics(const ConeLayer& layer) const
{
  constexpr double tiny = 1e-9;
  const SceneSurfaces& surfaces = this->Model.Surfaces;
  const ConeLayer::Piece& first = layer.Pieces[0];
  const MaterialOptics* optics = layer.Size > 0 ? surfaces.GetOptics(first.Cell) : nullptr;
  if (!optics || optics->MeanSquareSlope > 0.0 ||
    surfaces.GetReflection(surfaces.GetMaterialId(first.Cell)).Reflectance > 0.0)
  {
    return nullptr;
  }
  const auto isSame = [&](const ConeLayer::Piece& piece)
  {
    return surfaces.GetOptics(piece.Cell) == optics &&
      std::equal(piece.Inverse, piece.Inverse + 3, first.Inverse,
        [&](double a, double b) { return std::abs(a - b) <= tiny * std::abs(first.Inverse[2]); });
  };
  return std::all_of(layer.Pieces, layer.Pieces + layer.Size, isSame) ? optics : nullptr;
}

//------------------------------------------------------------------------------
bool BeamTracer::PassLayer(
  const Pulse& pulse, const ConeLayer& layer, std::vector<SubReturn>& returns, ScanCounts& counts)
{
  returns.clear();
  const MaterialOptics* optics = this->GetFlatOptics(layer);
  if (!optics || this->Model.Wants.SubRays || !this->Model.Medium.IsEmpty() ||
    !this->Model.Air.IsEmpty() || this->Model.Optics.MaximumEvents < 1)
  {
    return false;
  }
  const Vec3 axis = pulse.GetDirection();
  const Vec3& plane = this->Response.GetPlaneNormal(layer.Pieces[0].Cell);
  const BeamOnPlane beam{ pulse.Origin, axis, pulse.GetMinorAxis(),
    1.0 / layer.Pieces[0].Inverse[2], plane.Dot(axis) > 0.0 ? -1.0 * plane : plane,
    this->Model.ConeTangent };
  this->Paths.StartPulse(pulse.Origin, returns);
  return PassFlatOptics(beam, *optics, 0.5 * this->Model.Equation.ReceiverDiameter, this->Passed) &&
    std::all_of(this->Passed.begin(), this->Passed.end(),
      [&](const PassedBeam& passed)
      { return this->CollectBeyond(passed, *optics, returns, counts); });
}

//------------------------------------------------------------------------------
/// Appends the returns of a beam behind a mirror or pane; false if they have to be sampled.
bool BeamTracer::CollectBeyond(const PassedBeam& beam, const MaterialOptics& optics,
  std::vector<SubReturn>& returns, ScanCounts& counts)
{
  const Vec3 normal(beam.Beyond.Normal);
  const auto getShare = [&](const Vec3& direction)
  {
    const double share = GetShare(optics, std::abs(normal.Dot(direction)), beam.IsReflected);
    return share * share;
  };
  if (getShare(beam.Axis) < this->Model.Optics.LeastShare)
  {
    return true;
  }
  if (!this->Surfaces.Collect(*this->Model.Cones, beam.Origin.GetData(), beam.Axis.GetData(),
        beam.Minor.GetData(), &beam.Beyond) ||
    !this->Surfaces.AreEdgesStraight() || this->HasOptics() ||
    this->GetNumberOfSurfaces() > this->Model.Plan.MaximumSurfaces ||
    !this->Surfaces.Divide(this->Parts))
  {
    return false;
  }
  counts.SubRays += static_cast<vtkIdType>(this->Parts.size());
  this->SelectParts(beam.Origin);
  for (std::size_t k = 0; k < this->Parts.size(); ++k)
  {
    const FootprintPart& part = this->Parts[k];
    const double range = part.Range + beam.Excess;
    const double power = getShare(Vec3(part.Direction)) * part.Energy * this->Returned.Powers[k];
    if (power > 0.0 && !this->Model.Gate.IsOutsideGate(part.Cell, range))
    {
      const Vec3 end = beam.Origin + part.Range * Vec3(part.Direction);
      returns.push_back(
        { range, power, this->Returned.Cosines[k], part.Cell, 0, this->Paths.AddEnd({ end, 1 }) });
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool BeamTracer::HasOptics() const
{
  const SceneSurfaces& surfaces = this->Model.Surfaces;
  return surfaces.HasOptics() &&
    this->Surfaces.AnyCell([&](vtkIdType cell) { return surfaces.GetOptics(cell) != nullptr; });
}

} // namespace helios
