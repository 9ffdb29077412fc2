// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegTrajectory.h"

#include "vtkHeliosSurveySource.h"
#include "vtkPolyData.h"
#include "vtkPythonUtil.h"

//------------------------------------------------------------------------------
PyObject* heliosGetTrajectory(PyObject*, PyObject* args)
{
  PyObject* object;
  int leg;
  double interval;
  if (!PyArg_ParseTuple(args, "Oid", &object, &leg, &interval))
  {
    return nullptr;
  }
  auto* source = static_cast<vtkHeliosSurveySource*>(
    vtkPythonUtil::GetPointerFromObject(object, "vtkHeliosSurveySource"));
  return source ? vtkPythonUtil::GetObjectFromPointer(source->GetTrajectory(leg, interval))
                : nullptr;
}
