// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosChunks.h"

#include <future>
#include <mutex>
#include <utility>
#include <vector>

namespace helios
{

namespace
{

constexpr std::chrono::milliseconds TimeBetweenReports(50);

/// Detached calls; only the end of the process waits for them.
class LeftCalls
{
public:
  void Add(std::future<void>&& call)
  {
    const std::lock_guard<std::mutex> lock(this->Access);
    this->Calls.erase(
      std::remove_if(this->Calls.begin(), this->Calls.end(), IsDone), this->Calls.end());
    this->Calls.push_back(std::move(call));
  }

private:
  static bool IsDone(const std::future<void>& call)
  {
    return call.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  }

  std::mutex Access;
  std::vector<std::future<void>> Calls; // waits on destruction
};

} // namespace

bool RunApart(const GoOn& goOn, double share, std::function<void()> call)
{
  static LeftCalls left;
  std::future<void> done = std::async(std::launch::async, std::move(call));
  do
  {
    if (!goOn(share))
    {
      left.Add(std::move(done));
      return false;
    }
  } while (done.wait_for(TimeBetweenReports) != std::future_status::ready);
  done.get(); // rethrows
  return true;
}

} // namespace helios
