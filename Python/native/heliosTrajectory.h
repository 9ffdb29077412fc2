// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// What VTK's wrapper cannot return: the object of a smart pointer.

#ifndef heliosTrajectory_h
#define heliosTrajectory_h

#include "vtkPython.h" // Must be first

/**
 * trajectory(source, leg, interval): GetTrajectory() of a vtkHeliosSurveySource; None for a leg that
 * fires nothing.
 */
PyObject* heliosGetTrajectory(PyObject* self, PyObject* args);

#endif
