// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunFolder.h"

#include "heliosPartFile.h"
#include "heliosRunJournal.h"
#include "heliosRunSummary.h"
#include "heliosStatus.h"
#include "vtkHeliosRunFiles.h"

#include <fstream>
#include <iterator>

namespace helios
{
namespace fs = std::filesystem;

//------------------------------------------------------------------------------
RunFolder::RunFolder(const std::string& path)
  : Path(path)
{
}

//------------------------------------------------------------------------------
bool RunFolder::Exists() const
{
  std::error_code ignored;
  return fs::is_directory(this->Path, ignored);
}

//------------------------------------------------------------------------------
bool RunFolder::IsEmpty() const
{
  return !RunJournal(this->Path.string()).Exists() && !this->HasSummary() &&
    this->FindFiles().empty();
}

//------------------------------------------------------------------------------
bool RunFolder::HasSummary() const
{
  std::error_code ignored;
  return fs::exists(this->Path / vtkHeliosRunFiles::GetSummaryName(), ignored);
}

//------------------------------------------------------------------------------
Status RunFolder::Prepare(bool overwrite, bool resume) const
{
  if (overwrite && resume)
  {
    return Status::Error(
      "Resume and Overwrite are both on (--resume, --overwrite), but Overwrite removes the "
      "run that Resume continues; set one of them");
  }
  const Status status = this->Make();
  return status.IsOk() ? this->CheckEarlierRun(overwrite, resume) : status;
}

//------------------------------------------------------------------------------
Status RunFolder::Make() const
{
  std::error_code problem;
  fs::create_directories(this->Path, problem);
  return problem || !this->Exists()
    ? Status::Error(this->Path.string() + ": the output folder cannot be created: " +
        (problem ? problem.message() : "a file has this name") + "; give another OutputDirectory")
    : Status();
}

//------------------------------------------------------------------------------
Status RunFolder::CheckEarlierRun(bool overwrite, bool resume) const
{
  const std::string folder = this->Path.string();
  const bool isUnfinished = RunJournal(folder).Exists();
  const bool hasFiles = !this->IsEmpty();
  if (resume)
  {
    if (isUnfinished || this->HasSummary())
    {
      return {};
    }
    return hasFiles
      ? Status::Error(folder + ": has no " + vtkHeliosRunFiles::GetJournalName() +
          ", so its contents cannot be resumed; set Overwrite (--overwrite) to replace it, or "
          "give another OutputDirectory")
      : Status::Error(folder + ": has no " + vtkHeliosRunFiles::GetJournalName() +
          ", so there is nothing to resume; run it without Resume (--resume)");
  }
  if (overwrite || !hasFiles)
  {
    return {};
  }
  return Status::Error(folder + ": holds the files of an earlier run, which are kept; " +
    (isUnfinished ? "the run is not finished: set Resume (--resume) to continue it, " : "") +
    "set Overwrite (--overwrite) to replace them, or give another OutputDirectory");
}

//------------------------------------------------------------------------------
std::vector<fs::path> RunFolder::FindFiles() const
{
  std::vector<fs::path> files;
  std::error_code ignored;
  fs::directory_iterator entry(this->Path, ignored);
  for (; entry != fs::directory_iterator(); entry.increment(ignored))
  {
    if (vtkHeliosRunFiles::IsOfLeg(entry->path().filename().string()))
    {
      files.push_back(entry->path());
    }
  }
  return files;
}

//------------------------------------------------------------------------------
Status RunFolder::Clear() const
{
  const fs::path journal = RunJournal(this->Path.string()).GetPath();
  LogFile lock;
  if (fs::exists(journal) && !lock.Open(journal.string()))
  {
    return Status::Error(
      lock.GetProblem() + "; wait for it to end, or give another OutputDirectory");
  }
  // Summary and journal, which state that files are complete, are removed before the files.
  std::vector<fs::path> files = { this->Path / vtkHeliosRunFiles::GetSummaryName(), journal };
  const std::vector<fs::path> found = this->FindFiles();
  files.insert(files.end(), found.begin(), found.end());
  for (const fs::path& file : files)
  {
    std::error_code problem;
    fs::remove_all(file, problem);
    if (problem)
    {
      return Status::Error(file.string() + ": cannot be replaced: " + problem.message() +
        "; give another OutputDirectory");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
Status RunFolder::ReadSummary(Json::Value& summary) const
{
  const fs::path path = this->Path / vtkHeliosRunFiles::GetSummaryName();
  std::ifstream file(path, std::ios::binary);
  const std::string text{ std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
  if (!FromText(text, summary))
  {
    return Status::Error(path.string() + " is damaged");
  }
  if (!summary["checksum"].isString())
  {
    return Status::Error(path.string() +
      " has no checksum: it was changed, or written by an earlier version of vtkHelios");
  }
  if (summary["checksum"].asString() != ComputeChecksum(summary))
  {
    return Status::Error(path.string() + " is damaged: it does not match its checksum");
  }
  ConvertToCurrent(summary);
  return {};
}

//------------------------------------------------------------------------------
Status RunFolder::WriteSummary(const Json::Value& summary) const
{
  return WriteWhole((this->Path / vtkHeliosRunFiles::GetSummaryName()).string(), ToText(summary));
}

} // namespace helios
