// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Written files are read back by the VTK readers and by the vtkHelios reader.
#include "heliosTempFolder.h"
#include "heliosWaveformTesting.h"
#include "vtkHeliosWaveformXMLReader.h"
#include "vtkHeliosWaveformXMLWriter.h"

#include <vtkExecutive.h>
#include <vtkXMLPTableReader.h>
#include <vtkXMLTableReader.h>

#include <catch2/catch.hpp>

#include <algorithm>

namespace names = vtkHeliosArrayNames;
namespace fs = std::filesystem;

namespace
{

template <typename ReaderT>
struct Reading
{
  vtkNew<ReaderT> Reader;
  vtkSmartPointer<helios::ErrorObserver> Log = helios::WatchErrors(Reader);
  vtkSmartPointer<helios::ErrorObserver> Quiet = helios::WatchErrors(Reader->GetExecutive());

  explicit Reading(const std::string& path) { this->Reader->SetFileName(path.c_str()); }

  vtkTable* Read(int piece = 0, int count = 1)
  {
    this->Reader->UpdatePiece(piece, count, 0);
    CHECK(this->Log->Errors.empty());
    CHECK(this->Log->Warnings.empty());
    return this->Reader->GetOutput();
  }
};

/// Counts values that differ from those written, from a tuple on; Offset is shifted.
vtkIdType CountDifferences(
  vtkFieldData* read, vtkIdType from, vtkFieldData* written, double shift = 0.0)
{
  vtkIdType wrong = 0;
  REQUIRE(read->GetNumberOfArrays() == written->GetNumberOfArrays());
  for (int i = 0; i < written->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* y = written->GetArray(i);
    vtkDataArray* x = read->GetArray(y->GetName());
    INFO(y->GetName());
    REQUIRE(x);
    REQUIRE(x->GetNumberOfComponents() == y->GetNumberOfComponents());
    REQUIRE(x->GetNumberOfTuples() >= from + y->GetNumberOfTuples());
    CHECK(x->GetDataTypeSize() == y->GetDataTypeSize());
    const double behind = std::string(y->GetName()) == names::Offset ? shift : 0.0;
    for (vtkIdType t = 0; t < y->GetNumberOfTuples(); ++t)
    {
      for (int c = 0; c < y->GetNumberOfComponents(); ++c)
      {
        wrong += x->GetComponent(from + t, c) == y->GetComponent(t, c) + behind ? 0 : 1;
      }
    }
  }
  return wrong;
}

void CheckSame(vtkTable* read, vtkTable* written)
{
  REQUIRE(read->GetNumberOfRows() == written->GetNumberOfRows());
  CHECK(CountDifferences(read->GetRowData(), 0, written->GetRowData()) == 0);
  CHECK(CountDifferences(read->GetFieldData(), 0, written->GetFieldData()) == 0);
}

vtkIdType CountSamples(vtkTable* table)
{
  return table->GetFieldData()->GetArray(names::Samples)->GetNumberOfTuples();
}

/// A folder with the waveforms of three blocks, the second one empty.
struct WrittenRun
{
  helios::TempFolder Folder;
  vtkSmartPointer<vtkTable> First = helios::MakeWaveforms(20000);
  vtkSmartPointer<vtkTable> Last = helios::MakeWaveforms(7);
  vtkNew<vtkHeliosWaveformXMLWriter> Writer;
  vtkSmartPointer<helios::ErrorObserver> Log = helios::WatchErrors(Writer);
  std::string Path = Folder / "run/leg000_fullwave.pvtt";

  WrittenRun()
  {
    this->Last->GetFieldData()->GetArray(names::Samples)->SetComponent(3, 0, 0.1F);
    for (const auto& table : { this->First, this->Last })
    {
      helios::AddColumn<vtkDoubleArray>(
        table->GetFieldData(), names::PulseLength, 1, [](vtkIdType) { return 4.5; });
    }
    this->Writer->SetFileName(this->Path.c_str());
    REQUIRE(this->Writer->Open());
    REQUIRE(this->Writer->Write(this->First));
    vtkNew<vtkTable> empty;
    REQUIRE(this->Writer->Write(empty));
    REQUIRE(this->Writer->Write(this->Last));
  }

  std::string operator/(const std::string& name) const { return this->Folder / ("run/" + name); }
};

} // namespace

