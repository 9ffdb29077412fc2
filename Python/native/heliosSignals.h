// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Signals that end the process in time, even if Python's handlers cannot run.

#ifndef heliosSignals_h
#define heliosSignals_h

#include "vtkPython.h" // Must be first

/**
 * end_after(signals, seconds): from now on the first of these signals runs Python's handler as soon
 * as possible, and ends the process after this time [s], whatever it does; the second one ends it
 * immediately. The exit code is 128 and the number of the signal. No signals: undoes it, also after
 * the first signal.
 */
PyObject* heliosEndAfter(PyObject* self, PyObject* args);

/// set_end_line(text): sets what is written to standard error if the process is ended: bytes.
PyObject* heliosSetEndLine(PyObject* self, PyObject* args);

/// claim_end_line(): whether the caller is the first to report the end, and is to write a line.
PyObject* heliosClaimEndLine(PyObject* self, PyObject* args);

/// remove_at_end(path, isUnfinished): a file that is removed if the process is ended; or no longer.
PyObject* heliosRemoveAtEnd(PyObject* self, PyObject* args);

#endif
