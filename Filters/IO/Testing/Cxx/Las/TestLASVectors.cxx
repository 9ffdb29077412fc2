// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// X(t), Y(t), Z(t) of points lead to the scanner; in files of earlier versions away from it.
#include "heliosLasWaveTesting.h"

namespace names = vtkHeliosArrayNames;
namespace fs = std::filesystem;
using helios::GetNumber;

namespace
{

/// A file as written by earlier versions.
std::string TurnVectors(std::string las)
{
  const std::string description = "waveform [W], to the scanner";
  std::string before = "waveform [W]";
  before.resize(description.size(), '\0');
  const std::size_t begin = GetNumber<std::uint32_t>(las, 96);
  std::size_t records = 0;
  for (std::size_t at = las.find(description); at < begin; at = las.find(description, at))
  {
    las.replace(at, description.size(), before);
    ++records;
  }
  CHECK(records == 252);
  for (std::size_t row = begin; row < las.size(); row += GetNumber<std::uint16_t>(las, 105))
  {
    for (std::size_t at = row + 30 + 17; at < row + 30 + 29; at += 4)
    {
      helios::SetNumber(las, at, -GetNumber<float>(las, at));
    }
  }
  return las;
}

} // namespace

TEST_CASE(
  "LASVectors: files of earlier versions are read correctly, with a warning", "[LASVectors]")
{
  helios::LasWaveWriting writing;
  const auto waveforms = helios::MakeWaveforms(60);
  REQUIRE((writing.Writer->Open() && writing.Write(waveforms) && writing.Writer->Close()));
  helios::LasReading reading(writing.Path);
  reading.Reader->ReadWaveformsOn();
  REQUIRE(reading.Read());
  CHECK(reading.Log->Warnings.empty());
  vtkNew<vtkTable> right;
  right->DeepCopy(reading.Reader->GetOutputDataObject(1));
  REQUIRE(right->GetNumberOfRows() == 48);

  const std::string old = writing.Folder / "old.las";
  std::ofstream(old, std::ios::binary) << TurnVectors(helios::ReadText(writing.Path));
  fs::copy_file(writing.Packets, writing.Folder / "old.wdp");
  reading.Reader->SetFileName(old.c_str());
  REQUIRE(reading.Read());
  CHECK(reading.Log->HasWarning(old + ": an earlier version of vtkHelios wrote its waveforms"));
  CHECK(reading.Log->HasWarning("vtkhelios convert " + old + " new.las turns them"));
  auto* table = vtkTable::SafeDownCast(reading.Reader->GetOutputDataObject(1));
  REQUIRE(table->GetNumberOfRows() == right->GetNumberOfRows());
  for (const char* name : { names::Origin, names::Direction, names::StartTime })
  {
    CHECK(helios::CountWrong(vtkDataArray::SafeDownCast(table->GetColumnByName(name)),
            vtkDataArray::SafeDownCast(right->GetColumnByName(name))) == 0);
  }
  reading.Log->Clear();
  REQUIRE((reading.Read(0, 3) && reading.Read(1, 3)));
  CHECK(reading.Log->Warnings.empty()); // once per file
}

TEST_CASE("LASVectors: a file of an earlier version cannot be resumed", "[LASVectors]")
{
  helios::LasWaveWriting writing;
  REQUIRE((writing.Writer->Open() && writing.Write(helios::MakeWaveforms(6))));
  const vtkIdType size = writing.Writer->GetFileSize();
  REQUIRE(writing.Writer->Abandon());
  const std::string part = writing.Path + ".part";
  const std::string las = helios::ReadText(part);
  std::ofstream(part, std::ios::binary) << TurnVectors(las);
  CHECK_FALSE(writing.Writer->Reopen(size, 18, size));
  CHECK(writing.Log->HasError(
    "points.las.part was started by an earlier version, whose waveform vectors point away from the "
    "scanner, and cannot be resumed; start again (vtkhelios run --overwrite)"));
  std::ofstream(part, std::ios::binary) << las;
  CHECK(writing.Writer->Reopen(size, 18, size));
}

TEST_CASE("LASVectors: the anchor in files of other programs", "[LASVectors]")
{
  // light is slower in air, and some programs account for it
  constexpr double air = 0.99972;
  helios::LasWaveWriting writing;
  const auto waveforms = helios::MakeWaveforms(4);
  const auto echoes = helios::MakeEchoesOf(waveforms);
  echoes->GetPointData()->RemoveArray(names::Range);
  writing.Writer->SetWaveforms(waveforms);
  REQUIRE((writing.Writer->Open() && writing.Writer->Write(echoes) && writing.Writer->Close()));
  std::string las = helios::ReadText(writing.Path);
  const std::size_t at = GetNumber<std::uint32_t>(las, 96) + 30; // place in the first point
  const float location = 60000.0F;                               // [ps]
  double anchor[3];
  for (std::size_t k = 0; k < 3; ++k)
  {
    const auto step = static_cast<float>(air * GetNumber<float>(las, at + 17 + 4 * k));
    helios::SetNumber(las, at + 17 + 4 * k, step);
    anchor[k] = echoes->GetPoint(0)[k] + static_cast<double>(location) * static_cast<double>(step);
  }
  helios::SetNumber(las, at + 13, location);
  std::ofstream(writing.Path, std::ios::binary) << las;
  helios::LasReading reading(writing.Path);
  reading.Reader->ReadWaveformsOn();
  REQUIRE(reading.Read());
  auto* table = vtkTable::SafeDownCast(reading.Reader->GetOutputDataObject(1));
  const auto get = [table](const char* name, int k)
  { return vtkDataArray::SafeDownCast(table->GetColumnByName(name))->GetComponent(0, k); };
  for (int k = 0; k < 3; ++k)
  {
    CHECK(get(names::Origin, k) == Approx(anchor[k]).margin(1e-4));
    // at its time the point has the original position
    const double time = get(names::StartTime, 0) + 1e-3 * static_cast<double>(location);
    CHECK(
      get(names::Origin, k) + 0.5e-9 * helios::LasSpeedOfLight * time * get(names::Direction, k) ==
      Approx(reading.Cloud()->GetPoint(0)[k]).margin(1e-6));
  }
}
