// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Among choices of so many scans: the one whose worst, then mean incidence is best.

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
  /// Pairs beyond which there is no table.
  static constexpr std::int64_t MaximumPairs = 20000000;

  AngleTable(const CoverProblem& problem, const Incidence& incidence);

  const double* Get(int candidate) const
  {
    return this->Angles.data() + static_cast<std::size_t>(candidate) * this->Points;
  }

  /// The weight of a point in means: 0 without a normal.
  const std::vector<double>& GetWeights() const { return this->Weights; }

  /// Who sees what at most so obliquely.
  BitMatrix Restrict(double angle) const;

  /// Distinct angles in [the smallest worst angle of all candidates together, below).
  std::vector<double> GetThresholds(double below) const;

private:
  int Candidates;
  int Points;
  std::vector<double> Angles;
  std::vector<double> Weights;
};

/// Looks for a cover of at most so many scans, and puts it into the choice.
using CoverSolver = std::function<CoverAnswer(const CoverProblem&, int count, Choice& choice)>;

/**
 * The smallest worst angle of covers of as many scans: a cover that sees every point at most so
 * obliquely is a cover of the problem with fewer bits, and the smallest such angle is found by
 * bisection over the distinct ones. The choice becomes that cover. True: the solver has answered
 * every question, so there is no smaller one.
 */
VTKHELIOSPLANNING_EXPORT bool MinimiseWorst(const CoverProblem& problem, const AngleTable& table,
  const Incidence& incidence, const CoverSolver& solver, Choice& choice);

/**
 * The smallest mean among covers of as many scans whose worst angle is not larger: goes through all
 * of them (CoverTree). True: it has seen all within the work (words and angles looked at).
 */
VTKHELIOSPLANNING_EXPORT bool MinimiseMean(const CoverProblem& problem, const AngleTable& table,
  const Incidence& incidence, std::int64_t work, Choice& choice, const StopTest& stop = {});

/**
 * Swaps a member for another candidate as long as worst, then mean get better and enough stays
 * covered, and connected where there is a network; after so much work (words and angles looked at)
 * it stops.
 */
VTKHELIOSPLANNING_EXPORT void ImproveBySwaps(const CoverProblem& problem,
  const Incidence& incidence, const OverlapNetwork* network, std::int64_t work, Choice& choice,
  const StopTest& stop = {});

} // namespace helios

#endif
