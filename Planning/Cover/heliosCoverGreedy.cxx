// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverGreedy.h"

#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

namespace helios
{

namespace
{

struct Offer
{
  double Gain;
  int Candidate;

  /// Orders a priority queue: the larger gain, then the lower index.
  bool operator<(const Offer& o) const
  {
    return this->Gain != o.Gain ? this->Gain < o.Gain : this->Candidate > o.Candidate;
  }
};

/// Calls take(candidate) on the best offer by gain(candidate), until done() or none is left.
template <typename GainT, typename DoneT, typename VisitT>
void VisitBest(const Choice& candidates, GainT gain, DoneT done, VisitT take)
{
  std::priority_queue<Offer> offers;
  for (const int candidate : candidates)
  {
    offers.push({ gain(candidate), candidate });
  }
  while (!offers.empty() && !done())
  {
    Offer best = offers.top();
    offers.pop();
    const double now = gain(best.Candidate);
    if (now < best.Gain && !offers.empty() && Offer{ now, best.Candidate } < offers.top())
    {
      offers.push({ now, best.Candidate });
    }
    else
    {
      take(best.Candidate);
    }
  }
}

} // namespace

GreedyChoice ChooseGreedily(
  const CoverProblem& problem, const Choice& candidates, const StopTest& stop)
{
  GreedyChoice result;
  CoverCounts counts(problem);
  int covered = 0;
  VisitBest(
    candidates, [&](int c) { return counts.GetGain(c); },
    [&] { return counts.IsEnough() || (stop && stop()); },
    [&](int c)
    {
      counts.Add(c);
      const int now = CountBits(counts.GetCovered().data(), problem.Rows.Length);
      result.Candidates.push_back(c);
      result.NewlyCovered.push_back(now - covered);
      covered = now;
    });
  return result;
}

Choice ChooseByPrice(
  const CoverProblem& problem, const std::vector<double>& prices, const StopTest& stop)
{
  Choice result;
  CoverCounts counts(problem);
  const auto gain = [&](int c)
  {
    const Word* row = problem.Rows.Get(c);
    double sum = 0.0;
    for (int w = 0; w < problem.Rows.Length; ++w)
    {
      VisitWord(row[w] & ~counts.GetCovered()[w], w,
        [&](int v) { sum += counts.IsNeeded(v) ? prices[v] : 0.0; });
    }
    return sum;
  };
  VisitBest(
    GetAllCandidates(problem), gain, [&] { return counts.IsEnough() || (stop && stop()); },
    [&](int c)
    {
      counts.Add(c);
      result.push_back(c);
    });
  return result;
}

std::vector<double> GetRarityPrices(const CoverProblem& problem)
{
  std::vector<double> prices(problem.Rows.Columns);
  for (int c = 0; c < problem.Rows.Rows; ++c)
  {
    VisitBits(problem.Rows.Get(c), problem.Rows.Length, [&](int v) { prices[v] += 1.0; });
  }
  for (int v = 0; v < problem.Rows.Columns; ++v)
  {
    prices[v] = prices[v] > 0.0 ? problem.GetWeight(v) / (prices[v] * prices[v]) : 0.0;
  }
  return prices;
}

GreedyChoice SortByGain(const CoverProblem& problem, const Choice& choice)
{
  CoverProblem whole = problem;
  whole.IsFull = false;
  whole.Required = HUGE_VAL;
  whole.Objects = {};
  return ChooseGreedily(whole, choice);
}

Choice GetAllCandidates(const CoverProblem& problem)
{
  Choice all(problem.Rows.Rows);
  std::iota(all.begin(), all.end(), 0);
  return all;
}

} // namespace helios
