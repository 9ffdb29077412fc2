// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Removes dominated candidates and points from a cover problem.

#ifndef heliosCoverDominance_h
#define heliosCoverDominance_h

#include "heliosCoverProblem.h"

#include <cstdint>

namespace helios
{

/// A smaller problem, with the rows and columns of the larger one that it keeps.
struct VTKHELIOSPLANNING_EXPORT ReducedCover
{
  CoverProblem Problem; // refers to Rows
  BitMatrix Rows;       // candidates by points
  BitMatrix Columns;    // points by candidates
  std::vector<int> Candidates;
  std::vector<int> Points;

  ReducedCover() = default;
  ReducedCover(ReducedCover&&) = default;
  ReducedCover& operator=(ReducedCover&&) = default;

  /// Maps a choice of the smaller problem to the larger one.
  Choice Restore(const Choice& choice) const;
};

/// Rules for what may be removed.
struct DominanceRules
{
  bool Candidates = true;         // not with a required overlap: a small viewshed may link others
  bool Points = true;             // not if a part of the points is enough
  std::int64_t Work = 1500000000; // words read, at most
};

/**
 * Removes candidates whose viewshed is contained in another's, points seen by all candidates that
 * see some other point (of equal ones the first stays), and points that none sees; repeats until
 * nothing changes. The fewest scans and the linear bound do not change.
 *
 * The points implied by point q are the bits common to the viewsheds of all candidates that see q:
 * rare points first, since these have the fewest, stopping when only q is left. The same with
 * candidates and points swapped. When the work is used up the rest stays unchanged.
 */
VTKHELIOSPLANNING_EXPORT ReducedCover ReduceCover(
  const CoverProblem& problem, DominanceRules rules, const StopTest& stop = {});

} // namespace helios

#endif
