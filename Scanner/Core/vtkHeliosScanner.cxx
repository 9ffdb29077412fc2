// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHeliosScanner.h"

#include "heliosBeamPreparation.h"
#include "heliosConstants.h"
#include "heliosPulseCount.h"
#include "heliosRangeZones.h"
#include "heliosRayCasterBackends.h"
#include "heliosScanModel.h"
#include "heliosScanOutput.h"
#include "heliosScanRun.h"
#include "heliosScenePreparation.h"
#include "heliosStatus.h"
#include "heliosTolerances.h"
#include "heliosTreeIds.h"
#include "heliosWeather.h"
#include "vtkHeliosArrayNames.h"
#include "vtkHeliosBeamDeflector.h"
#include "vtkHeliosBeamRayCaster.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosErrorModel.h"
#include "vtkHeliosPeakDetector.h"
#include "vtkHeliosPlatformNoise.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>

vtkStandardNewMacro(vtkHeliosScanner);

namespace
{

constexpr double MaximumGate = 1e8;          // gate of dark counts [m]
constexpr double MinimumDropletShare = 0.05; // share of the detection threshold, for single drops
constexpr double MinimumAirShare = 1e-3; // share of the detection threshold, for light from the air

helios::Pose ToPose(const double position[3], const double q[4])
{
  helios::Pose pose{ helios::Vec3(position), helios::Quaternion(q[0], q[1], q[2], q[3]) };
  pose.Orientation.Normalize();
  return pose;
}

/// Clears all outputs: partial results are discarded.
void ClearOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
}

/// Gives echoes and pulses the GPS time of GpsTime 0, if the trajectory has it.
void PassEpoch(vtkPolyData* trajectory, vtkInformationVector* outputs)
{
  vtkAbstractArray* epoch =
    trajectory->GetFieldData()->GetAbstractArray(vtkHeliosArrayNames::GpsEpoch);
  for (const int port : { 0, 2 })
  {
    if (epoch)
    {
      vtkPolyData::GetData(outputs, port)->GetFieldData()->AddArray(epoch);
    }
  }
}

} // namespace

/// The model of the kernel, and the owners of its pointers.
struct vtkHeliosScanner::Scan
{
  helios::ScanModel Model;
  helios::Trajectory Trajectory;
  vtkIdType FirstPulse = 0;
  vtkIdType LastPulse = 0;      // one past the end
  vtkIdType NumberOfPulses = 0; // number of the scan, regardless of windows
};

//------------------------------------------------------------------------------
struct vtkHeliosScanner::ProbedMotions
{
  using Key = std::tuple<const helios::ConeProbe*, vtkIdType, double, double, double>;

  std::weak_ptr<const helios::InstanceMotions> Motions;
  Key Settings;
  bool FindsPlanes = false;
};

vtkHeliosScanner::vtkHeliosScanner()
  : RangeTolerance(helios::DefaultRangeTolerance)
  , EnergyTolerance(helios::DefaultEnergyTolerance)
  , MaximumNumberOfSubRays(helios::DefaultSubRayLimit)
  , Counts(new helios::ScanCounts)
  , Batch(new helios::BatchSize)
  , Probed(new ProbedMotions)
{
  this->SetNumberOfInputPorts(3);
  this->RayCaster = helios::MakeDefaultRayCaster();
  this->BeamSampler = vtkSmartPointer<vtkHeliosBeamSampler>::New();
  this->EchoDetector = vtkSmartPointer<vtkHeliosPeakDetector>::New();
}

//------------------------------------------------------------------------------
vtkHeliosScanner::~vtkHeliosScanner() = default;

