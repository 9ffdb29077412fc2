// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Returns smart pointers, which VTK's wrapper cannot.

#ifndef heliosLegTrajectory_h
#define heliosLegTrajectory_h

#include "vtkPython.h" // Must be first

/**
 * Implements trajectory(source, leg, interval): calls GetTrajectory() of a vtkHeliosSurveySource;
 * None for a leg without pulses.
 */
PyObject* heliosGetTrajectory(PyObject* self, PyObject* args);

#endif
