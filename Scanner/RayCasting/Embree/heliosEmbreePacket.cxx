// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma GCC diagnostic ignored "-Wpsabi" // vectors are passed to inlined functions only
#include "heliosEmbreePacket.h"

#include <algorithm>
#include <cmath>
#include <cstring>

// The same operations with wider vectors where the machine has them; without FMA, so the same bytes.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) &&                             \
  !defined(__SANITIZE_ADDRESS__)
#define HELIOS_CLONES __attribute__((target_clones("avx2", "default")))
#else
#define HELIOS_CLONES
#endif

namespace helios
{

namespace
{

HELIOS_INLINE bool Any(const Masks& m)
{
  return (m[0] | m[1] | m[2] | m[3]) != 0;
}

template <typename VectorT, typename NumberT>
HELIOS_INLINE VectorT Load(const NumberT* from)
{
  VectorT v;
  std::memcpy(&v, from, sizeof(v));
  return v;
}

template <typename NumberT, typename VectorT>
HELIOS_INLINE void Store(NumberT* to, const VectorT& v)
{
  std::memcpy(to, &v, sizeof(v));
}

/// How far a float ray may go for a hit at a range: rounded up, so that equal ranges are still seen.
template <typename Real>
HELIOS_INLINE Real GetFar(const Real& range, const Real& start, const Real& stretch)
{
  return (range - start) * stretch * (1.0 + 0x1p-20) + 2 * LocalFrame::Pad;
}

HELIOS_INLINE void SetHalf(HalfPacket& half,
  const LocalFrame& frame,
  const vtkHeliosRay* rays,
  int count,
  FloatRays& floats,
  int first,
  int* valid)
{
  const vtkHeliosRay* r[Half];
  for (int lane = 0; lane < Half; ++lane)
  {
    r[lane] = rays + (first + lane < count ? first + lane : 0);
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    half.Origin[axis] =
      Doubles{ r[0]->Origin[axis], r[1]->Origin[axis], r[2]->Origin[axis], r[3]->Origin[axis] };
    half.Direction[axis] = Doubles{
      r[0]->Direction[axis], r[1]->Direction[axis], r[2]->Direction[axis], r[3]->Direction[axis]
    };
  }
  const Masks lanes = Masks{ 0, 1, 2, 3 } + first;
  half.Range =
    Doubles{ r[0]->MaximumRange, r[1]->MaximumRange, r[2]->MaximumRange, r[3]->MaximumRange };
  half.Triangle = Masks() + HalfPacket::NoTriangle;

  Masks isAlive, isX, isY;
  SetTerms<Doubles, Masks>(half, isAlive, isX, isY);
  const Masks z = isX ? Masks() : (isY ? Masks() + 1 : Masks() + 2);
  half.HaveSameAxes = true;
  for (int lane = 0; lane < Half; ++lane)
  {
    half.Axes[lane] = RayAxes(static_cast<int>(z[lane]));
    half.HaveSameAxes = half.HaveSameAxes && z[lane] == z[0];
  }

  // Advance the origins to the scene's box, in double.
  Doubles origin[3], low[3], high[3], entry, exit;
  for (int axis = 0; axis < 3; ++axis)
  {
    origin[axis] = half.Origin[axis] - frame.Centre[axis];
    low[axis] = frame.Low[axis] - origin[axis];
    high[axis] = frame.High[axis] - origin[axis];
  }
  GetBoxRange(low, high, half.Inverse, entry, exit);
  isAlive = isAlive & (lanes < count) & (half.Range > 0.0);
  isAlive = isAlive & (entry <= exit) & (exit > 0.0) & (entry <= half.Range);
  half.Start = Max(entry, Doubles());
  half.Stretch = Max<Doubles>(half.Largest, -half.Largest) * frame.Scale;
  const Doubles shrink = Max<Doubles>(half.LargestInverse, -half.LargestInverse);
  for (int axis = 0; axis < 3; ++axis)
  {
    const Doubles start = (origin[axis] + half.Start * half.Direction[axis]) * frame.Scale;
    const Doubles direction = half.Direction[axis] * shrink;
    Store(&floats.Origin[axis][first], __builtin_convertvector(start, Floats));
    Store(&floats.Direction[axis][first], __builtin_convertvector(direction, Floats));
  }
  const Doubles far = GetFar(half.Range, half.Start, half.Stretch);
  Store(&floats.Far[first], __builtin_convertvector(far, Floats));
  Store(&valid[first], __builtin_convertvector(isAlive, ShortMasks));
}

/// Which lanes are inside the triangle, given by their edge functions.
HELIOS_INLINE Masks GetInside(const Masks& valid,
  const Doubles sheared[3][2],
  const Doubles edges[3])
{
  const Masks positive = (edges[0] > 0.0) | (edges[1] > 0.0) | (edges[2] > 0.0);
  const Masks negative = (edges[0] < 0.0) | (edges[1] < 0.0) | (edges[2] < 0.0);
  Masks inside = valid & ~(positive & negative);
  const Masks tied = inside & ((edges[0] == 0.0) | (edges[1] == 0.0) | (edges[2] == 0.0));
  if (Any(tied))
  {
    for (int lane = 0; lane < Half; ++lane)
    {
      const double e[3] = { edges[0][lane], edges[1][lane], edges[2][lane] };
      const double s[3][2] = { { sheared[0][0][lane], sheared[0][1][lane] },
        { sheared[1][0][lane], sheared[1][1][lane] },
        { sheared[2][0][lane], sheared[2][1][lane] } };
      inside[lane] = inside[lane] && IsInside(s, e) ? -1 : 0;
    }
  }
  return inside;
}

/// Tests four rays; returns whether any has a better hit now.
HELIOS_INLINE void TestHalf(HalfPacket& half,
  const int* valid,
  const double* const points[3],
  vtkTypeInt32 triangle,
  TrianglePlane& plane,
  bool& hasPlane,
  float* far)
{
  const Masks isValid = __builtin_convertvector(Load<ShortMasks>(valid), Masks);
  if (!Any(isValid))
  {
    return;
  }
  if (!half.HaveSameAxes)
  {
    for (int lane = 0; lane < Half; ++lane)
    {
      if (valid[lane])
      {
        half.TestLane(lane, points, triangle, far[lane]);
      }
    }
    return;
  }
  Doubles corners[3][3], sheared[3][2], edges[3];
  Relate<Doubles>(half, points, corners);
  GetEdgeFunctions<Doubles>(half, half.Axes[0], corners, sheared, edges);
  const Masks inside = GetInside(isValid, sheared, edges);
  if (!Any(inside))
  {
    return;
  }
  if (!hasPlane)
  {
    plane = GetPlane(points);
    hasPlane = true;
  }
  const Doubles range = GetRange<Doubles>(half, plane, corners);
  const Masks id = Masks() + triangle;
  const Masks better = inside & (range > 0.0) &
    ((range < half.Range) | ((range == half.Range) & (id < half.Triangle)));
  half.Range = better ? range : half.Range;
  half.Triangle = better ? id : half.Triangle;
  const Doubles newFar = GetFar(half.Range, half.Start, half.Stretch);
  const Floats shortFar = __builtin_convertvector(newFar, Floats);
  Store(far, __builtin_convertvector(better, ShortMasks) ? shortFar : Load<Floats>(far));
}

} // namespace

void LocalFrame::Set(const double low[3], const double high[3])
{
  double half = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Centre[axis] = 0.5 * low[axis] + 0.5 * high[axis];
    half = std::max(half, high[axis] - this->Centre[axis]);
  }
  this->Scale = half > 0.0 ? std::ldexp(1.0, -std::ilogb(half) - 1) : 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Low[axis] = low[axis] - this->Centre[axis] - 2 * Pad / this->Scale;
    this->High[axis] = high[axis] - this->Centre[axis] + 2 * Pad / this->Scale;
  }
}

