// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes edited surveys as XML, and reads that back.

#ifndef heliosSurveyXml_h
#define heliosSurveyXml_h

#include "heliosStatus.h"
#include "heliosSurveyEdit.h"

namespace helios
{

/// The survey as a file.
VTKHELIOSSCANNERSURVEY_EXPORT std::string MakeSurveyText(const SurveyEdit& edit);

/// The survey read from a file with that text. Complete only if log has no error then.
VTKHELIOSSCANNERSURVEY_EXPORT SurveyData ReadSurveyText(const std::string& fileName,
  const std::string& text, const std::vector<std::string>& assetDirectories, Messages& log);

/// Writes a file that can be run; after an error nothing is written.
VTKHELIOSSCANNERSURVEY_EXPORT Status SaveSurvey(const SurveyEdit& edit, const std::string& fileName,
  const std::vector<std::string>& assetDirectories, Messages& log);

/**
 * How a file in a folder refers to another: by its name in one of the asset directories, by the
 * relative path if it is below the folder, else by its absolute path.
 */
VTKHELIOSSCANNERSURVEY_EXPORT std::string ReferTo(const std::string& path,
  const std::string& folder, const std::vector<std::string>& assetDirectories);

} // namespace helios

#endif
