// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTriangleArea.h"
#include "heliosTriangleTest.h"

#include "heliosRayCastingScenes.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace
{

using helios::Dice;
using helios::Vec3;

/// 113 bits, for an exact reference also for slivers.
#ifdef __SIZEOF_FLOAT128__
using Real = __float128;
#else
using Real = long double;
#endif

struct Triangle
{
  Vec3 P[3];

  double Test(const vtkHeliosRay& ray) const
  {
    const double* points[3] = { this->P[0].GetData(), this->P[1].GetData(), this->P[2].GetData() };
    helios::TestRay prepared;
    return prepared.Set(ray) ? helios::TestTriangle(prepared, points) : helios::NoHit;
  }
  bool SpansArea() const
  {
    return helios::SpansArea(this->P[0].GetData(), this->P[1].GetData(), this->P[2].GetData());
  }
};

/// The range of the stored doubles: n . (p0 - o) / n . d.
Real GetTrueRange(const Triangle& triangle, const vtkHeliosRay& ray)
{
  const auto& p = triangle.P;
  const double* d = ray.Direction;
  Real a[3], b[3], c[3];
  for (int i = 0; i < 3; ++i)
  {
    a[i] = Real(p[1][i]) - p[0][i];
    b[i] = Real(p[2][i]) - p[0][i];
    c[i] = Real(p[0][i]) - ray.Origin[i];
  }
  const Real n[3] = { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0] };
  return (n[0] * c[0] + n[1] * c[1] + n[2] * c[2]) / (n[0] * d[0] + n[1] * d[1] + n[2] * d[2]);
}

/// A triangle, and a ray to a point in it at a range and an angle [deg] from its normal.
struct Shot
{
  Triangle Target;
  vtkHeliosRay Ray;

  /// The corners are given along two axes in the plane, relative to the point.
  Shot(Dice& dice, const Vec3& offset, double range, double degrees, const double corners[3][2])
  {
    const Vec3 n = dice.Direction();
    const Vec3 t1 = n.Cross(dice.Direction()).Normalized();
    const Vec3 t2 = n.Cross(t1);
    const double angle = vtkMath::RadiansFromDegrees(degrees);
    for (int i = 0; i < 3; ++i)
    {
      this->Target.P[i] = offset + t1 * corners[i][0] + t2 * corners[i][1];
    }
    const Vec3 direction = t1 * std::sin(angle) - n * std::cos(angle);
    this->Ray = helios::MakeRay(offset - direction * range, direction);
  }

  /// The error of a range in units of u R / cos(incidence).
  double GetError(double found, double range) const
  {
    const auto& p = this->Target.P;
    const Vec3 normal = (p[1] - p[0]).Cross(p[2] - p[0]).Normalized();
    const double cosine = std::abs(normal.Dot(Vec3(this->Ray.Direction)));
    const Real error = found - GetTrueRange(this->Target, this->Ray);
    return std::abs(static_cast<double>(error)) * cosine / (0x1p-53 * range);
  }
};

} // namespace

TEST_CASE("TriangleTest: range error within 8 u R / cos in 168 cases", "[TriangleTest]")
{
  // Offsets, ranges and angles; equilateral triangles of circumradius 0.1 R.
  Dice dice;
  double worst = 0.0;
  int misses = 0;
  for (const Vec3& offset : helios::Offsets)
  {
    for (double range : { 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5 })
    {
      for (double angle : { 0.0, 60.0, 85.0, 89.0, 89.9, 89.99, 89.999, 89.9999 })
      {
        for (int i = 0; i < 40; ++i)
        {
          const double turn = dice(0, 2 * vtkMath::Pi());
          const double x = dice(-0.2, 0.2);
          const double y = dice(-0.2, 0.2);
          double corners[3][2];
          for (int k = 0; k < 3; ++k)
          {
            corners[k][0] = 0.1 * range * (x + std::cos(turn + k * 2 * vtkMath::Pi() / 3));
            corners[k][1] = 0.1 * range * (y + std::sin(turn + k * 2 * vtkMath::Pi() / 3));
          }
          const Shot shot(dice, offset, range, angle, corners);
          const double found = shot.Target.Test(shot.Ray);
          // The rounding of world coordinates, 1e-9 m, moves some grazing rays off near triangles.
          const bool mayMiss =
            offset[0] > 0 && range * std::cos(vtkMath::RadiansFromDegrees(angle)) < 1e-7;
          misses += found == helios::NoHit && !mayMiss;
          worst = found == helios::NoHit ? worst : std::max(worst, shot.GetError(found, range));
        }
      }
    }
  }
  CHECK(misses == 0);
  CHECK(worst < 8.0); // measured: 3.1
}

