// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneInput.h"

#include "heliosMessages.h"
#include "vtkHeliosTriangulate.h"

#include <vtkAlgorithm.h>
#include <vtkCellArray.h>
#include <vtkCompositeDataGeometryFilter.h>
#include <vtkCompositeDataSet.h>
#include <vtkDataSet.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

namespace helios
{

namespace
{

template <typename FilterT>
vtkSmartPointer<vtkPolyData> Pass(FilterT* filter, vtkDataObject* data)
{
  filter->SetInputDataObject(data);
  filter->Update();
  auto output = vtkSmartPointer<vtkPolyData>::New();
  output->ShallowCopy(filter->GetOutput());
  output->SetFieldData(data->GetFieldData()); // the materials
  return output;
}

/// Returns the surface of any data set; null for other data.
vtkSmartPointer<vtkPolyData> MakeSurface(vtkDataObject* data)
{
  if (auto* mesh = vtkPolyData::SafeDownCast(data))
  {
    auto copy = vtk::TakeSmartPointer(mesh->NewInstance()); // may have instances
    copy->ShallowCopy(mesh);
    return copy;
  }
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    return Pass(vtkSmartPointer<vtkCompositeDataGeometryFilter>::New().Get(), data);
  }
  return vtkDataSet::SafeDownCast(data)
    ? Pass(vtkSmartPointer<vtkDataSetSurfaceFilter>::New().Get(), data)
    : nullptr;
}

} // namespace

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeTriangles(
  vtkDataObject* data, const std::string& name, Messages& log)
{
  const vtkSmartPointer<vtkPolyData> surface = MakeSurface(data);
  if (!surface || vtkHeliosTriangulate::HasOnlyTriangles(surface))
  {
    return surface; // with its instances
  }
  vtkNew<vtkHeliosTriangulate> filter;
  log.Listen(filter.Get(), name);
  return Pass(filter.Get(), surface);
}

} // namespace helios
