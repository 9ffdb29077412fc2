// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasPackets.h"

#include "heliosConstants.h"
#include "heliosInputFile.h"
#include "heliosLasWaves.h"
#include "heliosPartFile.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

namespace helios
{

namespace names = vtkHeliosArrayNames;

namespace
{

constexpr int LastDescriptorId = 354;
constexpr double LargestId = 9e18;
///@{
/// Values outside are damaged: the two-way speed of light is 1.5e-4 m or 1.3e-9 degrees per ps.
constexpr double SmallestSpeed = 1e-12;
constexpr double LargestSpeed = 1.0;
constexpr float LargestLocation = 1e12F; // [ps], a second
constexpr double LargestRange = 1e9;     // [m]
///@}
constexpr std::size_t DescriptorSize = 26;
constexpr int InternalWaves = 2; // a bit of the encoding

/// Returns "a.wdp" for "a.las", "a.wdp.part" for "a.las.part".
std::string GetPacketsName(const std::string& path)
{
  const std::string part = PartEnding;
  std::filesystem::path name = path;
  const bool isPart = name.extension() == part;
  name = isPart ? name.replace_extension() : name;
  return name.replace_extension(".wdp").string() + (isPart ? part : std::string());
}

/// Returns an error if only compressed packets are there, for which there is no maintained library.
Status CheckCompressed(const std::string& packets)
{
  std::error_code error;
  const auto compressed = std::filesystem::path(packets).replace_extension(".wdz");
  return std::filesystem::exists(packets, error) || !std::filesystem::exists(compressed, error)
    ? Status()
    : Status::Error(compressed.string() +
        ": compressed waveforms (.wdz) cannot be read; decompress them to " + packets +
        " with the program that wrote them, or switch ReadWaveforms off");
}

template <typename ArrayT>
vtkSmartPointer<ArrayT> AddColumn(vtkFieldData* data, const char* name, int components = 1)
{
  vtkNew<ArrayT> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  data->AddArray(array);
  return array;
}

bool IsDescriptor(const LasRecord& record)
{
  return record.User == LasSpecUser && record.Id >= LasWaves::FirstDescriptorId &&
    record.Id <= LastDescriptorId;
}

/// Returns whether an earlier version wrote the file, with vectors that lead away from the scanner.
bool IsTurned(const LasFile& file)
{
  const auto& records = file.GetRecords();
  return std::any_of(records.begin(), records.end(),
    [](const LasRecord& record)
    { return IsDescriptor(record) && record.Description == LasWaves::OldDescription; });
}

double GetSpeed(const float step[3])
{
  return std::hypot(step[0], step[1], step[2]);
}

/// The columns of the table, filled row by row.
struct Columns
{
  explicit Columns(vtkTable* table)
    : Pulses(AddColumn<vtkTypeInt64Array>(table->GetRowData(), names::PulseIds))
    , Origins(AddColumn<vtkDoubleArray>(table->GetRowData(), names::Origin, 3))
    , Directions(AddColumn<vtkDoubleArray>(table->GetRowData(), names::Direction, 3))
    , Times(AddColumn<vtkDoubleArray>(table->GetRowData(), names::GpsTime))
    , Starts(AddColumn<vtkDoubleArray>(table->GetRowData(), names::StartTime))
    , Bins(AddColumn<vtkDoubleArray>(table->GetRowData(), names::BinSize))
    , Offsets(AddColumn<vtkTypeInt64Array>(table->GetRowData(), names::Offset))
    , Counts(AddColumn<vtkTypeInt64Array>(table->GetRowData(), names::Count))
    , Samples(AddColumn<vtkFloatArray>(table->GetFieldData(), names::Samples))
  {
  }

