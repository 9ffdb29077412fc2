// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Damaged VTK XML files of waveforms give an error or complete waveforms.
#include "heliosMutation.h"
#include "heliosTempFolder.h"
#include "heliosWaveformTesting.h"
#include "vtkHeliosWaveformXMLReader.h"
#include "vtkHeliosWaveformXMLWriter.h"

#include <vtkExecutive.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

namespace names = vtkHeliosArrayNames;

namespace
{

/// Two pieces and their index.
struct Files
{
  helios::TempFolder Folder;
  std::string Names[2] = { "wave.pvtt", "wave_0000.vtt" };
  std::string Bytes[2];

  Files()
  {
    vtkNew<vtkHeliosWaveformXMLWriter> writer;
    writer->SetFileName((this->Folder / this->Names[0]).c_str());
    REQUIRE(writer->Open());
    REQUIRE(writer->Write(helios::MakeWaveforms(12)));
    REQUIRE(writer->Write(helios::MakeWaveforms(3)));
    REQUIRE(writer->Close());
    for (int i = 0; i < 2; ++i)
    {
      std::ifstream file(this->Folder / this->Names[i], std::ios::binary);
      std::ostringstream text;
      text << file.rdbuf();
      this->Bytes[i] = text.str();
      REQUIRE(this->Bytes[i].size() > 100);
    }
  }

  void Write(int i, const std::string& bytes) const
  {
    std::ofstream(this->Folder / this->Names[i], std::ios::binary) << bytes;
  }
};

/// Every row has its own samples, which exist and are finite.
bool IsWhole(vtkTable* table)
{
  const vtkIdType rows = table->GetNumberOfRows();
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  auto* offsets = vtkDataArray::SafeDownCast(table->GetColumnByName(names::Offset));
  auto* counts = vtkDataArray::SafeDownCast(table->GetColumnByName(names::Count));
  bool isWhole = rows == 0 || (samples && offsets && counts);
  for (vtkIdType i = 0; isWhole && i < rows; ++i)
  {
    const double first = offsets->GetTuple1(i);
    const double count = counts->GetTuple1(i);
    isWhole = first >= 0.0 && count >= 0.0 &&
      first + count <= static_cast<double>(samples->GetNumberOfTuples());
  }
  return isWhole;
}

} // namespace

TEST_CASE("WaveformXMLMutations: impossible values are refused", "[WaveformXMLReader]")
{
  const Files files;
  auto table = helios::MakeWaveforms(3);
  vtkDataArray* samples = table->GetFieldData()->GetArray(names::Samples);
  auto* sizes = vtkDataArray::SafeDownCast(table->GetColumnByName(names::BinSize));
  vtkNew<vtkHeliosWaveformXMLWriter> writer;
  writer->SetFileName((files.Folder / "odd.pvtt").c_str());
  vtkNew<vtkHeliosWaveformXMLReader> reader;
  const auto log = helios::WatchErrors(reader);
  const auto quiet = helios::WatchErrors(reader->GetExecutive());
  reader->SetFileName((files.Folder / "odd.pvtt").c_str());
  const auto fails = [&](vtkDataArray* array, vtkIdType row, double value, const char* message)
  {
    const double before = array->GetComponent(row, 0);
    array->SetComponent(row, 0, value);
    REQUIRE((writer->Open() && writer->Write(table) && writer->Close()));
    array->SetComponent(row, 0, before);
    log->Clear();
    reader->Modified();
    reader->Update();
    return log->HasError(message);
  };
  CHECK(fails(samples, 4, std::nan(""), "has an array Samples whose value 4 is not finite"));
  CHECK(fails(sizes, 1, 0.0, "has a row 1 whose BinSize is not above 0 ns"));
  CHECK(fails(sizes, 2, -0.25, "has a row 2 whose BinSize is not above 0 ns"));
}

TEST_CASE("WaveformXMLMutations: damaged files give an error or waveforms",
  "[WaveformXMLMutations][mutation]")
{
  const Files files;
  helios::Mutator mutate(20202);
  int errorCount = 0;
  int goodCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    const int which = i % 2;
    files.Write(0, files.Bytes[0]);
    files.Write(1, files.Bytes[1]);
    files.Write(which, mutate(files.Bytes[which]));
    INFO("case " << i << ", " << files.Names[which]);
    vtkNew<vtkHeliosWaveformXMLReader> reader;
    const auto log = helios::WatchErrors(reader);
    const auto quiet = helios::WatchErrors(reader->GetExecutive());
    reader->SetFileName((files.Folder / files.Names[i / 2 % 2 == 0 ? 0 : which]).c_str());
    reader->Update();
    const bool isGood = log->Errors.empty() && quiet->Errors.empty();
    (isGood ? goodCount : errorCount) += 1;
    REQUIRE((!isGood || IsWhole(reader->GetOutput())));
  }
  CHECK(errorCount > 20);
  CHECK(goodCount > 5);
}
