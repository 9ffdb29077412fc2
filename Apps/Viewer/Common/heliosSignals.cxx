// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSignals.h"

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>

#include <unistd.h>

namespace helios::viewer
{

namespace
{

constexpr char Line[] = "error: interrupted; files with their final names are complete\n";
constexpr std::size_t LongestPath = 4096;

struct File
{
  std::array<char, LongestPath> Path;
  std::atomic<bool> IsSet{ false };
};

std::array<File, 4> Files; // a video, and a still meanwhile

/// Uses nothing that the interrupted code may have locked.
void End(int number)
{
  if (write(STDERR_FILENO, Line, sizeof Line - 1) < 0)
  {
    // nobody reads it
  }
  for (const File& file : Files)
  {
    if (file.IsSet)
    {
      unlink(file.Path.data());
    }
  }
  _exit(128 + number);
}

} // namespace

//------------------------------------------------------------------------------
void EndOnSignals()
{
  struct sigaction action = {};
  sigset_t both;
  sigemptyset(&both);
  for (const int number : { SIGINT, SIGTERM })
  {
    sigaddset(&both, number);
  }
  action.sa_handler = End;
  action.sa_mask = both; // one line
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigprocmask(SIG_UNBLOCK, &both, nullptr); // vtkhelios view blocks them
}

//------------------------------------------------------------------------------
void SetUnfinished(const std::string& file, bool isUnfinished)
{
  for (File& known : Files)
  {
    const bool isThere = known.IsSet && file == known.Path.data();
    if (isThere || (isUnfinished && !known.IsSet && file.size() < LongestPath))
    {
      std::memcpy(known.Path.data(), file.c_str(), file.size() + 1);
      known.IsSet = isUnfinished;
      break;
    }
  }
}

} // namespace helios::viewer
