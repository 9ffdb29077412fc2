// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The sub-rays and bins that the tolerances of a scan require.

#ifndef heliosSamplingPlan_h
#define heliosSamplingPlan_h

#include "heliosTolerances.h"
#include "vtkHeliosScannerCoreModule.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

namespace helios
{

/**
 * Plan of the visible parts of a beam, and of the sub-rays of a beam with too many triangles for
 * them, or among leaves. The measured laws behind it (Docs/scanner-trade.md), for N sub-rays on
 * Vogel's spiral and a straight edge anywhere in a beam truncated at 1.5 w:
 * - RMS of the energy on a side (2416 / N)^(3/4) / 1000
 * - hence of the range, if the two sides are one echo: that times their distance, assumed to be a
 *   fifth of the longest echo
 * - bins of h sigma with the parabola through the logarithms: RMS of the range 0.02 h^2 sigma_R
 */
struct SamplingPlan
{
  int NumberOfSubRays = 336;  ///< number for a beam among leaves
  bool PrefersRays = false;   ///< whether they are cast in all beams, if most are among leaves
  double PlaneDistance = 0.0; ///< distance of triangles that count as one plane [m]
  double PlaneContrast = 0.0; ///< relative contrast of their responses
  double Overlap = 0.0;       ///< overlap of a sheet before the plane that fills a beam [m]
  /// rings of sub-rays of a beam that one continuous surface fills; 0: none
  int LayerRings = 3;
  double LayerDistance = 0.0; ///< distance of its triangles from one plane [m]
  double LayerContrast = 0.0; ///< relative contrast of their responses
  double LayerSpread = 0.0;   ///< spread of their ranges [m]
  /// largest number in a beam that is divided into its visible parts
  std::size_t MaximumSurfaces = 512;
  double CellsAcross = 526.0;    ///< cells across a beam that is sampled, of a typical tree
  int MaximumCellsAcross = 1024; ///< limit, a multiple of 8
  /// sub-rays of a beam with too many triangles to collect; times 4 until they agree
  int MinimumSubRays = 256;
  int MaximumSubRays = 65536;

  /// Returns the distance within which a triangle behind one that fills a beam may belong to it [m].
  double GetLargestDistance() const { return std::max(this->PlaneDistance, this->LayerDistance); }
  double DetectionBin = 0.25; ///< [ns]
  /// returns of a beam whose maxima are found beyond those of the bins
  std::size_t MaximumRefined = std::numeric_limits<std::size_t>::max();
  double PairTilt = 0.0; ///< tilt between two triangles that are drawn as one [rad]; 0: none are
  double LargestDepth = 1.0;    ///< depth of a visible part that is two returns, in sigma_R
  double RimEnergy = 0.0;       ///< energy of the rim of a divided beam, left out; a fraction
  double PartError = 1e-6;      ///< error of the energy of a small part, as a fraction of the beam
  double LargestWidening = 0.0; ///< widening of an echo in closed form: (sigma' / sigma)^2 - 1
  double LargestShift = 0.0;    ///< shift of its maximum, by omitted terms [m]

  double EnergyTolerance = DefaultEnergyTolerance;
  double RangeTolerance = DefaultRangeTolerance; ///< [m]

  /// Returns the cells across a beam of a number of surfaces that keep the tolerances, a multiple of
  /// 8; more than the limit if this is too low.
  VTKHELIOSSCANNERCORE_EXPORT int GetCellsAcross(std::size_t surfaces) const;

  /// Returns those at a level of refinement, from 0: half of them, doubled at each level up to the
  /// limit; more than the limit beyond the last level.
  VTKHELIOSSCANNERCORE_EXPORT int GetCellsAtLevel(std::size_t surfaces, int level) const;

  /// Returns whether cells keep the tolerances, and are expected to take less time than the division,
  /// for a number of surfaces that cover the beam so often.
  VTKHELIOSSCANNERCORE_EXPORT bool PrefersCells(std::size_t surfaces, double layers) const;

  /// Describes the plan, for a run's summary.
  std::string Describe() const;
};

/// Plans the sampling for tolerances, and a pulse's standard deviation [ns].
VTKHELIOSSCANNERCORE_EXPORT SamplingPlan PlanSampling(const Tolerances& tolerances, double sigma);

} // namespace helios

#endif
