// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Triangles of polygons: areas by the formulas of the shapes.
#include "heliosPolygonTesting.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <vector>

using Shape = helios::PolygonShape;
using helios::Vec3;

namespace
{

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

TEST_CASE("PolygonTriangulator: rings that touch themselves", "[PolygonTriangulator]")
{
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 4, 0, 0 }, { 4, 4, 0 }, { 0, 4, 0 },
    { 1, 1, 0 }, { 3, 1, 0 }, { 3, 3, 0 }, { 1, 3, 0 } };
  Shape keyhole; // a side to the hole and back
  keyhole.Points = points;
  keyhole.Rings = { { 0, 1, 2, 3, 0, 4, 7, 6, 5, 4 } };
  CHECK(keyhole.GetArea(Up) == Approx(12.0).epsilon(1e-12));
  CHECK(keyhole.IsSimple);
  CHECK(keyhole.CountAt(2.02, 2.01) == 0);
  CHECK(keyhole.CountAt(0.52, 0.51) == 1);

  Shape pinched; // two squares that share a corner
  pinched.Points = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 4, 2, 0 }, { 4, 4, 0 }, { 2, 4, 0 },
    { 0, 2, 0 } };
  pinched.Rings = { { 0, 1, 2, 3, 4, 5, 2, 6 } };
  CHECK(pinched.GetArea(Up) == Approx(8.0).epsilon(1e-12));
  CHECK(pinched.IsSimple);
  CHECK(pinched.Triangulator.GetCorners().size() == 12);

  Shape inner; // a hole that hangs on a corner
  inner.Points = points;
  inner.Rings = { { 0, 1, 2, 3 }, { 0, 7, 6 } };
  CHECK(inner.GetArea(Up) == Approx(13.0).epsilon(1e-12));
  CHECK(inner.IsSimple);

  Shape spike; // a side to a corner and back, without area
  spike.Points = points;
  spike.Rings = { { 0, 1, 2, 6, 2, 3 } };
  CHECK(spike.GetArea(Up) == Approx(16.0).epsilon(1e-12));
  CHECK(spike.IsSimple);

  Shape wall; // a door, which shares its threshold with the wall
  wall.Points = points;
  wall.Points[4] = { 1, 0, 0 };
  wall.Points[5] = { 3, 0, 0 };
  wall.Rings = { { 0, 1, 2, 3 }, { 4, 5, 6, 7 } };
  CHECK(wall.GetArea(Up) == Approx(10.0).epsilon(1e-12));
  CHECK(wall.IsSimple);
}

TEST_CASE("PolygonTriangulator: a hole with a corner on a side", "[PolygonTriangulator]")
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.1, 0.9);
  for (int run = 0; run < 500; ++run)
  {
    const helios::PolygonPlane plane = helios::MakePlane(run, random);
    const double t = share(random); // the hole touches the side from (0, 0) to (20, 10) there
    Shape shape;
    shape.AddRing(
      { plane.Place(0, 0), plane.Place(20, 10), plane.Place(20, 30), plane.Place(0, 20) });
    shape.AddRing({ plane.Place(20 * t, 10 * t), plane.Place(20 * t + 1, 10 * t + 4),
      plane.Place(20 * t - 1, 10 * t + 4) });
    INFO("run " << run);
    CHECK(shape.GetArea(plane.GetNormal()) == Approx(400.0 - 4.0).epsilon(1e-8));
    CHECK(shape.IsSimple);
  }
}

TEST_CASE("PolygonTriangulator: a polygon that is not quite plane", "[PolygonTriangulator]")
{
  std::mt19937 random(4);
  std::normal_distribution<double> off(0.0, 0.01);
  for (int run = 0; run < 500; ++run)
  {
    const helios::PolygonPlane plane = helios::MakePlane(run, random);
    const double comb[][2] = { { 0, 0 }, { 9, 0 }, { 9, 5 }, { 7, 5 }, { 7, 1 }, { 5, 1 }, { 5, 5 },
      { 3, 5 }, { 3, 1 }, { 1, 1 }, { 1, 5 }, { 0, 5 } };
    std::vector<Vec3> ring;
    for (const auto& [x, y] : comb)
    {
      ring.push_back(plane.Place(x, y) + off(random) * plane.GetNormal());
    }
    Vec3 normal = helios::GetRingVector(ring);
    const double area = 0.5 * normal.Normalize();
    Shape shape;
    shape.AddRing(ring);
    INFO("run " << run);
    CHECK(shape.GetArea(normal) == Approx(area).epsilon(1e-9));
    CHECK(shape.IsSimple);
    CHECK(shape.GetSize() == Approx(29.0).epsilon(1e-3));
  }
}

