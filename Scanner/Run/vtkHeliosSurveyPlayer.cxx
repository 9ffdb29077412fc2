// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurveyPlayer.h"

#include "heliosMessages.h"
#include "heliosSurveyLoader.h"
#include "heliosSurveyRun.h"
#include "vtkHeliosRanks.h"
#include "vtkHeliosRunFiles.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveySource.h"

#include <vtkCommand.h>
#include <vtkObjectFactory.h>

#include <exception>
#include <filesystem>
#include <functional>
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

/// A player as the owner of its run.
class PlayerRun : public helios::RunOwner
{
public:
  explicit PlayerRun(vtkHeliosSurveyPlayer* player)
    : Player(player)
  {
  }

  bool CheckOptions(helios::RunSettings& settings) override
  {
    return this->Player->GetSource()->CheckOptions(settings);
  }

  bool LoadScene(const std::function<bool(const std::string& step)>& onStep,
    helios::RunSettings& settings) override
  {
    return this->Player->GetSource()->LoadScene(onStep, settings);
  }

  const helios::SurveyLoader& GetLoader() const override
  {
    return this->Player->GetSource()->GetLoader();
  }

  void SetEpoch(int epoch) override { this->Player->GetOptions()->SetEpoch(epoch); }
  std::string GetRunFolder() override { return this->Player->GetRunFolder(); }

  void ReportProgress() override
  {
    double progress = this->Player->GetProgress();
    this->Player->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  }

private:
  vtkHeliosSurveyPlayer* Player;
};

} // namespace

//------------------------------------------------------------------------------
vtkHeliosSurveyPlayer::vtkHeliosSurveyPlayer()
  : Source(vtkSmartPointer<vtkHeliosSurveySource>::New())
  , State(new helios::RunState)
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
double vtkHeliosSurveyPlayer::GetProgress() const
{
  return this->State->Progress;
}

//------------------------------------------------------------------------------
int vtkHeliosSurveyPlayer::GetCurrentLeg() const
{
  return this->State->CurrentLeg;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::GetWasFinished() const
{
  return this->State->WasFinished;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosSurveyPlayer::GetNumberOfPulses() const
{
  return this->State->NumberOfPulses;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveyPlayer::GetMessage() const
{
  return this->State->Message;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveyPlayer::GetReport() const
{
  return this->State->Report;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveyPlayer::GetForecastReport() const
{
  return this->State->Forecast;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveyPlayer::GetSampling() const
{
  return this->State->Sampling;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosSurveyPlayer::GetCount(const std::string& name) const
{
  return helios::GetCount(this->State->Counts, name);
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
    folder = vtkHeliosRunFiles::FindEpoch(folder.string(), this->GetOptions()->GetEpoch());
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
bool vtkHeliosSurveyPlayer::Attempt(bool (helios::SurveyRun::*work)())
{
  this->AbortRequested = false;
  *this->State = {};
  this->InvokeEvent(vtkCommand::StartEvent);
  bool good = false;
  try
  {
    PlayerRun owner(this);
    helios::Messages log(this);
    log.Listen(this->Source);
    const helios::RunRequest request{ TextOf(this->Format), this->Wanted, this->Overwrite,
      this->Resume, this->PulsesPerBlock, this->BytesToCheck, this->Part, this->NumberOfParts,
      this->PartCommand, this->PartFolders, this->Ranks, this->Forecast };
    helios::SurveyRun run(owner, request, this->AbortRequested, *this->State, log);
    good = (run.*work)();
  }
  catch (const std::exception& error) // library errors: out of memory, file system
  {
    this->State->Message = std::string("The run has failed: ") + error.what();
    vtkErrorMacro(<< this->State->Message);
  }
  this->InvokeEvent(vtkCommand::EndEvent);
  return good;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Run()
{
  return this->Attempt(&helios::SurveyRun::Run);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Estimate()
{
  return this->Attempt(&helios::SurveyRun::Estimate);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Serve()
{
  return this->Attempt(&helios::SurveyRun::Serve);
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
     << indent << "Forecast: " << this->Forecast << "\n"
     << indent << "PulsesPerBlock: " << this->PulsesPerBlock << "\n"
     << indent << "BytesToCheck: " << this->BytesToCheck << "\n"
     << indent << "Progress: " << this->State->Progress << "\n"
     << indent << "Message: " << this->State->Message << "\n"
     << indent << "Source:\n";
  this->Source->PrintSelf(os, indent.GetNextIndent());
}
