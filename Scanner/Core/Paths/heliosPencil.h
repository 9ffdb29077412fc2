// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How a narrow pencil of rays from one point spreads along a path.

#ifndef heliosPencil_h
#define heliosPencil_h

#include "heliosPose.h"
#include "vtkHeliosScannerCoreModule.h" // For export macro

namespace helios
{

/**
 * Rays near a central one. Distances is the inverse of the curvature of their wavefront, a symmetric
 * matrix on two axes across the ray, Side and the one that completes a right-handed frame; Area is
 * what a unit of solid angle at the start has grown to. At flat surfaces the distances change by the
 * Coddington equations (Born and Wolf, Principles of Optics, 4.6).
 */
class VTKHELIOSSCANNERCORE_EXPORT Pencil
{
public:
  /// Starts a pencil at a point along a unit vector, after a length [m].
  Pencil(const Vec3& direction, double length);

  /// Returns the area [m2] of a unit of solid angle at the start.
  double GetArea() const { return this->Area; }

  /// Advances along the ray [m].
  void Advance(double length);

  /// Mirrors at a flat surface with a unit normal.
  void Reflect(const Vec3& normal);

  /// Refracts at a flat surface with a unit normal: the direction before, the cosines of the angles
  /// before and after, and the ratio of the refractive indices after / before.
  void Refract(
    const Vec3& direction, const Vec3& normal, double cosine, double refracted, double indexRatio);

private:
  struct Matrix
  {
    double Side, Other, Mixed;
  };

  double GetDeterminant() const;
  void TurnTo(const Vec3& direction, const Vec3& side);

  Vec3 Side; // a unit vector across the ray; the other is direction x Side
  Matrix Distances;
  double Area;
};

} // namespace helios

#endif
