// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFacets.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace helios
{
namespace
{

constexpr double LargestTilt = 3e-4; // [rad], between triangles of a facet
constexpr double Straight = 1e-18;   // square of the sine of a corner's turn to the right

void Cross(const double a[3], const double b[3], double c[3])
{
  c[0] = a[1] * b[2] - a[2] * b[1];
  c[1] = a[2] * b[0] - a[0] * b[2];
  c[2] = a[0] * b[1] - a[1] * b[0];
}

void GetNormal(const ConeTriangle& t, double n[3])
{
  double a[3], b[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = t.Corners[1][axis] - t.Corners[0][axis];
    b[axis] = t.Corners[2][axis] - t.Corners[0][axis];
  }
  Cross(a, b, n);
}

double Dot(const double a[3], const double b[3])
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

bool IsBeforeApex(const ConeTriangle& t)
{
  return std::min({ t.Corners[0][2], t.Corners[1][2], t.Corners[2][2] }) > 0.0;
}

/// Returns whether the normals of two planes are parallel: otherwise their responses differ.
bool AreParallel(const double a[3], const double b[3], double tilt = LargestTilt)
{
  const double along = Dot(a, b);
  return along * along >= (1.0 - tilt * tilt) * Dot(a, a) * Dot(b, b);
}

/// Returns a triangle as a facet; turned by its sign.
Facet MakeFacet(const ConeTriangle& t, std::size_t index, bool isClockwise)
{
  Facet facet;
  facet.Cell = t.Cell;
  facet.Size = 3;
  for (int i = 0; i < 3; ++i)
  {
    std::copy_n(t.Corners[isClockwise ? 2 - i : i], 3, facet.Corners[i]);
  }
  facet.First = index;
  facet.Last = index + 1;
  return facet;
}

int FindCorner(const Facet& facet, const double corner[3])
{
  for (int i = 0; i < facet.Size; ++i)
  {
    const double* other = facet.Corners[i];
    if (corner[0] == other[0] && corner[1] == other[1] && corner[2] == other[2])
    {
      return i;
    }
  }
  return -1;
}

/// Corners that a facet shares with a triangle, or -1.
struct SharedCorners
{
  SharedCorners(const Facet& facet, const ConeTriangle& triangle)
  {
    for (int i = 0; i < 3; ++i)
    {
      this->Places[i] = FindCorner(facet, triangle.Corners[i]);
      this->Count += this->Places[i] >= 0 ? 1 : 0;
    }
  }

  int Places[3];
  int Count = 0;
};

void Insert(Facet& facet, int place, const double corner[3])
{
  std::copy_backward(
    &facet.Corners[place][0], &facet.Corners[facet.Size][0], &facet.Corners[facet.Size][0] + 3);
  std::copy_n(corner, 3, facet.Corners[place]);
  ++facet.Size;
}

void Remove(Facet& facet, int place)
{
  std::copy(
    &facet.Corners[place][0] + 3, &facet.Corners[0][0] + 3 * facet.Size, &facet.Corners[place][0]);
  --facet.Size;
}

/// Adds a triangle that shares one or two edges with a facet; returns the corner where the facet
/// changed, or -1 if it does not, or does not fit.
int Add(Facet& facet, const ConeTriangle& triangle, const SharedCorners& shared, bool isClockwise)
{
  const auto follows = [&facet](int next, int place)
  { return next == (place + 1 < facet.Size ? place + 1 : 0); };
  for (int i = 0; i < 3; ++i)
  {
    // The facet has the edges of the triangle in the opposite direction.
    const int next = (i + 1) % 3;
    const int after = (i + 2) % 3;
    const int from = shared.Places[isClockwise ? next : i];
    const int to = shared.Places[isClockwise ? i : next];
    const int third = shared.Places[after];
    if (shared.Count == 2 && third < 0 && follows(from, to) && facet.Size < Facet::Capacity)
    {
      Insert(facet, to + 1, triangle.Corners[after]);
      return to + 1;
    }
    if (shared.Count == 3 && facet.Size > 3 && follows(from, to) && follows(to, third))
    {
      Remove(facet, to);
      return to;
    }
  }
  return -1;
}

/// Returns whether a corner turns left about the normal.
bool IsLeftTurn(const Facet& facet, int corner, const double normal[3])
{
  const double* from = facet.Corners[corner > 0 ? corner - 1 : facet.Size - 1];
  const double* at = facet.Corners[corner];
  const double* to = facet.Corners[corner + 1 < facet.Size ? corner + 1 : 0];
  double a[3], b[3], n[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = at[axis] - from[axis];
    b[axis] = to[axis] - at[axis];
  }
  Cross(a, b, n);
  const double turn = Dot(n, normal);
  return turn >= 0.0 || turn * turn <= Straight * Dot(a, a) * Dot(b, b) * Dot(normal, normal);
}

/// Returns whether a corner and its neighbours turn left.
bool IsConvexNear(const Facet& facet, int corner, const double normal[3])
{
  const int at = corner < facet.Size ? corner : 0;
  const int before = at > 0 ? at - 1 : facet.Size - 1;
  const int after = at + 1 < facet.Size ? at + 1 : 0;
  return IsLeftTurn(facet, before, normal) && IsLeftTurn(facet, at, normal) &&
    IsLeftTurn(facet, after, normal);
}

bool IsConvex(const Facet& facet, const double normal[3])
{
  for (int i = 0; i < facet.Size; ++i)
  {
    if (!IsLeftTurn(facet, i, normal))
    {
      return false;
    }
  }
  return true;
}

/// Finds the edge that two triangles share; false if they share no edge.
bool FindPair(const ConeTriangle& a, const ConeTriangle& b, FacetMaker::Pair& pair)
{
  int places[3] = { -1, -1, -1 }; // places of the corners of b in a
  int shared = 0;
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3 && places[i] < 0; ++k)
    {
      places[i] = std::equal(b.Corners[i], b.Corners[i] + 3, a.Corners[k]) ? k : -1;
    }
    shared += places[i] >= 0 ? 1 : 0;
    pair.OfSecond = places[i] < 0 ? i : pair.OfSecond;
  }
  if (shared != 2)
  {
    return false;
  }
  const int after = places[(pair.OfSecond + 1) % 3];
  const int before = places[(pair.OfSecond + 2) % 3];
  pair.IsSameWay = after == (before + 1) % 3;
  const int from = pair.IsSameWay ? before : after;
  pair.Corners[0] = from;
  pair.Corners[1] = FacetMaker::Pair::Own;
  pair.Corners[2] = (from + 1) % 3;
  pair.Corners[3] = (from + 2) % 3;
  return before != after;
}

} // namespace

