// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Waveforms of a LAS file: packets in a .wdp, and the point fields that refer to them.
#include "heliosLasWaveTesting.h"

#include <filesystem>
#include <fstream>
#include <limits>

#include <sys/stat.h>

namespace names = vtkHeliosArrayNames;
namespace fs = std::filesystem;
using helios::GetNumber;

TEST_CASE("LASWaveforms: packets hold the samples, points refer to them", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  const auto first = helios::MakeWaveforms(60);
  const auto second = helios::MakeWaveforms(7);
  REQUIRE((writing.Writer->Open() && writing.Write(first)));
  helios::CheckFileHead(helios::ReadText(writing.Packets + ".part"));
  helios::CheckPackets(helios::ReadText(writing.Path + ".part"),
    helios::ReadText(writing.Packets + ".part"), first, helios::MakeEchoesOf(first), 0);
  REQUIRE((writing.Write(second) && writing.Writer->Flush()));
  const std::string part = helios::ReadText(writing.Packets + ".part");
  REQUIRE(writing.Writer->Close());
  CHECK(writing.Log->Errors.empty());
  const std::string las = helios::ReadText(writing.Path);
  const std::string packets = helios::ReadText(writing.Packets);
  CHECK((part == packets));
  CHECK_FALSE(fs::exists(writing.Packets + ".part"));
  helios::CheckFileHead(packets);
  CHECK(GetNumber<std::uint8_t>(las, 104) == 9);
  CHECK(GetNumber<std::uint16_t>(las, 6) == (16 | 4)); // WKT, packets in another file
  CHECK(GetNumber<std::uint64_t>(las, 227) == 0);
  helios::CheckPackets(las, packets, first, helios::MakeEchoesOf(first), 0);
  helios::CheckPackets(las, packets, second, helios::MakeEchoesOf(second), 180);
  CHECK(writing.Writer->GetNumberOfBytes() == static_cast<vtkIdType>(las.size() + packets.size()));
  helios::LasReading reading(writing.Path);
  REQUIRE(reading.Read());
  CHECK(reading.CountPoints() == 201);
}

TEST_CASE("LASWaveforms: samples of any amplitude keep 23 bits", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  const auto waveforms = helios::MakeWaveforms(200);
  auto* samples = vtkFloatArray::SafeDownCast(waveforms->GetFieldData()->GetArray(names::Samples));
  auto* offsets = vtkDataArray::SafeDownCast(waveforms->GetColumnByName(names::Offset));
  auto* counts = vtkDataArray::SafeDownCast(waveforms->GetColumnByName(names::Count));
  for (vtkIdType wave = 0; wave < 200; ++wave)
  {
    const auto at = static_cast<vtkIdType>(offsets->GetTuple1(wave));
    for (vtkIdType i = 0; i < static_cast<vtkIdType>(counts->GetTuple1(wave)); ++i)
    {
      const double strength = std::pow(10.0, -15.5 + 0.08 * static_cast<double>(wave));  // to 2.6 W
      samples->SetValue(at + i, static_cast<float>(strength * std::sin(1.0 + 7.0 * i))); // negative
    }
  }
  REQUIRE((writing.Writer->Open() && writing.Write(waveforms) && writing.Writer->Close()));
  helios::CheckPackets(helios::ReadText(writing.Path), helios::ReadText(writing.Packets), waveforms,
    helios::MakeEchoesOf(waveforms), 0);
}

TEST_CASE("LASWaveforms: with colours the format is 10", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  const auto waveforms = helios::MakeWaveforms(20);
  const auto echoes = helios::MakeEchoesOf(waveforms);
  helios::AddVectors(echoes, vtkNew<vtkFloatArray>(), names::RGB, 0.5);
  writing.Writer->SetWaveforms(waveforms);
  REQUIRE((writing.Writer->Open() && writing.Writer->Write(echoes) && writing.Writer->Close()));
  const std::string las = helios::ReadText(writing.Path);
  CHECK(GetNumber<std::uint8_t>(las, 104) == 10);
  const helios::LasWavePacket packet(las, 5, 38);
  CHECK(packet.Index > 0);
  CHECK(packet.Location == Approx(400.0).margin(0.02));
  helios::LasReading reading(writing.Path);
  REQUIRE(reading.Read());
  CHECK(reading.Get(names::NearInfrared)->GetRange()[1] == 0.0);
  CHECK(helios::CountWrong(reading.Get(names::RGB), echoes->GetPointData()->GetArray(names::RGB), 0,
          1.0 / 65535) == 0);
}

