// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSamplingPlan.h"

#include "heliosConstants.h"
#include "heliosFootprintRaster.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace helios
{
namespace
{

constexpr double BinRangeLaw = 0.02;
constexpr int MinimumSubRays = 64; // never worse than the 19 of fixed sampling
constexpr int MaximumSubRays = 4096;
// The energy at the rim that is left out: at most 15 % of an echo that the tolerances promise, which
// has EnergyTolerance of a full footprint. Ranges err by up to 0.44 of their tolerance then, and
// amplitudes by 0.1 (BenchAccuracy).
constexpr double RimShare = 0.15;   // share of the tolerances
constexpr double MinimumRim = 3e-3; // narrower ones save little
constexpr double MaximumRim = 1.5e-2;
// The response of leaves of two triangles errs by less than their tilt, times their share of the beam.
constexpr double FinestPairs = 0.01;    // energy tolerance for which they are two surfaces
constexpr double PairShare = 0.03;      // tilt [rad], in the tolerance
constexpr double MergedDistance = 0.1;  // distance of parts that are one echo [m], typically
constexpr double CoarseRange = 5e-3;    // [m], from which the maxima of bins will do
constexpr double WideRange = 2e-2;      // [m], for which wider bins will do
constexpr std::size_t FewReturns = 32;  // for which they are not used
constexpr double SurfacesPerSide = 2.0; // surfaces of a beam that is divided, per sub-ray across

/// Returns the number for which the energy error of an edge is at most a fraction.
int GetNumberOfSubRays(double share)
{
  const double count = 2416.0 * std::pow(1e-3 / share, 4.0 / 3.0);
  const double full =
    4.0 * std::ceil(0.25 * std::min(count, 1.0 * MaximumSubRays)); // 4-fold symmetric
  return std::max(MinimumSubRays, static_cast<int>(full));
}

/// Gauss-Legendre rings for a continuous surface, and their errors: the root mean square of the
/// energy of a half plane, where the response changes; the largest of the mean range over a surface
/// that bends at a straight edge, relative to its distance from one plane at the rim; and of the
/// amplitude of a plane, for each sigma_R between the ranges of the axis and the rim, up to the most
/// for which its echo has one maximum.
struct LayerRule
{
  int Rings;
  double HalfPlane;
  double Bend;
  double Amplitude;
  double MaximumSigmas;
};

constexpr LayerRule LayerRules[] = { { 2, 0.035, 0.014, 3.7e-3, 5.0 },
  { 3, 0.02, 0.006, 1.4e-3, 8.0 }, { 4, 0.015, 0.0035, 6.5e-4, 10.0 } };
constexpr double WidestRange = 5e-3; // [m]
constexpr double WidestEnergy = 5e-2;
constexpr double EnoughSigmas = 0.7; // planes are rarely steeper

/// Sets the smallest rule whose errors are half of the tolerances.
void SetLayerRule(const Tolerances& tolerances, double sigmaRange, SamplingPlan& plan)
{
  plan.LayerRings = 0;
  for (const LayerRule& rule : LayerRules)
  {
    const double sigmas = std::min(rule.MaximumSigmas, 0.5 * tolerances.Energy / rule.Amplitude);
    if (sigmas >= EnoughSigmas)
    {
      plan.LayerRings = rule.Rings;
      plan.LayerDistance = std::min(0.5 * tolerances.Range / rule.Bend, 0.5 * sigmaRange);
      plan.LayerContrast = 0.5 * tolerances.Energy / rule.HalfPlane;
      plan.LayerSpread = 2.0 * sigmas * sigmaRange;
      return;
    }
  }
}

/// Sets what counts as one plane or one layer. Tolerances beyond the widest save little here, and
/// would be worse than 19 fixed sub-rays on rough ground (BenchAccuracy: gravel).
void SetSurfaceRules(const Tolerances& asked, double sigmaRange, SamplingPlan& plan)
{
  const Tolerances tolerances{ std::min(asked.Range, WidestRange),
    std::min(asked.Energy, WidestEnergy) };
  plan.PlaneDistance = 2.0 * tolerances.Range;
  plan.Overlap = 0.2 * tolerances.Range;
  plan.PlaneContrast = 0.5 * tolerances.Energy;
  plan.LargestWidening = std::min(0.25, 0.9 * std::cbrt(tolerances.Energy));
  plan.LargestShift = 0.5 * tolerances.Range;
  SetLayerRule(tolerances, sigmaRange, plan);
}

/// Cells across a beam full of leaves, for an error of the range (95th percentile) from 10 mm on, from
/// 1 mm on, and below (measured: a stand of trees and BenchAccuracy, where other scenes need fewer);
/// and for an error of the number of echoes.
struct CellLaw
{
  double Range; ///< [m]
  double Cells, Power;
};
constexpr CellLaw CellsForRange[] = { { 0.01, 126.0, 1.05 }, { 1e-3, 440.0, 0.54 },
  { 0.0, 440.0, 0.7 } };
constexpr double CellsForEnergy = 75.0; // at 1 %
constexpr double CellPower = 0.62;
constexpr double MinimumCells = 16.0;
constexpr double FinestLaw = 1e-3; // [m], reference of the last law
// From so many surfaces on, echoes are fluctuations of many: the cells grow with the root of their
// number (measured on 500 leaves of 1 cm in a beam, leaf area index 4).
constexpr double TypicalSurfaces = 150.0;
constexpr double CellsPerSubRay = 16.0; // that take as long
// Times for n surfaces and N cells across (measured on a stand of trees, leaves, gravel and maize,
// 2.3 GHz): of the division n^1.5 times; of cells for each surface, for each row of cells in it, whose
// side is sqrt(pi layers / n) radii, and for each cell [us].
constexpr double TimeOfDivision = 0.32;
constexpr double TimeOfSurface = 0.2;
constexpr double TimeOfRow = 0.008;
constexpr double TimeOfCell = 3.4e-4;

/// Sets the cells of beams with many surfaces.
void SetCells(const Tolerances& tolerances, SamplingPlan& plan)
{
  const double side = std::sqrt(1.0 * tolerances.MaximumSubRays);
  plan.MaximumSurfaces = static_cast<std::size_t>(SurfacesPerSide * side);
  plan.MaximumCellsAcross = std::min(
    FootprintRaster::MaximumAcross, 8 * static_cast<int>(side * std::sqrt(CellsPerSubRay) / 8.0));
  const CellLaw& law = *std::find_if(std::begin(CellsForRange), std::end(CellsForRange) - 1,
    [&tolerances](const CellLaw& l) { return tolerances.Range >= l.Range; });
  const double reference = std::max(law.Range, FinestLaw);
  plan.CellsAcross = std::max({ law.Cells * std::pow(reference / tolerances.Range, law.Power),
    CellsForEnergy * std::pow(0.01 / tolerances.Energy, CellPower), MinimumCells });
}

/// Sets the sub-rays of tolerances so wide that these take less time than cells: in leaves, the error of
/// their ranges (95th percentile) falls with the power 0.6 of the number (measured: BenchAccuracy).
void SetRays(const Tolerances& tolerances, SamplingPlan& plan)
{
  constexpr double range = 0.08; // [m], from which on
  constexpr double energy = 0.2;
  constexpr double number = 64.0; // for an error of the range
  constexpr double error = 0.14;  // [m]
  plan.PrefersRays = tolerances.Range >= range && tolerances.Energy >= energy;
  if (plan.PrefersRays)
  {
    const double count = number * std::pow(error / tolerances.Range, 1.0 / 0.6);
    plan.NumberOfSubRays = std::max(MinimumSubRays, 4 * static_cast<int>(std::ceil(0.25 * count)));
  }
}

} // namespace

SamplingPlan PlanSampling(const Tolerances& tolerances, double sigma)
{
  const double rangeTolerance = tolerances.Range;
  const double energyTolerance = tolerances.Energy;
  const double sigmaRange = 0.5 * SpeedOfLight * sigma;
  const double longestEcho = 4.0 * sigmaRange; // sides farther apart are separate echoes
  SamplingPlan plan;
  plan.EnergyTolerance = energyTolerance;
  plan.RangeTolerance = rangeTolerance;
  // Less than half of the amplitude tolerance, because small fractions have larger relative errors.
  plan.NumberOfSubRays =
    GetNumberOfSubRays(std::min(0.45 * energyTolerance, 4.5 * rangeTolerance / longestEcho));
  plan.MaximumSubRays = tolerances.MaximumSubRays;
  SetRays(tolerances, plan);
  SetCells(tolerances, plan);
  SetSurfaceRules(tolerances, sigmaRange, plan);
  const double h = std::sqrt(0.5 * rangeTolerance / (BinRangeLaw * sigmaRange));
  // For 4 ns, at least as fine as 0.25 ns, and 0.43 and 0.68 ns for wide tolerances. The maxima of the
  // first are within 0.3 mm of those of the sum (95th percentile, a stand of trees).
  const double widest = rangeTolerance < CoarseRange ? 0.15
    : rangeTolerance < WideRange                     ? 0.25
                                                     : 0.4;
  plan.DetectionBin = sigma * std::clamp(h, 0.03, widest);
  plan.MaximumRefined = rangeTolerance < CoarseRange ? plan.MaximumRefined : FewReturns;
  // Two returns have the mean and variance of a part. What is left: with its fourth moment the
  // amplitude errs by 0.0007 d^4, with its third one the range by up to 0.0037 d^3 sigma_R. Beyond
  // 1.2 the gaps between parts would show.
  plan.LargestDepth = std::min({ 1.2, std::pow(energyTolerance / (4 * 0.0007), 0.25),
    std::cbrt(rangeTolerance / (4 * 0.0037 * sigmaRange)) });
  plan.PairTilt = energyTolerance > FinestPairs ? PairShare * energyTolerance : 0.0;
  const double merged = std::min(energyTolerance, rangeTolerance / MergedDistance);
  plan.PartError = std::clamp(3e-4 * merged, 1e-6, 3e-5);
  plan.RimEnergy = RimShare * merged < MinimumRim ? 0.0 : std::min(RimShare * merged, MaximumRim);
  return plan;
}

int SamplingPlan::GetCellsAcross(std::size_t surfaces) const
{
  // In steps, because each size has a grid of its own.
  const double root = std::sqrt(static_cast<double>(surfaces) / TypicalSurfaces);
  const double many = std::max(1.0, 0.25 * std::ceil(4.0 * root));
  const double cells = std::min(this->CellsAcross * many, 1e6);
  return 8 * static_cast<int>(std::ceil(cells / 8.0));
}

int SamplingPlan::GetCellsAtLevel(std::size_t surfaces, int level) const
{
  const int last = std::min(this->GetCellsAcross(surfaces), this->MaximumCellsAcross);
  const int size = (last + 8) / 16 * 8 << level;
  const bool isLast = size > this->MaximumCellsAcross && size / 2 < this->MaximumCellsAcross;
  return isLast ? this->MaximumCellsAcross : size;
}

bool SamplingPlan::PrefersCells(std::size_t surfaces, double layers) const
{
  const auto count = static_cast<double>(surfaces);
  const double cells = this->GetCellsAcross(surfaces);
  return cells <= this->MaximumCellsAcross &&
    TimeOfDivision * count * std::sqrt(count) > TimeOfSurface * count +
      TimeOfRow * cells * std::sqrt(vtkMath::Pi() * layers * count) + TimeOfCell * cells * cells;
}

std::string SamplingPlan::Describe() const
{
  std::ostringstream text;
  if (this->PrefersRays)
  {
    text << "adaptive, visible areas of surfaces, or " << this->NumberOfSubRays
         << " sub-rays if most beams are full of leaves; none for planar footprints";
    return text.str();
  }
  text << "adaptive, visible areas of surfaces; beams ";
  const int cells = this->GetCellsAcross(1);
  if (cells <= this->MaximumCellsAcross)
  {
    text << "full of leaves in " << cells << " x " << cells << " cells or more, ";
  }
  text << "of more than " << this->MaximumSurfaces << " surfaces in up to "
       << this->MaximumCellsAcross << " x " << this->MaximumCellsAcross
       << " cells; none for planar footprints; waveform bin " << this->DetectionBin
       << " ns where the returns of a pulse spread over more than c sigma";
  return text.str();
}

} // namespace helios
