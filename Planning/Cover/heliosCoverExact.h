// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The fewest scans, proved by branch and cut. A build without CBC returns no answer.

#ifndef heliosCoverExact_h
#define heliosCoverExact_h

#include "heliosCoverOverlap.h"

namespace helios
{

VTKHELIOSPLANNING_EXPORT bool HasExactSolver();

struct ExactAnswer
{
  Choice Best;   // the choice given, or one of fewer scans
  int Bound = 0; // no choice has fewer scans
  bool IsProved = false;
};

/**
 * Returns the fewest scans that see enough, starting from a choice that does, within a time limit
 * [s]. With a network they are connected in it, as the choice given must be: a disconnected
 * solution is cut off by x_a + x_b - sum of x over candidates that separate a from b <= 1, for
 * members a and b of its unconnected parts, until it is connected.
 */
VTKHELIOSPLANNING_EXPORT ExactAnswer SolveCover(const CoverProblem& problem, const Choice& start,
  OverlapNetwork* network, double timeLimit, const StopTest& stop = {});

/// Returns the bound of the linear relaxation; 0: more bits than allowed, stopped, or not solved
/// within the time limit [s].
VTKHELIOSPLANNING_EXPORT double GetLinearBound(const CoverProblem& problem,
  std::int64_t maximumBits, double timeLimit, const StopTest& stop = {});

} // namespace helios

#endif
