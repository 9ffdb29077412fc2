// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of polygons: areas by the formulas of the shapes.
#include "heliosPolygonTriangulator.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

using helios::PolygonRings;
using helios::PolygonTriangulator;
using helios::Vec3;

namespace
{

/// Vertices, and the sum of the areas of the triangles made of them.
struct Shape
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

  /// The area of all triangles along a normal: negative for those that face away.
  double GetArea(const Vec3& normal)
  {
    this->IsSimple = this->Triangulator.Triangulate(this->Points.front().GetData(), this->Rings);
    double area = 0.0;
    const std::vector<vtkTypeInt32>& corners = this->Triangulator.GetCorners();
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      const auto point = [&](std::size_t k)
      { return this->Points[static_cast<std::size_t>(corners[i + k])]; };
      area += 0.5 * (point(1) - point(0)).Cross(point(2) - point(0)).Dot(normal);
    }
    return area;
  }

  /// The number of triangles over a place, seen from above.
  int CountAt(double x, double y) const
  {
    int count = 0;
    const std::vector<vtkTypeInt32>& corners = this->Triangulator.GetCorners();
    for (std::size_t i = 0; i < corners.size(); i += 3)
    {
      bool isInside = true;
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Vec3 a = this->Points[static_cast<std::size_t>(corners[i + k])];
        const Vec3 b = this->Points[static_cast<std::size_t>(corners[i + (k + 1) % 3])];
        isInside = isInside && (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) > 0.0;
      }
      count += isInside;
    }
    return count;
  }
};

std::vector<Vec3> MakeSquare(double x, double y, double side)
{
  return { { x, y, 0 }, { x + side, y, 0 }, { x + side, y + side, 0 }, { x, y + side, 0 } };
}

const Vec3 Up(0.0, 0.0, 1.0);

} // namespace

TEST_CASE("PolygonTriangulator: convex polygons become fans", "[PolygonTriangulator]")
{
  Shape shape;
  shape.AddRing({ { 0, 0, 0 }, { 2, 0, 0 }, { 3, 1, 0 }, { 2, 2, 0 }, { 0, 2, 0 } });
  CHECK(shape.GetArea(Up) == Approx(5.0));
  CHECK(shape.IsSimple);
  CHECK(shape.Triangulator.GetCorners() == std::vector<vtkTypeInt32>{ 0, 1, 2, 0, 2, 3, 0, 3, 4 });
}

TEST_CASE("PolygonTriangulator: concave polygons are covered once", "[PolygonTriangulator]")
{
  Shape shape; // a U: the fan about its first corner would cover the gap
  shape.AddRing({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 2, 3, 0 }, { 2, 1, 0 }, { 1, 1, 0 },
    { 1, 3, 0 }, { 0, 3, 0 } });
  CHECK(shape.GetArea(Up) == Approx(7.0));
  CHECK(shape.IsSimple);
  CHECK(shape.CountAt(1.51, 2.02) == 0);
  CHECK(shape.CountAt(0.51, 2.02) == 1);
}

TEST_CASE("PolygonTriangulator: holes of either winding are left open", "[PolygonTriangulator]")
{
  for (const bool isReversed : { false, true })
  {
    Shape shape;
    shape.AddRing(MakeSquare(0, 0, 10));
    shape.AddRing(MakeSquare(1, 1, 2));
    shape.AddRing(MakeSquare(6, 5, 3));
    if (isReversed)
    {
      std::reverse(shape.Rings[1].begin(), shape.Rings[1].end());
    }
    CHECK(shape.GetArea(Up) == Approx(100.0 - 4.0 - 9.0));
    CHECK(shape.IsSimple);
    CHECK(shape.CountAt(2.01, 1.52) == 0);
    CHECK(shape.CountAt(7.01, 6.52) == 0);
    CHECK(shape.CountAt(4.51, 4.02) == 1);
  }
}

