// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs VTK from Python with other Python threads running, Ctrl-C and progress reports.

#ifndef heliosRun_h
#define heliosRun_h

#include "vtkPython.h" // Must be first

/**
 * Implements run(target, argument, watched, on_progress, interval): calls Update(argument) of an
 * algorithm, Load() of a vtkHeliosSurveySource if argument is negative, Run() of a
 * vtkHeliosSurveyPlayer, or its Estimate() if argument is not 0, Close() of a vtkHeliosCOPCWriter. Every object of watched is
 * observed: at its ProgressEvent, at most every interval seconds, pending signals are handled and
 * on_progress (or None) is called with the object and its progress; if either raises, all of them
 * are aborted, and run() raises the same exception. The interpreter lock is released meanwhile,
 * unless watched includes a Python filter that does not acquire it (see guard()). Returns whether
 * target succeeded, if it reports it, and a list of the exceptions of Python filters, which VTK
 * would print and clear.
 */
PyObject* heliosRun(PyObject* self, PyObject* args);

/**
 * Implements guard(): every vtkPythonAlgorithm (i.e. every VTKPythonAlgorithmBase) created from now
 * on acquires the interpreter lock while it runs.
 */
PyObject* heliosGuard(PyObject* self, PyObject* args);

#endif