TEST_CASE("LASWaveforms: are resumed", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  vtkHeliosLASWriter* writer = writing.Writer;
  const auto run = [&](const std::string& name)
  {
    writer->SetFileName((writing.Folder / (name + ".las")).c_str());
    // at first no pulse has a waveform: the sample spacing is not known yet
    const auto none = helios::MakeEchoesOf(helios::MakeWaveforms(4));
    helios::AddColumn<vtkTypeInt64Array>(
      none->GetPointData(), names::WaveformIds, 12, [](vtkIdType) { return -1; });
    writer->SetWaveforms(nullptr);
    REQUIRE((writer->Open() && writer->Write(none) && writing.Write(helios::MakeWaveforms(6))));
  };
  run("whole");
  const vtkIdType size = writer->GetFileSize();
  const vtkIdType bytes = writer->GetNumberOfBytes();
  REQUIRE((writing.Write(helios::MakeWaveforms(9)) && writer->Close()));
  const vtkIdType all = writer->GetNumberOfBytes();
  run("broken");
  const bool isClosed = GENERATE(true, false);
  REQUIRE(writing.Write(helios::MakeWaveforms(20)));
  REQUIRE((isClosed ? writer->Close() : writer->Abandon()));
  writer->WriteWaveformsOff();
  CHECK_FALSE(writer->Reopen(size, 30, bytes));
  CHECK(
    writing.Log->HasError("broken.las.part has waveforms; switch WriteWaveforms on, as it was"));
  writer->WriteWaveformsOn();
  if (GENERATE(true, false))
  {
    fs::remove(writing.Folder / "broken.wdp");
    fs::remove(writing.Folder / "broken.wdp.part");
    CHECK_FALSE(writer->Reopen(size, 30, bytes));
    CHECK(writing.Log->HasError("broken.wdp.part cannot be resumed: No such file"));
    CHECK_FALSE(writer->IsOpen());
    return;
  }
  REQUIRE(writer->Reopen(size, 30, bytes));
  helios::CheckFileHead(helios::ReadText(writing.Folder / "broken.wdp.part"));
  REQUIRE((writing.Write(helios::MakeWaveforms(9)) && writer->Close()));
  CHECK(writer->GetNumberOfBytes() == all);
  for (const char* ending : { ".las", ".wdp" })
  {
    CHECK((helios::ReadText(writing.Folder / (std::string("whole") + ending)) ==
      helios::ReadText(writing.Folder / (std::string("broken") + ending))));
  }
}

