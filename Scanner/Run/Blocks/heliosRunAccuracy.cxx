// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunAccuracy.h"

#include "heliosMessages.h"
#include "heliosPulseSubset.h"
#include "heliosReceiverSetup.h"
#include "heliosStatus.h"
#include "vtkHeliosBeamSampler.h"
#include "vtkHeliosScene.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace helios
{
namespace
{

// The sample: pulses that hit something, and at most MaximumMisses others for each of them.
constexpr vtkIdType MinimumHits = 200;
constexpr vtkIdType MaximumHits = 1000;
constexpr vtkIdType HitsPerSample = 20000;
constexpr vtkIdType MaximumMisses = 3;
constexpr vtkIdType PulsesPerPiece = 256;                // between checks for an abort
constexpr const char* PhotonCounting = "photonCounting"; // the name of its detector
// The reference.
constexpr double Finer = 0.1;           // factor of the tolerances of the run
constexpr double Coarser = 0.3;         // factor that bounds the error of the reference
constexpr int MaximumSubRays = 1 << 18; // sub-rays of a beam that it samples
constexpr int MaximumSubRaysCoarse = 1 << 16;
constexpr double BinsPerPulse = 50.0;
// Its check.
constexpr vtkIdType MaximumChecked = 32; // pulses that hit something, about
constexpr int SubRaysOfCheck = 32768;

} // namespace

//------------------------------------------------------------------------------
Json::Value DescribeErrors(const EchoErrors& errors)
{
  Json::Value described;
  for (const EchoMeasure& measure : EchoMeasures)
  {
    const Estimate& estimate = errors.*measure.Measure;
    Json::Value& value = described[measure.Name] = Json::arrayValue;
    for (const double number : { estimate.Value, estimate.Lower, estimate.Upper })
    {
      value.append(number);
    }
  }
  return described;
}

//------------------------------------------------------------------------------
RunAccuracy::RunAccuracy(LegRunner& runner, const RunSettings& settings, Messages& log)
  : Runner(runner)
  , Settings(settings)
  , Log(log)
{
  const ScanCounts& counts = runner.GetCounts();
  const vtkIdType hits = std::max(counts.PulsesHit, counts.PulsesFired / (1 + MaximumMisses));
  const vtkIdType wanted = std::clamp(hits / HitsPerSample, MinimumHits, MaximumHits);
  this->Step = std::max<vtkIdType>(1, hits / wanted);
  this->CheckStep = std::max<vtkIdType>(1, hits / MaximumChecked);
}

//------------------------------------------------------------------------------
double FindFinestBin(const SurveyData& survey)
{
  double finest = VTK_DOUBLE_MAX;
  for (const ScannerData& scanner : survey.Scanners)
  {
    for (std::size_t k = 0; k < scanner.GetNumberOfChannels(); ++k)
    {
      const ScannerData& channel = scanner.GetChannel(k);
      finest =
        std::min({ finest, channel.Receiver.PulseLength / BinsPerPulse, channel.Receiver.BinSize });
    }
  }
  return finest;
}

//------------------------------------------------------------------------------
std::string ExplainRandomness(const LegRunner& runner, const RunSettings& settings)
{
  vtkPolyData* scene = runner.GetScene();
  if (scene->GetNumberOfPolys() == 0 && !vtkHeliosScene::HasInstances(scene))
  {
    return "the scene has only turbid voxels, which are random";
  }
  const std::string& name = settings.Options.EchoDetector;
  const auto& scanners = runner.GetSurvey().Scanners;
  const bool countsPhotons = name.empty()
    ? std::any_of(scanners.begin(), scanners.end(),
        [](const ScannerData& scanner)
        { return scanner.GetChannel(0).Receiver.EchoDetector == PhotonCounting; })
    : name == PhotonCounting;
  return countsPhotons ? "photons are counted, which is random" : "";
}

//------------------------------------------------------------------------------
/// Returns the narrowest tolerances of the run; the default ones if it has fixed sub-rays only.
Tolerances RunAccuracy::GetTolerances() const
{
  Tolerances narrowest{ LargestTolerance, LargestTolerance };
  bool isAdaptive = false;
  for (const ScannerData& scanner : this->Runner.GetSurvey().Scanners)
  {
    for (std::size_t k = 0; k < scanner.GetNumberOfChannels(); ++k)
    {
      const BeamSampling sampling =
        ChooseSampling(scanner.GetChannel(k).Receiver, this->Settings.Options);
      if (sampling.IsAdaptive)
      {
        isAdaptive = true;
        narrowest.Range = std::min(narrowest.Range, sampling.RangeTolerance);
        narrowest.Energy = std::min(narrowest.Energy, sampling.EnergyTolerance);
      }
    }
  }
  return isAdaptive ? narrowest : Tolerances();
}

//------------------------------------------------------------------------------
/// Sets adaptive sampling at a fraction of the tolerances of the run.
void RunAccuracy::SetReference(double factor, int maximumSubRays, RunOptions& options) const
{
  const Tolerances tolerances = this->GetTolerances();
  options.NumberOfSubRays = 0;
  options.SubRayPattern.clear();
  options.RangeTolerance = std::max(MinimumRangeTolerance, factor * tolerances.Range);
  options.EnergyTolerance = std::max(MinimumEnergyTolerance, factor * tolerances.Energy);
  options.MaximumSubRays = std::max(options.MaximumSubRays, maximumSubRays);
}

//------------------------------------------------------------------------------
/// Makes the ways in the order of WayIndex.
std::vector<RunAccuracy::Way> RunAccuracy::MakeWays() const
{
  std::vector<Way> ways(NumberOfWays);
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    RunOptions& options = ways[i].Options;
    options = this->Settings.Options;
    options.Noise = false;
    options.Without += " voxels scattering";
    options.PulseStep = i >= CheckedReference ? this->CheckStep : this->Step;
    if (i != Run)
    {
      options.BinSize = FindFinestBin(this->Runner.GetSurvey());
    }
  }
  this->SetReference(Finer, MaximumSubRays, ways[Reference].Options);
  this->SetReference(Coarser, MaximumSubRaysCoarse, ways[Coarse].Options);
  this->SetReference(Finer, MaximumSubRays, ways[CheckedReference].Options);
  for (const WayIndex i : { Check, HalfCheck })
  {
    RunOptions& options = ways[i].Options;
    options.RangeTolerance = options.EnergyTolerance = 0.0;
    options.NumberOfSubRays = i == Check ? SubRaysOfCheck : SubRaysOfCheck / 2;
    options.SubRayPattern = vtkHeliosBeamSampler::GetPatternName(vtkHeliosBeamSampler::VOGEL);
  }
  return ways;
}

