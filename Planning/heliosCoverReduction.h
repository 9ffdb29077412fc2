// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's reduction: candidates leave as long as others see all they see.

#ifndef heliosCoverReduction_h
#define heliosCoverReduction_h

#include "heliosCoverProblem.h"

namespace helios
{

/**
 * Candidates by a key, the first to be removed first: those that see nothing (whose key may be NaN),
 * then by ascending or descending key; ties by lower index.
 */
VTKHELIOSPLANNING_EXPORT Choice SortForRemoval(
  const CoverProblem& problem, const std::vector<double>& keys, bool isAscending);

/// Viewsheds' weights: the key of the order viewshedSize.
VTKHELIOSPLANNING_EXPORT std::vector<double> GetViewshedWeights(const CoverProblem& problem);

/**
 * Removes, in that order, every candidate that sees no point alone. One pass does, since what a
 * candidate sees alone only grows while others leave: O(bits set). Keeps the order.
 */
VTKHELIOSPLANNING_EXPORT Choice RemoveRedundant(
  const CoverProblem& problem, const Choice& order, const StopTest& stop = {});

/**
 * The paper's coverage-limited step: removes the one that sees least alone (ties: lowest index) as
 * long as what is required stays covered.
 */
VTKHELIOSPLANNING_EXPORT Choice RemoveToLimit(
  const CoverProblem& problem, Choice choice, const StopTest& stop = {});

} // namespace helios

#endif
