// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// PCL reads the output of vtkHelios, and vtkHelios reads the output of PCL.
#include "heliosPclCloud.h"
#include "heliosPclTesting.h"
#include "vtkHeliosPCDReader.h"
#include "vtkHeliosPCDWriter.h"
#include "vtkHeliosPCLArrayNames.h"

#include <vtkFloatArray.h>
#include <vtkUnsignedShortArray.h>

#include <catch2/catch.hpp>

#include <pcl/io/pcd_io.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <limits>

namespace names = vtkHeliosArrayNames;

namespace
{

/// A temporary file, removed after the test.
struct TempFile
{
  std::string Folder = (std::filesystem::temp_directory_path() / "vtkHeliosXXXXXX").string();
  std::string Path;

  TempFile() { this->Path = std::string(::mkdtemp(this->Folder.data())) + "/a.pcd"; }
  ~TempFile() { std::filesystem::remove_all(this->Folder); }
};

vtkSmartPointer<vtkPolyData> MakeEchoes()
{
  helios::Triples points;
  for (int i = 0; i < 1000; ++i)
  {
    points.push_back(helios::Utm + helios::Triple{ 0.37 * i, -0.41 * i, 0.01 * i });
  }
  auto echoes = helios::MakeCloud(points);
  vtkPointData* data = echoes->GetPointData();
  helios::AddColumn<vtkDoubleArray>(
    data, names::Amplitude, 1000, [](vtkIdType i) { return 1e-9 * static_cast<double>(i); });
  helios::AddColumn<vtkDoubleArray>(
    data, names::EchoWidth, 1000, [](vtkIdType i) { return 4.0 + 0.25 * (i % 8); });
  helios::AddColumn<vtkDoubleArray>(
    data, names::GpsTime, 1000, [](vtkIdType i) { return 2.5e8 + 1e-6 * i; });
  helios::AddColumn<vtkIntArray>(
    data, names::ClassificationIds, 1000, [](vtkIdType i) { return i % 19 - 1; });
  helios::AddColumn<vtkUnsignedCharArray>(
    data, names::ReturnNumber, 1000, [](vtkIdType i) { return 1 + i % 3; });
  helios::AddColumn<vtkUnsignedCharArray>(
    data, names::NumberOfReturns, 1000, [](vtkIdType) { return 200; });
  return echoes;
}

} // namespace

TEST_CASE("PcdReference: PCL reads our files", "[PcdReference]")
{
  const int storage = GENERATE(0, 1);
  const TempFile file;
  const auto echoes = MakeEchoes();
  vtkNew<vtkHeliosPCDWriter> writer;
  writer->SetFileName(file.Path.c_str());
  writer->SetStorage(storage);
  writer->UseOriginOn();
  writer->SetOrigin(476300.0, 5473800.0, 300.0);
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));

  pcl::PointCloud<helios::PointEcho> cloud;
  REQUIRE(pcl::io::loadPCDFile(file.Path, cloud) == 0);
  REQUIRE(cloud.size() == 1000);
  CHECK(cloud.width == 1000);
  vtkIdType wrong = 0;
  for (std::size_t i = 0; i < 1000; ++i)
  {
    const helios::PointEcho& p = cloud[i];
    const double* q = echoes->GetPoint(static_cast<vtkIdType>(i));
    wrong += std::abs(static_cast<double>(p.x) + 476300.0 - q[0]) < 1e-4 &&
        std::abs(static_cast<double>(p.y) + 5473800.0 - q[1]) < 1e-4 &&
        std::abs(static_cast<double>(p.z) + 300.0 - q[2]) < 1e-4 &&
        p.intensity == static_cast<float>(1e-9 * static_cast<double>(i)) &&
        p.width == 4.0F + 0.25F * static_cast<float>(i % 8) &&
        p.gps_time == 2.5e8 + 1e-6 * static_cast<double>(i) &&
        p.pulse_id == static_cast<std::int64_t>(i) &&
        static_cast<int>(p.classification) == static_cast<int>(i % 19) - 1 &&
        p.return_number == 1 + i % 3 && p.number_of_returns == 200
      ? 0
      : 1;
  }
  CHECK(wrong == 0);
  pcl::PointCloud<pcl::PointXYZI> plain;
  REQUIRE(pcl::io::loadPCDFile(file.Path, plain) == 0);
  CHECK(plain[999].intensity == cloud[999].intensity);
}

