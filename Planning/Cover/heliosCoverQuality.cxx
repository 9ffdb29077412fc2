// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverQuality.h"

#include "heliosCoverDominance.h"
#include "heliosCoverTree.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// Relative tolerance for comparing sums.
constexpr double Rounding = 1e-12;

/// The sum of best angles, by weight.
class MeanSum
{
public:
  MeanSum(const AngleTable& table, std::int64_t& work)
    : Table(table)
    , Work(work)
  {
  }

  double Get(const Choice& choice)
  {
    const std::vector<double>& weights = this->Table.GetWeights();
    this->Angles.assign(weights.size(), HUGE_VAL);
    for (const int a : choice)
    {
      const double* angles = this->Table.Get(a);
      for (std::size_t v = 0; v < weights.size(); ++v)
      {
        this->Angles[v] = std::min(this->Angles[v], angles[v]);
      }
    }
    double sum = 0.0;
    for (std::size_t v = 0; v < weights.size(); ++v)
    {
      sum += this->Angles[v] < HUGE_VAL ? weights[v] * this->Angles[v] : 0.0;
    }
    this->Work -= static_cast<std::int64_t>(weights.size() * (choice.size() + 1));
    return sum;
  }

private:
  const AngleTable& Table;
  std::int64_t& Work;
  std::vector<double> Angles;
};

} // namespace

bool MinimiseWorst(const CoverProblem& problem, const AngleTable& table, const Incidence& incidence,
  const CoverSolver& solver, Choice& choice)
{
  const auto getWorst = [&](const Choice& c)
  { return Incidence::ComputeQuality(problem, incidence.GetBest(problem, c)).Worst; };
  const std::vector<double> angles = table.GetThresholds(getWorst(choice));
  const int count = static_cast<int>(choice.size());
  bool isProved = true;
  std::size_t low = 0;
  std::size_t high = angles.size(); // the angle of the choice
  while (low < high)
  {
    const std::size_t middle = (low + high) / 2;
    const BitMatrix rows = table.Restrict(angles[middle]);
    Choice better;
    const CoverAnswer answer = solver(CoverProblem(rows.View(), problem.Weights), count, better);
    if (answer == CoverAnswer::Found)
    {
      choice = better;
      high = std::lower_bound(angles.begin(), angles.end(), getWorst(better)) - angles.begin();
      high = std::min(high, middle);
    }
    else
    {
      low = middle + 1;
      isProved = isProved && answer == CoverAnswer::None;
    }
  }
  return isProved;
}

bool MinimiseMean(const CoverProblem& problem, const AngleTable& table, const Incidence& incidence,
  std::int64_t work, Choice& choice, const StopTest& stop)
{
  const double worst = Incidence::ComputeQuality(problem, incidence.GetBest(problem, choice)).Worst;
  const BitMatrix rows = table.Restrict(worst);
  const CoverProblem restricted(rows.View(), problem.Weights);
  const ReducedCover reduced = ReduceCover(restricted, { false, true }, stop);
  MeanSum sums(table, work);
  std::sort(choice.begin(), choice.end());
  double minimum = sums.Get(choice);
  const auto weigh = [&](const Choice& cover)
  {
    Choice sorted = cover;
    std::sort(sorted.begin(), sorted.end());
    const double sum = sums.Get(sorted);
    if (sum < minimum * (1.0 - Rounding) || (sum <= minimum * (1.0 + Rounding) && sorted < choice))
    {
      minimum = std::min(sum, minimum);
      choice = sorted;
    }
    return true;
  };
  return CoverTree(reduced.Rows.View(), reduced.Columns.View())
           .Visit(static_cast<int>(choice.size()), weigh, work, stop) == CoverAnswer::None;
}

} // namespace helios
