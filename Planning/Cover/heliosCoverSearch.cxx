// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverSearch.h"

#include "heliosRandom.h"

#include <algorithm>

namespace helios
{

namespace
{

/// More bits than this: the lists of a problem would take too much memory.
constexpr std::int64_t MaximumBits = 30000000;

/// Maximum number of steps per candidate or point.
constexpr int StepsEach = 100;

/// Consecutive lists of numbers.
class Lists
{
public:
  explicit Lists(const BitRows& rows)
  {
    this->Starts.push_back(0);
    for (int r = 0; r < rows.Rows; ++r)
    {
      VisitBits(rows.Get(r), rows.Length, [this](int i) { this->Items.push_back(i); });
      this->Starts.push_back(this->Items.size());
    }
  }

  const int* Begin(int list) const { return this->Items.data() + this->Starts[list]; }
  const int* End(int list) const { return this->Items.data() + this->Starts[list + 1]; }
  int GetSize(int list) const { return static_cast<int>(this->End(list) - this->Begin(list)); }

private:
  std::vector<std::size_t> Starts;
  std::vector<int> Items;
};

struct List
{
  const int* First;
  const int* Last;
  const int* begin() const { return this->First; }
  const int* end() const { return this->Last; }
};

class Search
{
public:
  Search(const CoverProblem& problem, const SearchSettings& settings)
    : Problem(problem)
    , Settings(settings)
    , Points(problem.Rows)
    , Seers(Transpose(problem.Rows).View())
    , Counts(problem.Rows.Columns)
    , Members(problem.Rows.Columns)
    , Place(problem.Rows.Columns, -1)
    , Weights(problem.Rows.Columns)
    , Scores(problem.Rows.Rows)
    , IsMember(problem.Rows.Rows)
    , MayJoin(problem.Rows.Rows, 1)
    , Stamps(problem.Rows.Rows)
    , Covered(problem.GetWeight(problem.Coverable.data()))
  {
    for (int v = 0; v < problem.Rows.Columns; ++v)
    {
      this->Weights[v] = problem.IsFull ? 1.0 : problem.GetWeight(v);
      if (HasBit(problem.Coverable.data(), v))
      {
        this->AddMissing(v);
      }
      for (const int a : this->GetSeers(v))
      {
        this->Scores[a] += this->Weights[v];
      }
    }
  }

  Choice Run(const Choice& start, const StopTest& stop)
  {
    for (const int a : start)
    {
      this->Join(a);
    }
    Choice best = start;
    const std::uint32_t steps = StepsEach * (this->Problem.Rows.Rows + this->Problem.Rows.Columns);
    for (std::uint32_t step = 1; step <= steps && this->Settings.Work > 0 && !(stop && stop());
         ++step)
    {
      while (this->IsEnough())
      {
        best = this->Chosen;
        if (static_cast<int>(best.size()) <= std::max(1, this->Settings.Target))
        {
          return best;
        }
        this->Leave(this->FindLeaver(-1));
      }
      this->Swap(step);
    }
    return best;
  }

private:
  List GetPoints(int a) const { return { this->Points.Begin(a), this->Points.End(a) }; }
  List GetSeers(int v) const { return { this->Seers.Begin(v), this->Seers.End(v) }; }

  bool IsEnough() const
  {
    return this->Problem.IsFull ? this->Missing.empty() : this->Covered >= this->Problem.Required;
  }

  void Swap(std::uint32_t step)
  {
    if (this->Chosen.size() > 1)
    {
      const int leaver = this->FindLeaver(this->Newest);
      this->Leave(leaver);
      this->Stamps[leaver] = step;
    }
    const double random = Uniform4(static_cast<std::uint64_t>(this->Settings.Start),
      RandomStream::ScanPositions, this->Problem.Rows.Rows, step)[0];
    const int wanted =
      this->Missing[static_cast<std::size_t>(random * static_cast<double>(this->Missing.size()))];
    const int joiner = this->FindJoiner(wanted);
    this->Join(joiner);
    this->Newest = joiner;
    this->Stamps[joiner] = step;
    if (this->Problem.IsFull)
    {
      this->RaiseMissing();
    }
  }

  /// Finds the member that loses least, the oldest for ties; not the newest, unless it is the only
  /// one.
  int FindLeaver(int newest)
  {
    int leaver = -1;
    for (const int a : this->Chosen)
    {
      if (a != newest && (leaver < 0 || this->IsBetter(a, leaver)))
      {
        leaver = a;
      }
    }
    this->Settings.Work -= static_cast<std::int64_t>(this->Chosen.size());
    return leaver < 0 ? newest : leaver;
  }

