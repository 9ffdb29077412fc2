// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRun.h"

#include "vtkAlgorithm.h"
#include "vtkCommand.h"
#include "vtkHeliosCOPCWriter.h"
#include "vtkHeliosSurveyPlayer.h"
#include "vtkHeliosSurveySource.h"
#include "vtkObjectFactory.h"
#include "vtkPythonAlgorithm.h"
#include "vtkPythonUtil.h"
#include "vtkSmartPointer.h"

#include <chrono>
#include <utility>
#include <vector>

namespace
{

/// A vtkPythonAlgorithm that takes the interpreter lock; it keeps its class name.
class GuardedPythonAlgorithm : public vtkPythonAlgorithm
{
public:
  static vtkObjectBase* MakeNew()
  {
    auto* made = new GuardedPythonAlgorithm;
    made->InitializeObjectBase();
    return made;
  }

protected:
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    const vtkPythonScopeGilEnsurer lock(true);
    return this->Superclass::ProcessRequest(request, inputs, outputs);
  }
  int FillInputPortInformation(int port, vtkInformation* info) override
  {
    const vtkPythonScopeGilEnsurer lock(true);
    return this->Superclass::FillInputPortInformation(port, info);
  }
  int FillOutputPortInformation(int port, vtkInformation* info) override
  {
    const vtkPythonScopeGilEnsurer lock(true);
    return this->Superclass::FillOutputPortInformation(port, info);
  }
  using Superclass = vtkPythonAlgorithm;
};

using Objects = std::vector<vtkSmartPointer<vtkObject>>;

void SetAbort(vtkObject* object, bool isAborted)
{
  if (auto* algorithm = vtkAlgorithm::SafeDownCast(object))
  {
    algorithm->SetAbortExecute(isAborted ? 1 : 0);
  }
}

void Abort(vtkObject* object)
{
  SetAbort(object, true);
  if (auto* source = vtkHeliosSurveySource::SafeDownCast(object))
  {
    source->Abort();
  }
  if (auto* player = vtkHeliosSurveyPlayer::SafeDownCast(object))
  {
    player->Abort();
  }
  if (auto* writer = vtkHeliosCOPCWriter::SafeDownCast(object))
  {
    writer->Abort();
  }
}

double GetProgress(vtkObject* object)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(object);
  auto* player = vtkHeliosSurveyPlayer::SafeDownCast(object);
  auto* writer = vtkHeliosCOPCWriter::SafeDownCast(object);
  return algorithm ? algorithm->GetProgress()
    : player       ? player->GetProgress()
    : writer       ? writer->GetProgress()
                   : 0.0;
}

/// Observes progress; stores exceptions.
class Watch : public vtkCommand
{
public:
  static Watch* New() { return new Watch; }

  void Begin(const Objects& objects, PyObject* onProgress, double interval)
  {
    this->Watched = objects;
    this->OnProgress = onProgress;
    this->Interval = std::chrono::duration<double>(interval);
    for (vtkObject* object : this->Watched)
    {
      this->Tags.push_back(object->AddObserver(vtkCommand::ProgressEvent, this));
      const bool isPython = object->IsA("vtkPythonAlgorithm");
      this->Tags.push_back(isPython ? object->AddObserver(vtkCommand::ErrorEvent, this, 1.0f) : 0);
    }
  }

  /// Restores a stored exception; true if there was none.
  bool End()
  {
    for (std::size_t i = 0; i < this->Watched.size(); ++i)
    {
      this->Watched[i]->RemoveObserver(this->Tags[2 * i]);
      this->Watched[i]->RemoveObserver(this->Tags[2 * i + 1]);
      if (this->IsStopping)
      {
        this->Watched[i]->Modified();      // its output is incomplete
        SetAbort(this->Watched[i], false); // since VTK 9.3 it stays
      }
    }
    if (this->IsStopping)
    {
      PyErr_Restore(this->Type, this->Value, this->Traceback);
    }
    return !this->IsStopping;
  }

  /// Exceptions of Python filters: a list.
  PyObject* GetRaised() { return this->Raised; }

  void Execute(vtkObject* caller, unsigned long event, void*) override
  {
    if (event == vtkCommand::ErrorEvent)
    {
      this->StoreException();
      return;
    }
    if (this->IsStopping)
    {
      Abort(caller); // an executive resets it when an algorithm starts
      return;
    }
    const auto now = std::chrono::steady_clock::now();
    if (now - this->Last < this->Interval)
    {
      return;
    }
    this->Last = now;
    const vtkPythonScopeGilEnsurer lock(true);
    if (!this->ReportProgress(caller))
    {
      PyErr_Fetch(&this->Type, &this->Value, &this->Traceback);
      this->IsStopping = true;
      for (vtkObject* object : this->Watched)
      {
        Abort(object);
      }
    }
  }

private:
  Watch()
    : Raised(PyList_New(0))
  {
  }
  ~Watch() override { Py_DECREF(this->Raised); }

