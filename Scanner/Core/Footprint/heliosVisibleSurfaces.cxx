// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVisibleSurfaces.h"

#include "heliosBeamTree.h"
#include "heliosSpacePolygon.h"
#include "heliosVectorLoops.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace helios
{
namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double MinimumArea = 1e-12;      // area of a part, in the cross-section
constexpr std::size_t ManyHiding = 3;      // faces, from which complements are faster than parts
constexpr std::size_t MaximumParts = 4096; // parts of a face
constexpr std::size_t MaximumOfLayer = 64; // facets

/// Returns whether a corner of a polygon is in a half plane.
bool Reaches(const Polygon& p, const HalfPlane& side)
{
  bool reaches = false;
  for (int i = 0; i < p.Size; ++i)
  {
    reaches = reaches || side(p.X[i], p.Y[i]) > 0.0;
  }
  return reaches;
}

/// Returns the half plane where a plane is nearer than another.
HalfPlane GetNearerSide(const InverseDepth& a, const InverseDepth& b)
{
  return { a.X - b.X, a.Y - b.Y, a.One - b.One };
}

/// A number for a point, the same for the same coordinates.
vtkTypeUInt64 Mix(vtkTypeUInt64 x)
{
  x = (x ^ (x >> 32)) * 0xd6e8feb86659fd93u;
  return (x ^ (x >> 32)) * 0xd6e8feb86659fd93u;
}
vtkTypeUInt64 GetKey(vtkTypeUInt64 from, vtkTypeUInt64 to)
{
  return Mix(from + 0x9e3779b97f4a7c15u * Mix(to));
}
vtkTypeUInt64 GetKey(const double corner[3])
{
  vtkTypeUInt64 bits[3];
  std::memcpy(bits, corner, sizeof bits);
  return GetKey(GetKey(bits[0], bits[1]), bits[2]);
}

/// Returns whether a segment reaches into the unit circle, or nearly so.
bool IsInBeam(const double a[2], const double b[2])
{
  constexpr double rim = 1.0 + 1e-6;
  const double d[2] = { b[0] - a[0], b[1] - a[1] };
  const double square = d[0] * d[0] + d[1] * d[1];
  const double along = -(a[0] * d[0] + a[1] * d[1]);
  const double s = along <= 0.0 ? 0.0 : (along >= square ? 1.0 : along / square);
  const double x = a[0] + s * d[0];
  const double y = a[1] + s * d[1];
  return x * x + y * y <= rim;
}

/// Computes the normal of the plane of a facet; its length is twice the area.
void GetNormal(const Facet& facet, double n[3])
{
  const auto& p = facet.Corners;
  std::fill_n(n, 3, 0.0);
  for (int i = 2; i < facet.Size; ++i)
  {
    double a[3], b[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      a[axis] = p[i - 1][axis] - p[0][axis];
      b[axis] = p[i][axis] - p[0][axis];
    }
    n[0] += a[1] * b[2] - a[2] * b[1];
    n[1] += a[2] * b[0] - a[0] * b[2];
    n[2] += a[0] * b[1] - a[1] * b[0];
  }
}

/**
 * Sets 1 / depth of the plane of a facet, near a known value; false if the plane is edge-on. A beam
 * with a waist is like a cone there, whose apex is by a = ApexOffset^2 / depth farther away.
 */
bool SetInverseDepth(
  const Facet& facet, const BeamProjection& beam, double inverse, InverseDepth& result)
{
  const auto& p = facet.Corners;
  double n[3];
  GetNormal(facet, n);
  const double away = beam.ApexOffset * beam.ApexOffset * inverse;
  const double constant =
    n[0] * p[0][0] + n[1] * p[0][1] + n[2] * (p[0][2] - beam.ApexOffset + away);
  if (constant == 0.0)
  {
    return false;
  }
  // 1 / z for v = 1 / (z + a): v / (1 - a v), of which the tangent at the value is taken.
  const double v = inverse / (1.0 + away * inverse);
  const double slope = 1.0 / ((1.0 - away * v) * (1.0 - away * v));
  const double tangent = beam.GetRadius(1.0 / inverse) * v;
  result = { slope * n[0] * tangent / constant, slope * n[1] * tangent / constant,
    inverse + slope * (n[2] / constant - v) };
  return true;
}

} // namespace

