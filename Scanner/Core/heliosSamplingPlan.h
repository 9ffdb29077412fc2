// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The sub-rays and bins that the tolerances of a scan require.

#ifndef heliosSamplingPlan_h
#define heliosSamplingPlan_h

#include "heliosTolerances.h"
#include "vtkHeliosScannerCoreModule.h"

#include <cstddef>
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
  int NumberOfSubRays = 336;  ///< of a beam among leaves
  double PlaneDistance = 0.0; ///< of triangles that count as one plane [m]
  double PlaneContrast = 0.0; ///< of their responses, relative
  double Overlap = 0.0;       ///< of a sheet before the plane that fills a beam [m]
  int LayerRings = 3;         ///< of sub-rays of a beam that one continuous surface fills; 0: none
  double LayerDistance = 0.0; ///< of its triangles from one plane [m]
  double LayerContrast = 0.0; ///< of their responses, relative
  double LayerSpread = 0.0;   ///< of their ranges [m]
  std::size_t MostSurfaces = 512; ///< of a beam that is divided into its visible parts
  int FewestCellsAcross = 64;     ///< of a beam with more; doubled once or more until answers agree
  int MostCellsAcross = 256;
  int FewestSubRays = 256; ///< of one with too many triangles to collect; times 4 until they agree
  int MostSubRays = 65536;
  double DetectionBin = 0.25;   ///< [ns]
  double LargestDepth = 1.0;    ///< of a visible part that is two returns, in sigma_R
  double RimEnergy = 0.0;       ///< of the rim of a divided beam, left out; a fraction
  double PartError = 1e-6;      ///< of the energy of a small part, as a fraction of the beam
  double LargestWidening = 0.0; ///< of an echo in closed form: (sigma' / sigma)^2 - 1
  double LargestShift = 0.0;    ///< of its maximum, by omitted terms [m]

  double EnergyTolerance = DefaultEnergyTolerance;
  double RangeTolerance = DefaultRangeTolerance; ///< [m]

  /// The cells across a beam at a level of refinement, from 0.
  int GetCellsAcross(int level) const { return this->FewestCellsAcross << level; }

  /// As text, for a run's summary.
  std::string Describe() const;
};

/// For tolerances, and a pulse's standard deviation [ns].
VTKHELIOSSCANNERCORE_EXPORT SamplingPlan PlanSampling(const Tolerances& tolerances, double sigma);

} // namespace helios

#endif
