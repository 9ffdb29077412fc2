// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLazPoints.h"

#include "heliosLazCodec.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace helios
{

namespace
{

///@{
/// A file has at most so many points per byte: more are damage, for which no memory is allocated.
constexpr std::uint64_t PointsPerByte = 100;
constexpr std::uint64_t FewPoints = 1000000;
///@}
constexpr std::int64_t TableAtEnd = -1; ///< the last bytes of the file locate the table
constexpr const char* Cure = "; it is cut off or damaged, copy it again";

} // namespace

LazPoints::LazPoints() = default;
LazPoints::~LazPoints() = default;

Status LazPoints::Start(
  const LasHeader& header, const LasRecord* record, std::uint64_t size, ReadBytes read)
{
  if (!record)
  {
    return Status::Error("has compressed points, but no record of LASzip; copy it again");
  }
  this->ReadFile = std::move(read);
  this->Begin = header.PointsBegin;
  this->Size = size;
  return this->Form.Decode(record->Data, header);
}

Status LazPoints::Open(
  const LasHeader& header, const LasRecord* record, std::uint64_t size, ReadBytes read)
{
  const std::uint64_t points = header.Points.Count;
  Status status = this->Start(header, record, size, std::move(read));
  if (status.IsOk() && points > FewPoints + PointsPerByte * size)
  {
    status = Status::Error("has " + std::to_string(size) + " bytes, too few for " +
      std::to_string(points) + " points" + Cure);
  }
  if (!status.IsOk() || points == 0 || !this->Form.HasChunks)
  {
    const bool isWhole = status.IsOk() && points > 0;
    this->Chunks.assign(isWhole ? 1 : 0, { points, this->Size - this->Begin });
    this->SetBegins();
    return status;
  }
  std::uint64_t end = this->Size;
  status = this->FindTable(points, end);
  this->Begin += LazTablePlaceSize;
  status = !status.IsOk() ? status
    : end > 0             ? this->ReadTable(points, end)
                          : this->FindChunks(points);
  end = end > 0 ? end : this->Size;
  status = status.IsOk() ? this->CheckChunks(points, end) : status;
  this->SetBegins();
  return status;
}

Status LazPoints::OpenGrowing(
  const LasHeader& header, const LasRecord* record, std::uint64_t size, ReadBytes read)
{
  Status status = this->Start(header, record, size, std::move(read));
  this->Begin += LazTablePlaceSize;
  status = status.IsOk() ? this->FindChunks(std::numeric_limits<std::uint64_t>::max()) : status;
  this->SetBegins();
  return status;
}

/// Finds the place of the table; 0: the writer was interrupted, and chunks with layers are found
/// without one.
Status LazPoints::FindTable(std::uint64_t points, std::uint64_t& place)
{
  char bytes[LazTablePlaceSize];
  const std::uint64_t first = this->Begin + LazTablePlaceSize;
  bool isRead = first <= this->Size && this->ReadFile(this->Begin, sizeof bytes, bytes);
  auto found = isRead ? LoadLas<std::int64_t>(bytes) : 0;
  if (isRead && found == TableAtEnd)
  {
    isRead = this->ReadFile(this->Size - sizeof bytes, sizeof bytes, bytes);
    found = LoadLas<std::int64_t>(bytes);
  }
  place = static_cast<std::uint64_t>(found);
  if (isRead && place == this->Begin && this->Form.IsLayered)
  {
    place = 0;
    return {};
  }
  return isRead && found > 0 && place >= first && place <= this->Size - 8
    ? Status()
    : Status::Error("has no table of its " + std::to_string(points) + " points at byte " +
        std::to_string(found) + " of " + std::to_string(this->Size) + Cure);
}

Status LazPoints::ReadTable(std::uint64_t points, std::uint64_t place)
{
  constexpr std::uint64_t bytesPerChunk = 16; // more than an entry needs
  const std::uint64_t most = 4096 + bytesPerChunk * std::min(points, this->Size);
  std::string bytes(std::min(most, this->Size - place), '\0');
  if (!this->ReadFile(place, bytes.size(), bytes.data()))
  {
    return Status::Error("cannot be read at byte " + std::to_string(place));
  }
  const Status status =
    DecodeLazTable(bytes, this->Form, points, place - this->Begin, this->Chunks);
  return status.IsOk() ? status : Status::Error(status.Message() + Cure);
}

/// Finds the chunks of a number of points, or all.
Status LazPoints::FindChunks(std::uint64_t points)
{
  this->Chunks.clear();
  std::string head(this->Form.GetHeadSize(), '\0');
  std::uint64_t found = 0;
  for (std::uint64_t place = this->Begin; place < this->Size && found < points;)
  {
    const std::uint64_t room = this->Size - place;
    LazChunk chunk;
    const bool isRead = head.size() <= room && this->ReadFile(place, head.size(), head.data());
    const Status status = isRead
      ? this->Form.DecodeHead(head, room, chunk)
      : Status::Error("has a chunk of " + std::to_string(room) + " bytes that is cut off");
    if (!status.IsOk())
    {
      return Status::Error(status.Message() + Cure);
    }
    this->Chunks.push_back(chunk);
    place += chunk.Bytes;
    found += chunk.Points;
  }
  return {};
}

/// Compares the sums of points and bytes of the chunks with what there is.
Status LazPoints::CheckChunks(std::uint64_t points, std::uint64_t end) const
{
  const auto least = static_cast<std::uint64_t>(this->Form.PointLength);
  std::uint64_t sum = 0;
  std::uint64_t bytes = 0;
  for (const LazChunk& chunk : this->Chunks)
  {
    sum += chunk.Points;
    bytes += chunk.Bytes;
    if (chunk.Bytes < least || chunk.Points == 0)
    {
      return Status::Error("has a chunk of " + std::to_string(chunk.Points) + " points in " +
        std::to_string(chunk.Bytes) + " bytes" + Cure);
    }
  }
  if (sum != points)
  {
    return Status::Error("has chunks with " + std::to_string(sum) + " points of the " +
      std::to_string(points) + " that its header counts" + Cure);
  }
  return bytes <= end - this->Begin
    ? Status()
    : Status::Error("has chunks of " + std::to_string(bytes) + " bytes in " +
        std::to_string(end - this->Begin) + " bytes" + Cure);
}

void LazPoints::SetBegins()
{
  this->Begins.assign(1, LazChunk{ 0, this->Begin });
  for (const LazChunk& chunk : this->Chunks)
  {
    const LazChunk& last = this->Begins.back();
    this->Begins.push_back({ last.Points + chunk.Points, last.Bytes + chunk.Bytes });
  }
}

/// Divides points among chunks; the first part continues with the last decoder, if it can.
std::vector<LazPoints::Part> LazPoints::FindParts(
  std::uint64_t first, std::uint64_t count, char* bytes)
{
  const auto after = std::upper_bound(this->Begins.begin(), this->Begins.end(), first,
    [](std::uint64_t point, const LazChunk& begin) { return point < begin.Points; });
  auto chunk = static_cast<std::size_t>(after - this->Begins.begin()) - 1;
  std::vector<Part> parts;
  for (std::uint64_t next = first; next < first + count; ++chunk)
  {
    const std::uint64_t begin = this->Begins[chunk].Points;
    const std::uint64_t end = std::min(first + count, this->Begins[chunk + 1].Points);
    const auto length = static_cast<std::uint64_t>(this->Form.PointLength);
    Part part{ chunk, next - begin, end - begin, bytes + (next - first) * length, nullptr };
    if (this->Current && this->CurrentChunk == chunk && this->CurrentNext == part.Begin)
    {
      part.Decoder = std::move(this->Current);
    }
    parts.push_back(std::move(part));
    next = end;
  }
  return parts;
}

/// Decompresses points of a chunk, also those before them if it must.
Status LazPoints::ReadPart(Part& part)
{
  Status status;
  if (!part.Decoder)
  {
    const LazChunk& chunk = this->Chunks[part.Chunk];
    std::string bytes(chunk.Bytes, '\0');
    if (!this->ReadFile(this->Begins[part.Chunk].Bytes, bytes.size(), bytes.data()))
    {
      return Status::Error("cannot be read; has it changed?");
    }
    part.Decoder = std::make_unique<LazDecoder>();
    status = part.Decoder->Open(this->Form, std::move(bytes), chunk.Points);
    constexpr std::uint64_t round = 4096;
    std::vector<char> skipped(round * static_cast<std::uint64_t>(this->Form.PointLength));
    for (std::uint64_t i = 0; i < part.Begin && status.IsOk(); i += round)
    {
      status = part.Decoder->Read(std::min(round, part.Begin - i), skipped.data());
    }
  }
  return status.IsOk() ? part.Decoder->Read(part.End - part.Begin, part.Bytes) : status;
}

Status LazPoints::Read(std::uint64_t first, std::uint64_t count, char* bytes)
{
  std::vector<Part> parts = this->FindParts(first, count, bytes);
  std::vector<Status> states(parts.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(parts.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        states[i] = this->ReadPart(parts[i]);
        parts[i].Decoder = i + 1 < parts.size() ? nullptr : std::move(parts[i].Decoder);
      }
    });
  for (const Status& status : states)
  {
    if (!status.IsOk())
    {
      return Status::Error(status.Message() + Cure);
    }
  }
  if (!parts.empty())
  {
    this->Current = std::move(parts.back().Decoder);
    this->CurrentChunk = parts.back().Chunk;
    this->CurrentNext = parts.back().End;
  }
  return {};
}

} // namespace helios
