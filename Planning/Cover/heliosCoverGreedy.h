// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Greedy selection of scan positions.

#ifndef heliosCoverGreedy_h
#define heliosCoverGreedy_h

#include "heliosCoverProblem.h"

namespace helios
{

/// A choice in order of selection, and the number of points each adds.
struct GreedyChoice
{
  Choice Candidates;
  std::vector<int> NewlyCovered;
};

/**
 * Takes the candidate of a list that adds most weight (ties: lowest index), until enough is
 * covered. Lazy evaluation: gains only fall, so only the best of the previous gains are recomputed.
 */
VTKHELIOSPLANNING_EXPORT GreedyChoice ChooseGreedily(
  const CoverProblem& problem, const Choice& candidates, const StopTest& stop = {});

/**
 * Returns the same with other gains: a point counts its price. Prices of 1/c^2, for a point seen by
 * c candidates, favour points that are hard to see.
 */
VTKHELIOSPLANNING_EXPORT Choice ChooseByPrice(
  const CoverProblem& problem, const std::vector<double>& prices, const StopTest& stop = {});

/// Returns 1/c^2 per point, times its weight.
VTKHELIOSPLANNING_EXPORT std::vector<double> GetRarityPrices(const CoverProblem& problem);

/// Returns the whole choice in order of decreasing gain; members that add nothing last.
VTKHELIOSPLANNING_EXPORT GreedyChoice SortByGain(const CoverProblem& problem, const Choice& choice);

/// Returns all candidates of a problem.
VTKHELIOSPLANNING_EXPORT Choice GetAllCandidates(const CoverProblem& problem);

} // namespace helios

#endif
