// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoordinateSystem.h"
#include "heliosLasTesting.h"
#include "heliosSceneCrs.h"
#include "vtkHeliosLASWriter.h"

#include <vtkSMPTools.h>
#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace names = vtkHeliosArrayNames;
namespace fs = std::filesystem;
using helios::GetNumber;
using helios::LasReading;
using helios::MakeLasEchoes;

namespace
{

constexpr std::size_t HeaderSize = 375;

struct LasWriting
{
  helios::TempFolder Folder;
  std::string Path = this->Folder / "run/points.las";
  vtkNew<vtkHeliosLASWriter> Writer;
  vtkSmartPointer<helios::ErrorObserver> Log = helios::WatchErrors(this->Writer);

  LasWriting() { this->Writer->SetFileName(this->Path.c_str()); }

  bool WriteAll(vtkPolyData* block)
  {
    return this->Writer->Open() && this->Writer->Write(block) && this->Writer->Close();
  }
  std::string Bytes() const { return helios::ReadText(this->Path); }
};

/// Creates one or more points.
vtkSmartPointer<vtkPolyData> MakePoints(const std::vector<std::array<double, 3>>& coordinates)
{
  auto cloud = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& point : coordinates)
  {
    points->InsertNextPoint(point.data());
  }
  cloud->SetPoints(points);
  return cloud;
}

/// Copies points begin to end.
vtkSmartPointer<vtkPolyData> CopyPoints(vtkPolyData* echoes, vtkIdType begin, vtkIdType end)
{
  auto block = MakePoints({});
  vtkPointData* data = block->GetPointData();
  data->CopyAllOn();
  data->CopyAllocate(echoes->GetPointData(), end - begin);
  for (vtkIdType i = begin; i < end; ++i)
  {
    block->GetPoints()->InsertNextPoint(echoes->GetPoint(i));
    data->CopyData(echoes->GetPointData(), i, i - begin);
  }
  return block;
}

/// Checks the header and the points after it.
void CheckHeader(const std::string& bytes, std::uint64_t points)
{
  REQUIRE(bytes.size() >= HeaderSize);
  CHECK(bytes.substr(0, 4) == "LASF");
  CHECK(GetNumber<std::uint8_t>(bytes, 24) == 1);
  CHECK(GetNumber<std::uint8_t>(bytes, 25) == 4);
  CHECK(GetNumber<std::uint16_t>(bytes, 94) == HeaderSize);
  CHECK(GetNumber<std::uint64_t>(bytes, 247) == points);
  CHECK(GetNumber<std::uint32_t>(bytes, 107) == 0); // the counts of LAS 1.0
  const auto begin = GetNumber<std::uint32_t>(bytes, 96);
  const auto length = GetNumber<std::uint16_t>(bytes, 105);
  REQUIRE(bytes.size() == begin + points * length);
  std::int32_t least[3] = { INT32_MAX, INT32_MAX, INT32_MAX };
  std::int32_t most[3] = { INT32_MIN, INT32_MIN, INT32_MIN };
  std::uint64_t returns[16] = {};
  for (std::size_t i = 0; i < points; ++i)
  {
    const std::size_t at = begin + i * length;
    ++returns[GetNumber<std::uint8_t>(bytes, at + 14) & 15];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto number = GetNumber<std::int32_t>(bytes, at + 4 * k);
      least[k] = std::min(least[k], number);
      most[k] = std::max(most[k], number);
    }
  }
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto scale = GetNumber<double>(bytes, 131 + 8 * k);
    const auto offset = GetNumber<double>(bytes, 155 + 8 * k);
    CHECK(GetNumber<double>(bytes, 179 + 16 * k) == (points ? most[k] * scale + offset : 0.0));
    CHECK(GetNumber<double>(bytes, 187 + 16 * k) == (points ? least[k] * scale + offset : 0.0));
  }
  for (std::size_t i = 1; i < 16; ++i)
  {
    CHECK(GetNumber<std::uint64_t>(bytes, 255 + 8 * (i - 1)) == returns[i]);
  }
}

} // namespace

