// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosPointSort.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <queue>
#include <tuple>
#include <utility>

#include <unistd.h>

namespace helios
{

namespace
{

constexpr std::size_t AtIndex = 8; ///< in an entry of the scratch file, after the code
constexpr std::size_t AtRecord = 16;
constexpr std::size_t BlockSize = 1 << 20; ///< bytes that are written at once

std::uint64_t LoadNumber(const char* bytes)
{
  std::uint64_t value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

} // namespace

PointSort::PointSort(std::string folder, std::size_t length, std::uint64_t memory)
  : Folder(folder.empty() ? "." : std::move(folder))
  , Length(length)
  , EntrySize(AtRecord + length)
  , Memory(memory)
  , RowsPerRun(std::max<std::uint64_t>(1, memory / (length + sizeof(Key))))
{
}

PointSort::~PointSort()
{
  if (this->Scratch >= 0)
  {
    ::close(this->Scratch);
  }
}

Status PointSort::Fail(const char* what, int error) const
{
  return Status::Error("the scratch file in the folder " + this->Folder + " cannot be " + what +
    ": " + std::strerror(error));
}

Status PointSort::Add(const std::vector<std::uint64_t>& codes, const char* records)
{
  for (std::size_t done = 0; done < codes.size();)
  {
    const auto room = static_cast<std::size_t>(this->RowsPerRun) - this->Keys.size();
    const std::size_t count = std::min(room, codes.size() - done);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Keys.push_back({ codes[done + i], this->Keys.size() });
    }
    const char* begin = records + done * this->Length;
    this->Records.insert(this->Records.end(), begin, begin + count * this->Length);
    done += count;
    const bool isFull = this->Keys.size() == this->RowsPerRun;
    if (const Status status = isFull ? this->StoreRun() : Status(); !status.IsOk())
    {
      return status;
    }
  }
  return {};
}

void PointSort::Sort()
{
  vtkSMPTools::Sort(this->Keys.begin(), this->Keys.end(),
    [](const Key& a, const Key& b) { return std::tie(a.Code, a.Row) < std::tie(b.Code, b.Row); });
}

/// Appends bytes to the scratch file, which has no name.
Status PointSort::Append(const std::vector<char>& bytes)
{
  if (this->Scratch < 0)
  {
    std::string path = this->Folder + "/vtkHelios-points-XXXXXX";
    this->Scratch = ::mkstemp(path.data());
    if (this->Scratch < 0)
    {
      return this->Fail("made", errno);
    }
    ::unlink(path.c_str());
  }
  for (std::size_t done = 0; done < bytes.size();)
  {
    const ssize_t written = ::pwrite(this->Scratch, bytes.data() + done, bytes.size() - done,
      static_cast<off_t>(this->ScratchSize));
    if (written <= 0 && errno != EINTR)
    {
      return this->Fail("written", errno);
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    this->ScratchSize += static_cast<std::uint64_t>(std::max<ssize_t>(written, 0));
  }
  return {};
}

/// Sorts the points in memory, and moves them to the scratch file.
Status PointSort::StoreRun()
{
  this->Sort();
  this->Runs.push_back({ this->ScratchSize, this->Keys.size(), {} });
  std::vector<char> bytes;
  Status status;
  for (std::size_t i = 0; i < this->Keys.size() && status.IsOk(); ++i)
  {
    const Key& key = this->Keys[i];
    const std::uint64_t index = this->First + key.Row;
    const std::size_t at = bytes.size();
    bytes.resize(at + this->EntrySize);
    std::memcpy(&bytes[at], &key.Code, sizeof key.Code);
    std::memcpy(&bytes[at + AtIndex], &index, sizeof index);
    std::memcpy(&bytes[at + AtRecord], &this->Records[key.Row * this->Length], this->Length);
    if (bytes.size() >= BlockSize || i + 1 == this->Keys.size())
    {
      status = this->Append(bytes);
      bytes.clear();
    }
  }
  this->First += this->Keys.size();
  this->Keys.clear();
  this->Records.clear();
  return status;
}

Status PointSort::Visit(const std::function<Status(const SortedPoint&)>& use)
{
  if (this->Runs.empty())
  {
    return this->VisitMemory(use);
  }
  const Status status = this->Keys.empty() ? Status() : this->StoreRun();
  std::vector<Key>().swap(this->Keys);
  std::vector<char>().swap(this->Records);
  return status.IsOk() ? this->Merge(use) : status;
}

Status PointSort::VisitMemory(const std::function<Status(const SortedPoint&)>& use)
{
  this->Sort();
  Status status;
  for (std::size_t i = 0; i < this->Keys.size() && status.IsOk(); ++i)
  {
    const Key& key = this->Keys[i];
    status = use({ key.Code, key.Row, &this->Records[key.Row * this->Length] });
  }
  return status;
}

SortedPoint PointSort::GetPoint(const Run& run) const
{
  const char* entry = &run.Bytes[run.At];
  return { LoadNumber(entry), LoadNumber(entry + AtIndex), entry + AtRecord };
}

/// Reads the next points of a run: its share of the memory.
Status PointSort::Load(Run& run)
{
  const std::uint64_t share = this->Memory / this->Runs.size() / this->EntrySize;
  const std::uint64_t count = std::min(run.Count, std::max<std::uint64_t>(1, share));
  run.Bytes.resize(count * this->EntrySize);
  run.At = 0;
  for (std::size_t done = 0; done < run.Bytes.size();)
  {
    const ssize_t read = ::pread(this->Scratch, run.Bytes.data() + done, run.Bytes.size() - done,
      static_cast<off_t>(run.Place));
    if (read <= 0 && errno != EINTR)
    {
      return this->Fail("read", read < 0 ? errno : EIO);
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(read, 0));
    run.Place += static_cast<std::uint64_t>(std::max<ssize_t>(read, 0));
  }
  run.Count -= count;
  return {};
}

Status PointSort::Merge(const std::function<Status(const SortedPoint&)>& use)
{
  using Next = std::tuple<std::uint64_t, std::uint64_t, std::size_t>; // code, index, run
  std::priority_queue<Next, std::vector<Next>, std::greater<>> heap;
  Status status;
  for (std::size_t i = 0; i < this->Runs.size() && status.IsOk(); ++i)
  {
    status = this->Load(this->Runs[i]);
    const SortedPoint point = this->GetPoint(this->Runs[i]);
    heap.emplace(point.Code, point.Index, i);
  }
  while (!heap.empty() && status.IsOk())
  {
    const std::size_t i = std::get<2>(heap.top());
    heap.pop();
    Run& run = this->Runs[i];
    status = use(this->GetPoint(run));
    run.At += this->EntrySize;
    const bool isEnd = run.At == run.Bytes.size();
    status = status.IsOk() && isEnd && run.Count > 0 ? this->Load(run) : status;
    if (status.IsOk() && run.At < run.Bytes.size())
    {
      const SortedPoint point = this->GetPoint(run);
      heap.emplace(point.Code, point.Index, i);
    }
  }
  return status;
}

} // namespace helios
