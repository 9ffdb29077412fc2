// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoverOverlap.h"

#include "heliosCoverReduction.h"

#include <algorithm>

namespace helios
{

namespace
{

/// Relative tolerance for comparing shares of areas.
constexpr double Rounding = 1e-12;

/// Splits members into parts by areLinked(a, b); each part ascends from its lowest member.
template <typename LinkT>
std::vector<Choice> Split(Choice members, LinkT areLinked, const StopTest& stop)
{
  std::vector<Choice> parts;
  std::sort(members.begin(), members.end());
  while (!members.empty())
  {
    Choice part = { members.front() };
    members.erase(members.begin());
    for (std::size_t k = 0; k < part.size() && !(stop && stop()); ++k)
    {
      const auto rest = std::stable_partition(
        members.begin(), members.end(), [&](int b) { return !areLinked(part[k], b); });
      part.insert(part.end(), rest, members.end());
      members.erase(rest, members.end());
    }
    std::sort(part.begin(), part.end());
    parts.push_back(part);
  }
  return parts;
}

} // namespace

OverlapNetwork::OverlapNetwork(const CoverProblem& problem, double share)
  : Problem(&problem)
  , Share(share)
  , Sizes(GetViewshedWeights(problem))
  , Neighbours(problem.Rows.Rows)
{
}

bool OverlapNetwork::AreNeighbours(int a, int b) const
{
  const double common =
    this->Problem->GetCommonWeight(this->Problem->Rows.Get(a), this->Problem->Rows.Get(b));
  return common > 0.0 &&
    common >= this->Share * std::min(this->Sizes[a], this->Sizes[b]) * (1.0 - Rounding);
}

const Words& OverlapNetwork::GetNeighbours(int candidate)
{
  std::unique_ptr<Words>& set = this->Neighbours[candidate];
  if (!set)
  {
    const int count = this->Problem->Rows.Rows;
    set = std::make_unique<Words>(GetWordCount(count));
    for (int b = 0; b < count; ++b)
    {
      if (b != candidate && this->AreNeighbours(candidate, b))
      {
        SetBit(set->data(), b);
      }
    }
  }
  return *set;
}

std::vector<Choice> OverlapNetwork::GetParts(const Choice& choice) const
{
  return Split(choice, [this](int a, int b) { return this->AreNeighbours(a, b); }, {});
}

std::vector<Choice> OverlapNetwork::GetAllParts(const StopTest& stop) const
{
  Choice seeing;
  for (int c = 0; c < this->Problem->Rows.Rows; ++c)
  {
    if (this->Sizes[c] > 0.0)
    {
      seeing.push_back(c);
    }
  }
  return Split(
    seeing, [this](int a, int b) { return this->AreNeighbours(a, b); }, stop);
}

bool OverlapNetwork::Connect(Choice& choice, const StopTest& stop)
{
  for (;;)
  {
    const std::vector<Choice> parts = this->GetParts(choice);
    if (parts.size() <= 1)
    {
      return true;
    }
    const Choice path = this->FindPath(parts, stop);
    if (path.empty())
    {
      return false;
    }
    choice.insert(choice.end(), path.begin(), path.end());
  }
}

Choice OverlapNetwork::FindPath(const std::vector<Choice>& parts, const StopTest& stop)
{
  Choice shortest;
  for (std::size_t start = 0; start + 1 < parts.size(); ++start)
  {
    // Breadth-first search from one part to the next reached; ties by lowest index.
    Words targets(GetWordCount(this->Problem->Rows.Rows));
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      for (const int a : p != start ? parts[p] : Choice())
      {
        SetBit(targets.data(), a);
      }
    }
    const int length = static_cast<int>(targets.size());
    std::vector<int> from(this->Problem->Rows.Rows, -1);
    Words isNew(length, ~Word(0));
    Choice queue = parts[start];
    for (const int a : queue)
    {
      ClearBit(isNew.data(), a);
    }
    for (std::size_t k = 0; k < queue.size() && !(stop && stop()); ++k)
    {
      const int a = queue[k];
      const Words& neighbours = this->GetNeighbours(a);
      if (HasCommon(neighbours.data(), targets.data(), length))
      {
        Choice path;
        for (int b = a; from[b] >= 0; b = from[b])
        {
          path.push_back(b);
        }
        if (shortest.empty() || path.size() < shortest.size())
        {
          shortest = path;
        }
        break;
      }
      for (int w = 0; w < length; ++w)
      {
        VisitWord(neighbours[w] & isNew[w], w,
          [&](int b)
          {
            from[b] = a;
            queue.push_back(b);
          });
        isNew[w] &= ~neighbours[w];
      }
    }
    if (shortest.size() == 1)
    {
      break;
    }
  }
  return shortest;
}

Choice OverlapNetwork::RemoveNeedless(const Choice& order, const StopTest& stop) const
{
  CoverCounts counts(*this->Problem, order);
  Choice kept = order;
  for (const int candidate : order)
  {
    Choice others = kept;
    others.erase(std::find(others.begin(), others.end(), candidate));
    if (!(stop && stop()) && counts.IsEnoughWithout(candidate) && this->IsConnected(others))
    {
      counts.Remove(candidate);
      kept = others;
    }
  }
  return kept;
}

} // namespace helios
