// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What the tolerances of a scan mean for its sub-rays and bins.

#ifndef heliosSamplingPlan_h
#define heliosSamplingPlan_h

#include "vtkHeliosScannerCoreModule.h"

#include <algorithm>
#include <string>

namespace helios
{

/**
 * A few rings of sub-rays look at a beam; where they find no edge they are its returns. Else its
 * cross-section is parted into BaseCells^2 cells, and a cell that holds an edge into four until there are
 * as many as the edge needs, at most Levels times. The measured laws behind it
 * (Docs/scanner-trade.md):
 * - a straight edge through m^2 cells: RMS of the energy on a side 0.06 / m
 * - so of the range, where the two sides are one echo and lie d apart: 0.06 d / m
 * - bins of h sigma with the parabola through the logarithms: RMS of the range 0.02 h^2 sigma_R
 * Where sides are echoes of their own the share of a small one counts: there the cells are 2.5 times as
 * many.
 */
struct SamplingPlan
{
  int ProbeRings = 2; ///< q of the Gauss-Legendre rings that look at a beam first
  int BaseCells = 8;
  int Levels = 3;
  double DetectionBin = 0.25;   ///< [ns]
  double PointSpread = 0.0;     ///< of the ranges in a cell that one point stands for, in sigma_R
  double CellSpread = 0.0;      ///< of the ranges in a cell that four points stand for, in sigma_R
  double LargestWidening = 0.0; ///< of an echo in closed form: (sigma' / sigma)^2 - 1
  double LargestShift = 0.0;    ///< of its maximum by what that leaves out [m]

  double EnergyTolerance = 1e-2;
  double RangeTolerance = 1e-3; ///< [m]
  double LongestEcho = 1.0;     ///< [m]: sides farther apart than this are echoes of their own

  /// How far corners of a cell with a share of the energy may lie off one plane [m].
  double GetPlaneTolerance(double energy) const
  {
    return std::min(CellLaw * this->RangeTolerance / energy, 0.1 * this->LongestEcho);
  }

  /// How much less one may return than another, relative.
  double GetPowerTolerance(double energy) const
  {
    return std::min(CellLaw * this->EnergyTolerance / energy, 0.5);
  }

  /// Corners farther than this from the plane of another are those of an edge, not of a bend [m].
  double GetEdgeTolerance() const { return 20.0 * this->RangeTolerance; }

  int GetNumberOfCells() const { return this->BaseCells << this->Levels; }

  /// How many cells a side an edge needs whose sides lie so far apart [m].
  double GetNeededCells(double apart) const
  {
    const double byEnergy = 2.5 * EdgeLaw / this->EnergyTolerance;
    return apart < this->LongestEcho ? std::max(byEnergy, EdgeLaw * apart / this->RangeTolerance)
                                     : byEnergy;
  }

  static constexpr double EdgeLaw = 0.06;
  static constexpr double CellLaw =
    0.4; ///< half a cell is wrong, of about as many as cross the beam

  /// In words, for a run's summary.
  std::string Describe() const;
};

/// For tolerances in range [m] and energy (relative), and a pulse's standard deviation [ns].
VTKHELIOSSCANNERCORE_EXPORT SamplingPlan PlanSampling(
  double rangeTolerance, double energyTolerance, double sigma);

} // namespace helios

#endif
