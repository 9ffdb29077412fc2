// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Runs VTK from Python so that other Python threads go on, Ctrl-C stops it, and progress is told.

#ifndef heliosRun_h
#define heliosRun_h

#include "vtkPython.h" // Must be first

/**
 * run(target, argument, watched, on_progress, interval): Update(argument) of an algorithm, Load() of
 * a vtkHeliosSurveySource where argument is negative, Run() of a vtkHeliosSurveyPlayer. Every object of watched is listened to: at its ProgressEvent, at most
 * every interval seconds, pending signals are handled and on_progress (or None) is called with the
 * object and its progress; where either raises, all of them are told to abort, and run() raises the
 * same. The interpreter lock is released meanwhile, unless a Python filter that does not take it
 * (see guard()) is among watched. Returns whether target succeeded, as far as it tells, and a list of
 * what Python filters raised, which VTK would print and forget.
 */
PyObject* heliosRun(PyObject* self, PyObject* args);

/**
 * guard(): from now on every vtkPythonAlgorithm that is made (that is, every VTKPythonAlgorithmBase)
 * takes the interpreter lock while it works.
 */
PyObject* heliosGuard(PyObject* self, PyObject* args);

#endif
