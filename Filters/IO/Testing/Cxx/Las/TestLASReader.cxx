// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCoordinateSystem.h"
#include "heliosLasTesting.h"
#include "heliosSceneCrs.h"
#include "vtkHeliosLASWriter.h"

#include <vtkCallbackCommand.h>

#include <catch2/catch.hpp>

#include <limits>

#include <sys/stat.h>

namespace names = vtkHeliosArrayNames;
using helios::AddRecord;
using helios::CountWrong;
using helios::GetNumber;
using helios::LasReading;
using helios::MakeLasEchoes;
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

std::string WriteEchoes(vtkPolyData* echoes)
{
  vtkNew<vtkHeliosLASWriter> writer;
  writer->SetFileName(Path.c_str());
  REQUIRE((writer->Open() && writer->Write(echoes) && writer->Close()));
  return helios::ReadText(Path);
}

/// Whether reading the bytes fails with a message and without points.
bool FailsWith(const std::string& bytes, const std::string& message)
{
  WriteFile(bytes);
  LasReading reading(Path);
  const bool isRead = reading.Read();
  INFO(reading.Log->Errors);
  CHECK(reading.Log->HasError(Path + ": " + message));
  return !isRead && reading.CountPoints() == 0;
}

} // namespace

TEST_CASE("LASReader: written files are read back", "[LASReader]")
{
  const auto echoes = MakeLasEchoes(50000);
  helios::SetCrs(echoes, "EPSG:25832");
  helios::SetEpoch(echoes, 1.4e9);
  WriteEchoes(echoes);
  LasReading reading(Path);
  REQUIRE(reading.Read());
  vtkPolyData* cloud = reading.Cloud();
  REQUIRE(cloud->GetNumberOfPoints() == 50000);
  CHECK(cloud->GetPoints()->GetDataType() == VTK_DOUBLE);
  CHECK(CountWrong(cloud->GetPoints()->GetData(), echoes->GetPoints()->GetData(), 0,
          0.5 * 0.0001 + 1e-9) == 0);
  vtkPointData* data = echoes->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    const std::string name = data->GetArrayName(i);
    vtkDataArray* written = data->GetArray(i);
    vtkDataArray* read = reading.Get(name.c_str());
    INFO(name);
    REQUIRE(read);
    CHECK(read->GetDataType() == written->GetDataType());
    if (name == names::GpsTime)
    {
      continue; // different epoch
    }
    CHECK(CountWrong(read, written, 0, name == names::ScanAngle ? 1e-12 : 0.0) == 0);
  }
  helios::CoordinateSystem written, read;
  CHECK(written.Set("EPSG:25832").IsOk());
  CHECK(read.Set(helios::GetCRS(cloud)).IsOk());
  CHECK(written == read);
  const double epoch = cloud->GetFieldData()->GetArray(names::GpsEpoch)->GetTuple1(0);
  CHECK(epoch == 1e9);
  CHECK(epoch + reading.Get(names::GpsTime)->GetTuple1(7) ==
    Approx(1.4e9 + data->GetArray(names::GpsTime)->GetTuple1(7)).epsilon(1e-15));
  CHECK(vtkTypeInt64Array::SafeDownCast(reading.Get(names::PulseIds)));
}

TEST_CASE("LASReader: a file read and written is byte-identical", "[LASReader]")
{
  const auto echoes = MakeLasEchoes(500);
  helios::AddVectors(echoes, vtkNew<vtkFloatArray>(), names::RGB, 0.5);
  helios::SetCrs(echoes, "EPSG:32632");
  const bool hasEpoch = GENERATE(true, false);
  helios::SetEpoch(echoes, hasEpoch ? 1.4e9 : 0.0);
  const std::string bytes = WriteEchoes(echoes);
  LasReading reading(Path);
  REQUIRE(reading.Read());
  CHECK(GetNumber<std::uint8_t>(bytes, 104) == 7);
  vtkNew<vtkPolyData> cloud;
  cloud->DeepCopy(reading.Cloud());
  const std::string first = WriteEchoes(cloud);
  LasReading again(Path);
  REQUIRE(again.Read());
  cloud->DeepCopy(again.Cloud());
  CHECK(first == WriteEchoes(cloud));
  // ChannelIds now precede other arrays; otherwise the points are the same
  REQUIRE(first.size() == bytes.size());
  const auto begin = GetNumber<std::uint32_t>(bytes, 96);
  const auto length = GetNumber<std::uint16_t>(bytes, 105);
  CHECK(first.substr(0, 375) == bytes.substr(0, 375));
  for (std::size_t at = begin; at < bytes.size(); at += length)
  {
    REQUIRE(first.substr(at, 36) == bytes.substr(at, 36));
  }
}

