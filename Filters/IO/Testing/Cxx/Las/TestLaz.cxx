// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// LAZ: written and read, resumed, and damaged.
#include "heliosLasTesting.h"
#include "heliosLazCodec.h"
#include "vtkHeliosLASWriter.h"

#include <vtkSMPTools.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <string>
#include <vector>

namespace names = vtkHeliosArrayNames;
namespace fs = std::filesystem;
using helios::GetNumber;
using helios::LasReading;
using helios::MakeLasEchoes;
using helios::SetNumber;

namespace
{

constexpr std::size_t AtPoints = 96; // where the header says where points begin
constexpr std::size_t AtFormat = 104;

struct LazWriting
{
  helios::TempFolder Folder;
  vtkNew<vtkHeliosLASWriter> Writer;
  vtkSmartPointer<helios::ErrorObserver> Log = helios::WatchErrors(this->Writer);

  void Open(const std::string& name, bool isCompressed = true)
  {
    this->Writer->SetFileName((this->Folder / name).c_str());
    this->Writer->SetWriteCompressed(isCompressed);
    REQUIRE(this->Writer->Open());
  }
  std::string Bytes(const std::string& name) const { return helios::ReadText(this->Folder / name); }
};

/// Returns a LAS file with its points compressed, with or without a table of chunks.
std::string Pack(std::string bytes, bool hasTable = true)
{
  const int format = bytes[AtFormat];
  const int length = GetNumber<std::uint16_t>(bytes, AtFormat + 1);
  const auto form = helios::LazForm::Make(format, length);
  const helios::LasRecord record = form.Encode();
  helios::AddRecord(bytes, record.User, static_cast<std::uint16_t>(record.Id), record.Data);
  const std::size_t begin = GetNumber<std::uint32_t>(bytes, AtPoints);
  const std::string points = bytes.substr(begin);
  std::vector<helios::LazBytes> packed;
  REQUIRE(helios::EncodeLazChunks(
    form, points.data(), points.size() / static_cast<std::size_t>(length), packed)
            .IsOk());
  bytes = bytes.substr(0, begin) + helios::EncodeLas<std::uint64_t>(begin);
  std::vector<helios::LazChunk> chunks;
  for (const helios::LazBytes& chunk : packed)
  {
    bytes += chunk.Bytes;
    chunks.push_back({ chunk.Points, chunk.Bytes.size() });
  }
  if (hasTable)
  {
    SetNumber<std::uint64_t>(bytes, begin, bytes.size());
    bytes += helios::EncodeLazTable(chunks);
  }
  bytes[AtFormat] = static_cast<char>(format | 0x80);
  return bytes;
}

void WriteFile(const std::string& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}

/// Checks that two files have the same points and arrays.
void CheckSame(const std::string& path, const std::string& other)
{
  LasReading one(path);
  LasReading two(other);
  REQUIRE(one.Read());
  REQUIRE(two.Read());
  const vtkIdType count = one.CountPoints();
  REQUIRE(two.CountPoints() == count);
  vtkIdType differences = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    differences += one.Cloud()->GetPoint(i)[1] == two.Cloud()->GetPoint(i)[1] ? 0 : 1;
  }
  for (int k = 0; k < one.Cloud()->GetPointData()->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* array = one.Cloud()->GetPointData()->GetArray(k);
    INFO(array->GetName());
    vtkDataArray* same = two.Get(array->GetName());
    REQUIRE(same);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double value = array->GetComponent(i, 0);
      differences += std::isnan(value) || value == same->GetComponent(i, 0) ? 0 : 1;
    }
  }
  CHECK(differences == 0);
}

/// Returns whether a file is refused with a message that begins so, without points.
bool FailsWith(const std::string& path, const std::string& bytes, const std::string& message)
{
  WriteFile(path, bytes);
  LasReading reading(path);
  const bool isRead = reading.Read();
  INFO(reading.Log->Errors);
  CHECK(reading.Log->HasError(path + ": " + message));
  return !isRead && reading.CountPoints() == 0;
}

} // namespace

