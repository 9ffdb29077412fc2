// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Common behaviour of all writers, tested with the point text writer.
#include "heliosPartFile.h"
#include "heliosTempFolder.h"
#include "heliosWriterTesting.h"
#include "vtkHeliosPointTextWriter.h"

#include <vtkFloatArray.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <algorithm>

#include <fcntl.h>
#include <unistd.h>

namespace names = vtkHeliosArrayNames;
namespace fs = std::filesystem;

namespace
{

vtkIdType CountLines(const std::string& path)
{
  const std::string text = helios::ReadText(path);
  CHECK((text.empty() || text.back() == '\n'));
  return std::count(text.begin(), text.end(), '\n');
}

/// Gives the descriptor of an open file the target of another one.
bool Redirect(const std::string& path, const char* to)
{
  for (const auto& entry : fs::directory_iterator("/proc/self/fd"))
  {
    std::error_code ignored;
    if (fs::read_symlink(entry, ignored) == fs::canonical(path))
    {
      const int other = ::open(to, O_WRONLY | O_CLOEXEC);
      const bool good = ::dup2(other, std::stoi(entry.path().filename().string())) >= 0;
      ::close(other);
      return good;
    }
  }
  return false;
}

} // namespace

TEST_CASE("StreamWriter: .part until closed, in created folders", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "new/sub/leg000_points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(path.c_str());
  CHECK_FALSE(writer->IsOpen());
  REQUIRE(writer->Open());
  CHECK(writer->IsOpen());
  REQUIRE(writer->Write(helios::MakeEchoes(10)));
  CHECK(CountLines(path + ".part") == 10);
  CHECK_FALSE(fs::exists(path));
  writer->SetFileName("other"); // applies to the next Open()
  REQUIRE(writer->Write(helios::MakeEchoes(5)));
  REQUIRE(writer->Close());
  CHECK_FALSE(writer->IsOpen());
  CHECK_FALSE(fs::exists(path + ".part"));
  CHECK(CountLines(path) == 15);
  CHECK(writer->GetNumberOfRecords() == 15);
  CHECK(writer->GetNumberOfBytes() == static_cast<vtkIdType>(fs::file_size(path)));
}

TEST_CASE("StreamWriter: an existing file is replaced on closing, not before", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(7)) && writer->Close()));
  REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(3))));
  CHECK(writer->GetNumberOfRecords() == 3);
  CHECK(CountLines(path) == 7);
  REQUIRE(writer->Close());
  CHECK(CountLines(path) == 3);
}

TEST_CASE("StreamWriter: an abandoned file remains valid as .part", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.xyz";
  SECTION("by the user")
  {
    vtkNew<vtkHeliosPointTextWriter> writer;
    writer->SetFileName(path.c_str());
    REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(4)) && writer->Abandon()));
    CHECK_FALSE(writer->IsOpen());
    CHECK(writer->Abandon()); // no effect
  }
  SECTION("by the destructor of the writer")
  {
    vtkNew<vtkHeliosPointTextWriter> writer;
    writer->SetFileName(path.c_str());
    REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(4))));
  }
  CHECK_FALSE(fs::exists(path));
  CHECK(CountLines(path + ".part") == 4);
}

TEST_CASE("StreamWriter: no records: an empty file", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(path.c_str());
  SECTION("no block")
  {
    REQUIRE((writer->Open() && writer->Close()));
  }
  SECTION("blocks without points")
  {
    vtkNew<vtkPolyData> bare;
    REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(0)) && writer->Write(bare)));
    REQUIRE(writer->Close());
  }
  CHECK(fs::file_size(path) == 0);
  CHECK(writer->GetNumberOfRecords() == 0);
}

