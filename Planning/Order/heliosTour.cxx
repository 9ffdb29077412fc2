// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace helios
{

namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double Rounding = 1e-12;
constexpr int MaximumStarts = 16; // trips to the nearest place, fewer for many places
constexpr int StartWork = 4000;   // starts times places
constexpr int Ascents = 300;      // steps of the bound

double Measure(const DistanceTable& distances, const std::vector<int>& order)
{
  double length = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    length += distances.Get(order[i], order[(i + 1) % order.size()]);
  }
  return length;
}

/// Dynamic programming over the sets of places visited after place 0, and the last of them.
class ExactTour
{
public:
  explicit ExactTour(const DistanceTable& distances)
    : Distances(distances)
    , Others(distances.GetSize() - 1)
    , Lengths(static_cast<std::size_t>(Others) << Others, Infinite)
    , Before(Lengths.size(), -1)
  {
  }

  std::vector<int> Solve()
  {
    for (int last = 0; last < this->Others; ++last)
    {
      this->Lengths[this->Find(1 << last, last)] = this->Distances.Get(0, last + 1);
    }
    const int all = (1 << this->Others) - 1;
    for (int set = 1; set <= all; ++set)
    {
      this->Extend(set);
    }
    return this->Collect(all);
  }

private:
  std::size_t Find(int set, int last) const
  {
    return static_cast<std::size_t>(set) * static_cast<std::size_t>(this->Others) +
      static_cast<std::size_t>(last);
  }

  void Extend(int set)
  {
    for (int last = 0; last < this->Others; ++last)
    {
      const double length = this->Lengths[this->Find(set, last)];
      for (int next = 0; length < Infinite && next < this->Others; ++next)
      {
        const std::size_t place = this->Find(set | (1 << next), next);
        const double longer = length + this->Distances.Get(last + 1, next + 1);
        if ((set >> next & 1) == 0 && longer < this->Lengths[place])
        {
          this->Lengths[place] = longer;
          this->Before[place] = last;
        }
      }
    }
  }

  std::vector<int> Collect(int set) const
  {
    int last = 0;
    const auto close = [&](int end)
    { return this->Lengths[this->Find(set, end)] + this->Distances.Get(end + 1, 0); };
    for (int end = 1; end < this->Others; ++end)
    {
      last = close(end) < close(last) ? end : last;
    }
    std::vector<int> order;
    while (last >= 0)
    {
      order.push_back(last + 1);
      const int before = this->Before[this->Find(set, last)];
      set &= ~(1 << last);
      last = before;
    }
    order.push_back(0);
    std::reverse(order.begin(), order.end());
    return order;
  }

  const DistanceTable& Distances;
  int Others;
  std::vector<double> Lengths;
  std::vector<int> Before;
};

/// Goes from a place always to the nearest one that is left.
std::vector<int> GoToNearest(const DistanceTable& distances, int start)
{
  std::vector<int> order = { start };
  std::vector<int> rest(static_cast<std::size_t>(distances.GetSize()));
  std::iota(rest.begin(), rest.end(), 0);
  rest.erase(rest.begin() + start);
  while (!rest.empty())
  {
    const auto next = std::min_element(rest.begin(), rest.end(),
      [&](int a, int b)
      { return distances.Get(order.back(), a) < distances.Get(order.back(), b); });
    order.push_back(*next);
    rest.erase(next);
  }
  return order;
}

/// Reverses a part of the trip, if this shortens it (2-opt).
bool Reverse(const DistanceTable& distances, std::vector<int>& order)
{
  const std::size_t size = order.size();
  for (std::size_t i = 0; i + 2 < size; ++i)
  {
    for (std::size_t j = i + 2; j < size; ++j)
    {
      const int a = order[i];
      const int b = order[i + 1];
      const int c = order[j];
      const int d = order[(j + 1) % size];
      const double gain =
        distances.Get(a, b) + distances.Get(c, d) - distances.Get(a, c) - distances.Get(b, d);
      if (gain > Rounding * (distances.Get(a, b) + distances.Get(c, d)))
      {
        std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i) + 1,
          order.begin() + static_cast<std::ptrdiff_t>(j) + 1);
        return true;
      }
    }
  }
  return false;
}

