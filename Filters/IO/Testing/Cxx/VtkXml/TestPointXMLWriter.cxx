// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosTempFolder.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosPointXMLWriter.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkXMLPPolyDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include <catch2/catch.hpp>

#include <algorithm>

namespace names = vtkHeliosArrayNames;
namespace fs = std::filesystem;

namespace
{

template <typename ReaderT>
vtkSmartPointer<vtkPolyData> Read(const std::string& path)
{
  vtkNew<ReaderT> reader;
  const auto log = helios::WatchErrors(reader);
  reader->SetFileName(path.c_str());
  reader->Update();
  CHECK(log->Errors.empty());
  CHECK(log->Warnings.empty());
  return reader->GetOutput();
}

/// Compares every value of every array, from a point on.
void CheckSame(vtkPolyData* read, vtkIdType from, vtkPolyData* written)
{
  vtkPointData* a = read->GetPointData();
  vtkPointData* b = written->GetPointData();
  REQUIRE(a->GetNumberOfArrays() == b->GetNumberOfArrays());
  vtkIdType wrong = 0;
  const auto compare = [&wrong, from](vtkDataArray* x, vtkDataArray* y)
  {
    REQUIRE(x);
    REQUIRE(x->GetNumberOfComponents() == y->GetNumberOfComponents());
    CHECK(x->GetDataTypeSize() == y->GetDataTypeSize());
    CHECK(x->GetDataTypeMin() == y->GetDataTypeMin());
    for (vtkIdType i = 0; i < y->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < y->GetNumberOfComponents(); ++c)
      {
        wrong += x->GetComponent(from + i, c) == y->GetComponent(i, c) ? 0 : 1;
      }
    }
  };
  CHECK(read->GetPoints()->GetDataType() == VTK_DOUBLE);
  compare(read->GetPoints()->GetData(), written->GetPoints()->GetData());
  for (int i = 0; i < b->GetNumberOfArrays(); ++i)
  {
    compare(a->GetArray(b->GetArrayName(i)), b->GetArray(i));
  }
  CHECK(wrong == 0);
}

/// Checks that vertex i is point i.
void CheckVertices(vtkPolyData* cloud)
{
  REQUIRE(cloud->GetNumberOfVerts() == cloud->GetNumberOfPoints());
  CHECK(cloud->GetNumberOfCells() == cloud->GetNumberOfPoints());
  vtkIdType wrong = 0;
  for (vtkIdType i = 0; i < cloud->GetNumberOfVerts(); ++i)
  {
    vtkIdType size;
    const vtkIdType* ids;
    cloud->GetVerts()->GetCellAtId(i, size, ids);
    wrong += size == 1 && ids[0] == i ? 0 : 1;
  }
  CHECK(wrong == 0);
}

} // namespace

TEST_CASE("PointXMLWriter: VTK reads back every value", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "run/leg & 0_points.pvtp";
  vtkNew<vtkHeliosPointXMLWriter> writer;
  writer->SetFileName(path.c_str());
  const auto first = helios::MakeEchoes(70000); // several blocks of the compressor
  const auto second = helios::MakeEchoes(11);
  for (const auto& block : { first, second })
  {
    vtkNew<vtkFloatArray> vectors; // an array with several components
    vectors->SetName("of floats");
    vectors->SetNumberOfComponents(3);
    vectors->SetNumberOfTuples(block->GetNumberOfPoints());
    vectors->Fill(0.1);
    block->GetPointData()->AddArray(vectors);
  }
  REQUIRE(writer->Open());
  REQUIRE(writer->Write(first));
  REQUIRE(writer->Write(helios::MakeEchoes(0))); // creates no piece
  REQUIRE(writer->Write(second));
  CHECK(first->GetNumberOfCells() == 0); // the block is not modified
  CHECK(fs::exists(path + ".part"));
  CHECK_FALSE(fs::exists(path));
  REQUIRE(writer->Close());
  CHECK(writer->GetNumberOfPieces() == 2);
  CHECK(writer->GetNumberOfRecords() == 70011);
  vtkIdType bytes = 0;
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(folder / "run"))
  {
    files.push_back(entry.path().filename().string());
    bytes += entry.path().extension() == ".vtp" ? static_cast<vtkIdType>(entry.file_size()) : 0;
  }
  std::sort(files.begin(), files.end());
  CHECK(files ==
    std::vector<std::string>{
      "leg & 0_points.pvtp", "leg & 0_points_0000.vtp", "leg & 0_points_0001.vtp" });
  CHECK(writer->GetNumberOfBytes() == bytes);

  fs::rename(folder / "run", folder / "moved"); // piece names have no folder
  const auto cloud = Read<vtkXMLPPolyDataReader>(folder / "moved/leg & 0_points.pvtp");
  REQUIRE(cloud->GetNumberOfPoints() == 70011);
  CheckSame(cloud, 0, first);
  CheckSame(cloud, 70000, second);
  CheckVertices(cloud);
}

