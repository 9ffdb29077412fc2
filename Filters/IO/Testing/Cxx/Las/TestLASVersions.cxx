// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// LAS files of other programs: versions, formats, epochs, colours, flags, Extra Bytes.
#include "heliosLasTesting.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace names = vtkHeliosArrayNames;
using helios::AddRecord;
using helios::GetNumber;
using helios::LasReading;
using helios::MakeExtra;
using helios::MakeOld;
using helios::SetNumber;

namespace
{

const helios::TempFolder Folder;
const std::string Path = Folder / "a.las";

void WriteFile(const std::string& bytes)
{
  std::ofstream(Path, std::ios::binary) << bytes;
}

} // namespace

TEST_CASE("LASReader: all versions and formats", "[LASReader]")
{
  const int lengths[] = { 20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67 };
  const int format = GENERATE(range(0, 11));
  const int minor = format > 5 ? GENERATE(4, 5) : GENERATE(range(0, 5));
  const bool hasTime = format != 0 && format != 2;
  const bool hasColor =
    format == 2 || format == 3 || format == 5 || format == 7 || format == 8 || format == 10;
  const auto length = static_cast<std::uint16_t>(lengths[format] + 3); // undocumented bytes
  std::string bytes = MakeOld(minor, format, 2, length);
  const std::size_t at = GetNumber<std::uint32_t>(bytes, 96) + length;
  const bool isLong = format > 5;
  SetNumber<std::int32_t>(bytes, at, -150);
  SetNumber<std::int32_t>(bytes, at + 8, 2147483647);
  SetNumber<std::uint16_t>(bytes, at + 12, 40000);
  bytes[at + 14] = static_cast<char>(isLong ? 0xF2 : 0xEA); // return 2; 15, or 5 and both flags
  if (isLong)
  {
    bytes[at + 15] = static_cast<char>(0xE4);
    bytes[at + 16] = static_cast<char>(200);
    SetNumber<std::int16_t>(bytes, at + 18, -15000);
    SetNumber<std::uint16_t>(bytes, at + 20, 65535);
  }
  else
  {
    bytes[at + 15] = static_cast<char>(0x89);
    bytes[at + 16] = static_cast<char>(-90);
    SetNumber<std::uint16_t>(bytes, at + 18, 65535);
  }
  bytes[at + 17] = 7;
  const std::size_t time = isLong ? 22 : 20;
  const std::size_t color = isLong ? 30 : hasTime ? 28 : 20;
  if (hasTime)
  {
    SetNumber(bytes, at + time, 1234.5);
  }
  if (hasColor)
  {
    SetNumber<std::uint16_t>(bytes, at + color + 2, 65535);
  }
  if (format == 8 || format == 10)
  {
    SetNumber<std::uint16_t>(bytes, at + 36, 999);
  }
  WriteFile(bytes);
  LasReading reading(Path);
  INFO("format " << format << " of LAS 1." << minor);
  REQUIRE(reading.Read());
  REQUIRE(reading.CountPoints() == 2);
  const auto get = [&reading](const char* name)
  { return reading.Get(name) ? reading.Get(name)->GetComponent(1, 0) : -99.0; };
  CHECK(reading.Cloud()->GetPoint(1)[0] == -1.5);
  CHECK(reading.Cloud()->GetPoint(1)[1] == 100.0);
  CHECK(reading.Cloud()->GetPoint(1)[2] == 2147483647 * 0.01 + 200.0);
  CHECK(get(names::Intensity) == 40000);
  CHECK(get(names::ReturnNumber) == 2);
  CHECK(get(names::NumberOfReturns) == (isLong ? 15 : 5));
  CHECK(get(names::ScanDirectionFlag) == 1);
  CHECK(get(names::EdgeOfFlightLine) == 1);
  CHECK(get(names::ClassificationFlags) == 4); // withheld
  CHECK(get(names::ClassificationIds) == (isLong ? 200 : 9));
  CHECK(get(names::ChannelIds) == (isLong ? 2 : -99));
  CHECK(get(names::ScanAngle) == -90);
  CHECK(get(names::UserData) == 7);
  CHECK(get(names::LegIds) == 65534);
  CHECK(get(names::GpsTime) == (hasTime ? 1234.5 : -99));
  CHECK((reading.Get(names::RGB) != nullptr) == hasColor);
  CHECK((!hasColor || reading.Get(names::RGB)->GetComponent(1, 1) == 1.0));
  CHECK(get(names::NearInfrared) == (format == 8 || format == 10 ? 999 : -99));
  CHECK(reading.Get(names::LegIds)->GetTuple1(0) == -1);
  CHECK_FALSE(reading.Cloud()->GetFieldData()->HasArray(names::GpsEpoch));
  CHECK_FALSE(reading.Cloud()->GetFieldData()->HasArray(names::CRS));
}

