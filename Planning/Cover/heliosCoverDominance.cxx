// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverDominance.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace helios
{

namespace
{

/// Up to this many words of common bits, counting the bits is worthwhile.
constexpr std::size_t FewWords = 16;

/// Sets over a ground set, in both directions, and the superset search.
class Supersets
{
public:
  Supersets(const BitRows& sets, const BitRows& members, std::int64_t& work)
    : Sets(sets)
    , Members(members)
    , Work(work)
  {
  }

  /// Calls visit(t) for every set t other than s that contains all of s.
  template <typename VisitT>
  void Visit(int s, VisitT visit)
  {
    this->Elements.clear();
    VisitBits(this->Sets.Get(s), this->Sets.Length, [this](int e) { this->Elements.push_back(e); });
    if (this->Elements.empty())
    {
      return;
    }
    this->Intersect();
    for (const auto& [w, word] : this->Common)
    {
      VisitWord(word, w,
        [&](int t)
        {
          if (t != s && (this->IsWhole || this->Holds(t, s)))
          {
            visit(t);
          }
        });
    }
  }

private:
  /// Computes Common, the sets that contain the elements of s: of all elements (IsWhole), or only
  /// until the few remaining sets are faster to compare.
  void Intersect()
  {
    const int count = static_cast<int>(this->Elements.size());
    // Neighbours have much in common: large strides reduce the sets quickly.
    int stride = static_cast<int>(0.618 * count) | 1;
    while (std::gcd(stride, count) != 1)
    {
      stride += 2;
    }
    this->Start(this->Elements[0]);
    this->IsWhole = false;
    std::int64_t at = 0;
    for (int k = 1; k < count; ++k)
    {
      at = (at + stride) % count;
      this->Intersect(this->Members.Get(this->Elements[at]));
      if (this->IsFew(count - k))
      {
        return;
      }
    }
    this->IsWhole = true;
  }

  void Start(int element)
  {
    this->Common.clear();
    const Word* row = this->Members.Get(element);
    this->Work -= this->Members.Length;
    for (int w = 0; w < this->Members.Length; ++w)
    {
      if (row[w])
      {
        this->Common.emplace_back(w, row[w]);
      }
    }
  }

  void Intersect(const Word* row)
  {
    this->Work -= static_cast<std::int64_t>(this->Common.size()) + 4;
    std::size_t kept = 0;
    for (const auto& [w, word] : this->Common)
    {
      if (word & row[w])
      {
        this->Common[kept++] = { w, word & row[w] };
      }
    }
    this->Common.resize(kept);
  }

  /// Returns whether comparing the remaining sets is cheaper than processing the remaining
  /// elements.
  bool IsFew(int elementsLeft) const
  {
    if (this->Common.size() > FewWords)
    {
      return false;
    }
    std::int64_t sets = 0;
    for (const auto& [w, word] : this->Common)
    {
      sets += __builtin_popcountll(word);
    }
    return sets <= 1 ||
      (sets - 1) * this->Sets.Length <
      static_cast<std::int64_t>(this->Common.size()) * elementsLeft;
  }

  bool Holds(int t, int s)
  {
    this->Work -= this->Sets.Length;
    return IsSubset(this->Sets.Get(s), this->Sets.Get(t), this->Sets.Length);
  }

  BitRows Sets;
  BitRows Members;
  std::int64_t& Work;
  std::vector<int> Elements;
  std::vector<std::pair<int, Word>> Common;
  bool IsWhole = false;
};

std::vector<int> GetSizes(const BitRows& sets)
{
  std::vector<int> sizes(sets.Rows);
  for (int s = 0; s < sets.Rows; ++s)
  {
    sizes[s] = sets.GetSize(s);
  }
  return sizes;
}

std::vector<int> SortBySize(const std::vector<int>& sizes)
{
  std::vector<int> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&sizes](int a, int b) { return sizes[a] < sizes[b]; });
  return order;
}

/// Remaining sets: all but empty ones and, by isLost(s, t, sizes), sets removed for a superset.
class Sieve
{
public:
  Sieve(const BitRows& sets, const BitRows& members, std::int64_t& work)
    : Sizes(GetSizes(sets))
    , Lost(sets.Rows)
    , Search(sets, members, work)
    , Work(work)
  {
    for (int s = 0; s < sets.Rows; ++s)
    {
      this->Lost[s] = this->Sizes[s] == 0;
    }
  }

