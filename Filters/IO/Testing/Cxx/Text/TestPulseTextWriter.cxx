// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTempFolder.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosPulseTextWriter.h"

#include <catch2/catch.hpp>

namespace names = vtkHeliosArrayNames;

namespace
{

vtkSmartPointer<vtkPolyData> MakePulses()
{
  auto pulses = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(500000.25, -1.5, 100.00004);
  points->InsertNextPoint(1.0, 2.0, 3.0);
  pulses->SetPoints(points);
  vtkNew<vtkDoubleArray> directions;
  directions->SetName(names::Direction);
  directions->SetNumberOfComponents(3);
  directions->InsertNextTuple3(0.6, 0.0, -0.8);
  directions->InsertNextTuple3(1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0);
  vtkPointData* data = pulses->GetPointData();
  data->AddArray(directions);
  helios::AddColumn<vtkDoubleArray>(
    data, names::GpsTime, 2, [](vtkIdType i) { return i == 0 ? 0.0 : 1.5000000025; });
  helios::AddColumn<vtkTypeInt64Array>(
    data, names::PulseIds, 2, [](vtkIdType i) { return 5000000000 + i; });
  helios::AddColumn<vtkIntArray>(data, names::ChannelIds, 2, [](vtkIdType i) { return 7 * i; });
  return pulses;
}

} // namespace

TEST_CASE("PulseTextWriter: columns", "[PulseTextWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "pulse.txt";
  vtkNew<vtkHeliosPulseTextWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(MakePulses()) && writer->Close()));
  const auto rows = helios::ReadRows(path);
  REQUIRE(rows.size() == 2);
  CHECK(rows[0] ==
    std::vector<std::string>{ "500000.2500", "-1.5000", "100.0000", "0.600000000", "0.000000000",
      "-0.800000000", "0.0000", "5000000000", "0" });
  CHECK(rows[1] ==
    std::vector<std::string>{ "1.0000", "2.0000", "3.0000", "0.333333333", "0.666666667",
      "0.666666667", "1500000002.5000", "5000000001", "7" });
}

TEST_CASE("PulseTextWriter: bad input is an error", "[PulseTextWriter]")
{
  const helios::TempFolder folder;
  vtkNew<vtkHeliosPulseTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName((folder / "pulse.txt").c_str());
  CHECK_FALSE(writer->Write(MakePulses()));
  CHECK(log->HasError("is not open"));
  REQUIRE(writer->Open());
  vtkNew<vtkPolyData> bare;
  CHECK(writer->Write(bare));
  for (const char* name : { names::Direction, names::GpsTime, names::PulseIds, names::ChannelIds })
  {
    const auto pulses = MakePulses();
    pulses->GetPointData()->RemoveArray(name);
    CHECK_FALSE(writer->Write(pulses));
    CHECK(log->HasError(
      std::string("no array ") + name + "; the pulses of a vtkHeliosScanner have it"));
  }
  CHECK(writer->Close());
}
