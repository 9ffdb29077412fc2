// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Edited surveys as documents, to be run or written.

#ifndef heliosSurveyXml_h
#define heliosSurveyXml_h

#include "heliosStatus.h"
#include "heliosSurveyEdit.h"

class vtkHeliosSurvey;

namespace helios
{

class Messages;

/// Reads an edit as the survey of a file into a survey, which reports errors. False after an error.
VTKHELIOSSCANNERSURVEY_EXPORT bool ReadEdit(const SurveyEdit& edit, const std::string& fileName,
  const std::vector<std::string>& assetDirectories, vtkHeliosSurvey* survey);

/// Writes a file that can be run; after an error nothing is written.
VTKHELIOSSCANNERSURVEY_EXPORT Status SaveSurvey(const SurveyEdit& edit, const std::string& fileName,
  const std::vector<std::string>& assetDirectories, Messages& log);

} // namespace helios

#endif