TEST_CASE("LASWaveforms: are read back", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  const auto waveforms = helios::MakeWaveforms(60);
  const auto echoes = helios::MakeEchoesOf(waveforms);
  auto* starts = vtkDataArray::SafeDownCast(waveforms->GetColumnByName(names::StartTime));
  const bool hasRange = GENERATE(true, false);
  if (hasRange)
  {
    helios::AddColumn<vtkDoubleArray>(echoes->GetPointData(), names::Range, 180,
      [=](vtkIdType i) {
        return 0.5e-9 * helios::LasSpeedOfLight * (starts->GetTuple1(i / 3) + 0.2 * double(i % 3));
      });
  }
  else
  {
    echoes->GetPointData()->RemoveArray(names::Range);
  }
  writing.Writer->SetWaveforms(waveforms);
  REQUIRE((writing.Writer->Open() && writing.Writer->Write(echoes)));
  const bool isPart = GENERATE(true, false);
  REQUIRE((isPart ? writing.Writer->Abandon() : writing.Writer->Close()));
  helios::LasReading reading(isPart ? writing.Path + ".part" : writing.Path);
  REQUIRE(reading.Read());
  auto* table = vtkTable::SafeDownCast(reading.Reader->GetOutputDataObject(1));
  REQUIRE(table);
  CHECK(table->GetNumberOfRows() == 0); // not requested
  reading.Reader->ReadWaveformsOn();
  const int pieces = GENERATE(1, 5); // pieces of 36 points, 12 waveforms
  vtkIdType wave = 0;
  vtkIdType wrong = 0;
  for (int piece = 0; piece < pieces; ++piece)
  {
    REQUIRE(reading.Read(piece, pieces));
    const auto get = [table](const char* name, vtkIdType row, int k = 0)
    {
      auto* array = vtkDataArray::SafeDownCast(table->GetColumnByName(name));
      return array ? array->GetComponent(row, k) : std::nan("");
    };
    for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row, ++wave)
    {
      wave += wave % 5 == 4 ? 1 : 0; // without a packet
      const auto expected = [&waveforms, wave](const char* name, int k = 0) {
        return vtkDataArray::SafeDownCast(waveforms->GetColumnByName(name))->GetComponent(wave, k);
      };
      const double start = expected(names::StartTime);
      const double skipped = hasRange ? 0.0 : 0.5e-9 * helios::LasSpeedOfLight * start; // [m]
      REQUIRE(get(names::PulseIds, row) == expected(names::PulseIds));
      REQUIRE(get(names::StartTime, row) == Approx(hasRange ? start : 0.0).margin(1e-4));
      REQUIRE(get(names::BinSize, row) == 0.25);
      for (int k = 0; k < 3; ++k)
      {
        const double direction = expected(names::Direction, k);
        REQUIRE(get(names::Direction, row, k) == Approx(direction).margin(1e-7));
        REQUIRE(get(names::Origin, row, k) ==
          Approx(expected(names::Origin, k) + skipped * direction).margin(2e-4));
      }
      auto* read = table->GetFieldData()->GetArray(names::Samples);
      auto* written = waveforms->GetFieldData()->GetArray(names::Samples);
      const auto from = static_cast<vtkIdType>(expected(names::Offset));
      const auto at = static_cast<vtkIdType>(get(names::Offset, row));
      const auto count = static_cast<vtkIdType>(get(names::Count, row));
      REQUIRE(count <= static_cast<vtkIdType>(expected(names::Count)));
      for (vtkIdType i = 0; i < static_cast<vtkIdType>(expected(names::Count)); ++i)
      {
        const double value = i < count ? read->GetTuple1(at + i) : 0.0;
        wrong += std::abs(value - written->GetTuple1(from + i)) <= 1e-6 / (1 << 23) ? 0 : 1;
      }
    }
  }
  CHECK(wave == 59); // the last one has no packet
  CHECK(wrong == 0);
}

TEST_CASE("LASWaveforms: packets inside the LAS file", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  const auto waveforms = helios::MakeWaveforms(4);
  REQUIRE((writing.Writer->Open() && writing.Write(waveforms) && writing.Writer->Close()));
  std::string las = helios::ReadText(writing.Path);
  helios::SetNumber<std::uint16_t>(las, 6, 16 | 2);
  helios::SetNumber<std::uint64_t>(las, 227, las.size());
  helios::SetNumber<std::uint64_t>(las, 235, las.size());
  helios::SetNumber<std::uint32_t>(las, 243, 1);
  std::ofstream(writing.Path, std::ios::binary) << las << helios::ReadText(writing.Packets);
  fs::remove(writing.Packets);
  helios::LasReading reading(writing.Path);
  reading.Reader->ReadWaveformsOn();
  REQUIRE(reading.Read());
  auto* table = vtkTable::SafeDownCast(reading.Reader->GetOutputDataObject(1));
  REQUIRE(table->GetNumberOfRows() == 4);
  const auto* last = vtkFloatArray::SafeDownCast(table->GetFieldData()->GetArray(names::Samples));
  CHECK(last->GetValue(last->GetNumberOfValues() - 1) == Approx(9e-9)); // 1 + 2 + 3 + 4 samples
}

