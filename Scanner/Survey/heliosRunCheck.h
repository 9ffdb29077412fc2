// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Whether the files of an earlier run are those that were written.

#ifndef heliosRunCheck_h
#define heliosRunCheck_h

#include "heliosRunProgress.h"

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

  explicit RunCheck(const std::string& folder);

  ///@{
  /// Each says in words what is wrong, or returns an empty text.

  /// The sizes of all files that a journal names.
  std::string CheckSizes(const RunJournal& journal) const;

  /// The newest blocks of a journal, as many as have these bytes.
  std::string CheckBlocks(
    const RunJournal& journal, vtkIdType bytes, const BlockCallback& onBlock) const;

  /// The sizes of the files of a run that is finished, by its summary.
  std::string CheckSummary(const Json::Value& summary) const;
  ///@}

private:
  std::string CheckSize(const FileProgress& file) const;
  std::string CheckBlock(const FileBlock& block) const;
  std::string FindFile(const std::string& name) const;
  std::string GetPath(const std::string& name) const;
  vtkIdType GetSizeWithPieces(const std::string& name) const;

  std::string Folder;
};

} // namespace helios

#endif
