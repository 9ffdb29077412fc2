// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosObjectParts.h"

#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <map>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

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
  std::map<int, int> numbers; // of objects with triangles, in the scene
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
