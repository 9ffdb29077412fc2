// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneCrs.h"

#include "vtkHeliosArrayNames.h"

#include <vtkDataObject.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

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
