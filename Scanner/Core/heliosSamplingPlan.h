// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What the tolerances of a scan mean for its sub-rays and bins.

#ifndef heliosSamplingPlan_h
#define heliosSamplingPlan_h

#include "vtkHeliosScannerCoreModule.h"

#include <string>

namespace helios
{

/**
 * A few sub-rays look at a beam; where they find no edge they are its returns. Else it is sampled
 * by as many as the edge needs. Where these are no more than those that look, they are cast at once.
 * The measured laws behind it (Docs/scanner-trade.md), for N sub-rays on Vogel's spiral and a straight
 * edge anywhere in a beam cut at 1.5 w:
 * - RMS of the energy on a side (2416 / N)^(3/4) / 1000
 * - so of the range, where the two sides are one echo: that times their distance, which is taken as a
 *   fifth of the longest echo
 * - a plane whose ranges spread over more than 4 sigma_R a ring shows the gaps between sub-rays as echoes
 * - bins of h sigma with the parabola through the logarithms: RMS of the range 0.02 h^2 sigma_R
 */
struct SamplingPlan
{
  bool LooksClosely = false;    ///< whether rings of 64 sub-rays look at a beam first
  int NumberOfSubRays = 336;    ///< of a beam that meets edges
  int Rings = 9;                ///< that these are worth, and that see one steep surface
  double DetectionBin = 0.25;   ///< [ns]
  double LargestSpread = 0.0;   ///< of the ranges that probes may stand for, in sigma_R
  double LargestWidening = 0.0; ///< of an echo in closed form: (sigma' / sigma)^2 - 1
  double LargestShift = 0.0;    ///< of its maximum by what that leaves out [m]

  double EnergyTolerance = 1e-2;
  double RangeTolerance = 1e-3; ///< [m]

  /// How often the rings are doubled, at most, where a surface spreads over many sigma_R.
  int FinerSteps = 2;

  /// How many sub-rays look at a beam: on the axis and two rings, or many rings and eight at the rim.
  int GetNumberOfProbes() const { return this->LooksClosely ? 72 : 21; }

  /// Whether they look, or all sub-rays are cast at once.
  bool LooksFirst() const { return this->NumberOfSubRays > this->GetNumberOfProbes(); }

  /// How often they are doubled for a surface that spreads over so many sigma_R in a beam.
  int GetStep(double spread) const;

  /// Probes farther than this from the plane of another are those of an edge, not of a bend [m].
  double GetEdgeTolerance() const { return 20.0 * this->RangeTolerance; }

  /// In words, for a run's summary.
  std::string Describe() const;
};

/// For tolerances in range [m] and energy (relative), and a pulse's standard deviation [ns].
VTKHELIOSSCANNERCORE_EXPORT SamplingPlan PlanSampling(
  double rangeTolerance, double energyTolerance, double sigma);

} // namespace helios

#endif
