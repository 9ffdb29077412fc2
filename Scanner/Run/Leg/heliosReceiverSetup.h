// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// Sets up a scanner from its data and the options of a run.

#ifndef heliosReceiverSetup_h
#define heliosReceiverSetup_h

#include "vtkHeliosScannerRunModule.h" // For export macro

#include <string>

class vtkHeliosScanner;

namespace helios
{

struct EchoMatching;
struct ReceiverData;
struct RunOptions;
struct ScannerData;

/// How the beams of a scanner are sampled; options override the data.
struct BeamSampling
{
  bool IsAdaptive;
  double RangeTolerance;  ///< [m]
  double EnergyTolerance; ///< relative
};
BeamSampling ChooseSampling(const ReceiverData& receiver, const RunOptions& options);

/// Returns the name of the echo detector of a scanner, or of the options.
const std::string& ChooseDetector(const ReceiverData& receiver, const RunOptions& options);

/// Whether ranges have noise at every range, which Accuracy "instrument" of the options needs.
bool HasRangeNoise(const ReceiverData& receiver);

/// Sets up pulse, radiometry, sampling, waveforms, detection, noise and errors; options override
/// the data.
VTKHELIOSSCANNERRUN_EXPORT void SetUpReceiver(
  const ScannerData& data, const RunOptions& options, vtkHeliosScanner* scanner);

/// Which echoes of a receiver are compared: of 2 % of a full footprint (of reflectance 0.5) and the
/// energy tolerance, and of twice the detection threshold.
EchoMatching MakeMatching(const ReceiverData& receiver, double energyTolerance);

} // namespace helios

#endif
