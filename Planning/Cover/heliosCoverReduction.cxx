// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverReduction.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace helios
{

Choice SortForRemoval(
  const CoverProblem& problem, const std::vector<double>& keys, bool isAscending)
{
  std::vector<std::pair<double, int>> sorted(keys.size());
  for (int c = 0; c < problem.Rows.Rows; ++c)
  {
    const double key = isAscending ? keys[c] : -keys[c];
    sorted[c] = { problem.Rows.GetSize(c) == 0 || std::isnan(key) ? -HUGE_VAL : key, c };
  }
  std::sort(sorted.begin(), sorted.end());
  Choice order;
  for (const auto& [key, candidate] : sorted)
  {
    order.push_back(candidate);
  }
  return order;
}

std::vector<double> GetViewshedWeights(const CoverProblem& problem)
{
  std::vector<double> weights(problem.Rows.Rows);
  for (int c = 0; c < problem.Rows.Rows; ++c)
  {
    weights[c] = problem.GetWeight(problem.Rows.Get(c));
  }
  return weights;
}

Choice RemoveRedundant(const CoverProblem& problem, const Choice& order, const StopTest& stop)
{
  CoverCounts counts(problem, order);
  Choice kept;
  for (const int candidate : order)
  {
    if (stop && stop())
    {
      break;
    }
    if (counts.IsRedundant(candidate))
    {
      counts.Remove(candidate);
    }
    else
    {
      kept.push_back(candidate);
    }
  }
  return kept;
}

Choice RemoveToLimit(const CoverProblem& problem, Choice choice, const StopTest& stop)
{
  CoverCounts counts(problem, choice);
  std::sort(choice.begin(), choice.end());
  bool isOn = true;
  while (isOn && !(stop && stop()))
  {
    // One that sees little may be the only one to see enough of an object.
    auto minimum = choice.end();
    for (auto c = choice.begin(); c != choice.end(); ++c)
    {
      const bool isLess = minimum == choice.end() ||
        counts.GetExclusiveWeight(*c) < counts.GetExclusiveWeight(*minimum);
      minimum = isLess && counts.IsEnoughWithout(*c) ? c : minimum;
    }
    isOn = minimum != choice.end();
    if (isOn)
    {
      counts.Remove(*minimum);
      choice.erase(minimum);
    }
  }
  return choice;
}

} // namespace helios
