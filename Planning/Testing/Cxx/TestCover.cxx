// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Components of the planner, compared with enumeration of small problems.

#include "heliosCoverBest.h"
#include "heliosCoverBound.h"
#include "heliosCoverDominance.h"
#include "heliosCoverExact.h"
#include "heliosCoverGreedy.h"
#include "heliosCoverReduction.h"
#include "heliosCoverSearch.h"
#include "heliosCoverTree.h"
#include "heliosSmallCovers.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numeric>
#include <set>

using helios::BitMatrix;
using helios::Choice;
using helios::SmallCover;

namespace
{

/// Problems of several kinds: sparse and dense, all points or a part, counted or by area.
SmallCover MakeCover(int seed)
{
  SmallCover cover(6 + seed % 6, 10 + 7 * (seed % 11), 0.15 + 0.06 * (seed % 9), seed);
  if (seed % 3 == 1)
  {
    cover.UseAreas();
  }
  return cover;
}

void RequirePart(SmallCover& cover, int seed)
{
  const double share = 0.5 + 0.1 * (seed % 5);
  cover.Problem.Require(share * cover.Problem.GetWeight(cover.Problem.Coverable.data()));
}

/// The paper's loop, literally: the first in the order that sees no point exclusively leaves;
/// repeat.
Choice RemoveLiterally(const SmallCover& cover, const Choice& order)
{
  Choice remaining = order;
  bool isOn = true;
  while (isOn)
  {
    isOn = false;
    for (std::size_t k = 0; k < remaining.size() && !isOn; ++k)
    {
      Choice others = remaining;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      if (cover.IsEnough(others))
      {
        remaining = others;
        isOn = true;
      }
    }
  }
  return remaining;
}

bool IsMinimal(const SmallCover& cover, const Choice& choice)
{
  const helios::CoverCounts counts(cover.Problem, choice);
  return std::none_of(
    choice.begin(), choice.end(), [&counts](int a) { return counts.IsRedundant(a); });
}

constexpr int Seeds = 150;

} // namespace

TEST_CASE("Cover: transposing bits twice is the identity", "[Cover]")
{
  for (const int columns : { 1, 63, 64, 65, 200 })
  {
    const SmallCover cover(70, columns, 0.4, static_cast<unsigned int>(columns));
    const helios::BitRows rows = cover.Rows.View();
    const BitMatrix once = helios::Transpose(rows);
    const BitMatrix twice = helios::Transpose(once.View());
    bool isSame = once.View().Rows == columns && once.View().Columns == 70;
    for (int a = 0; a < rows.Rows; ++a)
    {
      for (int v = 0; v < columns; ++v)
      {
        isSame = isSame && rows.Has(a, v) == once.View().Has(v, a) &&
          rows.Has(a, v) == twice.View().Has(a, v);
      }
    }
    CHECK(isSame);
  }
}

TEST_CASE("Cover: one sorted pass equals the loop of the paper", "[Cover]")
{
  for (int seed = 0; seed < Seeds; ++seed)
  {
    const SmallCover cover = MakeCover(seed);
    const Choice order = helios::SortForRemoval(
      cover.Problem, helios::GetViewshedWeights(cover.Problem), seed % 2 == 0);
    const Choice kept = helios::RemoveRedundant(cover.Problem, order);
    INFO(seed);
    CHECK(kept == RemoveLiterally(cover, order));
    CHECK(IsMinimal(cover, kept));
  }
}

TEST_CASE("Cover: empty viewsheds are removed first, ties by lower index", "[Cover]")
{
  BitMatrix rows(4, 3);
  rows.Set(1, 0);
  rows.Set(1, 1);
  rows.Set(2, 1);
  rows.Set(3, 0);
  const helios::CoverProblem problem(rows.View());
  const double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(helios::SortForRemoval(problem, { none, 20.0, 10.0, 10.0 }, true) == Choice{ 0, 2, 3, 1 });
  CHECK(helios::SortForRemoval(problem, { none, 20.0, 10.0, 10.0 }, false) == Choice{ 0, 1, 2, 3 });
  CHECK(helios::SortForRemoval(problem, helios::GetViewshedWeights(problem), true) ==
    Choice{ 0, 2, 3, 1 });
}

