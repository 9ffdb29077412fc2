// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPartMaterials.h"

#include "vtkHeliosArrayNames.h"

#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace names = vtkHeliosArrayNames;

namespace helios
{

//------------------------------------------------------------------------------
std::vector<int> MergeMaterials(const MaterialTable& materials, MaterialTable& table)
{
  std::vector<int> rows;
  for (const Material& material : materials)
  {
    const auto known = std::find(table.begin(), table.end(), material);
    rows.push_back(static_cast<int>(known - table.begin()));
    if (known == table.end())
    {
      table.push_back(material);
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
vtkIdType MapMaterialIds(vtkPolyData* part, const std::vector<int>& rows, int* to)
{
  vtkDataArray* ids = part->GetCellData()->GetArray(names::MaterialIds);
  auto* ints = vtkIntArray::FastDownCast(ids);
  if (ids && ids->GetNumberOfTuples() < part->GetNumberOfPolys())
  {
    return ids->GetNumberOfTuples();
  }
  for (vtkIdType i = 0; i < part->GetNumberOfPolys(); ++i)
  {
    const double id = ints ? ints->GetValue(i) : ids ? ids->GetComponent(i, 0) : 0.0;
    if (!(id >= 0.0 && id < static_cast<double>(rows.size())))
    {
      return i;
    }
    to[i] = rows[static_cast<std::size_t>(id)];
  }
  return -1;
}

//------------------------------------------------------------------------------
vtkIntArray* GetSingleMaterialIds(const PartList& parts)
{
  vtkPolyData* single = GetSinglePart(parts);
  auto* ids = vtkIntArray::SafeDownCast(
    single ? single->GetCellData()->GetArray(names::MaterialIds) : nullptr);
  MaterialTable table;
  if (!ids || ids->GetNumberOfTuples() != single->GetNumberOfPolys())
  {
    return nullptr;
  }
  const std::size_t rows = MergeMaterials(GetMaterials(single), table).size();
  const int* range = ids->GetValueRange();
  const bool isRight = table.size() == rows && range[0] >= 0 && range[1] < static_cast<int>(rows);
  return isRight ? ids : nullptr;
}

} // namespace helios
