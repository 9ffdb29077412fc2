// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Echoes to PCL and back: within 0.1 mm of the original, at UTM coordinates, with their arrays.
#include "heliosPclCloud.h"
#include "heliosPclTesting.h"

#include <vtkFloatArray.h>
#include <vtkStringArray.h>

#include <catch2/catch.hpp>

#include <limits>

namespace names = vtkHeliosArrayNames;

namespace
{

/// Points up to 1 km from a position in UTM, with every array that a point type has a field for.
vtkSmartPointer<vtkPolyData> MakeEchoes(vtkIdType count)
{
  helios::Uniform uniform(3);
  helios::Triples points;
  for (vtkIdType i = 0; i < count; ++i)
  {
    points.push_back(helios::Utm +
      helios::Triple{ uniform(-1000, 1000), uniform(-1000, 1000), uniform(-100, 100) });
  }
  auto echoes = helios::MakeCloud(points);
  vtkPointData* data = echoes->GetPointData();
  helios::AddColumn<vtkTypeInt64Array>(
    data, names::PulseIds, count, [](vtkIdType i) { return (1LL << 60) + i; });
  helios::AddColumn<vtkFloatArray>(
    data, names::Amplitude, count, [](vtkIdType i) { return 1e-9 * static_cast<double>(i); });
  helios::AddColumn<vtkFloatArray>(
    data, names::EchoWidth, count, [](vtkIdType i) { return 4.0 + 0.25 * (i % 8); });
  helios::AddColumn<vtkDoubleArray>(
    data, names::GpsTime, count, [](vtkIdType i) { return 2.5e8 + 1e-6 * i; });
  helios::AddColumn<vtkIntArray>(
    data, names::ClassificationIds, count, [](vtkIdType i) { return i % 19; });
  helios::AddColumn<vtkUnsignedCharArray>(
    data, names::ReturnNumber, count, [](vtkIdType i) { return 1 + i % 3; });
  helios::AddColumn<vtkUnsignedCharArray>(
    data, names::NumberOfReturns, count, [](vtkIdType) { return 3; });
  vtkNew<vtkFloatArray> normals;
  normals->SetName(names::Normals);
  normals->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    normals->InsertNextTuple3(0.6, 0.0, i % 2 == 0 ? 0.8 : -0.8);
  }
  data->SetNormals(normals);
  return echoes;
}

double GetLargestShift(vtkPolyData* a, vtkPolyData* b)
{
  REQUIRE(a->GetNumberOfPoints() == b->GetNumberOfPoints());
  double largest = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      largest = std::max(largest, std::abs(a->GetPoint(i)[axis] - b->GetPoint(i)[axis]));
    }
  }
  return largest;
}

bool IsSame(vtkPolyData* a, vtkPolyData* b, const char* name)
{
  vtkDataArray* x = a->GetPointData()->GetArray(name);
  vtkDataArray* y = b->GetPointData()->GetArray(name);
  bool isSame = x && y && x->GetNumberOfValues() == y->GetNumberOfValues();
  for (vtkIdType i = 0; isSame && i < x->GetNumberOfValues(); ++i)
  {
    isSame = x->GetVariantValue(i) == y->GetVariantValue(i);
  }
  return isSame;
}

template <typename PointT>
vtkSmartPointer<vtkPolyData> GoThereAndBack(vtkPolyData* echoes)
{
  double origin[3];
  helios::ChooseOrigin(echoes, origin);
  pcl::PointCloud<PointT> cloud;
  REQUIRE(helios::ToPcl(echoes, origin, cloud).empty());
  CHECK(cloud.is_dense);
  auto back = vtkSmartPointer<vtkPolyData>::New();
  helios::FromPcl(cloud, origin, back);
  CHECK(back->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(GetLargestShift(echoes, back) < 1e-4);
  return back;
}

} // namespace

TEST_CASE("PclCloud: echoes are restored with their arrays", "[PclCloud]")
{
  const auto echoes = MakeEchoes(5000);
  CHECK(GoThereAndBack<pcl::PointXYZ>(echoes)->GetPointData()->GetNumberOfArrays() == 0);
  CHECK(IsSame(GoThereAndBack<pcl::PointXYZI>(echoes), echoes, names::Amplitude));

  const auto withNormals = GoThereAndBack<pcl::PointXYZINormal>(echoes);
  CHECK(IsSame(withNormals, echoes, names::Amplitude));
  CHECK(IsSame(withNormals, echoes, names::Normals));

  const auto back = GoThereAndBack<helios::PointEcho>(echoes);
  for (const char* name : { names::Amplitude, names::EchoWidth, names::GpsTime, names::PulseIds,
         names::ClassificationIds, names::ReturnNumber, names::NumberOfReturns })
  {
    INFO(name);
    CHECK(IsSame(back, echoes, name));
  }
}

