// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A scanner set up as its data say, and as a run wants it.

#ifndef heliosReceiver_h
#define heliosReceiver_h

#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <string>
#include <vector>

class vtkHeliosScanner;

namespace helios
{

struct ScannerData;

/// What a run wants otherwise than its survey; 0 and empty: as the survey has it.
struct ReceiverChoice
{
  bool Noise = true;
  double RangeTolerance = 0.0;  ///< [m]
  double EnergyTolerance = 0.0; ///< relative
  int NumberOfSubRays = 0;      ///< always so many
  std::string EchoDetector;     ///< its name
};

/// What ReceiverChoice and echoDetector="..." may name.
std::vector<std::string> GetEchoDetectorNames();

/// Pulse, radiometry, sampling, waveforms, detection, noise and errors; a choice wins over the data.
VTKHELIOSSCANNERSURVEY_EXPORT void SetUpReceiver(
  const ScannerData& data, const ReceiverChoice& choice, vtkHeliosScanner* scanner);

} // namespace helios

#endif
