// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Convex polygons in the cross-section of a beam.

#ifndef heliosPolygon_h
#define heliosPolygon_h

#include <algorithm>
#include <cmath>

namespace helios
{

/// The points where A x + B y + C is positive.
struct HalfPlane
{
  double A, B, C;

  double operator()(double x, double y) const { return this->A * x + this->B * y + this->C; }
  HalfPlane GetOpposite() const { return { -this->A, -this->B, -this->C }; }
};

/// A convex polygon, counterclockwise. It fills the coordinates up to its size.
struct Polygon
{
  static constexpr int Capacity = 24;

  int Size = 0;
  double X[Capacity];
  double Y[Capacity];

  Polygon() = default;
  Polygon(const Polygon& other) { *this = other; }
  Polygon& operator=(const Polygon& other)
  {
    if (this == &other)
    {
      return *this;
    }
    this->Size = other.Size;
    for (int i = 0; i < other.Size; ++i)
    {
      this->X[i] = other.X[i];
      this->Y[i] = other.Y[i];
    }
    return *this;
  }

  bool IsEmpty() const { return this->Size < 3; }

  void Add(double x, double y)
  {
    this->X[this->Size] = x;
    this->Y[this->Size] = y;
    ++this->Size;
  }

  /// Adds a corner of a cut polygon, unless it is the last one: an edge needs a direction.
  void AddCut(double x, double y)
  {
    if (this->Size < Capacity && !(this->Size > 0 && this->IsAt(this->Size - 1, x, y)))
    {
      this->Add(x, y);
    }
  }

  /// Removes the last corner if it is the first one.
  void CloseCut()
  {
    if (this->Size > 1 && this->IsAt(this->Size - 1, this->X[0], this->Y[0]))
    {
      --this->Size;
    }
  }

  bool IsAt(int corner, double x, double y) const
  {
    constexpr double same = 1e-10;
    return std::abs(this->X[corner] - x) < same && std::abs(this->Y[corner] - y) < same;
  }

  int GetNext(int corner) const { return corner + 1 < this->Size ? corner + 1 : 0; }

  /// Returns the half plane to the left of an edge, which is inside.
  HalfPlane GetInside(int edge) const
  {
    const int next = this->GetNext(edge);
    const double a = this->Y[edge] - this->Y[next];
    const double b = this->X[next] - this->X[edge];
    return { a, b, -(a * this->X[edge] + b * this->Y[edge]) };
  }

  double GetArea() const
  {
    double sum = 0.0;
    for (int i = 2; i < this->Size; ++i)
    {
      sum += (this->X[i - 1] - this->X[0]) * (this->Y[i] - this->Y[0]) -
        (this->X[i] - this->X[0]) * (this->Y[i - 1] - this->Y[0]);
    }
    return 0.5 * sum;
  }
};

/// The bounds of a polygon.
struct PolygonBounds
{
  double Low[2] = { HUGE_VAL, HUGE_VAL };
  double High[2] = { -HUGE_VAL, -HUGE_VAL };

  explicit PolygonBounds(const Polygon& p)
  {
    for (int i = 0; i < p.Size; ++i)
    {
      this->Low[0] = std::min(this->Low[0], p.X[i]);
      this->Low[1] = std::min(this->Low[1], p.Y[i]);
      this->High[0] = std::max(this->High[0], p.X[i]);
      this->High[1] = std::max(this->High[1], p.Y[i]);
    }
  }

  bool MayTouchUnitCircle() const
  {
    const double x = std::max({ 0.0, this->Low[0], -this->High[0] });
    const double y = std::max({ 0.0, this->Low[1], -this->High[1] });
    return x * x + y * y < 1.0;
  }

  /// Returns the area of an ellipse in the part of the bounds about the unit circle.
  double GetEllipseInSquare() const
  {
    constexpr double share = 0.7853981633974483;
    return share * std::max(0.0, std::min(1.0, this->High[0]) - std::max(-1.0, this->Low[0])) *
      std::max(0.0, std::min(1.0, this->High[1]) - std::max(-1.0, this->Low[1]));
  }

