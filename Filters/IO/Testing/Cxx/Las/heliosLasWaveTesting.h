// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// LAS files with waveforms: writing, and checks of the point and packet bytes.

#ifndef heliosLasWaveTesting_h
#define heliosLasWaveTesting_h

#include "heliosLasTesting.h"
#include "heliosWaveformTesting.h"
#include "vtkHeliosLASWriter.h"

#include <vtkTable.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

namespace helios
{

constexpr double LasSpeedOfLight = 299792458.0; // [m/s]

/// Three points per waveform, except every fifth pulse, which has none; on the beam, shortly after
/// the first sample.
inline vtkSmartPointer<vtkPolyData> MakeEchoesOf(vtkTable* waveforms)
{
  const vtkIdType count = 3 * waveforms->GetNumberOfRows();
  auto echoes = MakeLasEchoes(count);
  auto* origins =
    vtkDataArray::SafeDownCast(waveforms->GetColumnByName(vtkHeliosArrayNames::Origin));
  auto* directions =
    vtkDataArray::SafeDownCast(waveforms->GetColumnByName(vtkHeliosArrayNames::Direction));
  auto* starts =
    vtkDataArray::SafeDownCast(waveforms->GetColumnByName(vtkHeliosArrayNames::StartTime));
  auto* pulses =
    vtkDataArray::SafeDownCast(waveforms->GetColumnByName(vtkHeliosArrayNames::PulseIds));
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double time = starts->GetTuple1(i / 3) + 0.2 * static_cast<double>(i % 3); // [ns]
    double point[3];
    for (int k = 0; k < 3; ++k)
    {
      point[k] = origins->GetComponent(i / 3, k) +
        0.5e-9 * LasSpeedOfLight * time * directions->GetComponent(i / 3, k);
    }
    echoes->GetPoints()->SetPoint(i, point);
  }
  AddColumn<vtkTypeInt64Array>(echoes->GetPointData(), vtkHeliosArrayNames::WaveformIds, count,
    [pulses](vtkIdType i) { return i / 3 % 5 == 4 ? -1.0 : pulses->GetTuple1(i / 3); });
  return echoes;
}

/// The packet of a point and its descriptor.
struct LasWavePacket
{
  int Index;
  std::uint64_t Place;
  std::uint32_t Size;
  float Location;
  std::array<float, 3> Step;
  std::uint32_t Samples = 0;
  std::uint32_t Spacing = 0;
  double Gain = 0.0;
  double Offset = 0.0;

  LasWavePacket(const std::string& las, std::size_t row, std::size_t place = 30)
  {
    const std::size_t at =
      GetNumber<std::uint32_t>(las, 96) + row * GetNumber<std::uint16_t>(las, 105) + place;
    this->Index = GetNumber<std::uint8_t>(las, at);
    this->Place = GetNumber<std::uint64_t>(las, at + 1);
    this->Size = GetNumber<std::uint32_t>(las, at + 9);
    this->Location = GetNumber<float>(las, at + 13);
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Step[k] = GetNumber<float>(las, at + 17 + 4 * k);
    }
    for (std::size_t record = 375; record < GetNumber<std::uint32_t>(las, 96);
         record += 54 + GetNumber<std::uint16_t>(las, record + 20))
    {
      if (GetNumber<std::uint16_t>(las, record + 18) == 99 + this->Index && this->Index > 0)
      {
        this->AddDescriptor(las, record + 54);
      }
    }
  }

  void AddDescriptor(const std::string& las, std::size_t at)
  {
    CHECK(las.substr(at - 54 + 2, 9) == "LASF_Spec");
    CHECK(las[at] == 32);    // bits
    CHECK(las[at + 1] == 0); // not compressed
    this->Samples = GetNumber<std::uint32_t>(las, at + 2);
    this->Spacing = GetNumber<std::uint32_t>(las, at + 6);
    this->Gain = GetNumber<double>(las, at + 10);
    this->Offset = GetNumber<double>(las, at + 18);
  }

  double GetSample(const std::string& packets, std::size_t i) const
  {
    return this->Offset + this->Gain * GetNumber<std::uint32_t>(packets, this->Place + 4 * i);
  }
};

/// Checks the rule of the specification: the anchor, point + location (X(t), Y(t), Z(t)), is the
/// origin of the first sample and lies between scanner and point.
inline void CheckAnchor(
  const LasWavePacket& packet, const double point[3], vtkTable* waveforms, vtkIdType wave)
{
  const double start =
    vtkDataArray::SafeDownCast(waveforms->GetColumnByName(vtkHeliosArrayNames::StartTime))
      ->GetTuple1(wave);
  double along = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const auto get = [=](const char* name)
    { return vtkDataArray::SafeDownCast(waveforms->GetColumnByName(name))->GetComponent(wave, k); };
    const double origin = get(vtkHeliosArrayNames::Origin);
    const double direction = get(vtkHeliosArrayNames::Direction);
    const auto step = static_cast<double>(packet.Step[static_cast<std::size_t>(k)]);
    const double anchor = point[k] + static_cast<double>(packet.Location) * step;
    REQUIRE(anchor == Approx(origin + 0.5e-9 * LasSpeedOfLight * start * direction).margin(1e-6));
    along += (point[k] - anchor) * direction;
  }
  REQUIRE(along >= -1e-6);
}

