// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosSimulation.h"

#include "heliosErrorText.h"
#include "heliosGroundHeight.h"
#include "heliosSceneBounds.h"
#include "heliosSurveyData.h"
#include "heliosSurveyLoader.h"
#include "vtkHeliosSurvey.h"
#include "vtkHeliosSurveySource.h"

#include <vtkBoundingBox.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

namespace helios::viewer
{

namespace
{

constexpr std::size_t LongestQueue = 8;
constexpr vtkIdType MinimumPulses = 1024; // pulses of a block
constexpr vtkIdType MaximumPulses = 262144;
constexpr double SecondsPerBlock = 0.05; // target duration of a block
constexpr double SamplesPerLeg = 2000.0; // samples of the trajectory

// Heights at which the trajectory is that of the scanner, not of the wheels [m].
constexpr double MinimumLift = 0.5;
constexpr double MaximumLift = 4.0;

template <typename Data>
vtkSmartPointer<Data> CopyOutput(vtkHeliosSurveySource* source, int port)
{
  auto kept = vtkSmartPointer<Data>::New();
  kept->ShallowCopy(source->GetOutputDataObject(port));
  return kept;
}

/// Returns whether parts move or deform in any epoch: the mesh that is drawn is then split into layers.
bool HasMovingParts(const SceneData& scene)
{
  const auto moves = [](const PartData& part)
  {
    return part.IsMoving() ||
      std::any_of(part.Swaps.begin(), part.Swaps.end(),
        [](const SwapData& swap) { return swap.Part.IsMoving(); });
  };
  return std::any_of(scene.Parts.begin(), scene.Parts.end(), moves);
}

} // namespace

//------------------------------------------------------------------------------
bool SimulatedLeg::SetTrajectory(vtkPolyData* trajectory)
{
  const bool isSet = this->Path.Set(trajectory).IsOk();
  for (vtkIdType k = 0; isSet && k < trajectory->GetNumberOfPoints(); ++k)
  {
    this->Positions.emplace_back(trajectory->GetPoint(k));
  }
  return isSet;
}

//------------------------------------------------------------------------------
Pose SimulatedLeg::GetHead(double time) const
{
  const double elapsed = std::clamp(time, this->StartTime, this->EndTime) - this->StartTime;
  const double angle = this->HeadStart + this->HeadSpeed * elapsed;
  return { this->Mount.Position, this->Mount.Orientation * AxisAngle(this->HeadAxis, angle) };
}

//------------------------------------------------------------------------------
const SimulatedLeg* FindLeg(const std::vector<SimulatedLeg>& legs, double time)
{
  const SimulatedLeg* found = legs.empty() ? nullptr : &legs.front();
  for (const SimulatedLeg& leg : legs)
  {
    found = leg.StartTime <= time ? &leg : found;
  }
  return found;
}

//------------------------------------------------------------------------------
void FindPlatforms(std::vector<SimulatedLeg>& legs, const std::vector<Vec3>& points)
{
  for (SimulatedLeg& leg : legs)
  {
    if (!leg.IsMoving || (leg.Kind != PlatformKind::Unknown && !IsOnGround(leg.Kind)))
    {
      continue;
    }
    const Vec3 place = leg.Positions[leg.Positions.size() / 2];
    const double height = place[2] - FindGround(points, place);
    double length = 0.0;
    for (std::size_t i = 1; i < leg.Positions.size(); ++i)
    {
      length += (leg.Positions[i] - leg.Positions[i - 1]).Norm();
    }
    leg.Kind = leg.Kind == PlatformKind::Unknown
      ? GuessPlatformKind(height, length / std::max(1e-3, leg.EndTime - leg.StartTime))
      : leg.Kind;
    leg.Height =
      IsOnGround(leg.Kind) && height > MinimumLift && height < MaximumLift ? height : 0.0;
  }
}

//------------------------------------------------------------------------------
Simulation::Simulation(vtkHeliosSurvey* survey)
  : Survey(survey)
  , PulsesPerBlock(16 * MinimumPulses)
  , Target(-std::numeric_limits<double>::infinity())
{
  this->Source->SetSurvey(survey);
  this->Source->SetInstances(!HasMovingParts(survey->GetData().Scene));
}

//------------------------------------------------------------------------------
Simulation::~Simulation()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsEnding = true;
  }
  this->Source->Abort();
  this->Wake.notify_all();
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
}

//------------------------------------------------------------------------------
void Simulation::Start()
{
  this->Thread = std::thread([this] { this->Work(); });
}

