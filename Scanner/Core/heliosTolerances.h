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
