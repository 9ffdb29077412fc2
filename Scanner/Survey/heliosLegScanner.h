// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The scanner of a leg: a vtkHeliosScanner for every channel, all firing at once.

#ifndef heliosLegScanner_h
#define heliosLegScanner_h

#include "heliosLegPlan.h"
#include "heliosReceiver.h"
#include "heliosSpectrum.h"
#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataObject;
class vtkHeliosRayCaster;
class vtkHeliosScanner;
class vtkPolyData;

namespace helios
{

class Messages;
struct RunCounts;

/// What the scanners of all legs have in common.
struct ScanOptions
{
  vtkIdType Seed = 0;
  ReceiverChoice Receiver;
  bool Waveforms = false;
  bool Pulses = false;
  vtkSmartPointer<vtkHeliosRayCaster> RayCaster; ///< null: the scanner's default
};

class VTKHELIOSSCANNERSURVEY_EXPORT LegScanner
{
public:
  LegScanner(
    const SurveyData& survey, vtkPolyData* scene, const ScanOptions& options, Messages& log);
  ~LegScanner();

  /// Makes the scanner that of a leg.
  void SetUp(const LegPlan& plan);

  std::size_t GetNumberOfChannels() const { return this->Channels.size(); }

  /// Limits what is computed to the times [first, last) [s]; SetUp() lifts that.
  void SetTimeWindow(double first, double last);

  /// The pulses of all channels in the window.
  vtkIdType CountPulses();

  /// Runs a piece of the leg; false after an error.
  bool Update(int piece, int pieces);

  /// The port of all channels together, in the order of pulses; the port of one of them.
  vtkSmartPointer<vtkDataObject> GetOutput(int port) const;
  vtkDataObject* GetOutput(int port, std::size_t channel) const;

  /// Forgets the output of the last piece.
  void ReleaseOutput();

  /// Adds the counts of the last piece.
  void Count(RunCounts& counts) const;

  /// Known after SetUp().
  std::string GetRayCasterName() const;

  /// What sub-rays and bins the settings come to, in words.
  std::string DescribeSampling() const;

private:
  vtkSmartPointer<vtkHeliosScanner> MakeChannel(
    const ScannerData& data, const PlatformData& platform);
  void MakeChannels(const LegPlan& plan);

  const SurveyData& Survey;
  ScanOptions Options;
  Messages& Log;
  SpectralScenes Scenes;
  std::size_t Scanner; // of the survey, that the channels are of
  std::size_t Platform;
  std::vector<vtkSmartPointer<vtkHeliosScanner>> Channels;
};

} // namespace helios

#endif