void LocalFrame::AddBox(const double* const points[3], float low[3], float high[3]) const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const double x = (points[corner][axis] - this->Centre[axis]) * this->Scale;
      low[axis] = std::min(low[axis], static_cast<float>(x - Pad));
      high[axis] = std::max(high[axis], static_cast<float>(x + Pad));
    }
  }
}

HELIOS_CLONES
int Packet::Set(const LocalFrame& frame,
  const vtkHeliosRay* rays,
  int count,
  FloatRays& floats,
  int valid[Lanes])
{
  if (frame.Scale == 0.0) // all of the scene is without area, or outliers
  {
    count = 0;
  }
  int alive = 0;
  for (int first = 0; first < Lanes; first += Half)
  {
    SetHalf(this->GetHalf(first), frame, rays, count, floats, first, valid);
  }
  for (int lane = 0; lane < Lanes; ++lane)
  {
    floats.Near[lane] = 0.0f;
    floats.Time[lane] = 0.0f;
    floats.Mask[lane] = ~0u;
    floats.Id[lane] = 0;
    floats.Flags[lane] = 0;
    alive -= valid[lane];
  }
  return alive;
}

HELIOS_CLONES
void Packet::TestLanes(const int valid[Lanes],
  const double* const points[3],
  vtkTypeInt32 triangle,
  float far[Lanes])
{
  TrianglePlane plane;
  bool hasPlane = false;
  for (int first = 0; first < Lanes; first += Half)
  {
    TestHalf(this->GetHalf(first), valid + first, points, triangle, plane, hasPlane, far + first);
  }
}

bool HalfPacket::TestLane(int lane,
  const double* const points[3],
  vtkTypeInt32 triangle,
  float& far)
{
  RayTerms<double> ray;
  for (int axis = 0; axis < 3; ++axis)
  {
    ray.Origin[axis] = this->Origin[axis][lane];
    ray.Direction[axis] = this->Direction[axis][lane];
    ray.Inverse[axis] = this->Inverse[axis][lane];
  }
  ray.Shear[0] = this->Shear[0][lane];
  ray.Shear[1] = this->Shear[1][lane];
  double corners[3][3], sheared[3][2], edges[3];
  Relate<double>(ray, points, corners);
  GetEdgeFunctions<double>(ray, this->Axes[lane], corners, sheared, edges);
  if (!IsInside(sheared, edges))
  {
    return false;
  }
  const double range = GetRange<double>(ray, GetPlane(points), corners);
  const double best = this->Range[lane];
  if (!(range > 0.0 && (range < best || (range == best && triangle < this->Triangle[lane]))))
  {
    return false;
  }
  this->Range[lane] = range;
  this->Triangle[lane] = triangle;
  far = static_cast<float>(GetFar<double>(range, this->Start[lane], this->Stretch[lane]));
  return true;
}

} // namespace helios
