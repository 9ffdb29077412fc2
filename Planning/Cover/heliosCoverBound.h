// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A lower bound on the number of scans, without a linear solver.

#ifndef heliosCoverBound_h
#define heliosCoverBound_h

#include "heliosCoverProblem.h"

#include <cstdint>

namespace helios
{

/**
 * Returns a Lagrangian lower bound on the number of scans, at most, and near, the bound of the
 * linear relaxation. Every vector of prices u >= 0 of points gives one,
 *
 * L(u) = sum_a min(0, 1 - sum_{v seen by a} u_v) + min_z sum_v u_v z_v,
 *
 * over the z in [0, 1] that see enough weight (all: z = 1). u ascends along the smoothed
 * subgradient (Held and Karp 1971), from u_v = 1 / (the largest viewshed that sees v). Stops when
 * the bound rounded up reaches upper, or when the work (bits read) is used up.
 */
VTKHELIOSPLANNING_EXPORT double GetLagrangeBound(
  const CoverProblem& problem, int upper, std::int64_t work = 400000000, const StopTest& stop = {});

} // namespace helios

#endif
