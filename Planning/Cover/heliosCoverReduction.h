// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's reduction: removes candidates whose points are all seen by others.

#ifndef heliosCoverReduction_h
#define heliosCoverReduction_h

#include "heliosCoverProblem.h"

namespace helios
{

/**
 * Candidates in order of removal: those that see nothing (whose key may be NaN) first, then by
 * ascending or descending key; ties by lower index.
 */
VTKHELIOSPLANNING_EXPORT Choice SortForRemoval(
  const CoverProblem& problem, const std::vector<double>& keys, bool isAscending);

/// Returns the weights of the viewsheds: the key of the order viewshedSize.
VTKHELIOSPLANNING_EXPORT std::vector<double> GetViewshedWeights(const CoverProblem& problem);

/**
 * Removes, in that order, every candidate that sees no point exclusively. One pass is enough, since
 * exclusive points only increase while others leave: O(bits set). Keeps the order.
 */
VTKHELIOSPLANNING_EXPORT Choice RemoveRedundant(
  const CoverProblem& problem, const Choice& order, const StopTest& stop = {});

/**
 * Returns the paper's coverage-limited step: removes the candidate that sees the fewest points
 * exclusively (ties: lowest index) as long as the required weight stays covered.
 */
VTKHELIOSPLANNING_EXPORT Choice RemoveToLimit(
  const CoverProblem& problem, Choice choice, const StopTest& stop = {});

} // namespace helios

#endif
