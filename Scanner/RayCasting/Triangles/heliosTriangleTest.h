// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The common ray/triangle test of all ray casters.
//
// Hit or not: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (JCGT 2(1), 2013) in
// double. The corners, relative to the ray's origin, are sheared so that the ray is the z axis;
// the triangle is hit if the signs of its three 2D edge functions agree. A sheared corner is a
// function of the ray and the corner alone, the same in each triangle that shares it, and the signs
// are exact: a*b - c*d, rounded, never has the wrong sign, since rounding is monotone; it may only
// be zero where the exact value is not; then the rounding errors of the two products decide
// (GetSignOfTie). So the test is exact for the mesh of the sheared corners, which is as closed as
// the scene's mesh (except triangles without area, which are never hit): no ray leaks through a
// shared edge or corner, in any direction.
//
// Range: from the plane of the scene's own points, which keeps |error| <= 8 u R / cos(incidence)
// also for slivers, then clamped to the triangle's bounding box. The clamp only affects triangles
// seen edge-on; it makes culling by range safe: a box is never entered behind the hits in it.
//
// The templates take double or a vector of doubles (one ray per lane) and do the same operations
// in the same order: compiled without contraction (-ffp-contract=off) all are byte-identical.

#ifndef heliosTriangleTest_h
#define heliosTriangleTest_h

#include "heliosVectorLoops.h"
#include "vtkHeliosRay.h"
#include "vtkHeliosScannerRayCastingModule.h"

#include <limits>

namespace helios
{

constexpr double NoHit = std::numeric_limits<double>::infinity();

/**
 * The tolerance, in units of a corner's largest distance from the ray's origin along an axis,
 * within which a ray may pass beside a triangle and hit it: the rounding of the shear, 7 u, and of
 * a test of its box, 4 u, with a margin. u = 2^-53.
 */
constexpr double BoxSlack = 0x1p-49;

/// The data of a ray for the test, for one ray (double) or for a ray in each lane of a vector.
template <typename Real>
struct RayTerms
{
  Real Origin[3];
  Real Direction[3];
  Real Inverse[3]; ///< inverse of the direction; 1e300 for a component of zero
  Real Shear[2];   ///< direction x / z and y / z, of the axes below
  Real Largest;    ///< largest of the direction's components: z
  Real LargestInverse;
};

/// The axes of the test: z is the one along which the direction is largest.
struct RayAxes
{
  int X = 0;
  int Y = 1;
  int Z = 2;

  RayAxes() = default;
  explicit RayAxes(int z)
    : X(z == 2 ? 0 : z + 1)
    , Y(z == 0 ? 2 : z - 1)
    , Z(z)
  {
  }
};

/// A ray prepared for the test.
struct TestRay : RayTerms<double>
{
  RayAxes Axes;
  double MaximumRange;

  /// Sets a ray; false if it hits nothing: not finite, without length or with an empty range.
  inline bool Set(const vtkHeliosRay& ray);
};

/// The plane of a triangle: its normal (of any length), and the corner with the largest angle.
struct TrianglePlane
{
  double Normal[3];
  int Pivot;
};

/// Computes the normal of a triangle whose edges at the pivot are nearly parallel, in
/// double-double.
VTKHELIOSSCANNERRAYCASTING_EXPORT void GetFlatNormal(
  const double* const points[3], int pivot, double normal[3]);

/// Returns the sign of a b - c d where the two products round to the same double, from their
/// errors.
VTKHELIOSSCANNERRAYCASTING_EXPORT int GetSignOfTie(double a, double b, double c, double d);

template <typename Real>
HELIOS_INLINE Real Min(const Real& a, const Real& b)
{
  return a < b ? a : b;
}

template <typename Real>
HELIOS_INLINE Real Max(const Real& a, const Real& b)
{
  return a > b ? a : b;
}

/**
 * Sets the terms from origin and direction, and the axis of the largest direction component. False
 * for a ray that hits nothing: not finite, or without length.
 */
template <typename Real, typename MaskT>
HELIOS_INLINE void SetTerms(RayTerms<Real>& ray, MaskT& isUsable, MaskT& isX, MaskT& isY)
{
  Real* d = ray.Direction;
  Real* inverse = ray.Inverse;
  const Real size[3] = { Max<Real>(d[0], -d[0]), Max<Real>(d[1], -d[1]), Max<Real>(d[2], -d[2]) };
  const Real largest = Max(Max(size[0], size[1]), size[2]);
  isUsable = largest > 1e-100;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Real& o = ray.Origin[axis];
    isUsable = isUsable & (size[axis] < 1e100) & (Max<Real>(o, -o) < 1e100);
    // A negligible component is set to zero, so that no term of the test becomes subnormal.
    const MaskT isZero = size[axis] <= 1e-200 * largest;
    inverse[axis] = isZero ? Real() + 1e300 : 1.0 / d[axis];
    d[axis] = isZero ? Real() : d[axis];
  }
  isX = size[0] == largest;
  isY = size[1] == largest;
  ray.Largest = isX ? d[0] : (isY ? d[1] : d[2]);
  ray.LargestInverse = isX ? inverse[0] : (isY ? inverse[1] : inverse[2]);
  ray.Shear[0] = (isX ? d[1] : (isY ? d[2] : d[0])) * ray.LargestInverse;
  ray.Shear[1] = (isX ? d[2] : (isY ? d[0] : d[1])) * ray.LargestInverse;
}