TEST_CASE("StreamWriter: byte-identical for any threads and blocks", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.xyz";
  constexpr vtkIdType count = 100000; // several rounds
  const auto echoes = helios::MakeEchoes(count);
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(path.c_str());
  std::string texts[2];
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::Initialize(threads);
    REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));
    texts[threads - 1] = helios::ReadText(path);
  }
  CHECK(texts[0].size() > 8000000);
  CHECK(texts[0] == texts[1]);

  // blocks of one echo each give the same lines
  REQUIRE(writer->Open());
  vtkNew<vtkPolyData> one;
  vtkNew<vtkPoints> point;
  point->SetDataTypeToDouble();
  one->GetPointData()->CopyAllocate(echoes->GetPointData());
  for (vtkIdType i = 0; i < 2000; ++i)
  {
    point->Reset();
    point->InsertNextPoint(echoes->GetPoint(i));
    one->SetPoints(point);
    one->GetPointData()->CopyData(echoes->GetPointData(), i, 0);
    REQUIRE(writer->Write(one));
  }
  REQUIRE(writer->Close());
  const std::string lines = helios::ReadText(path);
  CHECK(lines == texts[0].substr(0, lines.size()));
}

TEST_CASE("StreamWriter: numbers that are not finite are dropped and counted", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  const auto echoes = helios::MakeEchoes(6);
  echoes->GetPoints()->SetPoint(2, 0, vtkMath::Inf(), 0);
  vtkPointData* data = echoes->GetPointData();
  data->GetArray(names::EchoWidth)->SetComponent(4, 0, vtkMath::Nan());
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));
  CHECK(log->HasWarning("2 of 6 records of a block have a number that is not finite"));
  CHECK(writer->GetNumberOfRecords() == 4);
  const auto rows = helios::ReadRows(path);
  REQUIRE(rows.size() == 4);
  CHECK(rows[2][7] == "5000000003");
  CHECK(rows[3][7] == "5000000005");
}

TEST_CASE("StreamWriter: wrong order of calls", "[StreamWriter]")
{
  const helios::TempFolder folder;
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  CHECK_FALSE(writer->Open());
  CHECK(log->HasError("FileName is not set"));
  CHECK_FALSE(writer->Write(helios::MakeEchoes(1)));
  CHECK(log->HasError("the file is not open; call Open() before Write() and Close()"));
  log->Clear();
  const std::string path = folder / "points.xyz";
  writer->SetFileName(path.c_str());
  CHECK_FALSE(writer->Close());
  CHECK(log->HasError(path + " is not open"));
  CHECK(writer->Abandon());
  REQUIRE(writer->Open());
  CHECK_FALSE(writer->Open());
  CHECK(log->HasError(path + " is open already"));
  CHECK(writer->Write(helios::MakeEchoes(1)));
  CHECK(writer->Close());
}

TEST_CASE("StreamWriter: file names that cannot be written", "[StreamWriter]")
{
  const helios::TempFolder folder;
  std::ofstream(folder / "plain") << "text";
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  SECTION("a file where a folder should be")
  {
    const std::string path = folder / "plain/run/points.xyz";
    writer->SetFileName(path.c_str());
    CHECK_FALSE(writer->Open());
    CHECK(log->HasError(
      "the folder " + (folder / "plain/run") + " cannot be created: Not a directory"));
    CHECK(log->HasError("choose another output folder"));
  }
  SECTION("a folder where the file should be")
  {
    fs::create_directory(folder / "points.xyz");
    const std::string path = folder / "points.xyz";
    writer->SetFileName(path.c_str());
    CHECK_FALSE(writer->Open());
    CHECK(log->HasError(path + " is a folder"));
  }
  SECTION("a folder where the .part should be")
  {
    const std::string path = folder / "points.xyz";
    fs::create_directory(path + ".part");
    writer->SetFileName(path.c_str());
    CHECK_FALSE(writer->Open());
    CHECK(log->HasError(path + ".part cannot be opened: Is a directory"));
  }
  SECTION("a folder that appears before the file is closed")
  {
    const std::string path = folder / "points.xyz";
    writer->SetFileName(path.c_str());
    REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(2))));
    fs::create_directory(path);
    CHECK_FALSE(writer->Close());
    CHECK(log->HasError("cannot be renamed to " + path));
    CHECK(log->HasError("2 records were written to " + path + ".part"));
    CHECK(CountLines(path + ".part") == 2);
  }
  CHECK_FALSE(writer->IsOpen());
}

