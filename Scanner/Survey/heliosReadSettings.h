// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The settings of a run, read from the properties of a player or a source.

#ifndef heliosReadSettings_h
#define heliosReadSettings_h

#include "heliosRunSettings.h"

#include <string>

class vtkHeliosSurveyPlayer;
class vtkHeliosSurveySource;

namespace helios
{

/// The output folder of a player that has a survey.
std::string MakeRunFolder(vtkHeliosSurveyPlayer* player);

/// Reads the settings of a player that has a survey; returns an error message, or an empty string.
std::string ReadSettings(vtkHeliosSurveyPlayer* player, RunSettings& settings);

/// The same for a source.
std::string ReadSettings(vtkHeliosSurveySource* source, RunSettings& settings);

} // namespace helios

#endif