//------------------------------------------------------------------------------
void vtkHeliosScanner::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "RayCaster: " << (this->RayCaster ? this->RayCaster->GetName() : "(none)") << "\n"
     << indent
     << "BeamDeflector: " << (this->BeamDeflector ? this->BeamDeflector->GetClassName() : "(none)")
     << "\n"
     << indent
     << "BeamSampler: " << (this->BeamSampler ? this->BeamSampler->GetClassName() : "(none)")
     << "\n"
     << indent
     << "EchoDetector: " << (this->EchoDetector ? this->EchoDetector->GetClassName() : "(none)")
     << "\n"
     << indent << "ErrorModel: " << (this->ErrorModel ? this->ErrorModel->GetClassName() : "(none)")
     << "\n"
     << indent << "PlatformNoise: " << (this->PlatformNoise ? "on" : "(none)") << "\n"
     << indent << "Sampling: " << (this->Sampling == FIXED ? "Fixed" : "Tolerance") << "\n"
     << indent << "RangeTolerance: " << this->RangeTolerance << " m\n"
     << indent << "EnergyTolerance: " << this->EnergyTolerance << "\n"
     << indent << "MaximumNumberOfSubRays: " << this->MaximumNumberOfSubRays << "\n"
     << indent << "HeadRotateStart: " << this->HeadRotateStart << " deg\n"
     << indent << "HeadRotateStop: " << this->HeadRotateStop << " deg\n"
     << indent << "HeadRotateSpeed: " << this->HeadRotateSpeed << " deg/s\n"
     << indent << "PoseInterval: " << this->PoseInterval << " s\n"
     << indent << "InterpolateOrientation: " << this->InterpolateOrientation << "\n"
     << indent << "MergeReturns: " << this->MergeReturns << "\n"
     << indent << "StartTime: " << this->StartTime << " s\n"
     << indent << "Duration: " << this->Duration << " s\n"
     << indent << "PulseStep: " << this->PulseStep << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "FirstPulseId: " << this->FirstPulseId << "\n"
     << indent << "PulseIdStride: " << this->PulseIdStride << "\n"
     << indent << "LegId: " << this->LegId << "\n"
     << indent << "ChannelId: " << this->ChannelId << "\n";
}

