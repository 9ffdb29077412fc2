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

/// The rays that are cast first.
enum class ProbeRays
{
  All,  ///< the sub-rays of a beam with an edge, no more than probe rays
  Few,  ///< on the axis and two rings
  Many, ///< many rings, and eight at the edge
};

/**
 * Of the visible parts of a beam, and of the sub-rays of a beam with too many triangles for them: a
 * few probe rays test it; if they detect no edge they are its returns. Otherwise it is
 * sampled by as many sub-rays as the edge needs. If these are no more than the probe rays, they are
 * cast at once. The measured laws behind it (Docs/scanner-trade.md), for N sub-rays on Vogel's
 * spiral and a straight edge anywhere in a beam truncated at 1.5 w:
 * - RMS of the energy on a side (2416 / N)^(3/4) / 1000
 * - hence of the range, if the two sides are one echo: that times their distance, assumed to be a
 *   fifth of the longest echo
 * - a plane whose ranges spread over more than 4 sigma_R per ring shows the gaps between sub-rays
 *   as echoes
 * - bins of h sigma with the parabola through the logarithms: RMS of the range 0.02 h^2 sigma_R
 */
struct SamplingPlan
{
  ProbeRays Probes = ProbeRays::Few;
  int NumberOfSubRays = 336;    ///< of a beam with an edge
  int Rings = 9;                ///< equivalent to these, for one steep surface
  double DetectionBin = 0.25;   ///< [ns]
  double LargestDepth = 1.0;    ///< of a visible part that is two returns, in sigma_R
  double LargestSpread = 0.0;   ///< maximum of the ranges represented by probe rays, in sigma_R
  double LargestWidening = 0.0; ///< of an echo in closed form: (sigma' / sigma)^2 - 1
  double LargestShift = 0.0;    ///< of its maximum, by omitted terms [m]

  double EnergyTolerance = DefaultEnergyTolerance;
  double RangeTolerance = DefaultRangeTolerance; ///< [m]

  /// The maximum number of doublings of the rings, where a surface spreads over many sigma_R.
  int FinerSteps = 2;

  /// The number of rays cast first.
  int GetNumberOfProbes() const;

  /// The number of doublings for a surface that spreads over n sigma_R in a beam.
  int GetStep(double spread) const;

  /// Probe rays farther than this from the plane of another indicate an edge, not a curved surface
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