TEST_CASE("LASWriter: the part is a valid file after every block", "[LASWriter]")
{
  LasWriting writing;
  vtkHeliosLASWriter* writer = writing.Writer;
  REQUIRE(writer->Open());
  const std::string part = writing.Path + ".part";
  vtkIdType sum = 0;
  for (const vtkIdType count : { 5, 0, 40000, 1 })
  {
    REQUIRE(writer->Write(MakeLasEchoes(count)));
    sum += count;
    CheckHeader(helios::ReadText(part), static_cast<std::uint64_t>(sum));
    LasReading reading(part);
    REQUIRE(reading.Read());
    CHECK(reading.CountPoints() == sum);
    CHECK(writer->GetNumberOfRecords() == sum);
    CHECK(writer->GetNumberOfBytes() == static_cast<vtkIdType>(fs::file_size(part)));
    CHECK(writer->GetFileSize() == writer->GetNumberOfBytes());
  }
  REQUIRE(writer->Close());
  CHECK_FALSE(fs::exists(part));
  CheckHeader(writing.Bytes(), 40006);
  CHECK(writing.Log->Errors.empty());
  CHECK(writing.Log->Warnings.empty());
}

TEST_CASE("LASWriter: point fields are at the offsets of the specification", "[LASWriter]")
{
  LasWriting writing;
  const auto echo = MakePoints({ { 1000.00017, -2.00006, 3.0 }, { 1002.0, 0.0, 3.0 } });
  vtkPointData* data = echo->GetPointData();
  const auto add = [data](const char* name, int value)
  { helios::AddColumn<vtkIntArray>(data, name, 2, [value](vtkIdType) { return value; }); };
  add(names::ReturnNumber, 2);
  add(names::NumberOfReturns, 3);
  add(names::ClassificationIds, 200);
  add(names::LegIds, 6);
  add(names::ChannelIds, 6);
  add(names::UserData, 77);
  add(names::ClassificationFlags, 9);
  add(names::ScanDirectionFlag, 0);
  add(names::EdgeOfFlightLine, 1);
  helios::AddColumn<vtkDoubleArray>(data, names::GpsTime, 2, [](vtkIdType) { return 12.5; });
  helios::AddColumn<vtkDoubleArray>(data, names::Amplitude, 2, [](vtkIdType) { return 1e-9; });
  helios::AddColumn<vtkDoubleArray>(data, names::ScanAngle, 2, [](vtkIdType) { return 350.0; });
  REQUIRE(writing.WriteAll(echo));
  const std::string bytes = writing.Bytes();
  CheckHeader(bytes, 2);
  const std::size_t extras = HeaderSize + 54; // ChannelIds, Amplitude: in array order
  CHECK(bytes.substr(HeaderSize + 2, 10) == std::string("LASF_Spec\0", 10));
  CHECK(GetNumber<std::uint16_t>(bytes, HeaderSize + 18) == 4);
  CHECK(GetNumber<std::uint16_t>(bytes, HeaderSize + 20) == 2 * 192);
  CHECK(bytes[extras + 2] == 6); // int32
  CHECK(bytes.substr(extras + 4, 11) == std::string("ChannelIds\0", 11));
  CHECK(bytes[extras + 192 + 2] == 10); // double
  CHECK(bytes.substr(extras + 192 + 4, 10) == std::string("Amplitude\0", 10));
  CHECK(bytes.substr(extras + 192 + 160, 21) == std::string("peak of the echo [W]\0", 21));

  const auto at = GetNumber<std::uint32_t>(bytes, 96);
  CHECK(GetNumber<std::uint8_t>(bytes, 104) == 6);
  CHECK(GetNumber<std::uint16_t>(bytes, 105) == 30 + 4 + 8);
  CHECK(GetNumber<double>(bytes, 155) == 1000.0); // the first point in whole units
  CHECK(GetNumber<double>(bytes, 163) == -2.0);
  CHECK(GetNumber<std::int32_t>(bytes, at) == 2);      // rounded, not truncated
  CHECK(GetNumber<std::int32_t>(bytes, at + 4) == -1); // negative values too
  CHECK(GetNumber<std::int32_t>(bytes, at + 8) == 0);
  CHECK(GetNumber<std::uint16_t>(bytes, at + 12) == 6000); // 1 nW over 1 fW: 60 dB
  CHECK(GetNumber<std::uint8_t>(bytes, at + 14) == (2 | 3 << 4));
  CHECK(GetNumber<std::uint8_t>(bytes, at + 15) == (9 | 2 << 4 | 1 << 7)); // channel 6 modulo 4
  CHECK(GetNumber<std::uint8_t>(bytes, at + 16) == 200);
  CHECK(GetNumber<std::uint8_t>(bytes, at + 17) == 77);
  CHECK(GetNumber<std::int16_t>(bytes, at + 18) == -1667); // 350 degrees are -10
  CHECK(GetNumber<std::uint16_t>(bytes, at + 20) == 7);    // leg 6
  CHECK(GetNumber<double>(bytes, at + 22) == 12.5);
  CHECK(GetNumber<std::int32_t>(bytes, at + 30) == 6);
  CHECK(GetNumber<double>(bytes, at + 34) == 1e-9);
  CHECK(GetNumber<std::uint16_t>(bytes, 6) == 16); // WKT, and unknown GPS time
}