TEST_CASE("PointXMLWriter: a piece has the part names", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.pvtp";
  vtkNew<vtkHeliosPointXMLWriter> writer;
  writer->SetFileName(path.c_str());
  const auto echoes = helios::MakeEchoes(20);
  vtkNew<vtkStringArray> parts;
  parts->SetName(names::PartName);
  parts->InsertNextValue("the house");
  parts->InsertNextValue("the ground");
  echoes->GetFieldData()->AddArray(parts);
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));
  const auto piece = Read<vtkXMLPolyDataReader>(folder / "points_0000.vtp");
  CheckSame(piece, 0, echoes);
  CheckVertices(piece);
  auto* read =
    vtkStringArray::SafeDownCast(piece->GetFieldData()->GetAbstractArray(names::PartName));
  REQUIRE(read);
  CHECK(read->GetValue(1) == "the ground");
}

TEST_CASE(
  "PointXMLWriter: the bytes of a piece do not depend on earlier pieces", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  const auto echoes = helios::MakeEchoes(100);
  vtkNew<vtkDoubleArray> column; // field data like a scene's: the same in all blocks
  column->SetName("Column");
  column->InsertNextValue(0.5);
  echoes->GetFieldData()->AddArray(column);
  vtkNew<vtkHeliosPointXMLWriter> writer;
  writer->SetFileName((folder / "points.pvtp").c_str());
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Write(echoes) && writer->Close()));
  const std::string first = helios::ReadText(folder / "points_0000.vtp");
  CHECK(first.size() > 1000);
  CHECK(first == helios::ReadText(folder / "points_0001.vtp"));
}

TEST_CASE("PointXMLWriter: resumes an index", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  vtkNew<vtkHeliosPointXMLWriter> writer;
  const auto log = helios::WatchErrors(writer);
  const auto run = [&writer, &folder](const std::string& name)
  {
    writer->SetFileName((folder / (name + "/points.pvtp")).c_str());
    REQUIRE(writer->Open());
    REQUIRE((writer->Write(helios::MakeEchoes(20)) && writer->Write(helios::MakeEchoes(30))));
  };
  run("whole");
  const vtkIdType size = writer->GetFileSize();
  const vtkIdType bytes = writer->GetNumberOfBytes();
  REQUIRE((writer->Write(helios::MakeEchoes(40)) && writer->Close()));
  run("broken");
  SECTION("abandoned")
  {
    REQUIRE((writer->Write(helios::MakeEchoes(7)) && writer->Abandon()));
  }
  SECTION("closed")
  {
    REQUIRE(writer->Close());
  }
  SECTION("a piece is missing")
  {
    REQUIRE(writer->Abandon());
    fs::remove(folder / "broken/points_0001.vtp");
    CHECK_FALSE(writer->Reopen(size, 50, bytes));
    CHECK(log->HasError(
      "points_0001.vtp is missing or incomplete, and the run cannot be resumed after it"));
    CHECK_FALSE(writer->IsOpen());
    return;
  }
  REQUIRE(writer->Reopen(size, 50, bytes));
  CHECK(writer->GetNumberOfPieces() == 2);
  REQUIRE((writer->Write(helios::MakeEchoes(40)) && writer->Flush() && writer->Close()));
  CHECK(writer->GetNumberOfRecords() == 90);
  for (const char* name :
    { "points.pvtp", "points_0000.vtp", "points_0001.vtp", "points_0002.vtp" })
  {
    CHECK(helios::ReadText(folder / (std::string("whole/") + name)) ==
      helios::ReadText(folder / (std::string("broken/") + name)));
  }
}

