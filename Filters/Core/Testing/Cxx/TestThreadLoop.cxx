// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Loops on all threads, and on one where a loop is within another.
#include "heliosThreadLoop.h"

#include <catch2/catch.hpp>

#include <atomic>
#include <thread>

using helios::LoopOnThreads;
using helios::OneThreadScope;

TEST_CASE("ThreadLoop: every number has its turn, on one thread within a scope", "[ThreadLoop]")
{
  const auto count = [](vtkIdType last)
  {
    const std::thread::id own = std::this_thread::get_id();
    std::atomic<int> calls(0);
    std::atomic<vtkIdType> sum(0);
    std::atomic<bool> isOwn(true);
    LoopOnThreads(0, last,
      [&](vtkIdType begin, vtkIdType end)
      {
        ++calls;
        isOwn = isOwn && std::this_thread::get_id() == own;
        for (vtkIdType i = begin; i < end; ++i)
        {
          sum += i;
        }
      });
    CHECK(sum == last * (last - 1) / 2);
    return calls == 1 && isOwn;
  };
  CHECK(count(1));
  CHECK_FALSE(count(1000)); // in pieces
  {
    const OneThreadScope outer;
    {
      const OneThreadScope inner;
      CHECK(count(1000));
    }
    CHECK(OneThreadScope::IsOn());
    CHECK(count(1000));
  }
  CHECK_FALSE(OneThreadScope::IsOn());
}