TEST_CASE("Cover: every method covers, and none is better than the optimum", "[Cover]")
{
  for (int seed = 0; seed < Seeds; ++seed)
  {
    INFO(seed);
    SmallCover cover = MakeCover(seed);
    const Choice all = helios::GetAllCandidates(cover.Problem);
    const std::size_t optimum = cover.GetOptima()[0].size();
    const helios::ReducedCover reduced = helios::ReduceCover(cover.Problem, {});
    const Choice best = reduced.Restore(helios::ChooseBest(reduced.Problem, {}));
    const Choice greedy = helios::RemoveWhatIsLeft(
      cover.Problem, helios::ChooseGreedily(cover.Problem, all).Candidates);
    const Choice paper = helios::RemoveRedundant(cover.Problem, all);
    for (const Choice& choice : { best, greedy, paper })
    {
      CHECK(cover.IsEnough(choice));
      CHECK(IsMinimal(cover, choice));
      CHECK(choice.size() >= optimum);
    }
    CHECK(best.size() == optimum);
  }
}

TEST_CASE("Cover: removing dominated candidates keeps the optimum", "[Cover]")
{
  for (int seed = 0; seed < Seeds; ++seed)
  {
    INFO(seed);
    const SmallCover cover = MakeCover(seed);
    const helios::ReducedCover reduced = helios::ReduceCover(cover.Problem, {});
    SmallCover rest(reduced.Problem.Rows.Rows, reduced.Problem.Rows.Columns, 0.0, 0);
    rest.Rows = helios::SelectRows(reduced.Problem.Rows, helios::GetAllCandidates(reduced.Problem));
    rest.Problem = helios::CoverProblem(rest.Rows.View());
    CHECK(rest.GetOptima()[0].size() == cover.GetOptima()[0].size());
    CHECK(reduced.Candidates.size() <= static_cast<std::size_t>(cover.Problem.Rows.Rows));
    for (std::size_t a = 0; a < reduced.Candidates.size(); ++a)
    {
      for (std::size_t b = 0; b < reduced.Candidates.size(); ++b)
      {
        const auto i = static_cast<int>(a);
        const auto j = static_cast<int>(b);
        CHECK((a == b ||
          !helios::IsSubset(reduced.Problem.Rows.Get(i), reduced.Problem.Rows.Get(j),
            reduced.Problem.Rows.Length)));
      }
    }
  }
}

TEST_CASE("Cover: limited coverage is reached", "[Cover]")
{
  for (int seed = 0; seed < Seeds; ++seed)
  {
    INFO(seed);
    SmallCover cover = MakeCover(seed);
    RequirePart(cover, seed);
    const std::size_t optimum = cover.GetOptima()[0].size();
    const helios::ReducedCover reduced = helios::ReduceCover(cover.Problem, { true, false });
    const Choice best = reduced.Restore(helios::ChooseBest(reduced.Problem, {}));
    const Choice all = helios::GetAllCandidates(cover.Problem);
    const Choice paper =
      helios::RemoveToLimit(cover.Problem, helios::RemoveRedundant(cover.Problem, all));
    CHECK(cover.IsEnough(best));
    CHECK(cover.IsEnough(paper));
    CHECK(best.size() == optimum);
    CHECK(paper.size() >= optimum);
    CHECK(helios::GetLagrangeBound(reduced.Problem, 100) <= static_cast<double>(optimum) + 1e-9);
    if (helios::HasExactSolver())
    {
      const double linear = helios::GetLinearBound(reduced.Problem, 100000, 60.0);
      CHECK(helios::GetLagrangeBound(reduced.Problem, 100) <= linear + 1e-6);
      CHECK(linear <= static_cast<double>(optimum) + 1e-6);
      const helios::ExactAnswer exact = helios::SolveCover(cover.Problem, all, nullptr, 60.0);
      CHECK(exact.IsProved);
      CHECK(exact.Best.size() == optimum);
      CHECK(cover.IsEnough(exact.Best));
    }
  }
}

