// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Passes the texts of events to Python, for any bytes.

#ifndef heliosObserve_h
#define heliosObserve_h

#include "vtkPython.h" // Must be first

/**
 * Implements observe(object, event, callback): calls callback(text) at every event of that name,
 * and returns the tag for object.RemoveObserver(). Bytes of the text that are not UTF-8 become
 * backslash escapes (\xff); VTK's own observers with CallDataType "string0" drop the whole text.
 * Exceptions of callback are written to standard error, except that Ctrl-C during it is kept for
 * the next signal check.
 */
PyObject* heliosObserve(PyObject* self, PyObject* args);

#endif