TEST_CASE("LASWriter: points without arrays are single returns", "[LASWriter]")
{
  LasWriting writing;
  REQUIRE(writing.WriteAll(MakePoints({ { 1, 2, 3 } })));
  const std::string bytes = writing.Bytes();
  CheckHeader(bytes, 1);
  REQUIRE(bytes.size() == HeaderSize + 30); // no records
  CHECK(GetNumber<std::uint8_t>(bytes, HeaderSize + 14) == 0x11);
  CHECK(GetNumber<std::uint8_t>(bytes, HeaderSize + 16) == 1); // unclassified
  CHECK(GetNumber<std::uint16_t>(bytes, HeaderSize + 20) == 0);
}

TEST_CASE("LASWriter: header: software, date and coordinate system", "[LASWriter]")
{
  LasWriting writing;
  vtkHeliosLASWriter* writer = writing.Writer;
  const auto echoes = MakeLasEchoes(3);
  helios::SetCrs(echoes, "EPSG:25832");
  helios::SetEpoch(echoes, 1.4e9);
  SECTION("no values that differ between runs by default")
  {
    REQUIRE(writing.WriteAll(echoes));
    const std::string bytes = writing.Bytes();
    CHECK(bytes.substr(26, 11) == std::string("SIMULATION\0", 11));
    CHECK(bytes.substr(58, 10) == "vtkHelios ");
    CHECK(GetNumber<std::uint32_t>(bytes, 90) == 0);
    CHECK(GetNumber<std::uint16_t>(bytes, 6) == 17); // WKT and standard time
    CHECK(GetNumber<std::uint16_t>(bytes, HeaderSize + 18) == 2112);
    CHECK(bytes.substr(HeaderSize + 54, 8) == "PROJCS[\"");
    const auto size = GetNumber<std::uint16_t>(bytes, HeaderSize + 20);
    CHECK(bytes[HeaderSize + 54 + size - 1] == '\0');
    CHECK(bytes.find("\"EPSG\",\"25832\"") < HeaderSize + 54 + size);
    const auto at = GetNumber<std::uint32_t>(bytes, 96);
    CHECK(GetNumber<double>(bytes, at + 22) == 604799.5 + 4e8);
  }
  SECTION("given values")
  {
    writer->SetCreationDay(123);
    writer->SetCreationYear(2031);
    writer->SetSystemIdentifier("a scanner with a name that is longer than 32 characters");
    REQUIRE(writing.WriteAll(echoes));
    const std::string bytes = writing.Bytes();
    CHECK(GetNumber<std::uint16_t>(bytes, 90) == 123);
    CHECK(GetNumber<std::uint16_t>(bytes, 92) == 2031);
    CHECK(bytes.substr(26, 32) == "a scanner with a name that is lo");
  }
  SECTION("epoch 0: no epoch")
  {
    helios::SetEpoch(echoes, 0.0);
    REQUIRE(writing.WriteAll(echoes));
    CHECK(GetNumber<std::uint16_t>(writing.Bytes(), 6) == 16);
  }
}

TEST_CASE("LASWriter: intensity relative to full scale, and unchanged as read", "[LASWriter]")
{
  LasWriting writing;
  const auto echoes = MakePoints({ { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } });
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double amplitudes[] = { 0.5, 2.0, -1.0, nan };
  helios::AddColumn<vtkDoubleArray>(echoes->GetPointData(), names::Amplitude, 4,
    [&amplitudes](vtkIdType i) { return amplitudes[i]; });
  const auto check = [&writing, &echoes](const std::array<int, 4>& expected)
  {
    REQUIRE(writing.WriteAll(echoes));
    const std::string bytes = writing.Bytes();
    const std::size_t length = GetNumber<std::uint16_t>(bytes, 105);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const std::size_t at = GetNumber<std::uint32_t>(bytes, 96) + i * length + 12;
      CHECK(GetNumber<std::uint16_t>(bytes, at) == expected[i]);
    }
  };
  check({ 14699, 15301, 0, 0 });
  writing.Writer->SetFullIntensity(1.0);
  check({ 32768, 65535, 0, 0 });
  helios::AddColumn<vtkIntArray>(
    echoes->GetPointData(), names::Intensity, 4, [](vtkIdType i) { return 40000 * i; });
  check({ 0, 40000, 65535, 65535 });
}