  vtkSmartPointer<vtkTypeInt64Array> Pulses;
  vtkSmartPointer<vtkDoubleArray> Origins, Directions, Times, Starts, Bins;
  vtkSmartPointer<vtkTypeInt64Array> Offsets, Counts;
  vtkSmartPointer<vtkFloatArray> Samples;
};

/// Returns the value of a point, or a default if the array is missing or the value is too large.
double GetNumber(
  vtkPolyData* cloud, const char* name, vtkIdType row, double otherwise, double largest)
{
  vtkDataArray* array = cloud->GetPointData()->GetArray(name);
  const double value =
    array && array->GetNumberOfComponents() == 1 ? array->GetTuple1(row) : otherwise;
  return std::abs(value) <= largest ? value : otherwise;
}

} // namespace

Status LasPackets::Open(const LasFile& file)
{
  const LasHeader& header = file.GetHeader();
  this->Form = GetLasPointForm(header.Format);
  this->PointLength = header.PointLength;
  const bool isInternal = (header.Encoding & InternalWaves) != 0;
  this->Path = isInternal ? file.GetPath() : GetPacketsName(file.GetPath());
  this->Begin = isInternal ? header.WavesBegin : 0;
  if (const Status status = CheckCompressed(this->Path); !status.IsOk())
  {
    return status;
  }
  if (const Status status = CheckInputFile(this->Path); !status.IsOk())
  {
    return Status::Error(this->Path + ": " + status.Message());
  }
  std::error_code error;
  this->File.open(this->Path, std::ios::binary);
  this->End = this->File ? std::filesystem::file_size(this->Path, error) : 0;
  if (!this->File || error)
  {
    return Status::Error(this->Path + ": cannot be read, but holds the waveforms of " +
      file.GetPath() + "; put it there, or switch ReadWaveforms off");
  }
  if (IsTurned(file))
  {
    this->StepSign = 1.0F;
    this->Warning = file.GetPath() +
      ": an earlier version of vtkHelios wrote its waveforms with vectors X(t), Y(t), Z(t) that "
      "point away from the scanner; they are read correctly here, but other programs mirror them: "
      "vtkhelios convert " +
      file.GetPath() + " new.las turns them";
  }
  for (const LasRecord& record : file.GetRecords())
  {
    const Status status = IsDescriptor(record) ? this->AddDescriptor(record) : Status();
    if (!status.IsOk())
    {
      return Status::Error(file.GetPath() + ": " + status.Message());
    }
  }
  return {};
}

Status LasPackets::AddDescriptor(const LasRecord& record)
{
  const int index = record.Id - LasWaves::FirstDescriptorId + 1;
  const char* data = record.Data.data();
  Descriptor descriptor;
  if (record.Data.size() == DescriptorSize && LoadLas<std::uint32_t>(data + 2) == 0)
  {
    this->Descriptors[index] = descriptor; // empty, as in the tables of some programs
    return {};
  }
  descriptor.Bits = record.Data.size() == DescriptorSize ? LoadLas<std::uint8_t>(data) : 0;
  const bool isKnown =
    (descriptor.Bits == 8 || descriptor.Bits == 16 || descriptor.Bits == 32) && data[1] == 0;
  if (!isKnown)
  {
    return Status::Error("has a waveform descriptor " + std::to_string(index) +
      " that does not have 8, 16 or 32 bits without compression");
  }
  descriptor.Count = LoadLas<std::uint32_t>(data + 2);
  descriptor.Spacing = LoadLas<std::uint32_t>(data + 6);
  descriptor.Gain = LoadLas<double>(data + 10);
  descriptor.Offset = LoadLas<double>(data + 18);
  const double largest = std::ldexp(std::abs(descriptor.Gain), descriptor.Bits);
  if (!(largest + std::abs(descriptor.Offset) <= VTK_FLOAT_MAX))
  {
    return Status::Error("has a waveform descriptor " + std::to_string(index) +
      " whose gain is not a number, or too large for samples");
  }
  this->Descriptors[index] = descriptor;
  return {};
}

void LasPackets::Add(const char* records, vtkIdType first, vtkIdType count)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    const char* wave = records + i * this->PointLength + this->Form.Wave;
    Packet packet;
    packet.Index = LoadLas<std::uint8_t>(wave);
    packet.Place = LoadLas<std::uint64_t>(wave + 1);
    if (packet.Index == 0 || !this->Places.insert(packet.Place).second)
    {
      continue;
    }
    packet.Row = first + i;
    packet.Size = LoadLas<std::uint32_t>(wave + 9);
    packet.Location = LoadLas<float>(wave + 13);
    for (int k = 0; k < 3; ++k)
    {
      packet.Step[k] = this->StepSign * LoadLas<float>(wave + 17 + 4 * k);
    }
    this->Packets.push_back(packet);
  }
}

Status LasPackets::CheckPacket(const Packet& packet) const
{
  const auto found = this->Descriptors.find(packet.Index);
  if (found == this->Descriptors.end())
  {
    return Status::Error("refers to waveform descriptor " + std::to_string(packet.Index) +
      ", which the file does not have");
  }
  const Descriptor& descriptor = found->second;
  if (descriptor.Count == 0)
  {
    return Status::Error(
      "refers to waveform descriptor " + std::to_string(packet.Index) + ", which has no samples");
  }
  const std::uint64_t size = std::uint64_t(descriptor.Count) * descriptor.Bits / 8;
  if (packet.Size != size)
  {
    return Status::Error("has a packet of " + std::to_string(packet.Size) +
      " bytes; its descriptor has " + std::to_string(size));
  }
  const std::uint64_t room = this->GetRoom();
  if (size > room || packet.Place > room - size)
  {
    return Status::Error("has a packet of " + std::to_string(size) + " bytes at " +
      std::to_string(packet.Place) + ", beyond the end of " + this->Path);
  }
  if (descriptor.Spacing == 0)
  {
    return Status::Error("refers to waveform descriptor " + std::to_string(packet.Index) +
      ", whose sample spacing is 0");
  }
  const double speed = GetSpeed(packet.Step);
  if (!(std::abs(packet.Location) <= LargestLocation) || !(speed >= SmallestSpeed) ||
    !(speed <= LargestSpeed))
  {
    return Status::Error("has a waveform without a direction or position");
  }
  return {};
}

