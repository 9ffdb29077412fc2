// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How a survey is run.

#ifndef heliosRunSettings_h
#define heliosRunSettings_h

#include "heliosLegScanner.h"

#include <vtkType.h>

#include <string>

class vtkHeliosSurveyPlayer;

namespace helios
{

struct RunSettings
{
  std::string Folder; ///< of the files
  std::string Format; ///< xyz, vtp
  ScanOptions Scan;
  vtkIdType PulsesPerBlock = 262144;
};

/// Takes the settings of a player that has a survey; says in words what is wrong with them, or returns
/// an empty text.
std::string TakeSettings(vtkHeliosSurveyPlayer* player, RunSettings& settings);

} // namespace helios

#endif
