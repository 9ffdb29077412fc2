// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunForecast.h"

#include "heliosMessages.h"
#include "heliosReceiverSetup.h"
#include "heliosRunAccuracy.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

namespace helios
{
namespace
{

/// Ways, of a line of text and of a table.
const std::vector<double> RangeTolerances = { 0.001, 0.003, 0.01 }; // [m]
const std::vector<double> AllRangeTolerances = { 0.001, 0.003, 0.01, 0.03, 0.1 };
const std::vector<int> SubRays = { 19 };
const std::vector<int> AllSubRays = { 1, 7, 19, 62, 223 };
constexpr double EnergyPerRange = 10.0; // relative, per metre: 1 % with 1 mm
constexpr double LargestEnergyTolerance = 0.5;
constexpr double ReferenceTolerance = 1e-4;
constexpr int NumberOfWindows = 16;
constexpr int WindowStride = 11; // order of windows: any number of them is spread over the run
constexpr vtkIdType WindowsPerHead = 4; // the head of a window has its fixed cost, too
constexpr double MinimumPulses = 64.0;
constexpr double MaximumPulses = 8192.0;
// Trials in some windows, with more and more pulses, which tell the time of a pulse.
constexpr double TrialPulses = 64.0;
constexpr double TrialGrowth = 8.0;
constexpr int TrialWindows = 8;
constexpr double TrialSeconds = 0.02;
constexpr double CostOfHeads = 1.5;     // in windows, at most
constexpr double CostOfTrials = 2.0;    // in ways, at most
constexpr double CostOfReference = 2.0; // about, in ways

/// Returns the processor time of all threads [s]: other work on the computer takes none of it.
double GetProcessorTime()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

vtkIdType CountFired(const LegScanner& scanner)
{
  ScanCounts counts;
  scanner.Count(counts);
  return counts.PulsesFired;
}

} // namespace

//------------------------------------------------------------------------------
void MakeFalling(std::vector<double>& times)
{
  std::vector<std::pair<double, int>> pools; // mean and size
  for (const double time : times)
  {
    pools.emplace_back(time, 1);
    while (pools.size() > 1 && pools.back().first > pools[pools.size() - 2].first)
    {
      const auto [mean, size] = pools.back();
      pools.pop_back();
      auto& [before, all] = pools.back();
      before = (all * before + size * mean) / (all + size);
      all += size;
    }
  }
  times.clear();
  for (const auto& [mean, size] : pools)
  {
    times.insert(times.end(), static_cast<std::size_t>(size), mean);
  }
}

//------------------------------------------------------------------------------
RunForecast::Effort RunForecast::MakeEffort(bool isFull)
{
  Effort effort;
  if (isFull)
  {
    effort = { true, 3.0, 1.0, 0.0 };
  }
  return effort;
}

//------------------------------------------------------------------------------
RunForecast::RunForecast(LegRunner& runner, const RunSettings& settings, Messages& log)
  : Runner(runner)
  , Settings(settings)
  , Log(log)
{
}

//------------------------------------------------------------------------------
/// Adds a way with a tolerance [m], or with fixed sub-rays.
void RunForecast::AddWay(double rangeTolerance, int subRays)
{
  Way way;
  way.Options = this->Settings.Options;
  way.Options.Noise = false;
  way.Options.Without += " voxels";
  way.Options.Accuracy.clear();
  way.Options.SubRayPattern.clear();
  way.Options.NumberOfSubRays = subRays;
  way.Options.RangeTolerance = rangeTolerance;
  way.Options.EnergyTolerance = std::min(EnergyPerRange * rangeTolerance, LargestEnergyTolerance);
  RunSettings settings = this->Settings;
  settings.Options = way.Options;
  settings.Wants = {};
  way.Scanner = std::make_unique<LegScanner>(
    this->Runner.GetSurvey(), this->Runner.GetScene(), settings, this->Log);
  way.Scanner->SetOnProgress(
    [this](double)
    {
      this->IsStopped = this->IsStopped || !this->OnStep(0.0);
      return !this->IsStopped && !this->IsLate();
    });
  this->Ways.push_back(std::move(way));
}

//------------------------------------------------------------------------------
bool RunForecast::IsLate() const
{
  return GetProcessorTime() > this->Latest;
}

//------------------------------------------------------------------------------
void RunForecast::Measure(const Effort& effort, const StepWatcher& onStep)
{
  this->Reason = ExplainRandomness(this->Runner, this->Settings);
  if (!this->Reason.empty())
  {
    return;
  }
  this->OnStep = onStep;
  this->Latest = GetProcessorTime() + effort.Seconds;
  this->Log.Mute(true); // the run reports its warnings
  for (const double tolerance : effort.IsFull ? AllRangeTolerances : RangeTolerances)
  {
    this->AddWay(tolerance, 0);
  }
  for (const int count : effort.IsFull ? AllSubRays : SubRays)
  {
    this->AddWay(0.0, count);
  }
  this->AddWay(ReferenceTolerance, 0);
  this->Ways.back().Options.BinSize = FindFinestBin(this->Runner.GetSurvey());
  this->Ways.back().Scanner->SetOptions(this->Ways.back().Options);
  const bool hasPulses = this->ChoosePulses(effort);
  for (int i = 0; i < NumberOfWindows && hasPulses; ++i)
  {
    this->IsStopped = this->IsStopped || !onStep(static_cast<double>(i) / NumberOfWindows);
    if (this->IsStopped || this->IsLate() || !this->AddWindow(this->FindWindow(i)))
    {
      break;
    }
  }
  if (this->IsStopped || (this->Reason.empty() && this->PulsesFired == 0))
  {
    this->Reason = this->IsStopped ? "it was stopped" : "its pulses take too long for a sample";
  }
  for (Way& way : this->Ways)
  {
    way.Scanner.reset();
  }
  this->Log.Mute(false);
}

//------------------------------------------------------------------------------
/// Returns one of the equal parts of the run, without other legs than that in its middle.
RunForecast::Window RunForecast::FindWindow(int index) const
{
  const double total = static_cast<double>(this->Runner.GetNumberOfPulses());
  const double length = total / NumberOfWindows;
  const double start = length * (index * WindowStride % NumberOfWindows);
  const auto middle = static_cast<vtkIdType>(start + 0.5 * length);
  const std::vector<LegPlan>& plans = this->Runner.GetPlans();
  const auto found = std::find_if(plans.begin(), plans.end(),
    [middle](const LegPlan& plan) { return middle < plan.FirstPulse + plan.NumberOfPulses; });
  const LegPlan& plan = found == plans.end() ? plans.back() : *found;
  const auto channels =
    static_cast<vtkIdType>(this->Runner.GetSurvey().GetScanner(plan.Leg).GetNumberOfChannels());
  const auto find = [&plan, channels](double pulse)
  {
    const auto own = static_cast<vtkIdType>(pulse) - plan.FirstPulse;
    return std::clamp<vtkIdType>(own, 0, plan.NumberOfPulses) / channels;
  };
  return { &plan, find(start), find(start + length) };
}

//------------------------------------------------------------------------------
/// Has about a number of the pulses of the run computed.
void RunForecast::SetPulses(double pulses, Way& way)
{
  const double total = static_cast<double>(this->Runner.GetNumberOfPulses());
  this->Step = std::max<vtkIdType>(1, static_cast<vtkIdType>(total / pulses));
  way.Options.PulseStep = this->Step * this->Settings.Options.PulseStep;
  way.Scanner->SetOptions(way.Options);
  way.Plan = nullptr;
}

//------------------------------------------------------------------------------
/// Returns the time of a pulse of a sample [s], from a sample of at most some pulses; negative after a stop.
double RunForecast::TimePulse(double most)
{
  Way& way = this->Ways.front();
  for (double count = TrialPulses;; count *= TrialGrowth)
  {
    this->SetPulses(std::min(count, most), way);
    double seconds = 0.0;
    double pulses = 0.0;
    for (int i = 0; i < TrialWindows; ++i)
    {
      const Window trial = this->FindWindow(i);
      const double spent = this->FireWindow(way, trial);
      if (spent < 0.0)
      {
        return spent;
      }
      seconds += spent;
      pulses += static_cast<double>(trial.Last - trial.First);
      this->PulsesComputed += CountFired(*way.Scanner);
    }
    if (seconds > TrialSeconds || count >= most)
    {
      const auto channels = static_cast<double>(way.Scanner->GetNumberOfChannels());
      return seconds * static_cast<double>(this->Step) / std::max(1.0, channels * pulses);
    }
  }
}

//------------------------------------------------------------------------------
/// Chooses the pulses that the effort allows; false without any.
bool RunForecast::ChoosePulses(const Effort& effort)
{
  const auto total = static_cast<double>(this->Runner.GetNumberOfPulses());
  const auto ways = static_cast<double>(this->Ways.size());
  const double shared = effort.ShareOfPulses * total / (CostOfHeads * ways + CostOfTrials);
  const double seconds = shared < MinimumPulses ? 0.0 : this->TimePulse(shared);
  if (seconds < 0.0)
  {
    return false;
  }
  const double run = seconds * total / vtkSMPTools::GetEstimatedNumberOfThreads();
  if (shared < MinimumPulses || run < effort.ShortestRun)
  {
    this->Reason = "the run is short";
    return false;
  }
  // Without the tree of the ray caster, which the run needs, too.
  const double budget = std::min(effort.Seconds, effort.ShareOfPulses * run);
  this->Latest = GetProcessorTime() + budget;
  const double affordable = budget / (std::max(seconds, 1e-9) * (ways + CostOfReference));
  for (Way& way : this->Ways)
  {
    this->SetPulses(std::clamp(std::min(affordable, shared), MinimumPulses, MaximumPulses), way);
  }
  return true;
}

//------------------------------------------------------------------------------
/// Computes the sample of a window; returns its processor time, without that of no pulse [s], negative after a stop or
/// an error.
double RunForecast::FireWindow(Way& way, const Window& window)
{
  const auto fire = [&way](vtkIdType first, vtkIdType last)
  {
    const double start = GetProcessorTime();
    way.Scanner->SetPulseWindow(first, last);
    return way.Scanner->Update(0, 1) ? GetProcessorTime() - start : -1.0;
  };
  if (way.Plan != window.Plan)
  {
    way.Scanner->SetUp(*window.Plan);
    way.Plan = window.Plan;
    const bool isReady = fire(window.First, window.First) >= 0.0; // builds the tree
    way.Idle = isReady ? fire(window.First, window.First) : -1.0;
  }
  const double seconds = way.Idle < 0.0 ? -1.0 : fire(window.First, window.Last);
  return seconds < 0.0 ? seconds : std::max(0.0, seconds - way.Idle);
}

//------------------------------------------------------------------------------
/// Computes a window by the reference, which brings its part of the scene into the caches, and in all ways; false
/// after a stop or an error.
bool RunForecast::AddWindow(const Window& window)
{
  if (this->FireWindow(this->Ways.back(), window) < 0.0)
  {
    return false;
  }
  const Window head{ window.Plan, window.First,
    window.First + (window.Last - window.First) / WindowsPerHead };
  vtkIdType headFired = 0;
  for (std::size_t i = 0; i + 1 < this->Ways.size(); ++i)
  {
    Way& way = this->Ways[i];
    const double before = this->FireWindow(way, head);
    headFired = before < 0.0 ? 0 : CountFired(*way.Scanner);
    const double spent = before < 0.0 ? before : this->FireWindow(way, window);
    if (spent < 0.0)
    {
      return false;
    }
    way.Seconds += spent - before;
    way.Whole += spent;
    if (const Status status = this->AddErrors(way, window); !status.IsOk())
    {
      this->Reason = "its pulses could not be computed: " + status.Message();
      return false;
    }
  }
  const LegScanner& scanner = *this->Ways.front().Scanner;
  const vtkIdType fired = CountFired(scanner);
  this->PulsesFired += fired;
  this->PulsesTimed += fired - headFired;
  this->PulsesComputed += (fired + headFired) * static_cast<vtkIdType>(this->Ways.size());
  this->Pulses +=
    static_cast<vtkIdType>(scanner.GetNumberOfChannels()) * (window.Last - window.First);
  for (Way& way : this->Ways)
  {
    way.Scanner->ReleaseOutput();
  }
  return true;
}

//------------------------------------------------------------------------------
Status RunForecast::AddErrors(Way& way, const Window& window)
{
  const ScannerData& scanner = this->Runner.GetSurvey().GetScanner(window.Plan->Leg);
  const LegScanner& reference = *this->Ways.back().Scanner;
  for (std::size_t k = 0; k < reference.GetNumberOfChannels(); ++k)
  {
    const auto get = [k](const LegScanner& each)
    { return vtkPolyData::SafeDownCast(each.GetOutput(EchoPort, k)); };
    const Status status = way.Errors.Add(
      get(*way.Scanner), get(reference), MakeMatching(scanner.GetChannel(k).Receiver, 0.0));
    if (!status.IsOk())
    {
      return status;
    }
  }
  return {};
}

//------------------------------------------------------------------------------
/// Returns the times of a fired pulse [s] of the ways with tolerances, or of those with fixed sub-rays.
std::vector<double> RunForecast::FindTimes(bool isFixed) const
{
  const auto fired = static_cast<double>(this->PulsesFired);
  const auto timed = static_cast<double>(std::max<vtkIdType>(1, this->PulsesTimed));
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < this->Ways.size(); ++i)
  {
    const Way& way = this->Ways[i];
    if ((way.Options.NumberOfSubRays > 0) == isFixed)
    {
      const double most = way.Whole / fired;
      times.push_back(std::clamp(way.Seconds / timed, most / 3.0, most));
    }
  }
  return times;
}

