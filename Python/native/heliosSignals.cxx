// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSignals.h"

#include <array>
#include <csignal>

namespace
{

constexpr int MostSignals = 65;

std::array<struct sigaction, MostSignals> Before; // Python's
volatile std::sig_atomic_t HasCome = 0;

void HandleSignal(int number)
{
  if (HasCome)
  {
    std::signal(number, SIG_DFL);
    std::raise(number); // delivered when this function returns
    return;
  }
  HasCome = 1;
  const auto handler = Before[static_cast<std::size_t>(number)].sa_handler;
  if (handler != SIG_DFL && handler != SIG_IGN)
  {
    handler(number);
  }
}

/// Returns false, with an exception, on failure.
bool Install(long number)
{
  if (number < 1 || number >= MostSignals)
  {
    PyErr_Format(PyExc_ValueError, "%ld is not a signal number", number);
    return false;
  }
  struct sigaction action;
  const int which = static_cast<int>(number);
  struct sigaction& before = Before[static_cast<std::size_t>(number)];
  if (sigaction(which, nullptr, &action) != 0)
  {
    PyErr_SetFromErrno(PyExc_OSError);
    return false;
  }
  if (action.sa_handler == HandleSignal)
  {
    return true;
  }
  before = action;
  action.sa_handler = HandleSignal;
  if (sigaction(which, &action, nullptr) != 0)
  {
    PyErr_SetFromErrno(PyExc_OSError);
    return false;
  }
  return true;
}

} // namespace

//------------------------------------------------------------------------------
PyObject* heliosEndAtSecond(PyObject*, PyObject* args)
{
  PyObject* sequence;
  if (!PyArg_ParseTuple(args, "O", &sequence))
  {
    return nullptr;
  }
  PyObject* items = PySequence_Fast(sequence, "signals is not a sequence of signal numbers");
  HasCome = 0;
  for (Py_ssize_t i = 0; items && i < PySequence_Fast_GET_SIZE(items) && !PyErr_Occurred(); ++i)
  {
    const long number = PyLong_AsLong(PySequence_Fast_GET_ITEM(items, i));
    if (PyErr_Occurred() || !Install(number))
    {
      break;
    }
  }
  Py_XDECREF(items);
  if (PyErr_Occurred())
  {
    return nullptr;
  }
  Py_RETURN_NONE;
}
