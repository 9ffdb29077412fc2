// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverQuality.h"

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

class Swaps
{
public:
  Swaps(const CoverProblem& problem, const Incidence& incidence, const OverlapNetwork* network,
    std::int64_t work, const Choice& choice, const StopTest& stop)
    : Problem(problem)
    , Angles(incidence)
    , Network(network)
    , Work(work)
    , Members(choice)
    , Best(Incidence::ComputeQuality(problem, incidence.GetBest(problem, choice)))
    , Stop(stop)
  {
  }

  Choice Run()
  {
    bool isOn = !std::isnan(this->Best.Worst);
    while (isOn)
    {
      isOn = false;
      for (std::size_t k = 0; k < this->Members.size(); ++k)
      {
        isOn = this->Replace(k) || isOn;
      }
    }
    return this->Members;
  }

private:
  bool IsOn() const { return this->Work > 0 && !(this->Stop && this->Stop()); }

  /// Tries to swap one member for each other candidate; true: one is better.
  bool Replace(std::size_t k)
  {
    Choice others = this->Members;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
    const CoverCounts counts(this->Problem, others);
    const std::vector<double> best = this->Angles.GetBest(this->Problem, others);
    this->Work -= static_cast<std::int64_t>(others.size()) * this->Problem.Rows.Columns;
    std::vector<int> needy = this->FindNeedy(counts, best);
    bool isBetter = false;
    for (int b = 0; b < this->Problem.Rows.Rows && this->IsOn(); ++b)
    {
      this->Work -= 4;
      if (this->Serves(b, needy) && this->IsEnough(counts, b) && this->TryMember(k, b, best))
      {
        isBetter = true;
        needy = this->FindNeedy(counts, best);
      }
    }
    return isBetter;
  }

  /// Finds the points that a new member must see, at no worse than the current worst angle.
  std::vector<int> FindNeedy(const CoverCounts& counts, const std::vector<double>& best) const
  {
    std::vector<int> needy;
    for (int v = 0; v < this->Problem.Rows.Columns; ++v)
    {
      const bool isMissing = this->Problem.IsFull && counts.GetCount(v) == 0 &&
        HasBit(this->Problem.Coverable.data(), v);
      if (isMissing || best[v] > this->Best.Worst)
      {
        needy.push_back(v);
      }
    }
    return needy;
  }

  bool Serves(int b, const std::vector<int>& needy)
  {
    const Word* row = this->Problem.Rows.Get(b);
    for (const int v : needy)
    {
      --this->Work;
      if (!HasBit(row, v) || this->Angles.GetAngle(b, v) > this->Best.Worst)
      {
        return false;
      }
    }
    return true;
  }

  bool IsEnough(const CoverCounts& counts, int b) const
  {
    return this->Problem.IsFull ||
      counts.GetCoveredWeight() + counts.GetGain(b) >= this->Problem.Required;
  }

  bool TryMember(std::size_t k, int b, const std::vector<double>& others)
  {
    if (std::find(this->Members.begin(), this->Members.end(), b) != this->Members.end())
    {
      return false;
    }
    std::vector<double> best = others;
    VisitBits(this->Problem.Rows.Get(b), this->Problem.Rows.Length,
      [&](int v) { best[v] = std::fmin(best[v], this->Angles.GetAngle(b, v)); });
    this->Work -= this->Problem.Rows.Columns;
    const Quality quality = Incidence::ComputeQuality(this->Problem, best);
    Choice members = this->Members;
    members[k] = b;
    if (!quality.IsBetterThan(this->Best) ||
      (this->Network && !this->Network->IsConnected(members)))
    {
      return false;
    }
    this->Members = members;
    this->Best = quality;
    return true;
  }

  const CoverProblem& Problem;
  const Incidence& Angles;
  const OverlapNetwork* Network;
  std::int64_t Work;
  Choice Members;
  Quality Best;
  const StopTest& Stop;
};

} // namespace

void ImproveBySwaps(const CoverProblem& problem, const Incidence& incidence,
  const OverlapNetwork* network, std::int64_t work, Choice& choice, const StopTest& stop)
{
  choice = Swaps(problem, incidence, network, work, choice, stop).Run();
}

} // namespace helios
