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
 * A cross-section of the beam is parted into BaseCells^2 cells, and a cell that holds an edge into four
 * until there are as many as the edge needs, at most Levels times. The measured laws behind it
 * (Docs/scanner-trade.md):
 * - a straight edge through m^2 cells: RMS of the energy on a side 0.06 / m
 * - so of the range, where the two sides are one echo and lie d apart: 0.06 d / m
 * - bins of h sigma with the parabola through the logarithms: RMS of the range 0.02 h^2 sigma_R
 * A beam may hold more than one edge: each gets twice the cells.
 */
struct SamplingPlan
{
  int BaseCells = 6;
  int Levels = 3;
  double DetectionBin = 0.25;   ///< [ns]
  double PlaneTolerance = 0.0;  ///< [m]: corners of a cell nearer than this to a plane are on it
  double PowerTolerance = 0.0;  ///< relative: corners of a cell that differ by less are alike
  double PointSpread = 0.0;     ///< of the ranges in a cell that one point stands for, in sigma_R
  double CellSpread = 0.0;      ///< of the ranges in a cell that four points stand for, in sigma_R
  double LargestWidening = 0.0; ///< of an echo in closed form: (sigma' / sigma)^2 - 1
  double LargestShift = 0.0;    ///< of its maximum by what that leaves out [m]

  double EnergyTolerance = 1e-2;
  double RangeTolerance = 1e-3; ///< [m]
  double LongestEcho = 1.0;     ///< [m]: sides farther apart than this are echoes of their own

  int GetNumberOfCells() const { return this->BaseCells << this->Levels; }

  /// How many cells a side an edge needs whose sides lie so far apart [m].
  double GetNeededCells(double apart) const
  {
    const double byEnergy = EdgeLaw / this->EnergyTolerance;
    return apart < this->LongestEcho ? std::max(byEnergy, EdgeLaw * apart / this->RangeTolerance)
                                     : byEnergy;
  }

  static constexpr double EdgeLaw = 2.0 * 0.06;

  /// In words, for a run's summary.
  std::string Describe() const;
};

/// For tolerances in range [m] and energy (relative), and a pulse's standard deviation [ns].
VTKHELIOSSCANNERCORE_EXPORT SamplingPlan PlanSampling(
  double rangeTolerance, double energyTolerance, double sigma);

} // namespace helios

#endif
