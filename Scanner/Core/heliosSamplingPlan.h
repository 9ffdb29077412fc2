// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The sub-rays and bins that the tolerances of a scan require.

#ifndef heliosSamplingPlan_h
#define heliosSamplingPlan_h

#include "heliosTolerances.h"
#include "vtkHeliosScannerCoreModule.h"

#include <string>

namespace helios
{

/**
 * Of the visible parts of a beam, and of the sub-rays of a beam with too many triangles for them, or
 * among leaves. The measured laws behind it (Docs/scanner-trade.md), for N sub-rays on Vogel's
 * spiral and a straight edge anywhere in a beam truncated at 1.5 w:
 * - RMS of the energy on a side (2416 / N)^(3/4) / 1000
 * - hence of the range, if the two sides are one echo: that times their distance, assumed to be a
 *   fifth of the longest echo
 * - bins of h sigma with the parabola through the logarithms: RMS of the range 0.02 h^2 sigma_R
 */
struct SamplingPlan
{
  int NumberOfSubRays = 336;    ///< of a beam among leaves
  int SmoothSubRays = 336;      ///< of one with too many triangles: these find whether it is smooth
  int EdgeSubRays = 4096;       ///< of one that is not
  double DetectionBin = 0.25;   ///< [ns]
  double LargestDepth = 1.0;    ///< of a visible part that is two returns, in sigma_R
  double LargestWidening = 0.0; ///< of an echo in closed form: (sigma' / sigma)^2 - 1
  double LargestShift = 0.0;    ///< of its maximum, by omitted terms [m]

  double EnergyTolerance = DefaultEnergyTolerance;
  double RangeTolerance = DefaultRangeTolerance; ///< [m]

  /// Sub-rays farther than this from the plane of another indicate an edge, not a curved surface
  /// [m].
  double GetEdgeTolerance() const { return 20.0 * this->RangeTolerance; }

  /// As text, for a run's summary.
  std::string Describe() const;
};

/// For tolerances in range [m] and energy (relative), and a pulse's standard deviation [ns].
VTKHELIOSSCANNERCORE_EXPORT SamplingPlan PlanSampling(
  double rangeTolerance, double energyTolerance, double sigma);

} // namespace helios

#endif