/// Returns the corners relative to the ray's origin.
template <typename PlaceT>
HELIOS_INLINE void ComputeOffsets(
  const PlaceT origin[3], const double* const points[3], PlaceT corners[3][3])
{
  for (int corner = 0; corner < 3; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      corners[corner][axis] = points[corner][axis] - origin[axis];
    }
  }
}

/// Shears the corners into the plane across the ray, and computes the edge functions there.
template <typename Real, typename PlaceT>
HELIOS_INLINE void GetEdgeFunctions(const RayTerms<Real>& ray, const RayAxes& axes,
  const PlaceT corners[3][3], Real sheared[3][2], Real edges[3])
{
  for (int corner = 0; corner < 3; ++corner)
  {
    const PlaceT* p = corners[corner];
    sheared[corner][0] = p[axes.X] - ray.Shear[0] * p[axes.Z];
    sheared[corner][1] = p[axes.Y] - ray.Shear[1] * p[axes.Z];
  }
  const Real* a = sheared[0];
  const Real* b = sheared[1];
  const Real* c = sheared[2];
  edges[0] = c[0] * b[1] - c[1] * b[0];
  edges[1] = a[0] * c[1] - a[1] * c[0];
  edges[2] = b[0] * a[1] - b[1] * a[0];
}

/// Returns whether the ray is inside, on an edge or on a corner: no two edge functions differ in
/// sign.
inline bool IsInside(const double sheared[3][2], const double edges[3])
{
  bool anyPositive = edges[0] > 0 || edges[1] > 0 || edges[2] > 0;
  bool anyNegative = edges[0] < 0 || edges[1] < 0 || edges[2] < 0;
  if (anyPositive && anyNegative)
  {
    return false;
  }
  for (int i = 0; i < 3; ++i)
  {
    if (edges[i] == 0)
    {
      const double* p = sheared[(i + 2) % 3];
      const double* q = sheared[(i + 1) % 3];
      const int sign = GetSignOfTie(p[0], q[1], p[1], q[0]);
      anyPositive |= sign > 0;
      anyNegative |= sign < 0;
    }
  }
  return anyPositive != anyNegative; // neither: the triangle is seen edge-on
}

HELIOS_INLINE TrianglePlane GetPlane(const double* const points[3])
{
  double edges[3][3]; // edge i starts at corner i
  double squares[3];
  for (int i = 0; i < 3; ++i)
  {
    const double* from = points[i];
    const double* to = points[i == 2 ? 0 : i + 1];
    for (int axis = 0; axis < 3; ++axis)
    {
      edges[i][axis] = to[axis] - from[axis];
    }
    const double* e = edges[i];
    squares[i] = e[0] * e[0] + e[1] * e[1] + e[2] * e[2];
  }
  // The largest angle is opposite the longest edge: the cross product is most accurate there.
  const int longest =
    squares[0] > squares[1] ? (squares[0] > squares[2] ? 0 : 2) : (squares[1] > squares[2] ? 1 : 2);
  TrianglePlane plane;
  plane.Pivot = longest == 0 ? 2 : longest - 1;
  const int before = plane.Pivot == 0 ? 2 : plane.Pivot - 1;
  const double* a = edges[before];
  const double* b = edges[plane.Pivot];
  double* n = plane.Normal;
  n[0] = a[1] * b[2] - a[2] * b[1];
  n[1] = a[2] * b[0] - a[0] * b[2];
  n[2] = a[0] * b[1] - a[1] * b[0];
  const double square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
  if (!(square > 0.0625 * squares[before] * squares[plane.Pivot])) // sine of the angle < 1/4
  {
    GetFlatNormal(points, plane.Pivot, n);
  }
  return plane;
}

