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
  this->Beam = pulse;
  this->Returns->clear();
  this->SubRays->clear();
  this->Clear();
  const bool isDone = this->TraceProbes();
  counts.SubRays += static_cast<vtkIdType>(this->Corners.size());
  if (!isDone)
  {
    this->Clear();
    this->TraceCells();
    this->ReturnFromWeights();
    counts.SubRays += static_cast<vtkIdType>(this->Corners.size());
  }
  for (const Corner& corner : this->Corners)
  {
    counts.HitsOutOfRange += corner.IsSilent ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
void BeamTracer::Clear()
{
  for (const std::size_t slot : this->Used)
  {
    this->Slots[slot] = -1;
  }
  this->Used.clear();
  this->Rays.clear();
  this->Corners.clear();
  this->Cells.clear();
}

//------------------------------------------------------------------------------
/// Takes the returns of the probes; false where they meet an edge or a surface too much aslant.
bool BeamTracer::TraceProbes()
{
  const std::vector<SubRay>& probes = this->Model.Probes;
  for (const SubRay& probe : probes)
  {
    this->AddRay(
      this->Beam.Beam * probe.Direction, this->Beam.Origin + this->Beam.Beam * probe.Offset);
  }
  this->CastRays();
  const double share = 1.0 / static_cast<double>(probes.size());
  for (const auto& [a, b] : this->Model.ProbePairs)
  {
    if (this->Compare(a, b, share) == Edge)
    {
      return false;
    }
  }
  const auto isNearer = [](const Corner& a, const Corner& b) { return a.Range < b.Range; };
  const auto limits = std::minmax_element(this->Corners.begin(), this->Corners.end(), isNearer);
  if (limits.second->CellId >= 0 &&
    limits.second->Range - limits.first->Range > this->Model.Plan.CellSpread * this->SigmaRange)
  {
    return false;
  }
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    this->Corners[i].Weight = probes[i].Weight;
  }
  this->ReturnFromWeights();
  return true;
}

//------------------------------------------------------------------------------
void BeamTracer::TraceCells()
{
  this->StartCells();
  for (int level = 0; !this->Cells.empty(); ++level)
  {
    this->Finer.clear();
    this->CastRays();
    for (Cell& cell : this->Cells)
    {
      const double energy = this->Model.Lattice->GetCell(level, cell.X, cell.Y).Energy;
      cell.Kind = this->GetKind(cell.Corners, energy);
      this->Visit(cell, level);
    }
    this->Cells.swap(this->Finer);
  }
}

//------------------------------------------------------------------------------
void BeamTracer::StartCells()
{
  const int n = this->Model.Plan.BaseCells;
  const int size = 1 << this->Model.Plan.Levels;
  for (int i = 0; i < (n + 1) * (n + 1); ++i)
  {
    this->GetCorner(size * (i % (n + 1)), size * (i / (n + 1)));
  }
  for (int y = 0; y < n; ++y)
  {
    for (int x = 0; x < n; ++x)
    {
      const int corner = y * (n + 1) + x;
      this->Cells.push_back(
        { x, y, { corner, corner + 1, corner + n + 2, corner + n + 1 }, Smooth });
    }
  }
}

//------------------------------------------------------------------------------
/// Lets a cell return what it gets, or leaves that to its four parts.
void BeamTracer::Visit(const Cell& cell, int level)
{
  const BeamCell& share = this->Model.Lattice->GetCell(level, cell.X, cell.Y);
  const double spread = this->GetSpread(cell.Corners);
  const bool isLast = level == this->Model.Plan.Levels;
  const bool isSteep = spread > this->Model.Plan.CellSpread * this->SigmaRange;
  if (cell.Kind == Smooth && (isLast || !isSteep))
  {
    this->ReturnFromCell(share, cell.Corners[0], spread);
  }
  else if ((cell.Kind == Bent && !isSteep) ||
    (cell.Kind != Smooth && (isLast || this->IsFineEnough(spread, level))))
  {
    this->ReturnFromCorners(cell.Corners, share.Energy);
  }
  else
  {
    this->Split(cell, level);
  }
}

