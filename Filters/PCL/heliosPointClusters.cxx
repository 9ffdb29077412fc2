// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPointClusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>

namespace helios
{

namespace
{

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// Relative to a cell's side, so that despite rounding points of one cell are near each other, and
/// near points are in cells at most two apart.
constexpr double Safety = 0.9999;

/// Pairs of points compared one by one.
constexpr std::ptrdiff_t FewPairs = 64;

/// Points read between two progress reports.
constexpr std::int64_t Stride = 1 << 18;

/// The index of a cell; as double it cannot overflow.
using Place = std::array<double, 3>;

/// A box around points.
struct Box
{
  float Low[3] = { HUGE_VALF, HUGE_VALF, HUGE_VALF };
  float High[3] = { -HUGE_VALF, -HUGE_VALF, -HUGE_VALF };

  void Add(const pcl::PointXYZ& p)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], p.data[axis]);
      this->High[axis] = std::max(this->High[axis], p.data[axis]);
    }
  }
  int GetLongestAxis() const
  {
    const auto length = [this](int axis) { return this->High[axis] - this->Low[axis]; };
    const int xy = length(1) > length(0) ? 1 : 0;
    return length(2) > length(xy) ? 2 : xy;
  }
};

/// Returns the square of the distance of two boxes, rounded like the distance of two of their
/// points, so it never exceeds it.
float GetSquare(const Box& a, const Box& b)
{
  float sum = 0.0F;
  for (int axis = 0; axis < 3; ++axis)
  {
    const float gap = std::max({ a.Low[axis] - b.High[axis], b.Low[axis] - a.High[axis], 0.0F });
    sum += gap * gap;
  }
  return sum;
}

/// Returns the square of a tolerance with PCL's rounding.
float GetSquare(double tolerance)
{
  const auto rounded = static_cast<double>(static_cast<float>(tolerance));
  return static_cast<float>(rounded * rounded);
}

float GetSquare(const pcl::PointXYZ& a, const pcl::PointXYZ& b)
{
  float sum = 0.0F;
  for (int axis = 0; axis < 3; ++axis)
  {
    const float step = a.data[axis] - b.data[axis];
    sum += step * step;
  }
  return sum;
}

class Clusters
{
public:
  Clusters(const Cloud::ConstPtr& points, double tolerance, const GoOn& goOn)
    : Points(points)
    , Side(Safety * tolerance / std::sqrt(3.0))
    , Square(GetSquare(tolerance))
    , Report(goOn)
    , Order(points->size())
  {
  }

  std::vector<int> Find() { return this->Join() ? this->GetFirstPoints() : std::vector<int>(); }

  /// Sorts points by cells, and cells by position.
  void Sort()
  {
    std::vector<std::pair<Place, int>> places;
    places.reserve(this->Order.size());
    for (std::size_t i = 0; i < this->Order.size(); ++i)
    {
      places.emplace_back(this->GetPlace(static_cast<int>(i)), static_cast<int>(i));
    }
    std::sort(places.begin(), places.end());
    for (std::size_t i = 0; i < this->Order.size(); ++i)
    {
      this->Order[i] = places[i].second;
      if (i == 0 || places[i].first != this->Cells.back())
      {
        this->Begin.push_back(i);
        this->Cells.push_back(places[i].first);
        this->Smallest.push_back(places[i].second);
      }
    }
    this->Begin.push_back(this->Order.size());
    this->Parent.resize(this->Cells.size());
    std::iota(this->Parent.begin(), this->Parent.end(), std::size_t(0));
    this->Boxes.resize(this->Cells.size());
    for (std::size_t c = 0; c < this->Cells.size(); ++c)
    {
      this->Boxes[c] = this->GetBox(this->GetBegin(c), this->GetBegin(c + 1));
    }
  }

private:
  using Iterator = std::vector<int>::iterator;

  const pcl::PointXYZ& Get(int i) const { return (*this->Points)[static_cast<std::size_t>(i)]; }

  Place GetPlace(int i) const
  {
    const pcl::PointXYZ& p = this->Get(i);
    return { std::floor(static_cast<double>(p.x) / this->Side),
      std::floor(static_cast<double>(p.y) / this->Side),
      std::floor(static_cast<double>(p.z) / this->Side) };
  }

  /// Joins each cell with later ones that may have near points: the rest of its column, and columns
  /// up to two away, each with an index that advances with the cell. False: stopped.
  bool Join()
  {
    std::vector<std::size_t> next(this->Cells.empty() ? 0 : 13);
    for (std::size_t c = 0; c < this->Cells.size(); ++c)
    {
      std::size_t column = 0;
      for (int dx = 0; dx <= 2; ++dx)
      {
        for (int dy = dx == 0 ? 0 : -2; dy <= 2; ++dy)
        {
          const Place& from = this->Cells[c];
          const Place first = { from[0] + dx, from[1] + dy, from[2] - 2.0 };
          std::size_t& other = next[column++];
          while (other < this->Cells.size() && (other <= c || this->Cells[other] < first))
          {
            ++other;
          }
          this->JoinColumn(c, other, { first[0], first[1], from[2] + 2.0 });
        }
      }
      if (!this->GoesOn(c, 13))
      {
        return false;
      }
    }
    return true;
  }