TEST_CASE("TriangleTest: range error within 8 u R / cos on slivers", "[TriangleTest]")
{
  // 10 m long: needles (one short edge), flat triangles (a corner of almost 180 degrees).
  Dice dice;
  for (double width : { 1e-3, 1e-5, 1e-7, 1e-9 })
  {
    const double shapes[4][3][2] = { { { -5, 0 }, { 5, width / 2 }, { 5, -width / 2 } },
      { { -4, 0 }, { 6, 0 }, { -4, width } }, { { -5, 0 }, { 1, width }, { 5, 0 } },
      { { -5, 0 }, { 5, 0 }, { 4.9, width } } };
    for (const auto& shape : shapes)
    {
      double worst = 0.0;
      int hits = 0;
      for (int i = 0; i < 200; ++i)
      {
        const double weights[3] = { dice(0.2, 1), dice(0.2, 1), dice(0.2, 1) };
        const double sum = weights[0] + weights[1] + weights[2];
        double corners[3][2];
        for (int k = 0; k < 2; ++k)
        {
          const double centre =
            (weights[0] * shape[0][k] + weights[1] * shape[1][k] + weights[2] * shape[2][k]) / sum;
          for (int j = 0; j < 3; ++j)
          {
            corners[j][k] = shape[j][k] - centre;
          }
        }
        const Shot shot(dice, helios::Offsets[0], 10, dice(0, 80), corners);
        const double found = shot.Target.Test(shot.Ray);
        hits += found < helios::NoHit;
        worst = std::max(worst, shot.GetError(found, 10));
      }
      INFO("width " << width << ", shape " << &shape - shapes);
      CHECK(hits == 200);
      CHECK(worst < 8.0);
    }
  }
}

TEST_CASE("TriangleTest: the sign of a difference of products is exact", "[TriangleTest]")
{
  const double e = 0x1p-52;
  CHECK((1 + e) * (1 - e) == 1.0);
  CHECK(helios::GetSignOfTie(1 + e, 1 - e, 1, 1) == -1);
  CHECK(helios::GetSignOfTie(1, 1, 1 + e, 1 - e) == 1);
  CHECK(helios::GetSignOfTie(0.1, 0.3, 0.3, 0.1) == 0);
  CHECK(helios::GetSignOfTie(-(1 + e), 1 - e, -1, 1) == 1);
}

TEST_CASE("TriangleTest: degeneracy is decided exactly", "[TriangleTest]")
{
  Dice dice;
  for (int i = 0; i < 1000; ++i)
  {
    const Vec3 p = helios::Offsets[i % 3] + dice.Point(-1, 1);
    const Vec3 step(std::round(dice(-9, 9)), std::round(dice(-9, 9)), 1.0 + std::round(dice(0, 9)));
    const Vec3 a(std::round(p[0] * 64), std::round(p[1] * 64), std::round(p[2] * 64));
    Triangle straight{ { a, a + step * 3.0, a - step * 7.0 } };
    CHECK_FALSE(straight.SpansArea());
    CHECK_FALSE(Triangle{ { p, p, a } }.SpansArea());
    const int axis = i % 2;
    straight.P[1][axis] = std::nextafter(straight.P[1][axis], 1e300);
    CHECK(straight.SpansArea());
  }
}

TEST_CASE(
  "TriangleTest: both sides are hit, ranges are in lengths of the direction", "[TriangleTest]")
{
  const Triangle wall{ { { 3, -1, -1 }, { 3, 1, -1 }, { 3, 0, 2 } } };
  const Triangle back{ { wall.P[0], wall.P[2], wall.P[1] } };
  for (double length : { 1e-90, 0.5, 1.0, 4.0, 1e90 })
  {
    const vtkHeliosRay ray = helios::MakeRay({ 0, 0, 0 }, { length, 0, 0 });
    CHECK(wall.Test(ray) == Approx(3 / length).epsilon(1e-15));
    CHECK(back.Test(ray) == wall.Test(ray));
  }
  CHECK(wall.Test(helios::MakeRay({ 6, 0, 0 }, { 1, 0, 0 })) == helios::NoHit);
  CHECK(wall.Test(helios::MakeRay({ 3, 0, 0 }, { 1, 0, 0 })) == helios::NoHit);
  CHECK(wall.Test(helios::MakeRay({ 0, 0, 0 }, { 1, 0, 0 }, 3.0)) == 3.0);
  CHECK(wall.Test(helios::MakeRay({ 0, 0, 0 }, { 1, 0, 0 }, 2.99)) == helios::NoHit);
}

TEST_CASE(
  "TriangleTest: an edge-on triangle is hit within its box, or not at all", "[TriangleTest]")
{
  Dice dice;
  int hits = 0;
  int outside = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const Vec3 along = dice.Direction();
    const Vec3 across = along.Cross(dice.Direction());
    const Vec3 target = dice.Point(-1, 1);
    const Triangle t{ { target, target + along * dice() + across * 0.3, target + along - across } };
    const Vec3 origin = target - along * 2.0;
    const double range = t.Test(helios::MakeRay(origin, along));
    hits += range < helios::NoHit;
    for (int axis = 0; axis < 3 && range < helios::NoHit; ++axis)
    {
      const double hit = origin[axis] + range * along[axis];
      outside += hit < std::min({ t.P[0][axis], t.P[1][axis], t.P[2][axis] }) - 1e-14;
      outside += hit > std::max({ t.P[0][axis], t.P[1][axis], t.P[2][axis] }) + 1e-14;
    }
  }
  CHECK(hits > 100);
  CHECK(outside == 0);
}
