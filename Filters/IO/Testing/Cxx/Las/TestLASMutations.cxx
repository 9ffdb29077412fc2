// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged LAS files give an error or complete points, in any number of pieces.
#include "heliosLasTesting.h"
#include "heliosMutation.h"
#include "heliosWaveformTable.h"
#include "heliosWaveformTesting.h"
#include "vtkHeliosLASWriter.h"

#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace
{

/// Finite points, and the same number of tuples in all arrays.
bool IsWhole(vtkPolyData* cloud)
{
  const vtkIdType count = cloud->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* x = cloud->GetPoint(i);
    if (!std::isfinite(x[0] + x[1] + x[2]))
    {
      return false;
    }
  }
  vtkPointData* data = cloud->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    if (data->GetArray(i)->GetNumberOfTuples() != count)
    {
      return false;
    }
  }
  return true;
}

} // namespace

TEST_CASE("LASMutations: damaged files give an error or points", "[LASMutations][mutation]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "a.las";
  const auto echoes = helios::MakeLasEchoes(20);
  helios::SetCrs(echoes, "EPSG:25832");
  vtkNew<vtkHeliosLASWriter> writer;
  writer->SetFileName(path.c_str());
  const bool isCompressed = GENERATE(false, true);
  writer->SetWriteCompressed(isCompressed);
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));
  const std::string whole = helios::ReadText(path);
  // the header and the records are a small part of the file: most damage is done there
  const std::size_t head = 375 + 54 + (isCompressed ? 60 : 200);
  helios::Mutator mutate(20251);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const bool isHead = i % 2 == 0;
    const std::string bytes =
      isHead ? mutate(whole.substr(0, head)) + whole.substr(head) : mutate(whole);
    std::ofstream(path, std::ios::binary) << bytes;
    helios::LasReading reading(path);
    INFO("file " << i);
    const bool isGood = reading.Read();
    const vtkIdType count = reading.CountPoints();
    (isGood ? goodCount : errorCount) += 1;
    REQUIRE((isGood || reading.Log->HasError(path + ": ")));
    REQUIRE((isGood || count == 0));
    REQUIRE(IsWhole(reading.Cloud()));
    vtkIdType sum = 0;
    for (int piece = 0; piece < 3; ++piece)
    {
      REQUIRE(reading.Read(piece, 3) == isGood);
      REQUIRE(IsWhole(reading.Cloud()));
      sum += reading.CountPoints();
    }
    REQUIRE(sum == count);
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > (isCompressed ? 3 : 20)); // little damage of compressed points is harmless
}

TEST_CASE("LASMutations: damaged waveforms give an error or waveforms", "[LASMutations][mutation]")
{
  namespace names = vtkHeliosArrayNames;
  const helios::TempFolder folder;
  const std::string path = folder / "a.las";
  const std::string packetsPath = folder / "a.wdp";
  const auto waveforms = helios::MakeWaveforms(20);
  const auto echoes = helios::MakeLasEchoes(20);
  vtkDataArray* pulses = waveforms->GetRowData()->GetArray(names::PulseIds);
  helios::AddColumn<vtkTypeInt64Array>(echoes->GetPointData(), names::WaveformIds, 20,
    [pulses](vtkIdType i) { return pulses->GetTuple1(i); });
  vtkNew<vtkHeliosLASWriter> writer;
  writer->SetFileName(path.c_str());
  writer->WriteWaveformsOn();
  writer->WriteExtraBytesOff();
  writer->SetWaveforms(waveforms);
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));
  const std::string whole = helios::ReadText(path);
  const std::string packets = helios::ReadText(packetsPath);
  const std::size_t points = whole.size() - 20 * 59; // descriptors of a few bytes, and the points
  helios::Mutator mutate(20252);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const std::size_t from = i % 3 == 0 ? points : i % 3 == 1 ? 375 : whole.size();
    const std::size_t end = i % 3 == 1 ? 375 + 2000 : whole.size();
    const std::string damaged = from < end ? mutate(whole.substr(from, end - from)) : std::string();
    std::ofstream(path, std::ios::binary) << whole.substr(0, from) << damaged << whole.substr(end);
    std::ofstream(packetsPath, std::ios::binary) << (i % 3 == 2 ? mutate(packets) : packets);
    helios::LasReading reading(path);
    reading.Reader->ReadWaveformsOn();
    INFO("file " << i);
    const bool isGood = reading.Read();
    (isGood ? goodCount : errorCount) += 1;
    auto* table = vtkTable::SafeDownCast(reading.Reader->GetOutputDataObject(1));
    REQUIRE(table);
    REQUIRE(IsWhole(reading.Cloud()));
    REQUIRE((isGood || reading.Log->HasError(path) || reading.Log->HasError(packetsPath)));
    REQUIRE((isGood || reading.CountPoints() + table->GetNumberOfRows() == 0));
    helios::WaveformTable taken;
    REQUIRE(taken.Set(table).IsOk());
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 20);
}