TEST_CASE("PcdReference: PCL's files are read", "[PcdReference]")
{
  const int kind = GENERATE(0, 1, 2);
  const TempFile file;
  const auto echoes = MakeEchoes();
  double origin[3];
  helios::ChooseOrigin(echoes, origin);
  pcl::PointCloud<helios::PointEcho> cloud;
  REQUIRE(helios::ToPcl(echoes, origin, cloud).empty());
  cloud[7].x = std::numeric_limits<float>::quiet_NaN();
  cloud.is_dense = false;
  cloud.width = 50;
  cloud.height = 20;
  pcl::PCDWriter pclWriter;
  REQUIRE((kind == 0      ? pclWriter.writeASCII(file.Path, cloud, 9)
              : kind == 1 ? pclWriter.writeBinary(file.Path, cloud)
                          : pclWriter.writeBinaryCompressed(file.Path, cloud)) == 0);

  vtkNew<vtkHeliosPCDReader> reader;
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(reader);
  reader->SetFileName(file.Path.c_str());
  reader->Update();
  REQUIRE(log->Errors.empty());
  CHECK(log->HasWarning("1 of 1000 points are not finite: dropped"));
  vtkPolyData* read = reader->GetOutput();
  REQUIRE(read->GetNumberOfPoints() == 999);
  vtkPointData* data = read->GetPointData();
  vtkIdType wrong = 0;
  for (vtkIdType i = 0; i < 999; ++i)
  {
    const helios::PointEcho& p = cloud[static_cast<std::size_t>(i < 7 ? i : i + 1)];
    const double* q = read->GetPoint(i);
    wrong += static_cast<float>(q[0]) == p.x && static_cast<float>(q[1]) == p.y &&
        static_cast<float>(q[2]) == p.z &&
        static_cast<float>(data->GetArray(names::Intensity)->GetTuple1(i)) == p.intensity &&
        static_cast<float>(data->GetArray(names::EchoWidth)->GetTuple1(i)) == p.width &&
        data->GetArray(names::PulseIds)->GetVariantValue(i).ToTypeInt64() == p.pulse_id &&
        data->GetArray(names::ReturnNumber)->GetTuple1(i) == p.return_number &&
        data->GetArray(names::ClassificationIds)->GetTuple1(i) ==
          static_cast<int>(p.classification) &&
        std::abs(data->GetArray(names::GpsTime)->GetTuple1(i) - p.gps_time) <=
          (kind == 0 ? 1.0 : 0.0) // PCL writes nine digits
      ? 0
      : 1;
  }
  CHECK(wrong == 0);
}

namespace
{

/// Returns a colour of a point: all values of 8 bits occur, also denormal floats.
std::uint8_t GetShade(std::size_t point, int component)
{
  return static_cast<std::uint8_t>(point < 2 ? 0 : (point * (3 + 2 * component)) % 256);
}

template <typename PointT>
bool HasShades(const PointT& p, std::size_t i)
{
  return p.r == GetShade(i, 0) && p.g == GetShade(i, 1) && p.b == GetShade(i, 2);
}

void AddShades(vtkPolyData* cloud)
{
  vtkNew<vtkFloatArray> colors;
  colors->SetName(names::RGB);
  colors->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < static_cast<std::size_t>(cloud->GetNumberOfPoints()); ++i)
  {
    colors->InsertNextTuple3(
      GetShade(i, 0) / 255.0, GetShade(i, 1) / 255.0, GetShade(i, 2) / 255.0);
  }
  cloud->GetPointData()->AddArray(colors);
}