/// Moves up to three places that follow each other to elsewhere, if this shortens it (Or-opt).
bool Move(const DistanceTable& distances, std::vector<int>& order)
{
  const std::size_t size = order.size();
  const double length = Measure(distances, order);
  for (std::size_t count = 1; count <= 3 && count + 2 <= size; ++count)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      std::vector<int> turned = order;
      std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(i), turned.end());
      const int first = turned[0];
      const int last = turned[count - 1];
      const double freed = distances.Get(turned.back(), first) +
        distances.Get(last, turned[count]) - distances.Get(turned.back(), turned[count]);
      for (std::size_t k = count; k + 1 < size; ++k)
      {
        const double link = distances.Get(turned[k], turned[k + 1]);
        const double straight =
          distances.Get(turned[k], first) + distances.Get(last, turned[k + 1]) - link;
        const double reversed =
          distances.Get(turned[k], last) + distances.Get(first, turned[k + 1]) - link;
        if (freed - std::min(straight, reversed) > Rounding * length)
        {
          const auto part = static_cast<std::ptrdiff_t>(count);
          if (reversed < straight)
          {
            std::reverse(turned.begin(), turned.begin() + part);
          }
          std::rotate(turned.begin(), turned.begin() + part,
            turned.begin() + static_cast<std::ptrdiff_t>(k) + 1);
          order = turned;
          return true;
        }
      }
    }
  }
  return false;
}

std::vector<int> FindGoodTour(const DistanceTable& distances)
{
  std::vector<int> best;
  double minimum = Infinite;
  const int size = distances.GetSize();
  const int starts = std::clamp(StartWork / size, 1, std::min(size, MaximumStarts));
  for (int k = 0; k < starts; ++k)
  {
    std::vector<int> order = GoToNearest(distances, k * size / starts);
    while (Reverse(distances, order) || Move(distances, order))
    {
    }
    if (const double length = Measure(distances, order); length < minimum)
    {
      minimum = length;
      best = order;
    }
  }
  std::rotate(best.begin(), std::find(best.begin(), best.end(), 0), best.end());
  return best;
}

/**
 * The bound of Held and Karp: a round trip is a 1-tree, a spanning tree of the places but 0 and the
 * two shortest links of 0. Penalties on the places change the length of every round trip equally;
 * they are raised where a 1-tree has more than two links.
 */
class TreeBound
{
public:
  explicit TreeBound(const DistanceTable& distances)
    : Distances(distances)
    , Penalties(static_cast<std::size_t>(distances.GetSize()), 0.0)
    , Links(Penalties.size(), 0)
  {
  }

  double Compute(double upper)
  {
    double best = 0.0;
    double scale = 1.0;
    int unchanged = 0;
    for (int i = 0; i < Ascents; ++i)
    {
      const double bound = this->Build();
      unchanged = bound > best ? 0 : unchanged + 1;
      best = std::max(best, bound);
      scale = unchanged > 10 ? scale / 2.0 : scale;
      unchanged = unchanged > 10 ? 0 : unchanged;
      double squares = 0.0;
      for (const int links : this->Links)
      {
        squares += (links - 2.0) * (links - 2.0);
      }
      if (squares == 0.0)
      {
        break; // the 1-tree is a round trip
      }
      const double step = scale * std::max(upper - bound, Rounding * upper) / squares;
      for (std::size_t k = 0; k < this->Links.size(); ++k)
      {
        this->Penalties[k] += step * (this->Links[k] - 2.0);
      }
    }
    return std::min(best, upper);
  }

private:
  double GetCost(int a, int b) const
  {
    return this->Distances.Get(a, b) + this->Penalties[static_cast<std::size_t>(a)] +
      this->Penalties[static_cast<std::size_t>(b)];
  }

