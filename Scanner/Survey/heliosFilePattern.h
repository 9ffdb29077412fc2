// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A folder and a regular expression for the names of the files in it.

#ifndef heliosFilePattern_h
#define heliosFilePattern_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace helios
{

/**
 * The text up to the last slash is the folder, what follows is the expression. Matching takes time
 * linear in the length of a name, whatever the expression: it has no lookahead and no back
 * references. Bytes are compared, so that a name need not be UTF-8.
 */
class VTKHELIOSSCANNERSURVEY_EXPORT FilePattern
{
public:
  static constexpr std::size_t LongestExpression = 1000;
  static constexpr std::size_t MostFilesInFolder = 1000000;

  explicit FilePattern(const std::string& text);
  ~FilePattern();

  /// What is wrong with the expression, and the cure; empty: nothing.
  const std::string& GetFault() const { return this->Fault; }

  /// With a slash at its end; empty: none is named.
  const std::string& GetFolder() const { return this->Folder; }

  /**
   * Adds the files of a folder whose whole names match, in alphabetical order. False where the folder
   * has more than `most` entries; nothing is added then.
   */
  bool FindFiles(const std::string& folder, std::vector<std::string>& files,
    std::size_t most = MostFilesInFolder) const;

private:
  struct Engine;

  std::string Folder;
  std::string Fault;
  std::unique_ptr<Engine> Expression;
};

} // namespace helios

#endif
