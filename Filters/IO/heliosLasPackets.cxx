// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasPackets.h"

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

constexpr double SpeedOfLight = 0.299792458; // [m/ns]
constexpr double PicosecondsPerNanosecond = 1000.0;
constexpr int FirstDescriptorId = 100;
constexpr int LastDescriptorId = 354;
constexpr std::size_t DescriptorSize = 26;
constexpr int InternalWaves = 2; // a bit of the encoding

/// "a.wdp" for "a.las", "a.wdp.part" for "a.las.part".
std::string GetPacketsName(const std::string& path)
{
  const std::string part = ".part";
  std::filesystem::path name = path;
  const bool isPart = name.extension() == part;
  name = isPart ? name.replace_extension() : name;
  return name.replace_extension(".wdp").string() + (isPart ? part : std::string());
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

/// The columns of the table, which grow row by row.
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

/// A number of a point, or what it is where there is no such array.
double GetNumber(vtkPolyData* cloud, const char* name, vtkIdType row, double otherwise)
{
  vtkDataArray* array = cloud->GetPointData()->GetArray(name);
  return array && array->GetNumberOfComponents() == 1 ? array->GetTuple1(row) : otherwise;
}

} // namespace

std::string LasPackets::Open(const LasFile& file)
{
  const LasHeader& header = file.GetHeader();
  this->Form = GetLasPointForm(header.Format);
  this->PointLength = header.PointLength;
  const bool isInternal = (header.Encoding & InternalWaves) != 0;
  this->Path = isInternal ? file.GetPath() : GetPacketsName(file.GetPath());
  this->Begin = isInternal ? header.WavesBegin : 0;
  std::error_code error;
  this->File.open(this->Path, std::ios::binary);
  this->End = this->File ? std::filesystem::file_size(this->Path, error) : 0;
  if (!this->File || error)
  {
    return this->Path + ": cannot be read, and has the waveforms of " + file.GetPath() +
      "; put it there, or switch ReadWaveforms off";
  }
  for (const LasRecord& record : file.GetRecords())
  {
    const std::string problem =
      record.User == LasSpecUser && record.Id >= FirstDescriptorId && record.Id <= LastDescriptorId
      ? this->TakeDescriptor(record)
      : std::string();
    if (!problem.empty())
    {
      return file.GetPath() + ": " + problem;
    }
  }
  return {};
}

std::string LasPackets::TakeDescriptor(const LasRecord& record)
{
  const int index = record.Id - FirstDescriptorId + 1;
  const char* data = record.Data.data();
  Descriptor descriptor;
  descriptor.Bits = record.Data.size() == DescriptorSize ? GetLas<std::uint8_t>(data) : 0;
  const bool isKnown =
    (descriptor.Bits == 8 || descriptor.Bits == 16 || descriptor.Bits == 32) && data[1] == 0;
  if (!isKnown)
  {
    return "has a waveform descriptor " + std::to_string(index) +
      " that is not of 8, 16 or 32 bits without compression";
  }
  descriptor.Count = GetLas<std::uint32_t>(data + 2);
  descriptor.Spacing = GetLas<std::uint32_t>(data + 6);
  descriptor.Gain = GetLas<double>(data + 10);
  descriptor.Offset = GetLas<double>(data + 18);
  if (!std::isfinite(descriptor.Gain) || !std::isfinite(descriptor.Offset))
  {
    return "has a waveform descriptor " + std::to_string(index) + " whose gain is no number";
  }
  this->Descriptors[index] = descriptor;
  return {};
}

void LasPackets::Take(const char* records, vtkIdType first, vtkIdType count)
{
  for (vtkIdType i = 0; i < count; ++i)
  {
    const char* wave = records + i * this->PointLength + this->Form.Wave;
    Packet packet;
    packet.Index = GetLas<std::uint8_t>(wave);
    packet.Place = GetLas<std::uint64_t>(wave + 1);
    if (packet.Index == 0 || !this->Places.insert(packet.Place).second)
    {
      continue;
    }
    packet.Row = first + i;
    packet.Size = GetLas<std::uint32_t>(wave + 9);
    packet.Location = GetLas<float>(wave + 13);
    std::memcpy(packet.Step, wave + 17, sizeof(packet.Step));
    this->Packets.push_back(packet);
  }
}

