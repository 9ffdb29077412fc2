// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunJournal.h"

#include "heliosPartFile.h"
#include "heliosStatus.h"
#include "vtkHeliosRunFiles.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace helios
{

namespace
{

constexpr const char* SealBegin = ",\"check\":\"";
constexpr const char* SealEnd = "\"}";

} // namespace

//------------------------------------------------------------------------------
void ConvertToCurrent(Json::Value& summary)
{
  if (!summary.isObject() || !summary["versions"].isObject() || !summary["options"].isObject() ||
    summary["versions"].isMember("summary"))
  {
    return;
  }
  summary["versions"]["summary"] = SummaryVersion;
  Json::Value epoch;
  if (summary["options"].removeMember("play", &epoch))
  {
    summary["options"]["epoch"] = epoch;
  }
}

//------------------------------------------------------------------------------
RunJournal::RunJournal(const std::string& folder)
  : Path((std::filesystem::path(folder) / vtkHeliosRunFiles::GetJournalName()).string())
{
}

//------------------------------------------------------------------------------
bool RunJournal::Exists() const
{
  std::error_code ignored;
  return std::filesystem::is_regular_file(this->Path, ignored);
}

//------------------------------------------------------------------------------
Status RunJournal::Create(const Json::Value& fingerprint)
{
  this->Forget();
  this->Fingerprint = fingerprint;
  const Status status = WriteWhole(this->Path, this->Seal(fingerprint));
  return status.IsOk() && !this->File.Open(this->Path) ? Status::Error(this->File.GetProblem())
                                                       : status;
}

//------------------------------------------------------------------------------
void RunJournal::Forget()
{
  this->Legs.clear();
  this->Files.clear();
  this->Blocks.clear();
  this->Lines.clear();
  this->Counts = ScanCounts();
  this->Leg = 0;
  this->LastSeal.clear();
  this->Size = 0;
  this->Fingerprint = Json::nullValue;
}

//------------------------------------------------------------------------------
Status RunJournal::Read()
{
  this->Forget();
  if (this->IsWithoutChecksums())
  {
    return Status::Error(this->Path +
      " was written by an earlier version of vtkHelios: it has no checksums, so its contents "
      "cannot be verified");
  }
  std::ifstream file(this->Path, std::ios::binary);
  bool isBroken = false;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line) && !file.eof();)
  {
    if (isBroken)
    {
      return Status::Error(this->Path + " has a damaged line (line " + std::to_string(number) +
        ", which is not the last one)");
    }
    ++number;
    std::string body;
    isBroken = !this->Unseal(line, body);
    if (isBroken)
    {
      continue; // a crash may leave the last line incomplete
    }
    const Status status = this->ReadLine(body);
    if (!status.IsOk())
    {
      return Status::Error(
        this->Path + ", line " + std::to_string(number) + ": " + status.Message());
    }
    this->Size += line.size() + 1;
  }
  return this->Fingerprint.isObject()
    ? Status()
    : Status::Error(this->Path + " does not state which run it belongs to");
}

//------------------------------------------------------------------------------
/// Returns whether the journal has no checksums; journals of earlier versions are JSON lines, too.
bool RunJournal::IsWithoutChecksums() const
{
  std::ifstream file(this->Path, std::ios::binary);
  std::string line;
  Json::Value value;
  return std::getline(file, line) && FromText(line, value) && value.isMember("versions") &&
    !value.isMember("check");
}

//------------------------------------------------------------------------------
/// Returns a value as a line with the checksum of all lines up to it.
std::string RunJournal::Seal(const Json::Value& value)
{
  std::string body = ToLine(value);
  Checksum sum;
  sum.Add(this->LastSeal + body);
  this->LastSeal = sum.Finish();
  body.pop_back();
  return body + SealBegin + this->LastSeal + SealEnd + "\n";
}

//------------------------------------------------------------------------------
/// Removes the checksum of a line; false if it does not match.
bool RunJournal::Unseal(const std::string& line, std::string& body)
{
  const std::size_t length = std::strlen(SealBegin) + ChecksumDigits + std::strlen(SealEnd);
  if (line.size() <= length)
  {
    return false;
  }
  body = line.substr(0, line.size() - length) + "}";
  Checksum sum;
  sum.Add(this->LastSeal + body);
  const std::string seal = sum.Finish();
  if (line.substr(line.size() - length) != SealBegin + seal + SealEnd)
  {
    return false;
  }
  this->LastSeal = seal;
  return true;
}