struct PcdReading
{
  vtkNew<vtkHeliosPCDReader> Reader;
  vtkSmartPointer<helios::ErrorObserver> Log =
    vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());

  explicit PcdReading(const std::string& path)
  {
    this->Log->Watch(this->Reader);
    this->Reader->SetFileName(path.c_str());
    this->Reader->Update();
  }
  vtkDataArray* Get(const char* name)
  {
    return this->Reader->GetOutput()->GetPointData()->GetArray(name);
  }
  vtkIdType CountWrongShades()
  {
    vtkIdType wrong = 0;
    for (vtkIdType i = 0; i < this->Reader->GetOutput()->GetNumberOfPoints(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double shade = this->Get(names::RGB)->GetComponent(i, k) * 255.0;
        wrong += std::abs(shade - GetShade(static_cast<std::size_t>(i), k)) > 1e-4;
      }
    }
    return wrong;
  }
};

template <typename CloudT>
int WritePcl(const std::string& path, const CloudT& cloud, int kind)
{
  pcl::PCDWriter writer;
  return kind == 0 ? writer.writeASCII(path, cloud, 9)
    : kind == 1    ? writer.writeBinary(path, cloud)
                   : writer.writeBinaryCompressed(path, cloud);
}

} // namespace

TEST_CASE(
  "PcdReference: PCL's own point types read our colours, labels and normals", "[PcdReference]")
{
  const int storage = GENERATE(0, 1);
  const TempFile file;
  const auto echoes = MakeEchoes();
  vtkPointData* data = echoes->GetPointData();
  data->RemoveArray(names::Amplitude);
  helios::AddColumn<vtkUnsignedShortArray>(
    data, names::Intensity, 1000, [](vtkIdType i) { return 65535 - i; });
  helios::AddColumn<vtkFloatArray>(data, vtkHeliosPCLArrayNames::Curvature, 1000,
    [](vtkIdType i) { return 1e-4 * static_cast<double>(i); });
  vtkNew<vtkFloatArray> normals;
  normals->SetName(names::Normals);
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 1000; ++i)
  {
    normals->InsertNextTuple3(0.6, 0.0, 0.8);
  }
  data->AddArray(normals);
  AddShades(echoes);
  vtkNew<vtkHeliosPCDWriter> writer;
  writer->SetFileName(file.Path.c_str());
  writer->SetStorage(storage);
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));

  pcl::PointCloud<pcl::PointXYZRGB> rgb;
  pcl::PointCloud<pcl::PointXYZRGBA> rgba;
  pcl::PointCloud<pcl::PointXYZRGBL> labels;
  pcl::PointCloud<pcl::PointXYZI> intensities;
  pcl::PointCloud<pcl::PointNormal> facing;
  REQUIRE(pcl::io::loadPCDFile(file.Path, rgb) == 0);
  REQUIRE(pcl::io::loadPCDFile(file.Path, rgba) == 0);
  REQUIRE(pcl::io::loadPCDFile(file.Path, labels) == 0);
  REQUIRE(pcl::io::loadPCDFile(file.Path, intensities) == 0);
  REQUIRE(pcl::io::loadPCDFile(file.Path, facing) == 0);
  REQUIRE(rgb.size() == 1000);
  vtkIdType wrong = 0;
  for (std::size_t i = 0; i < 1000; ++i)
  {
    const bool isRight = HasShades(rgb[i], i) && HasShades(rgba[i], i) && HasShades(labels[i], i) &&
      rgb[i].a == 255 && static_cast<int>(labels[i].label) == static_cast<int>(i % 19) - 1 &&
      intensities[i].intensity == static_cast<float>(65535 - i) && facing[i].normal_x == 0.6F &&
      facing[i].normal_y == 0.0F && facing[i].normal_z == 0.8F &&
      facing[i].curvature == static_cast<float>(1e-4 * static_cast<double>(i));
    wrong += isRight ? 0 : 1;
  }
  CHECK(wrong == 0);

  PcdReading reading(file.Path); // and we read them back
  REQUIRE(reading.Log->Errors.empty());
  CHECK(reading.Log->Warnings.empty());
  CHECK(reading.CountWrongShades() == 0);
  REQUIRE(reading.Get(names::Intensity)->GetDataType() == VTK_UNSIGNED_SHORT);
  CHECK(reading.Get(names::Intensity)->GetTuple1(999) == 64536);
  CHECK(reading.Get(names::ClassificationIds)->GetTuple1(0) == -1);
  CHECK(reading.Get(vtkHeliosPCLArrayNames::Curvature)->GetTuple1(10) == Approx(1e-3));
  CHECK(reading.Get(names::Normals)->GetComponent(5, 2) == Approx(0.8));
}