TEST_CASE("LASWriter: scale and offset", "[LASWriter]")
{
  LasWriting writing;
  const auto scaleOf = [&writing](double size)
  {
    REQUIRE(writing.WriteAll(MakePoints({ { 5e5, 5e6, 0 }, { 5e5 + size, 5e6, 0 } })));
    return GetNumber<double>(writing.Bytes(), 131);
  };
  CHECK(scaleOf(1e3) == 0.0001);
  writing.Writer->SetScale(0.001);
  CHECK(scaleOf(1e3) == 0.001);
  writing.Writer->SetScale(0.0);
  CHECK(scaleOf(1.0) == 1e-6);
  CHECK(scaleOf(200.0) == 1e-6);
  CHECK(scaleOf(300.0) == 1e-5); // 8 x 300 m are more than 2^31 micrometres
  CHECK(scaleOf(1e10) == 100.0);
  CHECK_FALSE(writing.WriteAll(MakePoints({ { 1e16, 0, 0 } })));
  CHECK(writing.Log->HasError(
    "a block has a scale of 1e-06 and an offset of 1e+16, which give no valid coordinates"));
}

TEST_CASE("LASWriter: steps by the unit of an axis, and by the file of the points", "[LASWriter]")
{
  LasWriting writing;
  using Triple = std::array<double, 3>;
  const auto get = [&writing](const std::string& crs, double size, const Triple& scale,
                     const Triple* offset = nullptr)
  {
    const auto points = MakePoints({ { 8.7, 49.4, 0 }, { 8.7 + size, 49.4, 0 } });
    helios::SetCRS(points, crs);
    helios::CoordinateSteps steps;
    steps.Scale = scale;
    steps.HasOffset = offset != nullptr;
    steps.Offset = offset ? *offset : Triple();
    helios::SetCoordinateSteps(points, steps);
    REQUIRE(writing.WriteAll(points));
    const std::string bytes = writing.Bytes();
    return Triple{ GetNumber<double>(bytes, 131), GetNumber<double>(bytes, 139),
      GetNumber<double>(bytes, 147) };
  };
  const double none = std::numeric_limits<double>::infinity();
  const Triple unknown{ none, none, none };
  CHECK(get("EPSG:25832", 1.0, unknown) == Triple{ 1e-4, 1e-4, 1e-4 });
  CHECK(get("EPSG:2263", 1.0, unknown) == Triple{ 1e-4, 1e-4, 1e-4 });
  CHECK(get("EPSG:4326", 0.01, unknown) == Triple{ 1e-9, 1e-9, 1e-4 });
  CHECK(get("EPSG:4326", 2.0, unknown) == Triple{ 1e-8, 1e-9, 1e-4 }); // room for 16 degrees
  CHECK(get("EPSG:4326", 0.01, { 1e-7, 1e-7, 1e-5 }) == Triple{ 1e-9, 1e-9, 1e-5 });
  CHECK(get("EPSG:25832", 1.0, { 0.01, 0.00025, 2e-5 }) == Triple{ 1e-4, 1e-4, 1e-5 });
  const Triple offset{ 8.5, 49.25, 0.125 };
  CHECK(get("", 0.1, { 1e-7, 2e-7, 0.01 }, &offset) == Triple{ 1e-7, 2e-7, 0.01 });
  CHECK(GetNumber<double>(writing.Bytes(), 155) == 8.5);
  writing.Writer->SetScale(0.001); // the wanted one
  CHECK(get("EPSG:25832", 1.0, { 1e-5, 1e-5, 1e-5 }, &offset) == Triple{ 0.001, 0.001, 0.001 });
}

