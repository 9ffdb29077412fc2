// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Files of VTK are read; damaged files give an error that names the file.
#include "heliosMutation.h"
#include "heliosVtpTesting.h"
#include "heliosWaveformTesting.h"
#include "vtkHeliosPointXMLReader.h"
#include "vtkHeliosPointXMLWriter.h"
#include "vtkHeliosWaveformXMLReader.h"

#include <vtkCellArray.h>
#include <vtkExecutive.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLTableWriter.h>

#include <catch2/catch.hpp>

namespace
{

template <typename ReaderT>
struct Reading
{
  vtkNew<ReaderT> Reader;
  vtkSmartPointer<helios::ErrorObserver> Log = helios::WatchErrors(Reader);
  vtkSmartPointer<helios::ErrorObserver> Quiet = helios::WatchErrors(Reader->GetExecutive());

  explicit Reading(const std::string& path) { this->Reader->SetFileName(path.c_str()); }

  /// Whether reading ends without an error.
  bool Read(int piece = 0, int count = 1)
  {
    this->Log->Errors.clear();
    this->Reader->Modified();
    this->Reader->UpdatePiece(piece, count, 0);
    return this->Log->Errors.empty();
  }
};

using PointReading = Reading<vtkHeliosPointXMLReader>;

/// A .vtp with ascii values, of which one part is replaced.
struct DamagedFile
{
  helios::TempFolder Folder;
  std::string Path = Folder / "a.vtp";
  std::string Whole =
    helios::WriteAllForms<vtkXMLPolyDataWriter>(helios::MakeCloud(20).Get(), Path)[0];
  PointReading Reading{ Path };

  bool FailsWith(const std::string& from, const std::string& to, const std::string& message)
  {
    const std::string text = helios::Replace(this->Whole, from, to);
    REQUIRE_FALSE(text.empty());
    helios::WriteBytes(this->Path, text);
    const bool isGood = this->Reading.Read();
    INFO(this->Reading.Log->Errors);
    CHECK(this->Reading.Log->HasError(this->Path + ": " + message));
    return !isGood && this->Reading.Reader->GetOutput()->GetNumberOfPoints() == 0;
  }
};

} // namespace

TEST_CASE("PointXMLReader: all encodings that VTK writes", "[PointXMLReader]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "a.vtp";
  const auto cloud = helios::MakeCloud(1000);
  PointReading reading(path);
  for (const std::string& file : helios::WriteAllForms<vtkXMLPolyDataWriter>(cloud.Get(), path))
  {
    helios::WriteBytes(path, file);
    REQUIRE(reading.Read());
    vtkPolyData* read = reading.Reader->GetOutput();
    REQUIRE(reading.Reader->GetNumberOfPoints() == 1000);
    REQUIRE(read->GetNumberOfPoints() == 1000);
    REQUIRE(read->GetNumberOfVerts() == 1000);
    REQUIRE(read->GetNumberOfPolys() == 1);
    REQUIRE(read->GetPoint(999)[1] == Approx(cloud->GetPoint(999)[1]).epsilon(1e-10));
    REQUIRE(
      read->GetPointData()->GetNumberOfArrays() == cloud->GetPointData()->GetNumberOfArrays());
    REQUIRE(read->GetFieldData()->GetAbstractArray("CRS")->GetVariantValue(1).ToString() ==
      "another text");
  }
}

TEST_CASE("PointXMLReader: one, several or all pieces", "[PointXMLReader]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "a.pvtp";
  vtkNew<vtkHeliosPointXMLWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(5)) &&
    writer->Write(helios::MakeEchoes(7)) && writer->Close()));
  PointReading reading(path);
  REQUIRE(reading.Read());
  CHECK(reading.Reader->GetNumberOfPieces() == 2);
  CHECK(reading.Reader->GetOutput()->GetNumberOfPoints() == 12);
  CHECK(reading.Reader->GetOutput()->GetPoint(11)[0] == 500000 + 0.25 * 6);
  REQUIRE(reading.Read(1, 2));
  CHECK(reading.Reader->GetOutput()->GetNumberOfPoints() == 7);
  REQUIRE(reading.Read(0, 3)); // more pieces than in the file
  CHECK(reading.Reader->GetOutput()->GetNumberOfPoints() == 0);

  helios::WriteBytes(folder / "a_0001.vtp", helios::ReadText(folder / "a_0001.vtp").substr(0, 900));
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("a_0001.vtp: "));
  auto other = helios::MakeEchoes(7);
  other->GetPointData()->RemoveArray(vtkHeliosArrayNames::GpsTime);
  vtkNew<vtkXMLPolyDataWriter> piece;
  piece->SetInputData(other);
  piece->SetFileName((folder / "a_0001.vtp").c_str());
  piece->Write();
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("a_0001.vtp: has other arrays than the pieces before it"));
}

