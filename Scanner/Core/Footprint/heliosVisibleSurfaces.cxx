// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVisibleSurfaces.h"

#include <algorithm>
#include <cmath>

namespace helios
{
namespace
{

constexpr double LeastArea = 1e-12;     // of a part, in the cross-section
constexpr double Frame = 2.0;           // half side of the square that large triangles are cut to
constexpr double Large = 100.0;         // coordinates from which they are, without a waist
constexpr std::size_t ManyHiding = 3;   // faces, from which complements are faster than parts
constexpr std::size_t MostParts = 4096; // of a face

/// A polygon in space, with corners of which depth z is the third coordinate.
struct SpacePolygon
{
  static constexpr int Capacity = 3 + 5;
  int Size = 0;
  double Corners[Capacity][3];
};

/// The part where a x + b y + c z is at least d.
SpacePolygon Clip(const SpacePolygon& p, double a, double b, double c, double d)
{
  SpacePolygon part;
  for (int i = 0; i < p.Size; ++i)
  {
    const double* from = p.Corners[i];
    const double* to = p.Corners[(i + 1) % p.Size];
    const double atFrom = a * from[0] + b * from[1] + c * from[2] - d;
    const double atTo = a * to[0] + b * to[1] + c * to[2] - d;
    if (atFrom >= 0.0 && part.Size < SpacePolygon::Capacity)
    {
      std::copy_n(from, 3, part.Corners[part.Size++]);
    }
    if (((atFrom > 0.0 && atTo < 0.0) || (atFrom < 0.0 && atTo > 0.0)) &&
      part.Size < SpacePolygon::Capacity)
    {
      const double t = atFrom / (atFrom - atTo);
      for (int axis = 0; axis < 3; ++axis)
      {
        part.Corners[part.Size][axis] = from[axis] + t * (to[axis] - from[axis]);
      }
      ++part.Size;
    }
  }
  return part;
}

/// Whether a corner of a polygon is in a half plane.
bool Reaches(const Polygon& p, const HalfPlane& side)
{
  bool reaches = false;
  for (int i = 0; i < p.Size; ++i)
  {
    reaches = reaches || side(p.X[i], p.Y[i]) > 0.0;
  }
  return reaches;
}

/// Where a plane is nearer than another.
HalfPlane GetNearerSide(const InverseDepth& a, const InverseDepth& b)
{
  return { a.X - b.X, a.Y - b.Y, a.One - b.One };
}

/// The part of a triangle in a frustum about the beam; all of it if it is not much larger.
SpacePolygon CutToBeam(const ConeTriangle& triangle, const BeamProjection& beam)
{
  SpacePolygon space;
  space.Size = 3;
  std::copy_n(&triangle.Corners[0][0], 9, &space.Corners[0][0]);
  const double largest = beam.Setback > 0.0 ? Frame : Large;
  const bool isLarge = std::any_of(triangle.Corners, triangle.Corners + 3,
    [&beam, largest](const double* corner)
    {
      const double reach = std::max(std::abs(corner[0]), std::abs(corner[1]));
      return !(corner[2] > beam.Setback) || reach > largest * beam.Tangent * corner[2];
    });
  if (isLarge)
  {
    const double slope = Frame * beam.Tangent;
    space = Clip(space, 0.0, 0.0, 1.0, beam.Setback);
    space = Clip(space, 1.0, 0.0, slope, 0.0);
    space = Clip(space, -1.0, 0.0, slope, 0.0);
    space = Clip(space, 0.0, 1.0, slope, 0.0);
    space = Clip(space, 0.0, -1.0, slope, 0.0);
  }
  return space;
}

/**
 * Sets 1 / depth of the plane of a triangle, near a value of it; false if the plane is edge-on. A
 * beam with a waist is like a cone there, whose apex is by a = Setback^2 / depth farther away.
 */
bool SetInverseDepth(
  const ConeTriangle& triangle, const BeamProjection& beam, double inverse, InverseDepth& result)
{
  const auto& p = triangle.Corners;
  double a[3], b[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = p[1][axis] - p[0][axis];
    b[axis] = p[2][axis] - p[0][axis];
  }
  const double n[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
  const double away = beam.Setback * beam.Setback * inverse;
  const double constant = n[0] * p[0][0] + n[1] * p[0][1] + n[2] * (p[0][2] - beam.Setback + away);
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
void VisibleSurfaces::Project(const ConeView& view, const BeamProjection& beam)
{
  this->Beam = beam;
  this->Faces.clear();
  for (const ConeTriangle& triangle : view.Triangles)
  {
    this->ProjectTriangle(triangle);
  }
  this->Occluders.clear();
  for (std::size_t i = 0; i < this->Faces.size(); ++i)
  {
    this->Occluders.push_back({ PolygonBounds(this->Faces[i].Outline), this->Faces[i].Most, i });
  }
  std::sort(this->Occluders.begin(), this->Occluders.end(),
    [this](const Occluder& a, const Occluder& b)
    {
      return a.Most > b.Most ||
        (a.Most == b.Most && this->Faces[a.Face].Cell < this->Faces[b.Face].Cell);
    });
}

//------------------------------------------------------------------------------
void VisibleSurfaces::ProjectTriangle(const ConeTriangle& triangle)
{
  const SpacePolygon space = CutToBeam(triangle, this->Beam);
  Face face;
  face.Cell = triangle.Cell;
  face.Least = HUGE_VAL;
  face.Most = 0.0;
  for (int i = 0; i < space.Size; ++i)
  {
    const double* corner = space.Corners[i];
    const double depth = corner[2] - this->Beam.Setback;
    if (!(depth > 0.0))
    {
      return; // at the apex
    }
    const double radius = this->Beam.GetRadius(depth);
    face.Outline.Add(corner[0] / radius, corner[1] / radius);
    face.Least = std::min(face.Least, 1.0 / depth);
    face.Most = std::max(face.Most, 1.0 / depth);
  }
  if (!PolygonBounds(face.Outline).MayTouchUnitCircle())
  {
    return;
  }
  const double area = face.Outline.GetArea();
  if (face.Outline.IsEmpty() || !(std::abs(area) > LeastArea) ||
    !SetInverseDepth(triangle, this->Beam, 0.5 * (face.Least + face.Most), face.Inverse))
  {
    return; // edge-on
  }
  if (area < 0.0)
  {
    std::reverse(face.Outline.X, face.Outline.X + face.Outline.Size);
    std::reverse(face.Outline.Y, face.Outline.Y + face.Outline.Size);
  }
  this->Faces.push_back(face);
}

//------------------------------------------------------------------------------
void VisibleSurfaces::FindHiding(std::size_t face)
{
  const Face& f = this->Faces[face];
  const PolygonBounds bounds(f.Outline);
  this->Current = face;
  this->Hiding.clear();
  auto other = this->Occluders.begin();
  for (; other != this->Occluders.end() && other->Most >= f.Least; ++other)
  {
    if (other->Face != face && bounds.Overlaps(other->Bounds))
    {
      const Face& by = this->Faces[other->Face];
      if (DoOverlap(by.Outline, f.Outline) && this->IsNearerSomewhere(by, f))
      {
        this->Hiding.push_back(other->Face);
      }
    }
  }
  this->IsBehindAll = this->Hiding.size() > ManyHiding &&
    std::none_of(this->Occluders.begin(), this->Occluders.end(),
      [&](const Occluder& o)
      {
        const Face& by = this->Faces[o.Face];
        return o.Face != face && bounds.Overlaps(o.Bounds) && this->IsNearerSomewhere(f, by) &&
          DoOverlap(by.Outline, f.Outline);
      });
}

//------------------------------------------------------------------------------
/// Whether a face is nearer than another at some corner of each: otherwise it is not where they
/// overlap.
bool VisibleSurfaces::IsNearerSomewhere(const Face& a, const Face& b) const
{
  if (a.Most < b.Least || a.Least > b.Most)
  {
    return a.Most > b.Least;
  }
  const HalfPlane nearer = GetNearerSide(a.Inverse, b.Inverse);
  if (nearer.A == 0.0 && nearer.B == 0.0 && nearer.C == 0.0)
  {
    return a.Cell < b.Cell;
  }
  return Reaches(a.Outline, nearer) && Reaches(b.Outline, nearer);
}

//------------------------------------------------------------------------------
Polygon VisibleSurfaces::GetNearer(const Polygon& polygon, std::size_t by) const
{
  const Face& face = this->Faces[this->Current];
  const Face& other = this->Faces[by];
  if (other.Least >= face.Most)
  {
    return polygon;
  }
  return Clip(polygon, GetNearerSide(other.Inverse, face.Inverse)); // all of it if coincident
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
/// Subtracts a convex polygon from all parts; false if they are too many then.
bool VisibleSurfaces::Subtract(const Polygon& hidden)
{
  const PolygonBounds bounds(hidden);
  for (std::size_t i = this->Parts.size(); i-- > 0;)
  {
    if (!bounds.Overlaps(this->PartBounds[i]) || !DoOverlap(this->Parts[i], hidden))
    {
      continue;
    }
    Polygon inside = this->Parts[i];
    this->Parts[i] = this->Parts.back();
    this->PartBounds[i] = this->PartBounds.back();
    this->Parts.pop_back();
    this->PartBounds.pop_back();
    for (int edge = 0; edge < hidden.Size && !inside.IsEmpty(); ++edge)
    {
      const HalfPlane side = hidden.GetInside(edge);
      const Polygon outside = Clip(inside, side.GetOpposite());
      if (outside.Size == Polygon::Capacity || this->Parts.size() > MostParts)
      {
        return false;
      }
      if (outside.GetArea() > LeastArea)
      {
        const PolygonBounds outsideBounds(outside);
        if (outsideBounds.MayTouchUnitCircle())
        {
          this->Parts.push_back(outside);
          this->PartBounds.push_back(outsideBounds);
        }
        inside = Clip(inside, side);
      }
    }
  }
  return true;
}

} // namespace helios