//------------------------------------------------------------------------------
Simulation::Phase Simulation::GetPhase() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->State;
}

//------------------------------------------------------------------------------
std::string Simulation::GetMessage() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Message;
}

//------------------------------------------------------------------------------
void Simulation::GetBounds(double bounds[6]) const
{
  double own[6];
  static_cast<void>(GetSceneBounds(this->Scene, own)); // the source has checked the scene
  vtkBoundingBox box(own);
  for (vtkImageData* grid : this->Grids)
  {
    box.AddBounds(grid->GetBounds());
  }
  box.GetBounds(bounds);
}

//------------------------------------------------------------------------------
double Simulation::GetStartTime() const
{
  return this->Legs.empty() ? 0.0 : this->Legs.front().StartTime;
}

//------------------------------------------------------------------------------
double Simulation::GetEndTime() const
{
  return this->Legs.empty() ? 0.0 : this->Legs.back().EndTime;
}

//------------------------------------------------------------------------------
void Simulation::SetTarget(double time)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Target = std::max(this->Target, time);
  }
  this->Wake.notify_all();
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkPolyData>> Simulation::CollectEchoes()
{
  std::vector<vtkSmartPointer<vtkPolyData>> echoes;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    for (const Block& block : this->Blocks)
    {
      echoes.push_back(block.Echoes);
      this->CollectedTime = block.EndTime;
      this->CollectedPulses = block.EndPulse;
    }
    this->Blocks.clear();
  }
  this->Wake.notify_all();
  return echoes;
}

//------------------------------------------------------------------------------
double Simulation::GetCollectedTime() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->CollectedTime;
}

//------------------------------------------------------------------------------
vtkIdType Simulation::GetCollectedPulses() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->CollectedPulses;
}

//------------------------------------------------------------------------------
/// Compares pulses: their times are rounded.
bool Simulation::HasCollected(double time) const
{
  const vtkIdType pulses = this->Source->FindPulse(time);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->CollectedPulses >= pulses;
}

//------------------------------------------------------------------------------
double Simulation::GetComputingSeconds() const
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->ComputingSeconds;
}

//------------------------------------------------------------------------------
std::future<PulseRecord> Simulation::Inspect(vtkIdType pulse)
{
  return this->Submit({ pulse, pulse + 1, true, {} });
}

//------------------------------------------------------------------------------
std::future<PulseRecord> Simulation::Inspect(vtkIdType first, vtkIdType last)
{
  return this->Submit({ first, last, false, {} });
}

//------------------------------------------------------------------------------
std::future<PulseRecord> Simulation::Submit(Request request)
{
  std::future<PulseRecord> record = request.Record.get_future();
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Requests.push_back(std::move(request));
  }
  this->Wake.notify_all();
  return record;
}

//------------------------------------------------------------------------------
/// Runs in the thread: loads, then runs blocks and requests until it is stopped.
void Simulation::Work()
{
  const ErrorText errors(this->Source);
  bool isGood = this->Load();
  while (isGood)
  {
    {
      std::unique_lock<std::mutex> lock(this->Mutex);
      this->Wake.wait(lock, [this] { return this->IsEnding || this->HasWork(); });
      if (this->IsEnding)
      {
        break;
      }
    }
    isGood = this->RunRequests() && this->RunBlock();
  }
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Requests.clear(); // their futures then throw
  if (!isGood && !this->IsEnding)
  {
    this->State = Phase::Failed;
    this->Message = errors.Get("The survey cannot be run.");
  }
}

//------------------------------------------------------------------------------
bool Simulation::Load()
{
  if (!this->Source->Load())
  {
    return false;
  }
  // The viewer's own: pipelines of two threads must not share data objects, whose information they
  // change. The arrays are shared.
  vtkPolyData* scene = this->Source->GetScene();
  this->Scene = vtkSmartPointer<vtkPolyData>::Take(scene->NewInstance()); // with instances or not
  this->Scene->ShallowCopy(scene);
  for (int i = 0; this->Source->GetGrid(i); ++i)
  {
    this->Grids.push_back(vtkSmartPointer<vtkImageData>::New());
    this->Grids.back()->ShallowCopy(this->Source->GetGrid(i));
  }
  this->Frames = this->Source->GetLoader().GetFrames();
  this->NumberOfPulses = this->Source->GetNumberOfPulses();
  this->ReadLegs();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->CollectedTime = this->GetStartTime();
  this->State = Phase::Running;
  return true;
}