//------------------------------------------------------------------------------
/// Returns the samples of all channels of a leg.
vtkIdType RunAccuracy::CountSamples(const LegPlan& plan, vtkIdType step) const
{
  const auto channels =
    static_cast<vtkIdType>(this->Runner.GetSurvey().GetScanner(plan.Leg).GetNumberOfChannels());
  vtkIdType count = 0;
  for (vtkIdType k = 0; k < channels; ++k)
  {
    const PulseSubset sample(step, plan.FirstPulse + k);
    count += sample.CountBelow(plan.NumberOfPulses / channels) - sample.CountBelow(0);
  }
  return count;
}

//------------------------------------------------------------------------------
void RunAccuracy::Measure(const StepWatcher& onStep)
{
  this->Reason = ExplainRandomness(this->Runner, this->Settings);
  if (!this->Reason.empty())
  {
    return;
  }
  this->Log.Mute(true); // the run has reported its warnings
  std::vector<Way> ways = this->MakeWays();
  for (const LegPlan& plan : this->Runner.GetPlans())
  {
    for (Way& way : ways)
    {
      this->Fire(plan, onStep, way);
    }
    this->Compare(plan, ways);
  }
  this->Runner.Prepare(this->Runner.GetPlans().back(), this->Settings.Options)
    .SetOutputs(this->Settings.Wants);
  this->Log.Mute(false);
}

//------------------------------------------------------------------------------
/// Computes the sample of a leg.
void RunAccuracy::Fire(const LegPlan& plan, const StepWatcher& onStep, Way& way)
{
  way.Echoes.clear();
  way.Fired = 0;
  const vtkIdType samples = this->CountSamples(plan, way.Options.PulseStep);
  const int pieces = static_cast<int>((samples + PulsesPerPiece - 1) / PulsesPerPiece);
  LegScanner* scanner = pieces > 0 ? &this->Runner.Prepare(plan, way.Options) : nullptr;
  if (scanner)
  {
    scanner->SetOutputs({}); // echoes alone are compared
  }
  for (int piece = 0; this->Reason.empty() && piece < pieces; ++piece)
  {
    const double pulses = static_cast<double>(plan.NumberOfPulses) * piece / pieces;
    const bool goesOn = onStep((static_cast<double>(plan.FirstPulse) + pulses) /
      static_cast<double>(this->Runner.GetNumberOfPulses()));
    if (!goesOn || (!scanner->Update(piece, pieces) && scanner->WasStopped()))
    {
      this->Reason = "it was stopped while it was measured";
      return;
    }
    for (std::size_t k = 0; k < scanner->GetNumberOfChannels(); ++k)
    {
      auto* output = vtkPolyData::SafeDownCast(scanner->GetOutput(EchoPort, k));
      if (!output || output->GetPointData()->GetNumberOfArrays() == 0)
      {
        this->Reason = "its pulses could not be computed again";
        return;
      }
      way.Echoes.push_back(vtkSmartPointer<vtkPolyData>::New());
      way.Echoes.back()->ShallowCopy(output);
    }
    ScanCounts counts;
    scanner->Count(counts);
    way.Fired += counts.PulsesFired;
    scanner->ReleaseOutput();
  }
}

