// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Per-cell sums of points: integers, independent of the order.

#ifndef heliosVoxelSums_h
#define heliosVoxelSums_h

#include "heliosPose.h"

#include <vtkType.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace helios
{

/// Returns the unit vector, or 0 0 0 for zero length.
inline Vec3 GetUnit(const Vec3& direction)
{
  const double largest =
    std::max({ std::abs(direction[0]), std::abs(direction[1]), std::abs(direction[2]) });
  if (!(largest > 0.0) || !std::isfinite(largest))
  {
    return Vec3(0.0, 0.0, 0.0);
  }
  const Vec3 scaled = direction * (1.0 / largest);
  return scaled * (1.0 / scaled.Norm());
}

/// Returns the nearest integer to x; halves away from zero. (llround is a function call.)
inline std::int64_t GetNearest(double x)
{
  return static_cast<std::int64_t>(x + std::copysign(0.5, x));
}

/// The sum of unit vectors, in units of 2^-30.
struct NormalSum
{
  std::int64_t Sum[3] = { 0, 0, 0 };

  void Add(const Vec3& unit)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Sum[axis] += GetNearest(unit[axis] * 0x1p30);
    }
  }
  Vec3 GetNormal() const
  {
    const std::int64_t* s = this->Sum;
    return GetUnit(
      { static_cast<double>(s[0]), static_cast<double>(s[1]), static_cast<double>(s[2]) });
  }
};

/// The unit vector at the point nearest to a centre; the smallest of them for ties.
struct NearestNormal
{
  double Distance2 = std::numeric_limits<double>::infinity();
  double Normal[3] = { 0.0, 0.0, 0.0 };

  void Add(double distance2, const Vec3& unit)
  {
    if (distance2 < this->Distance2 ||
      (distance2 == this->Distance2 &&
        std::lexicographical_compare(
          unit.GetData(), unit.GetData() + 3, this->Normal, this->Normal + 3)))
    {
      this->Distance2 = distance2;
      std::copy_n(unit.GetData(), 3, this->Normal);
    }
  }
};

/// The root mean square of colours, which are integers up to 65535.
struct ColorSum
{
  std::uint64_t Squares[3] = { 0, 0, 0 };
  std::uint32_t Count = 0;

  void Add(const std::uint16_t color[3])
  {
    ++this->Count;
    for (int i = 0; i < 3; ++i)
    {
      this->Squares[i] += static_cast<std::uint64_t>(color[i]) * color[i];
    }
  }
  Vec3 GetColor() const
  {
    Vec3 color;
    for (int i = 0; i < 3; ++i)
    {
      color[i] = std::sqrt(static_cast<double>(this->Squares[i]) / this->Count) / 65535.0;
    }
    return color;
  }
};

/// The first and second moments of points, in units of 2^-30 of the cell from its centre.
class PlaneSum
{
public:
  void Add(const double local[3]);

  /// Returns the unit normal, upwards, of the least-squares plane; 0 0 0 for collinear points.
  Vec3 GetNormal() const;

private:
  __extension__ using Wide = __int128;

  std::int64_t Count = 0;
  std::int64_t Sums[3] = { 0, 0, 0 };
  Wide Products[6] = { 0, 0, 0, 0, 0, 0 }; // xx xy xz yy yz zz
};

} // namespace helios

#endif