TEST_CASE("LASReader: pieces in order equal the whole", "[LASReader]")
{
  const auto echoes = MakeLasEchoes(40001);
  WriteEchoes(echoes);
  LasReading reading(Path);
  const int pieces = GENERATE(1, 3, 7);
  vtkIdType sum = 0;
  for (int piece = 0; piece < pieces; ++piece)
  {
    REQUIRE(reading.Read(piece, pieces));
    vtkDataArray* ids = reading.Get(names::PulseIds);
    for (vtkIdType i = 0; i < reading.CountPoints(); i += 1000)
    {
      CHECK(ids->GetTuple1(i) == 5e9 + static_cast<double>(sum + i));
    }
    CHECK(std::abs(reading.CountPoints() - 40001 / pieces) <= 1);
    sum += reading.CountPoints();
  }
  CHECK(sum == 40001);
}

TEST_CASE("LASReader: decibels have the names of RIEGL in the file", "[LASReader]")
{
  const auto echoes = MakeLasEchoes(100);
  vtkPointData* data = echoes->GetPointData();
  for (const char* name : { names::RelativeAmplitude, names::Reflectance })
  {
    helios::AddColumn<vtkDoubleArray>(
      data, name, 100, [](vtkIdType i) { return 0.37 * static_cast<double>(i) - 10.0; });
  }
  WriteEchoes(echoes);
  const std::string bytes = helios::ReadText(Path);
  const auto has = [&bytes](const char* name, const char* description)
  {
    const std::size_t at = bytes.find(name + std::string(32 - std::strlen(name), '\0'));
    return at != std::string::npos &&
      bytes.compare(at + 156, std::strlen(description), description) == 0;
  };
  CHECK(has("Amplitude", "Echo signal amplitude [dB]"));
  CHECK(has("Reflectance", "Echo signal reflectance [dB]"));
  CHECK(has("Pulse width", "Full width at half maximum [ns]"));
  CHECK(has("Received power", "peak of the echo [W]"));
  CHECK(bytes.find("EchoWidth") == std::string::npos);
  LasReading reading(Path);
  REQUIRE(reading.Read());
  for (const char* name :
    { names::RelativeAmplitude, names::Reflectance, names::Amplitude, names::EchoWidth })
  {
    INFO(name);
    REQUIRE(reading.Get(name));
    CHECK(CountWrong(reading.Get(name), data->GetArray(name), 0, 0.0) == 0);
  }
}

TEST_CASE("LASReader: coordinate systems of other programs", "[LASReader]")
{
  const auto read = [](const std::string& bytes)
  {
    WriteFile(bytes);
    LasReading reading(Path);
    REQUIRE(reading.Read());
    return helios::GetCRS(reading.Cloud());
  };
  const auto keys = [](const std::vector<std::uint16_t>& words)
  {
    std::string bytes(2 * words.size(), '\0');
    std::memcpy(bytes.data(), words.data(), bytes.size());
    return bytes;
  };
  std::string bytes = MakeOld(2, 0, 1, 20);
  SECTION("projected and vertical")
  {
    AddRecord(bytes, "LASF_Projection", 34735,
      keys({ 1, 1, 0, 3, 1024, 0, 1, 1, 3072, 0, 1, 25832, 4096, 0, 1, 7837 }));
    CHECK(read(bytes) == "EPSG:25832+7837");
  }
  SECTION("geographic")
  {
    AddRecord(bytes, "LASF_Projection", 34735, keys({ 1, 1, 0, 1, 2048, 0, 1, 4326 }));
    CHECK(read(bytes) == "EPSG:4326");
  }
  SECTION("written by vtkHelios")
  {
    AddRecord(bytes, "LASF_Projection", 34735, keys({ 1, 1, 0, 1, 3072, 0, 1, 32767 }));
    CHECK(read(bytes).empty());
  }
  SECTION("WKT has precedence over keys")
  {
    AddRecord(bytes, "LASF_Projection", 34735, keys({ 1, 1, 0, 1, 2048, 0, 1, 4326 }));
    AddRecord(bytes, "LASF_Projection", 2112, std::string("LOCAL_CS[\"x\"]\0\0", 15));
    CHECK(read(bytes) == "LOCAL_CS[\"x\"]");
  }
  SECTION("WKT after the points")
  {
    bytes = MakeOld(4, 6, 1, 30);
    SetNumber<std::uint64_t>(bytes, 235, bytes.size());
    SetNumber<std::uint32_t>(bytes, 243, 1);
    std::string record(60, '\0');
    record.replace(2, 15, "LASF_Projection");
    SetNumber<std::uint16_t>(record, 18, 2112);
    SetNumber<std::uint64_t>(record, 20, 10);
    CHECK(FailsWith(bytes + record + "EPSG:2583", "has an extended record of 10 bytes at byte"));
    CHECK(read(bytes + record + "EPSG:25832") == "EPSG:25832");
  }
}