TEST_CASE("LASReader: the epoch of the times", "[LASReader]")
{
  struct Case
  {
    int Minor;
    int Encoding;
    double Epoch; // 0: none
  };
  const auto given =
    GENERATE(Case{ 0, 1, 0.0 }, Case{ 1, 1, 0.0 }, Case{ 2, 1, 1e9 }, Case{ 2, 0, 0.0 },
      Case{ 4, 1 | 64, 1e9 }, Case{ 5, 1, 1e9 }, Case{ 5, 1 | 64, 1.4e9 }, Case{ 5, 64, 0.0 });
  std::string bytes = MakeOld(given.Minor, given.Minor == 5 ? 6 : 1, 1, 30);
  SetNumber(bytes, 6, static_cast<std::uint16_t>(given.Encoding));
  if (given.Minor == 5)
  {
    SetNumber<std::uint16_t>(bytes, 391, 1400); // 1e6 s
  }
  WriteFile(bytes);
  LasReading reading(Path);
  REQUIRE(reading.Read());
  INFO("LAS 1." << given.Minor << ", encoding " << given.Encoding);
  auto* epoch =
    vtkArrayDownCast<vtkDoubleArray>(reading.Cloud()->GetFieldData()->GetArray(names::GpsEpoch));
  CHECK((epoch ? epoch->GetValue(0) : 0.0) == given.Epoch);
}

TEST_CASE("LASReader: colours of 8 bits", "[LASReader]")
{
  std::string bytes = MakeOld(2, 2, 3, 26);
  const std::size_t at = GetNumber<std::uint32_t>(bytes, 96) + 20;
  SetNumber<std::uint16_t>(bytes, at, 255);
  WriteFile(bytes);
  LasReading reading(Path);
  const auto red = [&reading](int row) { return reading.Get(names::RGB)->GetComponent(row, 0); };
  REQUIRE(reading.Read());
  CHECK(red(0) == 1.0);
  CHECK(reading.Log->HasWarning(Path + ": its colours have 8 bits: they are scaled by 257 to the"));
  REQUIRE(reading.Read(0, 3));
  CHECK(red(0) == 1.0);
  CHECK(reading.Log->Warnings.empty());          // once per file
  SetNumber<std::uint16_t>(bytes, at + 52, 256); // value of the last point: 16 bits, in all pieces
  WriteFile(bytes);
  REQUIRE(reading.Read(0, 3));
  CHECK(red(0) == Approx(255.0 / 65535.0));
  CHECK(reading.Log->Warnings.empty());
  SetNumber<std::uint16_t>(bytes, at + 52, 0);
  bytes.replace(58, 10, "vtkHelios "); // always 16 bits
  WriteFile(bytes);
  REQUIRE(reading.Read());
  CHECK(red(0) == Approx(255.0 / 65535.0));
}