TEST_CASE("StreamWriter: blocks of another type", "[StreamWriter]")
{
  const helios::TempFolder folder;
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  const std::string path = folder / "points.xyz";
  writer->SetFileName(path.c_str());
  REQUIRE(writer->Open());
  const auto echoes = helios::MakeEchoes(3);
  vtkPointData* data = echoes->GetPointData();
  SECTION("null")
  {
    CHECK_FALSE(writer->Write(nullptr));
    CHECK(log->HasError("a block is null, not vtkPolyData"));
  }
  SECTION("a table")
  {
    vtkNew<vtkTable> table;
    CHECK_FALSE(writer->Write(table));
    CHECK(
      log->HasError("a block is vtkTable, not vtkPolyData; write the echoes of vtkHeliosScanner"));
  }
  SECTION("float points")
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->InsertNextPoint(1, 2, 3);
    vtkNew<vtkPolyData> block;
    block->SetPoints(points);
    CHECK_FALSE(writer->Write(block));
    CHECK(log->HasError("the points of a block are float, not double; call SetDataTypeToDouble()"));
  }
  SECTION("a missing array")
  {
    data->RemoveArray(names::EchoWidth);
    CHECK_FALSE(writer->Write(echoes));
    CHECK(
      log->HasError("no array EchoWidth; the echoes of vtkHeliosScanner (output port 0) have it"));
  }
  SECTION("an array too short")
  {
    helios::AddColumn<vtkIntArray>(data, names::PartIds, 2, [](vtkIdType) { return 0; });
    CHECK_FALSE(writer->Write(echoes));
    CHECK(log->HasError("array PartIds of the block has 2 x 1 values, not 3 x 1"));
  }
  SECTION("an array too wide")
  {
    vtkNew<vtkDoubleArray> pairs;
    pairs->SetName(names::GpsTime);
    pairs->SetNumberOfComponents(2);
    pairs->SetNumberOfTuples(3);
    data->AddArray(pairs);
    CHECK_FALSE(writer->Write(echoes));
    CHECK(log->HasError("array GpsTime of the block has 3 x 2 values, not 3 x 1"));
  }
  SECTION("fractions for integers")
  {
    helios::AddColumn<vtkFloatArray>(data, names::PulseIds, 3, [](vtkIdType) { return 0.5; });
    CHECK_FALSE(writer->Write(echoes));
    CHECK(log->HasError("array PulseIds of the block holds float; it must hold integers"));
  }
  CHECK(writer->GetNumberOfRecords() == 0);
  CHECK(writer->Write(helios::MakeEchoes(2))); // another block is accepted
  CHECK(writer->Close());
  CHECK(CountLines(path) == 2);
}

TEST_CASE(
  "StreamWriter: a full disk keeps complete blocks and reports their number", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const helios::SmallDisk disk(folder / "disk", 4096);
  if (!disk.IsMounted())
  {
    WARN("no small disk can be mounted here: not tested");
    return;
  }
  const std::string path = folder / "disk/points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  REQUIRE(writer->Open());
  REQUIRE(writer->Write(helios::MakeEchoes(1000)));
  const vtkIdType bytes = writer->GetNumberOfBytes();
  CHECK_FALSE(writer->Write(helios::MakeEchoes(60000))); // most of its chunks fit
  CHECK(log->HasError(path + ".part cannot be written: No space left on device"));
  CHECK(log->HasError("1000 records are safe in " + path + ".part; make room"));
  CHECK(writer->GetNumberOfRecords() == 1000);
  CHECK(writer->GetNumberOfBytes() == bytes);
  CHECK(static_cast<vtkIdType>(fs::file_size(path + ".part")) == bytes);

  // the file lacks a block: no more blocks are accepted, and no final name is given
  log->Clear();
  CHECK_FALSE(writer->Write(helios::MakeEchoes(10)));
  CHECK(log->HasError("lacks a block that could not be written; 1000 records are safe in"));
  log->Clear();
  CHECK_FALSE(writer->Close());
  CHECK(log->HasError("lacks a block that could not be written"));
  CHECK_FALSE(writer->IsOpen());
  CHECK_FALSE(fs::exists(path));
  CHECK(CountLines(path + ".part") == 1000);

  log->Clear();
  CHECK((writer->Open() && writer->Write(helios::MakeEchoes(10)) && writer->Close()));
  CHECK(log->Errors.empty());
  CHECK(CountLines(path) == 10);
}

