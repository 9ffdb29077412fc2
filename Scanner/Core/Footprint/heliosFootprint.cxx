// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFootprint.h"

#include "heliosSpacePolygon.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace helios
{
namespace
{

constexpr double MinimumEnergy = 1e-12; // energy of a part
// deviation of the ranges of a part that is two, in the depth
constexpr double MinimumDeviation = 0.02;
// rest of a backdrop by its complement, which errs by the parts before it
constexpr double MinimumRest = 1e-4;
constexpr double RestPerError = 30.0;
constexpr double Flatness = 1e-3; // flatness of a facet, in the depth
constexpr double MaximumStrips = 4096.0;

/// Returns whether a triangle is met in the direction of a point.
bool IsInside(const double p[3], const ConeTriangle& triangle)
{
  bool isLeft[3];
  for (int i = 0; i < 3; ++i)
  {
    const double* a = triangle.Corners[i];
    const double* b = triangle.Corners[(i + 1) % 3];
    isLeft[i] = p[0] * (a[1] * b[2] - a[2] * b[1]) + p[1] * (a[2] * b[0] - a[0] * b[2]) +
        p[2] * (a[0] * b[1] - a[1] * b[0]) >
      0.0;
  }
  return isLeft[0] == isLeft[1] && isLeft[1] == isLeft[2];
}

/// Returns the part of a face before a depth.
HalfPlane GetNearerSide(const FacePlane& face, double depth)
{
  return { face.Inverse.X, face.Inverse.Y, face.Inverse.One - 1.0 / depth };
}

} // namespace

//------------------------------------------------------------------------------
Footprint::Footprint(const FootprintSettings& settings, FacetMaker::AreAlike areAlike)
  : Settings(settings)
  , Beam(settings.HalfAngle, settings.Truncation, settings.EnergyError)
  , Ellipse(settings.Ratio)
  , Projection{ this->Beam.GetTangent(), settings.ApexOffset }
  , Maker(std::move(areAlike), Flatness * settings.Depth)
{
}

//------------------------------------------------------------------------------
bool Footprint::Collect(const ConeProbe& probe, const double origin[3], const double axis[3],
  const double minor[3], const BeyondPlane* beyond)
{
  const double apexOffset = this->Settings.ApexOffset;
  const double apex[3] = { origin[0] - apexOffset * axis[0], origin[1] - apexOffset * axis[1],
    origin[2] - apexOffset * axis[2] };
  const double nearest = apexOffset + (beyond ? beyond->Nearest : 0.0);
  if (!probe.Collect(apex, axis, this->Beam.GetTangent(), nearest, MaximumTriangles, this->View))
  {
    return false;
  }
  if (!this->Ellipse.IsCircle())
  {
    this->Ellipse.Align(this->View.Frame, minor);
  }
  this->Crowded = Crowd();
  if (!beyond && this->CollectCrowd())
  {
    return true;
  }
  this->Maker.Make(this->View, this->Facets);
  if (beyond && !this->ClipFacets(*beyond, apex))
  {
    return false;
  }
  if (!this->Ellipse.IsCircle())
  {
    this->StretchFacets();
  }
  this->Surfaces.Project(this->Facets, this->Projection);
  this->SetTiles();
  return true;
}

//------------------------------------------------------------------------------
bool Footprint::MeetsGate() const
{
  return std::any_of(std::begin(this->Settings.Gate), std::end(this->Settings.Gate),
    [this](double limit)
    {
      bool isBeyond = false;
      bool isBefore = false;
      for (std::size_t i = 0; i < this->Surfaces.GetNumberOfFaces(); ++i)
      {
        const VisibleSurfaces::Face& face = this->Surfaces.GetFace(i);
        isBeyond = isBeyond || limit * face.Minimum < 1.0;
        isBefore = isBefore || limit * face.Maximum > 1.0;
      }
      return isBeyond && isBefore;
    });
}

//------------------------------------------------------------------------------
/// Keeps the parts of facets beyond a plane; false if one has too many corners.
bool Footprint::ClipFacets(const BeyondPlane& beyond, const double apex[3])
{
  constexpr double margin = 1e-6; // [m]: what lies in the plane is not beyond it
  double n[3];
  vtkMath::Multiply3x3(this->View.Frame, beyond.Normal, n);
  const double limit = beyond.Constant - vtkMath::Dot(beyond.Normal, apex) + margin;
  std::size_t kept = 0;
  for (Facet& facet : this->Facets)
  {
    SpacePolygon whole;
    whole.Size = facet.Size;
    std::copy_n(&facet.Corners[0][0], 3 * facet.Size, &whole.Corners[0][0]);
    const SpacePolygon part = Clip(whole, n[0], n[1], n[2], limit);
    if (part.Size > Facet::Capacity)
    {
      return false;
    }
    if (part.Size >= 3)
    {
      facet.Size = part.Size;
      std::copy_n(&part.Corners[0][0], 3 * part.Size, &facet.Corners[0][0]);
      this->Facets[kept++] = facet;
    }
  }
  this->Facets.resize(kept);
  return true;
}

//------------------------------------------------------------------------------
/// Moves the facets to where the beam is circular.
void Footprint::StretchFacets()
{
  for (Facet& facet : this->Facets)
  {
    for (int corner = 0; corner < facet.Size; ++corner)
    {
      this->Ellipse.ToCircle(facet.Corners[corner]);
    }
  }
}

//------------------------------------------------------------------------------
bool Footprint::Divide(std::vector<FootprintPart>& parts)
{
  parts.clear();
  const std::size_t count = this->GetNumberOfFaces();
  this->Shares.assign(count, Share());
  this->AllVisible.clear();
  this->Backdrops.clear();
  const bool isOneLayer = this->Surfaces.AreOneLayer();
  if (!isOneLayer)
  {
    this->Surfaces.Sort();
  }
  bool isGood = true;
  for (std::size_t i = 0; i < count && isGood; ++i)
  {
    if (isOneLayer)
    {
      this->AddVisible(i, &this->Surfaces.GetFace(i).Outline, 1, parts);
      continue;
    }
    this->Surfaces.FindHiding(i);
    if (this->IsFlat() && this->Surfaces.IsBackdrop())
    {
      this->Backdrops.push_back(i);
      continue;
    }
    isGood = this->AddSurface(i, parts);
  }
  for (std::size_t i = 0; i < this->Backdrops.size() && isGood; ++i)
  {
    this->Surfaces.FindHiding(this->Backdrops[i]);
    isGood = this->AddBackdrop(this->Backdrops[i], parts);
  }
  return isGood;
}

//------------------------------------------------------------------------------
/// Returns the limits of depth in a beam, and of the corners themselves, whatever the rounding.
Footprint::Interval Footprint::GetSpread(const FacePlane& face) const
{
  const double across = std::hypot(face.Inverse.X, face.Inverse.Y);
  return { 1.0 / std::min(face.Maximum, face.Inverse.One + across),
    1.0 / std::max(face.Minimum, face.Inverse.One - across) };
}

//------------------------------------------------------------------------------
/// Returns the depths of the visible parts of a face.
Footprint::Interval Footprint::GetSpread(const FacePlane& face, const Share& share) const
{
  Interval spread = this->GetSpread(face);
  if (!(spread.Far > spread.Near + std::min(this->Settings.Depth, LargestRatio * spread.Near)))
  {
    return spread;
  }
  double minimum = HUGE_VAL;
  double maximum = 0.0;
  for (std::size_t i = share.First; i < share.Last; ++i)
  {
    const Polygon& p = this->AllVisible[i].Outline;
    for (int corner = 0; corner < p.Size; ++corner)
    {
      const double inverse = face.Inverse(p.X[corner], p.Y[corner]);
      minimum = std::min(minimum, inverse);
      maximum = std::max(maximum, inverse);
    }
  }
  return { std::max(spread.Near, 1.0 / maximum), std::min(spread.Far, 1.0 / minimum) };
}

//------------------------------------------------------------------------------
/// Adds the visible parts of a face.
bool Footprint::AddSurface(std::size_t index, std::vector<FootprintPart>& parts)
{
  const std::vector<Polygon>* visible = this->Surfaces.FindVisible();
  if (!visible)
  {
    return false;
  }
  this->AddVisible(index, visible->data(), visible->size(), parts);
  return true;
}

//------------------------------------------------------------------------------
/// Adds polygons of a face.
void Footprint::AddVisible(
  std::size_t index, const Polygon* visible, std::size_t count, std::vector<FootprintPart>& parts)
{
  const VisibleSurfaces::Face& face = this->Surfaces.GetFace(index);
  Share& share = this->Shares[index];
  share.First = this->AllVisible.size();
  EnergyMoments all;
  for (const Polygon* polygon = visible; polygon != visible + count; ++polygon)
  {
    const Polygon& p = *polygon;
    const PolygonBounds bounds(p);
    const EnergyMoments moments =
      bounds.MayTouchUnitCircle() ? this->Beam.Integrate(p) : EnergyMoments();
    if (moments.Energy > MinimumEnergy)
    {
      this->AllVisible.push_back({ p, bounds, PolygonCircle(bounds), moments });
      all.Add(moments);
    }
  }
  share.Last = this->AllVisible.size();
  if (share.First == share.Last)
  {
    return;
  }
  this->SetCuts(face, this->GetSpread(face, share));
  if (!this->IsFlat())
  {
    this->AddTiledStrips(face, share, parts);
    return;
  }
  // The parts of a strip are one, however the visible area is divided into polygons.
  std::vector<EnergyMoments>& strips = this->StripMoments;
  strips.assign(this->Cuts.size() + 1, EnergyMoments());
  if (this->Cuts.empty())
  {
    strips.front() = all;
  }
  for (std::size_t i = share.First; i < share.Last && !this->Cuts.empty(); ++i)
  {
    this->ForEachStrip(face, this->AllVisible[i].Outline,
      [&](std::size_t strip, const Polygon& p) { strips[strip].Add(this->Beam.Integrate(p)); });
  }
  for (const EnergyMoments& moments : strips)
  {
    this->AddPart(face, moments, parts);
  }
}

//------------------------------------------------------------------------------
/// Returns the energy in a polygon of a backdrop that the parts before it take.
EnergyMoments Footprint::GetHidden(const Polygon& polygon) const
{
  const PolygonBounds bounds(polygon);
  const PolygonSides sides(polygon);
  EnergyMoments sum;
  Polygon common;
  for (const std::size_t by : this->Surfaces.GetHiding())
  {
    const bool isNearer = this->Surfaces.IsNearer(by);
    for (std::size_t i = this->Shares[by].First; i < this->Shares[by].Last; ++i)
    {
      const Visible& part = this->AllVisible[i];
      if (!bounds.Overlaps(part.Bounds))
      {
        continue;
      }
      const Polygon nearer = isNearer ? Polygon() : this->Surfaces.GetNearer(part.Outline, by);
      const bool isCut = Cut(isNearer ? part.Outline : nearer, part.Circle, sides, common);
      sum.Add(isCut  ? this->Beam.Integrate(common)
          : isNearer ? part.Moments
                     : this->Beam.Integrate(nearer));
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
/// Adds a face by what the parts before it leave of its energy; if that is little, by its parts.
bool Footprint::AddBackdrop(std::size_t index, std::vector<FootprintPart>& parts)
{
  const VisibleSurfaces::Face& face = this->Surfaces.GetFace(index);
  const std::size_t before = parts.size();
  this->SetCuts(face, this->GetSpread(face));
  bool isGood = true;
  this->ForEachStrip(face, face.Outline,
    [&](std::size_t, const Polygon& strip)
    {
      EnergyMoments moments = this->Beam.Integrate(strip);
      if (moments.Energy > MinimumEnergy)
      {
        moments.Subtract(this->GetHidden(strip));
        isGood = isGood &&
          moments.Energy >= std::max(MinimumRest, RestPerError * this->Settings.EnergyError);
        this->AddPart(face, moments, parts);
      }
    });
  if (!isGood)
  {
    parts.resize(before);
    return this->AddSurface(index, parts);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Cuts the depths of a part of a face at steps that begin at its nearest point in the beam, whatever
/// the part, and at the range gate.
void Footprint::SetCuts(const FacePlane& face, const Interval& part)
{
  this->Cuts.clear();
  const double near = this->GetSpread(face).Near;
  const double depth = std::max(
    std::min(this->Settings.Depth, LargestRatio * near), (part.Far - part.Near) / MaximumStrips);
  const double first = std::max(0.0, std::floor((part.Near - near) / depth)) + 1.0;
  // Far beyond the nearest point, steps may be too small to count: there are at most so many.
  for (int i = 0; i <= MaximumStrips && near + (first + i) * depth < part.Far; ++i)
  {
    this->Cuts.push_back(near + (first + i) * depth);
  }
  for (const double limit : this->Settings.Gate)
  {
    if (limit > part.Near && limit < part.Far)
    {
      this->Cuts.insert(std::upper_bound(this->Cuts.begin(), this->Cuts.end(), limit), limit);
    }
  }
}

//------------------------------------------------------------------------------
/// Calls use(strip, polygon) for the strips of a polygon of a face.
template <typename UseT>
void Footprint::ForEachStrip(const FacePlane& face, const Polygon& polygon, UseT use)
{
  Polygon rest = polygon;
  for (std::size_t i = 0; i < this->Cuts.size() && !rest.IsEmpty(); ++i)
  {
    const HalfPlane nearer = GetNearerSide(face, this->Cuts[i]);
    use(i, Clip(rest, nearer));
    rest = Clip(rest, nearer.GetOpposite());
  }
  use(this->Cuts.size(), rest);
}

//------------------------------------------------------------------------------
/// Adds the visible polygons of a face of a wide beam, in strips and tiles.
void Footprint::AddTiledStrips(
  const FacePlane& face, const Share& share, std::vector<FootprintPart>& parts)
{
  for (std::size_t i = share.First; i < share.Last; ++i)
  {
    this->ForEachStrip(face, this->AllVisible[i].Outline,
      [&](std::size_t, const Polygon& strip) { this->AddTiles(face, strip, parts); });
  }
}

//------------------------------------------------------------------------------
/// Returns the mean and the standard deviation of the depths of a part, to second order in its
/// inverse depth.
Footprint::Spread Footprint::GetDepths(const FacePlane& face, const EnergyMoments& moments) const
{
  const double x = moments.X / moments.Energy;
  const double y = moments.Y / moments.Energy;
  const InverseDepth& g = face.Inverse;
  const double depth = 1.0 / std::clamp(g(x, y), face.Minimum, face.Maximum);
  const double along = g.X * x + g.Y * y;
  const double square =
    (g.X * g.X * moments.XX + 2.0 * g.X * g.Y * moments.XY + g.Y * g.Y * moments.YY) /
    moments.Energy;
  const double deviation = depth * depth * std::sqrt(std::max(0.0, square - along * along));
  const double cut = std::min(deviation, this->Settings.Depth);
  return { depth + cut * cut / depth, cut };
}

//------------------------------------------------------------------------------
/// Returns the triangle of a facet at a point from the waist.
vtkIdType Footprint::FindCell(const FacePlane& face, const double point[3]) const
{
  const double p[3] = { point[0], point[1], point[2] + this->Projection.ApexOffset };
  if (face.Facet == FacePlane::None)
  {
    const bool isSecond =
      face.Pair != FacePlane::None && !IsInside(p, this->View.Triangles[face.Pair]);
    return isSecond ? this->View.Triangles[face.Pair + 1].Cell : face.Cell;
  }
  const Facet& facet = this->Facets[face.Facet];
  for (std::size_t i = facet.First; i + 1 < facet.Last; ++i)
  {
    const ConeTriangle& triangle = this->View.Triangles[i];
    if (IsInside(p, triangle))
    {
      return triangle.Cell;
    }
  }
  return this->View.Triangles[facet.Last - 1].Cell;
}

//------------------------------------------------------------------------------
void Footprint::AddPart(
  const FacePlane& face, const EnergyMoments& moments, std::vector<FootprintPart>& parts)
{
  if (!(moments.Energy > MinimumEnergy))
  {
    return;
  }
  const double x = moments.X / moments.Energy;
  const double y = moments.Y / moments.Energy;
  const Spread depth = this->GetDepths(face, moments);
  FootprintPart part;
  part.Energy = moments.Energy;
  const double radius = this->Projection.GetRadius(depth.Mean);
  double centre[3] = { x * radius, y * radius, depth.Mean };
  if (!this->Ellipse.IsCircle())
  {
    this->Ellipse.FromCircle(centre);
  }
  const double length =
    std::sqrt(centre[0] * centre[0] + centre[1] * centre[1] + centre[2] * centre[2]);
  for (int axis = 0; axis < 3; ++axis)
  {
    part.Direction[axis] =
      (this->View.Frame[0][axis] * centre[0] + this->View.Frame[1][axis] * centre[1] +
        this->View.Frame[2][axis] * centre[2]) /
      length;
  }
  part.Cell = this->FindCell(face, centre);
  // A range is along an asymptote of the beam; on average over the part.
  const double tangent = this->Projection.Tangent;
  const double square = this->Ellipse.GetSquare(moments) / moments.Energy;
  const double stretch = std::sqrt(1.0 + tangent * tangent * square);
  if (depth.Deviation < MinimumDeviation * this->Settings.Depth)
  {
    part.Range = depth.Mean * stretch;
    parts.push_back(part);
    return;
  }
  part.Energy *= 0.5;
  for (const double side : { -1.0, 1.0 })
  {
    part.Range = (depth.Mean + side * depth.Deviation) * stretch;
    parts.push_back(part);
  }
}

} // namespace helios
