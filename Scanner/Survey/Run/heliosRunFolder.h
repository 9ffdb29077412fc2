// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The output folder of a run, with the files of earlier runs.

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
  /// Each returns an error message, or an empty string.

  /// Makes the folder; files of an earlier run there must be replaced or continued.
  std::string Prepare(bool overwrite, bool resume) const;

  /// Removes the files of earlier runs.
  std::string Clear() const;

  /// Reads the summary of a finished run.
  std::string ReadSummary(Json::Value& summary) const;

  std::string WriteSummary(const Json::Value& summary) const;
  ///@}

  /// Whether the folder has no files of a run.
  bool IsEmpty() const;

  bool HasSummary() const;
  bool Exists() const;

private:
  std::string Make() const;
  std::string CheckEarlierRun(bool overwrite, bool resume) const;
  std::vector<std::filesystem::path> FindFiles() const;

  std::filesystem::path Path;
};

} // namespace helios

#endif
