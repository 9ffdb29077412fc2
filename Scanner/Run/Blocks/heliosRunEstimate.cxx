// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunEstimate.h"

#include "heliosConstants.h"
#include "vtkHeliosStreamWriter.h"

#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

namespace helios
{

namespace
{

// Samples: a tenth of the run, within limits for accuracy and speed [pulses].
constexpr double SampledShare = 0.1;
constexpr double MinimumPulses = 262144.0;
constexpr double MaximumPulses = 2097152.0;
constexpr double PulsesPerWindow = 8192.0;
constexpr double MinimumWindows = 8.0;    // windows of a leg
constexpr double MaximumOverBudget = 4.0; // with whole lines
constexpr double LongestSampling = 4.0;   // [s], of all legs together
// Trials of increasing length, until one gives the time per pulse.
constexpr double PulsesPerTrial = 8.0;
constexpr double TrialGrowth = 8.0;
constexpr double TrialSeconds = 0.05; // and at most a tenth of the leg's limit
constexpr double GoldenRatio = 0.6180339887498949;
constexpr vtkIdType TrajectorySamples = 4096;

double Now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Returns the bytes that a writer would have written.
double CountBytes(vtkHeliosStreamWriter* writer)
{
  const auto size = static_cast<double>(writer->GetFileSize());
  const auto bytes = static_cast<double>(writer->GetNumberOfBytes());
  return size == bytes ? size : size + bytes; // an index and its pieces
}

} // namespace

//------------------------------------------------------------------------------
RunEstimate::RunEstimate(LegRunner& runner, double loadSeconds)
  : Runner(runner)
  , LoadSeconds(loadSeconds)
{
}

//------------------------------------------------------------------------------
bool RunEstimate::Make(const std::function<bool(double)>& onStep)
{
  const std::vector<LegPlan>& plans = this->Runner.GetPlans();
  for (std::size_t i = 0; i < plans.size(); ++i)
  {
    if (!onStep(static_cast<double>(i) / static_cast<double>(plans.size())) ||
      !this->Sample(plans[i]))
    {
      return false;
    }
  }
  return onStep(1.0);
}

//------------------------------------------------------------------------------
/// Returns the pulses to sample of a leg.
double RunEstimate::GetWanted(const LegPlan& plan) const
{
  const auto total = static_cast<double>(this->Runner.GetNumberOfPulses());
  const auto pulses = static_cast<double>(plan.NumberOfPulses);
  const double all = std::clamp(SampledShare * total, MinimumPulses, MaximumPulses);
  return std::max(PulsesPerWindow, all * pulses / total);
}

//------------------------------------------------------------------------------
RunEstimate::Windows RunEstimate::ChooseWindows(const LegPlan& plan, double affordable) const
{
  if (plan.NumberOfPulses == 0)
  {
    return {};
  }
  const double frequency = static_cast<double>(plan.NumberOfPulses) / plan.Duration;
  const double lines = this->Runner.GetSurvey().Legs[plan.Leg].Scans.front().ScanFrequency;
  // Whole lines: some pulses of a line may not be emitted.
  double length = lines > 0.0
    ? std::max(1.0, std::round(PulsesPerWindow / frequency * lines)) / lines
    : PulsesPerWindow / frequency;
  const double budget = std::min(this->GetWanted(plan), affordable);
  const double count = std::max(MinimumWindows, std::ceil(budget / (length * frequency)));
  if (count * length * frequency > MaximumOverBudget * budget)
  {
    // Parts of lines if whole lines take too long.
    length = std::max(1.0, budget / count) / frequency;
  }
  const double stratum = plan.Duration / count;
  if (2.0 * length > stratum)
  {
    return { { plan.StartTime - 1.0, plan.StartTime + plan.Duration + 1.0 } };
  }
  std::map<double, Window> windows; // sorted so that the first few cover the leg
  for (double i = 0.0; i < count; ++i)
  {
    // Near the middle, but not in step with periodic scenes.
    const double turns = (i + 1.0) * GoldenRatio;
    const double place = 0.25 + 0.5 * (turns - std::floor(turns));
    const double start = plan.StartTime + i * stratum + place * (stratum - length);
    windows.emplace(place, Window(start, start + length));
  }
  Windows sorted;
  for (const auto& window : windows)
  {
    sorted.push_back(window.second);
  }
  return sorted;
}

//------------------------------------------------------------------------------
bool RunEstimate::Sample(const LegPlan& plan)
{
  LegScanner& scanner = this->Runner.Prepare(plan);
  const LegRunner::Outputs outputs = this->Runner.MakeOutputs(plan);
  bool good = true;
  for (const LegOutput& output : outputs)
  {
    this->Runner.Listen(output.Writer);
    output.Writer->CountOnlyOn();
    good = output.Writer->Open() && good;
  }
  const Window empty(plan.StartTime, plan.StartTime);
  if (this->Samples.empty())
  {
    Sums ignored; // the first window builds the ray caster's tree
    const double start = Now();
    good = good && this->SampleWindow(empty, scanner, {}, ignored);
    this->LoadSeconds += Now() - start;
  }
  Sums idle; // overhead of a window without pulses
  good = good && this->SampleWindow(empty, scanner, {}, idle);
  Sums sums;
  const double affordable = good ? this->CountAffordable(plan, scanner) : 0.0;
  good = good && !this->Runner.HasError();
  const double latest = Now() + 2.0 * this->GetLongestSampling();
  for (const Window& window : good ? this->ChooseWindows(plan, affordable) : Windows())
  {
    if (!good || Now() > latest)
    {
      break;
    }
    good = this->SampleWindow(window, scanner, outputs, sums);
    sums.Seconds -= std::min(sums.Seconds, idle.Seconds);
  }
  for (const LegOutput& output : outputs)
  {
    good = good && output.Writer->Close();
    sums.Bytes += CountBytes(output.Writer);
  }
  this->Samples.push_back(sums);
  this->Legs.push_back(this->Scale(plan, sums));
  return good;
}

//------------------------------------------------------------------------------
/// Returns the time for the samples of a leg [s].
double RunEstimate::GetLongestSampling() const
{
  return LongestSampling / static_cast<double>(this->Runner.GetPlans().size());
}

//------------------------------------------------------------------------------
/// Returns the pulses of a leg that can be computed in the time that its samples may take.
double RunEstimate::CountAffordable(const LegPlan& plan, LegScanner& scanner)
{
  const auto pulses = static_cast<double>(plan.NumberOfPulses);
  const double step = plan.Duration / std::max(1.0, pulses);
  const double middle = plan.StartTime + 0.5 * plan.Duration;
  const double maximum = this->GetLongestSampling();
  const double largest = std::min(0.5 * pulses, this->GetWanted(plan));
  for (double count = PulsesPerTrial; count < largest; count *= TrialGrowth)
  {
    Sums trial;
    if (!this->SampleWindow({ middle, middle + count * step }, scanner, {}, trial))
    {
      return 0.0;
    }
    if (trial.Seconds > std::min(TrialSeconds, 0.1 * maximum) && trial.Pulses > 0.0)
    {
      return trial.Pulses * maximum / trial.Seconds;
    }
  }
  return pulses;
}

//------------------------------------------------------------------------------
bool RunEstimate::SampleWindow(
  const Window& window, LegScanner& scanner, const LegRunner::Outputs& outputs, Sums& sums)
{
  const double start = Now();
  scanner.SetTimeWindow(window.first, window.second);
  if (!scanner.Update(0, 1) || !this->Runner.Write(outputs))
  {
    return false;
  }
  ScanCounts counts;
  scanner.Count(counts);
  sums.Seconds += Now() - start;
  sums.Memory += scanner.GetMemorySize();
  scanner.ReleaseOutput();
  sums.Pulses += static_cast<double>(scanner.CountPulses());
  sums.Fired += static_cast<double>(counts.PulsesFired);
  sums.Echoes += static_cast<double>(counts.Echoes);
  return !this->Runner.HasError();
}

//------------------------------------------------------------------------------
RunEstimate::Sums RunEstimate::Scale(const LegPlan& plan, const Sums& sampled) const
{
  const auto pulses = static_cast<double>(plan.NumberOfPulses);
  const double factor = sampled.Pulses > 0.0 ? pulses / sampled.Pulses : 0.0;
  Sums leg;
  leg.Pulses = pulses;
  leg.Fired = factor * sampled.Fired;
  leg.Echoes = factor * sampled.Echoes;
  leg.Bytes = factor * sampled.Bytes + this->CountTrajectoryBytes(plan);
  leg.Memory = factor * sampled.Memory;
  leg.Seconds = factor * sampled.Seconds;
  return leg;
}

//------------------------------------------------------------------------------
double RunEstimate::CountTrajectoryBytes(const LegPlan& plan) const
{
  const TrajectorySampler sampler(
    plan, this->Runner.GetSurvey().Legs[plan.Leg].TrajectoryTimeInterval);
  const auto writer = this->Runner.MakeTrajectoryWriter(plan);
  writer->CountOnlyOn();
  const vtkIdType count = std::min(TrajectorySamples, sampler.GetNumberOfSamples());
  const bool good =
    writer->Open() && writer->Write(sampler.GetSamples(0, count)) && writer->Close();
  return good ? CountBytes(writer) * static_cast<double>(sampler.GetNumberOfSamples()) /
      static_cast<double>(count)
              : 0.0;
}

//------------------------------------------------------------------------------
double RunEstimate::GuessMemory(const Sums& totals) const
{
  // A piece is written while the next one is computed.
  vtksys::SystemInformation system;
  const double now = BytesPerKibibyte * static_cast<double>(system.GetProcMemoryUsed());
  const double piece =
    std::min(static_cast<double>(this->Runner.GetPulsesPerPiece()), totals.Pulses);
  return now + 2.0 * piece * totals.Memory / std::max(1.0, totals.Pulses);
}

//------------------------------------------------------------------------------
Json::Value RunEstimate::Describe() const
{
  Json::Value report;
  report["survey"] = this->Runner.GetSurvey().Name;
  report["rayCaster"] = this->Runner.GetRayCasterName();
  report["sampling"] = this->Runner.DescribeSampling();
  report["threads"] = vtkSMPTools::GetEstimatedNumberOfThreads();
  report["legs"] = Json::arrayValue;
  Sums totals;
  double sampled = 0.0;
  double duration = 0.0;
  const auto whole = [](double value) { return Json::Int64(std::llround(value)); };
  const auto describe = [&whole](const Sums& sums, double pulses, double seconds)
  {
    Json::Value value;
    value["duration_s"] = seconds;
    value["pulses"] = whole(sums.Pulses);
    value["pulsesSampled"] = whole(pulses);
    value["pulsesFired"] = whole(sums.Fired);
    value["points"] = whole(sums.Echoes);
    value["bytes"] = whole(sums.Bytes);
    return value;
  };
  for (std::size_t i = 0; i < this->Legs.size(); ++i)
  {
    const LegPlan& plan = this->Runner.GetPlans()[i];
    const Sums& leg = this->Legs[i];
    Json::Value& value =
      report["legs"].append(describe(leg, this->Samples[i].Pulses, plan.Duration));
    value["leg"] = Json::UInt(plan.Leg);
    value["start_s"] = plan.StartTime;
    totals.Pulses += leg.Pulses;
    totals.Fired += leg.Fired;
    totals.Echoes += leg.Echoes;
    totals.Bytes += leg.Bytes;
    totals.Memory += leg.Memory;
    totals.Seconds += leg.Seconds;
    sampled += this->Samples[i].Pulses;
    duration += plan.Duration;
  }
  report["totals"] = describe(totals, sampled, duration);
  report["memory_bytes"] = whole(this->GuessMemory(totals));
  report["load_s"] = this->LoadSeconds;
  report["run_s"] = totals.Seconds;
  return report;
}

} // namespace helios
