// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The spread of a pencil of rays against rays of finite distance.
#include "heliosFresnel.h"
#include "heliosPencil.h"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <vector>

using namespace helios;

namespace
{

/// A flat surface through a point; refracts to an index, or mirrors for 0.
struct Face
{
  Vec3 Point, Normal;
  double Index;
};

struct State
{
  Vec3 Origin, Direction;
  double Index = 1.0;
};

double GetLength(const State& s, const Face& face)
{
  return (face.Point - s.Origin).Dot(face.Normal) / s.Direction.Dot(face.Normal);
}

Vec3 Against(const Vec3& normal, const Vec3& direction)
{
  return normal.Dot(direction) > 0.0 ? -1.0 * normal : normal;
}

State Pass(State s, const Face& face)
{
  s.Origin = s.Origin + GetLength(s, face) * s.Direction;
  const Vec3 n = Against(face.Normal, s.Direction);
  if (face.Index == 0.0)
  {
    s.Direction = GetMirrored(s.Direction, n);
    return s;
  }
  const double cosine = GetRefractedCosine(-n.Dot(s.Direction), s.Index, face.Index);
  s.Direction = GetRefracted(s.Direction, n, s.Index, face.Index, cosine);
  s.Index = face.Index;
  return s;
}

/// Where a ray along a direction ends on a plane across the central ray's end.
Vec3 GetEnd(
  const Vec3& direction, const std::vector<Face>& faces, const Vec3& at, const Vec3& along)
{
  State s{ { 0, 0, 0 }, direction };
  for (const Face& face : faces)
  {
    s = Pass(s, face);
  }
  return s.Origin + ((at - s.Origin).Dot(along) / s.Direction.Dot(along)) * s.Direction;
}

} // namespace

TEST_CASE("Pencil: its area is that between nearby rays")
{
  Vec3 tilted(0.3, 1.0, -0.5);
  tilted.Normalize();
  Vec3 other(-0.2, 1.0, 0.3);
  other.Normalize();
  const std::vector<std::vector<Face>> scenes = {
    {},
    { { { 0, 10, 0 }, { 0, 1, 0 }, 1.33 } },
    { { { 0, 10, 0 }, tilted, 1.5 } },
    { { { 0, 10, 0 }, tilted, 1.5 }, { { 1, 14, 2 }, { 0, 1, 0 }, 1.0 } },
    { { { 0, 10, 0 }, tilted, 1.5 }, { { 0, 16, 0 }, { 0, 1, 0 }, 0.0 },
      { { 0, 11, 0 }, other, 1.0 } },
    { { { 0, 10, 0 }, tilted, 1.5 }, { { 0, 14, 0 }, other, 1.2 },
      { { 0, 18, 0 }, { 0, 1, 0 }, 0.0 }, { { 0, 11, 0 }, tilted, 1.0 } },
  };
  const std::vector<Face>& faces = GENERATE_COPY(from_range(scenes));
  Vec3 axis(0.1, 1.0, 0.2);
  axis.Normalize();
  const double beyond = 7.0;

  // The pencil.
  State s{ { 0, 0, 0 }, axis };
  Pencil pencil(axis, faces.empty() ? beyond : GetLength(s, faces.front()));
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const Vec3 n = Against(faces[i].Normal, s.Direction);
    const State next = Pass(s, faces[i]);
    if (faces[i].Index == 0.0)
    {
      pencil.Reflect(n);
    }
    else
    {
      const double cosine = -n.Dot(s.Direction);
      pencil.Refract(s.Direction, n, cosine, GetRefractedCosine(cosine, s.Index, next.Index),
        next.Index / s.Index);
    }
    s = next;
    pencil.Advance(i + 1 < faces.size() ? GetLength(s, faces[i + 1]) : beyond);
  }

  // Four rays about the axis.
  const Vec3 end = s.Origin + beyond * s.Direction;
  Vec3 u = Vec3(1, 0, 0) - axis[0] * axis;
  u.Normalize();
  const Vec3 v = axis.Cross(u);
  const double h = 1e-5;
  std::array<Vec3, 4> ends;
  for (int i = 0; i < 4; ++i)
  {
    Vec3 d = axis + (i % 2 == 0 ? h : -h) * (i < 2 ? u : v);
    d.Normalize();
    ends[static_cast<std::size_t>(i)] = GetEnd(d, faces, end, s.Direction);
  }
  const double area = (ends[0] - ends[1]).Cross(ends[2] - ends[3]).Norm() / (4.0 * h * h);
  CHECK(pencil.GetArea() == Approx(area).epsilon(1e-8));
}

TEST_CASE("Pencil: below water it has the area of the bathymetric lidar equation")
{
  const double height = 300.0, depth = 5.0, n = 1.33;
  const Vec3 down(0, 0, -1);
  Pencil pencil(down, height);
  pencil.Refract(down, { 0, 0, 1 }, 1.0, 1.0, n);
  pencil.Advance(depth);
  CHECK(n * n * pencil.GetArea() == Approx(std::pow(n * height + depth, 2)).epsilon(1e-14));
}
