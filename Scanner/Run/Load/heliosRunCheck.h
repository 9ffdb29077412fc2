// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks whether the files of an earlier run are unchanged.

#ifndef heliosRunCheck_h
#define heliosRunCheck_h

#include "heliosRunProgress.h"
#include "heliosStatus.h"

#include <functional>
#include <string>

namespace helios
{

class RunJournal;

class RunCheck
{
public:
  /// Called before every block; false ends the check.
  using BlockCallback = std::function<bool()>;

  /// Sets the folder, and the cure that follows messages; by default, to start the run again.
  explicit RunCheck(const std::string& folder, const std::string& cure = {});

  /// Checks the sizes of all files in a journal.
  Status CheckSizes(const RunJournal& journal) const;

  /// Checks the newest blocks of a journal, up to this many bytes.
  Status CheckBlocks(
    const RunJournal& journal, vtkIdType bytes, const BlockCallback& onBlock) const;

  /// Checks a block against its checksum.
  Status CheckBlock(const FileBlock& block) const;

  /// Returns the path of a file, with its final name or not.
  std::string FindFile(const std::string& name) const;

  /// Checks the sizes of the files of a finished run against its summary.
  Status CheckSummary(const Json::Value& summary) const;

private:
  Status CheckSize(const FileProgress& file) const;
  std::string GetPath(const std::string& name) const;
  vtkIdType GetSizeWithPieces(const std::string& name) const;

  std::string Folder;
  std::string Cure;
};

} // namespace helios

#endif
