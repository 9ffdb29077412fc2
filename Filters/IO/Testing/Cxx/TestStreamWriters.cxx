// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosErrorObserver.h"
#include "heliosPose.h"
#include "heliosTempFolder.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosPointTextWriter.h"
#include "vtkHeliosPointXMLWriter.h"
#include "vtkHeliosTrajectoryTextWriter.h"
#include "vtkHeliosWaveformTextWriter.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPPolyDataReader.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include <sys/mount.h>

namespace names = vtkHeliosArrayNames;
namespace fs = std::filesystem;

namespace
{

template <typename ArrayT, typename ValueT>
void AddColumn(vtkFieldData* data, const char* name, vtkIdType count, ValueT value)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < count; ++i)
  {
    array->InsertNextValue(static_cast<typename ArrayT::ValueType>(value(i)));
  }
  data->AddArray(array);
}

/// Echoes whose numbers follow from their row.
vtkSmartPointer<vtkPolyData> MakeEchoes(vtkIdType count)
{
  auto echoes = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->InsertNextPoint(500000 + 0.25 * i, 5500000.654321 - i, -1e-5 * i);
  }
  echoes->SetPoints(points);
  vtkPointData* data = echoes->GetPointData();
  AddColumn<vtkDoubleArray>(data, names::GpsTime, count, [](vtkIdType i) { return i / 100000.0; });
  AddColumn<vtkTypeInt64Array>(
    data, names::PulseIds, count, [](vtkIdType i) { return 5000000000LL + i; });
  AddColumn<vtkUnsignedCharArray>(data, names::ReturnNumber, count, [](vtkIdType) { return 1; });
  AddColumn<vtkUnsignedCharArray>(data, names::NumberOfReturns, count, [](vtkIdType) { return 2; });
  AddColumn<vtkDoubleArray>(data, names::Amplitude, count, [](vtkIdType i) { return 1e-7 * i; });
  AddColumn<vtkDoubleArray>(data, names::EchoWidth, count, [](vtkIdType) { return 4.0625; });
  AddColumn<vtkIntArray>(data, names::PartIds, count, [](vtkIdType i) { return i % 3; });
  AddColumn<vtkIntArray>(data, names::ClassificationIds, count, [](vtkIdType) { return 6; });
  return echoes;
}

void NameParts(vtkPolyData* echoes)
{
  vtkNew<vtkStringArray> parts;
  parts->SetName(names::PartName);
  parts->InsertNextValue("ground");
  parts->InsertNextValue("house_7");
  echoes->GetFieldData()->AddArray(parts);
}

vtkSmartPointer<helios::ErrorObserver> Watch(vtkObject* object)
{
  auto log = vtkSmartPointer<helios::ErrorObserver>::Take(helios::ErrorObserver::New());
  log->Watch(object);
  return log;
}

} // namespace

TEST_CASE("PointTextWriter: the columns", "[Writers]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "new/sub/leg000_points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(path.c_str());
  const auto echoes = MakeEchoes(10);
  NameParts(echoes);
  REQUIRE(writer->Open());
  REQUIRE(writer->Write(echoes));
  CHECK(fs::exists(path + ".part"));
  CHECK_FALSE(fs::exists(path));
  REQUIRE(writer->Write(MakeEchoes(5)));
  REQUIRE(writer->Close());
  CHECK_FALSE(fs::exists(path + ".part"));
  CHECK(writer->GetNumberOfRecords() == 15);
  CHECK(writer->GetNumberOfBytes() == static_cast<vtkIdType>(fs::file_size(path)));

  const auto rows = helios::ReadRows(path);
  REQUIRE(rows.size() == 15);
  const std::vector<std::string> expected{ "500001.7500", "5499993.6543", "-0.0001", "700.0000",
    "4.0625", "1", "2", "5000000007", "house_7", "6", "0.000070000" };
  CHECK(rows[7] == expected);
  CHECK(rows[0][2] == "0.0000");
  CHECK(rows[8][8] == "2"); // a part without a name
  CHECK(rows[11][8] == "1");
}

TEST_CASE("PointTextWriter: same bytes for any number of threads", "[Writers]")
{
  const helios::TempFolder folder;
  const auto echoes = MakeEchoes(50000);
  std::string texts[2];
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    vtkNew<vtkHeliosPointTextWriter> writer;
    const std::string path = folder / "points.xyz";
    writer->SetFileName(path.c_str());
    REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));
    texts[threads - 1] = helios::ReadText(path);
  }
  CHECK(texts[0].size() > 1000000);
  CHECK(texts[0] == texts[1]);
}

TEST_CASE("StreamWriter: what is abandoned stays whole as .part", "[Writers]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(MakeEchoes(4)) && writer->Abandon()));
  CHECK_FALSE(fs::exists(path));
  CHECK(helios::ReadRows(path + ".part").size() == 4);
}

TEST_CASE("StreamWriter: no records are an empty file", "[Writers]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(MakeEchoes(0)) && writer->Close()));
  CHECK(fs::file_size(path) == 0);
}

