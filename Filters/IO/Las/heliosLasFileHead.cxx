// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasFileHead.h"

#include "heliosLasFile.h"
#include "heliosLasWaves.h"
#include "heliosStatus.h"
#include "vtkHeliosArrayNames.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace helios
{

namespace
{

/// Returns the end of the packet of a point in the packet file; 0: no packet.
std::uint64_t GetPacketEnd(const char* wave)
{
  return wave[0] ? LoadLas<std::uint64_t>(wave + 1) + LoadLas<std::uint32_t>(wave + 9) : 0;
}

/// Counts all points of a file, and finds the end of their last packet.
Status Summarize(LasFile& file, LasSummary& summary, std::uint64_t& packetsEnd)
{
  const LasHeader& header = file.GetHeader();
  const auto length = static_cast<std::uint64_t>(header.PointLength);
  const int wave = GetLasPointForm(header.Format).Wave;
  std::vector<char> bytes;
  for (std::uint64_t first = 0; first < header.Points.Count;)
  {
    const auto count = std::min(file.GetPointsPerRound(), header.Points.Count - first);
    bytes.resize(count * length);
    Status status = file.Read(first, count, bytes.data());
    if (!status.IsOk())
    {
      return status;
    }
    summary.Add(bytes.data(), static_cast<std::int64_t>(count), header.PointLength);
    for (std::uint64_t i = 0; wave >= 0 && i < count; ++i)
    {
      packetsEnd = std::max(packetsEnd, GetPacketEnd(bytes.data() + i * length + wave));
    }
    first += count;
  }
  return {};
}

} // namespace

bool ReadGpsEpoch(vtkPolyData* echoes, double& epoch)
{
  vtkAbstractArray* any = echoes->GetFieldData()->GetAbstractArray(vtkHeliosArrayNames::GpsEpoch);
  auto* array = vtkDataArray::SafeDownCast(any);
  if (any && (!array || array->GetNumberOfValues() != 1 || !std::isfinite(array->GetTuple1(0))))
  {
    return false;
  }
  epoch = array ? array->GetTuple1(0) : 0.0;
  return true;
}

std::string LasFileHead::EncodeRecords(std::uint32_t& count) const
{
  const LasRecord wkt{ LasProjectionUser, LasWktId, "OGC coordinate system WKT", this->Wkt + '\0' };
  const LasRecord extras{ LasSpecUser, LasExtraBytesId, "Extra Bytes", this->Arrays };
  const LasHeader& header = this->Header;
  const std::string compression = header.IsCompressed
    ? LazForm::Make(header.Format, header.PointLength).Encode().Encode()
    : std::string();
  count = (compression.empty() ? 0 : 1) + (this->Wkt.empty() ? 0 : 1) +
    (this->Arrays.empty() ? 0 : 1) + (this->HasWaves ? LasWaves::NumberOfForms : 0);
  return compression + (this->Wkt.empty() ? std::string() : wkt.Encode()) +
    (this->Arrays.empty() ? std::string() : extras.Encode()) +
    (this->HasWaves ? LasWaves::EncodeDescriptors(this->Spacing) : std::string());
}

std::string LasFileHead::ListArrays() const
{
  std::vector<LasExtra> extras;
  static_cast<void>(DecodeLasExtras(this->Arrays, extras)); // made by EncodeLasExtras()
  std::string text;
  for (const LasExtra& extra : extras)
  {
    text += (text.empty() ? "" : ", ") + extra.Name + " (type " + std::to_string(extra.Type) + ")";
  }
  return text.empty() ? "none" : text;
}

Status LasFileHead::Read(
  const std::string& path, vtkIdType records, bool hasWaves, std::uint64_t& packetsEnd)
{
  LasFile file;
  LasSummary summary;
  Status status = file.OpenGrowing(path);
  status = status.IsOk() ? Summarize(file, summary, packetsEnd) : status;
  if (!status.IsOk())
  {
    return status;
  }
  this->Header = file.GetHeader();
  this->HasWaves = (this->Header.Encoding & LasHeader::ExternalWaves) != 0;
  if (summary.Count != static_cast<std::uint64_t>(records))
  {
    return Status::Error(path + " has " + std::to_string(summary.Count) + " points, not " +
      std::to_string(records) + ", and cannot be resumed");
  }
  if (this->HasWaves != hasWaves)
  {
    return Status::Error(path + " has " + (hasWaves ? "no " : "") +
      "waveforms; switch WriteWaveforms " + (hasWaves ? "off" : "on") + ", as it was");
  }
  const LasRecord* extras = file.Find(LasSpecUser, LasExtraBytesId);
  const LasRecord* descriptor = file.Find(LasSpecUser, LasWaves::FirstDescriptorId);
  if (descriptor && descriptor->Description != LasWaves::Description)
  {
    return Status::Error(path +
      " was started by an earlier version, whose waveform vectors point away from the scanner, and "
      "cannot be resumed; start again (vtkhelios run --overwrite)");
  }
  this->Header.Points = summary;
  this->Chunks = file.GetChunks();
  this->Arrays = extras ? extras->Data : std::string();
  this->Wkt = file.GetCrs();
  this->Spacing = descriptor && descriptor->Data.size() >= 10
    ? LoadLas<std::uint32_t>(descriptor->Data.data() + 6)
    : 0;
  this->Scaling.Scale = this->Header.Scale;
  this->Scaling.Offset = this->Header.Offset;
  this->HasTime = false;
  return {};
}

} // namespace helios