TEST_CASE("Laz: the points are those of LAS, and fewer bytes", "[Laz]")
{
  LazWriting writing;
  const auto echoes = MakeLasEchoes(120000); // three chunks
  helios::SetCrs(echoes, "EPSG:25832");
  helios::SetEpoch(echoes, 1.3e9);
  for (const bool isCompressed : { false, true })
  {
    writing.Open(isCompressed ? "a.laz" : "a.las", isCompressed);
    REQUIRE((writing.Writer->Write(echoes) && writing.Writer->Close()));
    CHECK(writing.Writer->GetNumberOfBytes() == writing.Writer->GetFileSize());
  }
  CHECK((GetNumber<std::uint8_t>(writing.Bytes("a.laz"), AtFormat) & 0x80) != 0);
  CHECK(writing.Bytes("a.laz").size() < 0.7 * static_cast<double>(writing.Bytes("a.las").size()));
  CheckSame(writing.Folder / "a.las", writing.Folder / "a.laz");
  // pieces begin anywhere in a chunk
  LasReading whole(writing.Folder / "a.las");
  LasReading pieces(writing.Folder / "a.laz");
  REQUIRE(whole.Read());
  vtkIdType row = 0;
  for (int piece = 0; piece < 7; ++piece)
  {
    REQUIRE(pieces.Read(piece, 7));
    for (vtkIdType i = 0; i < pieces.CountPoints(); i += 500)
    {
      REQUIRE(
        pieces.Get(names::GpsTime)->GetTuple1(i) == whole.Get(names::GpsTime)->GetTuple1(row + i));
    }
    row += pieces.CountPoints();
  }
  CHECK(row == 120000);
}

TEST_CASE("Laz: all point formats", "[Laz]")
{
  const helios::TempFolder folder;
  const int lengths[] = { 20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67 };
  const int format = GENERATE(range(0, 11));
  const int extra = GENERATE(0, 5);
  const auto length = static_cast<std::uint16_t>(lengths[format] + extra);
  const std::uint32_t count = 2000;
  std::string bytes = helios::MakeOld(4, format, count, length);
  const std::size_t begin = GetNumber<std::uint32_t>(bytes, AtPoints);
  for (std::size_t i = begin; i < bytes.size(); ++i) // channels alternate, too
  {
    bytes[i] = static_cast<char>(i * i / 7 + i % 13);
  }
  INFO("format " << format);
  WriteFile(folder / "a.las", bytes);
  WriteFile(folder / "a.laz", Pack(bytes));
  CheckSame(folder / "a.las", folder / "a.laz");
}

TEST_CASE("Laz: byte-identical for any number of threads, pieces and resumed runs", "[Laz]")
{
  LazWriting writing;
  vtkHeliosLASWriter* writer = writing.Writer;
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  const auto first = MakeLasEchoes(130000);
  const auto second = MakeLasEchoes(7000);
  const auto writeFirst = [&] { REQUIRE((writer->Write(first) && writer->EndBlock())); };
  vtkSMPTools::Initialize(1);
  writing.Open("one.laz");
  writeFirst();
  const vtkIdType size = writer->GetFileSize();
  const vtkIdType bytes = writer->GetNumberOfBytes();
  REQUIRE((writer->Write(second) && writer->Write(second) && writer->Close()));
  const vtkIdType all = writer->GetNumberOfBytes();
  vtkSMPTools::Initialize(4);
  SECTION("threads")
  {
    writing.Open("two.laz");
    writeFirst();
    REQUIRE((writer->Write(second) && writer->Write(second) && writer->Close()));
  }
  SECTION("resumed")
  {
    writing.Open("two.laz");
    writeFirst();
    const std::string part = writing.Folder / "two.laz.part";
    SECTION("after Abandon(), which leaves a whole file")
    {
      REQUIRE((writer->Write(MakeLasEchoes(90000)) && writer->Abandon()));
      LasReading reading(part);
      REQUIRE(reading.Read());
      CHECK(reading.CountPoints() == 220000);
    }
    SECTION("after a crash")
    {
      REQUIRE(writer->Write(MakeLasEchoes(210000)));
      fs::copy_file(part, writing.Folder / "crash");
      REQUIRE(writer->Abandon());
      fs::rename(writing.Folder / "crash", part);
      LasReading reading(part);
      REQUIRE(reading.Read());
      CHECK(reading.CountPoints() == 130000); // the blocks that ended, without a table
    }
    REQUIRE(writer->Reopen(size, 130000, bytes));
    REQUIRE((writer->Write(second) && writer->Write(second) && writer->Close()));
  }
  vtkSMPTools::Initialize(threads);
  CHECK(writer->GetNumberOfBytes() == all);
  CHECK(writer->GetNumberOfRecords() == 144000);
  CHECK(writing.Bytes("one.laz") == writing.Bytes("two.laz"));
}

