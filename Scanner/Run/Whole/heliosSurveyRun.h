// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
// A run of a survey, from the checks before it to its summary.

#ifndef heliosSurveyRun_h
#define heliosSurveyRun_h

#include "heliosInputFile.h"
#include "heliosLegRunner.h"
#include "heliosMessages.h"
#include "heliosRankBlocks.h"
#include "heliosRankWorker.h"
#include "heliosRunFolder.h"
#include "heliosRunJournal.h"
#include "heliosRunPartReader.h"
#include "heliosRunSettings.h"
#include "heliosScanCounts.h"
#include "heliosStatus.h"
#include "heliosSurveyLoader.h"
#include "vtkHeliosEchoAlgorithm.h"

#include <json/json.h>

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkHeliosRanks;
class vtkObject;

namespace helios
{

/// The files that a run is to write, and how.
struct RunRequest
{
  std::string Format; ///< xyz, las, vtp
  vtkHeliosEchoAlgorithm::Outputs Wants;
  bool Overwrite = false;
  bool Resume = false;
  vtkIdType PulsesPerBlock = 0;
  vtkIdType BytesToCheck = 0; ///< bytes of the files of an earlier run
  int Part = 1;
  int NumberOfParts = 0; ///< 0: the whole
  std::string PartCommand;
  std::vector<std::string> PartFolders; ///< to join
  vtkHeliosRanks* Ranks = nullptr;
  bool Forecast = false; ///< before the first pulse
};

/// The progress and the result of a run.
struct RunState
{
  bool WasFinished = false;
  double Progress = 0.0;
  int CurrentLeg = 0;
  vtkIdType NumberOfPulses = 0;
  ScanCounts Counts;
  std::string Sampling;
  std::string Message;
  std::string Report;   ///< JSON
  std::string Forecast; ///< JSON; empty: none
};

/// Has the survey that is run, and hears of its progress.
class RunOwner
{
public:
  virtual ~RunOwner() = default;

  virtual bool CheckOptions(RunSettings& settings) = 0;
  virtual bool LoadScene(
    const std::function<bool(const std::string& step)>& onStep, RunSettings& settings) = 0;
  virtual const SurveyLoader& GetLoader() const = 0;
  virtual void SetEpoch(int epoch) = 0;
  virtual std::string GetRunFolder() = 0;
  virtual void ReportProgress() = 0;
};

class SurveyRun
{
public:
  /// Reports errors and warnings as those of the log's owner. Abort is set to stop the run.
  SurveyRun(RunOwner& owner, const RunRequest& request, const std::atomic<bool>& abort,
    RunState& state, Messages& log)
    : Owner(owner)
    , Request(request)
    , Abort(abort)
    , State(state)
    , Log(log)
  {
  }

  /// Runs the survey and reports the result.
  bool Run();

  /// Reports the estimated time and output of Run().
  bool Estimate();

  /// Computes blocks for rank 0 until it ends the service.
  bool Serve();

private:
  bool CheckSettings();
  bool CheckPart();
  bool Check(const Status& status);
  bool OpenParts();
  bool FindBlocks();
  bool StartRanks();
  bool LoadForRank(int epoch);
  const SurveyData& GetSurvey() const { return this->Owner.GetLoader().GetSurvey(); }
  bool FindEarlierRun();
  bool CheckEarlierRun(const Json::Value& then);
  bool CheckFinishedRun(const Json::Value& then);
  bool CheckEarlierFiles();
  bool Load();
  bool HashScene();
  bool Plan();
  bool Begin();
  Json::Value ForecastRun(bool isFull);
  bool RunLegs();
  void MeasureAccuracy();
  bool Conclude();
  bool ConcludeFinished();
  bool ReportStep(const std::string& step);
  bool Count(const ScanCounts& counts);
  void SetCounts(const ScanCounts& counts);
  bool Fail(const std::string& text);
  bool Fail();
  std::string DescribeKept() const;

  RunOwner& Owner;
  const RunRequest& Request;
  const std::atomic<bool>& Abort;
  RunState& State;
  Messages& Log;
  RunSettings Settings;
  bool Resumes = false;
  std::unique_ptr<RunFolder> Folder;
  std::unique_ptr<RunJournal> Journal;
  std::unique_ptr<RunPartReader> Parts;   // null: pulses are computed
  std::unique_ptr<RankBlocks> RankSource; // null: by this process
  std::unique_ptr<RankWorker> Worker;     // worker of a rank other than 0
  std::unique_ptr<LegRunner> Runner;
  Json::Value Fingerprint;
  InputFiles Inputs; // that were opened
  double LoadSeconds = 0.0;
  Json::Value Accuracy;
  double AccuracySeconds = 0.0;
};

} // namespace helios

#endif