TEST_CASE("WaveformXMLWriter: VTK's readers restore every piece bit for bit", "[WaveformXMLWriter]")
{
  WrittenRun run;
  CHECK(fs::exists(run.Path + ".part"));
  CHECK_FALSE(fs::exists(run.Path));
  REQUIRE(run.Writer->Close());
  CHECK(run.Writer->GetNumberOfPieces() == 2);
  CHECK(run.Writer->GetNumberOfRecords() == 20007);
  std::vector<std::string> files;
  vtkIdType bytes = 0;
  for (const auto& entry : fs::directory_iterator(run.Folder / "run"))
  {
    files.push_back(entry.path().filename().string());
    bytes += entry.path().extension() == ".vtt" ? static_cast<vtkIdType>(entry.file_size()) : 0;
  }
  std::sort(files.begin(), files.end());
  CHECK(files ==
    std::vector<std::string>{
      "leg000_fullwave.pvtt", "leg000_fullwave_0000.vtt", "leg000_fullwave_0001.vtt" });
  CHECK(run.Writer->GetNumberOfBytes() == bytes);

  CheckSame(Reading<vtkXMLTableReader>(run / "leg000_fullwave_0000.vtt").Read(), run.First);
  fs::rename(run.Folder / "run", run.Folder / "moved"); // piece names have no folder
  Reading<vtkXMLPTableReader> index(run.Folder / "moved/leg000_fullwave.pvtt");
  index.Reader->UpdateInformation();
  REQUIRE(index.Reader->GetNumberOfPieces() == 2);
  CheckSame(index.Read(0, 2), run.First);
  CheckSame(index.Read(1, 2), run.Last);
}

TEST_CASE("WaveformXMLWriter: pieces, and all of them as one table", "[WaveformXMLWriter]")
{
  WrittenRun run;
  REQUIRE(run.Writer->Close());
  Reading<vtkHeliosWaveformXMLReader> all(run.Path);
  vtkTable* table = all.Read();
  CHECK(all.Reader->GetNumberOfPieces() == 2);
  const vtkIdType samples = CountSamples(run.First);
  REQUIRE(table->GetNumberOfRows() == 20007);
  CHECK(CountSamples(table) == samples + CountSamples(run.Last));
  CHECK(CountDifferences(table->GetRowData(), 0, run.First->GetRowData()) == 0);
  CHECK(CountDifferences(
          table->GetRowData(), 20000, run.Last->GetRowData(), static_cast<double>(samples)) == 0);
  vtkDataArray* joined = table->GetFieldData()->GetArray(names::Samples);
  vtkDataArray* last = run.Last->GetFieldData()->GetArray(names::Samples);
  vtkIdType wrong = 0;
  for (vtkIdType i = 0; i < last->GetNumberOfTuples(); ++i)
  {
    wrong += joined->GetComponent(samples + i, 0) == last->GetComponent(i, 0) ? 0 : 1;
  }
  CHECK(wrong == 0);
  vtkDataArray* length = table->GetFieldData()->GetArray(names::PulseLength);
  REQUIRE(length);
  CHECK(length->GetNumberOfTuples() == 1);
  CHECK(length->GetComponent(0, 0) == 4.5);

  CheckSame(all.Read(0, 2), run.First);
  CheckSame(all.Read(1, 2), run.Last);
  CHECK(all.Read(0, 3)->GetNumberOfRows() == 0); // more pieces than in the file
  CheckSame(all.Read(1, 3), run.First);
  CheckSame(all.Read(2, 3), run.Last);
  CheckSame(Reading<vtkHeliosWaveformXMLReader>(run / "leg000_fullwave_0001.vtt").Read(), run.Last);
}

TEST_CASE("WaveformXMLWriter: an abandoned index is readable", "[WaveformXMLWriter]")
{
  WrittenRun run;
  REQUIRE(run.Writer->Abandon());
  CHECK_FALSE(fs::exists(run.Path));
  CHECK(Reading<vtkHeliosWaveformXMLReader>(run.Path + ".part").Read()->GetNumberOfRows() == 20007);
  CheckSame(Reading<vtkXMLPTableReader>(run.Path + ".part").Read(1, 2), run.Last);
}

TEST_CASE("WaveformXMLWriter: no waveforms: an index without pieces", "[WaveformXMLWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "fullwave.pvtt";
  vtkNew<vtkHeliosWaveformXMLWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Close()));
  CHECK(Reading<vtkXMLPTableReader>(path).Read()->GetNumberOfRows() == 0);
  CHECK(Reading<vtkHeliosWaveformXMLReader>(path).Read()->GetNumberOfRows() == 0);
}

