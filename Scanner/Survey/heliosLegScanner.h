// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The scanner of a leg: a vtkHeliosScanner for every channel, all firing at once.

#ifndef heliosLegScanner_h
#define heliosLegScanner_h

#include "heliosLegPlan.h"
#include "heliosMovingScene.h"
#include "heliosPiecePile.h"
#include "heliosRunCounts.h"
#include "heliosRunSettings.h"
#include "heliosSpectrum.h"
#include "heliosSurveyData.h"
#include "vtkHeliosScannerSurveyModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataObject;
class vtkHeliosRayCaster;
class vtkHeliosScanner;
class vtkImageData;
class vtkPolyData;

namespace helios
{

class Messages;

class VTKHELIOSSCANNERSURVEY_EXPORT LegScanner
{
public:
  LegScanner(
    const SurveyData& survey, vtkPolyData* scene, const RunSettings& settings, Messages& log);
  ~LegScanner();

  /// Makes the scanner that of a leg.
  void SetUp(const LegPlan& plan);

  std::size_t GetNumberOfChannels() const { return this->Channels.size(); }

  /// The part [t0, t1) of the leg that is run [s]; all of it after SetUp().
  void SetTimeWindow(double t0, double t1);

  /// The part [first, last) of the pulses of each channel that is run, of those in the window of time;
  /// all of it after SetUp().
  void SetPulseWindow(vtkIdType first, vtkIdType last);

  /// Which outputs the settings ask for beside the echoes, from now on.
  void SetOutputs(const RunSettings& settings);

  /// The pulses of all channels in the windows.
  vtkIdType CountPulses();

  /// Runs a piece of the leg; false after an error.
  bool Update(int piece, int pieces);

  /// The port of all channels together, in the order of pulses; the port of one of them.
  vtkSmartPointer<vtkDataObject> GetOutput(int port) const;
  vtkDataObject* GetOutput(int port, std::size_t channel) const;

  /// Forgets the output of the last piece.
  void ReleaseOutput();

  /// What the output of the last piece takes [bytes].
  double GetMemorySize() const;

  /// Adds the counts of the last piece.
  void Count(RunCounts& counts) const;

  /// What sub-rays and bins the settings come to, in words.
  std::string DescribeSampling() const;

  std::string GetRayCasterName() const;

private:
  vtkSmartPointer<vtkHeliosScanner> MakeChannel(
    const ScannerData& data, const PlatformData& platform);
  void MakeChannels(const LegPlan& plan);
  void PutOutputs(vtkHeliosScanner* channel) const;
  bool HasPort(int port) const;
  void PutWindow(vtkIdType first, vtkIdType last);
  bool UpdateMoving(int piece, int pieces);
  bool UpdateAll(int piece, int pieces);
  void PutParts();
  void Gather();

  const SurveyData& Survey;
  RunSettings Settings;
  Messages& Log;
  SpectralScenes Scenes;
  std::vector<SpectralScenes> Grids;
  std::size_t Scanner; // of the survey, that the channels are of
  std::size_t Platform;
  std::vector<vtkSmartPointer<vtkHeliosScanner>> Channels;
  vtkIdType FirstPulse;
  vtkIdType LastPulse;

  // Where parts move: the leg's clock, the window of time, and what the windows of one scene gave.
  MovingScene Motion;
  vtkSmartPointer<vtkHeliosRayCaster> MotionCaster;
  PulseClock Clock;
  double WindowStart;
  vtkMTimeType MoveTime;
  std::vector<std::vector<PiecePile>> Gathered; // by channel and port
  RunCounts GatheredCounts;
};

} // namespace helios

#endif
