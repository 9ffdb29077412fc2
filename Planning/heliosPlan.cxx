// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPlan.h"

#include "heliosCoverBest.h"
#include "heliosCoverBound.h"
#include "heliosCoverDominance.h"
#include "heliosCoverExact.h"
#include "heliosCoverGreedy.h"
#include "heliosCoverQuality.h"
#include "heliosCoverReduction.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace helios
{

namespace
{

/// Time for the linear bound of methods without a proof, and the minimum for the method with a
/// proof [s].
constexpr double BoundTime = 10.0;

/// Maximum number of bits for a linear bound, and the bits read by the Lagrangian bound instead.
constexpr std::int64_t ExactBits = 2000000;
constexpr std::int64_t BoundBits = 500000;
constexpr std::int64_t BoundWork = 600000000;

/// Tolerance for rounding in a linear bound.
constexpr double Rounding = 1e-6;

/// Maximum number of candidate-point pairs for which Best bisects for the best worst angle.
constexpr std::int64_t BestPairs = 5000000;

/// Words and angles read for the best incidence.
constexpr std::int64_t QualityWork = 50000000;
constexpr std::int64_t ProofWork = 1000000000;

/// Work for one query for a smaller worst angle: scores changed by local search, words read to
/// enumerate all covers; the latter for Best; the share of the remaining time for CBC.
constexpr std::int64_t SearchWork = 5000000;
constexpr std::int64_t TreeWork = 1000000000;
constexpr std::int64_t BestShare = 20;
constexpr double QuestionShare = 4.0;

int RoundUp(double bound)
{
  return static_cast<int>(std::ceil(bound - Rounding));
}

double GetSeconds()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

/// A problem whose candidates can all be connected, if required.
class Planning
{
public:
  Planning(const CoverProblem& problem, const Incidence& incidence, const PlanSettings& settings)
    : Problem(problem)
    , Angles(incidence)
    , Settings(settings)
    , End(GetSeconds() + settings.TimeLimit)
  {
    if (settings.MinimumOverlap > 0.0)
    {
      this->Network = std::make_unique<OverlapNetwork>(problem, settings.MinimumOverlap);
    }
  }

  PlanResult Run()
  {
    this->Reduced = ReduceCover(this->Problem, { true, this->Problem.IsFull }, this->Settings.Stop);
    this->Report(0.3);
    this->Choose();
    this->Report(0.6);
    if (this->Network)
    {
      this->Connect();
    }
    this->FindBound();
    this->Report(0.7);
    if (this->Settings.Method >= PlanMethod::Best && !this->Network && this->Problem.IsFull)
    {
      this->FindFewer();
    }
    if (this->Settings.Method == PlanMethod::Optimal)
    {
      this->Prove();
    }
    if (this->Settings.Method >= PlanMethod::Best && this->Angles.HasNormals() &&
      !this->Problem.HasObjects())
    {
      this->Improve();
    }
    this->Report(0.95);
    this->Result.Selected = SortByGain(this->Problem, this->Result.Selected).Candidates;
    return this->Result;
  }

private:
  void Report(double progress) const
  {
    if (this->Settings.Report)
    {
      this->Settings.Report(progress);
    }
  }

  void Choose()
  {
    const StopTest& stop = this->Settings.Stop;
    switch (this->Settings.Method)
    {
      case PlanMethod::ViewshedSize:
        this->Remove(GetViewshedWeights(this->Problem));
        break;
      case PlanMethod::MeanIncidenceAngle:
        this->Remove(this->Settings.MeanAngles);
        break;
      case PlanMethod::Greedy:
        this->Result.Selected = RemoveWhatIsLeft(this->Problem,
          ChooseGreedily(this->Problem, GetAllCandidates(this->Problem), stop).Candidates, stop);
        break;
      default:
        this->Result.Selected = this->Reduced.Restore(
          ChooseBest(this->Reduced.Problem, { this->Settings.NumberOfStarts }, stop));
    }
  }

  /// Removes candidates by the paper's reduction, and its coverage-limited step.
  void Remove(const std::vector<double>& keys)
  {
    const Choice order = SortForRemoval(this->Problem, keys, this->Settings.IsAscending);
    this->Result.Selected = RemoveRedundant(this->Problem, order, this->Settings.Stop);
    if (!this->Problem.IsFull)
    {
      this->Result.Selected =
        RemoveToLimit(this->Problem, this->Result.Selected, this->Settings.Stop);
    }
  }

  void Connect()
  {
    this->Network->Connect(this->Result.Selected, this->Settings.Stop);
    Choice order;
    const Choice all = SortForRemoval(this->Problem, GetViewshedWeights(this->Problem), true);
    for (const int a : all)
    {
      const Choice& chosen = this->Result.Selected;
      if (std::find(chosen.begin(), chosen.end(), a) != chosen.end())
      {
        order.push_back(a);
      }
    }
    this->Result.Selected = this->Network->RemoveNeedless(order, this->Settings.Stop);
  }

  void FindBound()
  {
    const int count = static_cast<int>(this->Result.Selected.size());
    const bool isExact = this->Settings.Method == PlanMethod::Optimal;
    const double time = isExact ? std::max(this->GetTimeLeft(), BoundTime) : BoundTime;
    double bound = 0.0;
    if (isExact || this->Problem.IsFull || this->Problem.HasObjects())
    {
      bound = GetLinearBound(
        this->Reduced.Problem, isExact ? ExactBits : BoundBits, time, this->Settings.Stop);
    }
    if (bound == 0.0)
    {
      bound = GetLagrangeBound(this->Reduced.Problem, count, BoundWork, this->Settings.Stop);
    }
    this->Result.LinearBound = bound;
    this->Result.Bound = std::min(count, std::max(1, RoundUp(bound)));
  }

  double GetTimeLeft() const { return std::max(0.0, this->End - GetSeconds()); }

  /// Stops the additional work of Optimal.
  bool IsOver() const
  {
    const bool isLate = this->Settings.Method == PlanMethod::Optimal && this->GetTimeLeft() == 0.0;
    return isLate || (this->Settings.Stop && this->Settings.Stop());
  }

  bool IsCountProved() const
  {
    return this->Result.Bound >= static_cast<int>(this->Result.Selected.size());
  }

  /// Finds fewer scans: for small problems an enumeration of the remaining candidates is enough.
  void FindFewer()
  {
    CoverAnswer answer = CoverAnswer::Found;
    while (answer == CoverAnswer::Found && !this->IsCountProved())
    {
      const int count = static_cast<int>(this->Result.Selected.size());
      Choice found;
      answer = this->GoThrough(this->Reduced, count - 1, found);
      if (answer == CoverAnswer::Found)
      {
        this->Result.Selected = this->Reduced.Restore(found);
      }
      this->Result.Bound = answer == CoverAnswer::None ? count : this->Result.Bound;
    }
  }

  void Prove()
  {
    if (this->IsCountProved())
    {
      return;
    }
    ExactAnswer answer;
    if (this->Network)
    {
      const ReducedCover points =
        ReduceCover(this->Problem, { false, this->Problem.IsFull }, this->Settings.Stop);
      answer = SolveCover(points.Problem, this->Result.Selected, this->Network.get(),
        this->GetTimeLeft(), this->Settings.Stop);
    }
    else
    {
      const ReducedCover& reduced = this->Reduced;
      answer = SolveCover(reduced.Problem, this->GetReducedChoice(), nullptr, this->GetTimeLeft(),
        this->Settings.Stop);
      answer.Best = reduced.Restore(answer.Best);
    }
    this->Result.Selected = answer.Best;
    this->Result.Bound = std::max(this->Result.Bound, answer.Bound);
  }

  /// Returns the best choice, whose members are all candidates of the reduced problem, as a choice
  /// of the reduced problem.
  Choice GetReducedChoice() const
  {
    Choice choice;
    const std::vector<int>& candidates = this->Reduced.Candidates;
    for (const int a : this->Result.Selected)
    {
      choice.push_back(static_cast<int>(
        std::lower_bound(candidates.begin(), candidates.end(), a) - candidates.begin()));
    }
    return choice;
  }

  /// Improves worst, then mean incidence.
  void Improve()
  {
    const bool isOptimal = this->Settings.Method == PlanMethod::Optimal;
    const std::int64_t pairs =
      static_cast<std::int64_t>(this->Problem.Rows.Rows) * this->Problem.Rows.Columns;
    const bool hasTable = pairs <= (isOptimal ? AngleTable::MaximumPairs : BestPairs);
    Choice& choice = this->Result.Selected;
    if (hasTable && this->Problem.IsFull && !this->Network)
    {
      const AngleTable table(this->Problem, this->Angles);
      const CoverSolver solver = [this](const CoverProblem& p, int count, Choice& c)
      { return this->FindCover(p, count, c); };
      const bool isWorst = MinimiseWorst(this->Problem, table, this->Angles, solver, choice);
      ImproveBySwaps(
        this->Problem, this->Angles, nullptr, QualityWork, choice, this->Settings.Stop);
      const bool isMean = MinimiseMean(this->Problem, table, this->Angles,
        isOptimal ? ProofWork : QualityWork, choice, [this] { return this->IsOver(); });
      this->Result.IsWorstProved = isWorst && this->IsCountProved();
      this->Result.IsMeanProved = isMean && this->Result.IsWorstProved;
    }
    else
    {
      ImproveBySwaps(
        this->Problem, this->Angles, this->Network.get(), QualityWork, choice, this->Settings.Stop);
    }
  }

  /// Searches for a cover of this many scans.
  CoverAnswer FindCover(const CoverProblem& problem, int count, Choice& choice) const
  {
    const StopTest& stop = this->Settings.Stop;
    const ReducedCover reduced = ReduceCover(problem, {}, stop);
    Choice found = ChooseBest(reduced.Problem, { 1, count, SearchWork }, stop);
    CoverAnswer answer = CoverAnswer::Found;
    if (static_cast<int>(found.size()) > count)
    {
      answer = this->GoThrough(reduced, count, found);
    }
    if (answer == CoverAnswer::Unknown && this->Settings.Method == PlanMethod::Optimal)
    {
      answer = this->Solve(reduced.Problem, count, found);
    }
    choice = reduced.Restore(found);
    return answer;
  }

  /// Enumerates all covers, if they are few.
  CoverAnswer GoThrough(const ReducedCover& reduced, int count, Choice& found) const
  {
    const StopTest& stop = this->Settings.Stop;
    if (GetLagrangeBound(reduced.Problem, count + 1, QualityWork, stop) > count)
    {
      return CoverAnswer::None;
    }
    std::int64_t work =
      this->Settings.Method == PlanMethod::Optimal ? TreeWork : TreeWork / BestShare;
    return CoverTree(reduced.Rows.View(), reduced.Columns.View())
      .Visit(
        count,
        [&found](const Choice& cover)
        {
          found = cover;
          return false;
        },
        work, [this] { return this->IsOver(); });
  }

  CoverAnswer Solve(const CoverProblem& problem, int count, Choice& found) const
  {
    const double time = this->GetTimeLeft() / QuestionShare;
    const ExactAnswer answer = SolveCover(problem, found, nullptr, time, this->Settings.Stop);
    found = answer.Best;
    if (static_cast<int>(found.size()) <= count)
    {
      return CoverAnswer::Found;
    }
    return answer.Bound > count ? CoverAnswer::None : CoverAnswer::Unknown;
  }

  const CoverProblem& Problem;
  const Incidence& Angles;
  const PlanSettings& Settings;
  double End;
  std::unique_ptr<OverlapNetwork> Network;
  ReducedCover Reduced;
  PlanResult Result;
};

bool IsBetter(
  const CoverProblem& problem, const Incidence& incidence, const Choice& a, const Choice& b)
{
  return a.size() != b.size()
    ? a.size() < b.size()
    : Incidence::ComputeQuality(problem, incidence.GetBest(problem, a))
        .IsBetterThan(Incidence::ComputeQuality(problem, incidence.GetBest(problem, b)));
}

/// Plans each connected part that sees enough, and returns the best plan.
PlanResult PlanConnected(
  const CoverProblem& problem, const Incidence& incidence, const PlanSettings& settings)
{
  PlanResult best;
  best.Fault = "no connected network";
  const double end = GetSeconds() + settings.TimeLimit;
  for (const Choice& part :
    OverlapNetwork(problem, settings.MinimumOverlap).GetAllParts(settings.Stop))
  {
    const BitMatrix rows = SelectRows(problem.Rows, part);
    CoverProblem partProblem = problem;
    partProblem.Rows = rows.View();
    if (!CoverCounts(partProblem, GetAllCandidates(partProblem)).IsEnough())
    {
      continue;
    }
    PlanSettings partSettings = settings;
    partSettings.TimeLimit = std::max(0.0, end - GetSeconds());
    partSettings.MeanAngles.clear();
    for (const int a : part)
    {
      partSettings.MeanAngles.push_back(settings.MeanAngles.empty() ? 0.0 : settings.MeanAngles[a]);
    }
    PlanResult result = Planning(partProblem, incidence.Select(part), partSettings).Run();
    for (int& a : result.Selected)
    {
      a = part[a];
    }
    const int bound = best.Fault.empty() ? std::min(best.Bound, result.Bound) : result.Bound;
    const double linear =
      best.Fault.empty() ? std::min(best.LinearBound, result.LinearBound) : result.LinearBound;
    if (!best.Fault.empty() || IsBetter(problem, incidence, result.Selected, best.Selected))
    {
      best = result;
    }
    best.Bound = bound;
    best.LinearBound = linear;
  }
  return best;
}

} // namespace

PlanResult MakePlan(
  const CoverProblem& problem, const Incidence& incidence, const PlanSettings& settings)
{
  return settings.MinimumOverlap > 0.0 ? PlanConnected(problem, incidence, settings)
                                       : Planning(problem, incidence, settings).Run();
}

} // namespace helios