// The strategies have identical Set and Get methods.
#define HELIOS_STRATEGY(Name)                                                                      \
  void vtkHeliosScanner::Set##Name(vtkHelios##Name* strategy)                                      \
  {                                                                                                \
    if (this->Name != strategy)                                                                    \
    {                                                                                              \
      this->Name = strategy;                                                                       \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  vtkHelios##Name* vtkHeliosScanner::Get##Name() const                                             \
  {                                                                                                \
    return this->Name;                                                                             \
  }

HELIOS_STRATEGY(RayCaster)
HELIOS_STRATEGY(BeamDeflector)
HELIOS_STRATEGY(BeamSampler)
HELIOS_STRATEGY(EchoDetector)
HELIOS_STRATEGY(ErrorModel)
HELIOS_STRATEGY(PlatformNoise)
#undef HELIOS_STRATEGY

//------------------------------------------------------------------------------
vtkMTimeType vtkHeliosScanner::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  // The ray caster is excluded: building it changes no result, and all are byte-identical.
  for (vtkObject* strategy : { static_cast<vtkObject*>(this->BeamDeflector.Get()),
         static_cast<vtkObject*>(this->BeamSampler.Get()),
         static_cast<vtkObject*>(this->EchoDetector.Get()),
         static_cast<vtkObject*>(this->ErrorModel.Get()),
         static_cast<vtkObject*>(this->PlatformNoise.Get()) })
  {
    time = strategy ? std::max(time, strategy->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
int vtkHeliosScanner::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 2 ? "vtkImageData" : "vtkPolyData");
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHeliosScanner::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int port : { 0, 1 })
  {
    vtkInformation* info = inputs[port]->GetInformationObject(0);
    info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0); // scene, trajectory: always whole
    info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  }
  for (int i = 0; i < inputs[2]->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* info = inputs[2]->GetInformationObject(i);
    info->Set(Pipeline::UPDATE_EXTENT(), info->Get(Pipeline::WHOLE_EXTENT()), 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosScanner::CheckSettings()
{
  if (!this->BeamDeflector)
  {
    vtkErrorMacro(<< "BeamDeflector is not set; give the scanner one, e.g. a "
                     "vtkHeliosRotatingMirror");
    return false;
  }
  if (!this->RayCaster || !this->BeamSampler || !this->EchoDetector)
  {
    vtkErrorMacro(<< "RayCaster, BeamSampler or EchoDetector is not set");
    return false;
  }
  if (!(this->BeamDeflector->GetPulseFrequency() > 0.0))
  {
    vtkErrorMacro(<< "PulseFrequency is " << this->BeamDeflector->GetPulseFrequency()
                  << " Hz; it must be positive");
    return false;
  }
  const helios::Vec3 axis(this->HeadRotateAxis);
  if (!(axis.Norm() > 0.0))
  {
    vtkErrorMacro(<< "HeadRotateAxis has no direction");
    return false;
  }
  const helios::Status beam = helios::CheckBeam(this->BeamSampler);
  if (!beam.IsOk())
  {
    vtkErrorMacro(<< beam.Message());
    return false;
  }
  if (!helios::IsRangeTolerance(this->RangeTolerance) ||
    !helios::IsEnergyTolerance(this->EnergyTolerance))
  {
    vtkErrorMacro(<< "RangeTolerance is " << this->RangeTolerance << " m and EnergyTolerance "
                  << this->EnergyTolerance << "; give them within ["
                  << helios::MinimumRangeTolerance << ", " << helios::LargestTolerance
                  << "] m and [" << helios::MinimumEnergyTolerance << ", "
                  << helios::LargestTolerance << "]");
    return false;
  }
  if (!helios::IsSubRayLimit(this->MaximumNumberOfSubRays))
  {
    vtkErrorMacro(<< "MaximumNumberOfSubRays is " << this->MaximumNumberOfSubRays << "; give "
                  << helios::SmallestSubRayLimit << " to " << helios::LargestSubRayLimit);
    return false;
  }
  if (this->PulseWindow[0] < 0 || this->PulseWindow[1] < this->PulseWindow[0])
  {
    vtkErrorMacro(<< "PulseWindow is [" << this->PulseWindow[0] << ", " << this->PulseWindow[1]
                  << "); give two indices, the second not below the first, from 0");
    return false;
  }
  if (this->Wanted.Decibels &&
    !(this->EchoDetector->GetDetectionThreshold() > 0.0 && this->AveragePower > 0.0))
  {
    vtkErrorMacro(<< "GenerateDecibels is on, with a DetectionThreshold of "
                  << this->EchoDetector->GetDetectionThreshold() << " W and an AveragePower of "
                  << this->AveragePower << " W; decibels need both positive");
    return false;
  }
  if (this->EchoDetector->HasDarkCounts() && !(this->RangeMax <= MaximumGate))
  {
    vtkErrorMacro(<< "RangeMax is " << this->RangeMax
                  << " m, and the EchoDetector has dark counts within the range gate; set RangeMax "
                     "(rangeMax_m) to at most "
                  << MaximumGate << " m");
    return false;
  }
  if (this->MTAZone > 0 && this->Wanted.Waveforms)
  {
    vtkErrorMacro(<< "MTAZone is " << this->MTAZone
                  << " and GenerateWaveforms is on: waveforms cannot be taken for those of other "
                     "pulses; turn GenerateWaveforms off, or set MTAZone to 0");
    return false;
  }
  return this->CheckInstrument();
}

//------------------------------------------------------------------------------
bool vtkHeliosScanner::PrepareSources(vtkPolyData* trajectory, Scan& scan)
{
  const helios::Status wrong = scan.Trajectory.Set(trajectory);
  if (!wrong.IsOk())
  {
    vtkErrorMacro(<< wrong.Message());
    return false;
  }
  scan.Trajectory.SetInterpolatesOrientation(this->InterpolateOrientation);
  scan.Model.Sample = { this->PulseStep, this->FirstPulseId };
  helios::PulseSource& source = scan.Model.Source;
  source.Platform = &scan.Trajectory;
  source.Deflector = this->BeamDeflector;
  source.PulseFrequency = this->BeamDeflector->GetPulseFrequency();
  source.StartTime = this->StartTime >= 0.0 ? this->StartTime : scan.Trajectory.GetStartTime();
  source.Mount = ToPose(this->MountPosition, this->MountOrientation);
  source.BeamOrigin = ToPose(this->BeamOrigin, this->BeamOrientation);
  source.HeadAxis = helios::Vec3(this->HeadRotateAxis);
  source.HeadStart = this->HeadRotateStart;
  source.HeadSpeed = this->HeadRotateSpeed;
  source.PoseInterval = this->PoseInterval;
  source.Roll.IsOn = this->BeamSampler->GetDivergenceRatio() != 1.0;
  source.Roll.Angle = this->BeamSampler->GetMajorAxisAngle();
  this->BeamDeflector->GetCrossAxis(source.Roll.CrossAxis.GetData());
  source.Errors = this->ErrorModel;
  const bool isNoisy = this->PlatformNoise && this->PlatformNoise->IsOn();
  source.Noise = isNoisy ? this->PlatformNoise.Get() : nullptr;
  source.AngleAccuracy = this->AngleAccuracy;
  source.Seed = static_cast<std::uint64_t>(this->Seed);
  source.Ids = { this->FirstPulseId, this->PulseIdStride };
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosScanner::PreparePulses(Scan& scan)
{
  const double start = scan.Model.Source.StartTime;
  const double rate = scan.Model.Source.PulseFrequency;
  const double turn = this->HeadRotateStop - this->HeadRotateStart;
  double duration = this->Duration;
  if (duration < 0.0 && !scan.Trajectory.IsStatic())
  {
    duration = scan.Trajectory.GetEndTime() - start;
  }
  else if (duration < 0.0)
  {
    if (this->HeadRotateSpeed == 0.0)
    {
      vtkErrorMacro(<< "the scan never ends: the platform is static and HeadRotateSpeed is 0; set "
                       "HeadRotateSpeed and HeadRotateStop, or Duration");
      return false;
    }
    duration = turn / this->HeadRotateSpeed;
    if (duration < 0.0)
    {
      vtkErrorMacro(<< "the head never reaches its stop: it rotates from HeadRotateStart "
                    << this->HeadRotateStart << " deg at HeadRotateSpeed " << this->HeadRotateSpeed
                    << " deg/s away from HeadRotateStop " << this->HeadRotateStop << " deg");
      return false;
    }
  }
  const vtkIdType all = helios::CountPulses(duration, rate);
  const auto find = [all, start, rate](double time, vtkIdType low, vtkIdType high)
  {
    return std::clamp(
      helios::CountPulses(time - start, rate), std::min(all, low), std::min(all, high));
  };
  scan.NumberOfPulses = all;
  scan.Model.Zones = helios::MakeRangeZones(*this->BeamDeflector, this->MTAZone, all);
  const vtkIdType* window = this->PulseWindow;
  scan.FirstPulse = find(this->TimeWindow[0], window[0], window[1]);
  scan.LastPulse = find(this->TimeWindow[1], window[0], window[1]);
  return true;
}

//------------------------------------------------------------------------------
bool vtkHeliosScanner::PrepareScene(vtkInformationVector** inputs, Scan& scan)
{
  std::vector<vtkImageData*> grids;
  for (int i = 0; i < inputs[2]->GetNumberOfInformationObjects(); ++i)
  {
    grids.push_back(vtkImageData::GetData(inputs[2], i));
  }
  const bool isIsotropic = this->ScatteringOrders > 1 && this->ScatteringPhase == ISOTROPIC;
  const helios::Status status = helios::PrepareScene(
    vtkPolyData::GetData(inputs[0]), grids, this->RayCaster, isIsotropic, scan.Model);
  if (!status.IsOk() && !this->GetAbortExecute())
  {
    vtkErrorMacro(<< status.Message());
  }
  scan.Model.Surfaces.SetWavelength(this->Wavelength);
  const bool moves = status.IsOk() && this->Motions && scan.Model.Caster;
  if (moves && !scan.Model.Caster->MakeMoving(this->Motions))
  {
    vtkErrorMacro(<< "the RayCaster \"" << this->RayCaster->GetName()
                  << "\" does not support instances that move; set a vtkHeliosBeamRayCaster");
    return false;
  }
  scan.Model.Motions = moves ? this->Motions : nullptr;
  return status.IsOk() &&
    (!this->Wanted.Colors || this->PrepareColors(vtkPolyData::GetData(inputs[0]), grids, scan));
}

//------------------------------------------------------------------------------
void vtkHeliosScanner::SetMotions(std::shared_ptr<const helios::InstanceMotions> motions)
{
  this->Motions = std::move(motions);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHeliosScanner::SetTextures(std::shared_ptr<helios::TextureStore> textures)
{
  this->SharedTextures = std::move(textures);
  this->ColorTime = 0;
  this->Modified();
}

//------------------------------------------------------------------------------
bool vtkHeliosScanner::PrepareColors(
  vtkPolyData* scene, const std::vector<vtkImageData*>& grids, Scan& scan)
{
  std::vector<vtkDataObject*> data(grids.begin(), grids.end());
  data.push_back(scene);
  const auto isOlder = [](vtkDataObject* a, vtkDataObject* b)
  { return a->GetMTime() < b->GetMTime(); };
  const vtkMTimeType time = (*std::max_element(data.begin(), data.end(), isOlder))->GetMTime();
  const bool isNew = time != this->ColorTime;
  if (isNew)
  {
    this->Textures =
      this->SharedTextures ? this->SharedTextures : std::make_shared<helios::TextureStore>();
  }
  std::vector<std::string> warnings;
  if (const helios::Status status = this->Textures->Load(data, warnings); !status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  this->ColorTime = time;
  for (const std::string& warning : warnings)
  {
    vtkWarningMacro(<< warning);
  }
  helios::ScanModel& m = scan.Model;
  m.Colors.Set(scene, grids, m.Caster ? &m.Caster->GetGeometry() : nullptr, *this->Textures);
  if (isNew && m.Colors.IsEmpty())
  {
    vtkWarningMacro(<< "GenerateColors is on, but the scene has no colours, so all echoes are "
                       "black; read it with ReadColors, or turn GenerateColors off");
  }
  return true;
}

//------------------------------------------------------------------------------
/// Prepares scene and beam, which takes time: polls for an abort request.
bool vtkHeliosScanner::PrepareSearch(vtkInformationVector** inputs, Scan& scan)
{
  const auto shouldStop = [this]()
  {
    this->UpdateProgress(0.0);
    return this->GetAbortExecute() != 0;
  };
  this->RayCaster->SetShouldStop(shouldStop);
  const bool isReady = this->PrepareScene(inputs, scan);
  if (isReady)
  {
    this->PrepareBeam(scan);
  }
  this->RayCaster->SetShouldStop(nullptr);
  if (this->GetAbortExecute())
  {
    vtkErrorMacro(<< "The scan was aborted at 0 %; update again to complete it");
    return false;
  }
  return isReady;
}

//------------------------------------------------------------------------------
/// Prepares the light that the air returns.
void vtkHeliosScanner::PrepareAir(Scan& scan) const
{
  helios::ScanModel& m = scan.Model;
  const helios::Air air = this->ComputeAir();
  const helios::AirSettings settings{ air.LidarRatio > 0.0 ? air.Extinction / air.LidarRatio : 0.0,
    m.Power * m.Equation.GetGain(1.0, 1.0), air.Extinction,
    std::max(this->RangeMin, this->ReceiverDiameter), this->RangeMax,
    0.5 * helios::SpeedOfLight * m.Receiver.Shape.GetSigma(),
    MinimumAirShare * this->EchoDetector->GetDetectionThreshold() };
  m.Air = helios::AirColumn(settings);
  if (!m.Air.IsEmpty() && air.DropletDiameter > 0.0)
  {
    m.Drops = helios::Droplets(settings, m.Air.GetEnd(), helios::GetBeamWidth(this->BeamSampler),
      air.DropletDiameter, MinimumDropletShare * this->EchoDetector->GetDetectionThreshold());
    m.Air = helios::AirColumn(
      settings, [&m](double range) { return m.Drops.GetHomogeneousShare(range); });
  }
}

//------------------------------------------------------------------------------
bool vtkHeliosScanner::PrepareReceiver(Scan& scan)
{
  helios::ScanModel& m = scan.Model;
  helios::ReceiverSettings& receiver = m.Receiver;
  const helios::Status status = this->MakePulseShape(receiver.Shape);
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    return false;
  }
  receiver.BinSize = this->BinSize;
  receiver.Detector = this->EchoDetector;
  receiver.MaximumCount = this->CountSamples();
  receiver.HasLimit = this->MaximumWaveformLength > 0.0 || this->NumberOfBins > 0;
  receiver.Noise = this->DetectorNoise;
  receiver.Seed = static_cast<std::uint64_t>(this->Seed);
  receiver.Saturation = this->SaturationPower > 0.0 ? this->SaturationPower : receiver.Saturation;
  receiver.GateStart = 2.0 / helios::SpeedOfLight * this->RangeMin;
  receiver.GateStop = 2.0 / helios::SpeedOfLight * this->RangeMax;
  m.Power = this->AveragePower;
  m.Equation = { this->ReceiverDiameter, this->OpticalEfficiency, this->ComputeAir().Extinction };
  m.Background = this->ComputeBackground();
  m.Gate = { this->RangeMin, this->RangeMax };
  m.Optics = { this->MaximumSpecularEvents, this->LeastSpecularShare };
  this->PrepareAir(scan);
  m.Noise = { this->RangeAccuracy, this->RangeAccuracyPerMeter, this->RangeAccuracyAtThreshold,
    this->EchoDetector->GetDetectionThreshold() };
  m.ReturnSelection = this->ReturnSelection;
  m.MaximumNumberOfReturns = this->MaximumNumberOfReturns;
  m.Seed = static_cast<std::uint64_t>(this->Seed);
  m.Wants = this->Wanted;
  return true;
}

//------------------------------------------------------------------------------
void vtkHeliosScanner::PrepareBeam(Scan& scan)
{
  helios::ScanModel& m = scan.Model;
  helios::ScanTraits traits = this->GetTraits();
  traits.HasGaussianSum = m.HasGaussianSum();
  if (traits.IsAdaptive())
  {
    m.Plan = this->PlanSampling(m.Receiver.Shape);
    m.Cones = m.Caster ? this->RayCaster->GetConeProbe() : nullptr;
    helios::PrepareAdaptiveBeam(this->BeamSampler, m);
    traits.FindsPlanes = this->ScatteringOrders == 1 && this->FindsPlanes(scan);
    m.UsesRays =
      m.Plan.PrefersRays && !m.Surfaces.HasOptics() && helios::FindsCrowds(m, scan.NumberOfPulses);
  }
  else
  {
    helios::PrepareFixedBeam(this->BeamSampler, m);
    // Other casters have no trees to probe.
    const bool hasTrees = m.Caster && vtkHeliosBeamRayCaster::SafeDownCast(this->RayCaster);
    m.Cones = hasTrees ? this->RayCaster->GetConeProbe() : nullptr;
  }
  m.Path = helios::ChoosePath(traits);
  helios::PrepareScattering(*this, this->BeamSampler, m);
}

//------------------------------------------------------------------------------
/// Returns whether cone probes pay; with motions once for all pieces of a leg, as their boxes take
/// time.
bool vtkHeliosScanner::FindsPlanes(const Scan& scan)
{
  const helios::ScanModel& m = scan.Model;
  if (!m.Motions)
  {
    return helios::FindsPlanes(m, scan.NumberOfPulses);
  }
  const ProbedMotions::Key key(
    m.Cones, scan.NumberOfPulses, m.Plan.PlaneDistance, m.Plan.PlaneContrast, m.ConeTangent);
  ProbedMotions& probed = *this->Probed;
  if (probed.Motions.lock() != m.Motions || probed.Settings != key)
  {
    probed = { m.Motions, key, helios::FindsPlanes(m, scan.NumberOfPulses) };
  }
  return probed.FindsPlanes;
}

//------------------------------------------------------------------------------
helios::SamplingPlan vtkHeliosScanner::PlanSampling(const helios::PulseShape& shape) const
{
  return helios::PlanSampling(
    { this->RangeTolerance, this->EnergyTolerance, this->MaximumNumberOfSubRays },
    shape.GetSigma());
}

//------------------------------------------------------------------------------
/// Returns the traits of the settings that decide the scan's path.
helios::ScanTraits vtkHeliosScanner::GetTraits()
{
  helios::ScanTraits traits;
  traits.HasDivergence = this->BeamSampler->GetBeamDivergence() > 0.0;
  traits.IsFixed = this->Sampling == FIXED;
  traits.StoresWaveforms = this->Wanted.Waveforms;
  traits.MergesReturns = this->MergeReturns;
  return traits;
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosScanner::GetNumberOfPulses()
{
  Scan scan;
  if (!this->CheckSettings() || !this->GetInputAlgorithm(1, 0))
  {
    return -1;
  }
  this->GetInputAlgorithm(1, 0)->Update();
  auto* trajectory = vtkPolyData::SafeDownCast(this->GetInputDataObject(1, 0));
  if (!this->PrepareSources(trajectory, scan) || !this->PreparePulses(scan))
  {
    return -1;
  }
  return std::max<vtkIdType>(0, scan.LastPulse - scan.FirstPulse);
}

//------------------------------------------------------------------------------
int vtkHeliosScanner::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  Scan scan;
  if (!this->CheckSettings() || !this->PrepareSources(vtkPolyData::GetData(inputs[1]), scan) ||
    !this->PreparePulses(scan) || !this->PrepareReceiver(scan) ||
    !this->PrepareSearch(inputs, scan))
  {
    return 0;
  }
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  const int port = std::max(0, request->Get(Pipeline::FROM_OUTPUT_PORT()));
  vtkInformation* info = outputs->GetInformationObject(port);
  const vtkIdType pieces = std::max(1, info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()));
  const vtkIdType piece = info->Get(Pipeline::UPDATE_PIECE_NUMBER());
  const vtkIdType count = std::max<vtkIdType>(0, scan.LastPulse - scan.FirstPulse);
  if (!this->RunPulses(scan, scan.FirstPulse + helios::SplitPulses(count, piece, pieces),
        scan.FirstPulse + helios::SplitPulses(count, piece + 1, pieces), outputs))
  {
    return 0;
  }
  vtkPolyData* echoes = vtkPolyData::GetData(outputs, 0);
  scan.Model.Surfaces.PassFields(vtkPolyData::GetData(inputs[0]), echoes);
  helios::AddTreeIds(echoes);
  PassEpoch(vtkPolyData::GetData(inputs[1]), outputs);
  return 1;
}

//------------------------------------------------------------------------------
bool vtkHeliosScanner::RunPulses(
  const Scan& scan, vtkIdType first, vtkIdType last, vtkInformationVector* outputs)
{
  bool isAborted = false;
  const auto shouldContinue = [this, &isAborted](double share)
  {
    this->UpdateProgress(share);
    isAborted = this->GetAbortExecute() != 0;
    return !isAborted;
  };
  const vtkIdType begin = scan.Model.Sample.CountBelow(first);
  const vtkIdType end = scan.Model.Sample.CountBelow(last);
  helios::ScanOutput output(scan.Model, { this->LegId, this->ChannelId }, end - begin, outputs);
  const auto onChunks = [&output](const std::vector<helios::ChunkResult>& chunks)
  { output.Add(chunks); };
  helios::ScanCounts sum;
  std::shared_ptr<void> threads = this->EchoDetector->PrepareThreads();
  const helios::Status status =
    helios::RunScan(scan.Model, begin, end, *this->Batch, shouldContinue, onChunks, sum);
  threads.reset();
  output.Finish();
  if (!status.IsOk())
  {
    vtkErrorMacro(<< status.Message());
    ClearOutputs(outputs);
    return false;
  }
  if (isAborted)
  {
    vtkErrorMacro(<< "The scan was aborted at " << 100.0 * this->GetProgress()
                  << " %; update again to complete it");
    ClearOutputs(outputs);
    return false;
  }
  const bool isCut =
    this->PulseWindow[0] > 0 || this->PulseWindow[1] < scan.NumberOfPulses || this->PulseStep > 1;
  *this->Counts = sum;
  this->WarnOfCounts(scan.FirstPulse == first && scan.LastPulse == last && !isCut);
  if (this->CheckErrorTerms())
  {
    return true;
  }
  ClearOutputs(outputs);
  return false;
}

//------------------------------------------------------------------------------
/// Reports an error if the error model has invalid values.
bool vtkHeliosScanner::CheckErrorTerms()
{
  bool good = true;
  for (int term = 0; term < vtkHeliosErrorModel::NUMBER_OF_TERMS; ++term)
  {
    const auto& fault = this->Counts->Faults[static_cast<std::size_t>(term)];
    if (fault.Pulses > 0)
    {
      vtkErrorMacro(<< this->ErrorModel->GetTermName(term)
                    << fault.Describe(term, this->Counts->PulsesFired));
      good = false;
    }
  }
  return good;
}

//------------------------------------------------------------------------------
void vtkHeliosScanner::WarnOfCounts(bool isWholeScan)
{
  const helios::ScanCounts& counts = *this->Counts;
  if (counts.CutWaveforms > 0)
  {
    vtkWarningMacro(<< counts.CutWaveforms
                    << " waveforms were truncated: they exceed NumberOfBins, MaximumWaveformLength "
                       "or the longest that can be stored");
  }
  const bool hasThreshold = this->EchoDetector->GetCalibrationAmplitude() > 0.0;
  if (isWholeScan && counts.PulsesHit > 0 && counts.Echoes == 0 && !hasThreshold)
  {
    vtkWarningMacro(<< "no photon was counted: the largest amplitude of " << counts.PulsesHit
                    << " pulses is " << counts.LargestAmplitude
                    << " W; raise AveragePower or the efficiency of the EchoDetector");
  }
  else if (isWholeScan && counts.PulsesHit > 0 && counts.Echoes == 0)
  {
    vtkWarningMacro(<< "no echo was detected: the largest amplitude of " << counts.PulsesHit
                    << " pulses is " << counts.LargestAmplitude << " W, below DetectionThreshold ("
                    << this->EchoDetector->GetDetectionThreshold() << " W); lower the threshold");
  }
}

//------------------------------------------------------------------------------
vtkIdType vtkHeliosScanner::GetCount(const std::string& name) const
{
  return helios::GetCount(*this->Counts, name);
}

//------------------------------------------------------------------------------
std::string vtkHeliosScanner::GetCountNames()
{
  return helios::GetCountNames();
}

//------------------------------------------------------------------------------
double vtkHeliosScanner::GetLargestAmplitude() const
{
  return this->Counts->LargestAmplitude;
}

//------------------------------------------------------------------------------
std::string vtkHeliosScanner::DescribeSampling()
{
  if (!this->GetTraits().IsAdaptive())
  {
    const int count = this->Sampling == FIXED ? this->BeamSampler->GetNumberOfSubRays() : 1;
    return "fixed, " + std::to_string(count) + " sub-rays per pulse";
  }
  helios::PulseShape shape;
  const helios::Status status = this->MakePulseShape(shape);
  return status.IsOk() ? this->PlanSampling(shape).Describe() : status.Message();
}