TEST_CASE("LASReader: vertical keys and units of other programs", "[LASReader]")
{
  const auto read = [](std::vector<std::uint16_t> keys)
  {
    std::vector<std::uint16_t> words{ 1, 1, 0, static_cast<std::uint16_t>(keys.size() / 2) };
    for (std::size_t i = 0; i + 1 < keys.size(); i += 2)
    {
      words.insert(words.end(), { keys[i], 0, 1, keys[i + 1] });
    }
    std::string record(2 * words.size(), '\0');
    std::memcpy(record.data(), words.data(), record.size());
    std::string bytes = MakeOld(2, 0, 1, 20);
    AddRecord(bytes, "LASF_Projection", 34735, record);
    WriteFile(bytes);
    LasReading reading(Path);
    REQUIRE(reading.Read());
    return helios::GetCRS(reading.Cloud());
  };
  const auto unitOf = [](const std::string& crs)
  {
    helios::CoordinateSystem system;
    CAPTURE(crs);
    REQUIRE(system.Set(crs).Message() == "");
    CHECK(system.HasHeightUnit());
    CHECK(system.GetUnit() == Approx(1200.0 / 3937.0));
    return system.GetHeightUnit();
  };
  CHECK(read({ 3072, 2263 }) == "EPSG:2263");
  CHECK(unitOf(read({ 3072, 2263, 4099, 9001 })) == 1.0);
  CHECK(unitOf(read({ 3072, 2263, 4099, 9002 })) == 0.3048);
  CHECK(unitOf(read({ 3072, 2263, 4099, 9003 })) == Approx(1200.0 / 3937.0).epsilon(1e-12));
  CHECK(read({ 3072, 2263, 4096, 5703 }) == "EPSG:2263+5703");
  CHECK(read({ 3072, 2263, 4096, 5703, 4099, 9001 }) == "EPSG:2263+5703");
  CHECK(read({ 3072, 2263, 4096, 5703, 4099, 9003 }) == "EPSG:2263+6360");
  CHECK(read({ 3072, 2263, 4096, 5703, 4099, 9002 }) == "EPSG:2263+8228");
  CHECK(read({ 3072, 2263, 4096, 5103 }) == "EPSG:2263+5703"); // GeoTIFF 1.0
  CHECK(read({ 3072, 2263, 4096, 5103, 4099, 9003 }) == "EPSG:2263+6360");
  CHECK(unitOf(read({ 3072, 2263, 4096, 5702, 4099, 9001 })) == 1.0); // NGVD29 is in feet
  CHECK(read({ 3072, 25832, 4096, 5030 }) == "EPSG:25832");           // above the ellipsoid
  CHECK(read({ 3072, 25832, 4096, 32767 }) == "EPSG:25832");
  CHECK(read({ 3072, 25832, 4099, 9001 }).find("COMPOUNDCRS[") == 0);
  // a map by parameters is not its geographic base
  CHECK(read({ 1024, 1, 2048, 4269, 3072, 32767 }).empty());
  CHECK(read({ 1024, 1, 2048, 4269 }).empty());
  CHECK(read({ 1024, 2, 2048, 4269 }) == "EPSG:4269");
}

