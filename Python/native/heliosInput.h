// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks of input files, as in the readers.

#ifndef heliosInput_h
#define heliosInput_h

#include "vtkPython.h" // Must be first

/// Implements check_input_file(path as bytes): returns why a path is not a file that can be read;
/// empty if it may be.
PyObject* heliosCheckInputFile(PyObject* self, PyObject* args);

#endif
