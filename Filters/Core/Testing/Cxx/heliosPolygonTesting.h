// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Polygons of tests, and what their triangles cover.

#ifndef heliosPolygonTesting_h
#define heliosPolygonTesting_h

#include "heliosPolygonTriangulator.h"

#include <cmath>
#include <random>
#include <vector>

namespace helios
{

/// Vertices and rings, and the sum of the areas of the triangles made of them.
struct PolygonShape
{
  std::vector<Vec3> Points;
  PolygonRings Rings;
  PolygonTriangulator Triangulator;
  bool IsSimple = false;

  void AddRing(const std::vector<Vec3>& ring)
  {
    this->Rings.emplace_back();
    for (const Vec3& point : ring)
    {
      this->Rings.back().push_back(static_cast<vtkTypeInt32>(this->Points.size()));
      this->Points.push_back(point);
    }
  }

  const double* GetPoints() const { return this->Points.front().GetData(); }

  void Triangulate()
  {
    this->IsSimple = this->Triangulator.Triangulate(this->GetPoints(), this->Rings);
  }

  Vec3 GetCorner(std::size_t i) const
  {
    return this->Points[static_cast<std::size_t>(this->Triangulator.GetCorners()[i])];
  }

  /// The area of all triangles along a normal: negative for those that face away.
  double GetArea(const Vec3& normal)
  {
    this->Triangulate();
    double area = 0.0;
    for (std::size_t i = 0; i < this->Triangulator.GetCorners().size(); i += 3)
    {
      const Vec3 a = this->GetCorner(i);
      area += 0.5 * (this->GetCorner(i + 1) - a).Cross(this->GetCorner(i + 2) - a).Dot(normal);
    }
    return area;
  }

  /// Likewise, but of all triangles the size: more than GetArea() if some face away.
  double GetSize() const
  {
    double area = 0.0;
    for (std::size_t i = 0; i < this->Triangulator.GetCorners().size(); i += 3)
    {
      const Vec3 a = this->GetCorner(i);
      area += 0.5 * (this->GetCorner(i + 1) - a).Cross(this->GetCorner(i + 2) - a).Norm();
    }
    return area;
  }

  /// The number of triangles over a place, seen from above.
  int CountAt(double x, double y) const
  {
    int count = 0;
    for (std::size_t i = 0; i < this->Triangulator.GetCorners().size(); i += 3)
    {
      bool isInside = true;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Vec3 a = this->GetCorner(i + k);
        const Vec3 b = this->GetCorner(i + (k + 1) % 3);
        isInside = isInside && (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) > 0.0;
      }
      count += isInside;
    }
    return count;
  }
};

/// Twice the area of a ring as a vector, from its sides relative to its first corner.
inline Vec3 GetRingVector(const std::vector<Vec3>& ring)
{
  Vec3 sum(0.0, 0.0, 0.0);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    sum = sum + (ring[i] - ring[0]).Cross(ring[(i + 1) % ring.size()] - ring[0]);
  }
  return sum;
}

/// A place in space for polygons of a plane.
struct PolygonPlane
{
  Vec3 Origin{ 0.0, 0.0, 0.0 };
  Vec3 Right{ 1.0, 0.0, 0.0 };
  Vec3 Up{ 0.0, 1.0, 0.0 };

  Vec3 Place(double x, double y) const { return this->Origin + x * this->Right + y * this->Up; }
  Vec3 GetNormal() const { return this->Right.Cross(this->Up); }
};

/// Planes of any direction, some of them along axes, at map coordinates, local ones, and so on.
inline PolygonPlane MakePlane(int run, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  const Vec3 origins[] = { { 0, 0, 0 }, { 478233.5, 5471966.7, 120.25 }, { 4e6, 6e5, 4.9e6 } };
  PolygonPlane plane;
  plane.Origin = origins[run % 3];
  if (run % 4 > 0)
  {
    plane.Right = { normal(random), normal(random), normal(random) };
    plane.Right.Normalize();
    plane.Up = plane.Right.Cross(Vec3(normal(random), normal(random), normal(random)));
    plane.Up.Normalize();
  }
  return plane;
}

} // namespace helios

#endif
