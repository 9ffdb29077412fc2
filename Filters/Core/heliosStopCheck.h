// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Interrupts long work from the inside, including callbacks from a library.

#ifndef heliosStopCheck_h
#define heliosStopCheck_h

#include <cstddef>
#include <functional>

namespace helios
{

/// Exception that stops work, also through library code.
struct __attribute__((visibility("default"))) Stopped
{
};

/// Counts steps of some work and polls at intervals for a stop request.
class StopCheck
{
public:
  static constexpr std::size_t Interval = 20000; ///< steps of a few microseconds at most

  /// Sets the callback; null: never stops.
  explicit StopCheck(const std::function<bool()>& shouldStop)
    : ShouldStop(shouldStop)
  {
  }

  /// Throws Stopped on a stop request.
  void Count(std::size_t steps = 1)
  {
    this->Steps += steps;
    if (this->Steps >= Interval)
    {
      this->Steps = 0;
      this->Poll();
    }
  }

  const std::function<bool()>& GetShouldStop() const { return this->ShouldStop; }

  void Poll() const
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

/// Sorts primitives of a CGAL tree like the functor of its traits, and can be stopped.
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
