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
 * A cross-section of the beam is parted into BaseCells^2 cells, and a cell that holds an edge into four,
 * Levels times. The measured laws behind it (Docs/scanner-trade.md):
 * - a straight edge through m^2 cells: RMS of the energy 0.06 / m
 * - leaves, wires, steps through m^2 cells: RMS of the range 0.2 sigma_R / m
 * - bins of h sigma with the parabola through the logarithms: RMS of the range 0.02 h^2 sigma_R
 */
struct SamplingPlan
{
  int BaseCells = 6;
  int Levels = 3;
  double DetectionBin = 0.25;  ///< [ns]
  double PlaneTolerance = 0.0; ///< [m]: corners of a cell nearer than this to a plane are on it
  double PowerTolerance = 0.0; ///< relative: corners of a cell that differ by less are alike
  double PointSpread = 0.0; ///< of the ranges in a cell that one point stands for, in sigma_R
  double CellSpread = 0.0;  ///< of the ranges in a cell that four points stand for, in sigma_R
  double LargestWidening = 0.0; ///< of an echo in closed form: (sigma' / sigma)^2 - 1
  double LargestShift = 0.0;    ///< of its maximum by what that leaves out [m]

  int GetNumberOfCells() const { return this->BaseCells << this->Levels; }

  /// In words, for a run's summary.
  std::string Describe() const;
};

/// For tolerances in range [m] and energy (relative), and a pulse's standard deviation [ns].
VTKHELIOSSCANNERCORE_EXPORT SamplingPlan PlanSampling(
  double rangeTolerance, double energyTolerance, double sigma);

} // namespace helios

#endif
