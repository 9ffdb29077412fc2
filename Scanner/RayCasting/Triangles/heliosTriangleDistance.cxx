// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTriangleDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

namespace
{

/// Returns whether a point projects into a triangle along its normal.
bool IsOver(const Vec3& p, const Vec3 corners[3], const Vec3& normal)
{
  for (int i = 0; i < 3; ++i)
  {
    const Vec3 edge = corners[(i + 1) % 3] - corners[i];
    if (edge.Cross(p - corners[i]).Dot(normal) < 0.0)
    {
      return false;
    }
  }
  return true;
}

} // namespace

// Computes the distance of two segments (Ericson 2005, Real-Time Collision Detection, 5.1.9).
double SegmentToSegment(const Vec3& a0, const Vec3& b0, const Vec3& a1, const Vec3& b1)
{
  const Vec3 d0 = b0 - a0;
  const Vec3 d1 = b1 - a1;
  const Vec3 r = a0 - a1;
  const double l0 = d0.SquaredNorm();
  const double l1 = d1.SquaredNorm();
  const double f = d1.Dot(r);
  const double c = d0.Dot(r);
  double s = 0.0;
  double t = 0.0;
  if (l1 > 0.0)
  {
    const double b = d0.Dot(d1);
    const double area = d0.Cross(d1).SquaredNorm(); // l0 l1 - b^2 without its rounding
    s = area > 0.0 ? std::clamp((b * f - c * l1) / area, 0.0, 1.0) : 0.0;
    t = (b * s + f) / l1;
  }
  if (!(t >= 0.0 && t <= 1.0) || !(l1 > 0.0))
  {
    t = std::clamp(t, 0.0, 1.0);
    s = l0 > 0.0 ? std::clamp((t * d0.Dot(d1) - c) / l0, 0.0, 1.0) : 0.0;
  }
  return (r + s * d0 - t * d1).Norm();
}

double SegmentToTriangle(const Vec3& a, const Vec3& b, const Vec3 corners[3])
{
  double distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    distance = std::min(distance, SegmentToSegment(a, b, corners[i], corners[(i + 1) % 3]));
  }
  const Vec3 cross = (corners[1] - corners[0]).Cross(corners[2] - corners[0]);
  const double length = cross.Norm();
  if (!(length > 0.0))
  {
    return distance;
  }
  const Vec3 normal = (1.0 / length) * cross;
  const double heightA = normal.Dot(a - corners[0]);
  const double heightB = normal.Dot(b - corners[0]);
  const bool crosses = heightA * heightB < 0.0;
  if (crosses && IsOver(a + heightA / (heightA - heightB) * (b - a), corners, normal))
  {
    return 0.0;
  }
  distance = IsOver(a, corners, normal) ? std::min(distance, std::abs(heightA)) : distance;
  return IsOver(b, corners, normal) ? std::min(distance, std::abs(heightB)) : distance;
}

} // namespace helios
