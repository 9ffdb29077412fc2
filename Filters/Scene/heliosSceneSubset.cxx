// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneSubset.h"

#include "heliosStatus.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>

#include <algorithm>
#include <numeric>

namespace helios
{

namespace
{

Status FindShortArray(vtkDataSetAttributes* arrays, vtkIdType count, const std::string& kind)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < count)
    {
      const std::string name = array->GetName() ? array->GetName() : "(no name)";
      return Status::Error("The " + kind + " array " + name + " has " +
        std::to_string(array->GetNumberOfTuples()) + " values for " + std::to_string(count) + " " +
        kind + "s; give each " + kind + " a value");
    }
  }
  return {};
}

/// Copies the listed rows of all arrays, in that order.
void CopyRows(
  vtkDataSetAttributes* from, const std::vector<vtkIdType>& rows, vtkDataSetAttributes* to)
{
  const auto count = static_cast<vtkIdType>(rows.size());
  vtkNew<vtkIdList> fromIds;
  vtkNew<vtkIdList> toIds;
  fromIds->SetNumberOfIds(count);
  toIds->SetNumberOfIds(count);
  std::copy(rows.begin(), rows.end(), fromIds->GetPointer(0));
  std::iota(toIds->GetPointer(0), toIds->GetPointer(0) + count, vtkIdType(0));
  to->Initialize();
  to->CopyAllOn();
  to->CopyAllocate(from, count);
  to->CopyData(from, fromIds, toIds);
}

vtkSmartPointer<vtkDoubleArray> CopyPoints(vtkDoubleArray* from, const std::vector<vtkIdType>& rows)
{
  auto to = vtkSmartPointer<vtkDoubleArray>::New();
  to->SetNumberOfComponents(3);
  to->SetNumberOfTuples(static_cast<vtkIdType>(rows.size()));
  double* p = to->GetPointer(0);
  for (const vtkIdType row : rows)
  {
    p = std::copy_n(from->GetPointer(3 * row), 3, p);
  }
  return to;
}

vtkSmartPointer<vtkCellArray> MakePolys(
  const std::vector<vtkTypeInt32>& corners, const std::vector<vtkTypeInt32>& newIds)
{
  vtkNew<vtkTypeInt32Array> connectivity;
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(corners.size()));
  std::transform(corners.begin(), corners.end(), connectivity->GetPointer(0),
    [&newIds](vtkTypeInt32 id) { return newIds[id]; });
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(corners.size() / 3) + 1);
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
  }
  auto polys = vtkSmartPointer<vtkCellArray>::New();
  polys->SetData(offsets, connectivity);
  return polys;
}

} // namespace

vtkSmartPointer<vtkDoubleArray> GetDoublePoints(vtkPolyData* scene)
{
  vtkDataArray* points = scene->GetPoints()->GetData();
  if (auto* doubles = vtkDoubleArray::FastDownCast(points))
  {
    return doubles;
  }
  auto copy = vtkSmartPointer<vtkDoubleArray>::New();
  copy->DeepCopy(points);
  return copy;
}

Status FindShortArray(vtkPolyData* scene)
{
  const Status text = FindShortArray(scene->GetCellData(), scene->GetNumberOfCells(), "cell");
  return text.IsOk() ? FindShortArray(scene->GetPointData(), scene->GetNumberOfPoints(), "point")
                     : text;
}

vtkIdType ExtractTriangles(vtkPolyData* input, const std::vector<vtkIdType>& cells,
  const std::vector<vtkTypeInt32>& corners, vtkPolyData* output)
{
  std::vector<vtkTypeInt32> newIds(static_cast<std::size_t>(input->GetNumberOfPoints()), -1);
  for (const vtkTypeInt32 corner : corners)
  {
    newIds[corner] = 0;
  }
  std::vector<vtkIdType> used;
  for (std::size_t i = 0; i < newIds.size(); ++i)
  {
    if (newIds[i] == 0)
    {
      newIds[i] = static_cast<vtkTypeInt32>(used.size());
      used.push_back(static_cast<vtkIdType>(i));
    }
  }

  output->ShallowCopy(input);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(GetDoublePoints(input));
  if (used.size() < newIds.size())
  {
    points->SetData(CopyPoints(GetDoublePoints(input), used));
    CopyRows(input->GetPointData(), used, output->GetPointData());
  }
  output->SetPoints(points);
  if (static_cast<vtkIdType>(cells.size()) < input->GetNumberOfCells())
  {
    CopyRows(input->GetCellData(), cells, output->GetCellData());
  }
  output->SetPolys(MakePolys(corners, newIds));
  return static_cast<vtkIdType>(used.size());
}

} // namespace helios