//------------------------------------------------------------------------------
void VisibleSurfaces::Project(const std::vector<Facet>& facets, const BeamProjection& beam)
{
  this->Beam = beam;
  this->Faces.clear();
  this->EdgeSum = 0;
  this->HasFacetAtApex = false;
  this->LargestBend = 0.0;
  this->Layers = 0.0;
  this->IsLayer = facets.size() <= MaximumOfLayer;
  for (std::size_t i = 0; i < facets.size(); ++i)
  {
    if (this->IsLayer)
    {
      this->AddEdges(facets[i]);
    }
    this->AddBend(facets[i]);
    this->ProjectFacet(facets[i], i);
  }
}

//------------------------------------------------------------------------------
/// Adds the bend: between two depths of an edge the radius of the beam, over the depth, changes by
/// the bend.
void VisibleSurfaces::AddBend(const Facet& facet)
{
  if (!(this->Beam.ApexOffset > 0.0))
  {
    return;
  }
  const SpacePolygon space = CutToBeam(facet, this->Beam);
  double minimum = HUGE_VAL;
  double maximum = 0.0;
  for (int i = 0; i < space.Size; ++i)
  {
    const double depth = space.Corners[i][2] - this->Beam.ApexOffset;
    const double ratio = std::hypot(1.0, this->Beam.ApexOffset / std::max(depth, 1e-300));
    minimum = std::min(minimum, ratio);
    maximum = std::max(maximum, ratio);
  }
  this->LargestBend =
    std::max(this->LargestBend, maximum > minimum ? maximum / minimum - 1.0 : 0.0);
}

//------------------------------------------------------------------------------
void VisibleSurfaces::Sort()
{
  const std::size_t count = this->Faces.size();
  Order& order = this->Nearest;
  this->Keys.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Keys[i] = { this->Faces[i].Maximum, this->Faces[i].Cell, i };
  }
  std::sort(this->Keys.begin(), this->Keys.end(),
    [](const Key& a, const Key& b)
    { return a.Maximum > b.Maximum || (a.Maximum == b.Maximum && a.Cell < b.Cell); });
  order.Faces.resize(count);
  std::transform(this->Keys.begin(), this->Keys.end(), order.Faces.begin(),
    [](const Key& key) { return key.Face; });
  order.Maximum.resize(count);
  constexpr std::size_t word = sizeof(vtkTypeUInt64);
  order.Overlaps.assign((count + word - 1) / word * word, 0);
  for (int axis = 0; axis < 2; ++axis)
  {
    order.Low[axis].resize(count);
    order.High[axis].resize(count);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    const Face& face = this->Faces[order.Faces[i]];
    const PolygonBounds bounds(face.Outline);
    order.Maximum[i] = face.Maximum;
    for (int axis = 0; axis < 2; ++axis)
    {
      order.Low[axis][i] = RoundDown(bounds.Low[axis]);
      order.High[axis][i] = RoundUp(bounds.High[axis]);
    }
  }
}

//------------------------------------------------------------------------------
HELIOS_CLONES
void VisibleSurfaces::Order::SetOverlaps(const PolygonBounds& bounds)
{
  const float low[2] = { RoundDown(bounds.Low[0]), RoundDown(bounds.Low[1]) };
  const float high[2] = { RoundUp(bounds.High[0]), RoundUp(bounds.High[1]) };
  const float* lowX = this->Low[0].data();
  const float* lowY = this->Low[1].data();
  const float* highX = this->High[0].data();
  const float* highY = this->High[1].data();
  unsigned char* overlaps = this->Overlaps.data();
  const std::size_t count = this->Faces.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isInX = (lowX[i] < high[0]) & (low[0] < highX[i]);
    const bool isInY = (lowY[i] < high[1]) & (low[1] < highY[i]);
    overlaps[i] = isInX & isInY;
  }
}

void VisibleSurfaces::Order::FindOverlapping(const PolygonBounds& bounds)
{
  this->SetOverlaps(bounds);
  this->Overlapping.clear();
  constexpr std::size_t word = sizeof(vtkTypeUInt64);
  for (std::size_t first = 0; first < this->Overlaps.size(); first += word)
  {
    vtkTypeUInt64 any;
    std::memcpy(&any, &this->Overlaps[first], word);
    for (; any != 0; any &= any - 1) // a byte is 0 or 1
    {
      this->Overlapping.push_back(first + static_cast<std::size_t>(__builtin_ctzll(any)) / 8);
    }
  }
}