/// Widens a box given relative to the origin by the test's rounding.
template <typename PlaceT>
HELIOS_INLINE void Widen(PlaceT low[3], PlaceT high[3])
{
  const PlaceT reach = Max(Max(Max<PlaceT>(-low[0], high[0]), Max<PlaceT>(-low[1], high[1])),
    Max<PlaceT>(-low[2], high[2]));
  const PlaceT slack = BoxSlack * reach;
  for (int axis = 0; axis < 3; ++axis)
  {
    low[axis] = low[axis] - slack;
    high[axis] = high[axis] + slack;
  }
}

/// Returns the interval of ranges within a box.
template <typename Real, typename PlaceT, typename InverseT>
HELIOS_INLINE void GetInterval(
  const PlaceT low[3], const PlaceT high[3], const InverseT inverse[3], Real& entry, Real& exit)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    const Real t0 = low[axis] * inverse[axis];
    const Real t1 = high[axis] * inverse[axis];
    entry = axis == 0 ? Min(t0, t1) : Max<Real>(entry, Min(t0, t1));
    exit = axis == 0 ? Max(t0, t1) : Min<Real>(exit, Max(t0, t1));
  }
}

/// Returns the interval of ranges within a box relative to the origin, widened for the test's
/// rounding.
template <typename Real, typename InverseT>
HELIOS_INLINE void GetBoxRange(
  const Real low[3], const Real high[3], const InverseT inverse[3], Real& entry, Real& exit)
{
  Real wideLow[3] = { low[0], low[1], low[2] };
  Real wideHigh[3] = { high[0], high[1], high[2] };
  Widen(wideLow, wideHigh);
  GetInterval(wideLow, wideHigh, inverse, entry, exit);
}

/// The data of a triangle for the range of a hit, seen from an origin.
template <typename PlaceT>
struct RangeTerms
{
  PlaceT Distance; ///< distance of the plane, times the length of its normal
  PlaceT Low[3];   ///< the box, widened
  PlaceT High[3];

  HELIOS_INLINE void Set(const TrianglePlane& plane, const PlaceT corners[3][3])
  {
    const double* n = plane.Normal;
    const PlaceT* p = corners[plane.Pivot];
    this->Distance = n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = Min(Min(corners[0][axis], corners[1][axis]), corners[2][axis]);
      this->High[axis] = Max(Max(corners[0][axis], corners[1][axis]), corners[2][axis]);
    }
    Widen(this->Low, this->High);
  }
};

/// Returns the range of a hit with a triangle.
template <typename Real, typename PlaceT>
HELIOS_INLINE Real GetRange(
  const RayTerms<Real>& ray, const TrianglePlane& plane, const RangeTerms<PlaceT>& terms)
{
  const double* n = plane.Normal;
  const Real* d = ray.Direction;
  Real range = terms.Distance / (n[0] * d[0] + n[1] * d[1] + n[2] * d[2]);
  Real entry, exit;
  GetInterval(terms.Low, terms.High, ray.Inverse, entry, exit);
  range = exit < range ? exit : range;
  return range > entry ? range : entry; // also for 0 / 0, exactly edge-on
}

bool TestRay::Set(const vtkHeliosRay& ray)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Origin[axis] = ray.Origin[axis];
    this->Direction[axis] = ray.Direction[axis];
  }
  bool isUsable, isX, isY;
  SetTerms<double, bool>(*this, isUsable, isX, isY);
  this->Axes = RayAxes(isX ? 0 : (isY ? 1 : 2));
  this->MaximumRange = ray.MaximumRange;
  return isUsable && ray.MaximumRange > 0.0;
}

/// Returns the range at which the ray hits a triangle that has an area; NoHit for a miss or a hit
/// behind it.
inline double TestTriangle(const TestRay& ray, const double* const points[3])
{
  double corners[3][3], sheared[3][2], edges[3];
  ComputeOffsets<double>(ray.Origin, points, corners);
  GetEdgeFunctions(ray, ray.Axes, corners, sheared, edges);
  if (!IsInside(sheared, edges))
  {
    return NoHit;
  }
  const TrianglePlane plane = GetPlane(points);
  RangeTerms<double> terms;
  terms.Set(plane, corners);
  const double range = GetRange(ray, plane, terms);
  return range > 0.0 && range <= ray.MaximumRange ? range : NoHit;
}

} // namespace helios

#endif