TEST_CASE("PointXMLWriter: count only: nothing is written", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  vtkNew<vtkHeliosPointXMLWriter> writer;
  vtkIdType bytes[2];
  for (const bool isCounted : { false, true })
  {
    writer->SetFileName((folder / (isCounted ? "counted/points.pvtp" : "points.pvtp")).c_str());
    writer->SetCountOnly(isCounted);
    REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(500)) && writer->Close()));
    bytes[isCounted] = writer->GetNumberOfBytes() + writer->GetFileSize();
  }
  CHECK(bytes[0] == bytes[1]);
  CHECK_FALSE(fs::exists(folder / "counted"));
}

TEST_CASE("PointXMLWriter: cells of a block are kept", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.pvtp";
  vtkNew<vtkHeliosPointXMLWriter> writer;
  writer->SetFileName(path.c_str());
  const auto echoes = helios::MakeEchoes(3);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0, 1, 2 });
  echoes->SetVerts(vertices);
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));
  CHECK(Read<vtkXMLPPolyDataReader>(path)->GetNumberOfVerts() == 1);
}

TEST_CASE("PointXMLWriter: no records: an index without pieces", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.pvtp";
  vtkNew<vtkHeliosPointXMLWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Close()));
  CHECK(Read<vtkXMLPPolyDataReader>(path)->GetNumberOfPoints() == 0);
}

TEST_CASE("PointXMLWriter: an abandoned index is readable", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.pvtp";
  vtkNew<vtkHeliosPointXMLWriter> writer;
  writer->SetFileName(path.c_str());
  const auto echoes = helios::MakeEchoes(100);
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Write(echoes) && writer->Abandon()));
  CHECK_FALSE(fs::exists(path));
  const auto cloud = Read<vtkXMLPPolyDataReader>(path + ".part");
  REQUIRE(cloud->GetNumberOfPoints() == 200);
  CheckSame(cloud, 100, echoes);
}

TEST_CASE("PointXMLWriter: bad input is an error", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  vtkNew<vtkHeliosPointXMLWriter> writer;
  const auto log = helios::WatchErrors(writer);
  const std::string path = folder / "points.pvtp";
  writer->SetFileName(path.c_str());
  const auto echoes = helios::MakeEchoes(4);
  CHECK_FALSE(writer->Write(echoes));
  CHECK(log->HasError("is not open"));
  REQUIRE(writer->Open());
  REQUIRE(writer->Write(helios::MakeEchoes(5)));
  SECTION("a table")
  {
    vtkNew<vtkTable> table;
    CHECK_FALSE(writer->Write(table));
    CHECK(log->HasError("a block is vtkTable, not vtkPolyData"));
  }
  SECTION("texts")
  {
    vtkNew<vtkStringArray> words;
    words->SetName("Words");
    words->SetNumberOfValues(4);
    echoes->GetPointData()->AddArray(words);
    CHECK_FALSE(writer->Write(echoes));
    CHECK(log->HasError("the array Words of a block is not one tuple of numbers per record"));
  }
  SECTION("a name that VTK writes but cannot read")
  {
    echoes->GetPointData()->GetArray(0)->SetName("a<b");
    CHECK_FALSE(writer->Write(echoes));
    CHECK(log->HasError("the array a<b of a block has a name that VTK's XML cannot hold"));
  }
  SECTION("an array too short")
  {
    helios::AddColumn<vtkIntArray>(
      echoes->GetPointData(), names::PartIds, 2, [](vtkIdType) { return 0; });
    CHECK_FALSE(writer->Write(echoes));
    CHECK(log->HasError("the array PartIds of a block is not one tuple of numbers per record"));
  }
  SECTION("other arrays than in earlier blocks")
  {
    echoes->GetPointData()->RemoveArray(names::EchoWidth);
    CHECK_FALSE(writer->Write(echoes));
    CHECK(log->HasError("a block has other arrays than those before"));
    CHECK(log->HasError("Name=\"EchoWidth\""));
  }
  CHECK(writer->Write(helios::MakeEchoes(3))); // another block is accepted
  CHECK(writer->Close());
  CHECK(Read<vtkXMLPPolyDataReader>(path)->GetNumberOfPoints() == 8);
}