TEST_CASE("LASReader: a record that is no WKT is no system", "[LASReader]")
{
  std::string bytes = MakeOld(2, 0, 4, 20);
  AddRecord(bytes, "LASF_Projection", 2112, std::string("\"\"\0", 3));
  WriteFile(bytes);
  LasReading reading(Path);
  reading.Reader->UpdatePiece(0, 2, 0);
  CHECK(helios::GetCRS(reading.Cloud()).empty());
  CHECK(reading.Log->HasWarning("its coordinate system is not known and is ignored: \"\"\"\" is "
                                "not a coordinate system known to PROJ"));
  reading.Log->Clear();
  reading.Reader->UpdatePiece(1, 2, 0); // once a file
  CHECK_FALSE(reading.Log->HasWarning("coordinate system"));
}

TEST_CASE("LASReader: damaged files are errors", "[LASReader]")
{
  const std::string good = WriteEchoes(MakeLasEchoes(10));
  const auto with = [&good](std::size_t at, auto value)
  {
    std::string bytes = good;
    SetNumber(bytes, at, value);
    return bytes;
  };
  const auto u8 = [](int value) { return static_cast<std::uint8_t>(value); };
  const auto u16 = [](int value) { return static_cast<std::uint16_t>(value); };
  const std::size_t length = GetNumber<std::uint16_t>(good, 105);
  CHECK(FailsWith("", "is not a LAS file: it does not start with LASF"));
  CHECK(FailsWith("PK" + good, "is not a LAS file"));
  CHECK(FailsWith(good.substr(0, 100), "ends within its header, after 100 bytes"));
  CHECK(FailsWith(good.substr(0, 300), "ends within its header, after 300 bytes"));
  CHECK(FailsWith(good.substr(0, 375), "has 375 bytes, and its points begin at byte"));
  CHECK(FailsWith(good.substr(0, good.size() - 1),
    "has 9 whole points of the 10 that its header counts: it is cut off"));
  CHECK(FailsWith(good.substr(0, good.size() - 3 * length), "has 7 whole points of the 10"));
  CHECK(FailsWith(with(24, u8(2)), "is LAS 2.4; versions 1.0 to 1.5 can be read"));
  CHECK(FailsWith(with(25, u8(6)), "is LAS 1.6; versions 1.0 to 1.5 can be read"));
  CHECK(FailsWith(with(25, u8(5)), "has a header of 375 bytes; LAS 1.5 has 393"));
  CHECK(FailsWith(with(94, u16(227)), "has a header of 227 bytes; LAS 1.4 has 375"));
  CHECK(FailsWith(with(96, std::uint32_t(374)), "has points from byte 374 on, within its header"));
  CHECK(FailsWith(with(104, u8(11)), "has points of format 11; 0 to 10 can be read"));
  CHECK(FailsWith(
    with(104, u8(0x86)), "has compressed points, but no record of LASzip; copy it again"));
  CHECK(FailsWith(with(105, u16(29)), "has points of 29 bytes; format 6 needs 30"));
  CHECK(
    FailsWith(with(105, u16(30)), "has points with 0 bytes after their format, but describes "));
  CHECK(FailsWith(with(107, std::uint32_t(9)), "states two numbers of points, 10 and 9"));
  CHECK(FailsWith(with(247, ~std::uint64_t(0)), "has 10 whole points of the 18446744073709551615"));
  CHECK(FailsWith(with(131, 0.0), "has a scale of 0 and an offset of 500000, which give"));
  CHECK(FailsWith(with(131, 1e-320), "has a scale of 9.99989e-321 and an offset of 500000, which"));
  CHECK(FailsWith(with(131, std::nan("")), "has a scale of nan and an offset of 500000, which"));
  CHECK(FailsWith(with(155, 1e20),
    "has a scale of 0.0001 and an offset of 1e+20, which give no valid coordinates: a scale is at "
    "least 1e-15, a coordinate at most 1e+15"));
  CHECK(FailsWith(with(139, 1e308), "has a scale of 1e+308 and an offset of 5.5e+06, which"));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(FailsWith(with(171, nan), "has a scale of 0.0001 and an offset of nan, which give"));
  CHECK(FailsWith(with(100, std::uint32_t(9)), "has a variable length record at byte"));
  CHECK(FailsWith(with(375 + 20, u16(65535)), "has a variable length record of 65535 bytes at"));
  CHECK(FailsWith(with(375 + 20, u16(191)), "has an Extra Bytes record of 191 bytes"));
  CHECK(FailsWith(with(375 + 54 + 2, u8(31)), "has Extra Bytes \"PulseIds\" of type 31; types"));
  std::string scaled = with(375 + 54 + 3, u8(8)); // Extra Bytes with a scale
  SetNumber(scaled, 375 + 54 + 112, std::nan(""));
  CHECK(FailsWith(scaled, "has Extra Bytes \"PulseIds\" whose scale or offset is not a number"));
  CHECK(FailsWith(with(243, std::uint32_t(1)), "has an extended record of"));
  std::string extended = with(243, std::uint32_t(1));
  SetNumber(extended, 235, ~std::uint64_t(0));
  CHECK(FailsWith(extended, "has an extended record at byte 18446744073709551615 that ends after"));
  WriteFile(good);
  CHECK(LasReading(Path).Read());
}

