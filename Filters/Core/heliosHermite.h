// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Cubic interpolation between two samples of a motion, from positions and velocities.

#ifndef heliosHermite_h
#define heliosHermite_h

#include "heliosPose.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace helios
{

/**
 * The cubic Hermite polynomial of two positions and velocities, as a straight line plus a bending
 * term: at s in [0, 1], P0 + s (D + (1 - s) ((1 - s) B0 - s B1)) with D = P1 - P0, B = h V - D, h
 * the time step. It is exactly the straight line if B is only rounding error.
 */
class HermiteSegment
{
public:
  HermiteSegment() = default;

  /// Creates a straight segment.
  HermiteSegment(const Vec3& p0, const Vec3& p1)
    : Start(p0)
    , Way(p1 - p0)
  {
  }

  /// Sets the ends: times, positions and velocities.
  HermiteSegment(
    double t0, const Vec3& p0, const Vec3& v0, double t1, const Vec3& p1, const Vec3& v1)
    : HermiteSegment(p0, p1)
  {
    this->Bend0 = (t1 - t0) * v0 - this->Way;
    this->Bend1 = (t1 - t0) * v1 - this->Way;
    for (int k = 0; k < 3; ++k)
    {
      const double speed = std::max(std::abs(v0[k]), std::abs(v1[k]));
      const double terms = std::max(std::abs(p0[k]), std::abs(p1[k])) + speed * std::abs(t1);
      const double bend = std::max(std::abs(this->Bend0[k]), std::abs(this->Bend1[k]));
      this->Bends = this->Bends || bend > 8.0 * std::numeric_limits<double>::epsilon() * terms;
    }
  }

  Vec3 operator()(double s) const
  {
    if (!this->Bends)
    {
      return this->Start + s * this->Way;
    }
    const double r = 1.0 - s;
    return this->Start + s * (this->Way + r * (r * this->Bend0 - s * this->Bend1));
  }

  /// Returns the derivative.
  Vec3 GetSlope(double s) const
  {
    const double r = 1.0 - s;
    return this->Bends
      ? this->Way + r * (r - 2.0 * s) * this->Bend0 - s * (2.0 * r - s) * this->Bend1
      : this->Way;
  }

  /// Returns a bound of the length of the derivative.
  double GetSteepest() const
  {
    return this->Way.Norm() + (this->Bends ? this->Bend0.Norm() + this->Bend1.Norm() : 0.0);
  }

private:
  Vec3 Start{ 0.0, 0.0, 0.0 };
  Vec3 Way{ 0.0, 0.0, 0.0 };
  Vec3 Bend0{ 0.0, 0.0, 0.0 };
  Vec3 Bend1{ 0.0, 0.0, 0.0 };
  bool Bends = false;
};

} // namespace helios

#endif