TEST_CASE("PcdReference: colours, labels and normals of PCL's files", "[PcdReference]")
{
  const int kind = GENERATE(0, 1, 2);
  const TempFile file;
  pcl::PointCloud<pcl::PointXYZRGBNormal> cloud(40, 25);
  pcl::PointCloud<pcl::PointXYZRGBA> other(40, 25);
  pcl::PointCloud<pcl::PointXYZL> labels(40, 25);
  for (std::size_t i = 0; i < 1000; ++i)
  {
    cloud[i].r = other[i].r = GetShade(i, 0);
    cloud[i].g = other[i].g = GetShade(i, 1);
    cloud[i].b = other[i].b = GetShade(i, 2);
    cloud[i].a = static_cast<std::uint8_t>(i % 2 == 0 ? 255 : 0);
    cloud[i].normal_z = 1.0F;
    cloud[i].curvature = 0.25F;
    labels[i].label = static_cast<std::uint32_t>(i);
  }
  REQUIRE(WritePcl(file.Path, cloud, kind) == 0);
  PcdReading reading(file.Path);
  REQUIRE(reading.Log->Errors.empty());
  CHECK(reading.Log->Warnings.empty()); // no colour of alpha 255 is "not finite"
  REQUIRE(reading.Reader->GetOutput()->GetNumberOfPoints() == 1000);
  CHECK(reading.CountWrongShades() == 0);
  CHECK(reading.Get(names::Normals)->GetComponent(9, 2) == 1.0);
  CHECK(reading.Get(vtkHeliosPCLArrayNames::Curvature)->GetTuple1(9) == 0.25);
  CHECK(reading.Reader->GetOutput()->GetPointData()->GetNumberOfArrays() == 3);

  REQUIRE(WritePcl(file.Path, other, kind) == 0);
  PcdReading second(file.Path);
  CHECK(second.CountWrongShades() == 0);
  REQUIRE(WritePcl(file.Path, labels, kind) == 0);
  PcdReading third(file.Path);
  REQUIRE(third.Get(names::ClassificationIds));
  CHECK(third.Get(names::ClassificationIds)->GetTuple1(700) == 700);
}

TEST_CASE("PcdReference: PCL has no coordinates of 64 bits", "[PcdReference]")
{
  const TempFile file;
  const auto echoes = MakeEchoes();
  vtkNew<vtkHeliosPCDWriter> writer;
  writer->SetFileName(file.Path.c_str());
  writer->SetResolution(1e-9);
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));
  pcl::PointCloud<pcl::PointXYZI> cloud;
  REQUIRE(pcl::io::loadPCDFile(file.Path, cloud) == 0);
  REQUIRE(cloud.size() == 1000);
  CHECK(cloud[9].x == 0.0F); // stated in Docs/pcl.md
  CHECK(cloud[9].intensity == 9e-9F);
}
