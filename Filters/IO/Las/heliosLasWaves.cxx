// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasWaves.h"

#include "heliosConstants.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace helios
{

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr int SmallestScale = -46; // exponent of 2 of the finest full scale [W]
constexpr int ScaleStep = 8;
constexpr double Middle = 2147483648.0; // sample value of 0 W
constexpr double Largest = 4294967295.0;
constexpr int PacketsId = 65535;

/// Returns the sample counts of the packet forms.
const std::array<std::uint32_t, LasWaves::NumberOfLengths>& GetLengths()
{
  static const auto lengths = []
  {
    std::array<std::uint32_t, LasWaves::NumberOfLengths> all{};
    all[0] = 16;
    for (std::size_t i = 1; i < all.size(); ++i)
    {
      all[i] = (all[i - 1] * 5 / 4 + 3) / 4 * 4;
    }
    return all;
  }();
  return lengths;
}

double GetFullScale(int scale)
{
  return std::ldexp(1.0, SmallestScale + ScaleStep * scale);
}

int GetForm(int length, int scale)
{
  return 1 + scale * LasWaves::NumberOfLengths + length;
}

} // namespace

std::string LasWaves::EncodeDescriptors(std::uint32_t spacing)
{
  std::string records;
  for (int scale = 0; scale < NumberOfScales; ++scale)
  {
    for (int length = 0; length < NumberOfLengths; ++length)
    {
      LasRecord record{ LasSpecUser, FirstDescriptorId - 1 + GetForm(length, scale), Description,
        std::string(26, '\0') };
      char* data = record.Data.data();
      data[0] = 32; // bits per sample; not compressed
      StoreLas(data + 2, GetLengths()[static_cast<std::size_t>(length)]);
      StoreLas(data + 6, spacing);
      StoreLas(data + 10, GetFullScale(scale) / Middle);
      StoreLas(data + 18, -GetFullScale(scale));
      records += record.Encode();
    }
  }
  return records;
}

std::string LasWaves::EncodeFileHead(std::uint64_t size)
{
  std::string head(LasRecord::ExtendedHeadSize, '\0');
  const std::string user = LasSpecUser;
  const std::string description = "waveform packets";
  head.replace(2, user.size(), user);
  StoreLas(head.data() + 18, static_cast<std::uint16_t>(PacketsId));
  StoreLas(head.data() + 20, size - LasRecord::ExtendedHeadSize);
  head.replace(28, description.size(), description);
  return head;
}

Status LasWaves::Set(vtkTable* waveforms)
{
  const Status status = waveforms ? this->Table.Set(waveforms) : Status();
  if (!status.IsOk())
  {
    return Status::Error("the table of waveforms of a block " + status.Message());
  }
  const auto count = static_cast<std::size_t>(this->Table.NumberOfRows);
  this->Made.resize(count);
  this->Order.resize(count);
  std::iota(this->Order.begin(), this->Order.end(), 0);
  const auto isBefore = [this](vtkIdType a, vtkIdType b)
  { return this->Table.PulseIds.GetInteger(a) < this->Table.PulseIds.GetInteger(b); };
  if (!std::is_sorted(this->Order.begin(), this->Order.end(), isBefore))
  {
    std::stable_sort(this->Order.begin(), this->Order.end(), isBefore);
  }
  return this->CheckSpacing();
}

Status LasWaves::CheckSpacing()
{
  for (vtkIdType row = 0; row < this->Table.NumberOfRows; ++row)
  {
    const double size = PicosecondsPerNanosecond * this->Table.BinSize.GetNumber(row);
    const double whole = std::nearbyint(size);
    if (!(std::abs(size - whole) <= 1e-6) || whole < 1.0 || whole > Largest)
    {
      return Status::Error(std::string("the waveforms of a block have a ") + names::BinSize +
        " of " + std::to_string(this->Table.BinSize.GetNumber(row)) +
        " ns; LAS stores whole picoseconds: set another");
    }
    const auto spacing = static_cast<std::uint32_t>(whole);
    if (row > 0 && spacing != this->Spacing)
    {
      return Status::Error(std::string("the waveforms of a block have a ") + names::BinSize +
        " of " + std::to_string(spacing) + " ps and one of " + std::to_string(this->Spacing) +
        " ps; write them to separate files");
    }
    this->Spacing = spacing;
  }
  return {};
}

/// Finds the waveform of a pulse; -1: none.
vtkIdType LasWaves::Find(vtkTypeInt64 pulse) const
{
  const auto found = std::lower_bound(this->Order.begin(), this->Order.end(), pulse,
    [this](vtkIdType row, vtkTypeInt64 id) { return this->Table.PulseIds.GetInteger(row) < id; });
  return found != this->Order.end() && this->Table.PulseIds.GetInteger(*found) == pulse ? *found
                                                                                        : -1;
}