//------------------------------------------------------------------------------
/// Adds a line with a valid checksum.
Status RunJournal::ReadLine(const std::string& body)
{
  Json::Value value;
  if (!FromText(body, value))
  {
    return Status::Error("it is not JSON");
  }
  if (!this->Fingerprint.isObject())
  {
    this->Fingerprint = value;
    ConvertToCurrent(this->Fingerprint);
    return {};
  }
  try
  {
    const auto leg = static_cast<std::size_t>(GetCount(value, "leg"));
    const LegProgress progress = ProgressFromJson(value);
    const Status status = this->CheckFollows(leg, progress);
    if (status.IsOk())
    {
      this->Accept(leg, progress);
    }
    return status;
  }
  catch (const BadJson& problem)
  {
    return Status::Error(problem.what());
  }
}

//------------------------------------------------------------------------------
/// Checks whether progress can follow the lines that were read.
Status RunJournal::CheckFollows(std::size_t leg, const LegProgress& progress) const
{
  const LegProgress& before = this->GetLeg(leg);
  const bool isNext =
    leg == this->Leg || (leg > this->Leg && this->GetLeg(this->Leg).IsDone) || this->Legs.empty();
  if (!isNext || !Follows(before, progress))
  {
    return Status::Error("\"leg\" " + std::to_string(leg) + " with \"blocks\" " +
      std::to_string(progress.Blocks) +
      (progress.Pieces > 0 ? " and \"pieces\" " + std::to_string(progress.Pieces) : "") +
      " does not follow from the lines before");
  }
  if (!HasGrown(this->Counts, progress.Counts))
  {
    return Status::Error("a number of \"counts\" is smaller than in the line before");
  }
  for (const FileProgress& file : progress.Files)
  {
    const FileProgress* last = this->FindFile(file.Name);
    if (last && !HasGrown(*last, file))
    {
      return Status::Error("a number of " + file.Name + " is smaller than in a line before");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void RunJournal::Accept(std::size_t leg, const LegProgress& progress)
{
  if (this->RemembersLines)
  {
    this->Lines.emplace_back(leg, progress);
  }
  LegProgress& taken = this->Legs[leg];
  taken = progress;
  this->Leg = leg;
  this->Counts = progress.Counts;
  for (FileProgress& file : taken.Files)
  {
    if (IsRewritten(file))
    {
      const auto isOfFile = [&file](const FileBlock& block) { return block.Name == file.Name; };
      this->Blocks.erase(
        std::remove_if(this->Blocks.begin(), this->Blocks.end(), isOfFile), this->Blocks.end());
    }
    this->Blocks.insert(this->Blocks.end(), file.Blocks.begin(), file.Blocks.end());
    file.Blocks.clear(); // they belong to this line
    this->Files[file.Name] = file;
  }
}

//------------------------------------------------------------------------------
const FileProgress* RunJournal::FindFile(const std::string& name) const
{
  const auto found = this->Files.find(name);
  return found != this->Files.end() ? &found->second : nullptr;
}

//------------------------------------------------------------------------------
Status RunJournal::Check()
{
  return this->File.Check() ? Status() : Status::Error(this->File.GetProblem());
}

//------------------------------------------------------------------------------
Status RunJournal::Continue()
{
  if (!this->File.Open(this->Path))
  {
    return Status::Error(this->File.GetProblem());
  }
  const Status status = this->Read(); // again, now with exclusive access
  return status.IsOk() && !this->File.Cut(this->Size) ? Status::Error(this->File.GetProblem())
                                                      : status;
}

//------------------------------------------------------------------------------
Status RunJournal::Append(std::size_t leg, const LegProgress& progress)
{
  this->Accept(leg, progress);
  Json::Value line = ToJson(progress);
  line["leg"] = Json::UInt(leg);
  return this->File.Append(this->Seal(line)) ? Status() : Status::Error(this->File.GetProblem());
}

//------------------------------------------------------------------------------
const LegProgress& RunJournal::GetLeg(std::size_t leg) const
{
  static const LegProgress none;
  const auto found = this->Legs.find(leg);
  return found != this->Legs.end() ? found->second : none;
}

//------------------------------------------------------------------------------
void RunJournal::Remove()
{
  this->File.Close();
  RemoveFile(this->Path);
}

} // namespace helios
