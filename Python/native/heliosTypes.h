// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Adds features of newer VTK versions to wrapped classes. These are static types, which Python code
// cannot extend; every object gets them, even if created by C++.

#ifndef heliosTypes_h
#define heliosTypes_h

#include "vtkPython.h" // Must be first

/**
 * Implements set_hooks(configure, refuse, compose, describe): sets the functions called by extended
 * classes: configure(object, keywords) after construction with keywords, refuse(object, name) to
 * raise if an unknown name is read or assigned, compose(left, right) for >>, and describe(object)
 * for repr().
 */
PyObject* heliosSetHooks(PyObject* self, PyObject* args);

/**
 * Implements extend(cls, attributes): gives a wrapped class the attributes of a dictionary, keyword
 * construction, assignment that rejects unknown names, a repr, and, for an algorithm, >>.
 */
PyObject* heliosExtend(PyObject* self, PyObject* args);

#endif
