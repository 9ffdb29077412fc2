// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosFiniteCheck.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>

#include <algorithm>
#include <cmath>

namespace helios
{

namespace
{

/// Counts the tuples with a non-finite value; 0 for arrays of other types.
template <typename ArrayT>
vtkIdType CountTuples(vtkDataArray* data)
{
  auto* array = ArrayT::FastDownCast(data);
  const vtkIdType tuples = array ? array->GetNumberOfTuples() : 0;
  vtkIdType count = 0;
  for (vtkIdType i = 0; i < tuples; ++i)
  {
    const auto* tuple = array->GetPointer(i * array->GetNumberOfComponents());
    count += !std::all_of(tuple, tuple + array->GetNumberOfComponents(),
      [](auto value) { return std::isfinite(value); });
  }
  return count;
}

} // namespace

std::vector<std::pair<std::string, vtkIdType>> CountNotFinite(vtkFieldData* data)
{
  std::vector<std::pair<std::string, vtkIdType>> counts;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = data->GetArray(i);
    const vtkIdType count =
      array ? CountTuples<vtkFloatArray>(array) + CountTuples<vtkDoubleArray>(array) : 0;
    if (count > 0)
    {
      counts.emplace_back(array->GetName() ? array->GetName() : "", count);
    }
  }
  return counts;
}

} // namespace helios
