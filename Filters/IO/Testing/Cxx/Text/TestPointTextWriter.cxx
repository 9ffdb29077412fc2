// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTempFolder.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosPointTextReader.h"
#include "vtkHeliosPointTextWriter.h"

#include <vtkFloatArray.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkStringArray.h>
#include <vtkUnsignedShortArray.h>

#include <catch2/catch.hpp>

#include <limits>

namespace names = vtkHeliosArrayNames;

namespace
{

std::string WriteEchoes(const helios::TempFolder& folder, vtkPolyData* echoes)
{
  const std::string path = folder / "points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));
  return path;
}

} // namespace

TEST_CASE("PointTextWriter: columns of a line", "[PointTextWriter]")
{
  const helios::TempFolder folder;
  const auto echoes = helios::MakeEchoes(3);
  vtkPointData* data = echoes->GetPointData();
  echoes->GetPoints()->SetPoint(1, 500001.75, -0.00003, 5499993.65432);
  data->GetArray(names::Amplitude)->SetComponent(1, 0, 1.23456789e-6);
  data->GetArray(names::EchoWidth)->SetComponent(1, 0, 4.0625);
  data->GetArray(names::GpsTime)->SetComponent(1, 0, 0.00007);
  const std::string text = helios::ReadText(WriteEchoes(folder, echoes));
  CHECK(text.find("\n500001.7500 0.0000 5499993.6543 1234.5679 4.0625 2 200 5000000001 1 -2 "
                  "0.000070000\n") != std::string::npos);
}

TEST_CASE("PointTextWriter: two more columns for the flags of scan lines", "[PointTextWriter]")
{
  const helios::TempFolder folder;
  const auto echoes = helios::MakeEchoes(2);
  const std::string plain = helios::ReadText(WriteEchoes(folder, echoes));
  const std::string path = folder / "flagged.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  writer->WriteScanFlagsOn();
  REQUIRE(writer->Open());
  CHECK_FALSE(writer->Write(echoes));
  CHECK(log->HasError("ScanDirectionFlag"));
  helios::AddColumn<vtkUnsignedCharArray>(
    echoes->GetPointData(), names::ScanDirectionFlag, 2, [](vtkIdType i) { return i; });
  helios::AddColumn<vtkUnsignedCharArray>(
    echoes->GetPointData(), names::EdgeOfFlightLine, 2, [](vtkIdType i) { return 1 - i; });
  REQUIRE((writer->Write(echoes) && writer->Close()));
  std::string expected = plain;
  expected.insert(plain.size() - 1, " 1 0");
  expected.insert(plain.find('\n'), " 0 1");
  CHECK(helios::ReadText(path) == expected);
}

TEST_CASE("PointTextWriter: decibels follow the flags of scan lines", "[PointTextWriter]")
{
  const helios::TempFolder folder;
  const auto echoes = helios::MakeEchoes(2);
  const std::string plain = helios::ReadText(WriteEchoes(folder, echoes));
  const std::string path = folder / "decibels.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  writer->WriteDecibelsOn();
  vtkPointData* data = echoes->GetPointData();
  for (const char* name : { names::ScanDirectionFlag, names::EdgeOfFlightLine })
  {
    helios::AddColumn<vtkUnsignedCharArray>(data, name, 2, [](vtkIdType i) { return i; });
  }
  REQUIRE(writer->Open());
  CHECK_FALSE(writer->Write(echoes));
  CHECK(log->HasError("RelativeAmplitude"));
  helios::AddColumn<vtkDoubleArray>(data, names::RelativeAmplitude, 2,
    [](vtkIdType i) { return 12.34567 + static_cast<double>(i); });
  helios::AddColumn<vtkDoubleArray>(
    data, names::Reflectance, 2, [](vtkIdType i) { return -3.0103 - static_cast<double>(i); });
  REQUIRE((writer->Write(echoes) && writer->Close()));
  std::string expected = plain;
  expected.insert(plain.size() - 1, " 1 1 13.3457 -4.0103");
  expected.insert(plain.find('\n'), " 0 0 12.3457 -3.0103");
  CHECK(helios::ReadText(path) == expected);
  vtkNew<vtkHeliosPointTextReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPointData* back = reader->GetOutput()->GetPointData();
  CHECK(back->GetArray(names::RelativeAmplitude)->GetTuple1(1) == 13.3457);
  CHECK(back->GetArray(names::Reflectance)->GetTuple1(0) == -3.0103);
  CHECK(back->GetArray(names::EdgeOfFlightLine)->GetTuple1(1) == 1.0);
}

