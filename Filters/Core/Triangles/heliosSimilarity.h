// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rotation, uniform scale and translation of meshes.

#ifndef heliosSimilarity_h
#define heliosSimilarity_h

#include "heliosPose.h"

namespace helios
{

/// Maps a point p to R p s + t; with a pivot c to (c + R (p - c)) s + t. Identity components are
/// skipped to keep precision.
struct Similarity
{
  bool HasRotation = false;
  bool HasPivot = false;
  Rotation Turn; ///< or a reflection
  double Scale = 1.0;
  Vec3 Translation{ 0.0, 0.0, 0.0 };
  Vec3 Pivot{ 0.0, 0.0, 0.0 };

  Similarity() = default;
  /// Sets a quaternion (w, x, y, z) of any length but 0, a scale and a translation.
  Similarity(const double quaternion[4], double scale, const double translation[3])
    : HasRotation(quaternion[1] != 0.0 || quaternion[2] != 0.0 || quaternion[3] != 0.0)
    , Scale(scale)
    , Translation(translation)
  {
    Quaternion q(quaternion[0], quaternion[1], quaternion[2], quaternion[3]);
    q.Normalize();
    this->Turn = Rotation(q);
  }

  bool IsIdentity() const
  {
    return !this->HasRotation && this->Scale == 1.0 && this->Translation == Vec3(0.0, 0.0, 0.0);
  }

  void Apply(const double in[3], double out[3]) const
  {
    Vec3 p(in);
    if (this->HasPivot)
    {
      p = this->Pivot + this->Turn * (p - this->Pivot);
    }
    else if (this->HasRotation)
    {
      p = this->Turn * p;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      out[axis] = p[axis] * this->Scale + this->Translation[axis];
    }
  }

  /// Returns the rotated vector.
  Vec3 Rotate(const Vec3& v) const { return this->HasRotation ? this->Turn * v : v; }

  /// Computes the vector R^-1 v / s.
  void ApplyInverse(const double v[3], double out[3]) const
  {
    const auto& m = this->Turn.M;
    const double inverse = 1.0 / this->Scale;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x =
        this->HasRotation ? m[0][axis] * v[0] + m[1][axis] * v[1] + m[2][axis] * v[2] : v[axis];
      out[axis] = x * inverse;
    }
  }

  /// Computes the point R^-1 (p - t) / s, or with a pivot c + R^-1 (p / s - t / s - c).
  void ApplyInverseToPoint(const double p[3], double out[3]) const
  {
    const Vec3 centre = this->HasPivot ? this->Scale * this->Pivot : Vec3(0.0, 0.0, 0.0);
    const double v[3] = { p[0] - this->Translation[0] - centre[0],
      p[1] - this->Translation[1] - centre[1], p[2] - this->Translation[2] - centre[2] };
    this->ApplyInverse(v, out);
    for (int axis = 0; axis < 3 && this->HasPivot; ++axis)
    {
      out[axis] += this->Pivot[axis];
    }
  }
};

} // namespace helios

#endif