  /// Returns the length of the shortest 1-tree (Prim), less the penalties of a round trip.
  double Build()
  {
    const int size = this->Distances.GetSize();
    std::fill(this->Links.begin(), this->Links.end(), 0);
    std::vector<double> costs(static_cast<std::size_t>(size), Infinite);
    std::vector<int> neighbours(static_cast<std::size_t>(size), -1);
    std::vector<bool> isIn(static_cast<std::size_t>(size), false);
    double length = 0.0;
    int added = 1;
    for (int n = 1; n < size; ++n)
    {
      const auto at = static_cast<std::size_t>(added);
      isIn[at] = true;
      if (neighbours[at] >= 0)
      {
        length += costs[at];
        ++this->Links[at];
        ++this->Links[static_cast<std::size_t>(neighbours[at])];
      }
      added = this->FindNext(added, isIn, costs, neighbours);
    }
    length += this->LinkFirst();
    return length - 2.0 * std::accumulate(this->Penalties.begin(), this->Penalties.end(), 0.0);
  }

  /// Finds the place nearest to the tree, to which one was added; 0: none is left.
  int FindNext(int added, const std::vector<bool>& isIn, std::vector<double>& costs,
    std::vector<int>& neighbours) const
  {
    int nearest = 0;
    double minimum = Infinite;
    for (int k = 1; k < this->Distances.GetSize(); ++k)
    {
      const auto at = static_cast<std::size_t>(k);
      if (isIn[at])
      {
        continue;
      }
      if (const double cost = this->GetCost(added, k); cost < costs[at])
      {
        costs[at] = cost;
        neighbours[at] = added;
      }
      if (costs[at] < minimum)
      {
        minimum = costs[at];
        nearest = k;
      }
    }
    return nearest;
  }

  /// Adds the two shortest links of place 0; returns their length.
  double LinkFirst()
  {
    int first = 0;
    int second = 0;
    const auto cost = [this](int k) { return k == 0 ? Infinite : this->GetCost(0, k); };
    for (int k = 1; k < this->Distances.GetSize(); ++k)
    {
      if (cost(k) < cost(first))
      {
        second = first;
        first = k;
      }
      else if (cost(k) < cost(second))
      {
        second = k;
      }
    }
    this->Links[0] = 2;
    ++this->Links[static_cast<std::size_t>(first)];
    ++this->Links[static_cast<std::size_t>(second)];
    return cost(first) + cost(second);
  }

  const DistanceTable& Distances;
  std::vector<double> Penalties;
  std::vector<int> Links;
};

} // namespace

//------------------------------------------------------------------------------
DistanceTable::DistanceTable(int size)
  : Size(size)
  , Values(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.0)
{
}

//------------------------------------------------------------------------------
void DistanceTable::Set(int a, int b, double distance)
{
  this->Values[this->Find(a, b)] = distance;
  this->Values[this->Find(b, a)] = distance;
}

//------------------------------------------------------------------------------
Tour SolveTour(const DistanceTable& distances)
{
  const int size = distances.GetSize();
  Tour tour;
  if (size < 4)
  {
    tour.Order.resize(static_cast<std::size_t>(size));
    std::iota(tour.Order.begin(), tour.Order.end(), 0);
    tour.Length = Measure(distances, tour.Order);
    tour.Bound = tour.Length;
    return tour;
  }
  const bool isExact = size <= ExactPlaces;
  tour.Order = isExact ? ExactTour(distances).Solve() : FindGoodTour(distances);
  tour.Length = Measure(distances, tour.Order);
  tour.Bound = isExact ? tour.Length : TreeBound(distances).Compute(tour.Length);
  return tour;
}

} // namespace helios