TEST_CASE("PointTextWriter: an independent reader restores every value", "[PointTextWriter]")
{
  const helios::TempFolder folder;
  constexpr vtkIdType count = 20000;
  const auto echoes = helios::MakeEchoes(count);
  vtkPointData* data = echoes->GetPointData();
  std::ifstream file(WriteEchoes(folder, echoes));
  vtkIdType wrong = 0;
  const auto compare = [&wrong](double read, double written, int decimals)
  { wrong += std::abs(read - written) <= helios::RoundingOf(decimals, written) ? 0 : 1; };
  for (vtkIdType i = 0; i < count; ++i)
  {
    double x[3], intensity, width, time;
    long number, total, pulse, part, label;
    file >> x[0] >> x[1] >> x[2] >> intensity >> width >> number >> total >> pulse >> part >>
      label >> time;
    REQUIRE(file);
    for (int axis = 0; axis < 3; ++axis)
    {
      compare(x[axis], echoes->GetPoint(i)[axis], 4);
    }
    compare(intensity, 1e9 * data->GetArray(names::Amplitude)->GetComponent(i, 0), 4);
    compare(width, data->GetArray(names::EchoWidth)->GetComponent(i, 0), 4);
    compare(time, data->GetArray(names::GpsTime)->GetComponent(i, 0), 9);
    const bool same = number == 1 + i % 7 && total == 200 && pulse == 5000000000 + i &&
      part == i % 3 && label == (i % 2 == 0 ? 6 : -2);
    wrong += same ? 0 : 1;
  }
  CHECK(wrong == 0);
  std::string rest;
  CHECK_FALSE(file >> rest);
}

TEST_CASE("PointTextWriter: part names are single words", "[PointTextWriter]")
{
  const helios::TempFolder folder;
  const auto echoes = helios::MakeEchoes(6);
  vtkNew<vtkStringArray> parts;
  parts->SetName(names::PartName);
  for (const char* name : { "ground", "the red\thouse", "" })
  {
    parts->InsertNextValue(name);
  }
  echoes->GetFieldData()->AddArray(parts);
  vtkDataArray* ids = echoes->GetPointData()->GetArray(names::PartIds);
  ids->SetComponent(3, 0, 3);
  ids->SetComponent(4, 0, -1);
  const auto rows = helios::ReadRows(WriteEchoes(folder, echoes));
  const char* expected[] = { "ground", "the_red_house", "2", "3", "-1", "2" };
  for (std::size_t i = 0; i < 6; ++i)
  {
    REQUIRE(rows[i].size() == 11);
    CHECK(rows[i][8] == expected[i]);
  }
}

TEST_CASE("PointTextWriter: arrays of other types and layouts", "[PointTextWriter]")
{
  const helios::TempFolder folder;
  const auto echoes = helios::MakeEchoes(2);
  vtkPointData* data = echoes->GetPointData();
  helios::AddColumn<vtkFloatArray>(data, names::EchoWidth, 2, [](vtkIdType i) { return 0.5 + i; });
  helios::AddColumn<vtkUnsignedShortArray>(
    data, names::NumberOfReturns, 2, [](vtkIdType) { return 65535; });
  helios::AddColumn<vtkTypeInt64Array>(data, names::PulseIds, 2,
    [](vtkIdType i) { return std::numeric_limits<vtkTypeInt64>::max() - i; });
  vtkNew<vtkSOADataArrayTemplate<double>> times;
  times->SetName(names::GpsTime);
  times->SetNumberOfComponents(1); // allocates its buffer
  times->SetNumberOfTuples(2);
  times->SetValue(0, 1.25);
  times->SetValue(1, 2.5);
  data->AddArray(times);
  vtkNew<vtkSOADataArrayTemplate<int>> classes;
  classes->SetName(names::ClassificationIds);
  classes->SetNumberOfComponents(1);
  classes->SetNumberOfTuples(2);
  classes->SetValue(0, -7);
  classes->SetValue(1, 2000000000);
  data->AddArray(classes);
  const auto rows = helios::ReadRows(WriteEchoes(folder, echoes));
  REQUIRE(rows.size() == 2);
  CHECK(rows[1][4] == "1.5000");
  CHECK(rows[1][6] == "65535");
  CHECK(rows[1][7] == "9223372036854775806"); // double would round it
  CHECK(rows[0][9] == "-7");
  CHECK(rows[1][9] == "2000000000");
  CHECK(rows[1][10] == "2.500000000");
}

TEST_CASE("PointTextWriter: fills in arrays that are missing", "[PointTextWriter]")
{
  const helios::TempFolder folder;
  vtkNew<vtkPolyData> points;
  points->ShallowCopy(helios::MakeEchoes(2));
  points->GetPointData()->Initialize();
  helios::AddColumn<vtkFloatArray>(
    points->GetPointData(), names::EchoWidth, 2, [](vtkIdType i) { return 0.5 + i; });
  points->GetPoints()->SetPoint(1, 1.0, 2.0, 3.0);
  vtkNew<vtkHeliosPointTextWriter> writer;
  CHECK_FALSE(writer->GetFillMissing());
  writer->SetFileName((folder / "a.xyz").c_str());
  writer->FillMissingOn();
  REQUIRE((writer->Open() && writer->Write(points) && writer->Close()));
  const std::string text = helios::ReadText(folder / "a.xyz");
  CHECK(text.find("\n1.0000 2.0000 3.0000 0.0000 1.5000 1 1 -1 -1 0 0.000000000\n") !=
    std::string::npos);
  CHECK(points->GetPointData()->GetNumberOfArrays() == 1);
}