//------------------------------------------------------------------------------
/// Adds the echoes of a piece and channel, by index.
Status RunAccuracy::AddErrors(
  const std::vector<Way>& ways, std::size_t echoes, const EchoMatching& matching)
{
  vtkPolyData* reference = ways[Reference].Echoes[echoes];
  const Status status = this->Errors.Add(ways[Run].Echoes[echoes], reference, matching);
  return status.IsOk() ? this->CoarseErrors.Add(ways[Coarse].Echoes[echoes], reference, matching)
                       : status;
}

Status RunAccuracy::AddCheck(
  const std::vector<Way>& ways, std::size_t echoes, const EchoMatching& matching)
{
  vtkPolyData* check = ways[Check].Echoes[echoes];
  const Status status =
    this->CheckErrors.Add(ways[CheckedReference].Echoes[echoes], check, matching);
  return status.IsOk() ? this->OfCheck.Add(ways[HalfCheck].Echoes[echoes], check, matching)
                       : status;
}

//------------------------------------------------------------------------------
/// Compares the echoes of a leg, in the same order of pieces and channels.
void RunAccuracy::Compare(const LegPlan& plan, const std::vector<Way>& ways)
{
  const ScannerData& scanner = this->Runner.GetSurvey().GetScanner(plan.Leg);
  const std::size_t channels = scanner.GetNumberOfChannels();
  this->Pulses += ways[Run].Fired;
  this->CheckedPulses += ways[Check].Fired;
  const auto addAll = [&](const Way& way, auto add)
  {
    for (std::size_t i = 0; this->Reason.empty() && i < way.Echoes.size(); ++i)
    {
      const ScannerData& channel = scanner.GetChannel(i % channels);
      const BeamSampling sampling = ChooseSampling(channel.Receiver, this->Settings.Options);
      const EchoMatching matching =
        MakeMatching(channel.Receiver, sampling.IsAdaptive ? sampling.EnergyTolerance : 0.0);
      this->Reason = (this->*add)(ways, i, matching).Message();
    }
  };
  addAll(ways[Run], &RunAccuracy::AddErrors);
  addAll(ways[Check], &RunAccuracy::AddCheck);
}

//------------------------------------------------------------------------------
/// Returns the errors of the reference, at most: what its check finds counts where nothing else
/// explains it.
EchoErrors RunAccuracy::GetReferenceErrors() const
{
  EchoErrors errors = this->CoarseErrors.GetErrors();
  const EchoErrors found = this->CheckErrors.GetErrors();
  const EchoErrors ofCheck = this->OfCheck.GetErrors();
  for (const EchoMeasure& measure : EchoMeasures)
  {
    const Estimate& own = errors.*measure.Measure;
    const Estimate& difference = found.*measure.Measure;
    if (difference.Lower > 2.0 * (ofCheck.*measure.Measure).Upper + own.Upper)
    {
      errors.*measure.Measure = difference;
    }
  }
  return errors;
}

//------------------------------------------------------------------------------
Json::Value RunAccuracy::DescribeReference() const
{
  Json::Value described = DescribeErrors(this->GetReferenceErrors());
  RunOptions options;
  this->SetReference(Finer, MaximumSubRays, options);
  described["rangeTolerance_m"] = options.RangeTolerance;
  described["energyTolerance"] = options.EnergyTolerance;
  Json::Value& check = described["check"] = DescribeErrors(this->CheckErrors.GetErrors());
  check["pulses"] = Json::Int64(this->CheckedPulses);
  check["subRays"] = SubRaysOfCheck;
  return described;
}

//------------------------------------------------------------------------------
Json::Value RunAccuracy::Describe() const
{
  if (!this->Reason.empty())
  {
    Json::Value nothing;
    nothing["reason"] = this->Reason;
    return nothing;
  }
  const EchoErrors errors = this->Errors.GetErrors();
  Json::Value described = DescribeErrors(errors);
  described["pulses"] = Json::Int64(this->Pulses);
  described["echoes"] = Json::Int64(errors.Echoes);
  described["matched"] = Json::Int64(errors.Matched);
  described["reference"] = this->DescribeReference();
  const ScannerData& scanner =
    this->Runner.GetSurvey().GetScanner(this->Runner.GetPlans().front().Leg);
  const BeamSampling sampling = ChooseSampling(scanner.Receiver, this->Settings.Options);
  if (sampling.IsAdaptive)
  {
    described["asked"]["rangeTolerance_m"] = sampling.RangeTolerance;
    described["asked"]["energyTolerance"] = sampling.EnergyTolerance;
  }
  described["without"] = Json::arrayValue;
  if (this->Settings.Options.Noise)
  {
    described["without"].append("noise");
  }
  if (!this->Settings.Grids.empty())
  {
    described["without"].append("turbid voxels");
  }
  const auto& scanners = this->Runner.GetSurvey().Scanners;
  const int orders = this->Settings.Options.ScatteringOrders;
  if (orders > 1 ||
    (orders == 0 &&
      std::any_of(scanners.begin(), scanners.end(),
        [](const ScannerData& each) { return each.GetChannel(0).Receiver.ScatteringOrders > 1; })))
  {
    described["without"].append("light scattered more than once");
  }
  return described;
}

} // namespace helios