  bool Overlaps(const PolygonBounds& b) const
  {
    return (this->Low[0] < b.High[0]) & (b.Low[0] < this->High[0]) & (this->Low[1] < b.High[1]) &
      (b.Low[1] < this->High[1]);
  }
};

/// Sets the distances of the corners from a line, in any unit, positive in the half plane; returns
/// the least.
inline double SetDistances(const Polygon& p, const HalfPlane& side, double* distances)
{
  double minimum = HUGE_VAL;
  for (int i = 0; i < p.Size; ++i)
  {
    distances[i] = side(p.X[i], p.Y[i]);
    minimum = std::min(minimum, distances[i]);
  }
  return minimum;
}

/// Returns the part of a polygon on the side of a line, by the distances of its corners, that is
/// positive (or negative, by the sign). A polygon that is full is not cut any further.
template <int Sign>
Polygon GetSide(const Polygon& p, const double* distances)
{
  Polygon part;
  for (int i = 0; i < p.Size; ++i)
  {
    const int j = p.GetNext(i);
    const double a = Sign * distances[i];
    const double b = Sign * distances[j];
    if (a >= 0.0)
    {
      part.AddCut(p.X[i], p.Y[i]);
    }
    if ((a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0))
    {
      const double t = a / (a - b);
      part.AddCut(p.X[i] + t * (p.X[j] - p.X[i]), p.Y[i] + t * (p.Y[j] - p.Y[i]));
    }
  }
  part.CloseCut();
  return part;
}
inline Polygon GetBefore(const Polygon& p, const double* distances)
{
  return GetSide<1>(p, distances);
}
inline Polygon GetBeyond(const Polygon& p, const double* distances)
{
  return GetSide<-1>(p, distances);
}

/// Returns the part of a polygon in a half plane.
inline Polygon Clip(const Polygon& p, const HalfPlane& side)
{
  double distances[Polygon::Capacity];
  return SetDistances(p, side, distances) >= 0.0 ? p : GetBefore(p, distances);
}

/// Returns whether all corners of a polygon are outside of an edge of another, or on it. The edge
/// has a length: its corners were added by AddCut().
inline bool IsBeyond(const Polygon& p, const Polygon& of, int edge)
{
  const int next = of.GetNext(edge);
  const double x = of.X[edge];
  const double y = of.Y[edge];
  const double dx = of.X[next] - x;
  const double dy = of.Y[next] - y;
  bool isBeyond = true;
  for (int i = 0; i < p.Size && isBeyond; ++i)
  {
    isBeyond = dx * (p.Y[i] - y) - dy * (p.X[i] - x) <= 0.0;
  }
  return isBeyond;
}

inline bool IsBeyondAnEdge(const Polygon& p, const Polygon& of)
{
  for (int edge = 0; edge < of.Size; ++edge)
  {
    if (IsBeyond(p, of, edge))
    {
      return true;
    }
  }
  return false;
}

/// The half planes inside the edges of a polygon, with distances in the unit of the coordinates.
struct PolygonSides
{
  int Size = 0;
  HalfPlane Sides[Polygon::Capacity];

  explicit PolygonSides(const Polygon& p)
    : Size(p.Size)
  {
    for (int edge = 0; edge < p.Size; ++edge)
    {
      const HalfPlane side = p.GetInside(edge);
      const double scale = 1.0 / std::sqrt(side.A * side.A + side.B * side.B);
      this->Sides[edge] = { scale * side.A, scale * side.B, scale * side.C };
    }
  }
};

/// A circle about a polygon.
struct PolygonCircle
{
  double X, Y, Radius;

  explicit PolygonCircle(const PolygonBounds& bounds)
    : X(0.5 * (bounds.Low[0] + bounds.High[0]))
    , Y(0.5 * (bounds.Low[1] + bounds.High[1]))
  {
    const double x = bounds.High[0] - this->X;
    const double y = bounds.High[1] - this->Y;
    this->Radius = std::sqrt(x * x + y * y);
  }
};

/// Returns whether a polygon is beyond an edge, by a circle about the polygon and the sides of the
/// other, which is faster.
inline bool IsBeyondAnEdge(
  const Polygon& p, const PolygonCircle& about, const Polygon& of, const PolygonSides& sides)
{
  for (int edge = 0; edge < of.Size; ++edge)
  {
    const double distance = sides.Sides[edge](about.X, about.Y);
    if (distance < about.Radius && (distance <= -about.Radius || IsBeyond(p, of, edge)))
    {
      return true;
    }
  }
  return false;
}

/// Sets the part of a polygon inside another one; false, and it is not set, if the whole polygon is
/// inside.
inline bool Cut(
  const Polygon& p, const PolygonCircle& about, const PolygonSides& by, Polygon& common)
{
  const Polygon* from = &p;
  double distances[Polygon::Capacity];
  for (const HalfPlane* side = by.Sides; side != by.Sides + by.Size && !from->IsEmpty(); ++side)
  {
    const double distance = (*side)(about.X, about.Y);
    if (distance <= -about.Radius)
    {
      common.Size = 0;
      return true;
    }
    if (distance < about.Radius && SetDistances(*from, *side, distances) < 0.0)
    {
      common = GetBefore(*from, distances);
      from = &common;
    }
  }
  return from == &common;
}

/// Returns whether the interiors of two polygons have common points. Polygons with a common edge
/// have none.
inline bool DoOverlap(const Polygon& p, const Polygon& q)
{
  return !IsBeyondAnEdge(p, q) && !IsBeyondAnEdge(q, p);
}

} // namespace helios

#endif
