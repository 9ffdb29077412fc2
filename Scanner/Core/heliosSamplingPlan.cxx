// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSamplingPlan.h"

#include "heliosRadiometry.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace helios
{
namespace
{

constexpr double BinRangeLaw = 0.02;
constexpr int MostLevels = 4;

} // namespace

SamplingPlan PlanSampling(double rangeTolerance, double energyTolerance, double sigma)
{
  const double sigmaRange = 0.5 * SpeedOfLight * sigma;
  SamplingPlan plan;
  plan.ProbeRings = energyTolerance >= 0.002 ? 2 : 4;
  plan.EnergyTolerance = energyTolerance;
  plan.RangeTolerance = rangeTolerance;
  plan.LongestEcho = 4.0 * sigmaRange;
  const double cells =
    std::max(plan.GetNeededCells(1e300), plan.GetNeededCells(0.99 * plan.LongestEcho));
  const double levels = std::ceil(std::log2(cells / plan.BaseCells) - 0.1);
  plan.Levels = static_cast<int>(std::clamp(levels, 0.0, static_cast<double>(MostLevels)));
  const double h = std::sqrt(0.5 * rangeTolerance / (BinRangeLaw * sigmaRange));
  plan.DetectionBin = sigma * std::clamp(h, 0.03, 0.6);
  // Of even ranges over h sigma, one point misses h^2 / 24 of the amplitude, two miss h^4 / 1440.
  plan.PointSpread = std::sqrt(6.0 * energyTolerance);
  plan.CellSpread = std::min(1.5, std::pow(360.0 * energyTolerance, 0.25));
  plan.LargestWidening = std::min(0.25, 0.9 * std::cbrt(energyTolerance));
  plan.LargestShift = 0.5 * rangeTolerance;
  return plan;
}

std::string SamplingPlan::Describe() const
{
  std::ostringstream text;
  text << 4 * this->ProbeRings * this->ProbeRings + 8
       << " sub-rays where a beam meets one surface, more where it meets edges, down to 1/"
       << this->GetNumberOfCells() << " of the beam, and none where one plane is proved; bins of "
       << this->DetectionBin << " ns where the returns of a pulse spread over more than c sigma";
  return text.str();
}

} // namespace helios