TEST_CASE("Cover: bounds are below the optimum, the Lagrangian below the linear one", "[Cover]")
{
  double ours = 0.0;
  double theirs = 0.0;
  for (int seed = 0; seed < Seeds; ++seed)
  {
    INFO(seed);
    const SmallCover cover = MakeCover(seed);
    const auto optimum = static_cast<double>(cover.GetOptima()[0].size());
    const double bound = helios::GetLagrangeBound(cover.Problem, 100);
    CHECK(bound <= optimum);
    CHECK(bound > 0.0);
    if (helios::HasExactSolver())
    {
      const double linear = helios::GetLinearBound(cover.Problem, 100000, 60.0);
      CHECK(bound <= linear + 1e-6);
      CHECK(linear <= optimum + 1e-6);
      const helios::ExactAnswer exact =
        helios::SolveCover(cover.Problem, helios::GetAllCandidates(cover.Problem), nullptr, 60.0);
      CHECK(exact.IsProved);
      CHECK(static_cast<double>(exact.Best.size()) == optimum);
      CHECK(cover.IsEnough(exact.Best));
      ours += bound;
      theirs += linear;
    }
  }
  CHECK(ours >= 0.97 * theirs);
}

TEST_CASE("Cover: the tree finds every smallest cover once", "[Cover]")
{
  for (int seed = 0; seed < Seeds; ++seed)
  {
    INFO(seed);
    const SmallCover cover = MakeCover(seed);
    const std::vector<Choice> optima = cover.GetOptima();
    const helios::ReducedCover reduced = helios::ReduceCover(cover.Problem, { false, true });
    helios::CoverTree tree(reduced.Rows.View(), reduced.Columns.View());
    std::vector<Choice> found;
    std::int64_t work = 1000000000;
    const auto take = [&found](Choice c)
    {
      std::sort(c.begin(), c.end());
      found.push_back(c);
      return true;
    };
    const int count = static_cast<int>(optima[0].size());
    CHECK(tree.Visit(count, take, work) == helios::CoverAnswer::None);
    CHECK(std::set<Choice>(found.begin(), found.end()) ==
      std::set<Choice>(optima.begin(), optima.end()));
    CHECK(found.size() == optima.size());
    if (count > 1)
    {
      found.clear();
      CHECK(tree.Visit(count - 1, take, work) == helios::CoverAnswer::None);
      CHECK(found.empty());
    }
    work = 1;
    CHECK(tree.Visit(count, take, work) == helios::CoverAnswer::Unknown);
  }
}

TEST_CASE("Cover: local search keeps a cover and is repeatable", "[Cover]")
{
  const SmallCover cover(20, 150, 0.2, 7);
  const Choice all = helios::GetAllCandidates(cover.Problem);
  for (int start = 0; start < 5; ++start)
  {
    const Choice once = helios::SearchCover(cover.Problem, all, { 1, start, 200000 });
    CHECK(cover.IsEnough(once));
    CHECK(once.size() < all.size());
    CHECK(once == helios::SearchCover(cover.Problem, all, { 1, start, 200000 }));
  }
  CHECK(helios::SearchCover(cover.Problem, all, { 20, 0, 200000 }) == all);
}

TEST_CASE("Cover: loops can be aborted", "[Cover]")
{
  const SmallCover cover(20, 150, 0.2, 7);
  const auto stop = [] { return true; };
  const Choice all = helios::GetAllCandidates(cover.Problem);
  CHECK(helios::RemoveRedundant(cover.Problem, all, stop).empty());
  CHECK(helios::ChooseGreedily(cover.Problem, all, stop).Candidates.empty());
  CHECK(helios::SearchCover(cover.Problem, all, {}, stop) == all);
  CHECK(helios::ReduceCover(cover.Problem, {}, stop).Candidates == all);
}
