// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The tolerances of adaptive beam sampling: their defaults and valid ranges.

#ifndef heliosTolerances_h
#define heliosTolerances_h

namespace helios
{

constexpr double DefaultRangeTolerance = 1e-3; ///< 95th percentile of the errors of ranges [m]
/// relative error of amplitudes and numbers of echoes
constexpr double DefaultEnergyTolerance = 1e-2;

constexpr double MinimumRangeTolerance = 1e-6;  ///< [m]
constexpr double MinimumEnergyTolerance = 1e-4; ///< relative
constexpr double LargestTolerance = 1.0;        ///< limit of both

constexpr int DefaultSubRayLimit = 65536; ///< sub-rays of a beam that is sampled
constexpr int SmallestSubRayLimit = 1024;
constexpr int LargestSubRayLimit = 1 << 24;

/// Errors that the sampling of beams may have, and its cost.
struct Tolerances
{
  double Range = DefaultRangeTolerance;   ///< [m]
  double Energy = DefaultEnergyTolerance; ///< relative
  int MaximumSubRays = DefaultSubRayLimit;
};

inline bool IsSubRayLimit(int value)
{
  return value >= SmallestSubRayLimit && value <= LargestSubRayLimit;
}

inline bool IsRangeTolerance(double value)
{
  return value >= MinimumRangeTolerance && value <= LargestTolerance;
}

inline bool IsEnergyTolerance(double value)
{
  return value >= MinimumEnergyTolerance && value <= LargestTolerance;
}

} // namespace helios

#endif
