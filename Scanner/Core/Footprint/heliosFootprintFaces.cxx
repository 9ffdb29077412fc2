// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosFootprintFaces.h"

#include "heliosRayVectors.h"

#include <algorithm>

namespace helios
{
namespace
{

constexpr double Pi = 3.14159265358979323846;
constexpr double MinimumArea = 1e-12; // area of a face, in the cross-section
constexpr double Large = 100.0;       // coordinates of a triangle that is added as a facet
constexpr double Inside = 1.0 - 1e-6; // square of the radius of a corner that is in the beam
constexpr double LargestTilt = 3e-4;  // [rad], between triangles of one plane
constexpr double Rounding = 1e-9;     // share of depths
constexpr std::size_t Width = 4;

typedef Doubles Lane;
typedef Masks LaneMasks;

HELIOS_INLINE Lane Least(const Lane& a, const Lane& b)
{
  return a < b ? a : b;
}

HELIOS_INLINE Lane Most(const Lane& a, const Lane& b)
{
  return a > b ? a : b;
}

HELIOS_INLINE Lane Absolute(const Lane& a)
{
  return a < 0.0 ? -a : a;
}

/// Returns whether two normals are parallel.
bool AreParallel(const double a[3], const double b[3])
{
  const double along = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  return along * along >= (1.0 - LargestTilt * LargestTilt) *
    (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]) * (b[0] * b[0] + b[1] * b[1] + b[2] * b[2]);
}

} // namespace

/// Four triangles in a beam.
struct FootprintFaces::Lanes
{
  Lane X[3], Y[3]; ///< corners in the cross-section
  Lane Slopes[3];  ///< slopes of the edges from each corner
  Lane Depth[3];
  Lane Normal[3];        ///< normal, of any length
  Lane GX, GY, One;      ///< inverse depth of the plane
  Lane Minimum, Maximum; ///< inverse depths of the corners
  Lane Area;             ///< twice the area, positive if counterclockwise
  Lane Box;              ///< area of an ellipse in the box about it and the beam
  Lane
    NearestOnAxis; ///< largest inverse depth of the plane about the axis, if it may meet that; or 0
  LaneMasks IsLarge;
  LaneMasks IsFace;

  HELIOS_INLINE void Set(
    const ConeTriangle* triangles, std::size_t size, const BeamEllipse& ellipse, double tangent);
  HELIOS_INLINE void SetNearestOnAxis();
  HELIOS_INLINE void SetPlane(const Lane p[3][3], double tangent);
};

/// A triangle or quadrilateral in the cross-section.
struct FootprintFaces::Outline
{
  int Size = 0;
  double X[4], Y[4];
  double Slopes[4];  ///< slopes of the edges from each corner
  double Area = 0.0; ///< twice the area, as in lanes
  FacePlane Plane;
  std::size_t Index = 0; ///< in the view

  HELIOS_INLINE void Set(const Lanes& lanes, std::size_t lane, vtkIdType cell, std::size_t index);
};

HELIOS_INLINE void FootprintFaces::Outline::Set(
  const Lanes& lanes, std::size_t lane, vtkIdType cell, std::size_t index)
{
  this->Size = 3;
  for (int corner = 0; corner < 3; ++corner)
  {
    this->X[corner] = lanes.X[corner][lane];
    this->Y[corner] = lanes.Y[corner][lane];
    this->Slopes[corner] = lanes.Slopes[corner][lane];
  }
  this->Area = lanes.Area[lane];
  this->Plane.Inverse = { lanes.GX[lane], lanes.GY[lane], lanes.One[lane] };
  this->Plane.Minimum = lanes.Minimum[lane];
  this->Plane.Maximum = lanes.Maximum[lane];
  this->Plane.Cell = cell;
  this->Index = index;
}

