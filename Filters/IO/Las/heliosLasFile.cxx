// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLasFile.h"

#include "heliosInputFile.h"
#include "heliosLasGeoKeys.h"
#include "heliosStatus.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <numeric>
#include <system_error>

namespace helios
{

namespace
{

///@{
/// Points read at once; of LAZ chunks for all threads.
constexpr std::uint64_t PointsPerRound = 1 << 14;
constexpr std::uint64_t PointsPerThread = 1 << 16;
///@}

} // namespace

bool LasFile::ReadBytes(std::uint64_t place, std::uint64_t count, char* bytes)
{
  const std::lock_guard<std::mutex> lock(this->Reading);
  this->File.clear();
  this->File.seekg(static_cast<std::streamoff>(place));
  this->File.read(bytes, static_cast<std::streamsize>(count));
  return this->File.good();
}

/// Reads the header.
Status LasFile::OpenFile()
{
  this->Records.clear();
  this->Extras.clear();
  this->Header = LasHeader();
  Status status = CheckInputFile(this->Path);
  if (!status.IsOk())
  {
    return status;
  }
  std::error_code error;
  this->File = std::ifstream(this->Path, std::ios::binary);
  if (!this->File)
  {
    return Status::Error("cannot be read: " + std::generic_category().message(errno));
  }
  this->Size = std::filesystem::file_size(this->Path, error);
  std::string bytes(error ? 0 : std::min<std::uint64_t>(LasHeader::LargestSize, this->Size), '\0');
  if (!this->ReadBytes(0, bytes.size(), bytes.data()))
  {
    return Status::Error("cannot be read");
  }
  status = this->Header.Decode(bytes);
  return status.IsOk() && this->Header.PointsBegin > this->Size
    ? Status::Error("has " + std::to_string(this->Size) + " bytes, and its points begin at byte " +
        std::to_string(this->Header.PointsBegin) + ": it is cut off")
    : status;
}

/// Checks the number of points, or finds the chunks of LAZ.
Status LasFile::OpenPoints()
{
  const LasHeader& header = this->Header;
  if (header.IsCompressed)
  {
    return this->Compressed.Open(header, this->Find(LazForm::User, LazForm::RecordId), this->Size,
      [this](std::uint64_t place, std::uint64_t count, char* bytes)
      { return this->ReadBytes(place, count, bytes); });
  }
  const std::uint64_t room =
    (this->Size - header.PointsBegin) / static_cast<std::uint64_t>(header.PointLength);
  return header.Points.Count > room
    ? Status::Error("has " + std::to_string(room) + " whole points of the " +
        std::to_string(header.Points.Count) + " that its header counts: it is cut off")
    : Status();
}

/// Counts the points up to the end of a file.
Status LasFile::OpenGrowingPoints()
{
  LasHeader& header = this->Header;
  Status status;
  if (header.IsCompressed)
  {
    status =
      this->Compressed.OpenGrowing(header, this->Find(LazForm::User, LazForm::RecordId), this->Size,
        [this](std::uint64_t place, std::uint64_t count, char* bytes)
        { return this->ReadBytes(place, count, bytes); });
  }
  header.Points.Count = header.IsCompressed
    ? this->Compressed.GetCount()
    : (this->Size - header.PointsBegin) / static_cast<std::uint64_t>(header.PointLength);
  return status;
}

Status LasFile::Open(const std::string& path)
{
  this->Path = path;
  Status status = this->OpenFile();
  status = status.IsOk() ? this->ReadRecords() : status;
  status = status.IsOk() ? this->OpenPoints() : status;
  status = status.IsOk() ? this->CheckExtras() : status;
  return status.IsOk() ? status : Status::Error(path + ": " + status.Message());
}

Status LasFile::OpenGrowing(const std::string& path)
{
  this->Path = path;
  Status status = this->OpenFile();
  status = status.IsOk() ? this->ReadRecords() : status;
  status = status.IsOk() ? this->OpenGrowingPoints() : status;
  return status.IsOk() ? status : Status::Error(path + ": " + status.Message());
}

Status LasFile::ReadRecords()
{
  std::uint64_t place = this->Header.HeaderSize;
  Status status;
  for (std::uint32_t i = 0; i < this->Header.NumberOfRecords && status.IsOk(); ++i)
  {
    status = this->ReadRecord(place, this->Header.PointsBegin, false);
  }
  place = this->Header.ExtendedBegin;
  for (std::uint32_t i = 0; i < this->Header.NumberOfExtended && status.IsOk(); ++i)
  {
    status = this->ReadRecord(place, this->Size, true);
  }
  return status;
}

/// Reads a variable length record. Only requested extended records are kept: others may be large.
Status LasFile::ReadRecord(std::uint64_t& place, std::uint64_t end, bool isExtended)
{
  const std::uint64_t headSize = isExtended ? LasRecord::ExtendedHeadSize : LasRecord::HeadSize;
  const std::string where = isExtended ? "an extended record" : "a variable length record";
  char head[LasRecord::ExtendedHeadSize];
  if (place > end || end - place < headSize || !this->ReadBytes(place, headSize, head))
  {
    return Status::Error("has " + where + " at byte " + std::to_string(place) +
      " that ends after byte " + std::to_string(end));
  }
  place += headSize;
  const std::uint64_t size =
    isExtended ? LoadLas<std::uint64_t>(head + 20) : LoadLas<std::uint16_t>(head + 20);
  if (size > end - place)
  {
    return Status::Error("has " + where + " of " + std::to_string(size) + " bytes at byte " +
      std::to_string(place) + ", where there is room for " + std::to_string(end - place));
  }
  LasRecord record;
  record.User = GetLasText({ head + 2, 16 });
  record.Id = LoadLas<std::uint16_t>(head + 18);
  record.Description = GetLasText({ head + (isExtended ? 28 : 22), 32 });
  const bool isKept = !isExtended || record.User == LasProjectionUser ||
    (record.User == LasSpecUser && record.Id == LasExtraBytesId);
  if (isKept)
  {
    record.Data.resize(size);
    if (size > 0 && !this->ReadBytes(place, size, record.Data.data()))
    {
      return Status::Error("cannot be read at byte " + std::to_string(place));
    }
    this->Records.push_back(std::move(record));
  }
  place += size;
  const LasRecord* extras = isKept ? &this->Records.back() : nullptr;
  return extras && extras->User == LasSpecUser && extras->Id == LasExtraBytesId
    ? DecodeLasExtras(extras->Data, this->Extras)
    : Status();
}

Status LasFile::CheckExtras() const
{
  const int room = this->Header.PointLength - GetLasPointForm(this->Header.Format).Length;
  const std::int64_t needed = std::accumulate(this->Extras.begin(), this->Extras.end(),
    std::int64_t(0), [](std::int64_t sum, const LasExtra& extra) { return sum + extra.Size; });
  return needed > room
    ? Status::Error("has points with " + std::to_string(room) +
        " bytes after their format, but describes Extra Bytes of " + std::to_string(needed))
    : Status();
}

std::uint64_t LasFile::GetPointsPerRound() const
{
  return this->Header.IsCompressed
    ? PointsPerThread * static_cast<std::uint64_t>(vtkSMPTools::GetEstimatedNumberOfThreads())
    : PointsPerRound;
}

Status LasFile::Read(std::uint64_t first, std::uint64_t count, char* bytes)
{
  const auto length = static_cast<std::uint64_t>(this->Header.PointLength);
  const std::string points = std::to_string(first) + " to " + std::to_string(first + count - 1);
  if (this->Header.IsCompressed)
  {
    const Status status = this->Compressed.Read(first, count, bytes);
    return status.IsOk()
      ? status
      : Status::Error(this->Path + ": at points " + points + " " + status.Message());
  }
  return this->ReadBytes(this->Header.PointsBegin + first * length, count * length, bytes)
    ? Status()
    : Status::Error(this->Path + ": its points " + points + " cannot be read; has it changed?");
}

std::string LasFile::ReadHead()
{
  std::string bytes(this->Header.PointsBegin, '\0');
  return this->ReadBytes(0, bytes.size(), bytes.data()) ? bytes : std::string();
}

const LasRecord* LasFile::Find(const char* user, int id) const
{
  const auto found = std::find_if(this->Records.begin(), this->Records.end(),
    [user, id](const LasRecord& record) { return record.User == user && record.Id == id; });
  return found == this->Records.end() ? nullptr : &*found;
}

std::string LasFile::GetCrs() const
{
  const LasRecord* wkt = this->Find(LasProjectionUser, LasWktId);
  const LasRecord* keys = this->Find(LasProjectionUser, LasGeoKeysId);
  const std::string text = wkt ? GetLasText(wkt->Data) : std::string();
  return !text.empty() || !keys ? text : GetGeoKeysCrs(keys->Data);
}

} // namespace helios