TEST_CASE("StreamWriter: what is wrong is said", "[Writers]")
{
  const helios::TempFolder folder;
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = Watch(writer);
  SECTION("no name")
  {
    CHECK_FALSE(writer->Open());
    CHECK(log->HasError("FileName is not set"));
  }
  SECTION("not open")
  {
    CHECK_FALSE(writer->Write(MakeEchoes(1)));
    CHECK(log->HasError("is not open"));
    log->Clear();
    CHECK_FALSE(writer->Close());
    CHECK(log->HasError("is not open"));
  }
  SECTION("a file where a folder should be")
  {
    std::ofstream(folder / "plain") << "text";
    const std::string path = folder / "plain/run/points.xyz";
    writer->SetFileName(path.c_str());
    CHECK_FALSE(writer->Open());
    CHECK(log->HasError("cannot be made"));
    CHECK(log->HasError("choose another output folder"));
  }
  SECTION("blocks of another kind")
  {
    const std::string path = folder / "points.xyz";
    writer->SetFileName(path.c_str());
    REQUIRE(writer->Open());
    vtkNew<vtkTable> table;
    CHECK_FALSE(writer->Write(table));
    CHECK(log->HasError("not vtkPolyData"));
    const auto echoes = MakeEchoes(3);
    echoes->GetPointData()->RemoveArray(names::EchoWidth);
    CHECK_FALSE(writer->Write(echoes));
    CHECK(log->HasError("no array EchoWidth"));
    vtkNew<vtkDoubleArray> pairs;
    pairs->SetName(names::EchoWidth);
    pairs->SetNumberOfComponents(2);
    pairs->SetNumberOfTuples(3);
    echoes->GetPointData()->AddArray(pairs);
    CHECK_FALSE(writer->Write(echoes));
    CHECK(log->HasError("has 2 components"));
  }
}

TEST_CASE("StreamWriter: a full disk keeps whole lines and says how many", "[Writers]")
{
  const helios::TempFolder folder;
  const std::string disk = folder / "disk";
  fs::create_directory(disk);
  if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=256k") != 0)
  {
    WARN("no small disk can be mounted here: not tested");
    return;
  }
  const std::string path = disk + "/points.xyz";
  {
    vtkNew<vtkHeliosPointTextWriter> writer;
    const auto log = Watch(writer);
    writer->SetFileName(path.c_str());
    REQUIRE(writer->Open());
    REQUIRE(writer->Write(MakeEchoes(1000)));
    CHECK_FALSE(writer->Write(MakeEchoes(100000)));
    CHECK(log->HasError("No space left on device"));
    CHECK(log->HasError("1000 records are safe in " + path + ".part"));
    writer->Abandon();
    const std::string text = helios::ReadText(path + ".part");
    CHECK(text.back() == '\n');
    CHECK(std::count(text.begin(), text.end(), '\n') == 1000);

    vtkNew<vtkHeliosPointXMLWriter> pieces;
    const auto pieceLog = Watch(pieces);
    const std::string index = disk + "/points.pvtp";
    pieces->SetFileName(index.c_str());
    REQUIRE(pieces->Open());
    CHECK_FALSE(pieces->Write(MakeEchoes(100000)));
    CHECK(pieceLog->HasError("cannot be written"));
    pieces->Abandon();
  }
  ::umount(disk.c_str());
}

TEST_CASE("PointXMLWriter: VTK reads back what was written", "[Writers]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "run/leg000_points.pvtp";
  vtkNew<vtkHeliosPointXMLWriter> writer;
  writer->SetFileName(path.c_str());
  const auto echoes = MakeEchoes(1000);
  REQUIRE(writer->Open());
  REQUIRE(writer->Write(echoes));
  REQUIRE(writer->Write(MakeEchoes(10)));
  CHECK(echoes->GetNumberOfCells() == 0); // the block is left alone
  REQUIRE(writer->Close());
  CHECK(fs::exists(folder / "run/leg000_points_0001.vtp"));

  vtkNew<vtkXMLPPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* cloud = reader->GetOutput();
  REQUIRE(cloud->GetNumberOfPoints() == 1010);
  CHECK(cloud->GetNumberOfVerts() == 1010);
  CHECK(cloud->GetPoint(999)[1] == echoes->GetPoint(999)[1]);
  REQUIRE(
    cloud->GetPointData()->GetNumberOfArrays() == echoes->GetPointData()->GetNumberOfArrays());
  for (int a = 0; a < echoes->GetPointData()->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* wrote = echoes->GetPointData()->GetArray(a);
    vtkDataArray* read = cloud->GetPointData()->GetArray(wrote->GetName());
    REQUIRE(read);
    CHECK(read->GetDataTypeSize() == wrote->GetDataTypeSize());
    for (vtkIdType i = 0; i < 1000; i += 37)
    {
      CHECK(read->GetComponent(i, 0) == wrote->GetComponent(i, 0));
    }
  }
}

