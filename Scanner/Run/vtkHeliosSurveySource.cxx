// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosSurveySource.h"

#include "heliosEchoComparison.h"
#include "heliosLegOutput.h"
#include "heliosLegScanner.h"
#include "heliosLoadedSurvey.h"
#include "heliosMessages.h"
#include "heliosPathCell.h"
#include "heliosPulseCount.h"
#include "heliosReceiverSetup.h"
#include "heliosRunFingerprint.h"
#include "heliosRunProgress.h"
#include "vtkHeliosEchoComparison.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosRunOptions.h"
#include "vtkHeliosScanner.h"
#include "vtkHeliosSurvey.h"

#include <vtkAlgorithmOutput.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <exception>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkHeliosSurveySource);

namespace
{

constexpr int ScenePort = 0; // inputs
constexpr int GridPort = 1;
constexpr int TrajectoryPort = 2;
constexpr int MeshPort = 3;

} // namespace

class vtkHeliosSurveySource::Internals
{
public:
  explicit Internals(vtkHeliosSurveySource* source)
    : Source(source)
    , Log(source)
    , Survey(this->Log)
  {
  }

  bool CheckOptions(helios::RunSettings& settings);

  /// Loads all changes and plans the legs; false after an error or an abort.
  bool Prepare();

  helios::Messages& GetLog() { return this->Log; }

  /// Computes the fingerprint of the prepared run, as JSON.
  helios::Status ComputeFingerprint(std::string& text);

  /// Runs a pulse window into the outputs; false after an error.
  bool Run(vtkIdType first, vtkIdType last, vtkInformationVector* outputs);

private:
  vtkHeliosSurveySource* Source;
  helios::Messages Log;

public:
  helios::LoadedSurvey Survey;

private:
  bool CheckSurvey();
  helios::RunInputs GetInputs() const;
  bool ReportProgress(double progress);

  vtkWeakPointer<vtkHeliosSurvey> Observed;
  std::string Fingerprint;
  vtkMTimeType FingerprintTime = 0; // when its legs were planned
};

//------------------------------------------------------------------------------
/// Checks what was changed by the methods of a survey, and reports its messages.
bool vtkHeliosSurveySource::Internals::CheckSurvey()
{
  vtkHeliosSurvey* survey = this->Source->Survey;
  if (survey && this->Observed != survey)
  {
    this->Observed = survey;
    this->Log.Listen(survey);
  }
  return !survey || survey->GetNumberOfLegs() == 0 || survey->Check();
}

