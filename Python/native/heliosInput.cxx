// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosInput.h"

#include "heliosInputFile.h"

//------------------------------------------------------------------------------
PyObject* heliosCheckInputFile(PyObject*, PyObject* args)
{
  const char* path = nullptr;
  if (!PyArg_ParseTuple(args, "y:check_input_file", &path))
  {
    return nullptr;
  }
  return PyUnicode_FromString(helios::CheckInputFile(path).Message().c_str());
}