TEST_CASE("LASWriter: colours make format 7", "[LASWriter]")
{
  LasWriting writing;
  const auto echoes = MakePoints({ { 0, 0, 0 } });
  const auto check = [&](vtkDataArray* colors, double r, double g, double b)
  {
    colors->SetName(names::RGB);
    colors->SetNumberOfComponents(3);
    colors->InsertNextTuple3(r, g, b);
    echoes->GetPointData()->AddArray(colors);
    REQUIRE(writing.WriteAll(echoes));
    const std::string bytes = writing.Bytes();
    REQUIRE(bytes.size() == HeaderSize + 36);
    CHECK(bytes[104] == 7);
    CHECK(GetNumber<std::uint16_t>(bytes, HeaderSize + 30) == 65535);
    CHECK(GetNumber<std::uint16_t>(bytes, HeaderSize + 32) == 0);
    CHECK(GetNumber<std::uint16_t>(bytes, HeaderSize + 34) == 13107);
  };
  check(vtkNew<vtkFloatArray>(), 1.0, 0.0, 0.2);
  check(vtkNew<vtkUnsignedCharArray>(), 255, 0, 51);
}

TEST_CASE("LASWriter: without Extra Bytes", "[LASWriter]")
{
  LasWriting writing;
  writing.Writer->WriteExtraBytesOff();
  REQUIRE(writing.WriteAll(MakeLasEchoes(7)));
  CHECK(writing.Bytes().size() == HeaderSize + 7 * 30);
}

TEST_CASE("LASWriter: byte-identical for any number of threads", "[LASWriter]")
{
  LasWriting writing;
  const auto echoes = MakeLasEchoes(100000);
  std::string texts[2];
  for (const int threads : { 1, 4 })
  {
    vtkSMPTools::Initialize(threads);
    REQUIRE(writing.WriteAll(echoes));
    texts[threads / 4] = writing.Bytes();
  }
  CHECK(texts[0] == texts[1]);
  vtkSMPTools::Initialize();
}

TEST_CASE("LASWriter: byte-identical for any block size", "[LASWriter]")
{
  LasWriting writing;
  const auto echoes = MakeLasEchoes(1000);
  REQUIRE(writing.WriteAll(echoes));
  const std::string whole = writing.Bytes();
  for (const vtkIdType size : { 1, 7, 400 })
  {
    INFO(size);
    REQUIRE(writing.Writer->Open());
    for (vtkIdType first = 0; first < 1000; first += size)
    {
      REQUIRE(
        writing.Writer->Write(CopyPoints(echoes, first, std::min(first + size, vtkIdType(1000)))));
    }
    REQUIRE(writing.Writer->Close());
    CHECK((writing.Bytes() == whole)); // equal, without printing
  }
}

TEST_CASE("LASWriter: a file without blocks has no points", "[LASWriter]")
{
  LasWriting writing;
  REQUIRE(writing.Writer->Open());
  REQUIRE(writing.Writer->Write(MakePoints({})));
  const bool isClosed = GENERATE(true, false);
  REQUIRE((isClosed ? writing.Writer->Close() : writing.Writer->Abandon()));
  const std::string path = isClosed ? writing.Path : writing.Path + ".part";
  CheckHeader(helios::ReadText(path), 0);
  LasReading reading(path);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 0);
}

