// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Kinds of whole files, and checks of their contents.

#ifndef heliosXmlFile_h
#define heliosXmlFile_h

#include <string>
#include <vector>

namespace helios
{

class Messages;

/// Checks the surveys and planners of a file as they are read, and all scenes, scanners, platforms
/// and templates in it, used or not.
void CheckFile(
  const std::string& fileName, const std::vector<std::string>& assetDirectories, Messages& log);

/// Returns whether the ending of a file belongs to a document, XML or YAML.
bool IsDocument(const std::string& fileName);

/// Returns whether a file has a survey, or cannot be read.
bool MayHaveSurvey(const std::string& fileName);

} // namespace helios

#endif
