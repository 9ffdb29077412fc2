// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A good cover in short time: greedy methods, removal of redundant scans, and local search.

#ifndef heliosCoverBest_h
#define heliosCoverBest_h

#include "heliosCoverProblem.h"

#include <cstdint>

namespace helios
{

struct BestSettings
{
  int NumberOfStarts = 4;       // starts of the local search
  int Target = 0;               // number of scans at which the search ends
  std::int64_t Work = 60000000; // work of one local search
};

/**
 * Chooses a cover of a reduced problem: the better of greedy and greedy by rarity (1/c^2), without
 * redundant scans; then local searches from it, until a lower bound shows that no better cover
 * exists.
 */
VTKHELIOSPLANNING_EXPORT Choice ChooseBest(
  const CoverProblem& problem, const BestSettings& settings, const StopTest& stop = {});

/// Removes redundant candidates, the smallest viewsheds first.
VTKHELIOSPLANNING_EXPORT Choice RemoveWhatIsLeft(
  const CoverProblem& problem, const Choice& choice, const StopTest& stop = {});

} // namespace helios

#endif
