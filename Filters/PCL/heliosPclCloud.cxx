// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPclCloud.h"

#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPCLArrayNames.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVariant.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <type_traits>

namespace names = vtkHeliosArrayNames;

namespace helios
{

namespace
{

/// Reads arrays of echoes and records the first invalid one.
class EchoArrays
{
public:
  explicit EchoArrays(vtkPolyData* echoes)
    : Echoes(echoes)
  {
  }

  /// Returns the first array present, or null.
  vtkDataArray* Get(std::initializer_list<const char*> wanted, int components = 1)
  {
    for (const char* name : wanted)
    {
      vtkAbstractArray* any = this->Echoes->GetPointData()->GetAbstractArray(name);
      if (any)
      {
        auto* array = vtkDataArray::SafeDownCast(any);
        return this->Check(any, name, components) ? array : nullptr;
      }
    }
    return nullptr;
  }

  std::string Problem;

private:
  bool Check(vtkAbstractArray* array, const char* name, int components)
  {
    const vtkIdType count = this->Echoes->GetNumberOfPoints();
    if (vtkDataArray::SafeDownCast(array) && array->GetNumberOfComponents() == components &&
      array->GetNumberOfTuples() == count)
    {
      return true;
    }
    this->Problem = std::string("the point array ") + name + " holds " +
      std::to_string(array->GetNumberOfTuples()) + " x " +
      std::to_string(array->GetNumberOfComponents()) + " values (" + array->GetDataTypeAsString() +
      "), not " + std::to_string(count) + " x " + std::to_string(components) +
      " numbers; give it that shape, or remove it";
    return false;
  }

  vtkPolyData* Echoes;
};

/// Calls set(point, value) with the array value of every point.
template <typename PointT, typename SetT>
void Fill(pcl::PointCloud<PointT>& cloud, vtkDataArray* array, const SetT& set)
{
  for (std::size_t i = 0; array && i < cloud.size(); ++i)
  {
    set(cloud[i], array->GetComponent(static_cast<vtkIdType>(i), 0));
  }
}

template <typename PointT>
void FillPoints(vtkPolyData* echoes, const double origin[3], pcl::PointCloud<PointT>& cloud)
{
  cloud.is_dense = true;
  double p[3];
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    echoes->GetPoint(static_cast<vtkIdType>(i), p);
    cloud[i].x = static_cast<float>(p[0] - origin[0]);
    cloud[i].y = static_cast<float>(p[1] - origin[1]);
    cloud[i].z = static_cast<float>(p[2] - origin[2]);
    cloud.is_dense = cloud.is_dense && std::isfinite(p[0] + p[1] + p[2]);
  }
}

/// Rounds to an integer, within the range of its type; NaN is 0.
template <typename T>
T ToWhole(double value)
{
  using Limits = std::numeric_limits<T>;
  return value >= static_cast<double>(Limits::max()) ? Limits::max()
    : value <= static_cast<double>(Limits::min())    ? Limits::min()
    : value == value                                 ? static_cast<T>(value)
                                                     : T(0);
}

void FillAttributes(EchoArrays&, pcl::PointCloud<pcl::PointXYZ>&) {}

template <typename PointT>
void FillIntensity(EchoArrays& arrays, pcl::PointCloud<PointT>& cloud)
{
  Fill(cloud, arrays.Get({ names::Amplitude, names::Intensity }),
    [](PointT& point, double value) { point.intensity = static_cast<float>(value); });
}

void FillAttributes(EchoArrays& arrays, pcl::PointCloud<pcl::PointXYZI>& cloud)
{
  FillIntensity(arrays, cloud);
}

void FillAttributes(EchoArrays& arrays, pcl::PointCloud<pcl::PointXYZINormal>& cloud)
{
  FillIntensity(arrays, cloud);
  Fill(cloud, arrays.Get({ vtkHeliosPCLArrayNames::Curvature }),
    [](pcl::PointXYZINormal& p, double value) { p.curvature = static_cast<float>(value); });
  vtkDataArray* normals = arrays.Get({ names::Normals, names::Normal }, 3);
  for (std::size_t i = 0; normals && i < cloud.size(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      cloud[i].normal[axis] =
        static_cast<float>(normals->GetComponent(static_cast<vtkIdType>(i), axis));
    }
  }
}

void FillAttributes(EchoArrays& arrays, pcl::PointCloud<PointEcho>& cloud)
{
  FillIntensity(arrays, cloud);
  Fill(cloud, arrays.Get({ names::EchoWidth }),
    [](PointEcho& p, double value) { p.width = static_cast<float>(value); });
  Fill(
    cloud, arrays.Get({ names::GpsTime }), [](PointEcho& p, double value) { p.gps_time = value; });
  Fill(cloud, arrays.Get({ names::ClassificationIds }),
    [](PointEcho& p, double value)
    { p.classification = static_cast<std::uint32_t>(ToWhole<std::int32_t>(value)); });
  Fill(cloud, arrays.Get({ names::ReturnNumber }),
    [](PointEcho& p, double value) { p.return_number = ToWhole<std::uint8_t>(value); });
  Fill(cloud, arrays.Get({ names::NumberOfReturns }),
    [](PointEcho& p, double value) { p.number_of_returns = ToWhole<std::uint8_t>(value); });
  vtkDataArray* pulses = arrays.Get({ names::PulseIds }); // all 64 bits
  for (std::size_t i = 0; pulses && i < cloud.size(); ++i)
  {
    cloud[i].pulse_id = pulses->GetVariantValue(static_cast<vtkIdType>(i)).ToTypeInt64();
  }
}

/// Adds an array of value(point).
template <typename ArrayT, typename PointT, typename ValueT>
void AddArray(
  const pcl::PointCloud<PointT>& cloud, vtkPolyData* echoes, const char* name, const ValueT& value)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(cloud.size()));
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), value(cloud[i]));
  }
  echoes->GetPointData()->AddArray(array);
}

