// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Rotations and poses. Body and scanner frames: x right, y forward, z up.

#ifndef heliosPose_h
#define heliosPose_h

#include <vtkMath.h>
#include <vtkQuaternion.h>
#include <vtkVector.h>
#include <vtkVectorOperators.h>

#include <cmath>

namespace helios
{

using Vec3 = vtkVector3d;
using Quaternion = vtkQuaterniond; // w, x, y, z

/// A rotation as a matrix, for inner loops.
struct Rotation
{
  double M[3][3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

  Rotation() = default;
  explicit Rotation(const Quaternion& q) { q.ToMatrix3x3(this->M); }

  Vec3 operator*(const Vec3& v) const
  {
    const auto& m = this->M;
    return { m[0][0] * v[0] + m[0][1] * v[1] + m[0][2] * v[2],
      m[1][0] * v[0] + m[1][1] * v[1] + m[1][2] * v[2],
      m[2][0] * v[0] + m[2][1] * v[1] + m[2][2] * v[2] };
  }

  /// Multiplies two rotations. Inline, unlike the function of vtkMath: each pulse needs two.
  Rotation operator*(const Rotation& b) const
  {
    const auto& m = this->M;
    Rotation r;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        r.M[i][j] = m[i][0] * b.M[0][j] + m[i][1] * b.M[1][j] + m[i][2] * b.M[2][j];
      }
    }
    return r;
  }
};

/// Returns the right-handed rotation by an angle [deg] about an axis of any length.
inline Quaternion AxisAngle(Vec3 axis, double degrees)
{
  axis.Normalize();
  const double half = 0.5 * vtkMath::RadiansFromDegrees(degrees);
  const double s = std::sin(half);
  return Quaternion(std::cos(half), s * axis[0], s * axis[1], s * axis[2]);
}

inline Vec3 Rotate(const Quaternion& q, const Vec3& v)
{
  return Rotation(q) * v;
}

/// A frame relative to another: rotation, then translation.
struct Pose
{
  Vec3 Position{ 0.0, 0.0, 0.0 };
  Quaternion Orientation{ 1.0, 0.0, 0.0, 0.0 }; // w, x, y, z
};

/// Returns the pose of c in a, from b in a and c in b: the lever arm rotates with the attitude.
inline Pose operator*(const Pose& a, const Pose& b)
{
  return { a.Position + Rotate(a.Orientation, b.Position), a.Orientation * b.Orientation };
}

} // namespace helios

#endif
