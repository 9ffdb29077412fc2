// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// From a cover to one of fewer scans, by local search.

#ifndef heliosCoverSearch_h
#define heliosCoverSearch_h

#include "heliosCoverProblem.h"

#include <cstdint>

namespace helios
{

struct SearchSettings
{
  int Target = 1;               // scans that are few enough
  int Start = 0;                // which sequence of random numbers
  std::int64_t Work = 60000000; // scores changed, at most
};

/**
 * Local search with weights on points (Gao, Weise and Li 2015, "An efficient local search heuristic
 * with row weighting for the unicost set covering problem"): take one out, and as long as points are
 * missing swap the one that loses least for the best of those that see a missing point, drawn at
 * random; points that stay missing gain weight. Every cover of one scan fewer is kept. Random
 * numbers are counter-based and the work is counted, so the same start gives the same answer.
 * Returns the best found: at worst the choice given.
 */
VTKHELIOSPLANNING_EXPORT Choice SearchCover(const CoverProblem& problem, const Choice& choice,
  const SearchSettings& settings, const StopTest& stop = {});

} // namespace helios

#endif
