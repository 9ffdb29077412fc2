// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Choosing scan positions one after the other.

#ifndef heliosCoverGreedy_h
#define heliosCoverGreedy_h

#include "heliosCoverProblem.h"

namespace helios
{

/// A choice in the order of choosing, and the points each adds.
struct GreedyChoice
{
  Choice Candidates;
  std::vector<int> NewlyCovered;
};

/**
 * Until enough is covered, takes the candidate of a list that adds most weight (ties: lowest
 * index). Lazily: a gain only falls, so only the best of yesterday's gains are computed anew.
 */
VTKHELIOSPLANNING_EXPORT GreedyChoice ChooseGreedily(
  const CoverProblem& problem, const Choice& candidates, const StopTest& stop = {});

/**
 * The same with other gains: a point counts its price. Prices 1/c^2, of a point that c candidates
 * see, make for the points that are hard to see first.
 */
VTKHELIOSPLANNING_EXPORT Choice ChooseByPrice(
  const CoverProblem& problem, const std::vector<double>& prices, const StopTest& stop = {});

/// 1/c^2 a point, times its weight.
VTKHELIOSPLANNING_EXPORT std::vector<double> GetRarityPrices(const CoverProblem& problem);

/// All of a choice, those first that add most; whoever adds nothing last.
VTKHELIOSPLANNING_EXPORT GreedyChoice SortByGain(const CoverProblem& problem, const Choice& choice);

/// All candidates of a problem.
VTKHELIOSPLANNING_EXPORT Choice GetAllCandidates(const CoverProblem& problem);

} // namespace helios

#endif
