// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Local search for a cover of fewer scans.

#ifndef heliosCoverSearch_h
#define heliosCoverSearch_h

#include "heliosCoverProblem.h"

#include <cstdint>

namespace helios
{

struct SearchSettings
{
  int Target = 1;               // number of scans at which the search ends
  int Start = 0;                // index of the random number sequence
  std::int64_t Work = 60000000; // scores changed, at most
};

/**
 * Searches locally with point weights (Gao, Weise and Li 2015, "An efficient local search heuristic
 * with row weighting for the unicost set covering problem"): removes one member, and while points
 * are missing swaps the member that loses least for the best candidate that sees a randomly drawn
 * missing point; points that stay missing gain weight. Every cover of one scan fewer is kept.
 * Random numbers are counter-based and the work is counted, so the same start gives the same
 * result. Returns the best cover found: at worst the choice given.
 */
VTKHELIOSPLANNING_EXPORT Choice SearchCover(const CoverProblem& problem, const Choice& choice,
  const SearchSettings& settings, const StopTest& stop = {});

} // namespace helios

#endif
