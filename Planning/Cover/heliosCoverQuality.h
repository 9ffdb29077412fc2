// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Among choices of the same number of scans: the one with the best worst, then mean incidence.

#ifndef heliosCoverQuality_h
#define heliosCoverQuality_h

#include "heliosCoverOverlap.h"
#include "heliosCoverTree.h"
#include "heliosIncidence.h"

#include <cstdint>

namespace helios
{

/// The angle of every candidate to every point [deg]; infinite: not seen. 0 without a normal.
class VTKHELIOSPLANNING_EXPORT AngleTable
{
public:
  /// More pairs than this: no table.
  static constexpr std::int64_t MaximumPairs = 20000000;

  AngleTable(const CoverProblem& problem, const Incidence& incidence);

  const double* Get(int candidate) const
  {
    return this->Angles.data() + static_cast<std::size_t>(candidate) * this->Points;
  }

  /// Returns the weight of each point in means: 0 without a normal.
  const std::vector<double>& GetWeights() const { return this->Weights; }

  /// Returns the visibility matrix restricted to angles up to this one.
  BitMatrix Restrict(double angle) const;

  /// Returns the distinct angles from the worst angle of all candidates together to below
  /// (exclusive).
  std::vector<double> GetThresholds(double below) const;

private:
  int Candidates;
  int Points;
  std::vector<double> Angles;
  std::vector<double> Weights;
};

/// Searches for a cover of at most count scans and writes it to choice.
using CoverSolver = std::function<CoverAnswer(const CoverProblem&, int count, Choice& choice)>;

/**
 * Finds a cover with the smallest worst angle among covers of the same number of scans. A cover
 * that sees every point at an angle up to a limit is a cover of the problem with fewer bits; the
 * smallest such limit is found by bisection over the distinct angles. The choice becomes that
 * cover. True: the solver answered every query, so no smaller one exists.
 */
VTKHELIOSPLANNING_EXPORT bool MinimiseWorst(const CoverProblem& problem, const AngleTable& table,
  const Incidence& incidence, const CoverSolver& solver, Choice& choice);

/**
 * Finds a cover with the smallest mean among covers of the same number of scans and no larger worst
 * angle: enumerates all (CoverTree). True: the enumeration was complete within the work (words and
 * angles read).
 */
VTKHELIOSPLANNING_EXPORT bool MinimiseMean(const CoverProblem& problem, const AngleTable& table,
  const Incidence& incidence, std::int64_t work, Choice& choice, const StopTest& stop = {});

/**
 * Swaps a member for another candidate as long as worst, then mean improve and enough stays
 * covered, and connected if there is a network; stops when the work (words and angles read) is used
 * up.
 */
VTKHELIOSPLANNING_EXPORT void ImproveBySwaps(const CoverProblem& problem,
  const Incidence& incidence, const OverlapNetwork* network, std::int64_t work, Choice& choice,
  const StopTest& stop = {});

} // namespace helios

#endif
