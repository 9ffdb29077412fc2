// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosCopcFile.h"

#include "heliosInputFile.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numeric>
#include <utility>

namespace helios
{

namespace
{

constexpr const char* User = "copc";
constexpr int InfoId = 1;
constexpr int PagesId = 1000;
constexpr std::size_t InfoSize = 160;

///@{
/// Offsets in the header of LAS 1.4.
constexpr std::size_t AtPointsBegin = 96;
constexpr std::size_t AtNumberOfRecords = 100;
constexpr std::size_t AtBox = 179; ///< largest and smallest x, then y, z
constexpr std::size_t AtExtendedBegin = 235;
constexpr std::size_t AtNumberOfExtended = 243;
///@}

constexpr double ReadingShare = 0.3; ///< share of the time

template <typename T>
void Append(std::string& bytes, T value)
{
  bytes += EncodeLas(value);
}

/// Returns the cell of a coordinate along an axis of the cube. The border of a cell is low + cell *
/// size, as readers compute it: floor() alone may be off by one there.
std::uint64_t FindCell(double value, double low, double size)
{
  constexpr double last = (std::uint64_t(1) << MortonBits) - 1;
  double cell = std::clamp(std::floor((value - low) / size), 0.0, last);
  cell -= cell > 0.0 && value < low + cell * size ? 1.0 : 0.0;
  cell += cell < last && value >= low + (cell + 1.0) * size ? 1.0 : 0.0;
  return static_cast<std::uint64_t>(cell);
}

/// Returns the points of a node in the order of the file.
std::string SortByIndex(const OctreeNode& node, std::size_t length)
{
  std::vector<std::size_t> rows(node.Indices.size());
  std::iota(rows.begin(), rows.end(), std::size_t(0));
  std::sort(rows.begin(), rows.end(),
    [&node](std::size_t a, std::size_t b) { return node.Indices[a] < node.Indices[b]; });
  std::string sorted;
  sorted.reserve(node.Records.size());
  for (const std::size_t row : rows)
  {
    sorted.append(&node.Records[row * length], length);
  }
  return sorted;
}

} // namespace

CopcFile::CopcFile(Watch watch, std::uint64_t memory)
  : OnProgress(std::move(watch))
  , Bytes(memory)
{
}

Status CopcFile::Append(const std::string& bytes)
{
  return this->File.Append(bytes.data(), bytes.size()) ? Status()
                                                       : Status::Error(this->File.GetProblem());
}

Status CopcFile::Overwrite(std::uint64_t place, const std::string& bytes)
{
  return this->File.Overwrite(place, bytes.data(), bytes.size())
    ? Status()
    : Status::Error(this->File.GetProblem());
}

Status CopcFile::Report(double share) const
{
  return !this->OnProgress || this->OnProgress(share) ? Status() : Status::Error(Stopped);
}

//------------------------------------------------------------------------------
Status CopcFile::Write(const std::string& laz, const std::string& path)
{
  if (!this->File.Open(path))
  {
    return Status::Error(this->File.GetProblem());
  }
  Status status = this->WriteFile(laz);
  status = status.IsOk() ? this->File.Sync() : status;
  if (!this->File.Abandon() && status.IsOk())
  {
    status = Status::Error(this->File.GetProblem());
  }
  if (!status.IsOk())
  {
    RemoveFile(this->File.GetPartPath());
  }
  return status;
}

//------------------------------------------------------------------------------
Status CopcFile::WriteFile(const std::string& laz)
{
  Status status = this->Open(laz);
  if (!status.IsOk())
  {
    return status;
  }
  const std::string folder = std::filesystem::path(this->File.GetPath()).parent_path().string();
  PointSort sort(folder, static_cast<std::size_t>(this->Form.PointLength), this->Bytes);
  status = this->Append(this->Head + std::string(LazTablePlaceSize, '\0'));
  status = status.IsOk() ? this->ReadPoints(sort) : status;
  status = status.IsOk() ? this->WriteNodes(sort) : status;
  return status.IsOk() ? this->WriteTable() : status;
}

//------------------------------------------------------------------------------
/// Opens the points, and makes the head of the file and the cube.
Status CopcFile::Open(const std::string& laz)
{
  const InputWatch ignore([](const std::string&, const std::string&) {});
  const Status status = this->Source.Open(laz);
  const LasHeader& header = this->Source.GetHeader();
  if (!status.IsOk())
  {
    return status;
  }
  if (header.Minor != 4 || header.Format < 6 || header.Format > 8 || !header.IsCompressed)
  {
    return Status::Error(laz + ": is not LAZ 1.4 of point format 6, 7 or 8, which COPC needs");
  }
  this->Form = LazForm::Make(header.Format, header.PointLength);
  this->Head = this->Source.ReadHead();
  double step = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const char* box = this->Head.data() + AtBox + 16 * axis;
    this->Low[axis] = LoadLas<double>(box + 8);
    this->Side = std::max(this->Side, LoadLas<double>(box) - this->Low[axis]);
    step = std::max(step, std::abs(header.Scale[axis]));
  }
  this->Side = this->Side > 0.0 ? this->Side : step;
  this->Head.insert(LasHeader::Size14, std::string(LasRecord::HeadSize + InfoSize, '\0'));
  StoreLas(&this->Head[AtPointsBegin], static_cast<std::uint32_t>(this->Head.size()));
  StoreLas(&this->Head[AtNumberOfRecords], header.NumberOfRecords + 1);
  StoreLas(&this->Head[AtNumberOfExtended], std::uint32_t(1));
  return {};
}

