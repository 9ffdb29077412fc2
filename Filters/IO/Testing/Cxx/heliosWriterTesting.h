// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks for the tests of writers.

#ifndef heliosWriterTesting_h
#define heliosWriterTesting_h

#include "heliosErrorObserver.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <string>

namespace helios
{

inline vtkSmartPointer<ErrorObserver> WatchErrors(vtkObject* object)
{
  auto log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
  log->Watch(object);
  return log;
}

/// Adds or replaces a column whose values are value(row).
template <typename ArrayT, typename ValueT>
void AddColumn(vtkFieldData* data, const char* name, vtkIdType count, ValueT value)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->SetValue(i, static_cast<typename ArrayT::ValueType>(value(i)));
  }
  data->AddArray(array);
}

/// Echoes with values derived from their row.
inline vtkSmartPointer<vtkPolyData> MakeEchoes(vtkIdType count)
{
  namespace names = vtkHeliosArrayNames;
  auto echoes = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto x = static_cast<double>(i);
    points->SetPoint(i, 500000 + 0.25 * x, 5500000.654321 - x, -1e-5 * x);
  }
  echoes->SetPoints(points);
  vtkPointData* data = echoes->GetPointData();
  const auto wave = [](vtkIdType i) { return 1.0001 + std::sin(static_cast<double>(i)); };
  AddColumn<vtkDoubleArray>(data, names::GpsTime, count,
    [](vtkIdType i) { return 604799.5 + 1e-5 * static_cast<double>(i); });
  AddColumn<vtkTypeInt64Array>(
    data, names::PulseIds, count, [](vtkIdType i) { return 5000000000 + i; });
  AddColumn<vtkUnsignedCharArray>(
    data, names::ReturnNumber, count, [](vtkIdType i) { return 1 + i % 7; });
  AddColumn<vtkUnsignedCharArray>(
    data, names::NumberOfReturns, count, [](vtkIdType) { return 200; });
  AddColumn<vtkDoubleArray>(
    data, names::Amplitude, count, [wave](vtkIdType i) { return 1e-7 * wave(i); });
  AddColumn<vtkDoubleArray>(
    data, names::EchoWidth, count, [wave](vtkIdType i) { return 4.0625 * wave(i); });
  AddColumn<vtkIntArray>(data, names::PartIds, count, [](vtkIdType i) { return i % 3; });
  AddColumn<vtkIntArray>(
    data, names::ClassificationIds, count, [](vtkIdType i) { return i % 2 == 0 ? 6 : -2; });
  return echoes;
}

/// The maximum rounding error of a number of a magnitude with this many decimals.
inline double RoundingOf(int decimals, double magnitude)
{
  return 0.5 * std::pow(10.0, -decimals) + std::ldexp(std::abs(magnitude), -52);
}

} // namespace helios

#endif
