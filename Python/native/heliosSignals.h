// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Signals that end the process in time, even if Python's handlers cannot run.

#ifndef heliosSignals_h
#define heliosSignals_h

#include "vtkPython.h" // Must be first

/**
 * Implements end_after(signals, seconds): from now on the first of these signals runs Python's
 * handler as soon as possible, and ends the process after this time [s], whatever it does; the
 * second one ends it immediately. The exit code is 128 and the number of the signal. No signals:
 * undoes it, also after the first signal.
 */
PyObject* heliosEndAfter(PyObject* self, PyObject* args);

/// Implements set_end_line(text): sets the bytes that are written to standard error if the process
/// is ended.
PyObject* heliosSetEndLine(PyObject* self, PyObject* args);

/// Implements claim_end_line(): returns whether the caller is the first to report the end, and is
/// to write a line.
PyObject* heliosClaimEndLine(PyObject* self, PyObject* args);

/// Implements remove_at_end(path, isUnfinished): adds a file that is removed if the process is
/// ended; or forgets it.
PyObject* heliosRemoveAtEnd(PyObject* self, PyObject* args);

#endif
