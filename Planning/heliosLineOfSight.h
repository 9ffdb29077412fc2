// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Visibility of test points from an instrument position.

#ifndef heliosLineOfSight_h
#define heliosLineOfSight_h

#include "heliosPose.h"
#include "vtkHeliosRayCaster.h"

#include <vector>
#include <vtkType.h>

namespace helios
{

/// Limits for a test point to be seen. Angles in radians.
struct SightLimits
{
  double HitTolerance = 0.05; ///< [m]
  bool BothSides = false;     ///< the first surface must not be behind the point by more, either
  double MinimumRange = 0.0;  ///< [m]
  double MaximumRange = 1e9;
  double MinimumCosine = 0.0; ///< smallest cosine of the incidence
  double MinimumSine = -1.0;  ///< smallest sine of the elevation
  double MaximumSine = 1.0;
  double DensityFactor = 0.0; ///< cos(incidence) must be at least this times range^2 [1/m2]
};

/// Test points as plain arrays; Normals may be null.
struct SightTargets
{
  const double* Points = nullptr;
  const double* Normals = nullptr;
  vtkIdType Count = 0;
};

/// The result of a range of test points.
struct SightSum
{
  double Incidence = 0.0; ///< the sum of the angles [rad]
  vtkIdType Rays = 0;
};

/// Casts lines of sight in batches. One instance per thread.
class LineOfSight
{
public:
  /// Test points per batch; they fill whole words of bits.
  static constexpr vtkIdType PointsAtOnce = 1024;

  LineOfSight(
    const vtkHeliosRayCaster& caster, const SightTargets& targets, const SightLimits& limits);

  /**
   * Tests visibility from eye of the test points from first on, at most PointsAtOnce, and sets the
   * bits of those seen: test point first is bit 0 of words[0].
   */
  SightSum FindVisible(const Vec3& eye, vtkIdType first, vtkTypeUInt64* words);

private:
  struct Target
  {
    vtkIdType Bit;
    double Distance;
    double Cosine;
  };

  /// Builds a ray to every test point within the limits.
  void Aim(const Vec3& eye, vtkIdType first);
  bool IsWithinLimits(double sine, const Target& target) const;
  void Cast();

  const vtkHeliosRayCaster& Caster;
  const SightTargets& Targets;
  const SightLimits& Limits;
  std::vector<Target> Aimed;
  std::vector<vtkHeliosRay> Rays;
  std::vector<vtkHeliosHit> Hits;
  std::vector<unsigned char> IsHidden;
};

} // namespace helios

#endif