TEST_CASE("PolygonTriangulator: walls and roofs at map coordinates", "[PolygonTriangulator]")
{
  Shape wall; // 4 m by 3 m with a window of 1 m by 1 m, facing -y
  const Vec3 at(5e5, 5.5e6, 100.0);
  const auto add = [&](std::vector<Vec3> ring)
  {
    for (Vec3& p : ring)
    {
      p = at + Vec3(p[0], 0.0, p[1]);
    }
    wall.AddRing(ring);
  };
  add({ { 0, 0, 0 }, { 4, 0, 0 }, { 4, 3, 0 }, { 0, 3, 0 } });
  add({ { 1, 1, 0 }, { 1, 2, 0 }, { 2, 2, 0 }, { 2, 1, 0 } });
  CHECK(wall.GetArea({ 0.0, -1.0, 0.0 }) == Approx(11.0).epsilon(1e-9));
  CHECK(wall.IsSimple);

  Shape roof; // not quite plane
  roof.AddRing({ at, at + Vec3(4, 0, 0.001), at + Vec3(4, 4, 2), at + Vec3(2, 1, 0.5),
    at + Vec3(0, 4, 2.001) });
  CHECK(roof.GetArea(Up) == Approx(10.0));
  CHECK(roof.IsSimple);
}

TEST_CASE("PolygonTriangulator: random stars are covered once", "[PolygonTriangulator]")
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> radius(0.2, 1.0);
  for (int run = 0; run < 300; ++run)
  {
    std::vector<Vec3> ring;
    const int count = 4 + run % 60;
    double expected = 0.0;
    for (int i = 0; i < count; ++i)
    {
      const double r = radius(random);
      const double angle = 2.0 * vtkMath::Pi() * i / count;
      ring.emplace_back(r * std::cos(angle), r * std::sin(angle), 0.0);
    }
    for (int i = 0; i < count; ++i)
    {
      const Vec3& a = ring[static_cast<std::size_t>(i)];
      const Vec3& b = ring[static_cast<std::size_t>((i + 1) % count)];
      expected += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    Shape shape;
    shape.AddRing(ring);
    INFO("run " << run);
    CHECK(shape.GetArea(Up) == Approx(expected));
    CHECK(shape.IsSimple);
    CHECK(shape.Triangulator.GetCorners().size() == static_cast<std::size_t>(3 * (count - 2)));
  }
}

TEST_CASE("PolygonTriangulator: polygons that cross are reported", "[PolygonTriangulator]")
{
  Shape crossed; // a bow tie with unequal halves
  crossed.AddRing({ { 0, 0, 0 }, { 3, 2, 0 }, { 3, 0, 0 }, { 0, 1, 0 } });
  crossed.GetArea(Up);
  CHECK_FALSE(crossed.IsSimple);

  Shape outside; // a hole beside its polygon
  outside.AddRing(MakeSquare(0, 0, 2));
  outside.AddRing(MakeSquare(5, 5, 1));
  outside.GetArea(Up);
  CHECK_FALSE(outside.IsSimple);
}

TEST_CASE("PolygonTriangulator: repeated vertices and flat rings", "[PolygonTriangulator]")
{
  Shape shape;
  shape.AddRing(MakeSquare(0, 0, 2));
  shape.Rings[0] = { 0, 0, 1, 1, 2, 3, 3, 0 };
  CHECK(shape.GetArea(Up) == Approx(4.0));
  CHECK(shape.IsSimple);
  CHECK(shape.Triangulator.GetCorners().size() == 6);

  Shape flat;
  flat.AddRing({ { 0, 0, 0 }, { 1, 1, 0 }, { 2, 2, 0 } });
  CHECK(flat.GetArea(Up) == 0.0);
  CHECK(flat.IsSimple);
  CHECK(flat.Triangulator.GetCorners().empty());
  flat.Rings = { { 0, 1 } };
  CHECK(flat.GetArea(Up) == 0.0);
  CHECK(flat.IsSimple);
}
