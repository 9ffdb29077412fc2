// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Surveys that were made by hand become XML, and what that comes to.

#ifndef heliosSurveyXml_h
#define heliosSurveyXml_h

#include "heliosSurveyEdit.h"

namespace helios
{

/// The survey as a file.
VTKHELIOSSCANNERSURVEY_EXPORT std::string MakeSurveyText(const SurveyEdit& edit);

/// What a reader would read from a file of that text. Complete only if log has no error then.
VTKHELIOSSCANNERSURVEY_EXPORT SurveyData ReadSurveyText(const std::string& fileName,
  const std::string& text, const std::vector<std::string>& assetDirectories, Messages& log);

/// Writes a file that can be run; says what is wrong, and writes nothing then. Empty: written.
VTKHELIOSSCANNERSURVEY_EXPORT std::string SaveSurvey(const SurveyEdit& edit,
  const std::string& fileName, const std::vector<std::string>& assetDirectories, Messages& log);

/**
 * How a file in a folder refers to another: by its name in one of the asset directories, by the way
 * from the folder where it is below that, or else by its whole path.
 */
VTKHELIOSSCANNERSURVEY_EXPORT std::string ReferTo(const std::string& path,
  const std::string& folder, const std::vector<std::string>& assetDirectories);

} // namespace helios

#endif
