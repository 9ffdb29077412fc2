// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosVisibility.h"

#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <sstream>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

bool HasWords(vtkDataArray* array)
{
  return array->GetDataTypeSize() == 8 && array->HasStandardMemoryLayout() &&
    (array->GetDataType() == VTK_UNSIGNED_LONG || array->GetDataType() == VTK_UNSIGNED_LONG_LONG);
}

} // namespace

Status Visibility::Set(vtkPolyData* candidates, vtkIdType testPoints)
{
  vtkDataArray* array = candidates->GetPointData()->GetArray(names::Visibility);
  const vtkIdType length = GetRowLength(testPoints);
  if (!array)
  {
    return Status::Error(std::string("the candidates have no point array ") + names::Visibility +
      "; use those of vtkHeliosViewsheds, or add it");
  }
  std::ostringstream text;
  if (!HasWords(array) || array->GetNumberOfComponents() != length)
  {
    text << names::Visibility << " of the candidates has " << array->GetNumberOfComponents()
         << " components of type " << array->GetDataTypeAsString() << "; " << testPoints
         << " test points need " << length << " of unsigned 64-bit integers";
    return Status::Error(text.str());
  }
  this->Words = static_cast<const std::uint64_t*>(array->GetVoidPointer(0));
  this->NumberOfCandidates = candidates->GetNumberOfPoints();
  this->NumberOfTestPoints = testPoints;
  this->RowLength = length;
  const int used = static_cast<int>(testPoints % 64);
  for (vtkIdType c = 0; c < this->NumberOfCandidates && used > 0; ++c)
  {
    if (this->GetRow(c)[length - 1] >> used)
    {
      text << names::Visibility << " of candidate " << c << " has bits beyond the last of "
           << testPoints << " test points; clear them";
      return Status::Error(text.str());
    }
  }
  return {};
}

vtkIdType Visibility::GetSize(vtkIdType candidate) const
{
  const std::uint64_t* row = this->GetRow(candidate);
  vtkIdType size = 0;
  for (vtkIdType w = 0; w < this->RowLength; ++w)
  {
    size += __builtin_popcountll(row[w]);
  }
  return size;
}

} // namespace helios
