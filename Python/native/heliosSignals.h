// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Signals that end the process even if Python's handlers cannot run.

#ifndef heliosSignals_h
#define heliosSignals_h

#include "vtkPython.h" // Must be first

/// end_at_second(numbers): the first of these signals runs Python's handler as soon as possible,
/// the second one ends the process immediately. signal.signal() undoes it.
PyObject* heliosEndAtSecond(PyObject* self, PyObject* args);

#endif
