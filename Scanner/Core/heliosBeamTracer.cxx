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
    const std::size_t side = static_cast<std::size_t>(model.Lattice->GetNumberOfCorners());
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
  for (int level = 0; !this->Cells.empty(); ++level)
  {
    this->Finer.clear();
    int corners[4];
    for (const Cell& cell : this->Cells)
    {
      this->GetCorners(cell, level, corners);
    }
    this->CastRays();
    for (const Cell& cell : this->Cells)
    {
      this->Visit(cell, level);
    }
    this->Cells.swap(this->Finer);
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
  for (const std::size_t slot : this->Used)
  {
    this->Slots[slot] = -1;
  }
  this->Used.clear();
  this->Rays.clear();
  this->Corners.clear();
  this->Cells.clear();
  const int n = this->Model.Lattice->GetBaseCells();
  for (int i = 0; i < n * n; ++i)
  {
    this->Cells.push_back({ i % n, i / n });
  }
}

//------------------------------------------------------------------------------
/// Lets a cell return what it gets, or leaves that to its four parts.
void BeamTracer::Visit(const Cell& cell, int level)
{
  int corners[4];
  this->GetCorners(cell, level, corners);
  const BeamCell& share = this->Model.Lattice->GetCell(level, cell.X, cell.Y);
  const double spread = this->GetSpread(corners);
  const bool isContinuous = this->IsContinuous(corners);
  const bool isLast = level == this->Model.Plan.Levels;
  if (isContinuous && (isLast || spread <= this->Model.Plan.CellSpread * this->SigmaRange))
  {
    this->ReturnFromCell(share, corners[0], spread);
  }
  else if (!isContinuous && (isLast || this->IsFineEnough(spread, level)))
  {
    this->ReturnFromCorners(corners, share.Energy);
  }
  else
  {
    const int x = 2 * cell.X;
    const int y = 2 * cell.Y;
    this->Finer.insert(
      this->Finer.end(), { { x, y }, { x + 1, y }, { x, y + 1 }, { x + 1, y + 1 } });
  }
}

//------------------------------------------------------------------------------
/// Where a sub-ray leaves: the rulings of the hyperboloid that the beam is.
Vec3 BeamTracer::GetOrigin(const Vec3& local) const
{
  const double setback = this->Model.Setback;
  return setback > 0.0
    ? this->Beam.Origin + this->Beam.Beam * (setback * Vec3(local[2], 0.0, -local[0]))
    : this->Beam.Origin;
}

//------------------------------------------------------------------------------
/// The corner at a place counted in cells of the finest level; a new one gets a ray.
int BeamTracer::GetCorner(int x, int y)
{
  const BeamLattice& lattice = *this->Model.Lattice;
  const std::size_t id = lattice.GetCornerId(x, y);
  int& slot = this->Slots[id];
  if (slot < 0)
  {
    slot = static_cast<int>(this->Rays.size());
    this->Used.push_back(id);
    const Vec3& local = lattice.GetCorner(id);
    const Vec3 direction = this->Beam.Beam * local;
    const Vec3 origin = this->GetOrigin(local);
    vtkHeliosRay ray;
    std::copy_n(origin.GetData(), 3, ray.Origin);
    std::copy_n(direction.GetData(), 3, ray.Direction);
    this->Rays.push_back(ray);
  }
  return slot;
}

//------------------------------------------------------------------------------
void BeamTracer::GetCorners(const Cell& cell, int level, int corners[4])
{
  const int shift = this->Model.Lattice->GetLevels() - level;
  const int x0 = cell.X << shift;
  const int y0 = cell.Y << shift;
  const int x1 = (cell.X + 1) << shift;
  const int y1 = (cell.Y + 1) << shift;
  corners[0] = this->GetCorner(x0, y0);
  corners[1] = this->GetCorner(x1, y0);
  corners[2] = this->GetCorner(x1, y1);
  corners[3] = this->GetCorner(x0, y1);
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
/// Between the nearest and the farthest hit of the corners [m].
double BeamTracer::GetSpread(const int corners[4]) const
{
  double nearest = VTK_DOUBLE_MAX;
  double farthest = -VTK_DOUBLE_MAX;
  for (int i = 0; i < 4; ++i)
  {
    const Corner& c = this->Corners[static_cast<std::size_t>(corners[i])];
    if (c.CellId >= 0)
    {
      nearest = std::min(nearest, c.Range);
      farthest = std::max(farthest, c.Range);
    }
  }
  return std::max(0.0, farthest - nearest);
}

//------------------------------------------------------------------------------
/// Whether a cell that holds an edge may return from its corners, which spread over a range [m].
bool BeamTracer::IsFineEnough(double spread, int level) const
{
  const SamplingPlan& plan = this->Model.Plan;
  return plan.BaseCells << level >= plan.GetNeededCells(spread);
}

//------------------------------------------------------------------------------
/// Whether the corners of a cell meet nothing, or one smooth surface.
bool BeamTracer::IsContinuous(const int corners[4])
{
  const Corner& first = this->Corners[static_cast<std::size_t>(corners[0])];
  for (int i = 1; i < 4; ++i)
  {
    const Corner& c = this->Corners[static_cast<std::size_t>(corners[i])];
    if ((c.CellId >= 0) != (first.CellId >= 0) || c.IsSilent != first.IsSilent)
    {
      return false;
    }
  }
  return first.CellId < 0 || first.IsSilent ||
    (this->AreAlike(corners[0], corners[1]) && this->AreAlike(corners[0], corners[2]) &&
      this->AreAlike(corners[0], corners[3]));
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
void BeamTracer::ReturnFromCell(const BeamCell& cell, int corner, double spread)
{
  const Corner& at = this->Corners[static_cast<std::size_t>(corner)];
  if (at.CellId < 0 || at.IsSilent)
  {
    return;
  }
  if (spread <= this->Model.Plan.PointSpread * this->SigmaRange)
  {
    this->ReturnFromPlane(corner, cell.Centre, cell.Energy);
    return;
  }
  for (const Vec3& point : cell.Points)
  {
    this->ReturnFromPlane(corner, point, 0.25 * cell.Energy);
  }
}

//------------------------------------------------------------------------------
/// A return from where a direction meets the plane of a corner's hit.
void BeamTracer::ReturnFromPlane(int corner, const Vec3& local, double weight)
{
  const Corner& at = this->Corners[static_cast<std::size_t>(corner)];
  const vtkHeliosRay& ray = this->Rays[static_cast<std::size_t>(corner)];
  const Vec3 direction = this->Beam.Beam * local;
  const Vec3& normal = this->Response.GetPlaneNormal(at.CellId);
  double toPlane = at.Range * normal.Dot(Vec3(ray.Direction));
  if (this->Model.Setback > 0.0)
  {
    toPlane += normal.Dot(Vec3(ray.Origin) - this->GetOrigin(local));
  }
  const double range = toPlane / normal.Dot(direction);
  // Nearly in its plane, a triangle says nothing of where the point is.
  const bool isClose = std::abs(range - at.Range) <= 2.0 * this->SigmaRange;
  Corner point{ isClose ? range : at.Range, at.CellId, 0.0, 0.0, weight, false, true };
  point.Power = this->Response.GetPower(at.CellId, point.Range, direction, point.CosIncidence);
  this->AddReturn(point, direction, weight);
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