Status LasWaves::MakePackets(const Column& ids, vtkIdType count, std::uint64_t place)
{
  this->Begin = place;
  this->RowWaveform.assign(static_cast<std::size_t>(count), -1);
  for (vtkIdType row = 0; row < count; ++row)
  {
    const vtkTypeInt64 pulse = ids.GetInteger(row);
    if (pulse < 0)
    {
      continue;
    }
    const vtkIdType waveform = this->Find(pulse);
    if (waveform < 0)
    {
      return Status::Error("point " + std::to_string(row) + " of a block has " +
        names::WaveformIds + " = " + std::to_string(pulse) +
        ", and the waveforms of the block have no such pulse; give them "
        "with SetWaveforms() before Write()");
    }
    Status status = this->Made[static_cast<std::size_t>(waveform)].Form == 0
      ? this->MakePacket(waveform)
      : Status();
    if (!status.IsOk())
    {
      return status;
    }
    this->RowWaveform[static_cast<std::size_t>(row)] = waveform;
  }
  return {};
}

Status LasWaves::MakePacket(vtkIdType waveform)
{
  const vtkIdType first = this->Table.Offset.GetInteger(waveform);
  const vtkIdType count = this->Table.Count.GetInteger(waveform);
  double peak = 0.0;
  for (vtkIdType i = first; i < first + count; ++i)
  {
    const double value = std::abs(this->Table.Samples.GetNumber(i));
    peak = std::isfinite(value) ? std::max(peak, value) : HUGE_VAL; // fits in no packet
  }
  int scale = 0;
  while (scale < NumberOfScales && !(peak < GetFullScale(scale)))
  {
    ++scale;
  }
  const auto& lengths = GetLengths();
  const auto length = std::lower_bound(lengths.begin(), lengths.end(), count);
  if (scale == NumberOfScales || length == lengths.end())
  {
    return Status::Error("the waveform of pulse " +
      std::to_string(this->Table.PulseIds.GetInteger(waveform)) + " has " + std::to_string(count) +
      " samples of up to " + std::to_string(peak) + " W; a packet holds " +
      std::to_string(lengths.back()) + " of less than " +
      std::to_string(static_cast<int>(GetFullScale(NumberOfScales - 1))) + " W");
  }
  Packet& packet = this->Made[static_cast<std::size_t>(waveform)];
  packet.Place = this->Begin + this->Packets.size();
  packet.Form = GetForm(static_cast<int>(length - lengths.begin()), scale);
  const std::size_t at = this->Packets.size();
  this->Packets.resize(at + 4 * std::size_t(*length));
  const double perWatt = Middle / GetFullScale(scale);
  for (vtkIdType i = 0; i < static_cast<vtkIdType>(*length); ++i)
  {
    const double value = i < count ? this->Table.Samples.GetNumber(first + i) : 0.0;
    const double number = std::clamp(std::nearbyint(value * perWatt) + Middle, 0.0, Largest);
    StoreLas(this->Packets.data() + at + 4 * i, static_cast<std::uint32_t>(number));
  }
  return {};
}

void LasWaves::EncodePoint(vtkIdType row, const double point[3], char* bytes) const
{
  const vtkIdType waveform = this->RowWaveform[static_cast<std::size_t>(row)];
  if (waveform < 0)
  {
    std::memset(bytes, 0, 29);
    return;
  }
  const Packet& packet = this->Made[static_cast<std::size_t>(waveform)];
  const int length = (packet.Form - 1) % NumberOfLengths;
  double range = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    range += (point[axis] - this->Table.Origin.GetNumber(waveform, axis)) *
      this->Table.Direction.GetNumber(waveform, axis);
  }
  const double time = 2.0 * range / SpeedOfLight - this->Table.StartTime.GetNumber(waveform);
  StoreLas(bytes, static_cast<std::uint8_t>(packet.Form));
  StoreLas(bytes + 1, packet.Place);
  StoreLas(bytes + 9, 4 * GetLengths()[static_cast<std::size_t>(length)]);
  StoreLas(bytes + 13, static_cast<float>(PicosecondsPerNanosecond * time));
  for (int axis = 0; axis < 3; ++axis)
  {
    const double step = -0.5 * SpeedOfLight / PicosecondsPerNanosecond *
      this->Table.Direction.GetNumber(waveform, axis);
    StoreLas(bytes + 17 + 4 * axis, static_cast<float>(step));
  }
}

} // namespace helios