  /// Keeps the largest sets.
  std::vector<int> SelectLargest(const StopTest& stop)
  {
    return this->Select(stop,
      [this](int s, int t)
      { this->Lost[s] = this->Lost[s] || this->Sizes[t] > this->Sizes[s] || t < s; });
  }

  /// Keeps the smallest sets.
  std::vector<int> SelectSmallest(const StopTest& stop)
  {
    return this->Select(stop,
      [this](int s, int t)
      { this->Lost[t] = this->Lost[t] || this->Sizes[t] > this->Sizes[s] || s < t; });
  }

private:
  template <typename CompareT>
  std::vector<int> Select(const StopTest& stop, CompareT compare)
  {
    for (const int s : SortBySize(this->Sizes))
    {
      if (this->Work <= 0 || (stop && stop()))
      {
        break;
      }
      if (!this->Lost[s])
      {
        this->Search.Visit(s, [&](int t) { compare(s, t); });
      }
    }
    std::vector<int> kept;
    for (int s = 0; s < static_cast<int>(this->Lost.size()); ++s)
    {
      if (!this->Lost[s])
      {
        kept.push_back(s);
      }
    }
    return kept;
  }

  std::vector<int> Sizes;
  std::vector<char> Lost;
  Supersets Search;
  std::int64_t& Work;
};

std::vector<int> Pick(const std::vector<int>& values, const std::vector<int>& which)
{
  std::vector<int> picked;
  for (const int i : which)
  {
    picked.push_back(values[i]);
  }
  return picked;
}

/// Makes one of the two steps; false: nothing removed.
bool LeaveOutPoints(ReducedCover& cover, std::int64_t& work, const StopTest& stop)
{
  const std::vector<int> kept =
    Sieve(cover.Columns.View(), cover.Rows.View(), work).SelectSmallest(stop);
  if (kept.size() == cover.Points.size())
  {
    return false;
  }
  cover.Points = Pick(cover.Points, kept);
  cover.Columns = SelectRows(cover.Columns.View(), kept);
  cover.Rows = Transpose(cover.Columns.View());
  return true;
}

bool LeaveOutCandidates(ReducedCover& cover, std::int64_t& work, const StopTest& stop)
{
  const std::vector<int> kept =
    Sieve(cover.Rows.View(), cover.Columns.View(), work).SelectLargest(stop);
  if (kept.size() == cover.Candidates.size())
  {
    return false;
  }
  cover.Candidates = Pick(cover.Candidates, kept);
  cover.Rows = SelectRows(cover.Rows.View(), kept);
  cover.Columns = Transpose(cover.Rows.View());
  return true;
}

/// Removes points that no candidate sees.
void LeaveOutUnseen(ReducedCover& cover, const CoverProblem& problem)
{
  VisitBits(
    problem.Coverable.data(), problem.Rows.Length, [&cover](int v) { cover.Points.push_back(v); });
  cover.Columns = SelectRows(Transpose(problem.Rows).View(), cover.Points);
  cover.Rows = Transpose(cover.Columns.View());
  cover.Candidates.resize(problem.Rows.Rows);
  std::iota(cover.Candidates.begin(), cover.Candidates.end(), 0);
}

} // namespace

Choice ReducedCover::Restore(const Choice& choice) const
{
  return Pick(this->Candidates, choice);
}

ReducedCover ReduceCover(const CoverProblem& problem, DominanceRules rules, const StopTest& stop)
{
  ReducedCover cover;
  LeaveOutUnseen(cover, problem);
  bool isOn = true;
  while (isOn && !(stop && stop()))
  {
    const bool hasFewerPoints = rules.Points && LeaveOutPoints(cover, rules.Work, stop);
    const bool hasFewerCandidates = rules.Candidates && LeaveOutCandidates(cover, rules.Work, stop);
    isOn = (hasFewerPoints && rules.Candidates) || (hasFewerCandidates && rules.Points);
    isOn = isOn && rules.Work > 0;
  }
  std::vector<double> weights;
  for (const int v : problem.Weights.empty() ? std::vector<int>() : cover.Points)
  {
    weights.push_back(problem.Weights[v]);
  }
  cover.Problem = CoverProblem(cover.Rows.View(), std::move(weights));
  if (!problem.IsFull)
  {
    cover.Problem.IsFull = false;
    cover.Problem.Required = problem.Required;
  }
  if (problem.HasObjects())
  {
    cover.Problem.Objects.Required = problem.Objects.Required;
    for (const int v : cover.Points)
    {
      cover.Problem.Objects.Of.push_back(problem.Objects.Of[v]);
    }
  }
  return cover;
}

} // namespace helios