FacetMaker::FacetMaker(AreAlike areAlike, double tolerance)
  : Alike(std::move(areAlike))
  , Tolerance(tolerance)
{
}

//------------------------------------------------------------------------------
Facet& Facet::operator=(const Facet& other)
{
  if (this != &other)
  {
    this->Cell = other.Cell;
    this->Size = other.Size;
    this->First = other.First;
    this->Last = other.Last;
    std::copy_n(&other.Corners[0][0], 3 * other.Size, &this->Corners[0][0]);
  }
  return *this;
}

//------------------------------------------------------------------------------
/// Returns whether a corner is on a plane. In the direction of a corner of depth z, the plane has
/// the depth z constant / (normal . corner).
bool FacetMaker::IsOn(const Plane& plane, const double corner[3]) const
{
  const double there = Dot(plane.Normal, corner);
  return std::abs(there - plane.Constant) * corner[2] <= this->Tolerance * std::abs(there);
}

//------------------------------------------------------------------------------
/// Returns whether a triangle before the apex has the response of a facet, and lies in its plane.
bool FacetMaker::CanJoin(const Facet& facet, const Plane& plane, const ConeTriangle& other) const
{
  return IsBeforeApex(other) &&
    std::all_of(other.Corners, other.Corners + 3,
      [&](const double* corner) { return this->IsOn(plane, corner); }) &&
    this->Alike(facet.Cell, other.Cell);
}

//------------------------------------------------------------------------------
/// Joins the triangles that follow to the first one of a facet.
void FacetMaker::Grow(
  Facet& facet, const Plane& plane, const std::vector<ConeTriangle>& triangles) const
{
  Facet convex; // the last that was, while the facet is not
  bool isConvex = true;
  for (; facet.Last < triangles.size(); ++facet.Last)
  {
    const ConeTriangle& next = triangles[facet.Last];
    const SharedCorners shared(facet, next);
    if (shared.Count < 2 || !this->CanJoin(facet, plane, next))
    {
      break;
    }
    double own[3];
    GetNormal(next, own);
    if (isConvex)
    {
      convex = facet;
    }
    const int changed =
      AreParallel(own, plane.Normal) ? Add(facet, next, shared, Dot(own, plane.Normal) < 0.0) : -1;
    if (changed < 0)
    {
      break;
    }
    // Not so between the first and the last triangle of a fan.
    isConvex =
      isConvex ? IsConvexNear(facet, changed, plane.Normal) : IsConvex(facet, plane.Normal);
  }
  if (!isConvex)
  {
    facet = convex;
  }
}

//------------------------------------------------------------------------------
bool FacetMaker::CanPair(
  const ConeTriangle& a, const ConeTriangle& b, double tilt, Pair& pair) const
{
  if (!this->Alike || !FindPair(a, b, pair))
  {
    return false;
  }
  Plane plane;
  double other[3];
  GetNormal(a, plane.Normal);
  GetNormal(b, other);
  plane.Constant = Dot(plane.Normal, a.Corners[0]);
  return AreParallel(plane.Normal, other, tilt) && IsBeforeApex(a) && IsBeforeApex(b) &&
    this->IsOn(plane, b.Corners[pair.OfSecond]) && this->Alike(a.Cell, b.Cell);
}

//------------------------------------------------------------------------------
void FacetMaker::Make(const ConeView& view, std::vector<Facet>& facets) const
{
  const std::vector<ConeTriangle>& triangles = view.Triangles;
  facets.clear();
  for (std::size_t i = 0; i < triangles.size(); i = facets.back().Last)
  {
    const ConeTriangle& first = triangles[i];
    Plane plane;
    GetNormal(first, plane.Normal);
    plane.Constant = Dot(plane.Normal, first.Corners[0]);
    facets.push_back(MakeFacet(first, i, plane.Constant < 0.0));
    if (!this->Alike || plane.Constant == 0.0 || !IsBeforeApex(first))
    {
      continue;
    }
    if (plane.Constant < 0.0)
    {
      plane.Constant = -plane.Constant;
      std::transform(plane.Normal, plane.Normal + 3, plane.Normal, std::negate<>());
    }
    this->Grow(facets.back(), plane, triangles);
  }
}

} // namespace helios