  /// Finds the best candidate that sees a point and may join; one that has just left may not.
  int FindJoiner(int point)
  {
    int joiner = -1;
    for (const int a : this->GetSeers(point))
    {
      if (this->MayJoin[a] && (joiner < 0 || this->IsBetter(a, joiner)))
      {
        joiner = a;
      }
    }
    this->Settings.Work -= this->Seers.GetSize(point);
    return joiner < 0 ? *this->Seers.Begin(point) : joiner;
  }

  bool IsBetter(int a, int b) const
  {
    return this->Scores[a] != this->Scores[b] ? this->Scores[a] > this->Scores[b]
                                              : this->Stamps[a] < this->Stamps[b];
  }

  /// Updates the scores of the candidates that see a point when it becomes seen or missing.
  void Change(int point, double by, int except)
  {
    for (const int a : this->GetSeers(point))
    {
      if (a != except)
      {
        this->Scores[a] += by;
        this->MayJoin[a] = 1;
      }
    }
    this->Settings.Work -= this->Seers.GetSize(point);
  }

  void Join(int a)
  {
    this->Scores[a] = -this->Scores[a];
    this->IsMember[a] = 1;
    this->Chosen.push_back(a);
    for (const int v : this->GetPoints(a))
    {
      if (++this->Counts[v] == 1)
      {
        this->Change(v, -this->Weights[v], a);
        this->RemoveMissing(v);
      }
      else if (this->Counts[v] == 2)
      {
        this->Scores[this->Members[v]] += this->Weights[v];
      }
      this->Members[v] ^= a;
    }
    this->Settings.Work -= this->Points.GetSize(a);
  }

  void Leave(int a)
  {
    this->Scores[a] = -this->Scores[a];
    this->IsMember[a] = 0;
    this->MayJoin[a] = 0;
    this->Chosen.erase(std::find(this->Chosen.begin(), this->Chosen.end(), a));
    for (const int v : this->GetPoints(a))
    {
      this->Members[v] ^= a;
      if (--this->Counts[v] == 0)
      {
        this->Change(v, this->Weights[v], a);
        this->AddMissing(v);
      }
      else if (this->Counts[v] == 1)
      {
        this->Scores[this->Members[v]] -= this->Weights[v];
      }
    }
    this->Settings.Work -= this->Points.GetSize(a);
  }

  void AddMissing(int v)
  {
    this->Place[v] = static_cast<int>(this->Missing.size());
    this->Missing.push_back(v);
    this->Covered -= this->Problem.GetWeight(v);
  }

  void RemoveMissing(int v)
  {
    this->Place[this->Missing.back()] = this->Place[v];
    this->Missing[this->Place[v]] = this->Missing.back();
    this->Missing.pop_back();
    this->Covered += this->Problem.GetWeight(v);
  }

  void RaiseMissing()
  {
    for (const int v : this->Missing)
    {
      this->Weights[v] += 1.0;
      for (const int a : this->GetSeers(v))
      {
        this->Scores[a] += 1.0;
      }
      this->Settings.Work -= this->Seers.GetSize(v);
    }
  }

  const CoverProblem& Problem;
  SearchSettings Settings;
  Lists Points;
  Lists Seers;
  std::vector<int> Counts;     // number of members that see a point
  std::vector<int> Members;    // their exclusive or: the member, if there is only one
  std::vector<int> Missing;    // points that no member sees
  std::vector<int> Place;      // place of each point in Missing
  std::vector<double> Weights; // weights of the points
  std::vector<double> Scores;  // gain of a candidate, or minus the exclusive weight of a member
  std::vector<char> IsMember;
  std::vector<char> MayJoin;
  std::vector<std::uint32_t> Stamps;
  double Covered; // weight
  Choice Chosen;
  int Newest = -1;
};

} // namespace

Choice SearchCover(const CoverProblem& problem, const Choice& choice,
  const SearchSettings& settings, const StopTest& stop)
{
  if (static_cast<int>(choice.size()) <= std::max(1, settings.Target) ||
    problem.Rows.GetSize() > MaximumBits)
  {
    return choice;
  }
  return Search(problem, settings).Run(choice, stop);
}

} // namespace helios