//------------------------------------------------------------------------------
/// Reads all points, with their places on the curve.
Status CopcFile::ReadPoints(PointSort& sort)
{
  const LasHeader& header = this->Source.GetHeader();
  const auto length = static_cast<std::size_t>(header.PointLength);
  const auto time = static_cast<std::size_t>(GetLasPointForm(header.Format).Time);
  const double size = std::ldexp(this->Side, -MortonBits);
  std::vector<char> bytes;
  std::vector<std::uint64_t> codes;
  this->FirstTime = header.Points.Count > 0 ? std::numeric_limits<double>::infinity() : 0.0;
  this->LastTime = -this->FirstTime;
  for (std::uint64_t first = 0; first < header.Points.Count; first += codes.size())
  {
    codes.resize(std::min(this->Source.GetPointsPerRound(), header.Points.Count - first));
    bytes.resize(codes.size() * length);
    Status status = this->Source.Read(first, codes.size(), bytes.data());
    if (!status.IsOk())
    {
      return status;
    }
    for (std::size_t i = 0; i < codes.size(); ++i)
    {
      const char* record = &bytes[i * length];
      codes[i] = 0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double value = header.GetCoordinate(LoadLas<std::int32_t>(record + 4 * axis), axis);
        const double low = this->Low[static_cast<std::size_t>(axis)];
        codes[i] |= SpreadMorton(FindCell(value, low, size)) << axis;
      }
      const auto seconds = LoadLas<double>(record + time);
      this->FirstTime = std::min(this->FirstTime, seconds);
      this->LastTime = std::max(this->LastTime, seconds);
    }
    status = sort.Add(codes, bytes.data());
    const auto done = static_cast<double>(first + codes.size());
    status = status.IsOk()
      ? this->Report(ReadingShare * done / static_cast<double>(header.Points.Count))
      : status;
    if (!status.IsOk())
    {
      return status;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status CopcFile::WriteNodes(PointSort& sort)
{
  OctreeNodes nodes(static_cast<std::size_t>(this->Form.PointLength),
    [this](OctreeNode&& node) { return this->AddNode(std::move(node)); });
  Status status = sort.Visit([&nodes](const SortedPoint& point) { return nodes.Add(point); });
  status = status.IsOk() ? nodes.Finish() : status;
  return status.IsOk() ? this->WriteBatch() : status;
}

//------------------------------------------------------------------------------
/// Collects nodes until there are enough for all threads.
Status CopcFile::AddNode(OctreeNode&& node)
{
  const auto threads = static_cast<std::uint64_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
  this->BatchPoints += node.Indices.size();
  this->Batch.push_back(std::move(node));
  return this->BatchPoints < threads * LazPointsPerChunk ? Status() : this->WriteBatch();
}

//------------------------------------------------------------------------------
/// Compresses nodes in parallel, and appends them in order.
Status CopcFile::WriteBatch()
{
  std::vector<std::string> chunks(this->Batch.size());
  std::vector<Status> states(this->Batch.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Batch.size()), 1,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const OctreeNode& node = this->Batch[i];
        const std::string points =
          SortByIndex(node, static_cast<std::size_t>(this->Form.PointLength));
        states[i] = EncodeLazChunk(this->Form, points.data(), node.Indices.size(), chunks[i]);
      }
    });
  for (std::size_t i = 0; i < chunks.size(); ++i)
  {
    const OctreeNode& node = this->Batch[i];
    this->Entries.push_back(
      { node.Level, node.Code, this->File.GetSize(), { node.Indices.size(), chunks[i].size() } });
    this->Done += node.Indices.size();
    const Status status = states[i].IsOk() ? this->Append(chunks[i]) : states[i];
    if (!status.IsOk())
    {
      return status;
    }
  }
  this->Batch.clear();
  this->BatchPoints = 0;
  const auto count = static_cast<double>(std::max<std::uint64_t>(1, this->Done));
  const auto all = static_cast<double>(std::max(this->Done, this->Source.GetHeader().Points.Count));
  return this->Report(ReadingShare + (1.0 - ReadingShare) * count / std::max(1.0, all));
}