TEST_CASE("LASWriter: resumes a file", "[LASWriter]")
{
  LasWriting writing;
  vtkHeliosLASWriter* writer = writing.Writer;
  const auto make = [](vtkIdType count)
  {
    auto block = MakeLasEchoes(count);
    helios::SetCrs(block, "EPSG:25832+7837");
    helios::SetEpoch(block, 1.3e9);
    return block;
  };
  const auto run = [&](const std::string& name)
  {
    writer->SetFileName((writing.Folder / name).c_str());
    REQUIRE(writer->Open());
    REQUIRE((writer->Write(make(20)) && writer->Write(make(5000))));
  };
  run("whole.las");
  const vtkIdType size = writer->GetFileSize();
  REQUIRE((writer->Write(make(40)) && writer->Close()));
  const vtkIdType bytes = writer->GetNumberOfBytes();
  run("broken.las");
  const std::string part = writing.Folder / "broken.las.part";
  SECTION("abandoned")
  {
    REQUIRE((writer->Write(make(7)) && writer->Abandon()));
  }
  SECTION("closed")
  {
    REQUIRE((writer->Write(make(7000)) && writer->Close()));
  }
  SECTION("before the header included the block")
  {
    REQUIRE(writer->Abandon());
    std::string text = helios::ReadText(part);
    helios::SetNumber<std::uint64_t>(text, 247, 20);
    std::ofstream(part, std::ios::binary) << text << "rest of a block";
  }
  REQUIRE((!writer->IsOpen() || writer->Abandon()));
  const bool isOpen = writer->Reopen(size, 5020, size);
  INFO(writing.Log->Errors);
  REQUIRE(isOpen);
  CheckHeader(helios::ReadText(part), 5020); // immediately
  const auto other = make(1);
  SECTION("with another epoch")
  {
    helios::SetEpoch(other, 0.0);
    CHECK_FALSE(writer->Write(other));
    CHECK(writing.Log->HasError("a block has another GpsEpoch than those before"));
  }
  SECTION("with other arrays")
  {
    other->GetPointData()->RemoveArray(names::Amplitude);
    CHECK_FALSE(writer->Write(other));
    CHECK(writing.Log->HasError("a block has other arrays than those before"));
  }
  REQUIRE((writer->Write(make(40)) && writer->Flush() && writer->Close()));
  CHECK(writer->GetNumberOfRecords() == 5060);
  CHECK(writer->GetNumberOfBytes() == bytes);
  CHECK(helios::ReadText(writing.Folder / "whole.las") ==
    helios::ReadText(writing.Folder / "broken.las"));
}

TEST_CASE("LASWriter: resumes an empty file", "[LASWriter]")
{
  LasWriting writing;
  REQUIRE((writing.Writer->Open() && writing.Writer->Abandon()));
  REQUIRE(writing.Writer->Reopen(0, 0, 0));
  REQUIRE((writing.Writer->Write(MakeLasEchoes(3)) && writing.Writer->Close()));
  CheckHeader(writing.Bytes(), 3);
}

TEST_CASE("LASWriter: refuses to resume a file of another program", "[LASWriter]")
{
  LasWriting writing;
  vtkHeliosLASWriter* writer = writing.Writer;
  REQUIRE((writer->Open() && writer->Write(MakeLasEchoes(3)) && writer->Abandon()));
  const vtkIdType size = static_cast<vtkIdType>(fs::file_size(writing.Path + ".part"));
  CHECK_FALSE(writer->Reopen(size, 2, size));
  CHECK(writing.Log->HasError("points.las.part has 3 points, not 2, and cannot be resumed"));
  CHECK_FALSE(writer->IsOpen());
  CHECK_FALSE(writer->Reopen(300, 2, 300)); // truncated within the header
  CHECK(writing.Log->HasError("points.las.part: ends within its header, after 300 bytes"));
  CHECK_FALSE(writer->Reopen(size, 2, size));
  CHECK(writing.Log->HasError("it has 300 bytes of"));
}

TEST_CASE("LASWriter: count only: nothing is written", "[LASWriter]")
{
  LasWriting writing;
  REQUIRE(writing.WriteAll(MakeLasEchoes(500)));
  const vtkIdType bytes = writing.Writer->GetNumberOfBytes();
  writing.Writer->SetFileName((writing.Folder / "counted/points.las").c_str());
  writing.Writer->CountOnlyOn();
  REQUIRE(writing.WriteAll(MakeLasEchoes(500)));
  CHECK(writing.Writer->GetNumberOfBytes() == bytes);
  CHECK_FALSE(fs::exists(writing.Folder / "counted"));
}

TEST_CASE("LASWriter: values that do not fit are reported once", "[LASWriter]")
{
  LasWriting writing;
  const auto echoes = helios::MakeEchoes(4); // 200 returns; classes 6 and -2
  REQUIRE((writing.Writer->Open() && writing.Writer->Write(echoes)));
  CHECK(
    writing.Log->HasWarning("4 points of a block have a ReturnNumber or NumberOfReturns above 15"));
  CHECK(writing.Log->HasWarning("2 points of a block have ClassificationIds beyond 0 to 255"));
  writing.Log->Clear();
  REQUIRE((writing.Writer->Write(echoes) && writing.Writer->Close()));
  CHECK(writing.Log->Warnings.empty());
  LasReading reading(writing.Path);
  REQUIRE(reading.Read());
  CHECK(reading.Get(names::NumberOfReturns)->GetTuple1(0) == 15);
  CHECK(reading.Get(names::ClassificationIds)->GetTuple1(0) == 6);
  CHECK(reading.Get(names::ClassificationIds)->GetTuple1(1) == 1);

  helios::SetCrs(echoes, "ENU 49.4 8.7 110");
  REQUIRE(writing.WriteAll(echoes));
  CHECK(writing.Log->HasWarning(
    "the CRS ENU 49.4 8.7 110 cannot be written as WKT; the file has no CRS"));
}

