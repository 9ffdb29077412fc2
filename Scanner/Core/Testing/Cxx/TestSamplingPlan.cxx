// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSamplingPlan.h"

#include "heliosConstants.h"
#include "vtkHeliosBeamSampler.h"

#include <catch2/catch.hpp>

#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <utility>

using helios::PlanSampling;

TEST_CASE("SamplingPlan: sub-rays by the tolerances", "[SamplingPlan]")
{
  constexpr double sigma = 4.0 / helios::FwhmPerSigma;
  const helios::SamplingPlan plan = PlanSampling({ 1e-3, 1e-2 }, sigma);
  CHECK(plan.NumberOfSubRays == 336);
  CHECK(plan.LayerRings == 2);
  CHECK(plan.GetCellsAcross(100) == 440);
  CHECK(plan.GetCellsAcross(600) == 880);
  CHECK(plan.GetCellsAtLevel(100, 0) == 224);
  CHECK(plan.GetCellsAtLevel(100, 1) == 448);
  CHECK(plan.GetCellsAtLevel(100, 2) == 896);
  CHECK(plan.GetCellsAtLevel(100, 3) == plan.MaximumCellsAcross);
  CHECK(plan.GetCellsAtLevel(100, 4) > plan.MaximumCellsAcross);
  CHECK(PlanSampling({ 3e-3, 3e-2 }, sigma).GetCellsAcross(1) == 248);
  CHECK(PlanSampling({ 1e-2, 1e-1 }, sigma).GetCellsAcross(1) == 128);
  CHECK(plan.GetCellsAtLevel(2500, 1) == plan.MaximumCellsAcross);
  const helios::SamplingPlan fine = PlanSampling({ 3e-4, 3e-3 }, sigma);
  CHECK(fine.NumberOfSubRays == 1660);
  CHECK(fine.GetCellsAcross(1) == 1024);
  CHECK(fine.GetCellsAcross(600) > fine.MaximumCellsAcross);
  CHECK(fine.LayerRings == 3);
  CHECK(PlanSampling({ 1e-4, 1e-4 }, sigma).LayerRings == 0);
  const helios::SamplingPlan coarse = PlanSampling({ 1.0, 1.0 }, sigma);
  CHECK(coarse.NumberOfSubRays == 64);
}

TEST_CASE(
  "SamplingPlan: cells for many small surfaces, division for few or large ones", "[SamplingPlan]")
{
  const helios::SamplingPlan fine = PlanSampling({ 1e-3, 1e-2 }, 1.7);
  const helios::SamplingPlan coarse = PlanSampling({ 3e-2, 3e-1 }, 1.7);
  CHECK(coarse.GetCellsAcross(1) == 40);
  CHECK(PlanSampling({ 1.0, 1.0 }, 1.7).GetCellsAcross(1) == 16);
  CHECK(PlanSampling({ 1.0, 1e-2 }, 1.7).GetCellsAcross(1) == 80);
  CHECK(fine.PrefersCells(160, 6.0));
  CHECK_FALSE(fine.PrefersCells(160, 60.0));
  CHECK_FALSE(fine.PrefersCells(20, 2.0));
  CHECK(coarse.PrefersCells(20, 2.0));
  CHECK_FALSE(coarse.PrefersCells(2, 1.0));
  CHECK_FALSE(PlanSampling({ 3e-4, 3e-3 }, 1.7).PrefersCells(400, 10.0));
}

TEST_CASE("SamplingPlan: the maxima of bins will do for wide tolerances", "[SamplingPlan]")
{
  CHECK(PlanSampling({ 3e-3, 3e-2 }, 1.7).MaximumRefined > 1000000);
  CHECK(PlanSampling({ 1e-2, 1e-1 }, 1.7).MaximumRefined == 32);
  CHECK(PlanSampling({ 1e-2, 1e-1 }, 1.7).DetectionBin == Approx(0.25 * 1.7));
  CHECK(PlanSampling({ 3e-2, 3e-1 }, 1.7).DetectionBin == Approx(0.4 * 1.7));
}

TEST_CASE("SamplingPlan: rays for the widest tolerances only", "[SamplingPlan]")
{
  const helios::SamplingPlan plan = PlanSampling({ 0.1, 0.5 }, 1.7);
  CHECK(plan.PrefersRays);
  CHECK(plan.NumberOfSubRays == 116);
  CHECK_FALSE(PlanSampling({ 0.1, 0.1 }, 1.7).PrefersRays);
  CHECK_FALSE(PlanSampling({ 0.07, 0.5 }, 1.7).PrefersRays);
  CHECK(PlanSampling({ 1.0, 1.0 }, 1.7).NumberOfSubRays == 64);
}

TEST_CASE("SamplingPlan: wide tolerances leave out the rim of a beam", "[SamplingPlan]")
{
  CHECK(PlanSampling({ 1e-3, 1e-2 }, 1.7).RimEnergy == 0.0);
  CHECK(PlanSampling({ 1.0, 1e-2 }, 1.7).RimEnergy == 0.0);
  CHECK(PlanSampling({ 3e-3, 1.0 }, 1.7).RimEnergy == Approx(4.5e-3));
  CHECK(PlanSampling({ 1e-2, 1e-1 }, 1.7).RimEnergy == Approx(1.5e-2));
  CHECK(PlanSampling({ 1.0, 1.0 }, 1.7).RimEnergy == Approx(1.5e-2)); // less than 2 %
}

