// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneCrs.h"

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPointArrayNames.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>

namespace helios
{

namespace names = vtkHeliosArrayNames;

//------------------------------------------------------------------------------
std::string GetCRS(vtkDataObject* data)
{
  auto* crs = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(names::CRS));
  return crs && crs->GetNumberOfValues() > 0 ? std::string(crs->GetValue(0)) : std::string();
}

//------------------------------------------------------------------------------
CoordinateSteps GetCoordinateSteps(vtkDataObject* data)
{
  CoordinateSteps steps;
  vtkDataArray* stored = data->GetFieldData()->GetArray(vtkHeliosPointArrayNames::CoordinateScale);
  const vtkIdType count = stored ? stored->GetNumberOfValues() : 0;
  const auto get = [stored](vtkIdType i) { return stored->GetVariantValue(i).ToDouble(); };
  for (int axis = 0; (count == 3 || count == 6) && axis < 3; ++axis)
  {
    steps.Scale[axis] = get(axis) > 0.0 ? get(axis) : steps.Scale[axis];
    steps.Offset[axis] = count == 6 ? get(3 + axis) : 0.0;
  }
  steps.HasOffset = count == 6 &&
    std::all_of(steps.Scale.begin(), steps.Scale.end(), [](double x) { return std::isfinite(x); });
  return steps;
}

//------------------------------------------------------------------------------
void SetCoordinateSteps(vtkDataObject* data, const CoordinateSteps& steps)
{
  data->GetFieldData()->RemoveArray(vtkHeliosPointArrayNames::CoordinateScale);
  vtkNew<vtkDoubleArray> stored;
  stored->SetName(vtkHeliosPointArrayNames::CoordinateScale);
  for (const double step : steps.Scale)
  {
    if (!std::isfinite(step) || !(step > 0.0))
    {
      return;
    }
    stored->InsertNextValue(step);
  }
  for (int axis = 0; steps.HasOffset && axis < 3; ++axis)
  {
    stored->InsertNextValue(steps.Offset[axis]);
  }
  data->GetFieldData()->AddArray(stored);
}

//------------------------------------------------------------------------------
void SetCRS(vtkDataObject* data, const std::string& crs)
{
  data->GetFieldData()->RemoveArray(names::CRS);
  if (!crs.empty())
  {
    vtkNew<vtkStringArray> column;
    column->SetName(names::CRS);
    column->InsertNextValue(crs);
    data->GetFieldData()->AddArray(column);
  }
}

} // namespace helios
