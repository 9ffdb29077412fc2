// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The tolerances of adaptive beam sampling: their defaults and valid ranges.

#ifndef heliosTolerances_h
#define heliosTolerances_h

namespace helios
{

constexpr double DefaultRangeTolerance = 1e-3;  ///< 95th percentile of the errors of ranges [m]
constexpr double DefaultEnergyTolerance = 1e-2; ///< of amplitudes and numbers of echoes, relative

constexpr double LeastRangeTolerance = 1e-6;  ///< [m]
constexpr double LeastEnergyTolerance = 1e-4; ///< relative
constexpr double LargestTolerance = 1.0;      ///< of both

constexpr int DefaultMostSubRays = 65536; ///< of a beam that is sampled
constexpr int LeastMostSubRays = 1024;
constexpr int LargestMostSubRays = 1 << 24;

/// What the sampling of beams must keep, and may cost.
struct Tolerances
{
  double Range = DefaultRangeTolerance;   ///< [m]
  double Energy = DefaultEnergyTolerance; ///< relative
  int MostSubRays = DefaultMostSubRays;
};

inline bool IsMostSubRays(int value)
{
  return value >= LeastMostSubRays && value <= LargestMostSubRays;
}

inline bool IsRangeTolerance(double value)
{
  return value >= LeastRangeTolerance && value <= LargestTolerance;
}

inline bool IsEnergyTolerance(double value)
{
  return value >= LeastEnergyTolerance && value <= LargestTolerance;
}

} // namespace helios

#endif
