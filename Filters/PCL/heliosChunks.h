// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Splits work into chunks; between chunks a filter reports progress and may stop.

#ifndef heliosChunks_h
#define heliosChunks_h

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>

namespace helios
{

/// Reports the share of work done in [0, 1]; returns false if the work must stop.
using GoOn = std::function<bool(double)>;

/// Maps the progress of a part of the work to its interval of the whole.
inline GoOn Within(const GoOn& goOn, double first, double last)
{
  return [=](double share) { return goOn(first + (last - first) * share); };
}

/// Calls work(begin, end) for all of [0, count), in chunks of 64 to 4096 that take about 0.05 s if
/// possible; false if it was stopped.
template <typename WorkT>
bool ForChunks(std::size_t count, const GoOn& goOn, WorkT&& work)
{
  constexpr std::size_t smallest = 64;
  constexpr std::size_t largest = 4096;
  constexpr std::chrono::milliseconds longest(50);
  std::size_t size = smallest;
  for (std::size_t begin = 0; begin < count;)
  {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t end = std::min(count, begin + size);
    work(begin, end);
    const bool isShort = std::chrono::steady_clock::now() - start < longest;
    size = std::clamp(isShort ? 2 * size : size / 2, smallest, largest);
    begin = end;
    if (!goOn(static_cast<double>(end) / static_cast<double>(count)))
    {
      return false;
    }
  }
  return true;
}

/**
 * Runs a library call that cannot be stopped, such as building a search tree, in its own thread;
 * reports progress meanwhile. False if it was stopped: the call continues detached, so it owns all
 * its data, and its result is dropped.
 */
bool RunApart(const GoOn& goOn, double share, std::function<void()> call);

} // namespace helios

#endif
