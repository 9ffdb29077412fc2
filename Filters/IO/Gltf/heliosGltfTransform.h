// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Affine transforms of the nodes of glTF documents.

#ifndef heliosGltfTransform_h
#define heliosGltfTransform_h

#include <algorithm>
#include <array>
#include <cmath>

namespace helios
{

/// Rows of a 3 x 4 matrix: p' = M p + t.
struct GltfTransform
{
  double M[3][4] = { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } };

  /// Makes the transform of sixteen numbers in column order, as documents have them; the last row
  /// is not read.
  static GltfTransform FromColumns(const double* m)
  {
    GltfTransform result;
    for (int i = 0; i < 12; ++i)
    {
      result.M[i / 4][i % 4] = m[4 * (i % 4) + i / 4];
    }
    return result;
  }

  /// Makes a scale, then a rotation by a quaternion x, y, z, w of any length but 0, then a
  /// translation.
  static GltfTransform FromParts(const double* t, const double* q, const double* s)
  {
    const double n = 2.0 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double r[3][3] = {
      { 1 - n * (y * y + z * z), n * (x * y - z * w), n * (x * z + y * w) },
      { n * (x * y + z * w), 1 - n * (x * x + z * z), n * (y * z - x * w) },
      { n * (x * z - y * w), n * (y * z + x * w), 1 - n * (x * x + y * y) },
    };
    GltfTransform result;
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        result.M[i][k] = r[i][k] * s[k];
      }
      result.M[i][3] = t[i];
    }
    return result;
  }

  GltfTransform operator*(const GltfTransform& b) const
  {
    GltfTransform result;
    for (int i = 0; i < 3; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        result.M[i][k] = this->M[i][0] * b.M[0][k] + this->M[i][1] * b.M[1][k] +
          this->M[i][2] * b.M[2][k] + (k == 3 ? this->M[i][3] : 0.0);
      }
    }
    return result;
  }

  std::array<double, 3> Apply(const double* p) const
  {
    std::array<double, 3> result{};
    for (int i = 0; i < 3; ++i)
    {
      result[i] =
        this->M[i][0] * p[0] + this->M[i][1] * p[1] + this->M[i][2] * p[2] + this->M[i][3];
    }
    return result;
  }

  /// Returns whether surfaces are turned inside out.
  bool IsMirrored() const
  {
    const auto& m = this->M;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
      m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
      m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]) <
      0.0;
  }

  bool IsFinite() const
  {
    return std::all_of(
      &this->M[0][0], &this->M[0][0] + 12, [](double x) { return std::isfinite(x); });
  }
};

} // namespace helios

#endif
