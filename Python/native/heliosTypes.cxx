// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTypes.h"

#include "PyVTKObject.h"

#include <cstring>

namespace
{

enum Hook
{
  Configure,
  Refuse,
  Compose,
  Describe,
  NumberOfHooks
};

PyObject* Hooks[NumberOfHooks] = {};

bool IsPythonClass(PyTypeObject* type)
{
  return PyType_HasFeature(type, Py_TPFLAGS_HEAPTYPE);
}

/// Keywords are left to tp_init.
PyObject* New(PyTypeObject* type, PyObject* args, PyObject*)
{
  return PyVTKObject_New(type, args, nullptr);
}

/// Sets properties from keywords.
int Init(PyObject* self, PyObject*, PyObject* keywords)
{
  if (!keywords || PyDict_Size(keywords) == 0)
  {
    return 0;
  }
  PyObject* result = PyObject_CallFunctionObjArgs(Hooks[Configure], self, keywords, nullptr);
  Py_XDECREF(result);
  return result ? 0 : -1;
}

/// Sets an attribute: Python subclasses may set any; so may names with an underscore.
int SetAttribute(PyObject* self, PyObject* name, PyObject* value)
{
  const char* text = PyUnicode_AsUTF8(name);
  const bool isChecked = text && text[0] != '_' && !IsPythonClass(Py_TYPE(self));
  if (isChecked && !PyObject_HasAttr(reinterpret_cast<PyObject*>(Py_TYPE(self)), name))
  {
    Py_XDECREF(PyObject_CallFunctionObjArgs(Hooks[Refuse], self, name, nullptr));
    return -1;
  }
  return text ? PyObject_GenericSetAttr(self, name, value) : -1;
}

/// Suggests similar names if the name is unknown.
PyObject* GetAttribute(PyObject* self, PyObject* name)
{
  PyObject* value = PyObject_GenericGetAttr(self, name);
  const bool isMissing = !value && PyErr_ExceptionMatches(PyExc_AttributeError);
  if (isMissing && !IsPythonClass(Py_TYPE(self)) && PyUnicode_READ_CHAR(name, 0) != '_')
  {
    PyErr_Clear();
    Py_XDECREF(PyObject_CallFunctionObjArgs(Hooks[Refuse], self, name, nullptr));
  }
  return value;
}

PyObject* Shift(PyObject* left, PyObject* right)
{
  return PyObject_CallFunctionObjArgs(Hooks[Compose], left, right, nullptr);
}

PyObject* Represent(PyObject* self)
{
  return PyObject_CallFunctionObjArgs(Hooks[Describe], self, nullptr);
}

/// Calls the class's __call__.
PyObject* Call(PyObject* self, PyObject* args, PyObject* keywords)
{
  PyObject* function =
    PyObject_GetAttrString(reinterpret_cast<PyObject*>(Py_TYPE(self)), "__call__");
  PyObject* bound = function ? PyMethod_New(function, self) : nullptr;
  PyObject* result = bound ? PyObject_Call(bound, args, keywords) : nullptr;
  Py_XDECREF(function);
  Py_XDECREF(bound);
  return result;
}

PyNumberMethods NumberMethods = {};

} // namespace

//------------------------------------------------------------------------------
PyObject* heliosSetHooks(PyObject*, PyObject* args)
{
  PyObject* hooks[NumberOfHooks];
  if (!PyArg_ParseTuple(
        args, "OOOO", &hooks[Configure], &hooks[Refuse], &hooks[Compose], &hooks[Describe]))
  {
    return nullptr;
  }
  for (int i = 0; i < NumberOfHooks; ++i)
  {
    Py_INCREF(hooks[i]);
    Py_XSETREF(Hooks[i], hooks[i]);
  }
  Py_RETURN_NONE;
}

//------------------------------------------------------------------------------
PyObject* heliosExtend(PyObject*, PyObject* args)
{
  PyTypeObject* type;
  PyObject* attributes;
  int isAlgorithm;
  if (!PyArg_ParseTuple(
        args, "O!O!p", &PyType_Type, &type, &PyDict_Type, &attributes, &isAlgorithm))
  {
    return nullptr;
  }
  if (IsPythonClass(type) || type->tp_dealloc != PyVTKObject_Delete)
  {
    return PyErr_Format(PyExc_TypeError, "%s is not a wrapped class of VTK", type->tp_name);
  }
  if (PyDict_Update(type->tp_dict, attributes) != 0)
  {
    return nullptr;
  }
  type->tp_new = New;
  type->tp_init = Init;
  type->tp_getattro = GetAttribute;
  type->tp_setattro = SetAttribute;
  type->tp_repr = Represent;
  if (isAlgorithm && !type->tp_as_number)
  {
    NumberMethods.nb_rshift = Shift;
    type->tp_as_number = &NumberMethods;
    type->tp_call = Call;
  }
  PyType_Modified(type);
  Py_RETURN_NONE;
}
