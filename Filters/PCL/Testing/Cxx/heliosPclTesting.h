// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Clouds and a filter runner for the tests of PCL filters.

#ifndef heliosPclTesting_h
#define heliosPclTesting_h

#include "heliosErrorObserver.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPCLArrayNames.h"

#include <vtkAlgorithm.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace helios
{

/// In this namespace, for lookup of its operator+.
struct Triple : std::array<double, 3>
{
};
using Triples = std::vector<Triple>;

// A position in UTM, with decimals beyond float precision.
constexpr Triple Utm = { 476123.4567, 5473987.6543, 312.3456 };

inline Triple operator+(const Triple& a, const Triple& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

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

/// A cloud of points with their ids as PulseIds, for identification.
inline vtkSmartPointer<vtkPolyData> MakeCloud(const Triples& triples)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  const auto count = static_cast<vtkIdType>(triples.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(i, triples[static_cast<std::size_t>(i)].data());
  }
  cloud->SetPoints(points);
  AddColumn<vtkTypeInt64Array>(
    cloud->GetPointData(), vtkHeliosArrayNames::PulseIds, count, [](vtkIdType i) { return i; });
  AddColumn<vtkDoubleArray>(
    cloud->GetFieldData(), vtkHeliosArrayNames::GpsEpoch, 1, [](vtkIdType) { return 1e9; });
  return cloud;
}

/// Random numbers that are the same on all platforms, with any library.
class Uniform
{
public:
  explicit Uniform(unsigned seed)
    : Generator(seed)
  {
  }
  double operator()(double low, double high)
  {
    return low + (high - low) * (static_cast<double>(this->Generator()) + 0.5) / 4294967296.0;
  }
  /// Returns a normal number with mean 0 and standard deviation 1.
  double Normal()
  {
    return std::sqrt(-2.0 * std::log((*this)(0.0, 1.0))) * std::cos((*this)(0.0, 2.0 * M_PI));
  }

private:
  std::mt19937 Generator;
};

/// A filter with recorded messages.
template <typename FilterT>
struct Filtering
{
  vtkNew<FilterT> Filter;
  vtkSmartPointer<ErrorObserver> Log = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());
  vtkSmartPointer<ErrorObserver> Quiet = vtkSmartPointer<ErrorObserver>::Take(ErrorObserver::New());

  explicit Filtering(vtkPolyData* input)
  {
    this->Filter->SetInputDataObject(0, input);
    this->Log->Watch(this->Filter);
    this->Quiet->Watch(this->Filter->GetExecutive());
  }
  explicit Filtering(const Triples& triples)
    : Filtering(MakeCloud(triples))
  {
  }

  /// True if there was no error.
  bool Run()
  {
    this->Log->Clear();
    this->Filter->Modified();
    this->Filter->Update();
    return this->Log->Errors.empty();
  }
  bool FailsWith(const std::string& part)
  {
    return !this->Run() && this->Log->HasError(part) && this->Count() == 0;
  }

  vtkPolyData* Output() { return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(0)); }
  vtkIdType Count() { return this->Output()->GetNumberOfPoints(); }
  vtkDataArray* Get(const char* name) { return this->Output()->GetPointData()->GetArray(name); }
  vtkDataArray* GetField(const char* name)
  {
    return this->Output()->GetFieldData()->GetArray(name);
  }
  /// The input id of an output point.
  vtkIdType GetId(vtkIdType point)
  {
    return static_cast<vtkIdType>(this->Get(vtkHeliosArrayNames::PulseIds)->GetTuple1(point));
  }

  /// The number of output points that are not input points, bit by bit.
  vtkIdType CountMoved()
  {
    auto* input = vtkPolyData::SafeDownCast(this->Filter->GetInputDataObject(0, 0));
    vtkIdType moved = 0;
    for (vtkIdType i = 0; i < this->Count(); ++i)
    {
      Triple p;
      Triple q;
      this->Output()->GetPoint(i, p.data());
      input->GetPoint(this->GetId(i), q.data());
      moved += p == q ? 0 : 1;
    }
    return moved;
  }
};

} // namespace helios

#endif
