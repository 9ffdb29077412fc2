// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Adds to wrapped classes what newer versions of VTK have by themselves. They are static types, and
// Python code cannot; but whoever makes an object of them, C++ included, it has all of it.

#ifndef heliosTypes_h
#define heliosTypes_h

#include "vtkPython.h" // Must be first

/**
 * set_hooks(configure, refuse, compose, describe): the functions that extended classes call:
 * configure(object, keywords) after construction with keywords, refuse(object, name) to raise where
 * a name that the class does not have is read or assigned to, compose(left, right) for >>, and
 * describe(object) for repr().
 */
PyObject* heliosSetHooks(PyObject* self, PyObject* args);

/**
 * extend(cls, attributes): gives a wrapped class the attributes of a dictionary, keyword
 * construction, assignment that refuses unknown names, a repr, and, to an algorithm, >>.
 */
PyObject* heliosExtend(PyObject* self, PyObject* args);

#endif
