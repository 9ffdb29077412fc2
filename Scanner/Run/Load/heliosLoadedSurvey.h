// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A survey in memory: its scene, its legs, and any of their pulses.

#ifndef heliosLoadedSurvey_h
#define heliosLoadedSurvey_h

#include "heliosLegRunner.h"
#include "heliosPieceBuffer.h"
#include "heliosRunSettings.h"
#include "heliosSurveyLoader.h"

#include <vtkTimeStamp.h>

#include <functional>
#include <memory>
#include <vector>

namespace helios
{

class Messages;

class LoadedSurvey
{
public:
  /// Called with the share that is done; returns whether to go on.
  using ProgressCallback = std::function<bool(double)>;

  /// One per output port of a scanner.
  using Piles = std::vector<PieceBuffer>;

  explicit LoadedSurvey(Messages& log);

  SurveyLoader& GetLoader() { return this->Loader; }
  const SurveyLoader& GetLoader() const { return this->Loader; }

  /// Plans the legs in the loaded scene, unless that is done; false after an error, which may be
  /// that there are no pulses.
  bool Plan(const RunSettings& settings);

  /// Runs pulses [first, last) of all legs; false if it was stopped, or after an error.
  bool Run(vtkIdType first, vtkIdType last, const ProgressCallback& onProgress, Piles& piles);

  /// @{
  /// Return the settings of the last call of Plan(), and whether it changed anything.
  const RunSettings& GetSettings() const { return this->Settings; }
  vtkMTimeType GetPlanTime() const { return this->PlanTime.GetMTime(); }
  ///@}

  /// Returns the legs; null before Plan().
  LegRunner* GetLegs() const { return this->Runner.get(); }

  /// Finds a leg; null if there is none.
  const LegPlan* FindLeg(int leg) const;
  const LegPlan* FindPulse(vtkIdType pulse) const;

  /// Returns when a pulse of a leg is fired [s].
  double GetPulseTime(const LegPlan& plan, vtkIdType pulse) const;

  /// Returns the first pulse of a leg that is not fired before a time.
  vtkIdType GetPulse(const LegPlan& plan, double time) const;

private:
  /// Pulses [First, Last) of each channel of a leg.
  struct Shots
  {
    vtkIdType First;
    vtkIdType Last;
  };

  struct Progress
  {
    const ProgressCallback& OnProgress;
    vtkIdType Pulses;
    vtkIdType Done = 0;

    /// Reports it, with some more pulses; false: stop.
    bool GoesOn(double more = 0.0) const
    {
      return this->OnProgress(
        (static_cast<double>(this->Done) + more) / static_cast<double>(this->Pulses));
    }
  };

  vtkIdType GetChannels(const LegPlan& plan) const;
  double GetRate(const LegPlan& plan) const;
  Shots FindShots(const LegPlan& plan, vtkIdType first, vtkIdType last) const;
  bool RunLeg(const LegPlan& plan, const Shots& shots, Progress& progress, Piles& piles);

  Messages& Log;
  SurveyLoader Loader;
  RunSettings Settings;
  vtkMTimeType SceneTime = 0; // time of the scene that the legs were planned in
  vtkTimeStamp PlanTime;
  std::unique_ptr<LegRunner> Runner;
};

} // namespace helios

#endif
