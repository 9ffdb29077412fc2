// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// How a survey is run.

#ifndef heliosRunSettings_h
#define heliosRunSettings_h

#include "heliosReceiver.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <string>
#include <vector>

class vtkHeliosRayCaster;
class vtkHeliosSurveyPlayer;
class vtkHeliosSurveySource;
class vtkImageData;

namespace helios
{

struct RunSettings
{
  std::string Folder; ///< of the files
  int Play = -1;      ///< negative: the survey has only one
  std::string Format; ///< xyz, las, vtp
  vtkIdType Seed = 0;
  ReceiverChoice Receiver;
  bool Waveforms = false;
  bool Pulses = false;
  bool SubRays = false; ///< their hits; not written
  bool Truth = false;   ///< with the echoes; not written
  bool SplitByChannel = false;
  vtkIdType PulsesPerBlock = 262144;
  vtkSmartPointer<vtkHeliosRayCaster> RayCaster;    ///< null: the scanner's default
  std::vector<vtkSmartPointer<vtkImageData>> Grids; ///< turbid voxels of the scene
};

/// The output folder of a player that has a survey.
std::string MakeRunFolder(vtkHeliosSurveyPlayer* player);

/// Gets the settings of a player that has a survey; returns an error message, or an empty string.
std::string TakeSettings(vtkHeliosSurveyPlayer* player, RunSettings& settings);

/// The same for a source.
std::string TakeSettings(vtkHeliosSurveySource* source, RunSettings& settings);

} // namespace helios

#endif