//------------------------------------------------------------------------------
void VisibleSurfaces::ProjectFacet(const Facet& facet, std::size_t index)
{
  const SpacePolygon space = CutToBeam(facet, this->Beam);
  Face face;
  face.Cell = facet.Cell;
  face.Facet = index;
  face.Minimum = HUGE_VAL;
  face.Maximum = 0.0;
  for (int i = 0; i < space.Size; ++i)
  {
    const double* corner = space.Corners[i];
    const double depth = corner[2] - this->Beam.ApexOffset;
    if (!(depth > 0.0))
    {
      return; // at the apex
    }
    const double scale = 1.0 / this->Beam.GetRadius(depth);
    const double inverse = 1.0 / depth;
    face.Outline.AddCut(corner[0] * scale, corner[1] * scale);
    face.Minimum = std::min(face.Minimum, inverse);
    face.Maximum = std::max(face.Maximum, inverse);
  }
  face.Outline.CloseCut();
  const PolygonBounds bounds(face.Outline);
  if (!bounds.MayTouchUnitCircle())
  {
    return;
  }
  const double area = face.Outline.GetArea();
  if (face.Outline.IsEmpty() || !(std::abs(area) > MinimumArea) ||
    !SetInverseDepth(facet, this->Beam, 0.5 * (face.Minimum + face.Maximum), face.Inverse))
  {
    return; // edge-on
  }
  if (area < 0.0)
  {
    std::reverse(face.Outline.X, face.Outline.X + face.Outline.Size);
    std::reverse(face.Outline.Y, face.Outline.Y + face.Outline.Size);
  }
  this->Layers += std::min(std::abs(area), bounds.GetEllipseInSquare()) / Pi;
  this->Faces.push_back(face);
}

//------------------------------------------------------------------------------
void VisibleSurfaces::AddEdges(const Facet& facet)
{
  double places[Facet::Capacity][2];
  vtkTypeUInt64 keys[Facet::Capacity];
  for (int i = 0; i < facet.Size; ++i)
  {
    const double* corner = facet.Corners[i];
    const double depth = corner[2] - this->Beam.ApexOffset;
    this->HasFacetAtApex = this->HasFacetAtApex || !(depth > 0.0);
    const double radius = this->Beam.GetRadius(depth);
    places[i][0] = corner[0] / radius;
    places[i][1] = corner[1] / radius;
    keys[i] = GetKey(corner);
  }
  for (int i = 0; i < facet.Size; ++i)
  {
    const int next = i + 1 < facet.Size ? i + 1 : 0;
    const bool isFirst = keys[i] < keys[next]; // both facets of an edge decide alike
    if (IsInBeam(places[isFirst ? i : next], places[isFirst ? next : i]))
    {
      this->EdgeSum += GetKey(keys[i], keys[next]) - GetKey(keys[next], keys[i]);
    }
  }
}

//------------------------------------------------------------------------------
bool VisibleSurfaces::AreOneLayer() const
{
  if (!this->IsLayer || this->EdgeSum != 0 || this->HasFacetAtApex)
  {
    return false;
  }
  // Any point will do that is not on an edge.
  constexpr double x = 0.0123;
  constexpr double y = 0.0271;
  const auto layers = std::count_if(this->Faces.begin(), this->Faces.end(),
    [](const Face& face)
    {
      bool isInside = true;
      for (int edge = 0; edge < face.Outline.Size; ++edge)
      {
        isInside = isInside && face.Outline.GetInside(edge)(x, y) > 0.0;
      }
      return isInside;
    });
  return layers == 1;
}

//------------------------------------------------------------------------------
void VisibleSurfaces::FindHiding(std::size_t face)
{
  const Face& f = this->Faces[face];
  Order& order = this->Nearest;
  order.FindOverlapping(PolygonBounds(f.Outline));
  this->Current = face;
  this->Hiding.clear();
  for (const std::size_t i : order.Overlapping)
  {
    if (!(order.Maximum[i] >= f.Minimum))
    {
      break;
    }
    const std::size_t other = order.Faces[i];
    if (other != face && this->IsNearerSomewhere(this->Faces[other], f))
    {
      this->Hiding.push_back(other); // if their outlines overlap, which Subtract() finds
    }
  }
  this->IsBehindAll = this->Hiding.size() > ManyHiding && !this->HidesAny(face);
}

