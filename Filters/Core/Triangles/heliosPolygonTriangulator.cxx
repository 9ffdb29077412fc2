// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPolygonTriangulator.h"

#include "heliosTriangleArea.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace helios
{

namespace
{

constexpr double AreaTolerance = 1e-6; // relative to the area of a polygon
// Products of coordinates between these are exact as the sum of two numbers.
constexpr double SmallestCoordinate = 1e-120;
constexpr double LargestCoordinate = 1e120;
constexpr double TouchingTolerance = 1e-4; // likewise

Vec3 GetAxis(int axis)
{
  return { axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0 };
}

Vec3 GetPointOf(const double* points, vtkTypeInt32 vertex)
{
  return Vec3(points + 3 * static_cast<vtkIdType>(vertex));
}

/// Returns whether all triangles about the first corner have an area that faces along the normal,
/// within half a turn. A ring that repeats a vertex has one that has none.
bool IsFan(const double* points, const std::vector<vtkTypeInt32>& ring)
{
  if (ring.size() < 3)
  {
    return false;
  }
  const Vec3 first = GetPointOf(points, ring[0]);
  Vec3 normal(0.0, 0.0, 0.0);
  for (std::size_t i = 2; i < ring.size(); ++i)
  {
    normal =
      normal + (GetPointOf(points, ring[i - 1]) - first).Cross(GetPointOf(points, ring[i]) - first);
  }
  for (std::size_t i = 2; i < ring.size(); ++i)
  {
    const Vec3 start = GetPointOf(points, ring[1]);
    const Vec3 b = GetPointOf(points, ring[i - 1]);
    const Vec3 c = GetPointOf(points, ring[i]);
    if (!((b - first).Cross(c - first).Dot(normal) > 0.0) ||
      !((start - first).Cross(c - first).Dot(normal) > 0.0) ||
      IsFlat(first.GetData(), b.GetData(), c.GetData()))
    {
      return false;
    }
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
bool PolygonTriangulator::Triangulate(const double* points, const PolygonRings& rings)
{
  this->Corners.clear();
  this->Places.clear();
  if (rings.size() == 1 && IsFan(points, rings.front()))
  {
    this->AddFan(rings.front());
    return true;
  }
  if (!this->SetRings(points, rings))
  {
    return this->Rings.empty() || this->IsFlatRing(this->Rings.front());
  }
  const bool isSimple = this->AddInPlane();
  if (isSimple && this->IsTorn())
  {
    this->Corners.clear();
    this->Places.clear();
    this->AddFan(rings.front());
  }
  return isSimple;
}

//------------------------------------------------------------------------------
/// Copies the rings; false if the polygon has no area. Vertices equal to the previous one are left
/// out, and the last one if it equals the first.
bool PolygonTriangulator::SetRings(const double* points, const PolygonRings& rings)
{
  this->Points = points;
  this->Vertices.clear();
  this->Rings.clear();
  this->Area = 0.0;
  for (const std::vector<vtkTypeInt32>& given : rings)
  {
    std::vector<int> ring(given.size());
    std::iota(ring.begin(), ring.end(), static_cast<int>(this->Vertices.size()));
    this->Vertices.insert(this->Vertices.end(), given.begin(), given.end());
    const auto isSame = [this](int a, int b) { return this->Vertices[a] == this->Vertices[b]; };
    ring.erase(std::unique(ring.begin(), ring.end(), isSame), ring.end());
    while (ring.size() > 1 && isSame(ring.front(), ring.back()))
    {
      ring.pop_back();
    }
    Vec3 vector = this->GetAreaVector(ring);
    if (this->Rings.empty())
    {
      this->Area = 0.5 * vector.Normalize();
      this->Normal = vector;
      this->Rings.push_back(ring);
    }
    else if (const double area = 0.5 * vector.Dot(this->Normal); area != 0.0)
    {
      this->Area -= std::abs(area);
      this->Rings.push_back(ring);
    }
  }
  return this->Area > 0.0 && !this->IsFlatRing(this->Rings.front());
}

//------------------------------------------------------------------------------
bool PolygonTriangulator::IsFlatRing(const std::vector<int>& ring) const
{
  for (std::size_t i = 2; i < ring.size(); ++i)
  {
    if (!IsFlat(this->GetPoint(ring[0]), this->GetPoint(ring[i - 1]), this->GetPoint(ring[i])))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void PolygonTriangulator::AddFan(const std::vector<vtkTypeInt32>& ring)
{
  const auto count = static_cast<int>(ring.size());
  for (int i = 2; i < count; ++i)
  {
    this->Corners.insert(this->Corners.end(), { ring[0], ring[i - 1], ring[i] });
    this->Places.insert(this->Places.end(), { 0, i - 1, i });
  }
}

//------------------------------------------------------------------------------
/// Adds the polygon seen along an axis, so that points on a side stay on it exactly; a polygon that
/// is not plane may cross itself there, but not along its normal.
bool PolygonTriangulator::AddInPlane()
{
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = std::abs(this->Normal[i]) > std::abs(this->Normal[axis]) ? i : axis;
  }
  const Vec3 first = GetAxis((axis + 1) % 3);
  const Vec3 second = GetAxis((axis + 2) % 3);
  const bool isForward = this->Normal[axis] > 0.0;
  if (this->AddPlanar({ 0.0, 0.0, 0.0 }, isForward ? first : second, isForward ? second : first))
  {
    return true;
  }
  const std::vector<vtkTypeInt32> corners = this->Corners;
  const std::vector<int> places = this->Places;
  Vec3 right = first.Cross(this->Normal);
  right.Normalize();
  if (this->AddPlanar(Vec3(this->GetPoint(0)), right, this->Normal.Cross(right)))
  {
    return true;
  }
  this->Corners = corners;
  this->Places = places;
  return false;
}

//------------------------------------------------------------------------------
/// Triangulates what is seen of the rings in a plane. False if they cross.
bool PolygonTriangulator::AddPlanar(const Vec3& origin, const Vec3& right, const Vec3& up)
{
  this->Corners.clear();
  this->Places.clear();
  std::vector<PlanarTriangulation::Point> seen(this->Vertices.size());
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    const Vec3 point = Vec3(this->GetPoint(static_cast<int>(i))) - origin;
    seen[i] = { point.Dot(right), point.Dot(up) };
    for (double& x : seen[i])
    {
      x = std::abs(x) < SmallestCoordinate ? 0.0 : x;
      if (!(std::abs(x) < LargestCoordinate))
      {
        return false;
      }
    }
  }
  std::vector<int> order;
  for (const std::vector<int>& ring : this->Rings)
  {
    order.insert(order.end(), ring.begin(), ring.end());
  }
  std::stable_sort(order.begin(), order.end(), [&seen](int a, int b) { return seen[a] < seen[b]; });
  std::vector<int> ids(seen.size());
  std::vector<int> places; // one place per point of the plane
  std::vector<PlanarTriangulation::Point> points;
  for (const int place : order)
  {
    if (points.empty() || points.back() != seen[place])
    {
      points.push_back(seen[place]);
      places.push_back(place);
    }
    ids[place] = static_cast<int>(points.size()) - 1;
  }
  this->Plane.Build(std::move(points));
  for (const std::vector<int>& ring : this->Rings)
  {
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      this->Plane.AddSide(ids[ring[i]], ids[ring[(i + 1) % ring.size()]]);
    }
  }
  const std::vector<int> inside = this->Plane.FindInside();
  for (std::size_t i = 0; i < inside.size(); i += 3)
  {
    this->AddTriangle(places[inside[i]], places[inside[i + 1]], places[inside[i + 2]]);
  }
  const double detour = this->Plane.GetDetourArea();
  return detour <= TouchingTolerance * this->Area &&
    std::abs(this->ComputeTriangleArea() - this->Area) <= AreaTolerance * this->Area + detour;
}

//------------------------------------------------------------------------------
/// Corners on a line leave triangles between them that have no area but for rounding.
void PolygonTriangulator::AddTriangle(int a, int b, int c)
{
  if (!IsFlat(this->GetPoint(a), this->GetPoint(b), this->GetPoint(c)))
  {
    this->Corners.insert(
      this->Corners.end(), { this->Vertices[a], this->Vertices[b], this->Vertices[c] });
    this->Places.insert(this->Places.end(), { a, b, c });
  }
}

//------------------------------------------------------------------------------
/// Computes the area seen along the normal; triangles that overlap count twice.
double PolygonTriangulator::ComputeTriangleArea() const
{
  double area = 0.0;
  for (std::size_t i = 0; i < this->Places.size(); i += 3)
  {
    const int* c = this->Places.data() + i;
    area += 0.5 * std::abs(this->GetCross(c[0], c[1], c[2]).Dot(this->Normal));
  }
  return area;
}

//------------------------------------------------------------------------------
/// Returns whether the triangles do not have the sides of a polygon that is far from plane: a
/// corner is on a side seen along the normal, but not in space.
bool PolygonTriangulator::IsTorn() const
{
  Vec3 sum(0.0, 0.0, 0.0);
  for (std::size_t i = 0; i < this->Places.size(); i += 3)
  {
    const int* c = this->Places.data() + i;
    sum = sum + 0.5 * this->GetCross(c[0], c[1], c[2]);
  }
  return this->Rings.size() == 1 &&
    (sum - this->Area * this->Normal).Norm() >
    TouchingTolerance * this->Area + this->Plane.GetDetourArea();
}

//------------------------------------------------------------------------------
const double* PolygonTriangulator::GetPoint(int place) const
{
  return this->Points + 3 * static_cast<vtkIdType>(this->Vertices[place]);
}

//------------------------------------------------------------------------------
Vec3 PolygonTriangulator::GetSide(int from, int to) const
{
  return Vec3(this->GetPoint(to)) - Vec3(this->GetPoint(from));
}

//------------------------------------------------------------------------------
/// Returns twice the area of a triangle as a vector along its normal.
Vec3 PolygonTriangulator::GetCross(int a, int b, int c) const
{
  return this->GetSide(a, b).Cross(this->GetSide(a, c));
}

//------------------------------------------------------------------------------
/// Returns twice the area of a ring as a vector (Newell), computed relative to its first vertex.
Vec3 PolygonTriangulator::GetAreaVector(const std::vector<int>& ring) const
{
  Vec3 sum(0.0, 0.0, 0.0);
  for (std::size_t i = 2; i < ring.size(); ++i)
  {
    sum = sum + this->GetCross(ring[0], ring[i - 1], ring[i]);
  }
  return sum;
}

} // namespace helios
