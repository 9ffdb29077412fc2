// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What a cover need not look at: candidates that see no more than another, points that come with others.

#ifndef heliosCoverDominance_h
#define heliosCoverDominance_h

#include "heliosCoverProblem.h"

#include <cstdint>

namespace helios
{

/// A smaller problem, and what its rows and columns are in the larger one.
struct VTKHELIOSPLANNING_EXPORT ReducedCover
{
  CoverProblem Problem; // looks at Rows
  BitMatrix Rows;       // candidates by points
  BitMatrix Columns;    // points by candidates
  std::vector<int> Candidates;
  std::vector<int> Points;

  ReducedCover() = default;
  ReducedCover(ReducedCover&&) = default;
  ReducedCover& operator=(ReducedCover&&) = default;

  /// A choice of the smaller problem in the larger one.
  Choice Restore(const Choice& choice) const;
};

/// What may be left out.
struct DominanceRules
{
  bool Candidates = true;         // not where an overlap is asked: a small viewshed may link others
  bool Points = true;             // not where a part of the points will do
  std::int64_t Work = 1500000000; // words looked at, at most
};

/**
 * Leaves out candidates whose viewshed is in another's, and points that are seen by all who see
 * some other point (of equal ones the first stays), and points that none sees; again until nothing
 * changes. The fewest scans, and the linear bound, stay what they are.
 *
 * The points that come with point q are the bits common to the viewsheds of all who see q: rare
 * points first, since these have the fewest, and stopping when only q is left. The same with
 * candidates and points swapped. When the work allowed is done the rest stays as it is.
 */
VTKHELIOSPLANNING_EXPORT ReducedCover ReduceCover(
  const CoverProblem& problem, DominanceRules rules, const StopTest& stop = {});

} // namespace helios

#endif
