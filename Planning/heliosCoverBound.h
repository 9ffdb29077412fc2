// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How many scans it takes at least, without a linear solver.

#ifndef heliosCoverBound_h
#define heliosCoverBound_h

#include "heliosCoverProblem.h"

#include <cstdint>

namespace helios
{

/**
 * A lower bound of the number of scans, at most the one of the linear relaxation and near it:
 * Lagrange's. Every price u >= 0 of being seen gives one,
 *
 *   L(u) = sum_a min(0, 1 - sum_{v seen by a} u_v) + min_z sum_v u_v z_v,
 *
 * over the z in [0, 1] that see enough weight (all: z = 1); u climbs along the subgradient (Held and
 * Karp 1971), smoothed, from u_v = 1 / (the largest viewshed that sees v). Stops when rounding up
 * reaches upper, or after so much work (bits looked at).
 */
VTKHELIOSPLANNING_EXPORT double GetLagrangeBound(
  const CoverProblem& problem, int upper, std::int64_t work = 400000000, const StopTest& stop = {});

} // namespace helios

#endif