TEST_CASE("LASReader: times that are not finite are counted", "[LASReader]")
{
  std::string bytes = WriteEchoes(MakeLasEchoes(10));
  const std::size_t length = GetNumber<std::uint16_t>(bytes, 105);
  for (const std::size_t row : { 2, 7 })
  {
    SetNumber(bytes, GetNumber<std::uint32_t>(bytes, 96) + row * length + 22, std::nan(""));
  }
  WriteFile(bytes);
  LasReading reading(Path);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 10);
  CHECK(
    reading.Log->HasWarning(Path + ": GpsTime is not finite at 2 of 10 points, and is kept so"));
  reading.Log->Clear();
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty()); // once per file
}

TEST_CASE("LASReader: invalid names", "[LASReader]")
{
  vtkNew<vtkHeliosLASReader> reader;
  const auto log = helios::WatchErrors(reader);
  const auto quiet = helios::WatchErrors(reader->GetExecutive());
  reader->Update();
  CHECK(log->HasError("FileName is not set"));
  LasReading none(Folder / "none.las");
  CHECK_FALSE(none.Read());
  CHECK(none.Log->HasError("none.las: cannot be read: No such file or directory"));
  LasReading folder(Folder / "");
  CHECK_FALSE(folder.Read());
  CHECK(folder.Log->HasError("is a folder; give the name of a file"));
  REQUIRE(::mkfifo((Folder / "pipe.las").c_str(), 0600) == 0);
  LasReading pipe(Folder / "pipe.las");
  CHECK_FALSE(pipe.Read());
  CHECK(pipe.Log->HasError("pipe.las: cannot be read: it is a FIFO, not a regular file"));
  LasReading device("/dev/zero");
  CHECK_FALSE(device.Read());
  CHECK(device.Log->HasError(
    "/dev/zero: cannot be read: it is a character device, not a regular file"));
}

TEST_CASE("LASReader: a file removed while it is read", "[LASReader]")
{
  WriteEchoes(MakeLasEchoes(40000));
  LasReading reading(Path);
  const auto cut = vtkSmartPointer<helios::FileCut>::New();
  cut->Path = Path;
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, cut);
  CHECK_FALSE(reading.Read());
  CHECK(
    reading.Log->HasError(Path + ": its points 16384 to 32767 cannot be read; has it changed?"));
  CHECK(reading.CountPoints() == 0);
}

TEST_CASE("LASReader: abort", "[LASReader]")
{
  WriteEchoes(MakeLasEchoes(40000));
  LasReading reading(Path);
  vtkNew<vtkCallbackCommand> abort;
  abort->SetCallback([](vtkObject* reader, unsigned long, void*, void*)
    { static_cast<vtkAlgorithm*>(reader)->SetAbortExecute(1); });
  const unsigned long tag = reading.Reader->AddObserver(vtkCommand::ProgressEvent, abort);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError(Path + ": reading was aborted at point 16384; update again"));
  CHECK(reading.CountPoints() == 0);
  reading.Reader->RemoveObserver(tag);
  reading.Reader->SetAbortExecute(0); // see heliosAborts.h
  CHECK(reading.Read());              // and read again
  CHECK(reading.CountPoints() == 40000);
}
