// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Sets up a scanner from its data and the options of a run.

#ifndef heliosReceiver_h
#define heliosReceiver_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <string>
#include <vector>

class vtkHeliosScanner;

namespace helios
{

struct ScannerData;

/// The options of a run that override its survey; 0 and empty: as in the survey.
struct ReceiverChoice
{
  bool Noise = true;
  double RangeTolerance = 0.0;  ///< [m]
  double EnergyTolerance = 0.0; ///< relative
  int NumberOfSubRays = 0;      ///< fixed
  std::string EchoDetector;     ///< its name
};

/// The valid names for ReceiverChoice and echoDetector="...".
std::vector<std::string> GetEchoDetectorNames();

/// Sets up pulse, radiometry, sampling, waveforms, detection, noise and errors; a choice overrides
/// the data.
VTKHELIOSSCANNERSURVEY_EXPORT void SetUpReceiver(
  const ScannerData& data, const ReceiverChoice& choice, vtkHeliosScanner* scanner);

} // namespace helios

#endif