TEST_CASE("LASWriter: points beyond the limits of LAS are errors", "[LASWriter]")
{
  LasWriting writing;
  vtkHeliosLASWriter* writer = writing.Writer;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const bool isFirst = GENERATE(true, false);
  REQUIRE(writer->Open());
  const auto good = MakePoints({ { 10, 0, 0 } });
  const auto block = MakePoints({ { 10, 0, 0 }, { 11, 0, 0 }, { 12, 0, 0 } });
  if (!isFirst)
  {
    REQUIRE(writer->Write(good));
  }
  std::string expected;
  SECTION("not a number")
  {
    block->GetPoints()->SetPoint(1, 0, nan, 0);
    expected = "point 1 of a block has the coordinate y = nan, which is not a number";
  }
  SECTION("infinite")
  {
    block->GetPoints()->SetPoint(2, 0, 0, -1.0 / 0.0);
    expected = "point 2 of a block has the coordinate z = -inf, which is not a number";
  }
  SECTION("too far away")
  {
    block->GetPoints()->SetPoint(0, isFirst ? 1e6 : 214760, 0, 0);
    expected = isFirst
      ? "point 1 of a block has the coordinate x = 11, more than 214748.3647 from 1000000, the "
        "limit of 32 bits with Scale 0.0001; set a larger Scale"
      : "point 0 of a block has the coordinate x = 214760, more than 214748.3647 from 10,";
  }
  SECTION("a time")
  {
    helios::AddColumn<vtkDoubleArray>(
      block->GetPointData(), names::GpsTime, 3, [nan](vtkIdType i) { return i == 1 ? nan : 0.0; });
    expected = "point 1 of a block has GpsTime = nan, which is not a number";
  }
  SECTION("a leg")
  {
    helios::AddColumn<vtkIntArray>(
      block->GetPointData(), names::LegIds, 3, [](vtkIdType i) { return 65533 + i; });
    expected = "point 2 of a block has LegIds = 65535, outside the range -1 to 65534";
  }
  CHECK_FALSE(writer->Write(block));
  CHECK(writing.Log->HasError(writing.Path + ": " + expected));
  REQUIRE((writer->Write(good) && writer->Close())); // another block is accepted
  CheckHeader(writing.Bytes(), isFirst ? 1 : 2);
  CHECK(GetNumber<double>(writing.Bytes(), 155) == 10.0); // unaffected by the bad block
}

TEST_CASE(
  "LASWriter: a large block with a bad point at its end is dropped completely", "[LASWriter]")
{
  LasWriting writing;
  REQUIRE((writing.Writer->Open() && writing.Writer->Write(MakePoints({ { 0, 0, 0 } }))));
  const std::string before = helios::ReadText(writing.Path + ".part");
  auto* points = vtkPoints::New(VTK_DOUBLE);
  const auto block = MakePoints({});
  block->SetPoints(points);
  points->Delete();
  points->SetNumberOfPoints(600000); // more than fit in memory at a time, for up to 18 threads
  points->GetData()->Fill(1.0);
  points->SetPoint(599999, 0, 0, std::numeric_limits<double>::quiet_NaN());
  CHECK_FALSE(writing.Writer->Write(block));
  CHECK(writing.Log->HasError("point 599999 of a block has the coordinate z = nan"));
  CHECK((before == helios::ReadText(writing.Path + ".part")));
  REQUIRE(writing.Writer->Close());
}