/// Checks the samples of points from a row on, and the point locations in them.
inline void CheckPackets(const std::string& las, const std::string& packets, vtkTable* waveforms,
  vtkPolyData* echoes, std::size_t from)
{
  auto* counts = vtkDataArray::SafeDownCast(waveforms->GetColumnByName(vtkHeliosArrayNames::Count));
  auto* offsets =
    vtkDataArray::SafeDownCast(waveforms->GetColumnByName(vtkHeliosArrayNames::Offset));
  auto* samples = waveforms->GetFieldData()->GetArray(vtkHeliosArrayNames::Samples);
  auto* directions =
    vtkDataArray::SafeDownCast(waveforms->GetColumnByName(vtkHeliosArrayNames::Direction));
  for (vtkIdType row = 0; row < echoes->GetNumberOfPoints(); ++row)
  {
    const LasWavePacket packet(las, from + static_cast<std::size_t>(row));
    const vtkIdType wave = row / 3;
    if (wave % 5 == 4)
    {
      REQUIRE(packet.Index == 0);
      REQUIRE((packet.Place == 0 && packet.Size == 0 && packet.Location == 0.0F));
      continue;
    }
    REQUIRE(packet.Index > 0);
    REQUIRE(packet.Spacing == 250);
    REQUIRE(packet.Size == 4 * packet.Samples);
    REQUIRE(packet.Place >= 60);
    REQUIRE(packet.Place + packet.Size <= packets.size());
    const auto count = static_cast<vtkIdType>(counts->GetTuple1(wave));
    REQUIRE(static_cast<vtkIdType>(packet.Samples) >= count);
    double peak = 0.0;
    double worst = 0.0;
    for (vtkIdType i = 0; i < static_cast<vtkIdType>(packet.Samples); ++i)
    {
      const auto at = static_cast<vtkIdType>(offsets->GetTuple1(wave)) + i;
      const double expected = i < count ? samples->GetTuple1(at) : 0.0;
      peak = std::max(peak, std::abs(expected));
      worst = std::max(
        worst, std::abs(packet.GetSample(packets, static_cast<std::size_t>(i)) - expected));
    }
    REQUIRE(worst <= std::max(std::ldexp(peak, -23), 1e-23));
    REQUIRE(packet.Location == Approx(200.0 * static_cast<double>(row % 3)).margin(0.02)); // [ps]
    for (int k = 0; k < 3; ++k)
    {
      const double step = -0.5e-12 * LasSpeedOfLight * directions->GetComponent(wave, k);
      REQUIRE(packet.Step[static_cast<std::size_t>(k)] == Approx(step).epsilon(1e-6));
    }
    CheckAnchor(packet, echoes->GetPoint(row), waveforms, wave);
    const bool isOther = row % 3 > 0 &&
      LasWavePacket(las, from + static_cast<std::size_t>(row) - 1).Place != packet.Place;
    REQUIRE_FALSE(isOther); // one packet per pulse
  }
}

inline void CheckFileHead(const std::string& packets)
{
  REQUIRE(packets.size() >= 60);
  CHECK(packets.substr(2, 9) == "LASF_Spec");
  CHECK(GetNumber<std::uint16_t>(packets, 18) == 65535);
  CHECK(GetNumber<std::uint64_t>(packets, 20) == packets.size() - 60);
}

struct LasWaveWriting
{
  TempFolder Folder;
  std::string Path = this->Folder / "points.las";
  std::string Packets = this->Folder / "points.wdp";
  vtkNew<vtkHeliosLASWriter> Writer;
  vtkSmartPointer<ErrorObserver> Log = WatchErrors(this->Writer);

  LasWaveWriting()
  {
    this->Writer->SetFileName(this->Path.c_str());
    this->Writer->WriteWaveformsOn();
  }

  bool Write(vtkTable* waveforms)
  {
    this->Writer->SetWaveforms(waveforms);
    return this->Writer->Write(MakeEchoesOf(waveforms));
  }

  /// Whether a block fails with a message and leaves the files unchanged.
  bool Fails(vtkPolyData* echoes, vtkTable* waveforms, const std::string& message)
  {
    const std::string las = ReadText(this->Path + ".part");
    const std::string packets = ReadText(this->Packets + ".part");
    this->Writer->SetWaveforms(waveforms);
    const bool isWritten = this->Writer->Write(echoes);
    INFO(this->Log->Errors);
    CHECK(this->Log->HasError(message));
    CHECK((las == ReadText(this->Path + ".part")));
    CHECK((packets == ReadText(this->Packets + ".part")));
    return !isWritten;
  }
};

} // namespace helios

#endif
