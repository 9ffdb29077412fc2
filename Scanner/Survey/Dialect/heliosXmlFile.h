// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Checks a whole XML file and its contents.

#ifndef heliosXmlFile_h
#define heliosXmlFile_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <string>
#include <vector>

namespace helios
{

class Messages;

/// Checks the surveys and planners of a file as they are read, and all scenes, scanners, platforms
/// and templates in it, used or not.
void CheckFile(
  const std::string& fileName, const std::vector<std::string>& assetDirectories, Messages& log);

/// Returns whether a file has a survey; false if it cannot be read.
VTKHELIOSSCANNERSURVEY_EXPORT bool HasSurvey(const std::string& fileName);

} // namespace helios

#endif