TEST_CASE("PointXMLWriter: refuses what is no cloud", "[Writers]")
{
  const helios::TempFolder folder;
  vtkNew<vtkHeliosPointXMLWriter> writer;
  const auto log = Watch(writer);
  const std::string path = folder / "points.pvtp";
  writer->SetFileName(path.c_str());
  CHECK_FALSE(writer->Write(MakeEchoes(1)));
  CHECK(log->HasError("is not open"));
  REQUIRE(writer->Open());
  vtkNew<vtkTable> table;
  CHECK_FALSE(writer->Write(table));
  CHECK(log->HasError("not vtkPolyData"));
}

TEST_CASE("TrajectoryTextWriter: positions, times and angles", "[Writers]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "trajectory.txt";
  vtkNew<vtkPolyData> samples;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> orientations;
  orientations->SetName(names::Orientation);
  orientations->SetNumberOfComponents(4);
  const auto add = [&points, &orientations](double roll, double pitch, double yaw)
  {
    const helios::Quaternion q = helios::AxisAngle({ 1, 0, 0 }, roll) *
      helios::AxisAngle({ 0, 1, 0 }, pitch) * helios::AxisAngle({ 0, 0, 1 }, yaw);
    points->InsertNextPoint(1.5, -2.25, 100);
    orientations->InsertNextTuple(q.GetData());
  };
  add(0, 0, 0);
  add(0, 0, -90);
  add(10, -20, 300);
  add(0, 90, 40); // gimbal lock
  samples->SetPoints(points);
  samples->GetPointData()->AddArray(orientations);
  AddColumn<vtkDoubleArray>(
    samples->GetPointData(), names::GpsTime, 4, [](vtkIdType i) { return 0.5 * i; });

  vtkNew<vtkHeliosTrajectoryTextWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(samples) && writer->Close()));
  const auto rows = helios::ReadRows(path);
  REQUIRE(rows.size() == 4);
  using Row = std::vector<std::string>;
  CHECK(
    rows[0] == Row{ "1.5000", "-2.2500", "100.0000", "0.000000000", "0.0000", "0.0000", "0.0000" });
  CHECK(Row(rows[1].begin() + 3, rows[1].end()) ==
    Row{ "0.500000000", "0.0000", "0.0000", "270.0000" });
  CHECK(Row(rows[2].begin() + 4, rows[2].end()) == Row{ "10.0000", "-20.0000", "300.0000" });
  CHECK(Row(rows[3].begin() + 4, rows[3].end()) == Row{ "0.0000", "90.0000", "40.0000" });

  vtkNew<vtkPolyData> bare;
  bare->SetPoints(points);
  const auto log = Watch(writer);
  REQUIRE(writer->Open());
  CHECK_FALSE(writer->Write(bare));
  CHECK(log->HasError("no array GpsTime"));
}

TEST_CASE("WaveformTextWriter: the columns", "[Writers]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "fullwave.txt";
  vtkNew<vtkTable> table;
  vtkFieldData* rows = table->GetRowData();
  AddColumn<vtkTypeInt64Array>(rows, names::PulseIds, 2, [](vtkIdType i) { return 40 + i; });
  for (const char* name : { names::Origin, names::Direction })
  {
    vtkNew<vtkDoubleArray> vectors;
    vectors->SetName(name);
    vectors->SetNumberOfComponents(3);
    vectors->InsertNextTuple3(0.6, 0.8, 0);
    vectors->InsertNextTuple3(0, 1, 1e-9);
    rows->AddArray(vectors);
  }
  AddColumn<vtkDoubleArray>(rows, names::GpsTime, 2, [](vtkIdType i) { return 0.25 * i; });
  AddColumn<vtkDoubleArray>(rows, names::StartTime, 2, [](vtkIdType) { return 667.125; });
  AddColumn<vtkDoubleArray>(rows, names::BinSize, 2, [](vtkIdType) { return 0.25; });
  AddColumn<vtkTypeInt64Array>(rows, names::Offset, 2, [](vtkIdType i) { return 3 * i; });
  AddColumn<vtkTypeInt64Array>(rows, names::Count, 2, [](vtkIdType i) { return 3 - i; });
  AddColumn<vtkFloatArray>(
    table->GetFieldData(), names::Samples, 5, [](vtkIdType i) { return 1e-9 * (i + 1); });

  vtkNew<vtkHeliosWaveformTextWriter> writer;
  const auto log = Watch(writer);
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(table) && writer->Close()));
  const auto lines = helios::ReadRows(path);
  REQUIRE(lines.size() == 2);
  REQUIRE(lines[0].size() == 13);
  REQUIRE(lines[1].size() == 12);
  CHECK(lines[0][0] == "40");
  CHECK(lines[1][6] == "0.000000001");
  CHECK(lines[1][7] == "667.1250");
  CHECK(lines[1][8] == "667.3750");
  CHECK(lines[1][9] == "0.250000000");
  CHECK(std::stod(lines[1][10]) == Approx(4).epsilon(1e-7));

  REQUIRE(writer->Open());
  CHECK_FALSE(writer->Write(MakeEchoes(1)));
  CHECK(log->HasError("not a vtkTable"));
  table->GetFieldData()->RemoveArray(names::Samples);
  CHECK_FALSE(writer->Write(table));
  CHECK(log->HasError("no array Samples"));
}
