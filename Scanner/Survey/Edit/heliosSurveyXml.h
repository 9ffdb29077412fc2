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

} // namespace helios

#endif