TEST_CASE(
  "PointXMLWriter: a full disk keeps complete pieces and reports their number", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  const auto block = helios::MakeEchoes(2000);
  const auto small = helios::MakeEchoes(10);
  const std::string path = folder / "whole/points.pvtp";
  vtkNew<vtkHeliosPointXMLWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(block) && writer->Close()));
  const int pages = static_cast<int>(writer->GetNumberOfBytes() / 4096) + 1;
  REQUIRE(pages > 10);

  // space for everything but the last page, and for less
  for (const int room : { pages - 1, pages - 2, pages / 2, 1 })
  {
    const std::string name = "disk" + std::to_string(room);
    const helios::SmallDisk disk(folder / name, 4 * (room + 6)); // 6: folder, index, small piece
    if (!disk.IsMounted())
    {
      WARN("no small disk can be mounted here: not tested");
      return;
    }
    const std::string full = folder / (name + "/points.pvtp");
    log->Clear();
    writer->SetFileName(full.c_str());
    REQUIRE((writer->Open() && writer->Write(small)));
    const std::string fill(4096 * (fs::space(folder / name).free / 4096 - room), 'x');
    std::ofstream(folder / (name + "/fill")) << fill;
    REQUIRE(fs::space(folder / name).free == 4096u * room);
    INFO("pages " << pages << ", room for " << room);
    CHECK_FALSE(writer->Write(block));
    CHECK(log->HasError(
      folder / (name + "/points_0001.vtp.part cannot be written: No space left on device;")));
    CHECK(log->HasError("10 records are safe in " + (folder / (name + "/points_0000.vtp")) + ";"));
    CHECK(writer->GetNumberOfRecords() == 10);
    CHECK_FALSE(fs::exists(folder / (name + "/points_0001.vtp")));
    CHECK_FALSE(fs::exists(folder / (name + "/points_0001.vtp.part")));
    log->Clear();
    CHECK_FALSE(writer->Write(small));
    CHECK(log->HasError("lacks a block that could not be written"));
    CHECK_FALSE(writer->Close());
    CHECK_FALSE(fs::exists(full));
  }
}

TEST_CASE("PointXMLWriter: the folder is removed during a run", "[PointXMLWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "new/points.pvtp";
  vtkNew<vtkHeliosPointXMLWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(10))));
  fs::remove_all(folder / "new");
  CHECK_FALSE(writer->Write(helios::MakeEchoes(10)));
  CHECK(log->HasError("points_0001.vtp.part cannot be opened: No such file or directory; nothing "
                      "is kept, since " +
    path + ".part was removed; run again"));
  CHECK_FALSE(writer->Close());
  CHECK(log->HasError("lacks a block that could not be written; nothing is kept"));
  CHECK_FALSE(log->HasError("are safe"));
  CHECK_FALSE(fs::exists(folder / "new")); // not created again
}
