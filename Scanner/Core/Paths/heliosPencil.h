// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How a narrow pencil of rays from one point spreads along a path.

#ifndef heliosPencil_h
#define heliosPencil_h

#include "heliosPose.h"

#include <cmath>

namespace helios
{

/**
 * Rays near a central one. Distances is the inverse of the curvature of their wavefront, a symmetric
 * matrix on two axes across the ray, Side and the one that completes a right-handed frame; Area is
 * what a unit of solid angle at the start has grown to. At flat surfaces the distances change by the
 * Coddington equations (Born and Wolf, Principles of Optics, 4.6).
 */
class Pencil
{
public:
  /// From a point along a unit vector, after a length [m].
  Pencil(const Vec3& direction, double length)
    : Side(MakeSide(direction, direction))
    , Distances{ length, length, 0.0 }
    , Area(length * length)
  {
  }

  /// The area [m2] of a unit of solid angle at the start.
  double GetArea() const { return this->Area; }

  /// Along the ray [m].
  void Advance(double length)
  {
    const double before = this->GetDeterminant();
    this->Distances.Side += length;
    this->Distances.Other += length;
    this->Area *= this->GetDeterminant() / before;
  }

  /// Mirrored at a flat surface with a unit normal.
  void Reflect(const Vec3& normal)
  {
    this->Side = this->Side - (2.0 * this->Side.Dot(normal)) * normal;
    this->Distances.Mixed = -this->Distances.Mixed; // the frame stays right-handed
  }

  /// Refracted at a flat surface: from a direction and index to others, cosines to the normal.
  void Refract(const Vec3& direction, const Vec3& normal, double cosine, double refracted,
    double indexRatio) // n2 / n1
  {
    this->TurnTo(direction, MakeSide(normal, direction)); // across the plane of incidence
    const double stretch = refracted / cosine;
    this->Distances.Side *= indexRatio;
    this->Distances.Mixed *= indexRatio * stretch;
    this->Distances.Other *= indexRatio * stretch * stretch;
    this->Area *= stretch;
  }

private:
  struct Matrix
  {
    double Side, Other, Mixed;
  };

  /// A unit vector across both; across the second, any, if they are parallel.
  static Vec3 MakeSide(const Vec3& a, const Vec3& direction)
  {
    Vec3 side = a.Cross(direction);
    constexpr double least = 1e-9;
    if (!(side.Norm() > least))
    {
      const Vec3 other = std::abs(direction[0]) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
      side = other.Cross(direction);
    }
    side.Normalize();
    return side;
  }

  double GetDeterminant() const
  {
    return this->Distances.Side * this->Distances.Other -
      this->Distances.Mixed * this->Distances.Mixed;
  }

  void TurnTo(const Vec3& direction, const Vec3& side)
  {
    const double c = side.Dot(this->Side);
    const double s = side.Dot(direction.Cross(this->Side));
    const Matrix m = this->Distances;
    this->Distances = { c * c * m.Side + 2.0 * c * s * m.Mixed + s * s * m.Other,
      s * s * m.Side - 2.0 * c * s * m.Mixed + c * c * m.Other,
      c * s * (m.Other - m.Side) + (c * c - s * s) * m.Mixed };
    this->Side = side;
  }

  Vec3 Side; // a unit vector across the ray; the other is direction x Side
  Matrix Distances;
  double Area;
};

} // namespace helios

#endif