//------------------------------------------------------------------------------
HELIOS_INLINE void FootprintFaces::Lanes::Set(
  const ConeTriangle* triangles, std::size_t size, const BeamEllipse& ellipse, double tangent)
{
  Lane p[3][3];
  for (std::size_t lane = 0; lane < Width; ++lane)
  {
    const ConeTriangle& triangle = triangles[std::min(lane, size - 1)];
    for (int corner = 0; corner < 3; ++corner)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        p[corner][axis][lane] = triangle.Corners[corner][axis];
      }
    }
  }
  const double scale = 1.0 / tangent;
  this->IsLarge = LaneMasks();
  Lane low[2] = { Lane() + HUGE_VAL, Lane() + HUGE_VAL };
  Lane high[2] = { Lane() - HUGE_VAL, Lane() - HUGE_VAL };
  this->Minimum = Lane() + HUGE_VAL;
  this->Maximum = Lane();
  for (int corner = 0; corner < 3; ++corner)
  {
    ellipse.ToCircle(p[corner][0], p[corner][1]);
    const Lane inverse = 1.0 / p[corner][2];
    const Lane x = scale * p[corner][0] * inverse;
    const Lane y = scale * p[corner][1] * inverse;
    this->IsLarge |= ~((p[corner][2] > 0.0) & (Most(Absolute(x), Absolute(y)) <= Large));
    this->X[corner] = x;
    this->Y[corner] = y;
    this->Depth[corner] = p[corner][2];
    low[0] = Least(low[0], x);
    low[1] = Least(low[1], y);
    high[0] = Most(high[0], x);
    high[1] = Most(high[1], y);
    this->Minimum = Least(this->Minimum, inverse);
    this->Maximum = Most(this->Maximum, inverse);
  }
  this->Area = (this->X[1] - this->X[0]) * (this->Y[2] - this->Y[0]) -
    (this->X[2] - this->X[0]) * (this->Y[1] - this->Y[0]);
  for (int edge = 0; edge < 3; ++edge)
  {
    const int next = edge < 2 ? edge + 1 : 0;
    const Lane slope = (this->X[next] - this->X[edge]) / (this->Y[next] - this->Y[edge]);
    this->Slopes[edge] = Least(Lane() + 1e30, Most(Lane() - 1e30, slope));
  }
  const Lane beyond[2] = { Most(Lane(), Most(low[0], -high[0])),
    Most(Lane(), Most(low[1], -high[1])) };
  constexpr double share = 0.25 * Pi;
  this->Box = share * Most(Lane(), Least(Lane() + 1.0, high[0]) - Most(Lane() - 1.0, low[0])) *
    Most(Lane(), Least(Lane() + 1.0, high[1]) - Most(Lane() - 1.0, low[1]));
  this->SetPlane(p, tangent);
  this->SetNearestOnAxis();
  this->IsFace &= ~this->IsLarge & (Absolute(this->Area) > 2.0 * MinimumArea) &
    (beyond[0] * beyond[0] + beyond[1] * beyond[1] < 1.0);
}

/// Sets the inverse depth of the planes, which are not edge-on.
HELIOS_INLINE void FootprintFaces::Lanes::SetPlane(const Lane p[3][3], double tangent)
{
  Lane a[3], b[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    a[axis] = p[1][axis] - p[0][axis];
    b[axis] = p[2][axis] - p[0][axis];
  }
  Lane* n = this->Normal;
  n[0] = a[1] * b[2] - a[2] * b[1];
  n[1] = a[2] * b[0] - a[0] * b[2];
  n[2] = a[0] * b[1] - a[1] * b[0];
  const Lane constant = n[0] * p[0][0] + n[1] * p[0][1] + n[2] * p[0][2];
  this->IsFace = constant != 0.0;
  const Lane scale = 1.0 / constant;
  this->GX = tangent * n[0] * scale;
  this->GY = tangent * n[1] * scale;
  this->One = n[2] * scale;
}

/// Finds what the axis may meet, beyond the rounding of the coordinates.
HELIOS_INLINE void FootprintFaces::Lanes::SetNearestOnAxis()
{
  constexpr double error = 1e-6;
  LaneMasks isLeft = LaneMasks() - 1;
  LaneMasks isRight = LaneMasks() - 1;
  for (int k = 0; k < 3; ++k)
  {
    const int next = k < 2 ? k + 1 : 0;
    const Lane edge = this->X[k] * this->Y[next] - this->X[next] * this->Y[k];
    isLeft &= edge >= -error;
    isRight &= edge <= error;
  }
  const Lane rim = Crowd::Reach * (Absolute(this->GX) + Absolute(this->GY));
  const Lane plane = this->One + rim;
  const Lane nearest = this->IsLarge ? plane : Most(this->Maximum, plane);
  const Lane doubtful = Lane() + HUGE_VAL; // not a number: edge-on
  const Lane known = nearest >= 0.0 ? nearest : (nearest < 0.0 ? Lane() : doubtful);
  this->NearestOnAxis = isLeft | isRight | this->IsLarge ? known : Lane();
}

//------------------------------------------------------------------------------
void FootprintFaces::Clear()
{
  this->Faces.clear();
  this->Lines.clear();
}

//------------------------------------------------------------------------------
/// Adds the line of an edge that is not level, from its lower end.
HELIOS_INLINE void FootprintFaces::AddLine(double x, double y, double toX, double toY)
{
  const double slope = std::clamp((toX - x) / (toY - y), -1e30, 1e30);
  this->Lines.push_back(
    { static_cast<float>(x), static_cast<float>(y), static_cast<float>(slope) });
}

