// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBeamTracer.h"


#include <algorithm>
#include <cmath>

namespace helios
{

BeamTracer::BeamTracer(const ScanModel& model, SurfaceResponse& response)
  : Model(model)
  , Response(response)
  , SigmaRange(0.5 * SpeedOfLight * model.Receiver.Shape.GetSigma())
{
  if (model.Lattice)
  {
    const std::size_t side = static_cast<std::size_t>(model.Lattice->GetSide());
    this->Slots.assign(side * side, -1);
  }
}

//------------------------------------------------------------------------------
void BeamTracer::Trace(const Pulse& pulse, std::vector<SubReturn>& returns,
  std::vector<CastSubRay>& subRays, ScanCounts& counts)
{
  this->Returns = &returns;
  this->SubRays = &subRays;
  this->Start(pulse);
  const SamplingPlan& plan = this->Model.Plan;
  int size = 2 << plan.Levels; // of a cell, in steps of the lattice
  double weight = 1.0 / (plan.BaseCells * plan.BaseCells);
  for (int y = 0; y < plan.BaseCells; ++y)
  {
    for (int x = 0; x < plan.BaseCells; ++x)
    {
      this->Cells.push_back({ size * x, size * y });
    }
  }
  for (int level = 0; !this->Cells.empty(); ++level)
  {
    this->CastRays();
    this->Finer.clear();
    for (const Cell& cell : this->Cells)
    {
      int corners[4];
      this->GetCorners(cell, size, corners);
      if (this->IsSmooth(corners))
      {
        this->ReturnFromCentre(cell, size, corners[0], weight);
      }
      else if (level == plan.Levels)
      {
        this->ReturnFromCorners(corners, weight);
      }
      else
      {
        const int half = size / 2;
        this->Finer.insert(this->Finer.end(),
          { cell, { cell.X + half, cell.Y }, { cell.X, cell.Y + half },
            { cell.X + half, cell.Y + half } });
      }
    }
    this->Cells.swap(this->Finer);
    size /= 2;
    weight *= 0.25;
    for (const Cell& cell : this->Cells)
    {
      int corners[4];
      this->GetCorners(cell, size, corners);
    }
  }
  this->ReturnFromWeights();
  counts.SubRays += static_cast<vtkIdType>(this->Corners.size());
  for (const Corner& corner : this->Corners)
  {
    counts.HitsOutOfRange += corner.IsSilent ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
void BeamTracer::Start(const Pulse& pulse)
{
  this->Beam = pulse;
  this->Returns->clear();
  this->SubRays->clear();
  for (const int slot : this->Used)
  {
    this->Slots[static_cast<std::size_t>(slot)] = -1;
  }
  this->Used.clear();
  this->Rays.clear();
  this->Corners.clear();
  this->Cells.clear();
  const int size = 2 << this->Model.Plan.Levels;
  for (int y = 0; y <= this->Model.Plan.BaseCells; ++y)
  {
    for (int x = 0; x <= this->Model.Plan.BaseCells; ++x)
    {
      this->GetCorner(size * x, size * y);
    }
  }
}

//------------------------------------------------------------------------------
/// The corner at a place of the lattice; a new one gets a ray.
int BeamTracer::GetCorner(int x, int y)
{
  const BeamLattice& lattice = *this->Model.Lattice;
  int& slot = this->Slots[static_cast<std::size_t>(y * lattice.GetSide() + x)];
  if (slot < 0)
  {
    slot = static_cast<int>(this->Rays.size());
    this->Used.push_back(y * lattice.GetSide() + x);
    const Vec3& local = lattice.GetDirection(x, y);
    const Vec3 direction = this->Beam.Beam * local;
    vtkHeliosRay ray;
    std::copy_n(this->Beam.Origin.GetData(), 3, ray.Origin);
    std::copy_n(direction.GetData(), 3, ray.Direction);
    if (this->Model.Setback > 0.0)
    {
      const Vec3 offset = this->Beam.Beam * (this->Model.Setback * Vec3(local[2], 0.0, -local[0]));
      for (int axis = 0; axis < 3; ++axis)
      {
        ray.Origin[axis] += offset[axis];
      }
    }
    this->Rays.push_back(ray);
  }
  return slot;
}

//------------------------------------------------------------------------------
void BeamTracer::GetCorners(const Cell& cell, int size, int corners[4])
{
  corners[0] = this->GetCorner(cell.X, cell.Y);
  corners[1] = this->GetCorner(cell.X + size, cell.Y);
  corners[2] = this->GetCorner(cell.X + size, cell.Y + size);
  corners[3] = this->GetCorner(cell.X, cell.Y + size);
}

//------------------------------------------------------------------------------
/// Traces the rays that are new.
void BeamTracer::CastRays()
{
  const std::size_t before = this->Corners.size();
  const int count = static_cast<int>(this->Rays.size() - before);
  if (count == 0)
  {
    return;
  }
  this->Hits.resize(static_cast<std::size_t>(count));
  this->Model.Caster->IntersectBeams(this->Rays.data() + before, this->Hits.data(), count, 1);
  for (const vtkHeliosHit& hit : this->Hits)
  {
    const bool isSilent =
      hit.CellId >= 0 && (hit.Range < this->Model.RangeMin || hit.Range > this->Model.RangeMax);
    this->Corners.push_back({ hit.Range, hit.CellId, 0.0, 0.0, 0.0, isSilent, false });
  }
}

//------------------------------------------------------------------------------
double BeamTracer::GetPower(int corner)
{
  Corner& c = this->Corners[static_cast<std::size_t>(corner)];
  if (!c.HasPower)
  {
    const Vec3 direction(this->Rays[static_cast<std::size_t>(corner)].Direction);
    c.Power = this->Response.GetPower(c.CellId, c.Range, direction, c.CosIncidence);
    c.HasPower = true;
  }
  return c.Power;
}

//------------------------------------------------------------------------------
/// Whether a cell may return from its centre: its corners meet nothing, or one smooth surface.
bool BeamTracer::IsSmooth(const int corners[4])
{
  const Corner& first = this->Corners[static_cast<std::size_t>(corners[0])];
  double nearest = first.Range;
  double farthest = first.Range;
  for (int i = 1; i < 4; ++i)
  {
    const Corner& c = this->Corners[static_cast<std::size_t>(corners[i])];
    if ((c.CellId >= 0) != (first.CellId >= 0) || c.IsSilent != first.IsSilent)
    {
      return false;
    }
    nearest = std::min(nearest, c.Range);
    farthest = std::max(farthest, c.Range);
  }
  if (first.CellId < 0 || first.IsSilent)
  {
    return true;
  }
  return farthest - nearest <= this->SigmaRange && this->AreAlike(corners[0], corners[1]) &&
    this->AreAlike(corners[0], corners[2]) && this->AreAlike(corners[0], corners[3]);
}

//------------------------------------------------------------------------------
/// Whether b lies on the plane of a and returns as much.
bool BeamTracer::AreAlike(int a, int b)
{
  const Corner& ca = this->Corners[static_cast<std::size_t>(a)];
  const Corner& cb = this->Corners[static_cast<std::size_t>(b)];
  if (ca.CellId == cb.CellId)
  {
    return true;
  }
  const vtkHeliosRay& rayA = this->Rays[static_cast<std::size_t>(a)];
  const vtkHeliosRay& rayB = this->Rays[static_cast<std::size_t>(b)];
  const Vec3& normal = this->Response.GetPlaneNormal(ca.CellId);
  const Vec3 shift = Vec3(rayA.Origin) - Vec3(rayB.Origin);
  const double toPlane = normal.Dot(shift) + ca.Range * normal.Dot(Vec3(rayA.Direction));
  const double residual = toPlane / normal.Dot(Vec3(rayB.Direction)) - cb.Range;
  if (!(std::abs(residual) <= this->Model.Plan.PlaneTolerance))
  {
    return false;
  }
  const double powerA = this->GetPower(a);
  const double powerB = this->GetPower(b);
  return std::abs(powerA - powerB) <= this->Model.Plan.PowerTolerance * std::max(powerA, powerB);
}

//------------------------------------------------------------------------------
void BeamTracer::ReturnFromCentre(const Cell& cell, int size, int corner, double weight)
{
  const Corner& at = this->Corners[static_cast<std::size_t>(corner)];
  if (at.CellId < 0 || at.IsSilent)
  {
    return;
  }
  const Vec3& local = this->Model.Lattice->GetDirection(cell.X + size / 2, cell.Y + size / 2);
  const Vec3 direction = this->Beam.Beam * local;
  const vtkHeliosRay& ray = this->Rays[static_cast<std::size_t>(corner)];
  const Vec3& normal = this->Response.GetPlaneNormal(at.CellId);
  double toPlane = at.Range * normal.Dot(Vec3(ray.Direction));
  if (this->Model.Setback > 0.0)
  {
    const Vec3 offset = this->Beam.Beam * (this->Model.Setback * Vec3(local[2], 0.0, -local[0]));
    toPlane += normal.Dot(Vec3(ray.Origin) - this->Beam.Origin - offset);
  }
  const double range = toPlane / normal.Dot(direction);
  // Nearly in its plane, a triangle says nothing of where the centre is.
  const bool isClose = std::abs(range - at.Range) <= this->SigmaRange;
  Corner centre{ isClose ? range : at.Range, at.CellId, 0.0, 0.0, weight, false, true };
  centre.Power = this->Response.GetPower(at.CellId, centre.Range, direction, centre.CosIncidence);
  this->AddReturn(centre, direction, weight);
}

//------------------------------------------------------------------------------
void BeamTracer::ReturnFromCorners(const int corners[4], double weight)
{
  for (int i = 0; i < 4; ++i)
  {
    this->Corners[static_cast<std::size_t>(corners[i])].Weight += 0.25 * weight;
  }
}

//------------------------------------------------------------------------------
void BeamTracer::ReturnFromWeights()
{
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    const Corner& corner = this->Corners[i];
    if (corner.Weight > 0.0 && corner.CellId >= 0 && !corner.IsSilent)
    {
      this->GetPower(static_cast<int>(i));
      this->AddReturn(corner, Vec3(this->Rays[i].Direction), corner.Weight);
    }
  }
}

//------------------------------------------------------------------------------
void BeamTracer::AddReturn(const Corner& from, const Vec3& direction, double weight)
{
  const int index = static_cast<int>(this->Returns->size());
  this->Returns->push_back(
    { from.Range, weight * from.Power, from.CellId, index, from.CosIncidence });
  if (this->Model.WantsSubRays)
  {
    this->SubRays->push_back({ direction, weight });
  }
}

} // namespace helios
