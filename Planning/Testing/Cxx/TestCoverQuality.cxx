// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Worst and mean incidence among minimum covers, each step compared with enumeration.

#include "heliosCoverQuality.h"
#include "heliosSmallCovers.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using helios::Choice;
using helios::CoverAnswer;
using helios::Quality;

namespace
{

/// Candidates above, and points with random normals.
helios::Incidence MakeIncidence(int candidates, int points, unsigned int seed)
{
  std::mt19937 random(seed);
  const auto draw = [&random](int count, double height)
  {
    std::vector<helios::Incidence::Vector> vectors;
    for (int i = 0; i < count; ++i)
    {
      const auto next = [&random] { return 1e-3 * static_cast<double>(random() % 1000); };
      vectors.push_back({ next(), next(), height + next() });
    }
    return vectors;
  };
  auto positions = draw(candidates, 1.0);
  auto tests = draw(points, -1.0);
  return { positions, tests, draw(points, 0.0) };
}

struct Trial
{
  explicit Trial(unsigned int seed)
    : Cover(10, 30, 0.4, seed)
    , Angles(MakeIncidence(10, 30, seed))
    , Optima(Cover.GetOptima())
    , Best(ComputeQuality(Optima[0]))
    , Worst(Best)
  {
    for (const Choice& choice : this->Optima)
    {
      this->Best = this->ComputeQuality(choice).IsBetterThan(this->Best)
        ? this->ComputeQuality(choice)
        : this->Best;
      const bool isWorse = this->Worst.IsBetterThan(this->ComputeQuality(choice));
      this->Start = isWorse || this->Start.empty() ? choice : this->Start;
      this->Worst = isWorse ? this->ComputeQuality(choice) : this->Worst;
    }
  }

  Quality ComputeQuality(const Choice& choice) const
  {
    return helios::Incidence::ComputeQuality(
      this->Cover.Problem, this->Angles.GetBest(this->Cover.Problem, choice));
  }

  helios::SmallCover Cover;
  helios::Incidence Angles;
  std::vector<Choice> Optima;
  Quality Best;
  Quality Worst;
  Choice Start; // the worst of the optima
};

/// The first cover of at most count scans, by the tree.
CoverAnswer Solve(const helios::CoverProblem& problem, int count, Choice& choice)
{
  const helios::BitMatrix columns = helios::Transpose(problem.Rows);
  std::int64_t work = 100000000;
  const auto take = [&choice](const Choice& cover)
  {
    choice = cover;
    return false;
  };
  return helios::CoverTree(problem.Rows, columns.View()).Visit(count, take, work);
}

bool SeesAll(const Trial& trial)
{
  return helios::CountBits(trial.Cover.Problem.Coverable.data(), trial.Cover.Problem.Rows.Length) ==
    30;
}

} // namespace

TEST_CASE("CoverQuality: bisection finds the smallest worst angle, enumeration the smallest mean",
  "[Cover]")
{
  int better = 0;
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    INFO(seed);
    const Trial trial(seed);
    if (!SeesAll(trial))
    {
      continue;
    }
    const helios::AngleTable table(trial.Cover.Problem, trial.Angles);
    Choice choice = trial.Start;
    CHECK(helios::MinimiseWorst(trial.Cover.Problem, table, trial.Angles, Solve, choice));
    CHECK(trial.ComputeQuality(choice).Worst == trial.Best.Worst);
    CHECK(choice.size() == trial.Start.size());
    CHECK(helios::MinimiseMean(trial.Cover.Problem, table, trial.Angles, 100000000, choice));
    CHECK(trial.ComputeQuality(choice).Worst == trial.Best.Worst);
    CHECK(trial.ComputeQuality(choice).Mean == Approx(trial.Best.Mean).epsilon(1e-12));
    CHECK_FALSE(helios::MinimiseMean(trial.Cover.Problem, table, trial.Angles, 1, choice));
    better += trial.Best.Worst < trial.Worst.Worst ? 1 : 0;
  }
  CHECK(better > 10);
}

TEST_CASE("CoverQuality: an unfinished solve proves nothing", "[Cover]")
{
  const Trial trial(1);
  REQUIRE(trial.Best.Worst < trial.Worst.Worst);
  const helios::AngleTable table(trial.Cover.Problem, trial.Angles);
  Choice choice = trial.Start;
  const auto shrug = [](const helios::CoverProblem&, int, Choice&) { return CoverAnswer::Unknown; };
  CHECK_FALSE(helios::MinimiseWorst(trial.Cover.Problem, table, trial.Angles, shrug, choice));
  CHECK(choice == trial.Start);
}

TEST_CASE("CoverQuality: swaps never worsen a plan, and end at a local optimum", "[Cover]")
{
  for (unsigned int seed = 0; seed < 60; ++seed)
  {
    INFO(seed);
    const Trial trial(seed);
    Choice choice = trial.Start;
    helios::ImproveBySwaps(trial.Cover.Problem, trial.Angles, nullptr, 100000000, choice);
    CHECK(trial.Cover.IsEnough(choice));
    CHECK_FALSE(trial.Worst.IsBetterThan(trial.ComputeQuality(choice)));
    for (std::size_t k = 0; k < choice.size(); ++k)
    {
      for (int b = 0; b < 10; ++b)
      {
        Choice other = choice;
        other[k] = b;
        CHECK_FALSE((trial.Cover.IsEnough(other) &&
          trial.ComputeQuality(other).IsBetterThan(trial.ComputeQuality(choice))));
      }
    }
    Choice same = trial.Start;
    helios::ImproveBySwaps(trial.Cover.Problem, trial.Angles, nullptr, 0, same);
    CHECK(same == trial.Start);
  }
}

TEST_CASE("CoverQuality: angles are from the normal, on either side, and ties are exact", "[Cover]")
{
  const helios::Incidence incidence({ { 0.0, 0.0, 0.0 } },
    { { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 }, { 0.1, 0.1, 0.0 }, { 0.0, 0.0, 3.0 },
      { 1.0, 0.0, 0.0 } },
    { { 2.0, 0.0, 0.0 }, { -1.0, 0.0, 0.0 }, { 0.0, 7.0, 0.0 }, { 1.0, 0.0, 0.0 },
      { 0.0, 0.0, 0.0 } });
  CHECK(incidence.GetAngle(0, 0) == 0.0);
  CHECK(incidence.GetAngle(0, 1) == 45.0);
  CHECK(incidence.GetAngle(0, 2) == 45.0);
  CHECK(incidence.GetAngle(0, 3) == 90.0);
  CHECK(std::isnan(incidence.GetAngle(0, 4)));
}
