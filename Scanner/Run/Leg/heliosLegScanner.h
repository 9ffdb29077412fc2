// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// The scanner of a leg: one vtkHeliosScanner per channel, all firing at once.

#ifndef heliosLegScanner_h
#define heliosLegScanner_h

#include "heliosLegPlan.h"
#include "heliosMovingInstances.h"
#include "heliosRunSettings.h"
#include "heliosScanCounts.h"
#include "heliosSpectrum.h"
#include "heliosSurveyData.h"
#include "vtkHeliosScannerRunModule.h" // For export macro

#include <vtkSmartPointer.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkHeliosRayCaster;
class vtkHeliosScanner;
class vtkImageData;
class vtkObject;
class vtkPolyData;

namespace helios
{

class Messages;

class VTKHELIOSSCANNERRUN_EXPORT LegScanner
{
public:
  LegScanner(
    const SurveyData& survey, vtkPolyData* scene, const RunSettings& settings, Messages& log);
  ~LegScanner();

  /// Sets up the scanner for a leg.
  void SetUp(const LegPlan& plan);

  std::size_t GetNumberOfChannels() const { return this->Channels.size(); }

  /// Returns a channel that is not reported, nor changed later.
  vtkSmartPointer<vtkHeliosScanner> ReleaseChannel(std::size_t channel);

  /// Sets the part [t0, t1) of the leg to run [s]; the whole leg after SetUp().
  void SetTimeWindow(double t0, double t1);

  /// Sets the range [first, last) of each channel's pulses in the time window to run; all after
  /// SetUp().
  void SetPulseWindow(vtkIdType first, vtkIdType last);

  /// Runs in another way from the next SetUp() on.
  void SetOptions(const RunOptions& options);

  /// Sets what is computed besides the echoes.
  void SetOutputs(const vtkHeliosEchoAlgorithm::Outputs& wants);

  /// Returns the pulses of all channels in the windows.
  vtkIdType CountPulses();

  /// Sets a callback while a piece is run, with the fraction done; false stops the piece. Null:
  /// never stops.
  void SetOnProgress(const std::function<bool(double)>& onProgress)
  {
    this->OnProgress = onProgress;
  }

  /// Runs a piece of the leg; false after an error, or if it is stopped.
  bool Update(int piece, int pieces);

  /// Returns whether the last piece was stopped.
  bool WasStopped() const { return this->IsStopped; }

  /// Returns the port of all channels together, in pulse order; the port of one of them.
  vtkSmartPointer<vtkDataObject> GetOutput(int port) const;
  vtkDataObject* GetOutput(int port, std::size_t channel) const;

  /// Releases the output of the last piece.
  void ReleaseOutput();

  /// Returns the size of the output of the last piece [bytes].
  double GetMemorySize() const;

  /// Adds the counts of the last piece.
  void Count(ScanCounts& counts) const;

  /// Describes the numbers of sub-rays and bins as text.
  std::string DescribeSampling() const;

  std::string GetRayCasterName() const;

  /// Returns the size of scene and ray caster [bytes].
  double GetSceneSize() const;

  /// Returns the parts that move, with their speeds in legs.
  std::vector<PartSpeeds> GetSpeeds(const std::vector<LegPlan>& plans) const;

private:
  vtkPolyData* FindScene();
  vtkSmartPointer<vtkHeliosScanner> MakeChannel(
    const ScannerData& data, const PlatformData& platform);
  void MakeChannels(const LegPlan& plan);
  void SetTrajectory(const LegPlan& plan, vtkHeliosScanner* channel) const;
  void ApplyWindow(vtkIdType first, vtkIdType last);
  bool UpdateAll(int piece, int pieces);
  vtkDataObject* GetAt(SpectralScenes& scenes, double wavelength) const;
  vtkSmartPointer<vtkDataObject> GetScene(double wavelength);
  void HandleProgress(vtkObject* caller, unsigned long event, void* data);

  const SurveyData& Survey;
  RunSettings Settings;
  Messages& Log;
  MovingInstances Motion;
  vtkSmartPointer<vtkHeliosRayCaster> MotionCaster; // null: nothing moves
  SpectralScenes Scenes;
  std::vector<SpectralScenes> Grids;
  std::size_t Scanner; // scanner of the survey, with these channels
  std::size_t Platform;
  std::vector<vtkSmartPointer<vtkHeliosScanner>> Channels;
  vtkIdType FirstPulse;
  vtkIdType LastPulse;

  // While a piece is run: the range of the current update in it.
  std::function<bool(double)> OnProgress;
  std::chrono::steady_clock::time_point LastProgress;
  double ShareBefore = 0.0;
  double ShareAfter = 1.0;
  bool IsStopped = false;
};

} // namespace helios

#endif
