// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// TestTriangle for rays in the lanes of vectors. For sources only, which must first ignore -Wpsabi:
// vectors are passed to functions that are inlined, into those that are compiled for the machine.

#ifndef heliosRayVectors_h
#define heliosRayVectors_h

#include "heliosRayLanes.h"
#include "heliosVectorLoops.h"

#include <cstdint>
#include <cstring>

namespace helios
{

HELIOS_INLINE bool Any(const Masks& m)
{
  const Masks halves = m | __builtin_shufflevector(m, m, 2, 3, 0, 1);
  return (halves[0] | halves[1]) != 0;
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

typedef float EightFloats __attribute__((vector_size(32)));
typedef int EightMasks __attribute__((vector_size(32)));
typedef signed char MaskBytes __attribute__((vector_size(32)));

/// Converts numbers of eight lanes that fit a byte to one byte per lane: for logic independent of
/// lanes. By a shuffle, because compilers convert lane by lane without AVX-512.
HELIOS_INLINE vtkTypeUInt64 GetBytes(const EightMasks& masks)
{
  const auto& all = reinterpret_cast<const MaskBytes&>(masks);
  const MaskBytes bytes = __builtin_shufflevector(all, all, 0, 4, 8, 12, 16, 20, 24, 28, 0, 4, 8,
    12, 16, 20, 24, 28, 0, 4, 8, 12, 16, 20, 24, 28, 0, 4, 8, 12, 16, 20, 24, 28);
  vtkTypeUInt64 result;
  std::memcpy(&result, &bytes, sizeof(result));
  return result;
}

/// Sets the masks of four lanes whose bytes are not zero.
HELIOS_INLINE void SetMasks(std::uint32_t bytes, Masks& masks)
{
  constexpr Masks ofLanes = { 0xff, 0xff00, 0xff0000, 0xff000000 };
  masks = ((Masks() + bytes) & ofLanes) != 0;
}

/// Removes the lanes that are not inside from lanes inside a triangle but for an edge function of
/// zero.
__attribute__((noinline)) inline void ResolveTies(
  const Doubles sheared[3][2], const Doubles edges[3], Masks& inside)
{
  for (int lane = 0; lane < QuadWidth; ++lane)
  {
    const double e[3] = { edges[0][lane], edges[1][lane], edges[2][lane] };
    const double s[3][2] = { { sheared[0][0][lane], sheared[0][1][lane] },
      { sheared[1][0][lane], sheared[1][1][lane] }, { sheared[2][0][lane], sheared[2][1][lane] } };
    inside[lane] = inside[lane] && IsInside(s, e) ? -1 : 0;
  }
}

/// Returns the lanes inside the triangle, given by their edge functions.
HELIOS_INLINE void GetInside(
  const Masks& valid, const Doubles sheared[3][2], const Doubles edges[3], Masks& inside)
{
  const Masks positive = (edges[0] > 0.0) | (edges[1] > 0.0) | (edges[2] > 0.0);
  const Masks negative = (edges[0] < 0.0) | (edges[1] < 0.0) | (edges[2] < 0.0);
  inside = valid & ~(positive & negative);
  const Masks tied = inside & ((edges[0] == 0.0) | (edges[1] == 0.0) | (edges[2] == 0.0));
  if (Any(tied))
  {
    ResolveTies(sheared, edges, inside);
  }
}

/// The plane of a triangle, computed on first use.
struct LazyPlane
{
  TrianglePlane Plane;
  bool Has = false;

  HELIOS_INLINE const TrianglePlane& Get(const double* const points[3])
  {
    if (!this->Has)
    {
      this->Plane = GetPlane(points);
      this->Has = true;
    }
    return this->Plane;
  }
};

/// Keeps the hits with a triangle that are better; returns the lanes that have one.
template <typename PlaceT>
HELIOS_INLINE void SelectBetter(RayLanes& rays, const Masks& inside, long long triangle,
  const TrianglePlane& plane, const RangeTerms<PlaceT>& terms, Masks& better)
{
  const Doubles range = GetRange(rays, plane, terms);
  const Masks id = Masks() + triangle;
  better = inside & (range > 0.0) &
    ((range < rays.Range) | ((range == rays.Range) & (id < rays.Triangle)));
  rays.Range = better ? range : rays.Range;
  rays.Triangle = better ? id : rays.Triangle;
}

/// Tests four rays of the same axes, and keeps better hits; returns the lanes that have one.
HELIOS_INLINE void TestLanes(RayLanes& rays, const RayAxes& axes, const Masks& isValid,
  long long triangle, const double* const points[3], LazyPlane& plane, Masks& better)
{
  Doubles corners[3][3], sheared[3][2], edges[3];
  ComputeOffsets<Doubles>(rays.Origin, points, corners);
  GetEdgeFunctions(rays, axes, corners, sheared, edges);
  Masks inside;
  GetInside(isValid, sheared, edges, inside);
  better = inside;
  if (!Any(inside))
  {
    return;
  }
  RangeTerms<Doubles> terms;
  terms.Set(plane.Get(points), corners);
  SelectBetter(rays, inside, triangle, plane.Plane, terms, better);
}

} // namespace helios

#endif
