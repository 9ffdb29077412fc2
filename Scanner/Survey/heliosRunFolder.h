// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The folder that a run writes to, and what earlier runs left in it.

#ifndef heliosRunFolder_h
#define heliosRunFolder_h

#include <json/value.h>

#include <filesystem>
#include <string>
#include <vector>

namespace helios
{

class RunJournal;

class RunFolder
{
public:
  explicit RunFolder(const std::string& path);

  ///@{
  /// Each says in words what is wrong, or returns an empty text.

  /// Makes the folder; what an earlier run left there needs to be replaced, or gone on with.
  std::string Prepare(bool overwrite, bool resume) const;

  /// Removes what earlier runs left.
  std::string Clear() const;

  /// Reads the summary of a run that is finished.
  std::string ReadSummary(Json::Value& summary) const;

  std::string WriteSummary(const Json::Value& summary) const;
  ///@}

  /// Whether no run has left anything here.
  bool IsEmpty() const;

  bool HasSummary() const;
  bool Exists() const;

  static const char* GetSummaryName() { return "run_summary.json"; }

private:
  std::string Make() const;
  std::string CheckEarlierRun(bool overwrite, bool resume) const;
  std::vector<std::filesystem::path> FindFiles() const;

  std::filesystem::path Path;
};

} // namespace helios

#endif