  /// Stores an exception: a vtkPythonAlgorithm reports an error before it prints and clears the
  /// exception.
  void StoreException()
  {
    const vtkPythonScopeGilEnsurer lock(true);
    PyObject* type;
    PyObject* value;
    PyObject* trace;
    PyErr_Fetch(&type, &value, &trace);
    PyErr_NormalizeException(&type, &value, &trace);
    if (value)
    {
      if (trace)
      {
        PyException_SetTraceback(value, trace);
      }
      PyList_Append(this->Raised, value);
    }
    Py_XDECREF(type);
    Py_XDECREF(value);
    Py_XDECREF(trace);
  }

  /// Returns false if a signal or the callback raises.
  bool ReportProgress(vtkObject* caller)
  {
    if (PyErr_CheckSignals() != 0)
    {
      return false;
    }
    if (this->OnProgress == Py_None)
    {
      return true;
    }
    PyObject* object = vtkPythonUtil::GetObjectFromPointer(caller);
    PyObject* result = PyObject_CallFunction(this->OnProgress, "Nd", object, GetProgress(caller));
    Py_XDECREF(result);
    return result != nullptr;
  }

  Objects Watched;
  std::vector<unsigned long> Tags;
  PyObject* OnProgress = nullptr;
  std::chrono::duration<double> Interval{ 0.0 };
  std::chrono::steady_clock::time_point Last{};
  bool IsStopping = false;
  PyObject* Raised;
  PyObject* Type = nullptr;
  PyObject* Value = nullptr;
  PyObject* Traceback = nullptr;
};

vtkObject* GetVtkObject(PyObject* object)
{
  return static_cast<vtkObject*>(vtkPythonUtil::GetPointerFromObject(object, "vtkObject"));
}

/// Returns false, with an exception, if the sequence contains anything but VTK objects.
bool Unpack(PyObject* sequence, Objects& objects)
{
  PyObject* items = PySequence_Fast(sequence, "watched is not a sequence");
  for (Py_ssize_t i = 0; items && i < PySequence_Fast_GET_SIZE(items); ++i)
  {
    objects.emplace_back(GetVtkObject(PySequence_Fast_GET_ITEM(items, i)));
    if (!objects.back() && !PyErr_Occurred())
    {
      PyErr_SetString(PyExc_TypeError, "None cannot be watched");
    }
  }
  Py_XDECREF(items);
  return !PyErr_Occurred();
}

bool NeedsLock(const Objects& objects)
{
  for (vtkObject* object : objects)
  {
    if (object->IsA("vtkPythonAlgorithm") && !dynamic_cast<GuardedPythonAlgorithm*>(object))
    {
      return true;
    }
  }
  return false;
}

bool RunTarget(vtkObject* target, int argument)
{
  if (auto* player = vtkHeliosSurveyPlayer::SafeDownCast(target))
  {
    return argument == 0 ? player->Run() : player->Estimate();
  }
  if (auto* writer = vtkHeliosCOPCWriter::SafeDownCast(target))
  {
    return writer->Close();
  }
  auto* source = vtkHeliosSurveySource::SafeDownCast(target);
  if (source && argument < 0)
  {
    return source->Load();
  }
  auto* algorithm = vtkAlgorithm::SafeDownCast(target);
  algorithm->Update(argument);
  return algorithm->GetErrorCode() == 0;
}

} // namespace

//------------------------------------------------------------------------------
PyObject* heliosRun(PyObject*, PyObject* args)
{
  PyObject* targetObject;
  int argument;
  PyObject* sequence;
  PyObject* onProgress;
  double interval;
  Objects watched;
  if (!PyArg_ParseTuple(
        args, "OiOOd", &targetObject, &argument, &sequence, &onProgress, &interval) ||
    !Unpack(sequence, watched))
  {
    return nullptr;
  }
  vtkSmartPointer<vtkObject> target = GetVtkObject(targetObject);
  if (!target ||
    (!target->IsA("vtkAlgorithm") && !target->IsA("vtkHeliosSurveyPlayer") &&
      !target->IsA("vtkHeliosCOPCWriter")))
  {
    return PyErr_Format(PyExc_TypeError,
      "target is not an algorithm, a vtkHeliosSurveyPlayer or a vtkHeliosCOPCWriter");
  }
  auto watch = vtkSmartPointer<Watch>::New();
  watch->Begin(watched, onProgress, interval);
  PyThreadState* state = NeedsLock(watched) ? nullptr : PyEval_SaveThread();
  const bool succeeded = RunTarget(target, argument);
  if (state)
  {
    PyEval_RestoreThread(state);
  }
  const bool isWhole = watch->End() && PyErr_CheckSignals() == 0;
  return isWhole ? Py_BuildValue("NO", PyBool_FromLong(succeeded), watch->GetRaised()) : nullptr;
}

//------------------------------------------------------------------------------
PyObject* heliosGuard(PyObject*, PyObject*)
{
  PyVTKClass* wrapped = vtkPythonUtil::FindClass("vtkPythonAlgorithm");
  if (!wrapped)
  {
    return PyErr_Format(PyExc_ImportError, "vtkPythonAlgorithm is not wrapped");
  }
  wrapped->vtk_new = GuardedPythonAlgorithm::MakeNew;
  Py_RETURN_NONE;
}