//------------------------------------------------------------------------------
/// Returns whether a face hides anything of those whose bounds overlap; the farthest are the
/// likeliest.
bool VisibleSurfaces::HidesAny(std::size_t face) const
{
  const Face& f = this->Faces[face];
  const std::vector<std::size_t>& places = this->Nearest.Overlapping;
  return std::any_of(places.rbegin(), places.rend(),
    [&](std::size_t place)
    {
      const std::size_t other = this->Nearest.Faces[place];
      return other != face && this->IsNearerSomewhere(f, this->Faces[other]) &&
        DoOverlap(this->Faces[other].Outline, f.Outline);
    });
}

//------------------------------------------------------------------------------
/// Returns whether a face is nearer than another at some corner of each: otherwise it is not where
/// they overlap.
bool VisibleSurfaces::IsNearerSomewhere(const Face& a, const Face& b) const
{
  if (a.Maximum < b.Minimum || a.Minimum > b.Maximum)
  {
    return a.Maximum > b.Minimum;
  }
  const HalfPlane nearer = GetNearerSide(a.Inverse, b.Inverse);
  if (nearer.A == 0.0 && nearer.B == 0.0 && nearer.C == 0.0)
  {
    return a.Cell < b.Cell;
  }
  return Reaches(a.Outline, nearer) && Reaches(b.Outline, nearer);
}

//------------------------------------------------------------------------------
bool VisibleSurfaces::IsNearer(std::size_t by) const
{
  return this->Faces[by].Minimum >= this->Faces[this->Current].Maximum;
}

//------------------------------------------------------------------------------
Polygon VisibleSurfaces::GetNearer(const Polygon& polygon, std::size_t by) const
{
  const Face& face = this->Faces[this->Current];
  const Face& other = this->Faces[by];
  if (this->IsNearer(by))
  {
    return polygon;
  }
  // the whole polygon if coincident
  return Clip(polygon, GetNearerSide(other.Inverse, face.Inverse));
}

//------------------------------------------------------------------------------
const std::vector<Polygon>* VisibleSurfaces::FindVisible()
{
  const Polygon& outline = this->Faces[this->Current].Outline;
  this->Parts.assign(1, outline);
  this->PartBounds.assign(1, PolygonBounds(outline));
  for (const std::size_t by : this->Hiding)
  {
    if (this->Parts.empty())
    {
      break;
    }
    const Polygon hidden = this->GetNearer(this->Faces[by].Outline, by);
    if (!hidden.IsEmpty() && !this->Subtract(hidden))
    {
      return nullptr;
    }
  }
  return &this->Parts;
}

//------------------------------------------------------------------------------
/// Cuts off what is outside of a side; false if that is nothing.
bool VisibleSurfaces::Split(Polygon& inside, const HalfPlane& side, Polygon& outside)
{
  double distances[Polygon::Capacity];
  if (!(SetDistances(inside, side, distances) < 0.0))
  {
    return false;
  }
  outside = GetBeyond(inside, distances);
  if (!(outside.GetArea() > MinimumArea))
  {
    return false;
  }
  inside = GetBefore(inside, distances);
  return true;
}

//------------------------------------------------------------------------------
/// Subtracts a convex polygon from all parts; false if they are too many then.
bool VisibleSurfaces::Subtract(const Polygon& hidden)
{
  const PolygonBounds bounds(hidden);
  const PolygonSides sides(hidden);
  for (std::size_t i = this->Parts.size(); i-- > 0;)
  {
    if (!bounds.Overlaps(this->PartBounds[i]))
    {
      continue;
    }
    const PolygonCircle circle(this->PartBounds[i]);
    if (IsBeyondAnEdge(this->Parts[i], circle, hidden, sides) ||
      IsBeyondAnEdge(hidden, this->Parts[i]))
    {
      continue;
    }
    Polygon inside = this->Parts[i];
    this->Parts[i] = this->Parts.back();
    this->PartBounds[i] = this->PartBounds.back();
    this->Parts.pop_back();
    this->PartBounds.pop_back();
    for (int edge = 0; edge < sides.Size && !inside.IsEmpty(); ++edge)
    {
      const HalfPlane& side = sides.Sides[edge];
      Polygon outside;
      if (side(circle.X, circle.Y) >= circle.Radius || !Split(inside, side, outside))
      {
        continue;
      }
      if (outside.Size == Polygon::Capacity || this->Parts.size() > MaximumParts)
      {
        return false;
      }
      const PolygonBounds outsideBounds(outside);
      if (outsideBounds.MayTouchUnitCircle())
      {
        this->Parts.push_back(outside);
        this->PartBounds.push_back(outsideBounds);
      }
    }
  }
  return true;
}

} // namespace helios
