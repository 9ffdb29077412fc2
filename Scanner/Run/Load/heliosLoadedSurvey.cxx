// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosLoadedSurvey.h"

#include "heliosMessages.h"
#include "heliosNoEchoes.h"
#include "heliosPulseCount.h"
#include "vtkHeliosRayCaster.h"

#include <vtkImageData.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace helios
{

namespace
{

constexpr vtkIdType PulsesPerStep = 1048576;

template <class Condition>
const LegPlan* FindPlan(const LegRunner* runner, const Condition& condition)
{
  if (!runner)
  {
    return nullptr;
  }
  const auto& plans = runner->GetPlans();
  const auto found = std::find_if(plans.begin(), plans.end(), condition);
  return found == plans.end() ? nullptr : &*found;
}

} // namespace

//------------------------------------------------------------------------------
LoadedSurvey::LoadedSurvey(Messages& log)
  : Log(log)
  , Loader(log)
{
}

//------------------------------------------------------------------------------
bool LoadedSurvey::Plan(const RunSettings& settings)
{
  const bool isPlanned = this->Runner && this->SceneTime == this->Loader.GetLoadTime() &&
    this->Settings.Options == settings.Options &&
    this->Settings.Trajectories == settings.Trajectories && this->Settings.Mesh == settings.Mesh &&
    AreUnchanged(this->Runner->GetInputs());
  this->Settings = settings;
  if (isPlanned)
  {
    return true;
  }
  this->SceneTime = this->Loader.GetLoadTime();
  this->PlanTime.Modified();
  this->Runner = std::make_unique<LegRunner>(
    this->Loader.GetSurvey(), this->Loader.GetScene(), this->Settings, this->Log);
  if (!this->Runner->Plan())
  {
    return false;
  }
  if (this->Runner->GetNumberOfPulses() == 0)
  {
    this->Log.Error(ExplainNoEchoes(*this->Runner));
  }
  return this->Runner->GetNumberOfPulses() > 0;
}

//------------------------------------------------------------------------------
const LegPlan* LoadedSurvey::FindLeg(int leg) const
{
  return FindPlan(this->Runner.get(),
    [leg](const LegPlan& plan) { return plan.Leg == static_cast<std::size_t>(leg); });
}

//------------------------------------------------------------------------------
const LegPlan* LoadedSurvey::FindPulse(vtkIdType pulse) const
{
  return FindPlan(this->Runner.get(),
    [pulse](const LegPlan& plan)
    { return pulse >= plan.FirstPulse && pulse < plan.FirstPulse + plan.NumberOfPulses; });
}

//------------------------------------------------------------------------------
double LoadedSurvey::GetRate(const LegPlan& plan) const
{
  return this->Loader.GetSurvey().Legs[plan.Leg].Scans.front().PulseFrequency;
}

//------------------------------------------------------------------------------
vtkIdType LoadedSurvey::GetChannels(const LegPlan& plan) const
{
  return static_cast<vtkIdType>(
    this->Loader.GetSurvey().GetScanner(plan.Leg).GetNumberOfChannels());
}

//------------------------------------------------------------------------------
double LoadedSurvey::GetPulseTime(const LegPlan& plan, vtkIdType pulse) const
{
  const vtkIdType shot = (pulse - plan.FirstPulse) / this->GetChannels(plan);
  return plan.StartTime + static_cast<double>(shot) / this->GetRate(plan);
}

//------------------------------------------------------------------------------
vtkIdType LoadedSurvey::GetPulse(const LegPlan& plan, double time) const
{
  const vtkIdType shot = CountPulses(std::max(0.0, time - plan.StartTime), this->GetRate(plan));
  return plan.FirstPulse + std::min(plan.NumberOfPulses, shot * this->GetChannels(plan));
}

//------------------------------------------------------------------------------
/// Returns the shots of a leg with their first pulse in a window of ids.
LoadedSurvey::Shots LoadedSurvey::FindShots(
  const LegPlan& plan, vtkIdType first, vtkIdType last) const
{
  const vtkIdType channels = this->GetChannels(plan);
  const auto find = [&plan, channels](vtkIdType pulse)
  {
    const vtkIdType own = std::clamp<vtkIdType>(pulse - plan.FirstPulse, 0, plan.NumberOfPulses);
    return (own + channels - 1) / channels;
  };
  return { find(first), find(last) };
}

//------------------------------------------------------------------------------
bool LoadedSurvey::Run(
  vtkIdType first, vtkIdType last, const ProgressCallback& onProgress, Piles& piles)
{
  Progress progress{ onProgress, std::max<vtkIdType>(1, last - first) };
  piles = Piles(vtkHeliosEchoAlgorithm::Outputs::NumberOfPorts);
  for (const LegPlan& plan : this->Runner->GetPlans())
  {
    const Shots shots = this->FindShots(plan, first, last);
    if (shots.Last > shots.First && !this->RunLeg(plan, shots, progress, piles))
    {
      return false;
    }
  }
  for (PieceBuffer& pile : piles)
  {
    pile.Finish();
  }
  return true;
}

//------------------------------------------------------------------------------
bool LoadedSurvey::RunLeg(const LegPlan& plan, const Shots& shots, Progress& progress, Piles& piles)
{
  LegScanner& scanner = this->Runner->Prepare(plan);
  scanner.SetOutputs(this->Settings.Wants);
  const vtkIdType channels = this->GetChannels(plan);
  const vtkIdType step = std::max<vtkIdType>(1, PulsesPerStep / channels);
  for (vtkIdType shot = shots.First; shot < shots.Last; shot += step)
  {
    const vtkIdType end = std::min(shots.Last, shot + step);
    const auto pulses = static_cast<double>(channels * (end - shot));
    scanner.SetPulseWindow(shot, end);
    scanner.SetOnProgress(
      [&progress, pulses](double share) { return progress.GoesOn(share * pulses); });
    const bool isGood = progress.GoesOn() && scanner.Update(0, 1);
    scanner.SetOnProgress(nullptr);
    if (!isGood)
    {
      return false;
    }
    for (int port = 0; port < vtkHeliosEchoAlgorithm::Outputs::NumberOfPorts; ++port)
    {
      if (this->Settings.Wants.HasPort(port))
      {
        piles[static_cast<std::size_t>(port)].Add(scanner.GetOutput(port));
      }
    }
    scanner.ReleaseOutput();
    progress.Done += channels * (end - shot);
  }
  return true;
}

} // namespace helios
