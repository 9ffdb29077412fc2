// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Edited surveys of documents, and as documents to be run or written.

#ifndef heliosEditDocument_h
#define heliosEditDocument_h

#include "heliosStatus.h"
#include "heliosSurveyEdit.h"

class vtkHeliosSurvey;

namespace helios
{

class Messages;

/// Converts a survey to one that can be edited. Returns as text what cannot be edited and is dropped;
/// empty: nothing.
std::string EditSurvey(const SurveyData& survey, SurveyEdit& edit);

/// Reads an edit as the survey of a file into a survey, which reports errors. False after an error.
bool ReadEdit(const SurveyEdit& edit, const std::string& fileName,
  const std::vector<std::string>& assetDirectories, vtkHeliosSurvey* survey);

/// Writes a file that can be run; after an error nothing is written.
Status SaveSurvey(const SurveyEdit& edit, const std::string& fileName,
  const std::vector<std::string>& assetDirectories, Messages& log);

} // namespace helios

#endif
