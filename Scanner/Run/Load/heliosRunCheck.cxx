// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunCheck.h"

#include "heliosPartFile.h"
#include "heliosPointNames.h"
#include "heliosRunJournal.h"
#include "heliosStatus.h"
#include "vtkHeliosRunFiles.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

namespace helios
{
namespace fs = std::filesystem;

namespace
{

constexpr const char* StartAgain = "; set Overwrite (--overwrite) to start again";

/// Returns the size of a file [bytes]; -1 if missing, with the reason.
vtkIdType GetSize(const std::string& path, std::string& why)
{
  std::error_code error;
  const auto size = fs::file_size(path, error);
  why = error ? error.message() : std::string();
  return error ? -1 : static_cast<vtkIdType>(size);
}

/// Describes a wrong size: "cannot be read: ..." or "has 5".
std::string Describe(vtkIdType size, const std::string& why)
{
  return size < 0 ? "cannot be read: " + why : "has " + std::to_string(size);
}

} // namespace

//------------------------------------------------------------------------------
RunCheck::RunCheck(const std::string& folder, const std::string& cure)
  : Folder(folder)
  , Cure(cure.empty() ? StartAgain : cure)
{
}

//------------------------------------------------------------------------------
std::string RunCheck::GetPath(const std::string& name) const
{
  return (fs::path(this->Folder) / name).string();
}

//------------------------------------------------------------------------------
std::string RunCheck::FindFile(const std::string& name) const
{
  std::error_code ignored;
  const std::string part = this->GetPath(name + PartEnding);
  const std::string path = this->GetPath(name);
  return fs::exists(part, ignored) || !fs::exists(path, ignored) ? part : path;
}

//------------------------------------------------------------------------------
Status RunCheck::CheckSizes(const RunJournal& journal) const
{
  std::map<std::string, FileProgress> files = journal.GetFiles();
  for (const FileBlock& block : journal.GetBlocks()) // blocks of other files
  {
    FileProgress& file = files[block.Name];
    file.Name = block.Name;
    file.Size = std::max(file.Size, static_cast<vtkIdType>(block.End));
    file.IsWhole = file.IsWhole || block.IsWhole;
  }
  for (const auto& file : files)
  {
    const Status status = this->CheckSize(file.second);
    if (!status.IsOk())
    {
      return status;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status RunCheck::CheckSize(const FileProgress& file) const
{
  const std::string path = file.IsWhole ? this->GetPath(file.Name) : this->FindFile(file.Name);
  std::string why;
  const vtkIdType size = GetSize(path, why);
  if (file.IsWhole)
  {
    return size == file.Size
      ? Status()
      : Status::Error(path + ": was complete with " + std::to_string(file.Size) + " bytes and " +
          Describe(size, why) + this->Cure);
  }
  if (size >= file.Size)
  {
    return {}; // the rest is truncated
  }
  return Status::Error(path + " cannot be resumed: " +
    (size < 0 ? why : "it has " + std::to_string(size) + " bytes of " + std::to_string(file.Size)) +
    this->Cure);
}

//------------------------------------------------------------------------------
Status RunCheck::CheckBlocks(
  const RunJournal& journal, vtkIdType bytes, const BlockCallback& onBlock) const
{
  const std::vector<FileBlock>& blocks = journal.GetBlocks();
  Status status;
  for (auto block = blocks.rbegin();
       block != blocks.rend() && bytes > 0 && status.IsOk() && onBlock(); ++block)
  {
    status = this->CheckBlock(*block);
    bytes -= static_cast<vtkIdType>(block->End - block->Begin);
  }
  return status;
}

//------------------------------------------------------------------------------
Status RunCheck::CheckBlock(const FileBlock& block) const
{
  const std::string path = block.IsWhole ? this->GetPath(block.Name) : this->FindFile(block.Name);
  const std::string checksum = ComputeChecksum(path, block.Begin, block.End);
  if (checksum == block.Checksum)
  {
    return {};
  }
  const std::string place =
    "bytes " + std::to_string(block.Begin) + " to " + std::to_string(block.End);
  return Status::Error(path + ": " + place +
    (checksum.empty()
        ? " cannot be read"
        : " do not match their checksum in " + std::string(vtkHeliosRunFiles::GetJournalName())) +
    "; the file was changed or is damaged" + this->Cure);
}

//------------------------------------------------------------------------------
Status RunCheck::CheckSummary(const Json::Value& summary) const
{
  // Legs of a strip share files; the last leg has the final size.
  std::map<std::string, vtkIdType> sizes;
  for (const Json::Value& leg : summary["legs"])
  {
    for (const Json::Value& file : leg["files"])
    {
      sizes[file["name"].asString()] = file["bytes"].asInt64();
    }
  }
  for (const auto& file : sizes)
  {
    std::string why;
    const std::string path = this->GetPath(file.first);
    const vtkIdType size = GetSize(path, why) < 0 ? -1 : this->GetSizeWithPieces(file.first);
    if (size != file.second)
    {
      return Status::Error(path + ": was complete with " + std::to_string(file.second) +
        " bytes and " + Describe(size, why) + this->Cure);
    }
    if (const Status status = CheckPointNamesUnchanged(path); !status.IsOk())
    {
      return Status::Error(status.Message() + this->Cure);
    }
  }
  return {};
}

//------------------------------------------------------------------------------
/// Returns the size of a file with those that belong to it: pieces of an index, waveforms of LAS.
vtkIdType RunCheck::GetSizeWithPieces(const std::string& name) const
{
  std::string why;
  const fs::path path = this->GetPath(name);
  vtkIdType size = GetSize(path.string(), why);
  if (path.extension() == ".las" || path.extension() == ".laz")
  {
    return size + std::max<vtkIdType>(0, GetSize(fs::path(path).replace_extension(".wdp"), why));
  }
  if (path.extension() != ".pvtp" && path.extension() != ".pvtt")
  {
    return size;
  }
  const std::string stem = fs::path(path).replace_extension().string();
  const std::string ending = path.extension() == ".pvtp" ? ".vtp" : ".vtt";
  for (int piece = 0;; ++piece)
  {
    const std::string number = std::to_string(piece);
    const vtkIdType more = GetSize(
      stem + "_" + std::string(number.size() < 4 ? 4 - number.size() : 0, '0') + number + ending,
      why);
    if (more < 0)
    {
      return size;
    }
    size += more;
  }
}

} // namespace helios