void AddAttributes(const pcl::PointCloud<pcl::PointXYZ>&, vtkPolyData*) {}

template <typename PointT>
void AddIntensity(const pcl::PointCloud<PointT>& cloud, vtkPolyData* echoes)
{
  AddArray<vtkFloatArray>(
    cloud, echoes, names::Amplitude, [](const PointT& point) { return point.intensity; });
}

void AddAttributes(const pcl::PointCloud<pcl::PointXYZI>& cloud, vtkPolyData* echoes)
{
  AddIntensity(cloud, echoes);
}

void AddAttributes(const pcl::PointCloud<pcl::PointXYZINormal>& cloud, vtkPolyData* echoes)
{
  AddIntensity(cloud, echoes);
  AddArray<vtkFloatArray>(cloud, echoes, vtkHeliosPCLArrayNames::Curvature,
    [](const pcl::PointXYZINormal& p) { return p.curvature; });
  vtkNew<vtkFloatArray> normals;
  normals->SetName(names::Normals);
  normals->SetNumberOfComponents(3);
  normals->SetNumberOfTuples(static_cast<vtkIdType>(cloud.size()));
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    normals->SetTypedTuple(static_cast<vtkIdType>(i), cloud[i].normal);
  }
  echoes->GetPointData()->SetNormals(normals);
}

void AddAttributes(const pcl::PointCloud<PointEcho>& cloud, vtkPolyData* echoes)
{
  AddIntensity(cloud, echoes);
  AddArray<vtkFloatArray>(
    cloud, echoes, names::EchoWidth, [](const PointEcho& p) { return p.width; });
  AddArray<vtkDoubleArray>(
    cloud, echoes, names::GpsTime, [](const PointEcho& p) { return p.gps_time; });
  AddArray<vtkTypeInt64Array>(
    cloud, echoes, names::PulseIds, [](const PointEcho& p) { return p.pulse_id; });
  AddArray<vtkIntArray>(cloud, echoes, names::ClassificationIds,
    [](const PointEcho& p) { return static_cast<std::int32_t>(p.classification); });
  AddArray<vtkUnsignedCharArray>(
    cloud, echoes, names::ReturnNumber, [](const PointEcho& p) { return p.return_number; });
  AddArray<vtkUnsignedCharArray>(
    cloud, echoes, names::NumberOfReturns, [](const PointEcho& p) { return p.number_of_returns; });
}

} // namespace

void ChooseOrigin(vtkPolyData* echoes, double origin[3], double step)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double low[3] = { infinity, infinity, infinity };
  double high[3] = { -infinity, -infinity, -infinity };
  double p[3];
  for (vtkIdType i = 0; i < echoes->GetNumberOfPoints(); ++i)
  {
    echoes->GetPoint(i, p);
    for (int axis = 0; axis < 3 && std::isfinite(p[0] + p[1] + p[2]); ++axis)
    {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const double centre = low[axis] + 0.5 * (high[axis] - low[axis]);
    origin[axis] = low[axis] <= high[axis] ? std::round(centre / step) * step + 0.0 : 0.0;
  }
}

template <typename PointT>
std::string ToPcl(vtkPolyData* echoes, const double origin[3], pcl::PointCloud<PointT>& cloud)
{
  const vtkIdType count = echoes->GetNumberOfPoints();
  if (count > std::numeric_limits<pcl::index_t>::max())
  {
    return std::to_string(count) + " points are more than PCL can count; process them in pieces";
  }
  cloud.clear();
  cloud.resize(static_cast<std::size_t>(count));
  FillPoints(echoes, origin, cloud);
  EchoArrays arrays(echoes);
  FillAttributes(arrays, cloud);
  return arrays.Problem;
}

template <typename PointT>
void FromPcl(const pcl::PointCloud<PointT>& cloud, const double origin[3], vtkPolyData* echoes)
{
  echoes->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(cloud.size()));
  for (std::size_t i = 0; i < cloud.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), origin[0] + static_cast<double>(cloud[i].x),
      origin[1] + static_cast<double>(cloud[i].y), origin[2] + static_cast<double>(cloud[i].z));
  }
  echoes->SetPoints(points);
  AddAttributes(cloud, echoes);
}

#define HELIOS_INSTANTIATE(PointT)                                                                 \
  template VTKHELIOSFILTERSPCL_EXPORT std::string ToPcl(                                           \
    vtkPolyData*, const double[3], pcl::PointCloud<PointT>&);                                      \
  template VTKHELIOSFILTERSPCL_EXPORT void FromPcl(                                                \
    const pcl::PointCloud<PointT>&, const double[3], vtkPolyData*)

HELIOS_INSTANTIATE(pcl::PointXYZ);
HELIOS_INSTANTIATE(pcl::PointXYZI);
HELIOS_INSTANTIATE(pcl::PointXYZINormal);
HELIOS_INSTANTIATE(PointEcho);

} // namespace helios