TEST_CASE("PointXMLReader: bad input is an error", "[PointXMLReader]")
{
  DamagedFile file;
  const std::string deep = "<a>";
  std::string nested;
  for (int i = 0; i < 100000; ++i)
  {
    nested += deep;
  }
  CHECK(file.FailsWith("<Piece", nested + "<Piece", "has elements nested deeper than 32"));
  CHECK(file.FailsWith("</VTKFile>", "", "is not complete XML; copy or write the file again"));
  CHECK(file.FailsWith("type=\"PolyData\"", "type=\"Table\"", "has type=\"Table\", not PolyData"));
  CHECK(file.FailsWith("NumberOfPoints=\"20", "NumberOfPoints=\"2x",
    "NumberOfPoints=\"2x\" of Piece is not valid: expected 0 to "));
  CHECK(file.FailsWith("NumberOfPoints=\"20", "NumberOfPoints=\"9223372036854775807",
    "NumberOfPoints=\"9223372036854775807\" of Piece is not valid"));
  CHECK(file.FailsWith("NumberOfPoints=\"20", "NumberOfPoints=\"70000000",
    "its arrays need more than 500 MB of memory, too much for a file of"));
  CHECK(file.FailsWith("NumberOfPoints=\"20", "NumberOfPoints=\"200000",
    "the array GpsTime has more values than the file has room for; copy or write the file again"));
  CHECK(file.FailsWith("NumberOfPoints=\"20", "NumberOfPoints=\"21", "cannot be read: VTK's"));
  CHECK(file.FailsWith("Name=\"PulseIds\"", "Name=\"GpsTime\"",
    "has an array of PointData named twice: GpsTime; write the file again"));
  CHECK(file.FailsWith("Name=\"PulseIds\"", "", "has an array of PointData without a name"));
  CHECK(file.FailsWith("type=\"Float64\" Name=\"GpsTime\"", "type=\"String\" Name=\"GpsTime\"",
    "the array GpsTime does not have the 20 strings of its counts; write the file again"));
  CHECK(file.FailsWith("type=\"Float64\" Name=\"GpsTime\"", "type=\"Real\" Name=\"GpsTime\"",
    "the array GpsTime is a DataArray with type=\"Real\", which is not known"));
  CHECK(file.FailsWith("NumberOfComponents=\"3\"", "NumberOfComponents=\"0\"", "the array "));
  CHECK(file.FailsWith("NumberOfVerts=\"20", "NumberOfVerts=\"25", ""));
  CHECK(file.FailsWith("Name=\"connectivity\"", "Name=\"offsets\"",
    "has Verts with arrays other than connectivity and offsets; write the file again"));
  CHECK(
    file.FailsWith("<Points>", "<Points/><Points>", "has a piece with the element Points twice"));
  file.Reading.Reader->SetFileName((file.Folder / "none.vtp").c_str());
  CHECK_FALSE(file.Reading.Read());
  CHECK(file.Reading.Log->HasError("none.vtp: is not a file that can be read; check its name"));
  file.Reading.Reader->SetFileName(nullptr);
  CHECK_FALSE(file.Reading.Read());
  CHECK(file.Reading.Log->HasError("FileName is not set; give a file of points"));
}

TEST_CASE("PointXMLReader: cells of missing points", "[PointXMLReader]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "a.vtp";
  const auto cloud = helios::MakeEchoes(3);
  vtkNew<vtkCellArray> triangle;
  triangle->InsertNextCell({ 0, 1, 3 });
  cloud->SetPolys(triangle);
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(cloud);
  writer->SetFileName(path.c_str());
  writer->Write();
  PointReading reading(path);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(path + ": has cells with points that do not exist"));
}

TEST_CASE("PointXMLReader: damaged files give an error or points", "[PointXMLReader][mutation]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "a.vtp";
  const auto files = helios::WriteAllForms<vtkXMLPolyDataWriter>(helios::MakeCloud(20).Get(), path);
  PointReading reading(path);
  helios::Mutator mutate(20262);
  int errorCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    helios::WriteBytes(path, mutate(files[static_cast<std::size_t>(i) % files.size()]));
    INFO("file " << i);
    const bool isGood = reading.Read();
    errorCount += isGood ? 0 : 1;
    REQUIRE((isGood || reading.Log->HasError(path + ": ")));
  }
  CHECK(errorCount > 20);
}

TEST_CASE(
  "WaveformXMLReader: damaged files give an error or waveforms", "[WaveformXMLReader][mutation]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "a.vtt";
  const auto files =
    helios::WriteAllForms<vtkXMLTableWriter>(helios::MakeWaveforms(20).Get(), path);
  Reading<vtkHeliosWaveformXMLReader> reading(path);
  for (const std::string& file : files)
  {
    helios::WriteBytes(path, file);
    REQUIRE(reading.Read());
    REQUIRE(reading.Reader->GetOutput()->GetNumberOfRows() == 20);
  }
  helios::Mutator mutate(20263);
  int errorCount = 0;
  for (int i = 0; i < helios::GetNumberOfMutations(); ++i)
  {
    helios::WriteBytes(path, mutate(files[static_cast<std::size_t>(i) % files.size()]));
    INFO("file " << i);
    const bool isGood = reading.Read();
    errorCount += isGood ? 0 : 1;
    REQUIRE((isGood || reading.Log->HasError(path + ": ")));
  }
  CHECK(errorCount > 20);
}
