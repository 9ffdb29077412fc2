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

} // namespace helios

#endif
