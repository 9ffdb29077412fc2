// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTempFolder.h"
#include "heliosWaveformTesting.h"
#include "vtkHeliosWaveformTextWriter.h"

#include <catch2/catch.hpp>

namespace names = vtkHeliosArrayNames;

TEST_CASE("WaveformTextWriter: columns of a line", "[WaveformTextWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "fullwave.txt";
  vtkNew<vtkHeliosWaveformTextWriter> writer;
  writer->SetFileName(path.c_str());
  const auto table = helios::MakeWaveforms(3);
  table->GetFieldData()->GetArray(names::Samples)->SetComponent(3, 0, 0.5); // 5e8 nW
  REQUIRE((writer->Open() && writer->Write(table) && writer->Close()));
  const std::string text = helios::ReadText(path);
  CHECK(text.substr(0, text.find('\n')) ==
    "40 500000.0000 0.0000 100.5000 1.000000000 0.000000000 0.000000001 667.1250 667.1250 "
    "0.000000000 0.000000000");
  CHECK(text.find("\n46 500000.6667 -2.0000 100.5000 -0.416146837 0.909297427 0.000000001 669.1250 "
                  "669.6250 0.500000000 500000000.000000000 ") != std::string::npos);
}

TEST_CASE("WaveformTextWriter: an independent reader restores every value", "[WaveformTextWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "fullwave.txt";
  constexpr vtkIdType count = 5000;
  const auto table = helios::MakeWaveforms(count);
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  vtkNew<vtkHeliosWaveformTextWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(table) && writer->Write(table) && writer->Close()));
  CHECK(writer->GetNumberOfRecords() == 2 * count);

  std::ifstream file(path);
  vtkIdType wrong = 0, next = 0;
  const auto read = [&file, &wrong](double written, int decimals)
  {
    double value;
    REQUIRE(file >> value);
    wrong += std::abs(value - written) <= helios::RoundingOf(decimals, written) ? 0 : 1;
  };
  for (vtkIdType line = 0; line < 2 * count; ++line)
  {
    const vtkIdType i = line % count;
    const auto x = static_cast<double>(i);
    next = i == 0 ? 0 : next;
    read(static_cast<double>(40 + 3 * i), 0);
    read(500000 + x / 3, 4);
    read(-x, 4);
    read(100.5, 4);
    read(std::cos(x), 9);
    read(std::sin(x), 9);
    read(1e-9, 9);
    read(667.125 + x, 4);
    read(667.125 + x + 0.25 * static_cast<double>(i % 40), 4);
    read(0.25 * x, 9);
    for (vtkIdType k = 0; k < 1 + i % 40; ++k)
    {
      read(1e9 * samples->GetComponent(next++, 0), 9);
    }
    CHECK(file.get() == '\n');
  }
  CHECK(wrong == 0);
  CHECK(file.peek() == std::ifstream::traits_type::eof());
}

TEST_CASE("WaveformTextWriter: bad input is an error", "[WaveformTextWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "fullwave.txt";
  vtkNew<vtkHeliosWaveformTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  REQUIRE(writer->Open());
  const auto table = helios::MakeWaveforms(3);
  SECTION("no table")
  {
    CHECK_FALSE(writer->Write(helios::MakeEchoes(1)));
    CHECK(log->HasError("a block is vtkPolyData, not vtkTable; write the waveforms"));
    CHECK(log->HasError("GenerateWaveforms on"));
  }
  SECTION("no samples")
  {
    table->GetFieldData()->RemoveArray(names::Samples);
    CHECK_FALSE(writer->Write(table));
    CHECK(log->HasError("the block has no array Samples; write the waveforms of vtkHeliosScanner"));
  }
  SECTION("one column too few")
  {
    table->GetRowData()->RemoveArray(names::StartTime);
    CHECK_FALSE(writer->Write(table));
    CHECK(log->HasError("no array StartTime"));
  }
  SECTION("samples that are not there")
  {
    const auto [offset, count] = GENERATE(std::pair(5, 2), std::pair(-1, 1), std::pair(6, 1),
      std::pair(0, 0), std::pair(0, -1), std::pair(3, 4));
    table->GetRowData()->GetArray(names::Offset)->SetComponent(1, 0, offset);
    table->GetRowData()->GetArray(names::Count)->SetComponent(1, 0, count);
    CHECK_FALSE(writer->Write(table));
    CHECK(log->HasError("the block has a row 1 with Offset " + std::to_string(offset) +
      " and Count " + std::to_string(count) + ", not within its 6 Samples"));
  }
  SECTION("a sample that is not finite leaves out its waveform")
  {
    table->GetFieldData()->GetArray(names::Samples)->SetComponent(1, 0, vtkMath::Inf());
    CHECK(writer->Write(table));
    CHECK(log->HasWarning("1 of 3 records"));
    CHECK(writer->GetNumberOfRecords() == 2);
  }
  SECTION("an empty table is an error")
  {
    vtkNew<vtkTable> empty;
    CHECK(writer->Write(empty));
    CHECK(log->Errors.empty());
  }
}
