// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Signals that end the process also where Python's handlers cannot run.

#ifndef heliosSignals_h
#define heliosSignals_h

#include "vtkPython.h" // Must be first

/// end_at_second(numbers): the first of these signals runs Python's handler when it next can, the
/// second one ends the process at once, whatever it is at. signal.signal() takes it back.
PyObject* heliosEndAtSecond(PyObject* self, PyObject* args);

#endif