TEST_CASE("StreamWriter: resumes a file", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(10))));
  const vtkIdType size = writer->GetFileSize();
  REQUIRE(writer->Write(helios::MakeEchoes(20)));
  CHECK(writer->Flush());
  SECTION("abandoned")
  {
    REQUIRE(writer->Abandon());
  }
  SECTION("closed, but not yet in the journal")
  {
    REQUIRE(writer->Close());
  }
  SECTION("shorter than it was")
  {
    REQUIRE(writer->Abandon());
    CHECK_FALSE(writer->Reopen(1000000, 10, 1000000));
    CHECK(log->HasError(path + ".part cannot be resumed: it has"));
    CHECK(log->HasError("bytes of 1000000"));
    CHECK_FALSE(writer->IsOpen());
    fs::remove(path + ".part");
    CHECK_FALSE(writer->Reopen(0, 0, 0));
    CHECK(log->HasError("No such file or directory"));
    return;
  }
  REQUIRE(writer->Reopen(size, 10, size));
  CHECK_FALSE(fs::exists(path));
  REQUIRE((writer->Write(helios::MakeEchoes(5)) && writer->Close()));
  CHECK(CountLines(path) == 15);
  CHECK(writer->GetNumberOfRecords() == 15);
  CHECK(writer->GetNumberOfBytes() == static_cast<vtkIdType>(fs::file_size(path)));
  CHECK(log->Errors.empty());
}

TEST_CASE("StreamWriter: a .part is not written through a link", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.xyz";
  const std::string other = folder / "other.txt";
  std::ofstream(other) << "of the user";
  fs::create_symlink(other, path + ".part");
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  SECTION("of a new file")
  {
    REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(10)) && writer->Close()));
    CHECK(CountLines(path) == 10);
    CHECK_FALSE(fs::is_symlink(path));
  }
  SECTION("of a resumed file")
  {
    CHECK_FALSE(writer->Reopen(3, 1, 3));
    CHECK(
      log->HasError(path + ".part cannot be resumed: it is a link to another file, which is kept"));
  }
  SECTION("of a text")
  {
    CHECK(helios::WriteWhole(path, "whole").IsOk());
    CHECK(helios::ReadText(path) == "whole");
    fs::create_symlink(other, path + ".part");
    CHECK(helios::WriteUnsynced(path, "again").IsOk());
    CHECK(helios::ReadText(path) == "again");
  }
  SECTION("of a text that cannot be written")
  {
    fs::create_directories(path); // so that the .part cannot be renamed
    fs::remove(path + ".part");
    CHECK_THAT(helios::WriteWhole(path, "x").Message(), Catch::Contains("is a folder"));
    CHECK_THAT(helios::WriteUnsynced(path, "x").Message(), Catch::Contains("is a folder"));
    fs::create_directories(folder / "b.part/c");
    CHECK_THAT(helios::WriteUnsynced(folder / "b", "x").Message(),
      Catch::Contains("b.part cannot be opened"));
  }
  CHECK(helios::ReadText(other) == "of the user");
}

TEST_CASE("StreamWriter: copies rows of another file", "[StreamWriter]")
{
  const helios::TempFolder folder;
  vtkNew<vtkHeliosPointTextWriter> other;
  other->SetFileName((folder / "other.xyz").c_str());
  REQUIRE((other->Open() && other->Write(helios::MakeEchoes(7))));
  const auto begin = static_cast<std::uint64_t>(other->GetFileSize());
  REQUIRE((other->Write(helios::MakeEchoes(30000)) && other->Close()));
  helios::FileBlock rows{ "other.xyz", begin, fs::file_size(folder / "other.xyz"), "", false };
  REQUIRE(rows.End - rows.Begin > 1 << 20); // several reads
  const std::string path = folder / "points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(3))));
  const vtkIdType size = writer->GetFileSize();
  SECTION("as if they were written")
  {
    REQUIRE((writer->CopyRows(folder / "other.xyz", rows, 30000) && writer->Close()));
    CHECK(writer->GetNumberOfRecords() == 30003);
    CHECK(writer->GetNumberOfBytes() == static_cast<vtkIdType>(fs::file_size(path)));
    vtkNew<vtkHeliosPointTextWriter> expected;
    expected->SetFileName((folder / "expected.xyz").c_str());
    REQUIRE((expected->Open() && expected->Write(helios::MakeEchoes(3)) &&
      expected->Write(helios::MakeEchoes(30000)) && expected->Close()));
    CHECK(helios::ReadText(path) == helios::ReadText(folder / "expected.xyz"));
  }
  SECTION("that do not exist: nothing is appended")
  {
    rows.End += 1;
    CHECK_FALSE(writer->CopyRows(folder / "other.xyz", rows, 30000));
    CHECK(log->HasError("other.xyz: its bytes " + std::to_string(rows.Begin) + " to " +
      std::to_string(rows.End) + " cannot be read"));
    CHECK(log->HasError("3 records are safe in " + path + ".part"));
    CHECK(writer->GetFileSize() == size);
    writer->Abandon();
  }
}

