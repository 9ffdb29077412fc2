// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverBest.h"

#include "heliosCoverBound.h"
#include "heliosCoverGreedy.h"
#include "heliosCoverReduction.h"
#include "heliosCoverSearch.h"
#include "heliosCoverTree.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// Tolerance for rounding in a bound.
constexpr double Rounding = 1e-6;

/// Bits read for a bound.
constexpr std::int64_t BoundWork = 50000000;

/// Words read to enumerate all covers.
constexpr std::int64_t TreeWork = 20000000;

/// Searches for a cover of fewer scans. False: all were enumerated; the choice becomes the best
/// found.
bool HasFewer(const CoverProblem& problem, Choice& choice, const StopTest& stop)
{
  const BitMatrix columns = Transpose(problem.Rows);
  CoverTree tree(problem.Rows, columns.View());
  std::int64_t work = TreeWork;
  const auto take = [&choice](const Choice& cover)
  {
    choice = cover;
    return false;
  };
  CoverAnswer answer = CoverAnswer::Found;
  while (answer == CoverAnswer::Found)
  {
    answer = tree.Visit(static_cast<int>(choice.size()) - 1, take, work, stop);
  }
  return answer == CoverAnswer::Unknown;
}

} // namespace

Choice RemoveWhatIsLeft(const CoverProblem& problem, const Choice& choice, const StopTest& stop)
{
  Choice order = choice;
  std::sort(order.begin(), order.end());
  std::stable_sort(order.begin(), order.end(),
    [&problem](int a, int b)
    { return problem.GetWeight(problem.Rows.Get(a)) < problem.GetWeight(problem.Rows.Get(b)); });
  const Choice kept = RemoveRedundant(problem, order, stop);
  return problem.IsFull ? kept : RemoveToLimit(problem, kept, stop);
}

Choice ChooseBest(const CoverProblem& problem, const BestSettings& settings, const StopTest& stop)
{
  const Choice all = GetAllCandidates(problem);
  Choice best =
    RemoveWhatIsLeft(problem, ChooseByPrice(problem, GetRarityPrices(problem), stop), stop);
  const Choice greedy =
    RemoveWhatIsLeft(problem, ChooseGreedily(problem, all, stop).Candidates, stop);
  best = greedy.size() < best.size() ? greedy : best;
  if (problem.HasObjects())
  {
    return best; // the search counts no objects
  }
  const auto isFew = [&](int count) { return static_cast<int>(best.size()) <= count; };
  if (isFew(std::max(1, settings.Target)))
  {
    return best;
  }
  const double bound = GetLagrangeBound(problem, static_cast<int>(best.size()), BoundWork, stop);
  if (problem.IsFull && settings.Target == 0 && !HasFewer(problem, best, stop))
  {
    return best;
  }
  const int target = std::max(settings.Target, static_cast<int>(std::ceil(bound - Rounding)));
  for (int start = 0; start < settings.NumberOfStarts && !isFew(target); ++start)
  {
    best = SearchCover(problem, best, { target, start, settings.Work }, stop);
  }
  return best;
}

} // namespace helios