//------------------------------------------------------------------------------
/// Writes the table of chunks, the pages of the octree and the head.
Status CopcFile::WriteTable()
{
  std::vector<LazChunk> chunks;
  for (const Entry& entry : this->Entries)
  {
    chunks.push_back(entry.Chunk);
  }
  const std::uint64_t table = this->File.GetSize();
  Status status = this->Append(EncodeLazTable(chunks));
  const std::string pages = this->EncodePages();
  StoreLas(&this->Head[AtExtendedBegin], this->File.GetSize());
  this->PagesPlace = this->File.GetSize() + LasRecord::ExtendedHeadSize;
  status = status.IsOk() ? this->Append(pages) : status;
  const std::string info = LasRecord{ User, InfoId, "COPC info", this->EncodeInfo() }.Encode();
  this->Head.replace(LasHeader::Size14, info.size(), info);
  return status.IsOk() ? this->Overwrite(0, this->Head + EncodeLas(table)) : status;
}

//------------------------------------------------------------------------------
/// Returns the record of the cube and of the first page.
std::string CopcFile::EncodeInfo() const
{
  std::string info;
  for (const double low : this->Low)
  {
    helios::Append(info, low + 0.5 * this->Side); // centre
  }
  helios::Append(info, 0.5 * this->Side);
  helios::Append(info, std::ldexp(this->Side, -OctreeGridBits)); // spacing of the root
  helios::Append(info, this->PagesPlace);
  helios::Append(info, this->File.GetSize() - this->PagesPlace);
  helios::Append(info, this->FirstTime);
  helios::Append(info, this->LastTime);
  info.resize(InfoSize);
  return info;
}

//------------------------------------------------------------------------------
/// Returns the nodes as one page, an extended record; a file without points has an empty root.
std::string CopcFile::EncodePages() const
{
  std::vector<Entry> entries = this->Entries;
  if (entries.empty())
  {
    entries.push_back({ 0, 0, 0, {} });
  }
  std::string data;
  for (const Entry& entry : entries)
  {
    helios::Append(data, static_cast<std::int32_t>(entry.Level));
    for (int axis = 0; axis < 3; ++axis)
    {
      helios::Append(data, static_cast<std::int32_t>(GatherMorton(entry.Code >> axis)));
    }
    helios::Append(data, entry.Place);
    helios::Append(data, static_cast<std::int32_t>(entry.Chunk.Bytes));
    helios::Append(data, static_cast<std::int32_t>(entry.Chunk.Points));
  }
  return LasRecord{ User, PagesId, "EPT Hierarchy", data }.EncodeExtended();
}

} // namespace helios
