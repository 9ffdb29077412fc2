// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPointSelection.h"

#include <vtkCellArray.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace helios
{

namespace
{

void MakeVertices(vtkIdType count, vtkPolyData* output)
{
  vtkNew<vtkCellArray> vertices;
  vertices->AllocateExact(count, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  output->SetVerts(vertices);
}

} // namespace

void SelectPoints(vtkPolyData* input, const std::vector<vtkIdType>& ids, vtkPolyData* output)
{
  const auto count = static_cast<vtkIdType>(ids.size());
  vtkNew<vtkIdList> from;
  from->SetNumberOfIds(count);
  std::copy(ids.begin(), ids.end(), from->GetPointer(0));

  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints() ? input->GetPoints()->GetDataType() : VTK_DOUBLE);
  points->SetNumberOfPoints(count);
  if (count > 0)
  {
    input->GetPoints()->GetData()->GetTuples(from, points->GetData());
  }
  output->SetPoints(points);

  vtkPointData* data = output->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(input->GetPointData(), count);
  vtkNew<vtkIdList> to;
  to->SetNumberOfIds(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    to->SetId(i, i);
  }
  data->CopyData(input->GetPointData(), from, to);
  output->GetFieldData()->PassData(input->GetFieldData());
  if (input->GetNumberOfVerts() > 0)
  {
    MakeVertices(count, output);
  }
}

} // namespace helios
