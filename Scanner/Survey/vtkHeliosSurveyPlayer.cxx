// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurveyPlayer.h"

#include "heliosLegRunner.h"
#include "heliosMessages.h"
#include "heliosSceneBuilder.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosSurvey.h"

#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <regex>

vtkStandardNewMacro(vtkHeliosSurveyPlayer);

namespace fs = std::filesystem;

namespace
{

bool IsToleranceOrZero(double tolerance, double least)
{
  return tolerance == 0.0 || (tolerance >= least && tolerance <= 1.0);
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
  }

  /// Runs the survey and says how it ended.
  bool Run();

private:
  bool CheckSettings();
  bool ChooseReceiver();
  bool ChooseRayCaster();
  bool CheckFolder();
  bool ClearFolder();
  bool Load();
  bool RunLegs(helios::LegRunner& runner);
  bool Conclude(const helios::LegRunner& runner);
  bool Tell(const std::string& step);
  bool Count(const helios::RunCounts& counts);
  bool Fail(const std::string& text);
  bool Fail();
  std::string DescribeKept() const;

  /// The files of earlier runs of this survey.
  std::vector<fs::path> FindLegFiles() const;

  vtkHeliosSurveyPlayer* Player;
  helios::Messages Log;
  helios::RunSettings Settings;
  vtkSmartPointer<vtkPolyData> Scene;
};

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Run()
{
  if (!this->CheckSettings() || !this->CheckFolder() || !this->Load())
  {
    return this->Fail();
  }
  helios::LegRunner runner(this->Player->Survey->GetData(), this->Scene, this->Settings, this->Log);
  if (!runner.Plan())
  {
    return this->Fail();
  }
  this->Player->NumberOfPulses = runner.GetNumberOfPulses();
  this->Player->Sampling = runner.DescribeSampling();
  if (this->Player->NumberOfPulses == 0)
  {
    return this->Fail(runner.ExplainNoEchoes());
  }
  return this->ClearFolder() && this->RunLegs(runner) && this->Conclude(runner);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::CheckSettings()
{
  const vtkHeliosSurveyPlayer* player = this->Player;
  if (!player->Survey || player->Survey->GetNumberOfLegs() == 0)
  {
    return this->Fail(
      "Survey is not set or has no legs; give the survey of a vtkHeliosSurveyReader.");
  }
  const std::string format = player->Format ? player->Format : "";
  if (format != "xyz" && format != "vtp")
  {
    return this->Fail("Format is \"" + format + "\"; give xyz or vtp.");
  }
  const std::string output = player->OutputDirectory ? player->OutputDirectory : "";
  this->Settings.Folder = (fs::path(output) / player->Survey->GetName()).string();
  this->Settings.Format = format;
  this->Settings.Scan.Seed = player->Seed;
  this->Settings.Scan.Receiver.Noise = player->Noise;
  this->Settings.Scan.Waveforms = player->WriteWaveforms;
  this->Settings.PulsesPerBlock = player->PulsesPerBlock;
  return this->ChooseReceiver() && this->ChooseRayCaster();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::ChooseReceiver()
{
  const vtkHeliosSurveyPlayer* player = this->Player;
  helios::Sentence fault;
  if (!IsToleranceOrZero(player->RangeTolerance, 1e-6))
  {
    fault << "RangeTolerance is " << player->RangeTolerance
          << "; give 0.000001 to 1 m, or 0: as the survey says";
  }
  else if (!IsToleranceOrZero(player->EnergyTolerance, 1e-4))
  {
    fault << "EnergyTolerance is " << player->EnergyTolerance
          << "; give 0.0001 to 1, or 0: as the survey says";
  }
  else if (player->NumberOfSubRays > 0 &&
    (player->RangeTolerance > 0.0 || player->EnergyTolerance > 0.0))
  {
    fault << "NumberOfSubRays is " << player->NumberOfSubRays
          << " beside a tolerance, which would choose it; set one of them to 0";
  }
  const std::string detector = player->EchoDetector ? player->EchoDetector : "";
  const std::vector<std::string> known = helios::GetEchoDetectorNames();
  if (!detector.empty() && std::find(known.begin(), known.end(), detector) == known.end())
  {
    fault << "EchoDetector is \"" << detector << "\"; give " << helios::Enumerate(known);
  }
  if (!fault.str().empty())
  {
    return this->Fail(fault.str());
  }
  this->Settings.Scan.Receiver.RangeTolerance = player->RangeTolerance;
  this->Settings.Scan.Receiver.EnergyTolerance = player->EnergyTolerance;
  this->Settings.Scan.Receiver.NumberOfSubRays = player->NumberOfSubRays;
  this->Settings.Scan.Receiver.EchoDetector = detector;
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::ChooseRayCaster()
{
  const helios::SurveyData& survey = this->Player->Survey->GetData();
  const std::string given = this->Player->RayCaster ? this->Player->RayCaster : "";
  const std::string name = given.empty() ? survey.RayCaster : given;
  if (name.empty())
  {
    return true;
  }
  std::vector<std::string> names;
  for (int i = 0; i < vtkHeliosRayCaster::GetNumberOfBackends(); ++i)
  {
    names.emplace_back(vtkHeliosRayCaster::GetBackendName(i));
  }
  if (std::find(names.begin(), names.end(), name) == names.end())
  {
    return this->Fail((given.empty() ? survey.FileName + ": rayCaster" : "RayCaster") + "=\"" +
      name + "\" is not in this build; give one of " + helios::Enumerate(names));
  }
  this->Settings.Scan.RayCaster =
    vtkSmartPointer<vtkHeliosRayCaster>::Take(vtkHeliosRayCaster::Create(name.c_str()));
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::CheckFolder()
{
  const std::string& folder = this->Settings.Folder;
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem || !fs::is_directory(folder, problem))
  {
    return this->Fail(folder + ": the output folder cannot be made: " +
      (problem ? problem.message() : "there is a file of that name") +
      "; give another OutputDirectory");
  }
  if (!this->Player->Overwrite && !this->FindLegFiles().empty())
  {
    return this->Fail(folder +
      ": holds the files of an earlier run, which are kept; set Overwrite "
      "(--overwrite) to replace them, or give another OutputDirectory");
  }
  return true;
}

//------------------------------------------------------------------------------
std::vector<fs::path> vtkHeliosSurveyPlayer::Internals::FindLegFiles() const
{
  const std::regex pattern(helios::LegRunner::GetFilePattern());
  std::vector<fs::path> files;
  std::error_code ignored;
  fs::directory_iterator entry(this->Settings.Folder, ignored);
  for (; entry != fs::directory_iterator(); entry.increment(ignored))
  {
    if (std::regex_match(entry->path().filename().string(), pattern))
    {
      files.push_back(entry->path());
    }
  }
  return files;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::ClearFolder()
{
  for (const fs::path& file : this->FindLegFiles())
  {
    std::error_code problem;
    fs::remove_all(file, problem);
    if (problem)
    {
      return this->Fail(file.string() + ": cannot be replaced: " + problem.message());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Load()
{
  const helios::SurveyData& survey = this->Player->Survey->GetData();
  helios::SceneBuilder builder(survey.Scene, this->Log, this->Settings.Scan.Seed);
  const auto onStep = [this](const std::string& step) { return this->Tell(step); };
  this->Scene = builder.Build(onStep);
  this->Settings.Scan.Grids =
    this->Scene ? builder.GetGrids() : std::vector<vtkSmartPointer<vtkImageData>>();
  if (!this->Scene && !this->Log.HasError())
  {
    this->Player->Message = "Stopped while the scene was loaded; nothing was written.";
  }
  return this->Scene != nullptr;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::RunLegs(helios::LegRunner& runner)
{
  const auto onBlock = [this](const helios::RunCounts& counts) { return this->Count(counts); };
  for (const helios::LegPlan& plan : runner.GetPlans())
  {
    this->Player->CurrentLeg = static_cast<int>(plan.Leg);
    if (!this->Tell("running leg " + std::to_string(plan.Leg)) || !runner.Run(plan, onBlock))
    {
      const std::string error = this->Log.GetLastError();
      this->Player->Message =
        (error.empty() ? "Stopped" : error + ". Ended") + this->DescribeKept();
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveyPlayer::Internals::DescribeKept() const
{
  helios::Sentence text;
  text << " after " << this->Player->NumberOfPulsesDone << " of " << this->Player->NumberOfPulses
       << " pulses; the " << this->Player->NumberOfEchoes << " points so far are kept in "
       << this->Settings.Folder << ", those of the leg at work in files that end in .part.";
  return text.str();
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Conclude(const helios::LegRunner& runner)
{
  const helios::RunCounts& counts = runner.GetCounts();
  if (counts.Echoes == 0)
  {
    return this->Fail(runner.ExplainNoEchoes());
  }
  helios::Sentence text;
  text << counts.Echoes << " points of " << counts.Pulses << " pulses are in "
       << this->Settings.Folder << ".";
  this->Player->Message = text.str();
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Tell(const std::string& step)
{
  this->Player->Message = step;
  double progress = this->Player->Progress;
  this->Player->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  return !this->Player->AbortRequested;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Internals::Count(const helios::RunCounts& counts)
{
  vtkHeliosSurveyPlayer* player = this->Player;
  player->NumberOfPulsesDone = counts.Pulses;
  player->NumberOfPulsesFired = counts.PulsesFired;
  player->NumberOfEchoes = counts.Echoes;
  player->NumberOfFirstReturns = counts.FirstReturns;
  player->NumberOfPulsesOnPlane = counts.PulsesOnPlane;
  player->NumberOfPulsesWithoutBins = counts.PulsesWithoutBins;
  player->NumberOfPulsesBinned = counts.PulsesBinned;
  player->NumberOfSubRaysTraced = counts.SubRays;
  player->Progress =
    static_cast<double>(counts.Pulses) / static_cast<double>(player->NumberOfPulses);
  double progress = player->Progress;
  player->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  // After the last pulse there is nothing left to end.
  return !player->AbortRequested || counts.Pulses == player->NumberOfPulses;
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
vtkHeliosSurveyPlayer::vtkHeliosSurveyPlayer()
{
  this->SetOutputDirectory("output");
  this->SetFormat("xyz");
}

//------------------------------------------------------------------------------
vtkHeliosSurveyPlayer::~vtkHeliosSurveyPlayer()
{
  this->SetOutputDirectory(nullptr);
  this->SetFormat(nullptr);
  this->SetRayCaster(nullptr);
  this->SetEchoDetector(nullptr);
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::SetSurvey(vtkHeliosSurvey* survey)
{
  if (this->Survey != survey)
  {
    this->Survey = survey;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHeliosSurvey* vtkHeliosSurveyPlayer::GetSurvey() const
{
  return this->Survey;
}

//------------------------------------------------------------------------------
int vtkHeliosSurveyPlayer::GetNumberOfLegs() const
{
  return this->Survey ? this->Survey->GetNumberOfLegs() : 0;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveyPlayer::Run()
{
  this->AbortRequested = false;
  this->Progress = 0.0;
  this->CurrentLeg = 0;
  this->NumberOfPulses = 0;
  this->NumberOfPulsesDone = 0;
  this->NumberOfPulsesFired = 0;
  this->NumberOfEchoes = 0;
  this->NumberOfFirstReturns = 0;
  this->NumberOfPulsesOnPlane = 0;
  this->NumberOfPulsesWithoutBins = 0;
  this->NumberOfPulsesBinned = 0;
  this->NumberOfSubRaysTraced = 0;
  this->Sampling.clear();
  this->Message.clear();
  this->InvokeEvent(vtkCommand::StartEvent);
  bool good = false;
  try
  {
    good = Internals(this).Run();
  }
  catch (const std::exception& error) // the standard library's: no memory, a broken file system
  {
    this->Message = std::string("The run has failed: ") + error.what();
    vtkErrorMacro(<< this->Message);
  }
  this->InvokeEvent(vtkCommand::EndEvent);
  return good;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveyPlayer::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Survey: " << (this->Survey ? this->Survey->GetName() : "(none)") << "\n"
     << indent << "OutputDirectory: " << (this->OutputDirectory ? this->OutputDirectory : "(none)")
     << "\n"
     << indent << "Format: " << (this->Format ? this->Format : "(none)") << "\n"
     << indent << "RayCaster: " << (this->RayCaster ? this->RayCaster : "(none)") << "\n"
     << indent << "RangeTolerance: " << this->RangeTolerance << "\n"
     << indent << "EnergyTolerance: " << this->EnergyTolerance << "\n"
     << indent << "NumberOfSubRays: " << this->NumberOfSubRays << "\n"
     << indent << "EchoDetector: " << (this->EchoDetector ? this->EchoDetector : "(none)") << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "Noise: " << this->Noise << "\n"
     << indent << "WriteWaveforms: " << this->WriteWaveforms << "\n"
     << indent << "Overwrite: " << this->Overwrite << "\n"
     << indent << "PulsesPerBlock: " << this->PulsesPerBlock << "\n"
     << indent << "Progress: " << this->Progress << "\n"
     << indent << "Message: " << this->Message << "\n";
}