std::string LasPackets::CheckPacket(const Packet& packet) const
{
  const auto found = this->Descriptors.find(packet.Index);
  if (found == this->Descriptors.end())
  {
    return "names the waveform descriptor " + std::to_string(packet.Index) +
      ", which the file has not";
  }
  const Descriptor& descriptor = found->second;
  const std::uint64_t size = std::uint64_t(descriptor.Count) * descriptor.Bits / 8;
  if (packet.Size != size || size == 0)
  {
    return "has a packet of " + std::to_string(packet.Size) + " bytes; its descriptor has " +
      std::to_string(size);
  }
  const std::uint64_t room = this->End - std::min(this->End, this->Begin);
  if (size > room || packet.Place > room - size)
  {
    return "has a packet of " + std::to_string(size) + " bytes at " + std::to_string(packet.Place) +
      ", beyond the end of " + this->Path;
  }
  const double speed = std::hypot(packet.Step[0], packet.Step[1], packet.Step[2]);
  if (!std::isfinite(packet.Location) || !std::isfinite(speed) || speed == 0.0)
  {
    return "has a waveform without a direction or a place";
  }
  return {};
}

/// The samples up to the last that is not 0 W.
std::string LasPackets::ReadSamples(const Packet& packet, std::vector<float>& samples)
{
  const Descriptor& descriptor = this->Descriptors[packet.Index];
  this->Bytes.resize(packet.Size);
  this->File.clear();
  this->File.seekg(static_cast<std::streamoff>(this->Begin + packet.Place));
  this->File.read(this->Bytes.data(), static_cast<std::streamsize>(packet.Size));
  if (!this->File)
  {
    return "has a packet that cannot be read; has " + this->Path + " changed?";
  }
  samples.resize(descriptor.Count);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const char* bytes = this->Bytes.data() + i * static_cast<std::size_t>(descriptor.Bits / 8);
    const double number = descriptor.Bits == 8 ? GetLas<std::uint8_t>(bytes)
      : descriptor.Bits == 16                  ? GetLas<std::uint16_t>(bytes)
                                               : GetLas<std::uint32_t>(bytes);
    samples[i] = static_cast<float>(descriptor.Offset + descriptor.Gain * number);
  }
  while (samples.size() > 1 && samples.back() == 0.0F)
  {
    samples.pop_back();
  }
  return {};
}

std::string LasPackets::Read(vtkPolyData* cloud, vtkTable* table)
{
  const Columns columns(table);
  std::vector<float> samples;
  for (const Packet& packet : this->Packets)
  {
    std::string problem = this->CheckPacket(packet);
    problem = problem.empty() ? this->ReadSamples(packet, samples) : problem;
    if (!problem.empty())
    {
      return "point " + std::to_string(packet.Row) + " of the piece " + problem;
    }
    const double speed = std::hypot(packet.Step[0], packet.Step[1], packet.Step[2]);
    const double location = static_cast<double>(packet.Location) / PicosecondsPerNanosecond;
    // without a range the origin is where the first sample came from
    const double range = GetNumber(cloud, names::Range, packet.Row, 0.5 * SpeedOfLight * location);
    double point[3];
    cloud->GetPoint(packet.Row, point);
    double direction[3];
    for (int k = 0; k < 3; ++k)
    {
      direction[k] = static_cast<double>(packet.Step[k]) / speed;
      point[k] -= range * direction[k];
    }
    columns.Pulses->InsertNextValue(static_cast<vtkTypeInt64>(
      GetNumber(cloud, names::WaveformIds, packet.Row, static_cast<double>(packet.Row))));
    columns.Origins->InsertNextTuple(point);
    columns.Directions->InsertNextTuple(direction);
    columns.Times->InsertNextValue(GetNumber(cloud, names::GpsTime, packet.Row, 0.0));
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