TEST_CASE("PolygonTriangulator: polygons that cross by rounding touch", "[PolygonTriangulator]")
{
  Shape shape; // in whole millimetres, so the hole is up to half of one outside
  shape.AddRing({ { 0, 0, 0 }, { 20, 7, 0 }, { 20, 20, 0 }, { 0, 20, 0 } });
  shape.AddRing({ { 10.001, 3.5, 0 }, { 11, 6, 0 }, { 9, 6, 0 } });
  CHECK(shape.GetArea(Up) == Approx(330.0 - 2.4995).epsilon(1e-4));
  CHECK(shape.IsSimple);
}

TEST_CASE("PolygonTriangulator: all that crosses is reported", "[PolygonTriangulator]")
{
  Shape symmetric; // a bow tie: its halves cancel
  symmetric.AddRing({ { 0, 0, 0 }, { 2, 2, 0 }, { 2, 0, 0 }, { 0, 2, 0 } });
  symmetric.Triangulate();
  CHECK_FALSE(symmetric.IsSimple);

  Shape star; // five corners, each the second next
  std::vector<Vec3> ring;
  for (int i = 0; i < 5; ++i)
  {
    const double angle = 0.8 * vtkMath::Pi() * i;
    ring.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  star.AddRing(ring);
  star.Triangulate();
  CHECK_FALSE(star.IsSimple);

  Shape twice; // a square that is gone round twice
  twice.AddRing(MakeSquare(0, 0, 2));
  twice.Rings = { { 0, 1, 2, 3, 0, 1, 2, 3 } };
  twice.Triangulate();
  CHECK_FALSE(twice.IsSimple);

  Shape holes; // triangles that overlap
  holes.AddRing(MakeSquare(0, 0, 10));
  holes.AddRing(MakeSquare(1, 1, 4));
  holes.AddRing(MakeSquare(3, 3, 4));
  holes.Triangulate();
  CHECK_FALSE(holes.IsSimple);
}

TEST_CASE("PolygonTriangulator: ends for any rings", "[PolygonTriangulator]")
{
  std::mt19937 random(5);
  const double values[] = { 0.0, 1.0, 2.0, -1.0, 1e-300, 1e160, -1e300, 3.5, 0.1, 0.3 };
  int crossed = 0;
  for (int run = 0; run < 3000; ++run)
  {
    std::uniform_int_distribution<int> choose(0, run % 3 ? 3 : 9);
    std::uniform_int_distribution<int> pick(0, 9);
    Shape shape;
    for (int i = 0; i < 10; ++i)
    {
      const double z = run % 2 ? 0.0 : values[choose(random)];
      shape.Points.emplace_back(values[choose(random)], values[choose(random)], z);
    }
    shape.Rings.resize(static_cast<std::size_t>(1 + run % 3));
    for (std::vector<vtkTypeInt32>& ring : shape.Rings)
    {
      ring.resize(static_cast<std::size_t>(2 + run % 17));
      std::generate(ring.begin(), ring.end(), [&] { return pick(random); });
    }
    shape.Triangulate();
    crossed += !shape.IsSimple;
    const std::vector<vtkTypeInt32>& corners = shape.Triangulator.GetCorners();
    CHECK(corners.size() % 3 == 0);
    CHECK(std::all_of(corners.begin(), corners.end(), [](int i) { return i >= 0 && i < 10; }));
  }
  CHECK(crossed > 1000);
}

TEST_CASE("PolygonTriangulator: a comb of 20,000 corners", "[PolygonTriangulator]")
{
  std::vector<Vec3> ring{ { 0, -1, 0 } };
  constexpr int teeth = 10000;
  for (int i = 0; i < teeth; ++i)
  {
    ring.emplace_back(i + 0.5, 10.0, 0.0);
    ring.emplace_back(i + 1.0, 0.0, 0.0);
  }
  ring.back() = { teeth, -1, 0 };
  std::reverse(ring.begin(), ring.end());
  Shape shape;
  shape.AddRing(ring);
  const double expected = 0.5 * helios::GetRingVector(ring)[2];
  CHECK(shape.GetArea(Up) == Approx(expected).epsilon(1e-9));
  CHECK(shape.IsSimple);
}

TEST_CASE("PolygonTriangulator: a folded polygon keeps its sides", "[PolygonTriangulator]")
{
  Shape shape; // seen along its normal, the last corner is on the third side
  shape.AddRing({ { -5, 0, 5 }, { 5, 0, 5 }, { 5, 0, -5 }, { -5, 0, -5 }, { 0, 5, -5 } });
  shape.Triangulate();
  CHECK(shape.IsSimple);
  CHECK(shape.GetSize() == Approx(100.0 + 25.0 * std::sqrt(2.0)));
  CHECK(shape.Triangulator.GetPlaces() == std::vector<int>{ 0, 1, 2, 0, 2, 3, 0, 3, 4 });
}
