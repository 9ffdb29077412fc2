// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWaveformTable.h"

#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// Gets a numeric array.
Status ReadArray(
  vtkFieldData* data, const char* name, vtkIdType rows, int components, Column& column)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array)
  {
    return Status::Error(std::string("has no array ") + name);
  }
  if (array->GetNumberOfTuples() != rows || array->GetNumberOfComponents() != components)
  {
    return Status::Error(std::string("has an array ") + name + " of " +
      std::to_string(array->GetNumberOfTuples()) + " x " +
      std::to_string(array->GetNumberOfComponents()) + " values, not " + std::to_string(rows) +
      " x " + std::to_string(components));
  }
  column = Column(array);
  return {};
}

Status ReadIntegers(vtkFieldData* data, const char* name, vtkIdType rows, Column& column)
{
  Status status = ReadArray(data, name, rows, 1, column);
  if (status.IsOk() && !column.HasIntegers())
  {
    status = Status::Error(std::string("has an array ") + name + " of " +
      data->GetArray(name)->GetDataTypeAsString() + "; it must hold integers");
  }
  return status;
}

/// Returns the index of the first non-finite value, or -1; always -1 for integer types.
template <typename ArrayT>
vtkIdType FindNotFinite(vtkDataArray* data)
{
  auto* array = ArrayT::FastDownCast(data);
  if (!array)
  {
    return -1;
  }
  const auto* first = array->GetPointer(0);
  const auto* last = first + array->GetNumberOfValues();
  const auto* found = std::find_if(first, last, [](auto value) { return !std::isfinite(value); });
  return found == last ? -1 : found - first;
}

Status CheckFinite(vtkDataArray* array)
{
  const vtkIdType value = array
    ? std::max(FindNotFinite<vtkFloatArray>(array), FindNotFinite<vtkDoubleArray>(array))
    : -1;
  return value < 0
    ? Status()
    : Status::Error("has an array " + std::string(array->GetName() ? array->GetName() : "") +
        " whose value " + std::to_string(value) + " is not finite");
}

} // namespace

Status WaveformTable::Set(vtkTable* table)
{
  vtkFieldData* data = table->GetRowData();
  const vtkIdType rows = this->NumberOfRows = table->GetNumberOfRows();
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  this->NumberOfSamples = samples ? samples->GetNumberOfTuples() : 0;
  if (rows == 0)
  {
    return {};
  }
  const Status columns[] = {
    ReadIntegers(data, names::PulseIds, rows, this->PulseIds),
    ReadArray(data, names::Origin, rows, 3, this->Origin),
    ReadArray(data, names::Direction, rows, 3, this->Direction),
    ReadArray(data, names::GpsTime, rows, 1, this->GpsTime),
    ReadArray(data, names::StartTime, rows, 1, this->StartTime),
    ReadArray(data, names::BinSize, rows, 1, this->BinSize),
    ReadIntegers(data, names::Offset, rows, this->Offset),
    ReadIntegers(data, names::Count, rows, this->Count),
    ReadArray(table->GetFieldData(), names::Samples, this->NumberOfSamples, 1, this->Samples),
  };
  for (const Status& status : columns)
  {
    if (!status.IsOk())
    {
      return status;
    }
  }
  return this->CheckSamples();
}

Status WaveformTable::CheckSamples() const
{
  for (vtkIdType row = 0; row < this->NumberOfRows; ++row)
  {
    const vtkIdType first = this->Offset.GetInteger(row);
    const vtkIdType count = this->Count.GetInteger(row);
    if (first < 0 || first >= this->NumberOfSamples || count < 1 ||
      count > this->NumberOfSamples - first)
    {
      return Status::Error("has a row " + std::to_string(row) + " with Offset " +
        std::to_string(first) + " and Count " + std::to_string(count) + ", not within its " +
        std::to_string(this->NumberOfSamples) + " Samples");
    }
  }
  return {};
}

/// Checks the numbers of a row.
Status WaveformTable::CheckNumbers(vtkIdType row) const
{
  const auto fail = [row](const char* name, const char* fault)
  { return Status::Error(std::string(name) + " of row " + std::to_string(row) + fault); };
  const double binSize = this->BinSize.GetNumber(row);
  if (!(binSize > 0.0) || !std::isfinite(binSize))
  {
    return fail(names::BinSize, " is not a positive number of ns");
  }
  const std::pair<const char*, const Column*> scalars[] = { { names::StartTime, &this->StartTime },
    { names::GpsTime, &this->GpsTime } };
  for (const auto& [name, column] : scalars)
  {
    if (!std::isfinite(column->GetNumber(row)))
    {
      return fail(name, " is not a finite number");
    }
  }
  const std::pair<const char*, const Column*> vectors[] = { { names::Origin, &this->Origin },
    { names::Direction, &this->Direction } };
  double length = 0.0;
  for (const auto& [name, column] : vectors)
  {
    length =
      std::hypot(column->GetNumber(row, 0), column->GetNumber(row, 1), column->GetNumber(row, 2));
    if (!std::isfinite(length))
    {
      return fail(name, " is not a finite vector");
    }
  }
  if (!(std::abs(length - 1.0) < 1e-3))
  {
    return fail(names::Direction, " is not a unit vector");
  }
  const vtkIdType first = this->Offset.GetInteger(row);
  const vtkIdType last = first + this->Count.GetInteger(row);
  for (vtkIdType i = first; i < last; ++i)
  {
    if (!std::isfinite(this->Samples.GetNumber(i)))
    {
      return fail(names::Samples, " are not all finite");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status WaveformTable::CheckNumbers() const
{
  Status status;
  for (vtkIdType row = 0; status.IsOk() && row < this->NumberOfRows; ++row)
  {
    status = this->CheckNumbers(row);
  }
  return status.IsOk() ? status : Status::Error("is not valid: " + status.Message());
}

//------------------------------------------------------------------------------
/// Returns an error about the first bin size that is 0 or less.
Status CheckBinSizes(vtkDataArray* sizes)
{
  for (vtkIdType row = 0; sizes && row < sizes->GetNumberOfTuples(); ++row)
  {
    if (!(sizes->GetComponent(row, 0) > 0.0))
    {
      return Status::Error(std::string("has a row ") + std::to_string(row) + " whose " +
        names::BinSize + " is not above 0 ns");
    }
  }
  return {};
}

Status CheckValues(vtkTable* table)
{
  // other field data may have NaN for unknown values
  Status status = CheckFinite(table->GetFieldData()->GetArray(names::Samples));
  vtkFieldData* columns = table->GetRowData();
  for (int i = 0; status.IsOk() && i < columns->GetNumberOfArrays(); ++i)
  {
    status = CheckFinite(columns->GetArray(i));
  }
  return status.IsOk() ? CheckBinSizes(columns->GetArray(names::BinSize)) : status;
}

} // namespace helios
