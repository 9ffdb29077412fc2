// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLegScanner.h"

#include "heliosChannelMerge.h"
#include "heliosConstants.h"
#include "heliosLegOptics.h"
#include "heliosMakePlatform.h"
#include "heliosMessages.h"
#include "heliosReceiverSetup.h"
#include "heliosScanCounts.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosEchoDetector.h"
#include "vtkHeliosGpsTime.h"
#include "vtkHeliosPlatform.h"
#include "vtkHeliosPlatformNoise.h"
#include "vtkHeliosRayCaster.h"
#include "vtkHeliosScanner.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace helios
{
namespace names = vtkHeliosArrayNames;

namespace
{

constexpr vtkIdType AllPulses = VTK_ID_MAX;
constexpr auto None = static_cast<std::size_t>(-1);

void SetPose(const Pose& pose, double position[3], double orientation[4])
{
  std::copy_n(pose.Position.GetData(), 3, position);
  std::copy_n(pose.Orientation.GetData(), 4, orientation);
}

} // namespace

//------------------------------------------------------------------------------
LegScanner::LegScanner(
  const SurveyData& survey, vtkPolyData* scene, const RunSettings& settings, Messages& log)
  : Survey(survey)
  , Settings(settings)
  , Log(log)
  , Motion(survey.Scene, settings.Mesh ? settings.Mesh.Get() : scene, settings.Frames,
      survey.Convention, log)
  , Scenes(this->FindScene(), survey.Scene.SpectraFolders, log)
  , Scanner(None)
  , Platform(None)
  , FirstPulse(0)
  , LastPulse(AllPulses)
{
  if (this->Motion.IsMoving())
  {
    this->MotionCaster = vtkSmartPointer<vtkHeliosBeamRayCaster>::New();
  }
  for (const auto& grid : settings.Grids)
  {
    this->Grids.emplace_back(grid, survey.Scene.SpectraFolders, log);
  }
}

//------------------------------------------------------------------------------
LegScanner::~LegScanner() = default;

//------------------------------------------------------------------------------
/// Returns the scene that moves, or whose parts stand where they are at the start.
vtkPolyData* LegScanner::FindScene()
{
  if (this->Settings.Options.IsWithout("partMotion"))
  {
    this->Motion.StandStill();
  }
  return this->Motion.GetScene();
}

//------------------------------------------------------------------------------
void LegScanner::SetUp(const LegPlan& plan)
{
  const LegData& leg = this->Survey.Legs[plan.Leg];
  if (!this->Log.HasError())
  {
    this->Motion.CheckSpan(plan.StartTime, plan.StartTime + plan.Duration);
  }
  this->MakeChannels(plan);
  const auto count = static_cast<vtkIdType>(this->Channels.size());
  for (vtkIdType k = 0; k < count; ++k)
  {
    vtkHeliosScanner* channel = this->Channels[static_cast<std::size_t>(k)];
    const auto index = static_cast<std::size_t>(k);
    const ScanData& scan = leg.Scans[index];
    channel->SetBeamDeflector(
      MakeDeflector(this->Survey.GetScanner(plan.Leg).GetChannel(index), scan));
    channel->GetBeamSampler()->SetBeamDivergence(
      this->Settings.Options.IsWithout("divergence") ? 0.0 : scan.BeamDivergence);
    channel->SetHeadRotateStart(scan.HeadRotateStart);
    channel->SetHeadRotateStop(scan.HeadRotateStop);
    channel->SetHeadRotateSpeed(scan.HeadRotateSpeed);
    this->SetTrajectory(plan, channel);
    const bool standsStill = this->Settings.Options.IsWithout("motion") && scan.ScanFrequency > 0.0;
    channel->SetPoseInterval(standsStill ? 1.0 / scan.ScanFrequency : 0.0);
    channel->SetStartTime(plan.StartTime);
    channel->SetDuration(plan.Duration);
    channel->SetFirstPulseId(plan.FirstPulse + k);
    channel->SetPulseIdStride(count);
    channel->SetLegId(static_cast<int>(plan.Leg));
    channel->SetChannelId(static_cast<int>(k));
    channel->SetMotions(this->Motion.MakeMotions(
      { plan.FirstShot, plan.StartTime, leg.Scans.front().PulseFrequency }));
  }
  this->SetTimeWindow(-VTK_DOUBLE_MAX, VTK_DOUBLE_MAX);
  this->SetPulseWindow(0, AllPulses);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosScanner> LegScanner::ReleaseChannel(std::size_t channel)
{
  vtkSmartPointer<vtkHeliosScanner> released = this->Channels[channel];
  released->RemoveAllObservers();
  released->GetExecutive()->RemoveAllObservers();
  this->Channels.clear();
  this->Scanner = None;
  return released;
}

//------------------------------------------------------------------------------
/// Gives a channel the trajectory of a leg, with the GPS time of its time 0, if that is known.
void LegScanner::SetTrajectory(const LegPlan& plan, vtkHeliosScanner* channel) const
{
  const std::string& start = this->Settings.Options.GpsStart;
  if (start.empty())
  {
    channel->SetInputConnection(1, plan.Platform->GetOutputPort());
    return;
  }
  plan.Platform->Update();
  vtkNew<vtkPolyData> trajectory;
  trajectory->ShallowCopy(plan.Platform->GetOutput());
  vtkNew<vtkDoubleArray> array;
  array->SetName(names::GpsEpoch);
  array->InsertNextValue(vtkHeliosGpsTime::Parse(start));
  vtkNew<vtkFieldData> fields;
  fields->PassData(trajectory->GetFieldData());
  fields->AddArray(array);
  trajectory->SetFieldData(fields);
  channel->SetInputDataObject(1, trajectory);
}

//------------------------------------------------------------------------------
/// Makes the channels of the leg's scanner on its platform, unless the previous leg had the same.
void LegScanner::MakeChannels(const LegPlan& plan)
{
  const LegData& leg = this->Survey.Legs[plan.Leg];
  if (leg.Scanner == this->Scanner && leg.Platform == this->Platform)
  {
    return;
  }
  this->Scanner = leg.Scanner;
  this->Platform = leg.Platform;
  this->Channels.clear();
  const ScannerData& scanner = this->Survey.Scanners[leg.Scanner];
  for (std::size_t k = 0; k < scanner.GetNumberOfChannels(); ++k)
  {
    this->Channels.push_back(
      this->MakeChannel(scanner.GetChannel(k), this->Survey.Platforms[leg.Platform]));
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHeliosScanner> LegScanner::MakeChannel(
  const ScannerData& data, const PlatformData& platform)
{
  auto channel = vtkSmartPointer<vtkHeliosScanner>::New();
  this->Log.Listen(channel);
  channel->AddObserver(vtkCommand::ProgressEvent, this, &LegScanner::HandleProgress);
  const RunOptions& options = this->Settings.Options;
  std::vector<SpectralScenes> none;
  channel->SetInputDataObject(0, this->GetScene(data.Receiver.Wavelength));
  for (SpectralScenes& grid : options.IsWithout("voxels") ? none : this->Grids)
  {
    channel->AddInputDataObject(2, this->GetAt(grid, data.Receiver.Wavelength));
  }
  if (!this->Settings.RayCaster)
  {
    this->Settings.RayCaster = channel->GetRayCaster(); // shared by all, built once
  }
  channel->SetRayCaster(this->MotionCaster ? this->MotionCaster : this->Settings.RayCaster);
  channel->SetTextures(this->Settings.Textures);
  SetUpReceiver(data, this->Settings.Options, channel);
  double position[3];
  double orientation[4];
  SetPose(platform.Mount, position, orientation);
  channel->SetMountPosition(position);
  channel->SetMountOrientation(orientation);
  SetPose(data.Beam, position, orientation);
  channel->SetBeamOrigin(position);
  channel->SetBeamOrientation(orientation);
  Vec3 axis = data.HeadRotateAxis;
  channel->SetHeadRotateAxis(axis.GetData());
  if (this->Settings.Options.Noise)
  {
    const std::size_t channels = this->Survey.Scanners[this->Scanner].GetNumberOfChannels();
    channel->SetPlatformNoise(MakePlatformNoise(platform, channels));
  }
  channel->SetInterpolateOrientation(!options.IsWithout("attitude"));
  channel->SetSeed(this->Settings.Options.Seed);
  channel->SetPulseStep(this->Settings.Options.PulseStep);
  channel->SetWantedOutputs(this->Settings.Wants);
  return channel;
}

//------------------------------------------------------------------------------
/// Returns a scene at a wavelength [nm], or without spectra.
vtkDataObject* LegScanner::GetAt(SpectralScenes& scenes, double wavelength) const
{
  return this->Settings.Options.IsWithout("spectra") ? scenes.GetPlain() : scenes.Get(wavelength);
}

//------------------------------------------------------------------------------
/// Returns the scene at a wavelength [nm], with the materials of the options.
vtkSmartPointer<vtkDataObject> LegScanner::GetScene(double wavelength)
{
  vtkDataObject* scene = this->GetAt(this->Scenes, wavelength);
  vtkDataArray* lobes = scene->GetFieldData()->GetArray(names::MaterialSpecularity);
  if (!lobes || !this->Settings.Options.IsWithout("specular"))
  {
    return scene;
  }
  const auto none = vtkSmartPointer<vtkDataArray>::Take(lobes->NewInstance());
  none->DeepCopy(lobes);
  none->Fill(0.0);
  vtkNew<vtkFieldData> fields;
  fields->ShallowCopy(scene->GetFieldData());
  fields->AddArray(none); // replaces the array of this name
  const auto copy = vtkSmartPointer<vtkDataObject>::Take(scene->NewInstance());
  copy->ShallowCopy(scene);
  copy->SetFieldData(fields);
  return copy;
}

//------------------------------------------------------------------------------
void LegScanner::SetOptions(const RunOptions& options)
{
  this->Settings.Options = options;
  this->Scanner = None; // with other channels
}

//------------------------------------------------------------------------------
void LegScanner::SetOutputs(const vtkHeliosEchoAlgorithm::Outputs& wants)
{
  this->Settings.Wants = wants;
  for (vtkHeliosScanner* channel : this->Channels)
  {
    channel->SetWantedOutputs(this->Settings.Wants);
  }
}

//------------------------------------------------------------------------------
void LegScanner::SetTimeWindow(double t0, double t1)
{
  for (vtkHeliosScanner* channel : this->Channels)
  {
    channel->SetTimeWindow(t0, t1);
  }
}

//------------------------------------------------------------------------------
vtkIdType LegScanner::CountPulses()
{
  const auto channels = static_cast<vtkIdType>(this->Channels.size());
  return channels * std::max<vtkIdType>(0, this->Channels.front()->GetNumberOfPulses());
}

//------------------------------------------------------------------------------
void LegScanner::SetPulseWindow(vtkIdType first, vtkIdType last)
{
  this->FirstPulse = first;
  this->LastPulse = last;
  this->ApplyWindow(first, last);
}

//------------------------------------------------------------------------------
void LegScanner::ApplyWindow(vtkIdType first, vtkIdType last)
{
  for (vtkHeliosScanner* channel : this->Channels)
  {
    channel->SetPulseWindow(first, last);
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataObject> LegScanner::GetOutput(int port) const
{
  std::vector<vtkDataObject*> outputs;
  for (std::size_t k = 0; k < this->Channels.size(); ++k)
  {
    outputs.push_back(this->GetOutput(port, k));
  }
  return MergeChannels(outputs);
}

//------------------------------------------------------------------------------
vtkDataObject* LegScanner::GetOutput(int port, std::size_t channel) const
{
  return this->Channels[channel]->GetOutputDataObject(port);
}

//------------------------------------------------------------------------------
void LegScanner::ReleaseOutput()
{
  for (vtkHeliosScanner* channel : this->Channels)
  {
    for (int port = 0; port < channel->GetNumberOfOutputPorts(); ++port)
    {
      channel->GetOutputDataObject(port)->ReleaseData();
    }
  }
}

//------------------------------------------------------------------------------
double LegScanner::GetMemorySize() const
{
  double kibibytes = 0.0;
  for (std::size_t k = 0; k < this->Channels.size(); ++k)
  {
    for (int port = 0; port < vtkHeliosEchoAlgorithm::Outputs::NumberOfPorts; ++port)
    {
      vtkDataObject* output = this->GetOutput(port, k);
      kibibytes += output ? static_cast<double>(output->GetActualMemorySize()) : 0.0;
    }
  }
  return BytesPerKibibyte * kibibytes;
}

//------------------------------------------------------------------------------
double LegScanner::GetSceneSize() const
{
  const vtkHeliosRayCaster* caster =
    this->MotionCaster ? this->MotionCaster : this->Settings.RayCaster;
  const auto scene = static_cast<double>(this->Scenes.GetPlain()->GetActualMemorySize());
  return BytesPerKibibyte * scene + (caster ? static_cast<double>(caster->GetMemorySize()) : 0.0);
}

//------------------------------------------------------------------------------
std::vector<PartSpeeds> LegScanner::GetSpeeds(const std::vector<LegPlan>& plans) const
{
  std::vector<LegClock> legs;
  for (const LegPlan& plan : plans)
  {
    const double rate = this->Survey.Legs[plan.Leg].Scans.front().PulseFrequency;
    legs.push_back({ { plan.FirstShot, plan.StartTime, rate }, plan.StartTime + plan.Duration });
  }
  return this->Motion.GetSpeeds(legs);
}

//------------------------------------------------------------------------------
std::string LegScanner::DescribeSampling() const
{
  return this->Channels.empty() ? std::string() : this->Channels.front()->DescribeSampling();
}

//------------------------------------------------------------------------------
std::string LegScanner::GetRayCasterName() const
{
  const vtkHeliosRayCaster* caster =
    this->MotionCaster ? this->MotionCaster : this->Settings.RayCaster;
  return caster ? caster->GetName() : std::string();
}

} // namespace helios