//------------------------------------------------------------------------------
void FootprintFaces::Add(const VisibleSurfaces::Face& from)
{
  const Polygon& p = from.Outline;
  const auto [low, high] = std::minmax_element(p.Y, p.Y + p.Size);
  Face face{ from, static_cast<float>(*low), static_cast<float>(*high),
    static_cast<int>(this->Lines.size()), 0, 0 };
  for (const bool isRight : { false, true })
  {
    for (int edge = 0; edge < p.Size; ++edge)
    {
      const int next = p.GetNext(edge);
      const bool isUp = p.Y[edge] < p.Y[next]; // counterclockwise: up on the right
      if (isUp == isRight && p.Y[edge] != p.Y[next])
      {
        const int lower = isUp ? edge : next;
        const int upper = isUp ? next : edge;
        this->AddLine(p.X[lower], p.Y[lower], p.X[upper], p.Y[upper]);
        ++(isRight ? face.Right : face.Left);
      }
    }
  }
  this->Faces.push_back(face);
}

//------------------------------------------------------------------------------
/// Adds a face.
HELIOS_INLINE void FootprintFaces::AddOutline(const Outline& o)
{
  Face face;
  static_cast<FacePlane&>(face) = o.Plane;
  face.Low = static_cast<float>(std::min({ o.Y[0], o.Y[1], o.Y[2], o.Y[o.Size - 1] }));
  face.High = static_cast<float>(std::max({ o.Y[0], o.Y[1], o.Y[2], o.Y[o.Size - 1] }));
  face.FirstLine = static_cast<int>(this->Lines.size());
  face.Left = 0;
  face.Right = 0;
  const bool isTurned = o.Area < 0.0;
  for (const bool isRight : { false, true })
  {
    for (int edge = 0; edge < o.Size; ++edge)
    {
      const int next = edge + 1 < o.Size ? edge + 1 : 0;
      const bool isUp = o.Y[edge] < o.Y[next];
      if ((isUp != isTurned) == isRight && o.Y[edge] != o.Y[next])
      {
        const int from = isUp ? edge : next;
        this->Lines.push_back({ static_cast<float>(o.X[from]), static_cast<float>(o.Y[from]),
          static_cast<float>(o.Slopes[edge]) });
        ++(isRight ? face.Right : face.Left);
      }
    }
  }
  this->Faces.push_back(face);
}

//------------------------------------------------------------------------------
/// Sets both to the quadrilateral of two triangles, in the plane of the larger one; false if it is not
/// convex.
bool FootprintFaces::Join(
  const Outline& a, const Outline& b, const FacetMaker::Pair& pair, Outline& both)
{
  const bool isTurned = a.Area < 0.0;
  if (((b.Area < 0.0) == isTurned) != pair.IsSameWay)
  {
    return false;
  }
  const int own = pair.OfSecond;
  const int before = own > 0 ? own - 1 : 2;
  for (int i = 0; i < 4; ++i)
  {
    const int corner = pair.Corners[i];
    const bool isOwn = corner == FacetMaker::Pair::Own;
    both.X[i] = isOwn ? b.X[own] : a.X[corner];
    both.Y[i] = isOwn ? b.Y[own] : a.Y[corner];
    both.Slopes[i] = i == 0 ? b.Slopes[pair.IsSameWay ? before : own]
      : i == 1              ? b.Slopes[pair.IsSameWay ? own : before]
                            : a.Slopes[corner];
  }
  const auto turns = [&both, isTurned](int from, int at, int to)
  {
    const double turn = (both.X[at] - both.X[from]) * (both.Y[to] - both.Y[at]) -
      (both.X[to] - both.X[at]) * (both.Y[at] - both.Y[from]);
    return isTurned ? turn < 0.0 : turn > 0.0;
  };
  if (!turns(3, 0, 1) || !turns(1, 2, 3))
  {
    return false;
  }
  both.Size = 4;
  both.Area = a.Area + (pair.IsSameWay ? b.Area : -b.Area);
  both.Plane = std::abs(a.Area) >= std::abs(b.Area) ? a.Plane : b.Plane;
  both.Plane.Cell = a.Plane.Cell;
  both.Plane.Pair = a.Index;
  both.Plane.Minimum = std::min(a.Plane.Minimum, b.Plane.Minimum);
  both.Plane.Maximum = std::max(a.Plane.Maximum, b.Plane.Maximum);
  return true;
}

