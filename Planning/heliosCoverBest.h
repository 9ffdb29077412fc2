// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A good cover soon: greedy ways, what they leave needless removed, and local search.

#ifndef heliosCoverBest_h
#define heliosCoverBest_h

#include "heliosCoverProblem.h"

#include <cstdint>

namespace helios
{

struct BestSettings
{
  int NumberOfStarts = 4;       // of the local search
  int Target = 0;               // scans that are few enough
  std::int64_t Work = 60000000; // of a local search
};

/**
 * Of a reduced problem: the better of greedy and greedy by rarity (1/c^2), without what others see;
 * then local searches from it, until a lower bound says that there is no better one.
 */
VTKHELIOSPLANNING_EXPORT Choice ChooseBest(
  const CoverProblem& problem, const BestSettings& settings, const StopTest& stop = {});

/// Removes, the smallest viewsheds first, whoever is not needed for what is required.
VTKHELIOSPLANNING_EXPORT Choice RemoveWhatIsLeft(
  const CoverProblem& problem, const Choice& choice, const StopTest& stop = {});

} // namespace helios

#endif
