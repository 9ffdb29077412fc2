// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosWaveformTable.h"

#include "vtkHeliosArrayNames.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

/// Gets a numeric array. Returns an error message, or an empty string.
std::string ReadArray(
  vtkFieldData* data, const char* name, vtkIdType rows, int components, Column& column)
{
  vtkDataArray* array = data->GetArray(name);
  if (!array)
  {
    return std::string("has no array ") + name;
  }
  if (array->GetNumberOfTuples() != rows || array->GetNumberOfComponents() != components)
  {
    return std::string("has an array ") + name + " of " +
      std::to_string(array->GetNumberOfTuples()) + " x " +
      std::to_string(array->GetNumberOfComponents()) + " values, not " + std::to_string(rows) +
      " x " + std::to_string(components);
  }
  column = Column(array);
  return {};
}

std::string ReadIntegers(vtkFieldData* data, const char* name, vtkIdType rows, Column& column)
{
  std::string problem = ReadArray(data, name, rows, 1, column);
  if (problem.empty() && !column.HasIntegers())
  {
    problem = std::string("has an array ") + name + " of " +
      data->GetArray(name)->GetDataTypeAsString() + "; it must hold integers";
  }
  return problem;
}

/// Index of the first non-finite value, or -1; always -1 for integer types.
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

std::string CheckFinite(vtkDataArray* array)
{
  const vtkIdType value = array
    ? std::max(FindNotFinite<vtkFloatArray>(array), FindNotFinite<vtkDoubleArray>(array))
    : -1;
  return value < 0 ? std::string()
                   : "has an array " + std::string(array->GetName() ? array->GetName() : "") +
      " whose value " + std::to_string(value) + " is not finite";
}

} // namespace

std::string WaveformTable::Set(vtkTable* table)
{
  vtkFieldData* data = table->GetRowData();
  const vtkIdType rows = this->NumberOfRows = table->GetNumberOfRows();
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  this->NumberOfSamples = samples ? samples->GetNumberOfTuples() : 0;
  if (rows == 0)
  {
    return {};
  }
  const std::string problems[] = {
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
  for (const std::string& problem : problems)
  {
    if (!problem.empty())
    {
      return problem;
    }
  }
  return this->CheckSamples();
}

std::string WaveformTable::CheckSamples() const
{
  for (vtkIdType row = 0; row < this->NumberOfRows; ++row)
  {
    const vtkIdType first = this->Offset.GetInteger(row);
    const vtkIdType count = this->Count.GetInteger(row);
    if (first < 0 || first >= this->NumberOfSamples || count < 1 ||
      count > this->NumberOfSamples - first)
    {
      return "has a row " + std::to_string(row) + " with Offset " + std::to_string(first) +
        " and Count " + std::to_string(count) + ", not within its " +
        std::to_string(this->NumberOfSamples) + " Samples";
    }
  }
  return {};
}

/// Reports the first bin size that is 0 or less; empty: none.
std::string CheckBinSizes(vtkDataArray* sizes)
{
  for (vtkIdType row = 0; sizes && row < sizes->GetNumberOfTuples(); ++row)
  {
    if (!(sizes->GetComponent(row, 0) > 0.0))
    {
      return std::string("has a row ") + std::to_string(row) + " whose " + names::BinSize +
        " is not above 0 ns";
    }
  }
  return {};
}

std::string CheckValues(vtkTable* table)
{
  // other field data may have NaN for unknown values
  std::string problem = CheckFinite(table->GetFieldData()->GetArray(names::Samples));
  vtkFieldData* columns = table->GetRowData();
  for (int i = 0; problem.empty() && i < columns->GetNumberOfArrays(); ++i)
  {
    problem = CheckFinite(columns->GetArray(i));
  }
  return problem.empty() ? CheckBinSizes(columns->GetArray(names::BinSize)) : problem;
}

} // namespace helios
