// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLazSink.h"

#include "heliosLazCodec.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace helios
{

LazSink::LazSink(LazForm form, std::vector<LazChunk> chunks)
  : Form(std::move(form))
  , Chunks(std::move(chunks))
{
}

void LazSink::Mark()
{
  this->MarkedSize = this->Pending.size();
  this->MarkedChunks = this->Chunks.size();
  this->HasAppended = false;
}

void LazSink::Restore()
{
  if (this->HasAppended)
  {
    this->Pending = std::move(this->Marked);
  }
  this->Pending.resize(this->MarkedSize);
  this->Chunks.resize(this->MarkedChunks);
  this->HasAppended = false;
}

Status LazSink::Add(const std::vector<char>& records, const AppendBytes& append)
{
  this->Pending.insert(this->Pending.end(), records.begin(), records.end());
  const auto chunkSize = LazPointsPerChunk * static_cast<std::uint64_t>(this->Form.PointLength);
  const auto threads = static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
  const std::size_t chunks = this->Pending.size() / chunkSize;
  return chunks < threads ? Status() : this->AppendChunks(chunks * LazPointsPerChunk, append);
}

Status LazSink::Finish(const AppendBytes& append)
{
  const auto length = static_cast<std::uint64_t>(this->Form.PointLength);
  return this->AppendChunks(this->Pending.size() / length, append);
}

/// Compresses the first points in chunks, and appends these in order.
Status LazSink::AppendChunks(std::uint64_t points, const AppendBytes& append)
{
  std::vector<LazBytes> chunks;
  Status status = EncodeLazChunks(this->Form, this->Pending.data(), points, chunks);
  if (!this->HasAppended && points > 0)
  {
    const auto marked = this->Pending.begin() + static_cast<std::ptrdiff_t>(this->MarkedSize);
    this->Marked.assign(this->Pending.begin(), marked);
    this->HasAppended = true;
  }
  for (const LazBytes& chunk : chunks)
  {
    status = status.IsOk() && !append(chunk.Bytes) ? Status::Error(NotAppended) : status;
    if (!status.IsOk())
    {
      return status;
    }
    this->Chunks.push_back({ chunk.Points, chunk.Bytes.size() });
  }
  const auto size = static_cast<std::ptrdiff_t>(points) * this->Form.PointLength;
  this->Pending.erase(this->Pending.begin(), this->Pending.begin() + size);
  return status;
}

vtkIdType LazSink::GetNumberOfPoints() const
{
  return std::accumulate(this->Chunks.begin(), this->Chunks.end(), vtkIdType(0),
    [](vtkIdType sum, const LazChunk& chunk)
    { return sum + static_cast<vtkIdType>(chunk.Points); });
}

std::string LazSink::EncodeTable() const
{
  return EncodeLazTable(this->Chunks);
}

} // namespace helios
