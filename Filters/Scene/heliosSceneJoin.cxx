// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSceneJoin.h"

#include "heliosZeroIds.h"
#include "vtkHeliosArrayNames.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <map>
#include <string>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

template <typename ArrayT>
vtkTypeInt32* CopyCorners(ArrayT* from, vtkIdType firstPoint, vtkTypeInt32* to)
{
  const auto* corners = from->GetPointer(0);
  const vtkIdType count = from->GetNumberOfValues();
  return std::transform(corners, corners + count, to,
    [firstPoint](auto id) { return static_cast<vtkTypeInt32>(id + firstPoint); });
}

/// Returns a cell array of a part's triangles; null if it has none.
vtkDataArray* FindCellArray(vtkPolyData* part, const char* name, int components)
{
  vtkDataArray* array = part ? part->GetCellData()->GetArray(name) : nullptr;
  const bool isReal =
    array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
  const bool fits = isReal && array->GetNumberOfComponents() == components &&
    array->GetNumberOfTuples() == part->GetNumberOfPolys();
  return fits ? array : nullptr;
}

/// Sets the ids of the triangles of one mesh, from a place on, and adds the names of its objects.
void SplitPart(vtkPolyData* mesh, vtkIntArray* ids, vtkIdType first, vtkStringArray* all)
{
  auto* own = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetArray(names::PartIds));
  auto* given =
    vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray(names::PartName));
  if (!own || !given)
  {
    return;
  }
  std::map<int, int> numbers; // number in the scene of each object with triangles
  for (vtkIdType i = 0; i < own->GetNumberOfValues(); ++i)
  {
    numbers[own->GetValue(i)] = 0;
  }
  for (auto& [object, number] : numbers)
  {
    const bool isNamed = object >= 0 && object < given->GetNumberOfValues();
    number = static_cast<int>(
      all->InsertNextValue(isNamed ? given->GetValue(object) : std::to_string(object)));
  }
  const vtkIdType count = std::min(own->GetNumberOfValues(), mesh->GetNumberOfPolys());
  for (vtkIdType i = 0; i < count; ++i)
  {
    ids->SetValue(first + i, numbers.at(own->GetValue(i)));
  }
}

} // namespace

//------------------------------------------------------------------------------
vtkIdType CountPoints(const PartList& parts)
{
  vtkIdType count = 0;
  for (vtkPolyData* part : parts)
  {
    count += part ? part->GetNumberOfPoints() : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
vtkIdType CountTriangles(const PartList& parts)
{
  vtkIdType count = 0;
  for (vtkPolyData* part : parts)
  {
    count += part ? part->GetNumberOfPolys() : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
vtkPolyData* GetSinglePart(const PartList& parts)
{
  const auto isPart = [](vtkPolyData* part) { return part != nullptr; };
  return std::count_if(parts.begin(), parts.end(), isPart) == 1
    ? *std::find_if(parts.begin(), parts.end(), isPart)
    : nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPoints> JoinPoints(const PartList& parts)
{
  vtkPolyData* single = GetSinglePart(parts);
  if (single && single->GetPoints()->GetDataType() == VTK_DOUBLE)
  {
    return single->GetPoints();
  }
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(CountPoints(parts));
  vtkIdType first = 0;
  for (vtkPolyData* part : parts)
  {
    if (part)
    {
      points->InsertPoints(first, part->GetNumberOfPoints(), 0, part->GetPoints());
      first += part->GetNumberOfPoints();
    }
  }
  return points;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> JoinCells(const PartList& parts)
{
  vtkPolyData* single = GetSinglePart(parts);
  if (single && !single->GetPolys()->IsStorage64Bit())
  {
    return single->GetPolys();
  }
  const vtkIdType count = CountTriangles(parts);
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i)
  {
    offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
  }
  vtkNew<vtkTypeInt32Array> corners;
  corners->SetNumberOfValues(3 * count);
  vtkTypeInt32* to = corners->GetPointer(0);
  vtkIdType firstPoint = 0;
  for (vtkPolyData* part : parts)
  {
    if (part)
    {
      vtkCellArray* polys = part->GetPolys();
      to = polys->IsStorage64Bit() ? CopyCorners(polys->GetConnectivityArray64(), firstPoint, to)
                                   : CopyCorners(polys->GetConnectivityArray32(), firstPoint, to);
      firstPoint += part->GetNumberOfPoints();
    }
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, corners);
  return cells;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkIntArray> MakePartIds(const PartList& parts)
{
  vtkSmartPointer<vtkIntArray> ids = MakeZeroIds(names::PartIds, CountTriangles(parts));
  int* to = ids->GetPointer(0);
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    const vtkIdType count = parts[i] ? parts[i]->GetNumberOfPolys() : 0;
    to = i > 0 ? std::fill_n(to, count, static_cast<int>(i)) : to + count;
  }
  return ids;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkFloatArray> JoinCellArrays(
  const PartList& parts, const char* name, int components, float otherwise)
{
  const auto find = [name, components](vtkPolyData* part)
  { return FindCellArray(part, name, components); };
  if (std::none_of(parts.begin(), parts.end(), find))
  {
    return nullptr;
  }
  auto joined = vtkSmartPointer<vtkFloatArray>::New();
  joined->SetName(name);
  joined->SetNumberOfComponents(components);
  joined->SetNumberOfTuples(CountTriangles(parts));
  joined->Fill(otherwise);
  vtkIdType first = 0;
  for (vtkPolyData* part : parts)
  {
    if (vtkDataArray* from = find(part))
    {
      joined->InsertTuples(first, part->GetNumberOfPolys(), 0, from);
    }
    first += part ? part->GetNumberOfPolys() : 0;
  }
  return joined;
}

//------------------------------------------------------------------------------
void SplitParts(const PartList& parts, const std::vector<bool>& areSplit, vtkPolyData* scene)
{
  auto* ids = vtkIntArray::SafeDownCast(scene->GetCellData()->GetArray(names::PartIds));
  auto* given =
    vtkStringArray::SafeDownCast(scene->GetFieldData()->GetAbstractArray(names::PartName));
  if (!ids || !given)
  {
    return;
  }
  vtkIdType first = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (parts[i] && i < areSplit.size() && areSplit[i])
    {
      SplitPart(parts[i], ids, first, given);
    }
    first += parts[i] ? parts[i]->GetNumberOfPolys() : 0;
  }
}

} // namespace helios