/// Checks each packet, and that their total does not exceed the file: otherwise a small file could
/// expand to any number of samples.
Status LasPackets::CheckPackets() const
{
  std::uint64_t total = 0;
  for (const Packet& packet : this->Packets)
  {
    const Status status = this->CheckPacket(packet);
    if (!status.IsOk())
    {
      return Status::Error(
        "point " + std::to_string(packet.Row) + " of the piece " + status.Message());
    }
    total += packet.Size;
  }
  return total > this->GetRoom()
    ? Status::Error("the points of the piece refer to packets of " + std::to_string(total) +
        " bytes, but " + this->Path + " has " + std::to_string(this->GetRoom()) +
        ": packets overlap; write the file again")
    : Status();
}

/// Reads the samples up to the last nonzero one.
Status LasPackets::ReadSamples(const Packet& packet, std::vector<float>& samples)
{
  const Descriptor& descriptor = this->Descriptors[packet.Index];
  this->Bytes.resize(packet.Size);
  this->File.clear();
  this->File.seekg(static_cast<std::streamoff>(this->Begin + packet.Place));
  this->File.read(this->Bytes.data(), static_cast<std::streamsize>(packet.Size));
  if (!this->File)
  {
    return Status::Error("has a packet that cannot be read; has " + this->Path + " changed?");
  }
  samples.resize(descriptor.Count);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const char* bytes = this->Bytes.data() + i * static_cast<std::size_t>(descriptor.Bits / 8);
    const double number = descriptor.Bits == 8 ? LoadLas<std::uint8_t>(bytes)
      : descriptor.Bits == 16                  ? LoadLas<std::uint16_t>(bytes)
                                               : LoadLas<std::uint32_t>(bytes);
    samples[i] = static_cast<float>(descriptor.Offset + descriptor.Gain * number);
  }
  while (samples.size() > 1 && samples.back() == 0.0F)
  {
    samples.pop_back();
  }
  return {};
}

Status LasPackets::Read(vtkPolyData* cloud, vtkTable* table)
{
  Status status = this->CheckPackets();
  if (!status.IsOk())
  {
    return status;
  }
  const Columns columns(table);
  std::vector<float> samples;
  for (const Packet& packet : this->Packets)
  {
    status = this->ReadSamples(packet, samples);
    if (!status.IsOk())
    {
      return Status::Error(
        "point " + std::to_string(packet.Row) + " of the piece " + status.Message());
    }
    const double speed = GetSpeed(packet.Step);
    const double location = static_cast<double>(packet.Location) / PicosecondsPerNanosecond;
    // without a range the origin is the anchor, the origin of the first sample
    const double range = GetNumber(
      cloud, names::Range, packet.Row, speed * static_cast<double>(packet.Location), LargestRange);
    double point[3];
    cloud->GetPoint(packet.Row, point);
    double direction[3];
    for (int k = 0; k < 3; ++k)
    {
      direction[k] = static_cast<double>(packet.Step[k]) / speed;
      point[k] -= range * direction[k];
    }
    columns.Pulses->InsertNextValue(static_cast<vtkTypeInt64>(GetNumber(
      cloud, names::WaveformIds, packet.Row, static_cast<double>(packet.Row), LargestId)));
    columns.Origins->InsertNextTuple(point);
    columns.Directions->InsertNextTuple(direction);
    columns.Times->InsertNextValue(
      GetNumber(cloud, names::GpsTime, packet.Row, 0.0, VTK_DOUBLE_MAX));
    columns.Starts->InsertNextValue(2.0 * range / SpeedOfLight - location);
    columns.Bins->InsertNextValue(
      this->Descriptors[packet.Index].Spacing / PicosecondsPerNanosecond);
    columns.Offsets->InsertNextValue(columns.Samples->GetNumberOfValues());
    columns.Counts->InsertNextValue(static_cast<vtkTypeInt64>(samples.size()));
    for (const float sample : samples)
    {
      columns.Samples->InsertNextValue(sample);
    }
  }
  return {};
}

} // namespace helios