TEST_CASE("WaveformXMLWriter: bad input is an error", "[WaveformXMLWriter]")
{
  WrittenRun run;
  const auto table = helios::MakeWaveforms(3);
  SECTION("no table")
  {
    CHECK_FALSE(run.Writer->Write(helios::MakeEchoes(1)));
    CHECK(run.Log->HasError("a block is vtkPolyData, not vtkTable; write the waveforms"));
  }
  SECTION("one column too few")
  {
    table->GetRowData()->RemoveArray(names::StartTime);
    CHECK_FALSE(run.Writer->Write(table));
    CHECK(run.Log->HasError("the block has no array StartTime; write the waveforms of"));
  }
  SECTION("a column of the wrong form")
  {
    helios::AddColumn<vtkDoubleArray>(
      table->GetRowData(), names::Origin, 3, [](vtkIdType) { return 0; });
    CHECK_FALSE(run.Writer->Write(table));
    CHECK(run.Log->HasError("the block has an array Origin of 3 x 1 values, not 3 x 3"));
  }
  SECTION("ids that are not integers")
  {
    helios::AddColumn<vtkDoubleArray>(
      table->GetRowData(), names::PulseIds, 3, [](vtkIdType) { return 0; });
    CHECK_FALSE(run.Writer->Write(table));
    CHECK(run.Log->HasError("the block has an array PulseIds of double; it must hold integers"));
  }
  SECTION("other columns than in earlier blocks")
  {
    helios::AddColumn<vtkIntArray>(
      table->GetRowData(), names::LegIds, 3, [](vtkIdType) { return 0; });
    CHECK_FALSE(run.Writer->Write(table));
    CHECK(run.Log->HasError("a block has other arrays than those before"));
  }
  CHECK(run.Writer->Write(run.Last)); // another block is accepted
  CHECK(run.Writer->Close());
  CHECK(Reading<vtkHeliosWaveformXMLReader>(run.Path).Read()->GetNumberOfRows() == 20014);
}

TEST_CASE("WaveformXMLReader: bad input is an error", "[WaveformXMLReader]")
{
  WrittenRun run;
  REQUIRE(run.Writer->Close());
  Reading<vtkHeliosWaveformXMLReader> reading(run.Path);
  const auto failsWith = [&reading](const std::string& part)
  {
    reading.Reader->Modified();
    reading.Reader->Update();
    return reading.Log->HasError(part) && reading.Reader->GetOutput()->GetNumberOfRows() == 0;
  };
  SECTION("no name")
  {
    reading.Reader->SetFileName(nullptr);
    CHECK(failsWith("FileName is not set; give a file of waveforms"));
  }
  SECTION("no file")
  {
    reading.Reader->SetFileName((run / "none.pvtt").c_str());
    CHECK(failsWith("none.pvtt: there is no such file; give a file of waveforms"));
  }
  SECTION("no XML")
  {
    std::ofstream(run / "text.txt") << "1 2 3\n";
    reading.Reader->SetFileName((run / "text.txt").c_str());
    CHECK(failsWith("text.txt: is not a VTK XML file of tables; give a file of waveforms"));
  }
  SECTION("a missing piece")
  {
    fs::remove(run / "leg000_fullwave_0001.vtt");
    CHECK(failsWith(
      "leg000_fullwave_0001.vtt: the piece cannot be read; is it missing or incomplete?"));
  }
  SECTION("a truncated piece")
  {
    fs::resize_file(run / "leg000_fullwave_0000.vtt", 5000);
    CHECK(failsWith(
      "leg000_fullwave_0000.vtt: the piece cannot be read; is it missing or incomplete?"));
  }
  SECTION("a piece of another file")
  {
    vtkNew<vtkHeliosWaveformXMLWriter> writer;
    writer->SetFileName((run / "leg000_fullwave.pvtt").c_str());
    const auto table = helios::MakeWaveforms(3);
    helios::AddColumn<vtkIntArray>(
      table->GetRowData(), names::LegIds, 3, [](vtkIdType) { return 0; });
    REQUIRE((writer->Open() && writer->Write(table) && writer->Abandon()));
    CHECK(failsWith("leg000_fullwave_0001.vtt: the piece has other columns than"));
  }
}