  /// Joins a cell with others up to a last position.
  void JoinColumn(std::size_t cell, std::size_t other, const Place& last)
  {
    for (; other < this->Cells.size() && !(last < this->Cells[other]) && !this->IsStopped; ++other)
    {
      const std::size_t a = this->FindRoot(cell);
      const std::size_t b = this->FindRoot(other);
      if (a != b && this->AreNear(cell, other))
      {
        this->Parent[std::max(a, b)] = std::min(a, b);
        this->Smallest[std::min(a, b)] = std::min(this->Smallest[a], this->Smallest[b]);
      }
    }
  }

  bool AreNear(std::size_t a, std::size_t b)
  {
    this->Current = a;
    return this->AreNear(this->GetBegin(a), this->GetBegin(a + 1), this->Boxes[a],
      this->GetBegin(b), this->GetBegin(b + 1), this->Boxes[b]);
  }

  /// Returns whether one of the first points is near one of the second. The larger set is halved.
  bool AreNear(
    Iterator a, Iterator aEnd, const Box& aBox, Iterator b, Iterator bEnd, const Box& bBox)
  {
    if (GetSquare(aBox, bBox) >= this->Square || !this->GoesOn(this->Current, (aEnd - a)))
    {
      return false;
    }
    if ((aEnd - a) * (bEnd - b) <= FewPairs)
    {
      return this->HaveNearPair(a, aEnd, b, bEnd);
    }
    if (aEnd - a < bEnd - b)
    {
      return this->AreNear(b, bEnd, bBox, a, aEnd, aBox);
    }
    const Iterator middle = a + (aEnd - a) / 2;
    const int axis = aBox.GetLongestAxis();
    std::nth_element(a, middle, aEnd,
      [this, axis](int i, int j) { return this->Get(i).data[axis] < this->Get(j).data[axis]; });
    return this->AreNear(a, middle, this->GetBox(a, middle), b, bEnd, bBox) ||
      this->AreNear(middle, aEnd, this->GetBox(middle, aEnd), b, bEnd, bBox);
  }

  bool HaveNearPair(Iterator a, Iterator aEnd, Iterator b, Iterator bEnd) const
  {
    return std::any_of(a, aEnd,
      [=](int i)
      {
        return std::any_of(
          b, bEnd, [=](int j) { return GetSquare(this->Get(i), this->Get(j)) < this->Square; });
      });
  }

  Box GetBox(Iterator begin, Iterator end) const
  {
    Box box;
    std::for_each(begin, end, [this, &box](int i) { box.Add(this->Get(i)); });
    return box;
  }

  Iterator GetBegin(std::size_t cell)
  {
    return this->Order.begin() + static_cast<std::ptrdiff_t>(this->Begin[cell]);
  }

  std::size_t FindRoot(std::size_t cell)
  {
    while (this->Parent[cell] != cell)
    {
      cell = this->Parent[cell] = this->Parent[this->Parent[cell]];
    }
    return cell;
  }

  /// Reports from time to time.
  bool GoesOn(std::size_t cell, std::int64_t work)
  {
    this->Work += work;
    if (this->Work >= Stride && !this->IsStopped)
    {
      this->Work = 0;
      this->IsStopped =
        !this->Report(static_cast<double>(cell) / static_cast<double>(this->Cells.size()));
    }
    return !this->IsStopped;
  }

  std::vector<int> GetFirstPoints()
  {
    std::vector<int> first(this->Order.size());
    for (std::size_t c = 0; c < this->Cells.size(); ++c)
    {
      const int smallest = this->Smallest[this->FindRoot(c)];
      std::for_each(this->GetBegin(c), this->GetBegin(c + 1),
        [&first, smallest](int i) { first[static_cast<std::size_t>(i)] = smallest; });
    }
    return first;
  }

  Cloud::ConstPtr Points;
  double Side;
  float Square;
  GoOn Report;
  std::vector<int> Order;          // points by cells
  std::vector<std::size_t> Begin;  // begin of each cell in Order; one more at the end
  std::vector<Place> Cells;        // in their order
  std::vector<Box> Boxes;          // around the points of a cell
  std::vector<std::size_t> Parent; // parent of each cell in the tree of its cluster
  std::vector<int> Smallest;       // point of a cluster, at its root
  std::size_t Current = 0;
  std::int64_t Work = 0;
  bool IsStopped = false;
};

} // namespace

std::vector<int> FindClusters(const Cloud::ConstPtr& points, double tolerance, const GoOn& goOn)
{
  const auto clusters = std::make_shared<Clusters>(points, tolerance, goOn);
  return RunApart(goOn, 0.0, [clusters] { clusters->Sort(); }) ? clusters->Find()
                                                               : std::vector<int>();
}

} // namespace helios
