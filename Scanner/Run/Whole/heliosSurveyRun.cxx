// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSurveyRun.h"

#include "heliosCounted.h"
#include "heliosNoEchoes.h"
#include "heliosRankServer.h"
#include "heliosRunAccuracy.h"
#include "heliosRunCheck.h"
#include "heliosRunEstimate.h"
#include "heliosRunFingerprint.h"
#include "heliosRunForecast.h"
#include "heliosRunFormat.h"
#include "heliosRunInputs.h"
#include "heliosRunSummary.h"
#include "heliosSurveyLoader.h"
#include "vtkHeliosRanks.h"
#include "vtkHeliosRayCaster.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <chrono>

namespace helios
{

//------------------------------------------------------------------------------
bool SurveyRun::Run()
{
  if (!this->CheckSettings() || !this->FindEarlierRun())
  {
    return this->Fail();
  }
  if (this->State.WasFinished)
  {
    return this->ConcludeFinished();
  }
  return this->OpenParts() && this->StartRanks() && this->Load() && this->Plan() && this->Begin() &&
    this->RunLegs() && this->Conclude();
}

//------------------------------------------------------------------------------
bool SurveyRun::Estimate()
{
  const bool isChecked = this->CheckSettings();
  this->Settings.Part = {}; // all of them
  if (!isChecked || !this->Load() || !this->Plan())
  {
    return this->Fail();
  }
  RunEstimate estimate(*this->Runner, this->LoadSeconds);
  const bool isWhole = estimate.Make(
    [this](double share)
    {
      this->State.Progress = share;
      return this->ReportStep("sampling");
    });
  if (this->Log.HasError())
  {
    return this->Fail();
  }
  Json::Value report = isWhole ? estimate.Describe() : Json::Value();
  if (isWhole)
  {
    report["forecast"] = this->ForecastRun(true);
  }
  const bool isGood = isWhole && !this->Abort;
  this->State.Report = isGood ? ToText(report) : "";
  this->State.Message = isGood ? "Estimated; nothing was written." : "Stopped.";
  return isGood;
}

//------------------------------------------------------------------------------
/// Describes time and errors at several tolerances.
Json::Value SurveyRun::ForecastRun(bool isFull)
{
  RunForecast forecast(*this->Runner, this->Settings, this->Log);
  const auto onStep = [this](double) { return this->ReportStep("comparing tolerances"); };
  forecast.Measure(RunForecast::MakeEffort(isFull), onStep);
  return forecast.Describe();
}

//------------------------------------------------------------------------------
bool SurveyRun::CheckSettings()
{
  this->Settings.Wants = this->Request.Wants;
  if (!this->Owner.CheckOptions(this->Settings))
  {
    return this->Fail();
  }
  this->Settings.Folder = this->Owner.GetRunFolder();
  this->Settings.PulsesPerBlock = this->Request.PulsesPerBlock;
  return this->Check(SetFormat(this->Request.Format, this->Settings)) && this->CheckPart();
}

//------------------------------------------------------------------------------
bool SurveyRun::CheckPart()
{
  if (this->Request.NumberOfParts == 0)
  {
    return true;
  }
  const std::string parts = std::to_string(this->Request.NumberOfParts);
  if (this->Request.Part > this->Request.NumberOfParts)
  {
    return this->Fail("Part is " + std::to_string(this->Request.Part) + ", but NumberOfParts is " +
      parts + "; give 1 to " + parts + ".");
  }
  if (!this->Request.PartFolders.empty())
  {
    return this->Fail("NumberOfParts is " + parts +
      ", but there are folders of parts to join; set "
      "it to 0, or call ClearPartFolders().");
  }
  this->Settings.Part = { this->Request.Part, this->Request.NumberOfParts,
    this->Request.PartCommand };
  return true;
}

//------------------------------------------------------------------------------
/// Reads what the parts are; before the scene is loaded.
bool SurveyRun::OpenParts()
{
  if (this->Request.PartFolders.empty())
  {
    return true;
  }
  this->Parts = std::make_unique<RunPartReader>(this->GetSurvey(), this->Settings, this->Log);
  return this->Check(this->Parts->Open(this->Request.PartFolders)) &&
    this->Check(this->Parts->CheckFingerprints(this->Fingerprint));
}

//------------------------------------------------------------------------------
/// Finds the blocks of the legs in the parts, and checks that they are of the same scene.
bool SurveyRun::FindBlocks()
{
  if (!this->Parts)
  {
    return true;
  }
  this->Runner->SetSource(this->Parts.get());
  return this->Check(this->Parts->CheckFingerprints(this->Fingerprint)) &&
    this->Check(this->Parts->FindBlocks(this->Runner->GetPlans()));
}

//------------------------------------------------------------------------------
bool SurveyRun::FindEarlierRun()
{
  this->Folder = std::make_unique<RunFolder>(this->Settings.Folder);
  this->Journal = std::make_unique<RunJournal>(this->Settings.Folder);
  // Epochs after the current one of an interrupted run, and parts, may have no files yet.
  const bool isNext = (this->Settings.Options.Epoch > 0 || this->Settings.Part.IsSet()) &&
    !this->Request.Overwrite && this->Folder->IsEmpty();
  this->Resumes = this->Request.Resume && !isNext;
  Status status = this->Folder->Prepare(this->Request.Overwrite, this->Resumes);
  if (!status.IsOk())
  {
    return this->Fail(status.Message());
  }
  this->ReportStep("hashing the input files");
  this->Fingerprint = MakeFingerprint(this->GetSurvey(), this->Settings);
  if (!this->Resumes)
  {
    return true;
  }
  if (this->Owner.GetLoader().HasGivenScene()) // no file tells a change of it
  {
    if (!this->Load() || !this->Plan() || !this->HashScene())
    {
      return false;
    }
  }
  Json::Value summary;
  this->State.WasFinished =
    this->Settings.Part.IsSet() ? this->Folder->HasSummary() : !this->Journal->Exists();
  status = this->State.WasFinished ? this->Folder->ReadSummary(summary) : this->Journal->Continue();
  if (!status.IsOk())
  {
    return this->Fail(status.Message() +
      "; wait for the other run to end, or set Overwrite (--overwrite) to start again");
  }
  if (!this->State.WasFinished)
  {
    return this->CheckEarlierRun(this->Journal->GetFingerprint());
  }
  status = RunCheck(this->Settings.Folder).CheckSummary(summary);
  if (!this->CheckFinishedRun(summary) || (!status.IsOk() && !this->Fail(status.Message())))
  {
    return false;
  }
  this->State.Report = ToText(summary);
  return true;
}

//------------------------------------------------------------------------------
/// Checks what is known before the scene is loaded, and its files by the names that they had.
bool SurveyRun::CheckEarlierRun(const Json::Value& then)
{
  Json::Value now = this->Fingerprint;
  if (!IsOfLoadedSurvey(now))
  {
    AddEarlierInputs(then["inputs"], now["inputs"]);
  }
  const std::string difference = CompareFingerprints(then, now);
  return difference.empty() ||
    this->Fail(this->Settings.Folder + ": the run there cannot be resumed, since " + difference +
      "; use the same inputs and options, or set Overwrite (--overwrite) to start again");
}

//------------------------------------------------------------------------------
/// Loads the scene only if its files are not where they were.
bool SurveyRun::CheckFinishedRun(const Json::Value& then)
{
  Json::Value inputs = this->Fingerprint["inputs"];
  const bool isKnown =
    IsOfLoadedSurvey(this->Fingerprint) || AddEarlierInputs(then["inputs"], inputs);
  return this->CheckEarlierRun(then) &&
    (isKnown || (this->Load() && this->Plan() && this->HashScene() && this->CheckEarlierRun(then)));
}

//------------------------------------------------------------------------------
bool SurveyRun::CheckEarlierFiles()
{
  const RunCheck check(this->Settings.Folder);
  Status status = check.CheckSizes(*this->Journal);
  if (status.IsOk())
  {
    status = check.CheckBlocks(*this->Journal, this->Request.BytesToCheck,
      [this] { return this->ReportStep("checking the files of the earlier run"); });
  }
  if (!status.IsOk())
  {
    return this->Fail(status.Message());
  }
  this->State.Message = this->Abort ? "Stopped." : this->State.Message;
  return !this->Abort;
}

//------------------------------------------------------------------------------
bool SurveyRun::Load()
{
  const auto start = std::chrono::steady_clock::now();
  const auto onStep = [this](const std::string& step) { return this->ReportStep(step); };
  const bool isLoaded = this->Owner.LoadScene(onStep, this->Settings);
  if (!isLoaded && !this->Log.HasError())
  {
    this->State.Message = "Stopped while the scene was loaded; nothing was written.";
  }
  this->LoadSeconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return isLoaded || this->Fail();
}

//------------------------------------------------------------------------------
/// Completes the fingerprint of a loaded and planned survey.
bool SurveyRun::HashScene()
{
  this->ReportStep("hashing the files of the scene");
  return this->Check(AddLoadedSurvey(
    this->Owner.GetLoader(), *this->Runner, this->Settings, this->Fingerprint, this->Inputs));
}

//------------------------------------------------------------------------------
bool SurveyRun::Plan()
{
  if (this->Runner)
  {
    return true; // to compare it with an earlier run
  }
  this->Runner = std::make_unique<LegRunner>(
    this->GetSurvey(), this->Owner.GetLoader().GetScene(), this->Settings, this->Log);
  this->Runner->SetOnProgress([this](double) { return this->ReportStep(this->State.Message); });
  if (!this->Runner->Plan())
  {
    return this->Fail();
  }
  this->State.NumberOfPulses = this->Runner->GetNumberOfPulsesToRun();
  this->State.Sampling = this->Runner->DescribeSampling();
  return this->Runner->GetNumberOfPulses() > 0 || this->Fail(ExplainNoEchoes(*this->Runner));
}

//------------------------------------------------------------------------------
bool SurveyRun::Begin()
{
  if (!this->HashScene() || !this->FindBlocks())
  {
    return false;
  }
  if (this->RankSource)
  {
    this->RankSource->SetRun(this->Runner->GetPlans(), this->Fingerprint);
    this->Runner->SetSource(this->RankSource.get());
  }
  if (this->Resumes)
  {
    return this->CheckEarlierRun(this->Journal->GetFingerprint()) && this->CheckEarlierFiles();
  }
  if (const Status status = this->Folder->Clear(); !status.IsOk())
  {
    return this->Fail(status.Message());
  }
  const Status status = this->Journal->Create(this->Fingerprint);
  return status.IsOk() || this->Fail(status.Message() + "; give another OutputDirectory");
}

//------------------------------------------------------------------------------
bool SurveyRun::RunLegs()
{
  const bool isShared = this->Settings.Part.IsSet() || this->Parts || this->RankSource;
  if (this->Request.Forecast && !this->Resumes && !isShared)
  {
    this->State.Forecast = ToText(this->ForecastRun(false));
  }
  const auto onBlock = [this](const ScanCounts& counts) { return this->Count(counts); };
  for (const LegPlan& plan : this->Runner->GetPlans())
  {
    this->State.CurrentLeg = static_cast<int>(plan.Leg);
    if (!this->ReportStep("running leg " + std::to_string(plan.Leg)) ||
      !this->Runner->Run(plan, *this->Journal, onBlock))
    {
      this->SetCounts(this->Runner->GetCounts());
      const std::string error = this->Log.GetLastError();
      const std::string kept = this->DescribeKept();
      if (!error.empty())
      {
        this->Log.Error("Ended" + kept);
      }
      this->State.Message = (error.empty() ? "Stopped" : error + ". Ended") + kept;
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::string SurveyRun::DescribeKept() const
{
  MessageBuilder text;
  text << " after " << this->State.Counts.Pulses << " of " << this->State.NumberOfPulses
       << " pulses; ";
  if (!this->Folder->Exists() || !this->Journal->Check().IsOk())
  {
    text << "nothing is kept, since the folder " << this->Settings.Folder << " is gone"
         << (this->Folder->Exists() ? ", or was replaced by another one." : ".");
    return text.str();
  }
  text << "the " << this->State.Counts.Echoes << " points so far are kept in "
       << this->Settings.Folder << ", those of the current leg in files that end in .part; "
       << "Resume (--resume) continues from there.";
  return text.str();
}

//------------------------------------------------------------------------------
/// Measures the accuracy of a run whose points are complete; on an abort, without it.
void SurveyRun::MeasureAccuracy()
{
  if (!this->Settings.Options.AccuracyReport)
  {
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  RunAccuracy accuracy(*this->Runner, this->Settings, this->Log);
  accuracy.Measure([this](double) { return this->ReportStep("measuring the accuracy"); });
  this->Accuracy = accuracy.Describe();
  this->AccuracySeconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

//------------------------------------------------------------------------------
bool SurveyRun::Conclude()
{
  const ScanCounts& counts = this->Runner->GetCounts();
  this->SetCounts(counts);
  const bool isPart = this->Settings.Part.IsSet();
  if (counts.Echoes == 0 && !isPart)
  {
    return this->Fail(ExplainNoEchoes(*this->Runner));
  }
  if (!isPart)
  {
    this->MeasureAccuracy();
  }
  Json::Value summary = MakeSummary(this->Fingerprint, *this->Journal, *this->Runner,
    this->Accuracy, this->LoadSeconds, this->AccuracySeconds);
  if (this->Parts)
  {
    summary["timings"]["parts_s"] = this->Parts->GetSeconds();
  }
  const Status status = this->Folder->WriteSummary(summary);
  if (!status.IsOk())
  {
    return this->Fail(status.Message() +
      "; all points are written: free disk space, and complete the run with Resume "
      "(--resume)");
  }
  if (!isPart) // whose blocks are read by its journal
  {
    this->Journal->Remove();
  }
  this->State.Report = ToText(summary);
  MessageBuilder text;
  text << Counted(counts.Echoes, "point") << " from " << Counted(counts.Pulses, "pulse") << " "
       << (isPart ? "of part " + this->Settings.Part.GetText() + " " : "") << "are in "
       << this->Settings.Folder << ".";
  this->State.Message = text.str();
  return true;
}

//------------------------------------------------------------------------------
bool SurveyRun::ConcludeFinished()
{
  Json::Value summary;
  FromText(this->State.Report, summary);
  const ScanCounts counts = GetTotals(summary);
  this->State.NumberOfPulses = counts.Pulses;
  this->State.Sampling = summary["sampling"].asString();
  this->SetCounts(counts);
  MessageBuilder text;
  text << "Nothing is left to do: the run in " << this->Settings.Folder << " is finished, with "
       << Counted(counts.Echoes, "point") << " from " << Counted(counts.Pulses, "pulse") << ".";
  this->State.Message = text.str();
  return true;
}

//------------------------------------------------------------------------------
bool SurveyRun::ReportStep(const std::string& step)
{
  this->State.Message = step;
  this->Owner.ReportProgress();
  return !this->Abort;
}

//------------------------------------------------------------------------------
void SurveyRun::SetCounts(const ScanCounts& counts)
{
  this->State.Counts = counts;
  this->State.Progress = this->State.NumberOfPulses > 0
    ? static_cast<double>(counts.Pulses) / static_cast<double>(this->State.NumberOfPulses)
    : 1.0; // a part without blocks
}

//------------------------------------------------------------------------------
bool SurveyRun::Count(const ScanCounts& counts)
{
  this->SetCounts(counts);
  this->Owner.ReportProgress();
  // After the last pulse the run is complete.
  return !this->Abort || counts.Pulses == this->State.NumberOfPulses;
}

//------------------------------------------------------------------------------
bool SurveyRun::Check(const Status& status)
{
  return status.IsOk() || this->Fail(status.Message());
}

//------------------------------------------------------------------------------
bool SurveyRun::Fail(const std::string& text)
{
  this->Log.Error(text);
  return this->Fail();
}

//------------------------------------------------------------------------------
bool SurveyRun::Fail()
{
  const std::string& error = this->Log.GetLastError();
  this->State.Message = error.empty() ? this->State.Message : error;
  return false;
}

//------------------------------------------------------------------------------
/// Lets other ranks load the survey, too.
bool SurveyRun::StartRanks()
{
  vtkHeliosRanks* ranks = this->Request.Ranks;
  if (!ranks || ranks->GetNumberOfRanks() < 2 || this->Parts)
  {
    return true;
  }
  this->RankSource = std::make_unique<RankBlocks>(ranks,
    LegFiles(this->GetSurvey(), MakeRunPartSettings(this->Settings)), this->Log,
    [this] { return this->ReportStep(this->State.Message); });
  return this->RankSource->Begin(this->Settings.Options.Epoch) || this->Fail();
}

//------------------------------------------------------------------------------
bool SurveyRun::Serve()
{
  vtkHeliosRanks* ranks = this->Request.Ranks;
  if (!ranks || ranks->GetRank() == 0)
  {
    return this->Fail("Serve() is for ranks above 0: set Ranks, and call Run() of rank 0.");
  }
  RankServer server(ranks);
  const auto load = [this](int epoch)
  {
    RankServer::Service service;
    service.Worker = this->LoadForRank(epoch) ? this->Worker.get() : nullptr;
    service.Fingerprint = ToLine(this->Fingerprint);
    service.Error = this->Log.GetLastError();
    return service;
  };
  const Status status = server.Serve(load, this->Abort);
  return status.IsOk() ? !this->Abort : this->Fail(status.Message());
}

//------------------------------------------------------------------------------
bool SurveyRun::LoadForRank(int epoch)
{
  this->Worker.reset();
  this->Runner.reset();
  this->Owner.SetEpoch(epoch);
  this->Settings = {};
  if (!this->CheckSettings())
  {
    return false;
  }
  this->Settings.Part = {}; // rank 0 says which blocks
  this->Fingerprint = MakeFingerprint(this->GetSurvey(), this->Settings);
  if (!this->Load() || !this->Plan() || !this->HashScene())
  {
    return false;
  }
  this->Worker = std::make_unique<RankWorker>(
    LegFiles(this->GetSurvey(), MakeRunPartSettings(this->Settings)), *this->Runner, this->Log);
  return true;
}

} // namespace helios
