// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPencil.h"

#include <cmath>

namespace helios
{
namespace
{

/// Returns a unit vector across both; across the second, any, if they are parallel.
Vec3 MakeSide(const Vec3& a, const Vec3& direction)
{
  constexpr double minimum = 1e-9;
  Vec3 side = a.Cross(direction);
  if (!(side.Norm() > minimum))
  {
    const Vec3 other = std::abs(direction[0]) < 0.7 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 1.0, 0.0);
    side = other.Cross(direction);
  }
  side.Normalize();
  return side;
}

} // namespace

Pencil::Pencil(const Vec3& direction, double length)
  : Side(MakeSide(direction, direction))
  , Distances{ length, length, 0.0 }
  , Area(length * length)
{
}

void Pencil::Advance(double length)
{
  const double before = this->GetDeterminant();
  this->Distances.Side += length;
  this->Distances.Other += length;
  this->Area *= this->GetDeterminant() / before;
}

void Pencil::Reflect(const Vec3& normal)
{
  this->Side = this->Side - (2.0 * this->Side.Dot(normal)) * normal;
  this->Distances.Mixed = -this->Distances.Mixed; // the frame stays right-handed
}

void Pencil::Refract(
  const Vec3& direction, const Vec3& normal, double cosine, double refracted, double indexRatio)
{
  this->TurnTo(direction, MakeSide(normal, direction)); // across the plane of incidence
  const double stretch = refracted / cosine;
  this->Distances.Side *= indexRatio;
  this->Distances.Mixed *= indexRatio * stretch;
  this->Distances.Other *= indexRatio * stretch * stretch;
  this->Area *= stretch;
}

double Pencil::GetDeterminant() const
{
  const Matrix& m = this->Distances;
  return m.Side * m.Other - m.Mixed * m.Mixed;
}

void Pencil::TurnTo(const Vec3& direction, const Vec3& side)
{
  const double c = side.Dot(this->Side);
  const double s = side.Dot(direction.Cross(this->Side));
  const Matrix m = this->Distances;
  this->Distances = { c * c * m.Side + 2.0 * c * s * m.Mixed + s * s * m.Other,
    s * s * m.Side - 2.0 * c * s * m.Mixed + c * c * m.Other,
    c * s * (m.Other - m.Side) + (c * c - s * s) * m.Mixed };
  this->Side = side;
}

} // namespace helios
