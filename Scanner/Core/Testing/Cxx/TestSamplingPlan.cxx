// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSamplingPlan.h"

#include "heliosConstants.h"

#include <catch2/catch.hpp>

using helios::PlanSampling;
using helios::ProbeRays;

TEST_CASE("SamplingPlan: probe rays by the tolerances", "[SamplingPlan]")
{
  constexpr double sigma = 4.0 / helios::FwhmPerSigma;
  CHECK(PlanSampling(1e-3, 1e-2, sigma).Probes == ProbeRays::Few);
  CHECK(PlanSampling(1e-3, 2e-3, sigma).Probes == ProbeRays::Few);
  CHECK(PlanSampling(1e-3, 1.9e-3, sigma).Probes == ProbeRays::Many);
  // So coarse that the sub-rays of an edge are no more than the probe rays.
  const helios::SamplingPlan coarse = PlanSampling(1.0, 1.0, sigma);
  CHECK(coarse.Probes == ProbeRays::All);
  CHECK(coarse.NumberOfSubRays == 16);
}
