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
 * The text up to the last slash is the folder, the rest is the expression. Matching time is linear
 * in the length of a name: lookahead and back references are not supported. Bytes are compared; a
 * name need not be UTF-8.
 */
class VTKHELIOSSCANNERSURVEY_EXPORT FilePattern
{
public:
  static constexpr std::size_t LongestExpression = 1000;
  static constexpr std::size_t MaximumFilesInFolder = 1000000;

  explicit FilePattern(const std::string& text);
  ~FilePattern();

  /// Returns the error in the expression, and the fix; empty: none.
  const std::string& GetFault() const { return this->Fault; }

  /// Returns the folder with a trailing slash; empty: not given.
  const std::string& GetFolder() const { return this->Folder; }

  /**
   * Adds the files of a folder whose whole names match, in alphabetical order. Returns false, and
   * adds nothing, if the folder has more than `most` entries.
   */
  bool FindFiles(const std::string& folder, std::vector<std::string>& files,
    std::size_t maximum = MaximumFilesInFolder) const;

private:
  struct Engine;

  std::string Folder;
  std::string Fault;
  std::unique_ptr<Engine> Expression;
};

} // namespace helios

#endif