TEST_CASE("PclCloud: float is not sufficient without an origin", "[PclCloud]")
{
  const auto echoes = MakeEchoes(100);
  const double origin[3] = { 0.0, 0.0, 0.0 };
  pcl::PointCloud<pcl::PointXYZ> cloud;
  REQUIRE(helios::ToPcl(echoes, origin, cloud).empty());
  vtkNew<vtkPolyData> back;
  helios::FromPcl(cloud, origin, back);
  CHECK(GetLargestShift(echoes, back) > 0.1);
}

TEST_CASE("PclCloud: the origin is the centre of the finite points, rounded", "[PclCloud]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto cloud =
    helios::MakeCloud({ { 10.0, 0.0, -4.0 }, { 14.6, 3.0, -5.0 }, { nan, 1e9, 1e9 } });
  double origin[3];
  helios::ChooseOrigin(cloud, origin);
  CHECK((origin[0] == 12.0 && origin[1] == 2.0 && origin[2] == -5.0));
  helios::ChooseOrigin(cloud, origin, 0.5);
  CHECK((origin[0] == 12.5 && origin[1] == 1.5 && origin[2] == -4.5));
  helios::ChooseOrigin(helios::MakeCloud({}), origin);
  CHECK((origin[0] == 0.0 && origin[1] == 0.0 && origin[2] == 0.0));
}

TEST_CASE("PclCloud: points that are not finite are kept, and the cloud is not dense", "[PclCloud]")
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto echoes = helios::MakeCloud({ { 1.0, 2.0, 3.0 }, { 1.0, nan, 3.0 } });
  const double origin[3] = { 0.0, 0.0, 0.0 };
  pcl::PointCloud<helios::PointEcho> cloud;
  REQUIRE(helios::ToPcl(echoes, origin, cloud).empty());
  CHECK(cloud.size() == 2);
  CHECK(cloud.width == 2);
  CHECK_FALSE(cloud.is_dense);
  CHECK(cloud[1].pulse_id == 1);
  CHECK(cloud[0].gps_time == 0.0); // no such array
}

TEST_CASE("PclCloud: values beyond the range of a field are clamped", "[PclCloud]")
{
  const auto echoes = helios::MakeCloud({ { 0.0, 0.0, 0.0 }, { 0.0, 0.0, 1.0 } });
  helios::AddColumn<vtkIntArray>(
    echoes->GetPointData(), names::ReturnNumber, 2, [](vtkIdType i) { return i == 0 ? 300 : -1; });
  const double origin[3] = { 0.0, 0.0, 0.0 };
  pcl::PointCloud<helios::PointEcho> cloud;
  REQUIRE(helios::ToPcl(echoes, origin, cloud).empty());
  CHECK(static_cast<int>(cloud[0].return_number) == 255);
  CHECK(static_cast<int>(cloud[1].return_number) == 0);
}

TEST_CASE("PclCloud: arrays of another shape or type are errors", "[PclCloud]")
{
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const auto echoes = MakeEchoes(10);
  pcl::PointCloud<helios::PointEcho> cloud;
  helios::AddColumn<vtkFloatArray>(
    echoes->GetPointData(), names::Amplitude, 9, [](vtkIdType) { return 1; });
  CHECK(helios::ToPcl(echoes, origin, cloud) ==
    "the point array Amplitude holds 9 x 1 values (float), not 10 x 1 numbers; give it that shape, "
    "or remove it");
  echoes->GetPointData()->RemoveArray(names::Amplitude);
  vtkNew<vtkStringArray> text;
  text->SetName(names::GpsTime);
  text->SetNumberOfValues(10);
  echoes->GetPointData()->AddArray(text);
  CHECK(helios::ToPcl(echoes, origin, cloud).find("GpsTime holds 10 x 1 values (string)") !=
    std::string::npos);
  pcl::PointCloud<pcl::PointXYZ> places; // without such a field
  CHECK(helios::ToPcl(echoes, origin, places).empty());
}