TEST_CASE("SamplingPlan: the limit of sub-rays bounds cells, rays and surfaces", "[SamplingPlan]")
{
  const helios::SamplingPlan plan = PlanSampling({ 1e-3, 1e-2, 1 << 20 }, 1.7);
  CHECK(plan.MaximumCellsAcross == 2048);
  CHECK(plan.MaximumSurfaces == 2048);
  CHECK(plan.MaximumSubRays == 1 << 20);
  const helios::SamplingPlan least = PlanSampling({ 1e-3, 1e-2, 1024 }, 1.7);
  CHECK(least.GetCellsAtLevel(1000, 1) <= least.MaximumCellsAcross);
}

TEST_CASE("SamplingPlan: the errors of rings are those of the layer rules", "[SamplingPlan]")
{
  constexpr double tolerance = 1e-2;
  for (const double energy : { 1e-2, 3e-3, 1.1e-3 })
  {
    const helios::SamplingPlan plan = PlanSampling({ tolerance, energy }, 1.7);
    vtkNew<vtkHeliosBeamSampler> sampler;
    sampler->SetBeamDivergence(2e-3);
    sampler->SetPatternToGaussLegendre();
    sampler->SetNumberOfRings(plan.LayerRings);
    const double rim = 1e-3 * sampler->GetTruncation();
    // Energies and means beyond a line through the beam, against a fine spiral.
    vtkNew<vtkHeliosBeamSampler> fine;
    fine->SetBeamDivergence(2e-3);
    fine->SetPatternToVogel();
    fine->SetNumberOfSubRays(65536);
    double largestBend = 0.0;
    double squares = 0.0;
    int count = 0;
    for (int turn = 0; turn < 8; ++turn)
    {
      for (double offset = -0.95; offset < 1.0; offset += 0.1)
      {
        const auto sum = [&](vtkHeliosBeamSampler* beam, bool isBend)
        {
          double total = 0.0;
          for (int k = 0; k < beam->GetNumberOfSubRays(); ++k)
          {
            double d[3];
            beam->GetDirection(k, d);
            const double along = (std::cos(0.1 * turn) * d[0] + std::sin(0.1 * turn) * d[2]) / rim;
            const double beyond = (along - offset) / (1.0 - offset);
            total += beyond > 0.0 ? beam->GetWeight(k) * (isBend ? beyond : 1.0) : 0.0;
          }
          return total;
        };
        largestBend = std::max(largestBend, std::abs(sum(sampler, true) - sum(fine, true)));
        squares += std::pow(sum(sampler, false) - sum(fine, false), 2);
        ++count;
      }
    }
    CAPTURE(energy, plan.LayerRings);
    CHECK(largestBend * plan.LayerDistance <= 0.5 * tolerance);
    CHECK(std::sqrt(squares / count) * plan.LayerContrast <= 0.5 * energy);
  }
}

namespace
{

/// The largest amplitude of a beam on a plane, whose range at the rim is so many sigma_R from that
/// on the axis, in the direction of a turn; and the number of its maxima.
std::pair<double, int> GetPlaneEcho(vtkHeliosBeamSampler* beam, double sigmas, double turn)
{
  const double rim = 1e-3 * beam->GetTruncation();
  double largest = 0.0;
  int maxima = 0;
  double before[2] = { 0.0, 0.0 };
  for (double t = -1.2 * sigmas - 3.0; t < 1.2 * sigmas + 3.0; t += 0.05)
  {
    double sum = 0.0;
    for (int k = 0; k < beam->GetNumberOfSubRays(); ++k)
    {
      double d[3];
      beam->GetDirection(k, d);
      const double along = (std::cos(turn) * d[0] + std::sin(turn) * d[2]) / rim;
      sum += beam->GetWeight(k) * std::exp(-0.5 * std::pow(t - sigmas * along, 2));
    }
    maxima += before[1] > before[0] && before[1] >= sum && before[1] > 0.02 ? 1 : 0;
    before[0] = before[1];
    before[1] = sum;
    largest = std::max(largest, sum);
  }
  return { largest, maxima };
}

} // namespace

TEST_CASE("SamplingPlan: planes of the largest spread have one echo", "[SamplingPlan]")
{
  const double pulse = 1.7;
  const double sigmaRange = 0.5 * 0.299792458 * pulse;
  vtkNew<vtkHeliosBeamSampler> fine;
  fine->SetBeamDivergence(2e-3);
  fine->SetPatternToVogel();
  fine->SetNumberOfSubRays(4096);
  for (const double energy : { 1e-1, 1e-2, 3e-3, 1.1e-3 })
  {
    const helios::SamplingPlan plan = PlanSampling({ 0.1 * energy, energy }, pulse);
    vtkNew<vtkHeliosBeamSampler> sampler;
    sampler->SetBeamDivergence(2e-3);
    sampler->SetPatternToGaussLegendre();
    sampler->SetNumberOfRings(plan.LayerRings);
    const double most = 0.5 * plan.LayerSpread / sigmaRange;
    CAPTURE(energy, plan.LayerRings, most);
    CHECK(most >= 0.7);
    for (const double sigmas : { 0.25 * most, 0.5 * most, 0.75 * most, most })
    {
      for (const double turn : { 0.0, 0.2, 0.4, 0.6, 0.785 })
      {
        const auto [amplitude, maxima] = GetPlaneEcho(sampler, sigmas, turn);
        CHECK(maxima == 1);
        CHECK(std::abs(amplitude - GetPlaneEcho(fine, sigmas, turn).first) <= 0.5 * energy);
      }
    }
  }
}
