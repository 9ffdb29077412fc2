// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSamplingPlan.h"

#include "heliosConstants.h"
#include "heliosFootprint.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace helios
{
namespace
{

constexpr double BinRangeLaw = 0.02;
constexpr int FewestSubRays = 64; // never worse than the 19 of fixed sampling
constexpr int MostSubRays = 4096;
constexpr int SmoothSubRays = 256;
constexpr int EdgeSubRays = 4096;

/// The number for which the energy error of an edge is at most a fraction.
int GetNumberOfSubRays(double share)
{
  const double count = 2416.0 * std::pow(1e-3 / share, 4.0 / 3.0);
  const double full =
    4.0 * std::ceil(0.25 * std::min(count, 1.0 * MostSubRays)); // 4-fold symmetric
  return std::max(FewestSubRays, static_cast<int>(full));
}

} // namespace

SamplingPlan PlanSampling(double rangeTolerance, double energyTolerance, double sigma)
{
  const double sigmaRange = 0.5 * SpeedOfLight * sigma;
  const double longestEcho = 4.0 * sigmaRange; // sides farther apart are separate echoes
  SamplingPlan plan;
  plan.EnergyTolerance = energyTolerance;
  plan.RangeTolerance = rangeTolerance;
  // Less than half of the amplitude tolerance, because small fractions have larger relative errors.
  plan.NumberOfSubRays =
    GetNumberOfSubRays(std::min(0.45 * energyTolerance, 4.5 * rangeTolerance / longestEcho));
  plan.SmoothSubRays = std::max(SmoothSubRays, plan.NumberOfSubRays);
  plan.EdgeSubRays = std::max(EdgeSubRays, 4 * plan.NumberOfSubRays);
  const double h = std::sqrt(0.5 * rangeTolerance / (BinRangeLaw * sigmaRange));
  plan.DetectionBin = sigma * std::clamp(h, 0.03, 0.15); // at least as fine as 0.25 ns for 4 ns
  // Two returns have the mean and variance of a part. What is left: with its fourth moment the
  // amplitude errs by 0.0007 d^4, with its third one the range by up to 0.0037 d^3 sigma_R. Beyond
  // 1.2 the gaps between parts would show.
  plan.LargestDepth = std::min({ 1.2, std::pow(energyTolerance / (4 * 0.0007), 0.25),
    std::cbrt(rangeTolerance / (4 * 0.0037 * sigmaRange)) });
  plan.LargestWidening = std::min(0.25, 0.9 * std::cbrt(energyTolerance));
  plan.LargestShift = 0.5 * rangeTolerance;
  return plan;
}

std::string SamplingPlan::Describe() const
{
  std::ostringstream text;
  text << "adaptive, visible areas of surfaces; in beams of more than " << Footprint::MostTriangles
       << " triangles " << this->SmoothSubRays << " sub-rays on one surface, " << this->EdgeSubRays
       << " more at edges; none for planar footprints; waveform bin " << this->DetectionBin
       << " ns where the returns of a pulse spread over more than c sigma";
  return text.str();
}

} // namespace helios
