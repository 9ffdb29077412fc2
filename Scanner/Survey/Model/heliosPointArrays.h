// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Arrays of the points of a data set.

#ifndef heliosPointArrays_h
#define heliosPointArrays_h

#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace helios
{

/// Returns a new point array with one uninitialized tuple per point.
template <typename ArrayT>
ArrayT* AddPointArray(vtkPolyData* data, const char* name, int components = 1)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(data->GetNumberOfPoints());
  data->GetPointData()->AddArray(array);
  return array;
}

} // namespace helios

#endif