//------------------------------------------------------------------------------
void Simulation::ReadLegs()
{
  const SurveyData& data = this->Survey->GetData();
  vtkIdType shots = 0;
  for (int i = 0; i < this->Survey->GetNumberOfLegs(); ++i)
  {
    const auto index = static_cast<std::size_t>(i);
    SimulatedLeg leg;
    leg.Leg = i;
    double times[2];
    vtkIdType pulses[2];
    this->Source->GetLegTimes(i, times);
    this->Source->GetLegPulses(i, pulses);
    const auto trajectory = this->Source->GetTrajectory(i, (times[1] - times[0]) / SamplesPerLeg);
    if (!leg.SetTrajectory(trajectory))
    {
      continue;
    }
    leg.StartTime = times[0];
    leg.EndTime = times[1];
    leg.FirstPulse = pulses[0];
    leg.LastPulse = pulses[1];
    leg.Mount = data.GetPlatform(index).Mount;
    leg.IsMoving = data.IsMoving(index);
    leg.Type = data.GetPlatform(index).Type;
    leg.Kind = FindPlatformKind(data.GetPlatform(index));
    const ScanData& scan = data.Legs[index].Scans.front();
    leg.LineFrequency = scan.ScanFrequency;
    leg.Clock = { shots, times[0], scan.PulseFrequency };
    shots += (pulses[1] - pulses[0]) /
      static_cast<vtkIdType>(data.GetScanner(index).GetNumberOfChannels());
    leg.Model = data.GetPlatform(index).Model;
    leg.ScannerModel = data.GetScanner(index).Model;
    leg.HeadAxis = data.GetScanner(index).HeadRotateAxis;
    leg.HeadStart = scan.HeadRotateStart;
    leg.HeadSpeed = scan.HeadRotateSpeed;
    this->Legs.push_back(leg);
  }
}

//------------------------------------------------------------------------------
/// Returns whether there is work; under the mutex.
bool Simulation::HasWork() const
{
  const bool isBefore =
    this->NextPulse<this->NumberOfPulses&& this->Source->FindPulse(this->Target)> this->NextPulse;
  return !this->Requests.empty() || (isBefore && this->Blocks.size() < LongestQueue);
}

//------------------------------------------------------------------------------
/// Runs the next block towards the target, short enough to react to a new target soon.
bool Simulation::RunBlock()
{
  double target = 0.0;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    target = this->Target;
    if (this->Blocks.size() >= LongestQueue)
    {
      return true;
    }
  }
  const vtkIdType end =
    std::min(this->Source->FindPulse(target), this->NextPulse + this->PulsesPerBlock);
  if (end <= this->NextPulse)
  {
    return true;
  }
  const auto start = std::chrono::steady_clock::now();
  this->Source->SetPulseWindow(this->NextPulse, end);
  this->Source->Update();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!this->Source->GetScene()) // stopped after an error
  {
    return false;
  }
  if (end == this->NextPulse + this->PulsesPerBlock)
  {
    const double factor = std::clamp(SecondsPerBlock / seconds.count(), 0.5, 2.0);
    const auto pulses = static_cast<vtkIdType>(factor * static_cast<double>(this->PulsesPerBlock));
    this->PulsesPerBlock = std::clamp(pulses, MinimumPulses, MaximumPulses);
  }
  this->NextPulse = end;
  const bool isLast = end == this->NumberOfPulses;
  const double time = isLast ? this->GetEndTime() : this->Source->GetPulseTime(end);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Blocks.push_back({ CopyOutput<vtkPolyData>(this->Source, 0), time, end });
  this->State = isLast ? Phase::Finished : this->State;
  this->ComputingSeconds += seconds.count();
  return true;
}

//------------------------------------------------------------------------------
bool Simulation::RunRequests()
{
  std::deque<Request> requests;
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    requests.swap(this->Requests);
  }
  for (Request& request : requests)
  {
    this->Source->GenerateWaveformsOn();
    this->Source->GeneratePulsesOn();
    this->Source->SetGenerateSubRays(request.HasSubRays);
    this->Source->SetPulseWindow(request.First, request.Last);
    this->Source->Update();
    request.Record.set_value(
      { CopyOutput<vtkPolyData>(this->Source, 0), CopyOutput<vtkTable>(this->Source, 1),
        CopyOutput<vtkPolyData>(this->Source, 2), CopyOutput<vtkPolyData>(this->Source, 3) });
    this->Source->GenerateWaveformsOff();
    this->Source->GeneratePulsesOff();
    this->Source->GenerateSubRaysOff();
  }
  return this->Source->GetScene() != nullptr;
}

} // namespace helios::viewer