TEST_CASE("LASWaveforms: packets that are short, missing or compressed", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  REQUIRE(
    (writing.Writer->Open() && writing.Write(helios::MakeWaveforms(4)) && writing.Writer->Close()));
  const std::string packets = helios::ReadText(writing.Packets);
  const auto fails = [&writing](const std::string& message)
  {
    helios::LasReading reading(writing.Path);
    const bool isPlain = reading.Read(); // the points are there without waveforms
    reading.Reader->ReadWaveformsOn();
    const bool isRead = reading.Read();
    INFO(reading.Log->Errors);
    CHECK(reading.Log->HasError(message));
    return isPlain && !isRead;
  };
  std::ofstream(writing.Packets, std::ios::binary) << packets.substr(0, packets.size() - 1);
  CHECK(fails(", beyond the end of " + writing.Packets));
  std::filesystem::remove(writing.Packets);
  CHECK(fails(writing.Packets + ": cannot be read, but holds the waveforms of"));
  const std::string compressed =
    std::filesystem::path(writing.Packets).replace_extension(".wdz").string();
  std::ofstream(compressed, std::ios::binary) << "something";
  CHECK(fails(compressed + ": compressed waveforms (.wdz) cannot be read; decompress them to " +
    writing.Packets));
}

TEST_CASE("LASWaveforms: damaged packets are errors", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  REQUIRE(
    (writing.Writer->Open() && writing.Write(helios::MakeWaveforms(4)) && writing.Writer->Close()));
  const std::string good = helios::ReadText(writing.Path);
  const std::string packets = helios::ReadText(writing.Packets);
  const std::size_t at = GetNumber<std::uint32_t>(good, 96) + 30;
  const auto fails = [&](const std::string& las, const std::string& message)
  {
    std::ofstream(writing.Path, std::ios::binary) << las;
    helios::LasReading reading(writing.Path);
    const bool isPlain = reading.Read();
    reading.Reader->ReadWaveformsOn();
    const bool isRead = reading.Read();
    INFO(reading.Log->Errors);
    CHECK(reading.Log->HasError(message));
    return isPlain && !isRead && reading.CountPoints() == 0;
  };
  const auto with = [&good](std::size_t place, auto value)
  {
    std::string las = good;
    helios::SetNumber(las, place, value);
    return las;
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(fails(with(at, std::uint8_t(253)),
    "point 0 of the piece refers to waveform descriptor 253, which the file does not have"));
  CHECK(fails(with(at + 1, std::uint64_t(packets.size() - 63)),
    "point 0 of the piece has a packet of 64 bytes at " + std::to_string(packets.size() - 63) +
      ", beyond the end of " + writing.Packets));
  CHECK(fails(with(at + 1, ~std::uint64_t(0)), "beyond the end of"));
  CHECK(fails(with(at + 9, std::uint32_t(63)), "has a packet of 63 bytes; its descriptor has 64"));
  CHECK(fails(with(at + 13, nan), "has a waveform without a direction or position"));
  CHECK(fails(with(at + 17, nan), "has a waveform without a direction or position"));
  CHECK(fails(with(at + 13, 1e30F), "has a waveform without a direction or position"));
  CHECK(fails(with(at + 17, 1e30F), "has a waveform without a direction or position"));
  std::size_t record = 375; // the first descriptor, after the Extra Bytes
  record += 54 + GetNumber<std::uint16_t>(good, record + 20) + 54;
  CHECK(fails(
    with(record, std::uint8_t(12)), "has a waveform descriptor 1 that does not have 8, 16 or"));
  CHECK(fails(with(record + 1, std::uint8_t(1)), "bits without compression"));
  std::string empty = good; // an empty descriptor is valid unless a point refers to it
  empty.replace(record + 80, 26, 26, '\0'); // the second
  std::ofstream(writing.Path, std::ios::binary) << empty;
  helios::LasReading reading(writing.Path);
  reading.Reader->ReadWaveformsOn();
  const bool isRead = reading.Read();
  INFO(reading.Log->Errors);
  CHECK(isRead);
  helios::SetNumber(empty, at, std::uint8_t(2));
  CHECK(fails(empty, "point 0 of the piece refers to waveform descriptor 2, which has no samples"));
  std::string overlapping = good; // 12 points, each with its own packet from byte 60 on
  for (std::uint64_t i = 0; i < 12; ++i)
  {
    const std::size_t place = at + i * GetNumber<std::uint16_t>(good, 105);
    overlapping.replace(place, 29, good.substr(at, 29));
    helios::SetNumber(overlapping, place + 1, 60 + i);
  }
  CHECK(fails(overlapping,
    "the points of the piece refer to packets of 768 bytes, but " + writing.Packets +
      " has 316: packets overlap"));
  CHECK(
    fails(with(record + 10, std::nan("")), "a waveform descriptor 1 whose gain is not a number"));
  CHECK(fails(with(record + 10, 1e300), "whose gain is not a number, or too large for samples"));
  CHECK(fails(with(record + 6, std::uint32_t(0)),
    "refers to waveform descriptor 1, whose sample spacing is 0"));
  fs::remove(writing.Packets);
  CHECK(fails(good, writing.Packets + ": cannot be read, but holds the waveforms of"));
  REQUIRE(::mkfifo(writing.Packets.c_str(), 0600) == 0);
  CHECK(fails(good, writing.Packets + ": cannot be read: it is a FIFO, not a regular file"));
}

TEST_CASE("LASWaveforms: the packet file cannot be created or kept", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  SECTION("a folder has its name")
  {
    fs::create_directory(writing.Packets);
    CHECK_FALSE(writing.Writer->Open());
    CHECK(writing.Log->HasError(writing.Packets + " is a folder, not a file"));
    CHECK_FALSE(writing.Writer->IsOpen());
  }
  SECTION("it is removed")
  {
    REQUIRE((writing.Writer->Open() && writing.Write(helios::MakeWaveforms(6))));
    fs::remove(writing.Packets + ".part");
    const bool isFlushed = GENERATE(true, false);
    CHECK_FALSE((isFlushed ? writing.Writer->Flush() : writing.Writer->Close()));
    CHECK(writing.Log->HasError("points.wdp.part was removed while it was written"));
    CHECK_FALSE(writing.Writer->Close());
    CHECK_FALSE(fs::exists(writing.Path));
  }
  SECTION("the disk is full")
  {
    const helios::SmallDisk disk(writing.Folder / "disk", 128);
    if (!disk.IsMounted())
    {
      WARN("no small disk can be mounted here: not tested");
      return;
    }
    const std::string path = writing.Folder / "disk/points";
    writing.Writer->SetFileName((path + ".las").c_str());
    REQUIRE((writing.Writer->Open() && writing.Write(helios::MakeWaveforms(6))));
    const std::string las = helios::ReadText(path + ".las.part");
    const std::string packets = helios::ReadText(path + ".wdp.part");
    CHECK_FALSE(writing.Write(helios::MakeWaveforms(5000)));
    CHECK(writing.Log->HasError("points.wdp.part cannot be written: No space left on device; 18 "
                                "records are safe in"));
    CHECK((las == helios::ReadText(path + ".las.part")));
    CHECK((packets == helios::ReadText(path + ".wdp.part")));
    CHECK_FALSE(writing.Writer->Close());
  }
}

TEST_CASE("LASWaveforms: packets removed while they are read", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  REQUIRE(
    (writing.Writer->Open() && writing.Write(helios::MakeWaveforms(6)) && writing.Writer->Close()));
  helios::LasReading reading(writing.Path);
  reading.Reader->ReadWaveformsOn();
  const auto cut = vtkSmartPointer<helios::FileCut>::New();
  cut->Path = writing.Packets;
  reading.Reader->AddObserver(vtkCommand::ProgressEvent, cut);
  CHECK_FALSE(reading.Read());
  CHECK(reading.Log->HasError("has a packet that cannot be read; has " + writing.Packets));
  CHECK(reading.CountPoints() == 0);
}

TEST_CASE("LASWaveforms: no waveforms", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  const bool isCounted = GENERATE(true, false);
  writing.Writer->SetCountOnly(isCounted);
  REQUIRE((writing.Writer->Open() && writing.Writer->Close()));
  CHECK(fs::exists(writing.Packets) != isCounted);
  CHECK(writing.Writer->GetNumberOfBytes() == 60 + 375 + 252 * 80);
  if (!isCounted)
  {
    helios::CheckFileHead(helios::ReadText(writing.Packets));
    CHECK(GetNumber<std::uint8_t>(helios::ReadText(writing.Path), 104) == 9);
    CHECK(helios::LasReading(writing.Path).Read());
  }
}

TEST_CASE("LASWaveforms: bad input is an error", "[LASWaveforms]")
{
  helios::LasWaveWriting writing;
  const bool isFirst = GENERATE(true, false);
  const auto good = helios::MakeWaveforms(6);
  REQUIRE((writing.Writer->Open() && (isFirst || writing.Write(good))));
  const auto waveforms = helios::MakeWaveforms(6);
  const auto echoes = helios::MakeEchoesOf(waveforms);
  vtkFieldData* rows = waveforms->GetRowData();
  auto* samples = vtkFloatArray::SafeDownCast(waveforms->GetFieldData()->GetArray(names::Samples));
  const auto setBins = [rows](double first, double others)
  {
    helios::AddColumn<vtkDoubleArray>(
      rows, names::BinSize, 6, [=](vtkIdType i) { return i == 0 ? first : others; });
  };
  SECTION("no ids")
  {
    echoes->GetPointData()->RemoveArray(names::WaveformIds);
    CHECK(writing.Fails(echoes, waveforms, "a block has no array WaveformIds; switch"));
  }
  SECTION("no waveforms")
  {
    CHECK(writing.Fails(echoes, nullptr,
      "point 0 of a block has WaveformIds = 40, and the waveforms of the block have no such "
      "pulse"));
  }
  SECTION("an invalid table")
  {
    rows->RemoveArray(names::StartTime);
    CHECK(writing.Fails(echoes, waveforms, "the table of waveforms of a block has no array"));
  }
  SECTION("half a picosecond")
  {
    setBins(0.2505, 0.2505);
    CHECK(writing.Fails(echoes, waveforms, "have a BinSize of 0.250500 ns; LAS stores whole pico"));
  }
  SECTION("several bins")
  {
    setBins(0.25, 0.5);
    CHECK(writing.Fails(echoes, waveforms, "a BinSize of 500 ps and one of 250 ps; write them to"));
  }
  SECTION("other bins than in earlier blocks")
  {
    setBins(0.5, 0.5);
    if (isFirst)
    {
      return;
    }
    CHECK(writing.Fails(echoes, waveforms, "a BinSize of 500 ps, and those before 250 ps; write"));
  }
  SECTION("not a number")
  {
    samples->SetValue(1, std::numeric_limits<float>::quiet_NaN());
    CHECK(
      writing.Fails(echoes, waveforms, "the waveform of pulse 43 has 2 samples of up to inf W"));
  }
  SECTION("too strong")
  {
    samples->SetValue(0, -4.0F);
    CHECK(writing.Fails(echoes, waveforms, "pulse 40 has 1 samples of up to 4.000000 W; a packet"));
  }
  SECTION("a point")
  {
    echoes->GetPoints()->SetPoint(3, 500000, 0, std::numeric_limits<double>::infinity());
    CHECK(writing.Fails(echoes, waveforms, "point 3 of a block has the coordinate z = inf"));
  }
  REQUIRE((writing.Write(good) && writing.Writer->Close())); // another block is accepted
  helios::CheckPackets(helios::ReadText(writing.Path), helios::ReadText(writing.Packets), good,
    helios::MakeEchoesOf(good), isFirst ? 0 : 18);
}