TEST_CASE("LASWriter: bad blocks are errors", "[LASWriter]")
{
  LasWriting writing;
  vtkHeliosLASWriter* writer = writing.Writer;
  const auto block = MakeLasEchoes(4);
  vtkPointData* data = block->GetPointData();
  CHECK_FALSE(writer->Write(block));
  CHECK(writing.Log->HasError("is not open"));
  REQUIRE((writer->Open() && writer->Write(MakeLasEchoes(2))));
  const auto fails = [&](const std::string& message)
  { return !writer->Write(block) && writing.Log->HasError(message); };
  SECTION("a table")
  {
    CHECK_FALSE(writer->Write(vtkNew<vtkTable>()));
    CHECK(writing.Log->HasError("a block is vtkTable, not vtkPolyData"));
  }
  SECTION("floats")
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0, 0, 0);
    block->SetPoints(points);
    CHECK(fails("the points of a block are float, not double"));
  }
  SECTION("other arrays than in earlier blocks")
  {
    data->RemoveArray(names::EchoWidth);
    CHECK(fails("a block has other arrays than those before, which had the Extra Bytes PulseIds "
                "(type 8), Amplitude (type 10), EchoWidth (type 10)"));
  }
  SECTION("colours missing in earlier blocks")
  {
    helios::AddVectors(block, vtkNew<vtkFloatArray>(), names::RGB, 0.5);
    CHECK(fails("a block has other arrays than those before"));
  }
  SECTION("another system")
  {
    helios::SetCrs(block, "EPSG:25832");
    CHECK(fails("a block has the CRS \"EPSG:25832\", unlike those before"));
  }
  SECTION("no system")
  {
    helios::SetCrs(block, "EPSG:1");
    CHECK(fails("the field array CRS of a block: \"EPSG:1\" is not a coordinate system"));
  }
  SECTION("WKT longer than a record")
  {
    helios::CoordinateSystem system;
    REQUIRE(system.Set("EPSG:25832").IsOk());
    std::string wkt = system.GetWkt();
    wkt.insert(wkt.find("ETRS89 / UTM"), std::string(66000, 'x'));
    helios::SetCrs(block, wkt);
    CHECK(fails("the CRS of a block is longer than the 65534 characters of a record"));
  }
  SECTION("another epoch")
  {
    helios::SetEpoch(block, 1e9 + 1.0);
    CHECK(fails("a block has another GpsEpoch than those before"));
  }
  SECTION("no epoch")
  {
    helios::SetEpoch(block, std::numeric_limits<double>::infinity());
    CHECK(fails("the field array GpsEpoch of a block is not one number"));
  }
  SECTION("an array too short")
  {
    helios::AddColumn<vtkIntArray>(data, names::LegIds, 2, [](vtkIdType) { return 0; });
    CHECK(fails("the array LegIds of a block has 2 x 1 values, not 4 x 1"));
  }
  SECTION("numbers that are not integers")
  {
    helios::AddColumn<vtkFloatArray>(data, names::ReturnNumber, 4, [](vtkIdType) { return 1; });
    CHECK(fails("the array ReturnNumber of a block holds float; it must hold integers"));
  }
  SECTION("texts")
  {
    vtkNew<vtkStringArray> words;
    words->SetName("Words");
    words->SetNumberOfValues(4);
    data->AddArray(words);
    CHECK(fails("the array Words of a block is not numeric or has no name"));
  }
  SECTION("a name that is too long")
  {
    helios::AddColumn<vtkIntArray>(
      data, "a name of 33 characters, not less", 4, [](vtkIdType) { return 0; });
    CHECK(fails("the array a name of 33 characters, not less of a block cannot be Extra Bytes"));
  }
  SECTION("too many arrays")
  {
    for (int i = 0; i < 340; ++i)
    {
      helios::AddColumn<vtkUnsignedCharArray>(
        data, std::to_string(i).c_str(), 4, [](vtkIdType) { return 0; });
    }
    CHECK(fails("a block has more arrays than Extra Bytes can hold, 341 numbers"));
  }
  REQUIRE((writer->Write(MakeLasEchoes(3)) && writer->Close())); // another block is accepted
  CheckHeader(writing.Bytes(), 5);
}

TEST_CASE("LASWriter: a full disk keeps complete blocks", "[LASWriter]")
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
  const std::string path = folder / "disk/points.las";
  writer->SetFileName(path.c_str());
  REQUIRE((writer->Open() && writer->Write(MakeLasEchoes(10))));
  CHECK_FALSE(writer->Write(MakeLasEchoes(5000)));
  CHECK(log->HasError("points.las.part cannot be written: No space left on device; 10 records are "
                      "safe in"));
  CheckHeader(helios::ReadText(path + ".part"), 10);
  log->Clear();
  CHECK_FALSE(writer->Close());
  CHECK(log->HasError("lacks a block that could not be written"));
  CHECK_FALSE(fs::exists(path));
  CheckHeader(helios::ReadText(path + ".part"), 10);
}
