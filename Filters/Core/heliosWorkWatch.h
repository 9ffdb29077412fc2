// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Progress and stop of work that several threads do.

#ifndef heliosWorkWatch_h
#define heliosWorkWatch_h

#include <vtkType.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <thread>

namespace helios
{

/// The fraction done [0, 1]; false ends the work.
using RunWatcher = std::function<bool(double)>;

/// Reports the progress of work in the thread that started it, and lets all threads end early.
class WorkWatch
{
public:
  static constexpr std::chrono::milliseconds Interval{ 100 }; ///< between two reports

  WorkWatch(const RunWatcher& goesOn, vtkIdType steps)
    : GoesOn(goesOn)
    , Steps(steps)
    , Caller(std::this_thread::get_id())
  {
  }

  /// Returns whether the work ends; for any thread, once a step.
  bool IsStopped() const { return this->Stopped.load(std::memory_order_relaxed); }

  /// Ends the work; for any thread.
  void Stop() { this->Stopped.store(true, std::memory_order_relaxed); }

  /// Counts steps that were done; for any thread. The thread that started the work reports at
  /// intervals.
  void Count(vtkIdType steps)
  {
    this->Done.fetch_add(steps, std::memory_order_relaxed);
    if (std::this_thread::get_id() == this->Caller &&
      std::chrono::steady_clock::now() - this->Last > Interval)
    {
      this->Report();
    }
  }

  /// Reports the progress; false if the work ends.
  bool Report()
  {
    const auto done = static_cast<double>(this->Done.load(std::memory_order_relaxed));
    if (!this->IsStopped() && !this->GoesOn(done / static_cast<double>(this->Steps)))
    {
      this->Stop();
    }
    this->Last = std::chrono::steady_clock::now();
    return !this->IsStopped();
  }

private:
  const RunWatcher& GoesOn;
  const vtkIdType Steps;
  const std::thread::id Caller;
  std::atomic<vtkIdType> Done{ 0 };
  std::atomic<bool> Stopped{ false };
  std::chrono::steady_clock::time_point Last;
};

} // namespace helios

#endif
