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
  LaneMasks IsLarge;
  LaneMasks IsFace;

  HELIOS_INLINE void Set(
    const ConeTriangle* triangles, std::size_t size, const BeamEllipse& ellipse, double tangent);
  HELIOS_INLINE void SetPlane(const Lane p[3][3], double tangent);
};

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
/// Adds the triangles of lanes.
HELIOS_INLINE void FootprintFaces::AddLanes(
  const ConeTriangle* triangles, const Lanes& lanes, std::size_t size)
{
  for (std::size_t i = 0; i < size; ++i)
  {
    if (lanes.IsFace[i] == 0)
    {
      continue;
    }
    const double x[3] = { lanes.X[0][i], lanes.X[1][i], lanes.X[2][i] };
    const double y[3] = { lanes.Y[0][i], lanes.Y[1][i], lanes.Y[2][i] };
    Face face;
    face.Inverse = { lanes.GX[i], lanes.GY[i], lanes.One[i] };
    face.Minimum = lanes.Minimum[i];
    face.Maximum = lanes.Maximum[i];
    face.Cell = triangles[i].Cell;
    face.Low = static_cast<float>(std::min({ y[0], y[1], y[2] }));
    face.High = static_cast<float>(std::max({ y[0], y[1], y[2] }));
    face.FirstLine = static_cast<int>(this->Lines.size());
    face.Left = 0;
    face.Right = 0;
    const bool isTurned = lanes.Area[i] < 0.0;
    for (const bool isRight : { false, true })
    {
      for (int edge = 0; edge < 3; ++edge)
      {
        const int next = edge < 2 ? edge + 1 : 0;
        const bool isUp = y[edge] < y[next];
        if ((isUp != isTurned) == isRight && y[edge] != y[next])
        {
          const int from = isUp ? edge : next;
          this->Lines.push_back({ static_cast<float>(x[from]), static_cast<float>(y[from]),
            static_cast<float>(lanes.Slopes[edge][i]) });
          ++(isRight ? face.Right : face.Left);
        }
      }
    }
    this->Faces.push_back(face);
  }
}

//------------------------------------------------------------------------------
HELIOS_CLONES
Crowd FootprintFaces::AddTriangles(
  const ConeView& view, const BeamEllipse& ellipse, double tangent, std::vector<Facet>& large)
{
  Crowd crowd;
  large.clear();
  double last[3] = { 0.0, 0.0, 0.0 }; // normal
  const std::size_t count = view.Triangles.size();
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
    this->AddLanes(triangles, lanes, size);
  }
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
