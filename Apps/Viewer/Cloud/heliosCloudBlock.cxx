// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCloudBlock.h"

#include "heliosCloudCodes.h"
#include "vtkHeliosArrayNames.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <utility>

namespace names = vtkHeliosArrayNames;

namespace helios::viewer
{

namespace
{

/// Reads array values as doubles, tuple by tuple.
struct CopyWorker
{
  template <typename Array>
  void operator()(Array* array, vtkIdType first, std::vector<double>& values) const
  {
    const auto end = first + static_cast<vtkIdType>(values.size());
    std::size_t i = 0;
    for (const auto value : vtk::DataArrayValueRange(array, first, end))
    {
      values[i++] = static_cast<double>(value);
    }
  }
};

/// Returns the values of the tuples [begin, end).
std::vector<double> ToDoubles(vtkDataArray* array, vtkIdType begin, vtkIdType end)
{
  const vtkIdType width = array->GetNumberOfComponents();
  std::vector<double> values(static_cast<std::size_t>((end - begin) * width));
  CopyWorker worker;
  if (!vtkArrayDispatch::Dispatch::Execute(array, worker, begin * width, values))
  {
    worker(array, begin * width, values);
  }
  return values;
}

} // namespace

//------------------------------------------------------------------------------
CloudBlock::CloudBlock(vtkPolyData* echoes, vtkIdType begin, vtkIdType end)
  : Begin(begin)
  , End(end)
  , Xyz(ToDoubles(echoes->GetPoints()->GetData(), begin, end))
{
  vtkPointData* data = echoes->GetPointData();
  const std::pair<CloudColumn, const char*> columns[] = {
    { CloudColumn::Amplitude, names::Amplitude },
    { CloudColumn::ReturnNumber, names::ReturnNumber },
    { CloudColumn::NumberOfReturns, names::NumberOfReturns },
    { CloudColumn::Class, names::ClassificationIds },
    { CloudColumn::Time, names::GpsTime },
    { CloudColumn::Part, names::PartIds },
    { CloudColumn::Material, names::MaterialIds },
    { CloudColumn::Leg, names::LegIds },
    { CloudColumn::Incidence, names::IncidenceAngle },
    { CloudColumn::Range, names::Range },
    { CloudColumn::Pulse, names::PulseIds },
  };
  for (const auto& column : columns)
  {
    this->Read(column.first, data->GetArray(column.second), echoes->GetNumberOfPoints());
  }
  this->ReadColors(data->GetArray(names::RGB), echoes->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
/// Packs red, green and blue: real numbers in [0, 1], or whole ones of the range of their type.
void CloudBlock::ReadColors(vtkDataArray* array, vtkIdType rows)
{
  if (!array || array->GetNumberOfComponents() != 3 || array->GetNumberOfTuples() != rows)
  {
    return;
  }
  const bool isReal = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  const double scale = isReal ? 1.0 : 1.0 / array->GetDataTypeMax();
  std::vector<double> shares = ToDoubles(array, this->Begin, this->End);
  std::transform(
    shares.begin(), shares.end(), shares.begin(), [scale](double x) { return scale * x; });
  std::vector<double>& packed = this->Columns[static_cast<int>(CloudColumn::Color)];
  for (std::size_t i = 0; i < shares.size(); i += 3)
  {
    packed.push_back(PackColor(shares.data() + i));
  }
}

//------------------------------------------------------------------------------
void CloudBlock::Read(CloudColumn column, vtkDataArray* array, vtkIdType rows)
{
  if (array && array->GetNumberOfComponents() == 1 && array->GetNumberOfTuples() == rows)
  {
    this->Columns[static_cast<int>(column)] = ToDoubles(array, this->Begin, this->End);
  }
}

} // namespace helios::viewer
