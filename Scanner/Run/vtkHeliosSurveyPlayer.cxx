// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurveyPlayer.h"

#include "heliosLegRunner.h"
#include "heliosMessages.h"
#include "heliosNoEchoes.h"
#include "heliosRankBlocks.h"
#include "heliosRankServer.h"
#include "heliosRankWorker.h"
#include "heliosRunAccuracy.h"
#include "heliosRunCheck.h"
#include "heliosRunEstimate.h"
#include "heliosRunFingerprint.h"
#include "heliosRunFolder.h"
#include "heliosRunFormat.h"
#include "heliosRunInputs.h"
#include "heliosRunJournal.h"
#include "heliosRunPartReader.h"
#include "heliosRunSummary.h"
#include "heliosStatus.h"
#include "heliosSurveyLoader.h"
#include "vtkHeliosRanks.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRunFiles.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveySource.h"

#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHeliosSurveyPlayer);

namespace
{

std::string TextOf(const char* text)
{
  return text ? text : "";
}

} // namespace

/// One run of a player.
class vtkHeliosSurveyPlayer::Internals
{
public:
  explicit Internals(vtkHeliosSurveyPlayer* player)
    : Player(player)
    , Log(player)
  {
    this->Log.Listen(player->Source);
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
  bool Check(const helios::Status& status);
  bool OpenParts();
  bool FindBlocks();
  bool StartRanks();
  bool LoadForRank(int epoch);
  const helios::SurveyData& GetSurvey() const
  {
    return this->Player->Source->GetLoader().GetSurvey();
  }
  vtkPolyData* GetScene() const { return this->Player->Source->GetScene(); }
  bool FindEarlierRun();
  bool CheckEarlierRun(const Json::Value& then);
  bool CheckFinishedRun(const Json::Value& then);
  bool CheckEarlierFiles();
  bool Load();
  bool HashScene();
  bool Plan();
  bool Begin();
  bool RunLegs();
  void MeasureAccuracy();
  bool Conclude();
  bool ConcludeFinished();
  bool ReportStep(const std::string& step);
  bool Count(const helios::ScanCounts& counts);
  void SetCounts(const helios::ScanCounts& counts);
  bool Fail(const std::string& text);
  bool Fail();
  std::string DescribeKept() const;

  vtkHeliosSurveyPlayer* Player;
  helios::Messages Log;
  helios::RunSettings Settings;
  bool Resumes = false;
  std::unique_ptr<helios::RunFolder> Folder;
  std::unique_ptr<helios::RunJournal> Journal;
  std::unique_ptr<helios::RunPartReader> Parts;   // null: pulses are computed
  std::unique_ptr<helios::RankBlocks> RankSource; // null: by this process
  std::unique_ptr<helios::RankWorker> Worker;     // of a rank other than 0
  std::unique_ptr<helios::LegRunner> Runner;
  Json::Value Fingerprint;
  helios::InputFiles Inputs; // that were opened
  double LoadSeconds = 0.0;
  Json::Value Accuracy;
  double AccuracySeconds = 0.0;
};

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Run()
{
  if (!this->CheckSettings() || !this->FindEarlierRun())
  {
    return this->Fail();
  }
  if (this->Player->WasFinished)
  {
    return this->ConcludeFinished();
  }
  return this->OpenParts() && this->StartRanks() && this->Load() && this->Plan() && this->Begin() &&
    this->RunLegs() && this->Conclude();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Estimate()
{
  const bool isChecked = this->CheckSettings();
  this->Settings.Part = {}; // all of them
  if (!isChecked || !this->Load() || !this->Plan())
  {
    return this->Fail();
  }
  helios::RunEstimate estimate(*this->Runner, this->LoadSeconds);
  const bool isWhole = estimate.Make(
    [this](double share)
    {
      this->Player->Progress = share;
      return this->ReportStep("sampling");
    });
  if (this->Log.HasError())
  {
    return this->Fail();
  }
  this->Player->Report = isWhole ? helios::ToText(estimate.Describe()) : "";
  this->Player->Message = isWhole ? "Estimated; nothing was written." : "Stopped.";
  return isWhole;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::CheckSettings()
{
  vtkHeliosSurveyPlayer* player = this->Player;
  this->Settings.Wants = player->Wanted;
  if (!player->Source->CheckOptions(this->Settings))
  {
    return this->Fail();
  }
  this->Settings.Folder = player->GetRunFolder();
  this->Settings.PulsesPerBlock = player->PulsesPerBlock;
  return this->Check(helios::SetFormat(TextOf(player->Format), this->Settings)) &&
    this->CheckPart();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::CheckPart()
{
  const vtkHeliosSurveyPlayer* player = this->Player;
  if (player->NumberOfParts == 0)
  {
    return true;
  }
  const std::string parts = std::to_string(player->NumberOfParts);
  if (player->Part > player->NumberOfParts)
  {
    return this->Fail("Part is " + std::to_string(player->Part) + ", but NumberOfParts is " +
      parts + "; give 1 to " + parts + ".");
  }
  if (!player->PartFolders.empty())
  {
    return this->Fail("NumberOfParts is " + parts +
      ", but there are folders of parts to join; set "
      "it to 0, or call ClearPartFolders().");
  }
  this->Settings.Part = { player->Part, player->NumberOfParts, player->PartCommand };
  return true;
}

//------------------------------------------------------------------------------
/// Reads what the parts are; before the scene is loaded.
bool vtkHeliosSurveyPlayer::Internals::OpenParts()
{
  if (this->Player->PartFolders.empty())
  {
    return true;
  }
  this->Parts =
    std::make_unique<helios::RunPartReader>(this->GetSurvey(), this->Settings, this->Log);
  return this->Check(this->Parts->Open(this->Player->PartFolders)) &&
    this->Check(this->Parts->CheckFingerprints(this->Fingerprint));
}

//------------------------------------------------------------------------------
/// Finds the blocks of the legs in the parts, and checks that they are of the same scene.
bool vtkHeliosSurveyPlayer::Internals::FindBlocks()
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
bool vtkHeliosSurveyPlayer::Internals::FindEarlierRun()
{
  vtkHeliosSurveyPlayer* player = this->Player;
  this->Folder = std::make_unique<helios::RunFolder>(this->Settings.Folder);
  this->Journal = std::make_unique<helios::RunJournal>(this->Settings.Folder);
  // Epochs after the current one of an interrupted run, and parts, may have no files yet.
  const bool isNext = (this->Settings.Options.Epoch > 0 || this->Settings.Part.IsSet()) &&
    !player->Overwrite && this->Folder->IsEmpty();
  this->Resumes = player->Resume && !isNext;
  helios::Status status = this->Folder->Prepare(player->Overwrite, this->Resumes);
  if (!status.IsOk())
  {
    return this->Fail(status.Message());
  }
  this->ReportStep("hashing the input files");
  this->Fingerprint = helios::MakeFingerprint(this->GetSurvey(), this->Settings);
  if (!this->Resumes)
  {
    return true;
  }
  if (player->Source->GetLoader().HasGivenScene()) // no file tells a change of it
  {
    if (!this->Load() || !this->Plan() || !this->HashScene())
    {
      return false;
    }
  }
  Json::Value summary;
  player->WasFinished =
    this->Settings.Part.IsSet() ? this->Folder->HasSummary() : !this->Journal->Exists();
  status = player->WasFinished ? this->Folder->ReadSummary(summary) : this->Journal->Continue();
  if (!status.IsOk())
  {
    return this->Fail(status.Message() +
      "; wait for the other run to end, or set Overwrite (--overwrite) to start again");
  }
  if (!player->WasFinished)
  {
    return this->CheckEarlierRun(this->Journal->GetFingerprint());
  }
  status = helios::RunCheck(this->Settings.Folder).CheckSummary(summary);
  if (!this->CheckFinishedRun(summary) || (!status.IsOk() && !this->Fail(status.Message())))
  {
    return false;
  }
  player->Report = helios::ToText(summary);
  return true;
}

//------------------------------------------------------------------------------
/// Checks what is known before the scene is loaded, and its files by the names that they had.
bool vtkHeliosSurveyPlayer::Internals::CheckEarlierRun(const Json::Value& then)
{
  Json::Value now = this->Fingerprint;
  if (!helios::IsOfLoadedSurvey(now))
  {
    helios::AddEarlierInputs(then["inputs"], now["inputs"]);
  }
  const std::string difference = helios::CompareFingerprints(then, now);
  return difference.empty() ||
    this->Fail(this->Settings.Folder + ": the run there cannot be resumed, since " + difference +
      "; use the same inputs and options, or set Overwrite (--overwrite) to start again");
}

//------------------------------------------------------------------------------
/// Loads the scene only if its files are not where they were.
bool vtkHeliosSurveyPlayer::Internals::CheckFinishedRun(const Json::Value& then)
{
  Json::Value inputs = this->Fingerprint["inputs"];
  const bool isKnown =
    helios::IsOfLoadedSurvey(this->Fingerprint) || helios::AddEarlierInputs(then["inputs"], inputs);
  return this->CheckEarlierRun(then) &&
    (isKnown || (this->Load() && this->Plan() && this->HashScene() && this->CheckEarlierRun(then)));
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::CheckEarlierFiles()
{
  const helios::RunCheck check(this->Settings.Folder);
  helios::Status status = check.CheckSizes(*this->Journal);
  if (status.IsOk())
  {
    status = check.CheckBlocks(*this->Journal, this->Player->BytesToCheck,
      [this] { return this->ReportStep("checking the files of the earlier run"); });
  }
  if (!status.IsOk())
  {
    return this->Fail(status.Message());
  }
  this->Player->Message = this->Player->AbortRequested ? "Stopped." : this->Player->Message;
  return !this->Player->AbortRequested;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Load()
{
  const auto start = std::chrono::steady_clock::now();
  const auto onStep = [this](const std::string& step) { return this->ReportStep(step); };
  const bool isLoaded = this->Player->Source->LoadScene(onStep, this->Settings);
  if (!isLoaded && !this->Log.HasError())
  {
    this->Player->Message = "Stopped while the scene was loaded; nothing was written.";
  }
  this->LoadSeconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return isLoaded || this->Fail();
}

//------------------------------------------------------------------------------
/// Completes the fingerprint of a loaded and planned survey.
bool vtkHeliosSurveyPlayer::Internals::HashScene()
{
  this->ReportStep("hashing the files of the scene");
  return this->Check(helios::AddLoadedSurvey(this->Player->Source->GetLoader(), *this->Runner,
    this->Settings, this->Fingerprint, this->Inputs));
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Plan()
{
  if (this->Runner)
  {
    return true; // to compare it with an earlier run
  }
  this->Runner = std::make_unique<helios::LegRunner>(
    this->GetSurvey(), this->GetScene(), this->Settings, this->Log);
  this->Runner->SetOnProgress([this](double) { return this->ReportStep(this->Player->Message); });
  if (!this->Runner->Plan())
  {
    return this->Fail();
  }
  this->Player->NumberOfPulses = this->Runner->GetNumberOfPulsesToRun();
  this->Player->Sampling = this->Runner->DescribeSampling();
  return this->Runner->GetNumberOfPulses() > 0 || this->Fail(helios::ExplainNoEchoes(*this->Runner));
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Begin()
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
  if (const helios::Status status = this->Folder->Clear(); !status.IsOk())
  {
    return this->Fail(status.Message());
  }
  const helios::Status status = this->Journal->Create(this->Fingerprint);
  return status.IsOk() || this->Fail(status.Message() + "; give another OutputDirectory");
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::RunLegs()
{
  const auto onBlock = [this](const helios::ScanCounts& counts) { return this->Count(counts); };
  for (const helios::LegPlan& plan : this->Runner->GetPlans())
  {
    this->Player->CurrentLeg = static_cast<int>(plan.Leg);
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
      this->Player->Message = (error.empty() ? "Stopped" : error + ". Ended") + kept;
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveyPlayer::Internals::DescribeKept() const
{
  helios::Sentence text;
  text << " after " << this->Player->Counts->Pulses << " of " << this->Player->NumberOfPulses
       << " pulses; ";
  if (!this->Folder->Exists() || !this->Journal->Check().IsOk())
  {
    text << "nothing is kept, since the folder " << this->Settings.Folder << " is gone"
         << (this->Folder->Exists() ? ", or was replaced by another one." : ".");
    return text.str();
  }
  text << "the " << this->Player->Counts->Echoes << " points so far are kept in "
       << this->Settings.Folder << ", those of the current leg in files that end in .part; "
       << "Resume (--resume) continues from there.";
  return text.str();
}

//------------------------------------------------------------------------------
/// Measures the accuracy of a run whose points are complete; on an abort, without it.
void vtkHeliosSurveyPlayer::Internals::MeasureAccuracy()
{
  if (!this->Settings.Options.AccuracyReport)
  {
    return;
  }
  const auto start = std::chrono::steady_clock::now();
  helios::RunAccuracy accuracy(*this->Runner, this->Settings, this->Log);
  accuracy.Measure([this](double) { return this->ReportStep("measuring the accuracy"); });
  this->Accuracy = accuracy.Describe();
  this->AccuracySeconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Conclude()
{
  const helios::ScanCounts& counts = this->Runner->GetCounts();
  this->SetCounts(counts);
  const bool isPart = this->Settings.Part.IsSet();
  if (counts.Echoes == 0 && !isPart)
  {
    return this->Fail(helios::ExplainNoEchoes(*this->Runner));
  }
  if (!isPart)
  {
    this->MeasureAccuracy();
  }
  Json::Value summary = helios::MakeSummary(this->Fingerprint, *this->Journal, *this->Runner,
    this->Accuracy, this->LoadSeconds, this->AccuracySeconds);
  if (this->Parts)
  {
    summary["timings"]["parts_s"] = this->Parts->GetSeconds();
  }
  const helios::Status status = this->Folder->WriteSummary(summary);
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
  this->Player->Report = helios::ToText(summary);
  helios::Sentence text;
  text << counts.Echoes << " points from " << counts.Pulses << " pulses "
       << (isPart ? "of part " + this->Settings.Part.GetText() + " " : "") << "are in "
       << this->Settings.Folder << ".";
  this->Player->Message = text.str();
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::ConcludeFinished()
{
  Json::Value summary;
  helios::FromText(this->Player->Report, summary);
  const helios::ScanCounts counts = helios::GetTotals(summary);
  this->Player->NumberOfPulses = counts.Pulses;
  this->Player->Sampling = summary["sampling"].asString();
  this->SetCounts(counts);
  helios::Sentence text;
  text << "Nothing is left to do: the run in " << this->Settings.Folder << " is finished, with "
       << counts.Echoes << " points from " << counts.Pulses << " pulses.";
  this->Player->Message = text.str();
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::ReportStep(const std::string& step)
{
  this->Player->Message = step;
  double progress = this->Player->Progress;
  this->Player->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  return !this->Player->AbortRequested;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::Internals::SetCounts(const helios::ScanCounts& counts)
{
  vtkHeliosSurveyPlayer* player = this->Player;
  *player->Counts = counts;
  player->Progress = player->NumberOfPulses > 0
    ? static_cast<double>(counts.Pulses) / static_cast<double>(player->NumberOfPulses)
    : 1.0; // a part without blocks
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Count(const helios::ScanCounts& counts)
{
  vtkHeliosSurveyPlayer* player = this->Player;
  this->SetCounts(counts);
  double progress = player->Progress;
  player->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  // After the last pulse the run is complete.
  return !player->AbortRequested || counts.Pulses == player->NumberOfPulses;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Check(const helios::Status& status)
{
  return status.IsOk() || this->Fail(status.Message());
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Fail(const std::string& text)
{
  this->Log.Error(text);
  return this->Fail();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Fail()
{
  const std::string& error = this->Log.GetLastError();
  this->Player->Message = error.empty() ? this->Player->Message : error;
  return false;
}

//------------------------------------------------------------------------------
/// Lets other ranks load the survey, too.
bool vtkHeliosSurveyPlayer::Internals::StartRanks()
{
  vtkHeliosRanks* ranks = this->Player->Ranks;
  if (!ranks || ranks->GetNumberOfRanks() < 2 || this->Parts)
  {
    return true;
  }
  this->RankSource = std::make_unique<helios::RankBlocks>(ranks,
    helios::LegFiles(this->GetSurvey(), helios::MakeRunPartSettings(this->Settings)), this->Log,
    [this] { return this->ReportStep(this->Player->Message); });
  return this->RankSource->Begin(this->Settings.Options.Epoch) || this->Fail();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Serve()
{
  vtkHeliosRanks* ranks = this->Player->Ranks;
  if (!ranks || ranks->GetRank() == 0)
  {
    return this->Fail("Serve() is for ranks above 0: set Ranks, and call Run() of rank 0.");
  }
  helios::RankServer server(ranks);
  const auto load = [this](int epoch)
  {
    helios::RankServer::Service service;
    service.Worker = this->LoadForRank(epoch) ? this->Worker.get() : nullptr;
    service.Fingerprint = helios::ToLine(this->Fingerprint);
    service.Error = this->Log.GetLastError();
    return service;
  };
  const helios::Status status = server.Serve(load, this->Player->AbortRequested);
  return status.IsOk() ? !this->Player->AbortRequested : this->Fail(status.Message());
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::LoadForRank(int epoch)
{
  this->Worker.reset();
  this->Runner.reset();
  this->Player->GetOptions()->SetEpoch(epoch);
  this->Settings = {};
  if (!this->CheckSettings())
  {
    return false;
  }
  this->Settings.Part = {}; // rank 0 says which blocks
  this->Fingerprint = helios::MakeFingerprint(this->GetSurvey(), this->Settings);
  if (!this->Load() || !this->Plan() || !this->HashScene())
  {
    return false;
  }
  this->Worker = std::make_unique<helios::RankWorker>(
    helios::LegFiles(this->GetSurvey(), helios::MakeRunPartSettings(this->Settings)), *this->Runner,
    this->Log);
  return true;
}

//------------------------------------------------------------------------------
vtkHeliosSurveyPlayer::vtkHeliosSurveyPlayer()
  : Source(vtkSmartPointer<vtkHeliosSurveySource>::New())
  , Counts(new helios::ScanCounts)
{
  this->Source->SetInstances(true);
  this->SetOutputDirectory("output");
  this->SetFormat("xyz");
}

//------------------------------------------------------------------------------
vtkHeliosSurveyPlayer::~vtkHeliosSurveyPlayer()
{
  this->SetOutputDirectory(nullptr);
  this->SetFormat(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::SetSource(vtkHeliosSurveySource* source)
{
  if (source && this->Source != source)
  {
    this->Source = source;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHeliosSurveySource* vtkHeliosSurveyPlayer::GetSource() const
{
  return this->Source;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::SetSurvey(vtkHeliosSurvey* survey)
{
  this->Source->SetSurvey(survey);
}

//------------------------------------------------------------------------------
vtkHeliosSurvey* vtkHeliosSurveyPlayer::GetSurvey() const
{
  return this->Source->GetSurvey();
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::SetOptions(vtkHeliosRunOptions* options)
{
  this->Source->SetOptions(options);
}

//------------------------------------------------------------------------------
vtkHeliosRunOptions* vtkHeliosSurveyPlayer::GetOptions() const
{
  return this->Source->GetOptions();
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosSurveyPlayer::GetCount(const std::string& name) const
{
  return helios::GetCount(*this->Counts, name);
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveyPlayer::GetRunFolder()
{
  vtkHeliosSurvey* survey = this->GetSurvey();
  if (!survey)
  {
    return {};
  }
  std::filesystem::path folder = TextOf(this->OutputDirectory);
  folder /= survey->GetName();
  if (survey->GetNumberOfEpochs() > 1)
  {
    folder /= vtkHeliosRunFiles::GetEpochName(this->GetOptions()->GetEpoch());
  }
  if (this->NumberOfParts > 0)
  {
    folder /= vtkHeliosRunFiles::GetPartName(this->Part, this->NumberOfParts);
  }
  return folder.string();
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::AddPartFolder(const std::string& folder)
{
  this->PartFolders.push_back(folder);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::ClearPartFolders()
{
  this->PartFolders.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkHeliosSurveyPlayer::GetNumberOfLegs() const
{
  return this->GetSurvey() ? this->GetSurvey()->GetNumberOfLegs() : 0;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::Reset()
{
  this->AbortRequested = false;
  this->WasFinished = false;
  this->Progress = 0.0;
  this->CurrentLeg = 0;
  this->NumberOfPulses = 0;
  *this->Counts = helios::ScanCounts();
  this->Sampling.clear();
  this->Message.clear();
  this->Report.clear();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Attempt(bool (Internals::*work)())
{
  this->Reset();
  this->InvokeEvent(vtkCommand::StartEvent);
  bool good = false;
  try
  {
    Internals internals(this);
    good = (internals.*work)();
  }
  catch (const std::exception& error) // library errors: out of memory, file system
  {
    this->Message = std::string("The run has failed: ") + error.what();
    vtkErrorMacro(<< this->Message);
  }
  this->InvokeEvent(vtkCommand::EndEvent);
  return good;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Run()
{
  return this->Attempt(&Internals::Run);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Estimate()
{
  return this->Attempt(&Internals::Estimate);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Serve()
{
  return this->Attempt(&Internals::Serve);
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::SetRanks(vtkHeliosRanks* ranks)
{
  if (this->Ranks != ranks)
  {
    this->Ranks = ranks;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHeliosRanks* vtkHeliosSurveyPlayer::GetRanks() const
{
  return this->Ranks;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "OutputDirectory: " << (this->OutputDirectory ? this->OutputDirectory : "(none)")
     << "\n"
     << indent << "Format: " << (this->Format ? this->Format : "(none)") << "\n";
  for (const auto& row : vtkHeliosEchoAlgorithm::GetOutputRows())
  {
    os << indent << row.FileProperty << ": " << this->Wanted.*row.Flag << "\n";
  }
  os << indent << "Overwrite: " << this->Overwrite << "\n"
     << indent << "Resume: " << this->Resume << "\n"
     << indent << "Part: " << this->Part << " of " << this->NumberOfParts << "\n"
     << indent << "PartCommand: " << this->PartCommand << "\n"
     << indent << "PartFolders: " << this->PartFolders.size() << "\n"
     << indent << "Ranks: " << (this->Ranks ? this->Ranks->GetNumberOfRanks() : 1) << "\n"
     << indent << "PulsesPerBlock: " << this->PulsesPerBlock << "\n"
     << indent << "BytesToCheck: " << this->BytesToCheck << "\n"
     << indent << "Progress: " << this->Progress << "\n"
     << indent << "Message: " << this->Message << "\n"
     << indent << "Source:\n";
  this->Source->PrintSelf(os, indent.GetNextIndent());
}
