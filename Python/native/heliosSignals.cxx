// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSignals.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <thread>

#include <semaphore.h>
#include <unistd.h>

namespace
{

constexpr int MaximumSignals = 65;
constexpr std::size_t MaximumFiles = 64;
constexpr std::size_t LongestLine = 8192;
constexpr std::size_t LongestPath = 4096;

// The following is used by a signal handler: without locks, and without memory of the heap.

struct Text
{
  std::array<char, LongestLine> Bytes;
  std::size_t Size = 0;
};

struct UnfinishedFile
{
  std::array<char, LongestPath> Path;
  std::atomic<bool> IsSet{ false };
};

std::array<struct sigaction, MaximumSignals> Before; // Python's
std::array<bool, MaximumSignals> IsInstalled;
std::array<Text, 2> Lines; // one is written while the other one is set
std::atomic<std::size_t> Line{ 0 };
std::array<UnfinishedFile, MaximumFiles> Files;
std::atomic<bool> IsReported{ false };
std::atomic<int> Arrived{ 0 };                // the first signal; 0: none
std::atomic<long long> Nanoseconds{ 0 };      // from it to the end
std::atomic<unsigned int> Installations{ 0 }; // an end belongs to one of them
sem_t Wakes;

/// Writes the line, removes unfinished files, and ends the process.
[[noreturn]] void End(int number)
{
  if (!IsReported.exchange(true))
  {
    const Text& line = Lines[Line];
    std::size_t done = 0;
    while (done < line.Size)
    {
      const ssize_t count = write(STDERR_FILENO, line.Bytes.data() + done, line.Size - done);
      if (count <= 0 && errno != EINTR)
      {
        break;
      }
      done += static_cast<std::size_t>(std::max<ssize_t>(0, count));
    }
  }
  for (UnfinishedFile& file : Files)
  {
    if (file.IsSet)
    {
      unlink(file.Path.data());
    }
  }
  _exit(128 + number);
}

void HandleSignal(int number)
{
  int none = 0;
  if (!Arrived.compare_exchange_strong(none, number))
  {
    End(number);
  }
  const int error = errno;
  sem_post(&Wakes);
  const auto handler = Before[static_cast<std::size_t>(number)].sa_handler;
  if (handler != SIG_DFL && handler != SIG_IGN)
  {
    handler(number);
  }
  errno = error;
}

/// Ends the process some time after a signal, unless that is undone.
[[noreturn]] void Watch()
{
  for (;;)
  {
    while (sem_wait(&Wakes) != 0)
    {
    }
    const unsigned int installation = Installations;
    std::this_thread::sleep_for(std::chrono::nanoseconds(Nanoseconds));
    const int number = Arrived;
    if (number != 0 && installation == Installations)
    {
      End(number);
    }
  }
}

/// Starts the thread that watches, once; it takes no signals.
void StartWatch()
{
  static const bool isStarted = []
  {
    sem_init(&Wakes, 0, 0);
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    std::thread(Watch).detach();
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return true;
  }();
  static_cast<void>(isStarted);
}

/// Returns false, with an exception, on failure.
bool Install(long number)
{
  if (number < 1 || number >= MaximumSignals)
  {
    PyErr_Format(PyExc_ValueError, "%ld is not a signal number", number);
    return false;
  }
  const int which = static_cast<int>(number);
  const auto index = static_cast<std::size_t>(number);
  struct sigaction action;
  if (sigaction(which, nullptr, &action) == 0)
  {
    Before[index] = action;
    action.sa_handler = HandleSignal;
    IsInstalled[index] = sigaction(which, &action, nullptr) == 0;
  }
  if (!IsInstalled[index])
  {
    PyErr_SetFromErrno(PyExc_OSError);
  }
  return IsInstalled[index];
}

/// Restores the handlers that are still installed.
void Undo()
{
  ++Installations;
  for (std::size_t index = 0; index < IsInstalled.size(); ++index)
  {
    struct sigaction action;
    const int which = static_cast<int>(index);
    if (IsInstalled[index] && sigaction(which, nullptr, &action) == 0 &&
      action.sa_handler == HandleSignal)
    {
      sigaction(which, &Before[index], nullptr);
    }
    IsInstalled[index] = false;
  }
  Arrived = 0;
  IsReported = false;
}

} // namespace

//------------------------------------------------------------------------------
PyObject* heliosEndAfter(PyObject*, PyObject* args)
{
  PyObject* sequence;
  double seconds;
  if (!PyArg_ParseTuple(args, "Od", &sequence, &seconds))
  {
    return nullptr;
  }
  if (!(seconds >= 0.0 && seconds <= 3600.0))
  {
    return PyErr_Format(PyExc_ValueError, "seconds is not within 0 and 3600");
  }
  PyObject* items = PySequence_Fast(sequence, "signals is not a sequence of signal numbers");
  if (!items)
  {
    return nullptr;
  }
  Undo();
  StartWatch();
  Nanoseconds = static_cast<long long>(1e9 * seconds);
  for (Py_ssize_t i = 0; i < PySequence_Fast_GET_SIZE(items); ++i)
  {
    const long number = PyLong_AsLong(PySequence_Fast_GET_ITEM(items, i));
    if (PyErr_Occurred() || !Install(number))
    {
      Undo();
      break;
    }
  }
  Py_DECREF(items);
  if (PyErr_Occurred())
  {
    return nullptr;
  }
  Py_RETURN_NONE;
}

//------------------------------------------------------------------------------
PyObject* heliosSetEndLine(PyObject*, PyObject* args)
{
  PyObject* text;
  if (!PyArg_ParseTuple(args, "S", &text))
  {
    return nullptr;
  }
  const std::size_t other = 1 - Line;
  Lines[other].Size = std::min(static_cast<std::size_t>(PyBytes_GET_SIZE(text)), LongestLine);
  std::memcpy(Lines[other].Bytes.data(), PyBytes_AS_STRING(text), Lines[other].Size);
  Line = other;
  Py_RETURN_NONE;
}

//------------------------------------------------------------------------------
PyObject* heliosClaimEndLine(PyObject*, PyObject*)
{
  return PyBool_FromLong(!IsReported.exchange(true));
}

//------------------------------------------------------------------------------
PyObject* heliosRemoveAtEnd(PyObject*, PyObject* args)
{
  const char* path;
  int isUnfinished;
  if (!PyArg_ParseTuple(args, "yp", &path, &isUnfinished))
  {
    return nullptr;
  }
  for (UnfinishedFile& file : Files)
  {
    const bool isThere = file.IsSet && std::strcmp(file.Path.data(), path) == 0;
    if (isThere || (isUnfinished && !file.IsSet && std::strlen(path) < LongestPath))
    {
      if (!isThere)
      {
        std::strcpy(file.Path.data(), path);
      }
      file.IsSet = isUnfinished != 0;
      break;
    }
  }
  Py_RETURN_NONE; // the .part of further files stays
}