//------------------------------------------------------------------------------
void BeamTracer::Split(const Cell& cell, int level)
{
  const int half = 1 << (this->Model.Plan.Levels - level - 1);
  const int left = 2 * half * cell.X;
  const int low = 2 * half * cell.Y;
  const int bottom = this->GetCorner(left + half, low);
  const int right = this->GetCorner(left + 2 * half, low + half);
  const int top = this->GetCorner(left + half, low + 2 * half);
  const int side = this->GetCorner(left, low + half);
  const int middle = this->GetCorner(left + half, low + half);
  const int* c = cell.Corners;
  const int x = 2 * cell.X;
  const int y = 2 * cell.Y;
  this->Finer.push_back({ x, y, { c[0], bottom, middle, side }, Smooth });
  this->Finer.push_back({ x + 1, y, { bottom, c[1], right, middle }, Smooth });
  this->Finer.push_back({ x, y + 1, { side, middle, top, c[3] }, Smooth });
  this->Finer.push_back({ x + 1, y + 1, { middle, right, c[2], top }, Smooth });
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
void BeamTracer::AddRay(const Vec3& direction, const Vec3& origin)
{
  vtkHeliosRay ray;
  std::copy_n(origin.GetData(), 3, ray.Origin);
  std::copy_n(direction.GetData(), 3, ray.Direction);
  this->Rays.push_back(ray);
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
    this->AddRay(this->Beam.Beam * local, this->GetOrigin(local));
  }
  return slot;
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
    const double* direction = this->Rays[static_cast<std::size_t>(corner)].Direction;
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
/// What the corners of a cell with a share of the energy meet.
BeamTracer::Kinds BeamTracer::GetKind(const int corners[4], double energy)
{
  Kinds kind = Smooth;
  for (int i = 1; i < 4 && kind != Edge; ++i)
  {
    kind = std::max(kind, this->Compare(corners[0], corners[i], energy));
  }
  return kind;
}

//------------------------------------------------------------------------------
BeamTracer::Kinds BeamTracer::Compare(int a, int b, double energy)
{
  const Corner& ca = this->Corners[static_cast<std::size_t>(a)];
  const Corner& cb = this->Corners[static_cast<std::size_t>(b)];
  if ((ca.CellId >= 0) != (cb.CellId >= 0) || ca.IsSilent != cb.IsSilent)
  {
    return Edge;
  }
  return ca.CellId == cb.CellId || ca.IsSilent ? Smooth : this->CompareSurfaces(a, b, energy);
}

//------------------------------------------------------------------------------
/// Whether b lies on the plane of a, and returns as much.
BeamTracer::Kinds BeamTracer::CompareSurfaces(int a, int b, double energy)
{
  const Corner& ca = this->Corners[static_cast<std::size_t>(a)];
  const Corner& cb = this->Corners[static_cast<std::size_t>(b)];
  const vtkHeliosRay& rayA = this->Rays[static_cast<std::size_t>(a)];
  const vtkHeliosRay& rayB = this->Rays[static_cast<std::size_t>(b)];
  const Vec3& normal = this->Response.GetPlaneNormal(ca.CellId);
  double toPlane = ca.Range * normal.Dot(Vec3(rayA.Direction));
  if (this->Model.Setback > 0.0)
  {
    toPlane += normal.Dot(Vec3(rayA.Origin) - Vec3(rayB.Origin));
  }
  const double residual = std::abs(toPlane / normal.Dot(Vec3(rayB.Direction)) - cb.Range);
  const SamplingPlan& plan = this->Model.Plan;
  if (!(residual <= plan.GetEdgeTolerance()))
  {
    return Edge;
  }
  const double powerA = this->GetPower(a);
  const double powerB = this->GetPower(b);
  const double change = std::abs(powerA - powerB) / std::max(powerA, powerB);
  const bool isSmooth =
    residual <= plan.GetPlaneTolerance(energy) && change <= plan.GetPowerTolerance(energy);
  return isSmooth ? Smooth : change <= 0.5 ? Bent : Edge;
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
  point.Power =
    this->Response.GetPower(at.CellId, point.Range, direction.GetData(), point.CosIncidence);
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
    { from.Range, weight * from.Power, from.CosIncidence, from.CellId, index });
  if (this->Model.WantsSubRays)
  {
    this->SubRays->push_back({ direction, weight });
  }
}

} // namespace helios
