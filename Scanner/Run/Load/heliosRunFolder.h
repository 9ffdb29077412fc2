// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The output folder of a run, with the files of earlier runs.

#ifndef heliosRunFolder_h
#define heliosRunFolder_h

#include "heliosStatus.h"

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

  /// Makes the folder; files of an earlier run there must be replaced or continued.
  Status Prepare(bool overwrite, bool resume) const;

  /// Removes the files of earlier runs.
  Status Clear() const;

  /// Reads the summary of a finished run.
  Status ReadSummary(Json::Value& summary) const;

  Status WriteSummary(const Json::Value& summary) const;

  /// Returns whether the folder has no files of a run.
  bool IsEmpty() const;

  bool HasSummary() const;
  bool Exists() const;

private:
  Status Make() const;
  Status CheckEarlierRun(bool overwrite, bool resume) const;
  std::vector<std::filesystem::path> FindFiles() const;

  std::filesystem::path Path;
};

} // namespace helios

#endif
