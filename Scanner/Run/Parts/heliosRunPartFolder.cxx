// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunPartFolder.h"

#include "heliosLegPlan.h"
#include "heliosRunCheck.h"
#include "heliosRunFolder.h"
#include "heliosRunJournal.h"
#include "vtkHeliosRunFiles.h"

#include <filesystem>
#include <numeric>
#include <utility>

namespace helios
{

namespace
{

/// Returns the counts of a block, given those up to it.
ScanCounts Subtract(const ScanCounts& after, const ScanCounts& before)
{
  ScanCounts counts;
  for (const CountName& count : CountNames)
  {
    counts.*count.Count = after.*count.Count - before.*count.Count;
  }
  counts.LargestAmplitude = after.LargestAmplitude;
  return counts;
}

/// Reads the part that a fingerprint belongs to; none: a whole run.
RunPart ReadPart(const Json::Value& fingerprint)
{
  RunPart part;
  const Json::Value& value = fingerprint["part"];
  if (value.isObject() && value["number"].isInt() && value["count"].isInt())
  {
    part.Number = value["number"].asInt();
    part.Count = value["count"].asInt();
  }
  return part.Number >= 1 && part.Number <= part.Count ? part : RunPart();
}

} // namespace

//------------------------------------------------------------------------------
RunPartFolder::RunPartFolder(const std::string& path)
  : Path(path)
{
}

//------------------------------------------------------------------------------
std::string RunPartFolder::Describe() const
{
  return this->Path + ": part " + this->Part.GetText();
}

//------------------------------------------------------------------------------
std::string RunPartFolder::GetCure(const char* option) const
{
  return std::string("; run it with --part ") + this->Part.GetText() + " " + option;
}

//------------------------------------------------------------------------------
Status RunPartFolder::Read()
{
  RunJournal journal(this->Path);
  if (!journal.Exists())
  {
    return Status::Error(this->Path + " is no part of a run: it has no " +
      vtkHeliosRunFiles::GetJournalName() + "; give folders that were run with --part");
  }
  journal.RememberLines();
  if (const Status status = journal.Read(); !status.IsOk())
  {
    return Status::Error(status.Message() + "; run this part again with --overwrite");
  }
  this->Fingerprint = journal.GetFingerprint();
  this->Part = ReadPart(this->Fingerprint);
  if (!this->Part.IsSet())
  {
    return Status::Error(this->Path + " is no part of a run: its " +
      vtkHeliosRunFiles::GetJournalName() +
      " is that of a whole run; give folders that were run with --part");
  }
  for (const auto& [leg, progress] : journal.GetLines())
  {
    this->AddBlock(leg, progress);
  }
  return this->CheckSummary();
}

//------------------------------------------------------------------------------
/// Checks that the summary of a finished part, which is not needed, states the same as its journal.
Status RunPartFolder::CheckSummary() const
{
  const RunFolder folder(this->Path);
  Json::Value summary;
  Status status = folder.HasSummary() ? folder.ReadSummary(summary) : Status();
  if (status.IsOk() && folder.HasSummary())
  {
    for (const std::string& name : this->Fingerprint.getMemberNames())
    {
      if (status.IsOk() && ToLine(summary[name]) != ToLine(this->Fingerprint[name]))
      {
        status = Status::Error(
          (std::filesystem::path(this->Path) / vtkHeliosRunFiles::GetSummaryName()).string() +
          ": \"" + name + "\" is not that of " + vtkHeliosRunFiles::GetJournalName());
      }
    }
  }
  return status.IsOk() ? status : Status::Error(status.Message() + this->GetCure("--overwrite"));
}

//------------------------------------------------------------------------------
/// Adds a line of the journal.
void RunPartFolder::AddBlock(std::size_t leg, const LegProgress& progress)
{
  if (progress.IsDone)
  {
    return; // a line at the end of a leg
  }
  this->Seconds[leg] = progress.Seconds;
  RunPartBlock block{ leg, progress.Files, Subtract(progress.Counts, this->Counts) };
  this->Counts = progress.Counts;
  for (FileProgress& file : block.Files)
  {
    const vtkIdType records = file.Records;
    file.Records -= std::exchange(this->Records[file.Name], records);
  }
  this->Blocks.push_back(std::move(block));
}

//------------------------------------------------------------------------------
Status RunPartFolder::Check(const std::vector<LegPlan>& plans) const
{
  const std::vector<LegPlan> legs = SelectPart(plans, this->Part);
  const auto expected = static_cast<std::size_t>(CountBlocks(legs));
  RunJournal journal(this->Path);
  const bool isWhole = this->Blocks.size() == expected && journal.Read().IsOk() &&
    (legs.empty() || journal.GetLeg(legs.back().Leg).IsDone);
  if (!isWhole)
  {
    return Status::Error(this->Describe() + " is not finished: it has " +
      std::to_string(this->Blocks.size()) + " of " + std::to_string(expected) + " blocks" +
      this->GetCure("--resume"));
  }
  return RunCheck(this->Path, this->GetCure("--overwrite")).CheckSizes(journal);
}

//------------------------------------------------------------------------------
Status RunPartFolder::CheckBlock(const FileBlock& block) const
{
  return RunCheck(this->Path, this->GetCure("--overwrite")).CheckBlock(block);
}

//------------------------------------------------------------------------------
double RunPartFolder::GetSeconds() const
{
  return std::accumulate(this->Seconds.begin(), this->Seconds.end(), 0.0,
    [](double sum, const auto& leg) { return sum + leg.second; });
}

//------------------------------------------------------------------------------
std::string RunPartFolder::FindFile(const std::string& name) const
{
  return RunCheck(this->Path).FindFile(name);
}

} // namespace helios