TEST_CASE("Laz: a block that is refused leaves the points before it", "[Laz]")
{
  LazWriting writing;
  vtkHeliosLASWriter* writer = writing.Writer;
  writing.Open("a.laz");
  REQUIRE(writer->Write(MakeLasEchoes(1000)));
  const auto bad = MakeLasEchoes(210000); // chunks for four threads are written
  bad->GetPoints()->SetPoint(209999, 1e9, 0.0, 0.0);
  CHECK_FALSE(writer->Write(bad));
  CHECK(writing.Log->HasError("a.laz: point 209999 of a block has the coordinate x"));
  REQUIRE((writer->Write(MakeLasEchoes(500)) && writer->Close()));
  LasReading reading(writing.Folder / "a.laz");
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 1500);
  CHECK(reading.Get(names::Range)->GetTuple1(1001) == reading.Get(names::Range)->GetTuple1(1));
}

TEST_CASE("Laz: a file without points, and count only", "[Laz]")
{
  LazWriting writing;
  writing.Open("a.laz");
  REQUIRE(writing.Writer->Close());
  LasReading reading(writing.Folder / "a.laz");
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 0);
  writing.Open("b.laz");
  REQUIRE((writing.Writer->Write(MakeLasEchoes(70000)) && writing.Writer->Close()));
  const vtkIdType bytes = writing.Writer->GetNumberOfBytes();
  writing.Writer->CountOnlyOn();
  writing.Open("c.laz");
  REQUIRE((writing.Writer->Write(MakeLasEchoes(70000)) && writing.Writer->Close()));
  CHECK(writing.Writer->GetNumberOfBytes() == bytes);
  CHECK_FALSE(fs::exists(writing.Folder / "c.laz"));
}

TEST_CASE("Laz: a full disk keeps complete blocks", "[Laz]")
{
  const helios::TempFolder folder;
  const helios::SmallDisk disk(folder / "disk", 64);
  if (!disk.IsMounted())
  {
    WARN("no small disk can be mounted here: not tested");
    return;
  }
  vtkNew<vtkHeliosLASWriter> writer;
  const auto log = helios::WatchErrors(writer);
  const std::string path = folder / "disk/points.laz";
  writer->SetFileName(path.c_str());
  writer->WriteCompressedOn();
  REQUIRE((writer->Open() && writer->Write(MakeLasEchoes(10)) && writer->EndBlock()));
  CHECK_FALSE((writer->Write(MakeLasEchoes(90000)) && writer->EndBlock()));
  CHECK(log->HasError("points.laz.part cannot be written: No space left on device; 10 records are "
                      "safe in"));
  log->Clear();
  CHECK_FALSE(writer->Close());
  CHECK(log->HasError("lacks a block that could not be written"));
  CHECK_FALSE(fs::exists(path));
  LasReading reading(path + ".part");
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 10);
}

