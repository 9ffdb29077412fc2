// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosObserve.h"

#include "vtkCommand.h"
#include "vtkObject.h"
#include "vtkPythonUtil.h"

#include <cstring>

namespace
{

/// Calls a Python function with the text of an event.
class TextObserver : public vtkCommand
{
public:
  static TextObserver* New() { return new TextObserver; }

  void SetCallback(PyObject* callback)
  {
    Py_INCREF(callback);
    this->Callback = callback;
  }

  void Execute(vtkObject*, unsigned long, void* data) override
  {
    const auto* text = data ? static_cast<const char*>(data) : "";
    const vtkPythonScopeGilEnsurer lock(true);
    PyObject* type;
    PyObject* value;
    PyObject* trace;
    PyErr_Fetch(&type, &value, &trace); // events may arrive while an exception is pending
    this->Call(text);
    PyErr_Restore(type, value, trace);
  }

private:
  TextObserver() = default;
  ~TextObserver() override
  {
    if (Py_IsInitialized())
    {
      const vtkPythonScopeGilEnsurer lock(true);
      Py_XDECREF(this->Callback);
    }
  }

  void Call(const char* text)
  {
    PyObject* decoded =
      PyUnicode_DecodeUTF8(text, static_cast<Py_ssize_t>(std::strlen(text)), "backslashreplace");
    PyObject* result =
      decoded ? PyObject_CallFunctionObjArgs(this->Callback, decoded, nullptr) : nullptr;
    Py_XDECREF(decoded);
    Py_XDECREF(result);
    if (!result)
    {
      ReportException(this->Callback);
    }
  }

  static void ReportException(PyObject* callback)
  {
    if (PyErr_ExceptionMatches(PyExc_KeyboardInterrupt))
    {
      PyErr_Clear();
      PyErr_SetInterrupt();
      return;
    }
    PyErr_WriteUnraisable(callback);
  }

  PyObject* Callback = nullptr;
};

} // namespace

//------------------------------------------------------------------------------
PyObject* heliosObserve(PyObject*, PyObject* args)
{
  PyObject* object;
  const char* event;
  PyObject* callback;
  if (!PyArg_ParseTuple(args, "OsO", &object, &event, &callback))
  {
    return nullptr;
  }
  auto* watched = static_cast<vtkObject*>(vtkPythonUtil::GetPointerFromObject(object, "vtkObject"));
  if (!watched)
  {
    return PyErr_Occurred() ? nullptr : PyErr_Format(PyExc_TypeError, "None cannot be watched");
  }
  if (vtkCommand::GetEventIdFromString(event) == vtkCommand::NoEvent)
  {
    return PyErr_Format(PyExc_ValueError, "%s is not a VTK event", event);
  }
  if (!PyCallable_Check(callback))
  {
    return PyErr_Format(PyExc_TypeError, "the callback is not callable");
  }
  auto* observer = TextObserver::New();
  observer->SetCallback(callback);
  const unsigned long tag = watched->AddObserver(event, observer);
  observer->Delete();
  return PyLong_FromUnsignedLong(tag);
}
