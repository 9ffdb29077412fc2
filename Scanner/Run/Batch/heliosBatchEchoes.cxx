// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosBatchEchoes.h"

#include "vtkHeliosBatchArrayNames.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace helios
{

//------------------------------------------------------------------------------
BatchEchoes::BatchEchoes(vtkIdType scans, std::vector<std::string> names)
  : Scans(static_cast<std::size_t>(scans))
  , Names(std::move(names))
{
}

//------------------------------------------------------------------------------
Status BatchEchoes::Add(vtkIdType scan, vtkPolyData* echoes)
{
  if (echoes->GetNumberOfPoints() == 0)
  {
    return {};
  }
  Arrays arrays = { echoes->GetPoints()->GetData() };
  vtkPointData* data = echoes->GetPointData();
  for (int i = 0; this->Names.empty() && i < data->GetNumberOfArrays(); ++i)
  {
    arrays.emplace_back(data->GetArray(i));
  }
  for (const std::string& name : this->Names)
  {
    arrays.emplace_back(data->GetArray(name.c_str()));
    if (!arrays.back())
    {
      return Status::Error("the echoes have no array " + name);
    }
  }
  this->Scans[static_cast<std::size_t>(scan)] = std::move(arrays);
  return {};
}

//------------------------------------------------------------------------------
void BatchEchoes::Join(vtkPolyData* output)
{
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetName(vtkHeliosBatchArrayNames::Offsets);
  offsets->InsertNextValue(0);
  vtkIdType count = 0;
  for (const Arrays& arrays : this->Scans)
  {
    count += arrays.empty() ? 0 : arrays.front()->GetNumberOfTuples();
    offsets->InsertNextValue(count);
  }
  output->GetFieldData()->AddArray(offsets);
  const auto model = std::find_if(
    this->Scans.begin(), this->Scans.end(), [](const Arrays& arrays) { return !arrays.empty(); });
  const std::size_t columns = model == this->Scans.end() ? 0 : model->size();
  for (std::size_t k = 0; k < columns; ++k)
  {
    const auto whole = vtkSmartPointer<vtkDataArray>::Take((*model)[k]->NewInstance());
    whole->SetName((*model)[k]->GetName());
    whole->SetNumberOfComponents((*model)[k]->GetNumberOfComponents());
    whole->SetNumberOfTuples(count);
    const auto size = static_cast<std::size_t>(whole->GetDataTypeSize()) *
      static_cast<std::size_t>(whole->GetNumberOfComponents());
    auto* values = static_cast<char*>(whole->GetVoidPointer(0));
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Scans.size()),
      [&](vtkIdType first, vtkIdType last)
      {
        for (vtkIdType scan = first; scan < last; ++scan)
        {
          Arrays& arrays = this->Scans[static_cast<std::size_t>(scan)];
          if (!arrays.empty())
          {
            std::memcpy(values + size * static_cast<std::size_t>(offsets->GetValue(scan)),
              arrays[k]->GetVoidPointer(0),
              size * static_cast<std::size_t>(arrays[k]->GetNumberOfTuples()));
            arrays[k] = nullptr;
          }
        }
      });
    if (k > 0)
    {
      output->GetPointData()->AddArray(whole);
      continue;
    }
    vtkNew<vtkPoints> points;
    points->SetData(whole);
    output->SetPoints(points);
  }
  this->Scans.clear();
}

} // namespace helios