TEST_CASE("Laz: damaged files are errors", "[Laz]")
{
  const helios::TempFolder folder;
  const std::string path = folder / "a.laz";
  LazWriting writing;
  writing.Open("a.las", false);
  REQUIRE((writing.Writer->Write(MakeLasEchoes(300)) && writing.Writer->Close()));
  const std::string las = writing.Bytes("a.las");
  const std::string whole = Pack(las);
  const std::size_t begin = GetNumber<std::uint32_t>(whole, AtPoints);
  const std::size_t record = whole.find("laszip encoded") + 52; // its data
  const std::size_t length = GetNumber<std::uint16_t>(whole, AtFormat + 1);
  const auto table = GetNumber<std::uint64_t>(whole, begin);
  const auto with = [&whole](std::size_t at, auto value)
  {
    std::string bytes = whole;
    SetNumber(bytes, at, value);
    return bytes;
  };
  const auto u16 = [](int value) { return static_cast<std::uint16_t>(value); };
  const auto u32 = [](std::uint32_t value) { return value; };
  const auto i64 = [](std::int64_t value) { return value; };
  std::string bare = las;
  bare[AtFormat] = static_cast<char>(bare[AtFormat] | 0x80);
  CHECK(FailsWith(path, bare, "has compressed points, but no record of LASzip"));
  CHECK(FailsWith(path, with(record, u16(0)), "is compressed by compressor 0, coder 0, which"));
  CHECK(FailsWith(path, with(record, u16(4)), "is compressed by compressor 4, coder 0, which"));
  CHECK(FailsWith(path, with(record + 2, u16(1)), "is compressed by compressor 3, coder 1, which"));
  CHECK(FailsWith(path, with(record + 32, u16(999)), "has a record of LASzip of "));
  CHECK(FailsWith(path, with(record + 34, u16(6)),
    "has a compressed item of type 6, version 3, with 30 bytes, which cannot be read"));
  CHECK(FailsWith(path, with(record + 38, u16(9)), "has a compressed item of type 10, version 9"));
  CHECK(
    FailsWith(path, with(record + 32, u16(1)), "has compressed items of 30 bytes that are not"));
  CHECK(FailsWith(path, with(begin, i64(0)), "has no table of its 300 points at byte 0 of"));
  CHECK(FailsWith(path, with(begin, i64(1) << 60), "has no table of its 300 points at byte 1152"));
  CHECK(FailsWith(path, with(begin, i64(-1)), "has no table of its 300 points at byte"));
  CHECK(FailsWith(path, with(table, u32(1)), "has a table of chunks that is cut off or damaged"));
  CHECK(FailsWith(path, with(table + 4, u32(1000000000)), "has a table of 1000000000 chunks for"));
  CHECK(FailsWith(path, with(247, std::uint64_t(299)),
    "has chunks with 300 points of the 299 that its header counts"));
  CHECK(FailsWith(path, with(247, std::uint64_t(1) << 50),
    "has " + std::to_string(whole.size()) +
      " bytes, too few for 1125899906842624 points; it is cut off or damaged"));
  const std::size_t layers = begin + 8 + length + 4;
  CHECK(FailsWith(
    path, with(layers, u32(0x7fffffff)), "at points 0 to 299 has a chunk with layers of"));
  CHECK(FailsWith(path, whole.substr(0, table + 4), "has no table of its 300 points at byte "));
  CHECK(FailsWith(path, whole.substr(0, begin + 4), "has no table of its 300 points at byte 0"));
  std::string cut = Pack(las, false);
  WriteFile(path, cut); // the writer was interrupted, after all points
  LasReading reading(path);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 300);
  CHECK(FailsWith(path, cut.substr(0, cut.size() - 1), "has a chunk with layers of "));
  CHECK(FailsWith(path, cut.substr(0, begin + 20), "has a chunk of 12 bytes that is cut off"));
  std::string empty = Pack(las);
  std::vector<helios::LazChunk> chunks{ { 300, 10 } };
  empty = empty.substr(0, table) + helios::EncodeLazTable(chunks);
  CHECK(FailsWith(path, empty, "has a chunk of 300 points in 10 bytes"));
  chunks = { { 300, 1 << 20 } };
  empty = empty.substr(0, table) + helios::EncodeLazTable(chunks);
  CHECK(FailsWith(path, empty, "has chunks of 1048576 bytes in "));
  chunks.assign(3, { 1, length }); // more chunks than points, where there is room for them
  empty = empty.substr(0, table) + helios::EncodeLazTable(chunks);
  SetNumber<std::uint64_t>(empty, 247, 2);
  CHECK(FailsWith(path, empty, "has chunks with 3 points of the 2 that its header counts"));
}
