// SPDX-FileCopyrightText: Copyright (c) The vtkHelios authors
// SPDX-License-Identifier: BSD-3-Clause
#include "heliosRunAccuracy.h"

#include "heliosMessages.h"
#include "heliosPulseSample.h"
#include "heliosReceiver.h"
#include "heliosStatus.h"
#include "vtkHeliosScene.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>

namespace helios
{
namespace
{

// The sample: pulses that hit something, and at most MostMisses others for each of them.
constexpr vtkIdType FewestHits = 200;
constexpr vtkIdType MostHits = 1000;
constexpr vtkIdType HitsPerSample = 20000;
constexpr vtkIdType MostMisses = 3;
constexpr vtkIdType PulsesPerPiece = 256;                // between checks for an abort
constexpr const char* PhotonCounting = "photonCounting"; // the name of its detector
// The reference.
constexpr int SubRays = 4096;
constexpr double BinsPerPulse = 50.0;

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

} // namespace

//------------------------------------------------------------------------------
RunAccuracy::RunAccuracy(LegRunner& runner, const RunSettings& settings, Messages& log)
  : Runner(runner)
  , Settings(settings)
  , Log(log)
{
  const ScanCounts& counts = runner.GetCounts();
  const vtkIdType hits = std::max(counts.PulsesHit, counts.PulsesFired / (1 + MostMisses));
  const vtkIdType wanted = std::clamp(hits / HitsPerSample, FewestHits, MostHits);
  this->Step = std::max<vtkIdType>(1, hits / wanted);
}

//------------------------------------------------------------------------------
/// The bins of the reference [ns]: of the shortest pulse, and no wider than those of the survey.
double RunAccuracy::GetFinestBin() const
{
  double finest = VTK_DOUBLE_MAX;
  for (const ScannerData& scanner : this->Runner.GetSurvey().Scanners)
  {
    for (std::size_t k = 0; k < scanner.GetNumberOfChannels(); ++k)
    {
      const ScannerData& channel = scanner.GetChannel(k);
      finest = std::min({ finest, channel.PulseLength / BinsPerPulse, channel.Receiver.BinSize });
    }
  }
  return finest;
}

//------------------------------------------------------------------------------
bool RunAccuracy::CountsPhotons() const
{
  const std::string& name = this->Settings.Options.EchoDetector;
  const auto& scanners = this->Runner.GetSurvey().Scanners;
  return name.empty() ? std::any_of(scanners.begin(), scanners.end(),
                          [](const ScannerData& scanner)
                          { return scanner.GetChannel(0).Receiver.EchoDetector == PhotonCounting; })
                      : name == PhotonCounting;
}

//------------------------------------------------------------------------------
/// The run, the reference, and the reference with half the sub-rays.
std::vector<RunAccuracy::Way> RunAccuracy::MakeWays() const
{
  std::vector<Way> ways(3);
  for (std::size_t i = 0; i < ways.size(); ++i)
  {
    RunOptions& options = ways[i].Options;
    options = this->Settings.Options;
    options.Noise = false;
    options.Without += " voxels";
    options.PulseStep = this->Step;
    if (i > 0)
    {
      options.RangeTolerance = options.EnergyTolerance = 0.0;
      options.NumberOfSubRays = i == 1 ? SubRays : SubRays / 2;
      options.BinSize = this->GetFinestBin();
    }
  }
  return ways;
}

//------------------------------------------------------------------------------
/// The samples of all channels of a leg.
vtkIdType RunAccuracy::CountSamples(const LegPlan& plan) const
{
  const auto channels =
    static_cast<vtkIdType>(this->Runner.GetSurvey().GetScanner(plan.Leg).GetNumberOfChannels());
  vtkIdType count = 0;
  for (vtkIdType k = 0; k < channels; ++k)
  {
    const PulseSample sample(this->Step, plan.FirstPulse + k);
    count += sample.CountBelow(plan.NumberOfPulses / channels) - sample.CountBelow(0);
  }
  return count;
}

//------------------------------------------------------------------------------
void RunAccuracy::Measure(const StepWatcher& onStep)
{
  vtkPolyData* scene = this->Runner.GetScene();
  if (scene->GetNumberOfPolys() == 0 && !vtkHeliosScene::HasInstances(scene))
  {
    this->Reason = "the scene has only turbid voxels, which are random";
    return;
  }
  if (this->CountsPhotons())
  {
    this->Reason = "photons are counted, which is random";
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
  this->Runner.Prepare(this->Runner.GetPlans().back(), this->Settings.Options);
  this->Log.Mute(false);
}

//------------------------------------------------------------------------------
/// Computes the sample of a leg.
void RunAccuracy::Fire(const LegPlan& plan, const StepWatcher& onStep, Way& way)
{
  way.Echoes.clear();
  way.Fired = 0;
  const vtkIdType samples = this->CountSamples(plan);
  const int pieces = static_cast<int>((samples + PulsesPerPiece - 1) / PulsesPerPiece);
  LegScanner* scanner = pieces > 0 ? &this->Runner.Prepare(plan, way.Options) : nullptr;
  for (int piece = 0; this->Reason.empty() && piece < pieces; ++piece)
  {
    const double pulses = static_cast<double>(plan.NumberOfPulses) * piece / pieces;
    if (!onStep((static_cast<double>(plan.FirstPulse) + pulses) /
          static_cast<double>(this->Runner.GetNumberOfPulses())))
    {
      this->Reason = "it was stopped while it was measured";
      return;
    }
    scanner->Update(piece, pieces);
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
/// Compares the echoes of a leg, in the same order of pieces and channels.
void RunAccuracy::Compare(const LegPlan& plan, const std::vector<Way>& ways)
{
  const ScannerData& scanner = this->Runner.GetSurvey().GetScanner(plan.Leg);
  const std::size_t channels = scanner.GetNumberOfChannels();
  this->Pulses += ways[0].Fired;
  for (std::size_t i = 0; this->Reason.empty() && i < ways[0].Echoes.size(); ++i)
  {
    const ScannerData& channel = scanner.GetChannel(i % channels);
    const BeamSampling sampling = ChooseSampling(channel.Receiver, this->Settings.Options);
    const EchoMatching matching =
      MakeMatching(channel, sampling.IsAdaptive ? sampling.EnergyTolerance : 0.0);
    Status status = this->Errors.Add(ways[0].Echoes[i], ways[1].Echoes[i], matching);
    status = status.IsOk()
      ? this->ReferenceErrors.Add(ways[2].Echoes[i], ways[1].Echoes[i], matching)
      : status;
    this->Reason = status.Message();
  }
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
  described["reference"] = DescribeErrors(this->ReferenceErrors.GetErrors());
  described["reference"]["subRays"] = SubRays;
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
  return described;
}

} // namespace helios