//------------------------------------------------------------------------------
Json::Value RunForecast::Describe() const
{
  Json::Value described;
  if (!this->Reason.empty())
  {
    described["reason"] = this->Reason;
    return described;
  }
  described["pulses"] = Json::Int64(this->PulsesFired);
  described["pulsesComputed"] = Json::Int64(this->PulsesComputed);
  described["threads"] = vtkSMPTools::GetEstimatedNumberOfThreads();
  described["reference"]["rangeTolerance_m"] = ReferenceTolerance;
  described["ways"] = Json::arrayValue;
  const double fired = static_cast<double>(this->PulsesFired) * static_cast<double>(this->Step) *
    static_cast<double>(this->Runner.GetNumberOfPulses()) / static_cast<double>(this->Pulses);
  std::vector<double> times = this->FindTimes(false);
  const std::vector<double> fixed = this->FindTimes(true);
  MakeFalling(times);
  times.insert(times.end(), fixed.begin(), fixed.end());
  for (std::size_t i = 0; i + 1 < this->Ways.size(); ++i)
  {
    const Way& way = this->Ways[i];
    Json::Value row = DescribeErrors(way.Errors.GetErrors());
    const double seconds = times[i];
    row["us_per_pulse"] = 1e6 * seconds;
    row["run_s"] = seconds * fired / vtkSMPTools::GetEstimatedNumberOfThreads();
    if (way.Options.NumberOfSubRays > 0)
    {
      row["subRays"] = way.Options.NumberOfSubRays;
    }
    else
    {
      row["rangeTolerance_m"] = way.Options.RangeTolerance;
      row["energyTolerance"] = way.Options.EnergyTolerance;
    }
    described["ways"].append(row);
  }
  return described;
}

} // namespace helios
