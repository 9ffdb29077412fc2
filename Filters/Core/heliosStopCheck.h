// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Ends long work from inside of it, also from calls that a library makes back.

#ifndef heliosStopCheck_h
#define heliosStopCheck_h

#include <cstddef>
#include <functional>

namespace helios
{

/// Thrown where work was told to stop, across libraries too.
struct __attribute__((visibility("default"))) Stopped
{
};

/// Counts the steps of some work and asks now and then whether it shall stop.
class StopCheck
{
public:
  static constexpr std::size_t Interval = 20000; ///< steps, of some microseconds each at most

  /// Null: never.
  explicit StopCheck(const std::function<bool()>& shouldStop)
    : ShouldStop(shouldStop)
  {
  }

  /// Throws Stopped where the work shall stop.
  void Count(std::size_t steps = 1)
  {
    this->Steps += steps;
    if (this->Steps >= Interval)
    {
      this->Steps = 0;
      this->Ask();
    }
  }

  void Ask() const
  {
    if (this->ShouldStop && this->ShouldStop())
    {
      throw Stopped();
    }
  }

private:
  std::function<bool()> ShouldStop;
  std::size_t Steps = 0;
};

/// Sorts primitives of a tree of CGAL's as a functor of its traits does, and lets that be stopped.
template <typename SortT>
class StoppableSplit
{
public:
  StoppableSplit(const SortT& sort, StopCheck& check)
    : Sort(sort)
    , Check(check)
  {
  }
  template <typename IteratorT, typename BoxT>
  void operator()(IteratorT first, IteratorT last, const BoxT& box) const
  {
    this->Check.Count(1 + static_cast<std::size_t>(last - first) / 8);
    this->Sort(first, last, box);
  }

private:
  SortT Sort;
  StopCheck& Check;
};

} // namespace helios

#endif