//------------------------------------------------------------------------------
/// Adds the face of the last triangle and another one, or of the last one; the other may still pair.
HELIOS_INLINE void FootprintFaces::AddNext(
  const ConeView& view, const PairRule& pairs, const Outline& next, Outline& last)
{
  FacetMaker::Pair pair;
  Outline both;
  const bool isPair = pairs.Tilt > 0.0 && last.Size > 0 && last.Index + 1 == next.Index &&
    pairs.Maker.CanPair(view.Triangles[last.Index], view.Triangles[next.Index], pairs.Tilt, pair) &&
    Join(last, next, pair, both);
  if (last.Size > 0)
  {
    this->AddOutline(isPair ? both : last);
  }
  last = next;
  last.Size = isPair ? 0 : last.Size;
}

//------------------------------------------------------------------------------
HELIOS_CLONES
Crowd FootprintFaces::AddTriangles(const ConeView& view, const BeamEllipse& ellipse, double tangent,
  const PairRule& pairs, std::vector<Facet>& large)
{
  Crowd crowd;
  Outline outline;
  Outline waiting; // may pair with the next one
  large.clear();
  double last[3] = { 0.0, 0.0, 0.0 }; // normal
  const std::size_t count = view.Triangles.size();
  Lane nearestOnAxis = Lane();
  for (std::size_t first = 0; first < count; first += Width)
  {
    const ConeTriangle* triangles = &view.Triangles[first];
    const std::size_t size = std::min(Width, count - first);
    Lanes lanes;
    lanes.Set(triangles, size, ellipse, tangent);
    LaneMasks isInside = LaneMasks();
    for (int corner = 0; corner < 3; ++corner)
    {
      isInside |= lanes.X[corner] * lanes.X[corner] + lanes.Y[corner] * lanes.Y[corner] < Inside;
    }
    isInside &= lanes.IsFace;
    for (std::size_t i = 0; i < size; ++i)
    {
      if (isInside[i] != 0)
      {
        const double normal[3] = { lanes.Normal[0][i], lanes.Normal[1][i], lanes.Normal[2][i] };
        ++crowd.Triangles;
        crowd.Surfaces += AreParallel(normal, last) && crowd.Surfaces > 0 ? 0 : 1;
        std::copy_n(normal, 3, last);
        crowd.Layers += std::min(0.5 * std::abs(lanes.Area[i]), lanes.Box[i]) / Pi;
        for (int corner = 0; corner < 3; ++corner)
        {
          const double x = lanes.X[corner][i];
          const double y = lanes.Y[corner][i];
          const double depth = lanes.Depth[corner][i];
          const bool isIn = x * x + y * y < Inside;
          crowd.Nearest = isIn ? std::min(crowd.Nearest, depth) : crowd.Nearest;
          crowd.Farthest = isIn ? std::max(crowd.Farthest, depth) : crowd.Farthest;
        }
      }
      if (lanes.IsFace[i] != 0)
      {
        outline.Set(lanes, i, triangles[i].Cell, first + i);
        this->AddNext(view, pairs, outline, waiting);
      }
      if (lanes.IsLarge[i] != 0)
      {
        Facet facet;
        facet.Cell = triangles[i].Cell;
        facet.Size = 3;
        std::copy_n(&triangles[i].Corners[0][0], 9, &facet.Corners[0][0]);
        for (int corner = 0; corner < 3 && !ellipse.IsCircle(); ++corner)
        {
          ellipse.ToCircle(facet.Corners[corner]);
        }
        facet.First = first + i;
        facet.Last = first + i + 1;
        large.push_back(facet);
      }
    }
    nearestOnAxis = Most(nearestOnAxis, lanes.NearestOnAxis);
  }
  if (waiting.Size > 0)
  {
    this->AddOutline(waiting);
  }
  double inverse = 0.0;
  for (std::size_t i = 0; i < Width; ++i)
  {
    inverse = std::max(inverse, nearestOnAxis[i]);
  }
  crowd.NearestPlane = inverse > 0.0 ? (1 - Rounding) / inverse : HUGE_VAL;
  return crowd;
}

//------------------------------------------------------------------------------
void FootprintFaces::Sort()
{
  const std::size_t count = this->Faces.size();
  this->Keys.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Keys[i] = { -this->Faces[i].Maximum, i };
  }
  std::sort(this->Keys.begin(), this->Keys.end(),
    [this](const auto& a, const auto& b)
    {
      return a.first < b.first ||
        (a.first == b.first && this->Faces[a.second].Cell < this->Faces[b.second].Cell);
    });
  this->Order.resize(count);
  std::transform(this->Keys.begin(), this->Keys.end(), this->Order.begin(),
    [](const std::pair<double, std::size_t>& key) { return key.second; });
}

} // namespace helios
