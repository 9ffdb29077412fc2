// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// PCL reads the output of vtkHelios, and vtkHelios reads the output of PCL.
#include "heliosPclCloud.h"
#include "heliosPclTesting.h"
#include "vtkHeliosPCDReader.h"
#include "vtkHeliosPCDWriter.h"

#include <vtkFloatArray.h>

#include <catch2/catch.hpp>

#include <pcl/io/pcd_io.h>

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
        p.classification == static_cast<int>(i % 19) - 1 && p.return_number == 1 + i % 3 &&
        p.number_of_returns == 200
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
        data->GetArray(names::ClassificationIds)->GetTuple1(i) == p.classification &&
        std::abs(data->GetArray(names::GpsTime)->GetTuple1(i) - p.gps_time) <=
          (kind == 0 ? 1.0 : 0.0) // PCL writes nine digits
      ? 0
      : 1;
  }
  CHECK(wrong == 0);
}
