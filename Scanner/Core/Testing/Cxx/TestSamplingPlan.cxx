// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSamplingPlan.h"

#include "heliosConstants.h"

#include <catch2/catch.hpp>

using helios::PlanSampling;

TEST_CASE("SamplingPlan: sub-rays by the tolerances", "[SamplingPlan]")
{
  constexpr double sigma = 4.0 / helios::FwhmPerSigma;
  const helios::SamplingPlan plan = PlanSampling(1e-3, 1e-2, sigma);
  CHECK(plan.NumberOfSubRays == 336);
  CHECK(plan.SmoothSubRays == 336);
  CHECK(plan.EdgeSubRays == 4096);
  const helios::SamplingPlan fine = PlanSampling(3e-4, 3e-3, sigma);
  CHECK(fine.NumberOfSubRays == 1660);
  CHECK(fine.EdgeSubRays == 4 * 1660);
  const helios::SamplingPlan coarse = PlanSampling(1.0, 1.0, sigma);
  CHECK(coarse.NumberOfSubRays == 64);
  CHECK(coarse.SmoothSubRays == 256);
  CHECK(coarse.EdgeSubRays == 4096);
}