TEST_CASE("StreamWriter: the file is removed during a run", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "new/points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  CHECK_FALSE(writer->Flush());
  CHECK(log->HasError("is not open"));
  REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(10)) && writer->Flush()));
  fs::remove_all(folder / "new");
  REQUIRE(writer->Write(helios::MakeEchoes(10))); // still accepted by the system
  SECTION("found by Flush()")
  {
    CHECK_FALSE(writer->Flush());
    CHECK(log->HasError(path + ".part was removed while it was written; keep the"));
    CHECK_FALSE(writer->Write(helios::MakeEchoes(10)));
  }
  SECTION("found by Close()")
  {
    CHECK_FALSE(writer->Close());
    CHECK(log->HasError(path + ".part was removed while it was written; nothing is kept;"));
    CHECK_FALSE(log->HasError("records"));
  }
}

TEST_CASE("StreamWriter: count only: nothing is written", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "new/points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  writer->SetFileName(path.c_str());
  vtkIdType bytes[2];
  for (const bool isCounted : { true, false })
  {
    writer->SetCountOnly(isCounted);
    REQUIRE((writer->Open() && writer->Write(helios::MakeEchoes(100)) && writer->Close()));
    bytes[isCounted] = writer->GetNumberOfBytes();
    CHECK(fs::exists(path) == !isCounted);
  }
  CHECK(bytes[0] == bytes[1]);
  CHECK(bytes[0] == static_cast<vtkIdType>(fs::file_size(path)));
}

TEST_CASE("StreamWriter: the text of a block, copied to a file", "[StreamWriter]")
{
  const helios::TempFolder folder;
  std::string text;
  vtkNew<vtkHeliosPointTextWriter> counting;
  counting->SetFileName((folder / "a/nothing.xyz").c_str());
  counting->CountOnlyOn();
  counting->SetBlockText(&text);
  REQUIRE((counting->Open() && counting->Write(helios::MakeEchoes(30000)) && counting->Abandon()));
  CHECK_FALSE(fs::exists(folder / "a"));
  vtkNew<vtkHeliosPointTextWriter> copy;
  copy->SetFileName((folder / "copy.xyz").c_str());
  REQUIRE((copy->Open() && copy->CopyRows(text, 30000) && copy->Close()));
  CHECK(copy->GetNumberOfRecords() == 30000);
  CHECK(copy->GetNumberOfBytes() == static_cast<vtkIdType>(text.size()));
  vtkNew<vtkHeliosPointTextWriter> expected;
  expected->SetFileName((folder / "expected.xyz").c_str());
  REQUIRE((expected->Open() && expected->Write(helios::MakeEchoes(30000)) && expected->Close()));
  CHECK(text == helios::ReadText(folder / "expected.xyz"));
  CHECK(helios::ReadText(folder / "copy.xyz") == text);
}

TEST_CASE("StreamWriter: a disk that is full at the start", "[StreamWriter]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "points.xyz";
  vtkNew<vtkHeliosPointTextWriter> writer;
  const auto log = helios::WatchErrors(writer);
  writer->SetFileName(path.c_str());
  REQUIRE(writer->Open());
  REQUIRE(Redirect(path + ".part", "/dev/full")); // which cannot be truncated either
  CHECK_FALSE(writer->Write(helios::MakeEchoes(10)));
  CHECK(log->HasError(path + ".part cannot be written: No space left on device"));
  CHECK(log->HasError("the first 0 records are safe in " + path + ".part, which has part"));
  CHECK(writer->Abandon());
}