TEST_CASE("LASReader: withheld points", "[LASReader]")
{
  const int format = GENERATE(0, 6);
  std::string bytes = MakeOld(4, format, 3, 30);
  const std::size_t at = GetNumber<std::uint32_t>(bytes, 96) + 30;
  bytes[at + 15] = static_cast<char>(format == 0 ? 0x80 : 4);
  bytes[at + 30 + 15] = static_cast<char>(format == 0 ? 0x20 : 1); // synthetic
  WriteFile(bytes);
  LasReading reading(Path);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 3);
  reading.Reader->SkipWithheldOn();
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 2);
  CHECK(reading.Get(names::ClassificationFlags)->GetNumberOfTuples() == 2);
  CHECK(reading.Get(names::ClassificationFlags)->GetTuple1(1) == 1);
  CHECK(reading.Log->HasWarning(Path + ": 1 of 3 points are withheld; they are left out"));
}

TEST_CASE("LASReader: Extra Bytes without a value", "[LASReader]")
{
  std::string bytes = MakeOld(4, 6, 2, 30 + 2 + 4 + 8);
  std::string extras =
    MakeExtra("short", 4, 1) + MakeExtra("float", 9, 1) + MakeExtra("long", 8, 1);
  SetNumber<std::int64_t>(extras, 40, -9999);
  SetNumber(extras, 192 + 40, 0.1);
  SetNumber<std::int64_t>(extras, 2 * 192 + 40, -1);
  AddRecord(bytes, "LASF_Spec", 4, extras);
  const std::size_t at = GetNumber<std::uint32_t>(bytes, 96) + 30;
  SetNumber<std::int16_t>(bytes, at, -9999);
  SetNumber(bytes, at + 2, 0.1F);
  SetNumber<std::int64_t>(bytes, at + 6, -1);
  WriteFile(bytes);
  LasReading reading(Path);
  REQUIRE(reading.Read());
  CHECK(std::isnan(reading.Get("short")->GetTuple1(0)));
  CHECK(reading.Get("short")->GetTuple1(1) == 0.0);
  CHECK(std::isnan(reading.Get("float")->GetTuple1(0)));
  CHECK(reading.Get("float")->GetDataType() == VTK_FLOAT);
  CHECK(reading.Get("long")->GetTuple1(0) == -1.0);
  CHECK(
    reading.Log->HasWarning(Path + ": Extra Bytes \"long\" have -1 where there is no value; it"));
}

TEST_CASE("LASReader: Extra Bytes of other programs", "[LASReader]")
{
  std::string bytes = MakeOld(2, 0, 1, 20 + 3 + 2 + 4 + 12 + 1);
  std::string extras = MakeExtra("gap", 0, 3) + MakeExtra("Deviation", 3, 24) +
    MakeExtra("pair", 14) + MakeExtra("normal", 29);
  SetNumber(extras, 192 + 112, 0.01); // scale
  SetNumber(extras, 192 + 136, -1.0); // offset
  AddRecord(bytes, "LASF_Spec", 4, extras);
  const std::size_t at = GetNumber<std::uint32_t>(bytes, 96) + 20;
  SetNumber<std::uint16_t>(bytes, at + 3, 250);
  SetNumber<std::int16_t>(bytes, at + 5, -3);
  SetNumber<std::int16_t>(bytes, at + 7, 4);
  SetNumber<float>(bytes, at + 17, 0.5F);
  WriteFile(bytes);
  LasReading reading(Path);
  REQUIRE(reading.Read());
  CHECK_FALSE(reading.Get("gap"));
  CHECK(reading.Log->HasWarning(Path +
    ": its points have 4 bytes that no Extra Bytes record describes by type and name; they"));
  REQUIRE(reading.Get("Deviation"));
  CHECK(reading.Get("Deviation")->GetDataType() == VTK_DOUBLE);
  CHECK(reading.Get("Deviation")->GetTuple1(0) == 1.5);
  REQUIRE(reading.Get("pair"));
  CHECK(reading.Get("pair")->GetDataType() == VTK_SHORT);
  CHECK(reading.Get("pair")->GetNumberOfComponents() == 2);
  CHECK(reading.Get("pair")->GetComponent(0, 0) == -3);
  CHECK(reading.Get("pair")->GetComponent(0, 1) == 4);
  REQUIRE(reading.Get("normal"));
  CHECK(reading.Get("normal")->GetComponent(0, 2) == 0.5);
}