//------------------------------------------------------------------------------
helios::RunInputs vtkHeliosSurveySource::Internals::GetInputs() const
{
  vtkHeliosSurveySource* source = this->Source;
  helios::RunInputs inputs;
  inputs.Options = source->Options->GetData();
  if (source->Survey)
  {
    inputs.Survey = &source->Survey->GetData();
    inputs.SurveyTime = source->Survey->GetMTime();
  }
  inputs.Scene = source->GetInputDataObject(ScenePort, 0);
  for (int i = 0; i < source->GetNumberOfInputConnections(GridPort); ++i)
  {
    if (auto* grid = vtkImageData::SafeDownCast(source->GetInputDataObject(GridPort, i)))
    {
      inputs.Grids.push_back(grid);
    }
  }
  inputs.Instances = source->Instances;
  inputs.Mesh = vtkPolyData::SafeDownCast(source->GetInputDataObject(MeshPort, 0));
  for (int i = 0; i < source->GetNumberOfInputConnections(TrajectoryPort); ++i)
  {
    if (auto* data = vtkPolyData::SafeDownCast(source->GetInputDataObject(TrajectoryPort, i)))
    {
      inputs.Trajectories.push_back(data);
    }
  }
  return inputs;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveySource::Internals::CheckOptions(helios::RunSettings& settings)
{
  if (!this->CheckSurvey())
  {
    return false;
  }
  helios::RunInputs inputs = this->GetInputs();
  inputs.Colors = settings.Wants.Colors;
  return this->Survey.GetLoader().Check(inputs, settings);
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveySource::Internals::Prepare()
{
  helios::RunSettings settings;
  settings.Wants = this->Source->Wanted;
  const auto onStep = [this](const std::string&) { return this->ReportProgress(0.0); };
  return this->CheckOptions(settings) && this->Survey.GetLoader().Load(onStep, settings) &&
    this->Survey.Plan(settings);
}

//------------------------------------------------------------------------------
helios::Status vtkHeliosSurveySource::Internals::ComputeFingerprint(std::string& text)
{
  const vtkMTimeType time = this->Survey.GetPlanTime();
  helios::Status status;
  if (time != this->FingerprintTime)
  {
    helios::SurveyLoader& loader = this->Survey.GetLoader();
    Json::Value fingerprint =
      helios::MakeFingerprint(loader.GetSurvey(), this->Survey.GetSettings());
    helios::InputFiles inputs;
    status = helios::AddLoadedSurvey(
      loader, *this->Survey.GetLegs(), this->Survey.GetSettings(), fingerprint, inputs);
    this->Fingerprint = helios::ToLine(fingerprint);
    this->FingerprintTime = status.IsOk() ? time : 0;
  }
  text = status.IsOk() ? this->Fingerprint : std::string();
  return status;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveySource::Internals::Run(
  vtkIdType first, vtkIdType last, vtkInformationVector* outputs)
{
  helios::LoadedSurvey::Piles piles;
  const auto onProgress = [this](double share) { return this->ReportProgress(share); };
  if (!this->Survey.Run(first, last, onProgress, piles))
  {
    return !this->Log.HasError();
  }
  for (std::size_t port = 0; port < piles.size(); ++port)
  {
    if (piles[port].Get())
    {
      vtkDataObject::GetData(outputs, static_cast<int>(port))->ShallowCopy(piles[port].Get());
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveySource::Internals::ReportProgress(double progress)
{
  this->Source->UpdateProgress(progress);
  return !this->Source->AbortRequested && !this->Source->GetAbortExecute();
}

//------------------------------------------------------------------------------
vtkHeliosSurveySource::vtkHeliosSurveySource()
{
  this->Options = vtkSmartPointer<vtkHeliosRunOptions>::New();
  this->SetNumberOfInputPorts(4);
}

//------------------------------------------------------------------------------
vtkHeliosSurveySource::~vtkHeliosSurveySource() = default;

//------------------------------------------------------------------------------
void vtkHeliosSurveySource::SetSurvey(vtkHeliosSurvey* survey)
{
  if (this->Survey != survey)
  {
    this->Survey = survey;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHeliosSurvey* vtkHeliosSurveySource::GetSurvey() const
{
  return this->Survey;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveySource::SetOptions(vtkHeliosRunOptions* options)
{
  if (options && this->Options != options)
  {
    this->Options = options;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHeliosRunOptions* vtkHeliosSurveySource::GetOptions() const
{
  return this->Options;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkHeliosSurveySource::GetMTime()
{
  const vtkMTimeType own = std::max(this->Superclass::GetMTime(), this->Options->GetMTime());
  return this->Survey ? std::max(own, this->Survey->GetMTime()) : own;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveySource::Load()
{
  this->AbortRequested = false;
  this->UpdateInputs();
  return this->Prepare();
}

//------------------------------------------------------------------------------
void vtkHeliosSurveySource::UpdateInputs()
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
    {
      vtkAlgorithmOutput* input = this->GetInputConnection(port, i);
      input->GetProducer()->Update(input->GetIndex());
    }
  }
}

//------------------------------------------------------------------------------
vtkHeliosSurveySource::Internals& vtkHeliosSurveySource::GetInternals()
{
  if (!this->Loaded)
  {
    this->Loaded = std::make_unique<Internals>(this);
  }
  return *this->Loaded;
}

//------------------------------------------------------------------------------
/// Returns the legs; null before they are planned.
helios::LegRunner* vtkHeliosSurveySource::GetLegs() const
{
  return this->Loaded ? this->Loaded->Survey.GetLegs() : nullptr;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosScanner> vtkHeliosSurveySource::MakeScanner() const
{
  const helios::LegPlan* plan = this->Loaded ? this->Loaded->Survey.FindLeg(0) : nullptr;
  if (!plan)
  {
    return nullptr;
  }
  helios::RunSettings settings = this->Loaded->Survey.GetSettings();
  settings.RayCaster = settings.RayCaster
    ? vtkSmartPointer<vtkHeliosRayCaster>::Take(settings.RayCaster->NewInstance())
    : nullptr;
  helios::LegScanner legs(
    this->GetLoader().GetSurvey(), this->GetLoader().GetScene(), settings, this->Loaded->GetLog());
  legs.SetUp(*plan);
  return legs.GetNumberOfChannels() == 1 ? legs.ReleaseChannel(0) : nullptr;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveySource::CheckOptions(helios::RunSettings& settings)
{
  this->UpdateInputs();
  const bool isGood = this->GetInternals().CheckOptions(settings);
  if (!isGood)
  {
    this->Loaded.reset();
  }
  return isGood;
}

//------------------------------------------------------------------------------
bool vtkHeliosSurveySource::LoadScene(
  const std::function<bool(const std::string& step)>& onStep, helios::RunSettings& settings)
{
  const bool isGood = this->GetInternals().Survey.GetLoader().Load(onStep, settings);
  if (!isGood)
  {
    this->Loaded.reset();
  }
  return isGood;
}

//------------------------------------------------------------------------------
const helios::SurveyLoader& vtkHeliosSurveySource::GetLoader() const
{
  return this->Loaded->Survey.GetLoader();
}

//------------------------------------------------------------------------------
/// Discards loaded data after an error.
bool vtkHeliosSurveySource::Prepare()
{
  bool isGood = false;
  try
  {
    isGood = this->GetInternals().Prepare();
  }
  catch (const std::exception& error) // library errors: out of memory
  {
    vtkErrorMacro("The survey cannot be loaded: " << error.what());
  }
  if (!isGood)
  {
    this->Loaded.reset();
  }
  return isGood;
}

//------------------------------------------------------------------------------
vtkPolyData* vtkHeliosSurveySource::GetScene() const
{
  return this->Loaded ? this->GetLoader().GetScene() : nullptr;
}

//------------------------------------------------------------------------------
vtkImageData* vtkHeliosSurveySource::GetGrid(int grid) const
{
  const auto index = static_cast<std::size_t>(grid);
  const bool exists = this->Loaded && index < this->GetLoader().GetGrids().size();
  return exists ? this->GetLoader().GetGrids()[index].Get() : nullptr;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosSurveySource::GetNumberOfPulses() const
{
  helios::LegRunner* legs = this->GetLegs();
  return legs ? legs->GetNumberOfPulses() : 0;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveySource::GetLegPulses(int leg, vtkIdType ids[2]) const
{
  const helios::LegPlan* plan = this->Loaded ? this->Loaded->Survey.FindLeg(leg) : nullptr;
  ids[0] = plan ? plan->FirstPulse : 0;
  ids[1] = plan ? plan->FirstPulse + plan->NumberOfPulses : 0;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveySource::GetLegTimes(int leg, double times[2]) const
{
  const helios::LegPlan* plan = this->Loaded ? this->Loaded->Survey.FindLeg(leg) : nullptr;
  times[0] = plan ? plan->StartTime : 0.0;
  times[1] = plan ? plan->StartTime + plan->Duration : 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosSurveySource::GetLegPulseLength(int leg) const
{
  const helios::LegPlan* plan = this->Loaded ? this->Loaded->Survey.FindLeg(leg) : nullptr;
  return plan ? this->GetLoader().GetSurvey().GetScanner(plan->Leg).Receiver.PulseLength : 0.0;
}

//------------------------------------------------------------------------------
double vtkHeliosSurveySource::GetPulseTime(vtkIdType pulse) const
{
  const helios::LegPlan* plan = this->Loaded ? this->Loaded->Survey.FindPulse(pulse) : nullptr;
  return plan ? this->Loaded->Survey.GetPulseTime(*plan, pulse) : 0.0;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosSurveySource::FindPulse(double time) const
{
  helios::LegRunner* legs = this->GetLegs();
  if (!legs)
  {
    return 0;
  }
  for (const helios::LegPlan& plan : legs->GetPlans())
  {
    if (time < plan.StartTime + plan.Duration)
    {
      return this->Loaded->Survey.GetPulse(plan, time);
    }
  }
  return this->GetNumberOfPulses();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkHeliosSurveySource::GetTrajectory(int leg, double interval) const
{
  const helios::LegPlan* plan = this->Loaded ? this->Loaded->Survey.FindLeg(leg) : nullptr;
  if (!plan)
  {
    return nullptr;
  }
  const helios::TrajectorySampler sampler(*plan, std::max(0.0, interval));
  const auto trajectory = sampler.GetSamples(0, sampler.GetNumberOfSamples());
  helios::AddPathCell(trajectory);
  return trajectory;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveySource::SetUpComparison(vtkHeliosEchoComparison* comparison, int leg) const
{
  const helios::LegPlan* plan = this->Loaded ? this->Loaded->Survey.FindLeg(leg) : nullptr;
  if (comparison && plan)
  {
    const helios::EchoMatching matching =
      helios::MakeMatching(this->GetLoader().GetSurvey().GetScanner(plan->Leg).Receiver, 0.0);
    comparison->SetMatchingDistance(matching.Distance);
    comparison->SetFullAmplitude(matching.FullAmplitude);
    comparison->SetExtinction(matching.Extinction);
    comparison->SetLeastShare(matching.LeastShare);
    comparison->SetLeastAmplitude(matching.LeastAmplitude);
  }
}

//------------------------------------------------------------------------------
double vtkHeliosSurveySource::GetSceneSize() const
{
  helios::LegRunner* legs = this->GetLegs();
  return legs ? legs->GetSceneSize() : 0.0;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveySource::DescribeSampling()
{
  helios::LegRunner* legs = this->GetLegs();
  return legs ? legs->DescribeSampling() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveySource::GetFingerprint()
{
  helios::RunSettings settings;
  settings.Wants.Colors = this->Wanted.Colors; // part of what is loaded
  return this->CheckOptions(settings)
    ? helios::ToLine(helios::MakeFingerprint(this->GetLoader().GetSurvey(), settings))
    : std::string();
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveySource::ComputeLoadedFingerprint()
{
  std::string text;
  const helios::Status status =
    this->Load() ? this->Loaded->ComputeFingerprint(text) : helios::Status();
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
  }
  return text;
}

//------------------------------------------------------------------------------
std::string vtkHeliosSurveySource::CompareFingerprint(const std::string& other)
{
  Json::Value now;
  Json::Value then;
  try
  {
    const bool isValid = helios::FromText(other, then);
    const bool isLoaded = isValid && helios::IsOfLoadedSurvey(then);
    if (!helios::FromText(
          isLoaded ? this->ComputeLoadedFingerprint() : this->GetFingerprint(), now))
    {
      return "the survey is not valid";
    }
    return isValid ? helios::CompareFingerprints(then, now) : "the other fingerprint is not valid";
  }
  catch (const std::exception& error) // a member of another type
  {
    return std::string("the other fingerprint is not valid: ") + error.what();
  }
}

//------------------------------------------------------------------------------
int vtkHeliosSurveySource::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(INPUT_IS_OPTIONAL(), 1);
  if (port != ScenePort)
  {
    const bool isGrid = port == GridPort;
    info->Set(INPUT_REQUIRED_DATA_TYPE(), isGrid ? "vtkImageData" : "vtkPolyData");
    info->Set(INPUT_IS_REPEATABLE(), port == MeshPort ? 0 : 1);
    return 1;
  }
  info->Remove(INPUT_REQUIRED_DATA_TYPE());
  info->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

//------------------------------------------------------------------------------
/// Requests the whole scene for a piece of the pulses.
int vtkHeliosSurveySource::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputs[port]->GetInformationObject(i);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosSurveySource::RequestData(
  vtkInformation* request, vtkInformationVector**, vtkInformationVector* outputs)
{
  this->AbortRequested = false;
  if (this->PulseWindow[0] < 0 || this->PulseWindow[1] < this->PulseWindow[0])
  {
    vtkErrorMacro("PulseWindow is [" << this->PulseWindow[0] << ", " << this->PulseWindow[1]
                                     << "); give 0 <= i0 <= i1");
    return 0;
  }
  if (!this->Prepare())
  {
    return this->AbortRequested || this->GetAbortExecute() ? 1 : 0;
  }
  const int from = std::max(0, request->Get(vtkExecutive::FROM_OUTPUT_PORT()));
  vtkInformation* info = outputs->GetInformationObject(from);
  const int piece = info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER());
  const int pieces =
    std::max(1, info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES()));
  const vtkIdType end = std::min(this->PulseWindow[1], this->GetNumberOfPulses());
  const vtkIdType begin = std::min(this->PulseWindow[0], end);
  const vtkIdType first = begin + helios::SplitPulses(end - begin, piece, pieces);
  const vtkIdType last = begin + helios::SplitPulses(end - begin, piece + 1, pieces);
  try
  {
    if (this->Loaded->Run(first, last, outputs))
    {
      return 1;
    }
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("The survey cannot be run: " << error.what());
  }
  this->Loaded.reset();
  return 0;
}

//------------------------------------------------------------------------------
void vtkHeliosSurveySource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Survey: " << (this->Survey ? this->Survey->GetName() : "(none)") << "\n"
     << indent << "Instances: " << this->Instances << "\n"
     << indent << "PulseWindow: " << this->PulseWindow[0] << ", " << this->PulseWindow[1] << "\n"
     << indent << "Options:\n";
  this->Options->PrintSelf(os, indent.GetNextIndent());
}
